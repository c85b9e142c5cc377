import assert from 'node:assert/strict';
import { test } from 'node:test';
import { see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { judged, timelineWords } from '../../app/js/lens/verdict.js';
import { bytesOf } from './agreement.js';
import { fixture } from './fixtures.js';

test('the verdict of the lens is the one of the library: the same action, grades and numbers', () => {
  const views = fixture('verdicts');
  assert.ok(views.length > 0);
  views.forEach((view, number) => {
    const model = read(bytesOf(view.payload)),
      seen = see(model, view.state),
      { tone, error, timeline } = judged(model, view.state, seen);
    assert.equal(tone, view.tone, `tone of view ${number}`);
    assert.equal(seen.chosen, view.chosen, `choice of view ${number}`);
    const values = seen.values.map((line) => line[seen.readRow]);
    assert.equal(values.length, view.values.length);
    [...values, error].forEach((value, i) => {
      const far = Math.abs(value - [...view.values, view.error][i]);
      assert.ok(far <= view.allowed, `value ${i} of view ${number} is off by ${far}`);
    });
    assert.ok(Math.abs(timeline - view.timeline) <= 1e-6 * Math.max(1, view.timeline), `timeline of view ${number}`);
  });
});

test('a timeline is said to be off by more than all only where its number is', () => {
  const words = (size) => timelineWords(size, 'go').replace(' Timeline of go: ', '');
  assert.equal(words(0.04), '');
  assert.equal(words(0.493), 'ruined, 49% misplaced.');
  for (const size of [1, 1 + 2.3e-16, 1.004]) assert.equal(words(size), 'ruined, 100% misplaced.');
  assert.equal(words(1.01), 'ruined, off by 1.01 times all that truly comes.');
});
