import assert from 'node:assert/strict';
import { test } from 'node:test';
import { see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { csvOf, htmlOf } from '../../app/js/lens/export.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const given = fixture('table');

function lens() {
  const model = read(bytesOf(given.payload)),
    { state } = given;
  return { scene: { model, state, seen: see(model, state), images: {} }, told: { base: state } };
}

test('the table that is saved holds what the library computes', () => {
  const [head, names, ...rows] = csvOf(lens()).split('\n');
  assert.equal(JSON.parse(head.slice(2)).normalise, 'paper');
  const columns = names.split(',').map((name) => JSON.parse(name)),
    cells = rows.map((row) => row.split(','));
  const off = (got, wanted, name) =>
    wanted.forEach((value, i) => assert.ok(Math.abs(got[i] - value) < 1e-9, `${name}: ${got[i]}, not ${value}`));
  for (const [name, column] of Object.entries(given.columns)) {
    const at = columns.indexOf(name);
    assert.ok(at >= 0, name);
    assert.equal(rows.length, doublesOf(column).length);
    off(
      cells.map((row) => Number(row[at])),
      doublesOf(column),
      name,
    );
  }
  const from = columns.findIndex((name) => name.startsWith('P at '));
  off(
    cells.flatMap((row) => row.slice(from).map(Number)),
    doublesOf(given.tau_space),
    'tau-space',
  );
  assert.deepEqual(
    cells.map((row) => JSON.parse(row[columns.indexOf('best action')])),
    given.best,
  );
});

test('the lens in a file of its own holds its payload, and no tag ends early', () => {
  const tag = '<script id="held" type="application/json">',
    one = lens();
  one.scene.state = { ...one.scene.state, look: '</script>' };
  const page = htmlOf(one, undefined, `<p>${tag}</script></p>`);
  assert.equal(page.split('</script>').length, 2);
  const held = JSON.parse(page.slice(page.indexOf(tag) + tag.length, page.indexOf('</script>')));
  assert.equal(held.payload, given.payload);
  assert.equal(held.state.look, '</script>');
});
