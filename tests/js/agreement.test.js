import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compared } from './agreement.js';
import { fixture } from './fixtures.js';

const TOLERANCE = 1e-4; // of the range of an array

test('every picture of the lens is the one of the library', () => {
  const given = fixture('agreement'),
    { off, problems, leftOut, entries } = compared(given);
  assert.ok(given.cases.length >= 72);
  assert.deepEqual(problems, []);
  assert.ok(leftOut < 0.05 * entries, `${leftOut} of ${entries} numbers are left out`);
  assert.equal(Object.keys(off).length, 9);
  for (const [name, share] of Object.entries(off)) assert.ok(share <= TOLERANCE, `${name} is off by ${share}`);
});
