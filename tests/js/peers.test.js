import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lawsAt } from '../../app/js/player/peers.js';
import { doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

test('learned returns under the cursor are drawn as the figure draws them at rest', () => {
  const { locations, masses, steps, actions, drawn } = fixture('laws');
  const reel = { locations: doublesOf(locations), masses: doublesOf(masses), steps, actions };
  assert.equal(drawn.length, steps);
  drawn.forEach((wanted, step) => {
    const got = lawsAt(reel, step);
    for (const name of ['x', 'y']) {
      assert.deepEqual(
        got[name].map((line) => line.length),
        wanted[name].map((line) => line.length),
      );
      got[name]
        .flat()
        .forEach((value, i) => assert.ok(Math.abs(value - wanted[name].flat()[i]) < 1e-9, `${name} ${i}`));
    }
    got.range.forEach((value, i) => assert.ok(Math.abs(value - wanted.range[i]) < 1e-9, `range, step ${step}`));
  });
});
