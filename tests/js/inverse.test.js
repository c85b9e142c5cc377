import assert from 'node:assert/strict';
import { test } from 'node:test';
import { averagingKernel, made, nearest } from '../../app/js/inverse/maths.js';
import { read } from '../../app/js/inverse/model.js';
import { columnsOf, solved } from '../../app/js/core/nonnegative.js';
import { panelsOf } from '../../app/js/inverse/panels.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const TOLERANCE = 1e-6; // of the largest entry
const given = fixture('inverse'),
  models = Object.fromEntries(Object.entries(given.payloads).map(([name, data]) => [name, read(bytesOf(data))]));

const close = (got, wanted, words) => {
  assert.equal(got.length, wanted.length, words);
  const size = wanted.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-9);
  got.forEach((value, i) =>
    assert.ok(Math.abs(value - wanted[i]) <= TOLERANCE * size, `${words}: ${value}, not ${wanted[i]}`),
  );
};

test('what is drawn at an alpha is what the library computes, whatever alpha came before', () => {
  assert.ok(given.cases.length >= 200);
  for (const { payload, alpha, row, arrays, ...numbers } of given.cases) {
    const model = models[payload],
      found = made(model, alpha),
      drawn = { ...found, kernel: averagingKernel(model, found.kept, row) };
    for (const [name, wanted] of Object.entries(arrays))
      close(drawn[name], doublesOf(wanted), `${payload}, ${name} at ${alpha}`);
    for (const name of ['residual', 'size', 'degrees'])
      close([drawn[name]], [numbers[name]], `${payload}, ${name} at ${alpha}`);
  }
});

test('the non-negative timeline has no negative mass', () => {
  for (const [name, model] of Object.entries(models))
    if (name.endsWith('nonnegative')) assert.ok(made(model, 0.01).tau.every((mass) => mass >= 0));
});

test('non-negative columns do not depend on what was asked before, and are those of scipy.optimize.nnls', () => {
  assert.equal(given.columns.length, 2);
  for (const { system, targets, rows, found } of given.columns) {
    const columns = () => columnsOf(doublesOf(system), doublesOf(targets), rows),
      [falling, rising, there] = [columns(), columns(), columns()],
      down = found.map(({ alpha }) => falling.at(alpha)),
      up = found
        .toReversed()
        .map(({ alpha }) => rising.at(alpha))
        .reverse();
    found.forEach(({ alpha, masses }, i) => {
      close(down[i], doublesOf(masses), `scipy.optimize.nnls at ${alpha}`);
      (there.at(alpha / 7), there.at(alpha * 90));
      for (const other of [up[i], there.at(alpha), columns().at(alpha)])
        assert.deepEqual(other, down[i], `at ${alpha}`);
    });
    assert.deepEqual(falling.at(0), falling.at(1e-300));
  }
});

test('a symmetric system is solved', () => {
  close(solved(Float64Array.of(4, 2, 2, 3), Float64Array.of(2, 5)), [-0.5, 2], 'two unknowns');
});

test('a column without a mass to be found stays empty', () => {
  const columns = columnsOf(Float64Array.of(1, 1, 0, 0, 0, 1), Float64Array.of(-1, -2), 3);
  close(columns.at(0.1), Float64Array.of(0, 0, 0), 'negative data');
});

test('the nearest alpha is nearest in the logarithm', () => {
  assert.equal(nearest(Float64Array.of(0.01, 1, 100), 0.2), 1);
  assert.equal(nearest(Float64Array.of(0.01, 1, 100), 0.05), 0);
});

test('a finger takes hold of the dot of the L-curve where it is drawn, also of an alpha beyond the sweep', () => {
  const model = models['0 tikhonov'],
    words = Object.fromEntries(model.header.rules.map((name) => [name, { title: name, why: '', formula: '' }])),
    { handle } = panelsOf(model, words).curve,
    box = { x: 50, y: 10, w: 200, h: 100 },
    scale = /** @type {any} */ ({ X: (value) => 100 + 10 * value, Y: (value) => 60 - 10 * value, box });
  assert.ok(handle);
  const scene = (residual, size) => /** @type {any} */ ({ made: { residual, size } });
  assert.ok(handle(scene(1, 1), scale, 100, 60));
  assert.ok(!handle(scene(1, 1), scale, 250, 10));
  assert.ok(handle(scene(1e40, 1e40), scale, 250, 10), 'it is drawn at the corner');
});

test('a hand on the L-curve and on the curve of a rule sets an alpha of the sweep', () => {
  const model = models['0 tikhonov'],
    { alphas, residual, size } = model.arrays,
    words = Object.fromEntries(model.header.rules.map((name) => [name, { title: name, why: '', formula: '' }])),
    { curve, rules } = panelsOf(model, words);
  const scene = /** @type {any} */ ({
    model,
    images: {
      misfits: residual.map(Math.log10).slice(model.header.first),
      sizes: size.map(Math.log10).slice(model.header.first),
    },
  });
  const scale = /** @type {any} */ ({ X: (x) => 100 * x, Y: (y) => -100 * y, toX: (px) => px / 100 });
  const at = 120,
    place = [100 * Math.log10(residual[at]), -100 * Math.log10(size[at])];
  const { alpha } = curve.drag(scene, scale, place[0], place[1]);
  assert.ok(Math.abs(Math.log(alpha / alphas[at])) < 0.02, `${alpha}, not ${alphas[at]}`);
  assert.equal(rules[1].drag(scene, scale, -100, 0).alpha, 0.1);
  assert.equal(rules[1].drag(scene, scale, 1e4, 0).alpha, +alphas[alphas.length - 1].toPrecision(4));
});
