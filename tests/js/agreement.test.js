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

test('every solver, every weight and filter of the discounts is the one of the library', () => {
  const given = fixture('solvers'),
    { off, problems, leftOut, entries } = compared(given);
  assert.ok(given.cases.length >= 150);
  assert.ok(new Set(given.cases.map(({ payload }) => payload.split(' ').pop())).size >= 9); // solvers
  assert.deepEqual(problems, []);
  assert.ok(leftOut < 0.05 * entries, `${leftOut} of ${entries} numbers are left out`);
  for (const [name, share] of Object.entries(off)) assert.ok(share <= 1e-6, `${name} is off by ${share}`);
});
