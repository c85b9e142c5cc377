import assert from 'node:assert/strict';
import { test } from 'node:test';
import { greedy, growing, inverseOf, normalNoise, product, sigmoid, transposed } from '../../app/js/core/algebra.js';
import { read } from '../../app/js/core/model.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const close = (got, wanted, tolerance) => {
  assert.equal(got.length, wanted.length);
  got.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) <= tolerance, `${value}, not ${wanted[i]}`));
};

test('products and transposes are those of NumPy', () => {
  const { a, b, product: wanted, transposed: turned } = fixture('algebra');
  close(product(doublesOf(a), doublesOf(b), 4, 5, 3), doublesOf(wanted), 1e-14);
  assert.deepEqual(transposed(doublesOf(a), 4, 5), doublesOf(turned));
});

test('a product may be written into an array that holds something', () => {
  const out = Float64Array.of(7, 7);
  assert.equal(product(Float64Array.of(1, 2), Float64Array.of(3, 4, 5, 6), 1, 2, 2, out), out);
  assert.deepEqual([...out], [13, 16]);
});

test('noise is that of the library, number by number', () => {
  for (const { seed, skip, values } of fixture('algebra').noise)
    close(normalNoise(seed, 40, skip), doublesOf(values), 1e-14);
});

test('the sigmoid keeps its digits far from 0', () => {
  assert.equal(sigmoid(0), 0.5);
  assert.ok(Math.abs(sigmoid(-40) / Math.exp(-40) - 1) < 1e-12);
  assert.equal(sigmoid(800), 1);
  assert.equal(sigmoid(-800), 0);
});

test('the lowest action of those that tie is chosen, and rounding is a tie', () => {
  assert.equal(greedy([1, 2, 2]), 1);
  assert.equal(greedy([2 - 1e-10, 2]), 0);
  assert.equal(greedy([2 - 1e-6, 2]), 1);
  assert.equal(greedy([0, 1e-10], 1e3), 0); // sums of terms of size 1000
});

test('the inverse that grows row by row ends as the whole one', () => {
  const grid = read(bytesOf(fixture('table').payload)).grids.own,
    { r, K } = grid,
    right = Float64Array.from({ length: 2 * r }, (_, i) => Math.sin(i)),
    target = Float64Array.from({ length: K }, (_, k) => Math.cos(k));
  const whole = inverseOf(grid, { fold: false, alpha: 0.1 }, K),
    grown = inverseOf(grid, { fold: true, alpha: 0.1 }, K);
  close(grown.decode(right, 2), whole.decode(right, 2), 1e-10);
  close(grown.weights(target), whole.weights(target), 1e-10);
  assert.equal(growing(grid, 0.1).add().n, 1);
});
