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

// Names that a spreadsheet would compute, in a cell of their own, within a comment, and in more than one line.
const FORMULAS = ['=1+1', '+1', '-1', '@SUM(1)', '\t=1', '\r=1', '\n=1', 'a,=1+1,b', '",=1+1,"'];

// The cells of a text of CSV, as RFC 4180 has them.
function cellsOf(text) {
  const cells = [];
  for (const line of text.split(/\n(?=(?:[^"]*"[^"]*")*[^"]*$)/)) {
    for (const [, quoted, bare] of line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g))
      cells.push(quoted === undefined ? bare : quoted.replaceAll('""', '"'));
  }
  return cells;
}

test('no name becomes a formula in the table, and every name can be read from it again', () => {
  for (const name of FORMULAS) {
    const formula = lens(),
      { header } = formula.scene.model;
    Object.assign(header, { world: name, state: name, actions: header.actions.map(() => name) });
    const text = csvOf(formula);
    assert.equal(JSON.parse(text.split('\n')[0].slice(2)).from_state, name);
    for (const cell of cellsOf(text))
      assert.match(cell, /^(?:-?[\d.]+(e[+-]?\d+)?$|[^=+@\t\r\n-]|$)/, JSON.stringify(name));
    assert.ok(/^[=+@\t\r\n-]/.test(name) === cellsOf(text).includes(`'${name}`), JSON.stringify(name));
  }
});
