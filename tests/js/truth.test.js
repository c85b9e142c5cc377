import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deadlineWeights, see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const close = (got, wanted, name) => {
  assert.equal(got.length, wanted.length, name);
  wanted.forEach((value, i) => assert.ok(Math.abs(got[i] - value) < 1e-9, `${name} ${i}: ${got[i]}, not ${value}`));
};

test('the truth is that of the library, also where a step falls between two rows', () => {
  const views = fixture('truth');
  assert.ok(views.length >= 3);
  for (const { payload, state, rewards, survival, values, optimum } of views) {
    const model = read(bytesOf(payload)),
      seen = see(model, state);
    const flat = (lines) => lines.flatMap((line) => Array.from(line));
    close(flat(seen.truth.rewards), doublesOf(rewards), 'reward');
    close(flat(seen.truth.survival), doublesOf(survival), 'survival');
    close(flat(seen.truth.values), doublesOf(values), 'value');
    const best = Array.from({ length: model.K }, (_, k) => seen.optimumAt(k));
    close(
      best[0].flatMap((_, a) => best.map((each) => each[a])),
      doublesOf(optimum),
      'optimum',
    );
  }
});

test('a hard deadline counts the steps before it, a soft one half of the step at it', () => {
  assert.deepEqual([...deadlineWeights(2, 4, 0)], [1, 1, 0, 0]);
  const soft = deadlineWeights(2.5, 4, 0.2);
  assert.equal(soft[2], 0.5);
  assert.ok(soft[1] > 0.5 && soft[1] < 1 && soft[3] > 0 && soft[3] < 0.5);
});
