import assert from 'node:assert/strict';
import { test } from 'node:test';
import { read, remade } from '../../app/js/core/model.js';
import { leftOut } from '../../app/js/core/network.js';
import { bytesOf, doublesOf } from './agreement.js';
import { fixture } from './fixtures.js';

test('what lies between trained discounts is interpolated as in the library, and so is its error', () => {
  const { payload, trained, filled, left_out: missed } = fixture('interpolation');
  const model = remade(read(bytesOf(payload)), doublesOf(trained.differences), doublesOf(trained.constant));
  for (const name of ['differences', 'constant']) {
    const wanted = doublesOf(filled[name]);
    assert.equal(model.arrays[name].length, wanted.length);
    wanted.forEach((value, i) => assert.ok(Math.abs(model.arrays[name][i] - value) <= 1e-14 + 1e-12 * Math.abs(value)));
  }
  const off = leftOut(model, model.grids.own.columns.shared.values[1]),
    wanted = doublesOf(missed);
  assert.equal(off.length, wanted.length);
  wanted.forEach((value, i) => assert.ok(Math.abs(off[i] - value) <= 1e-9 * Math.abs(value)));
});
