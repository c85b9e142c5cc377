import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { read } from '../../app/js/core/model.js';
import {
  bySurprise,
  followedAt,
  frameAt,
  levelsOf,
  modelAt,
  nextMarked,
  openReel,
  ownAt,
  spaceAt,
} from '../../app/js/player/reel.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

let given, reel;

before(async () => {
  given = fixture('reel');
  reel = { ...(await openReel(bytesOf(given.payload))), id: 'episode' };
});

test('an episode is unpacked as it was packed', () => {
  for (const [name, block] of Object.entries(given.blocks)) {
    assert.deepEqual(Float64Array.from(reel[name]), doublesOf(block), name);
  }
  assert.deepEqual([...reel.taken], given.taken);
  assert.deepEqual(reel.differs, doublesOf(given.differs));
});

test('differences come back from their 16-bit changes, the constant channel as it is', () => {
  given.differences.forEach((wanted, step) => {
    const { differences, constant } = spaceAt(reel, step);
    assert.deepEqual(differences, doublesOf(wanted), `step ${step}`);
    assert.deepEqual(constant, doublesOf(given.constant[step]), `step ${step}`);
  });
});

test('changes of 16 bits wrap around', () => {
  // 30,000, then 40,000 more: 70,000 - 65,536.
  assert.deepEqual([...levelsOf(Uint8Array.of(30000 & 255, 40000 & 255, 30000 >> 8, 40000 >> 8), 2)], [30000, 4464]);
});

test('the model of a step has the gamma-space of that step', () => {
  const model = modelAt(reel, 3, read(bytesOf(given.lens)));
  assert.equal(model.id, 'episode 3');
  assert.deepEqual(model.arrays.differences, doublesOf(given.differences[3]));
  assert.deepEqual(model.arrays.constant, doublesOf(given.constant[3]));
});

test('each step has its own picture', () => {
  given.frames.slice(0, reel.steps).forEach((frame, step) => assert.deepEqual(frameAt(reel, step), bytesOf(frame)));
  assert.equal(frameAt({ frames: new Uint8Array(), ends: new Float64Array() }, 0), null);
});

test('what followed, and the order by surprise, are those of the server', () => {
  given.followed.forEach((wanted, step) => assert.deepEqual(followedAt(reel, step), wanted));
  assert.deepEqual(bySurprise(reel), given.by_surprise);
});

test('the next marked step is looked for around the end', () => {
  assert.equal(nextMarked([1, 0, 1], 0), 2);
  assert.equal(nextMarked([1, 0, 1], 2), 0);
  assert.equal(nextMarked([0, 1, 0], 1), 1);
  assert.equal(nextMarked([0, 0], 1), -1);
});

test('only where an episode was cut off does the own value of the agent count', () => {
  const cut = { acting_gamma: 0.5, steps: 10, terminated: false };
  assert.equal(ownAt(cut, 0), false); // 0.5 ** 10
  assert.equal(ownAt(cut, 9), true);
  assert.equal(ownAt({ ...cut, terminated: true }, 9), false);
});
