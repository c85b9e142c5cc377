import assert from 'node:assert/strict';
import { test } from 'node:test';
import { see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { bandsOf, onScale, rewardRange, turnsOf, windowsOf } from '../../app/js/core/reading.js';
import { bytesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const { payload, state: given } = fixture('table'), // the paper's toy, 'short' pays 5 at once
  model = read(bytesOf(payload)),
  state = { ...given, normalise: 'none', alpha: 1e-6 };
const sigmoid = (x) => 1 / (1 + Math.exp(-x));

test('a certain reward in the middle of a bin reads as 1', () => {
  // Bins of .2 at slope 10: middles lie 2 apart in units of 1 / slope, so that a window holds three bins, 6 wide. What a
  // reward in the middle leaves in them is f(3) - f(-3) = 2 / (1 + e^-3) - 1 = 0.905148; divided by it, it reads as 1.
  const thetas = Float64Array.from({ length: 11 }, (_, h) => h / 5),
    bins = /** @type {any} */ ({ thetas, H: 10, open: false }),
    windows = windowsOf(/** @type {any} */ ({ arrays: {}, cache: {}, truth: true }), { ...state, slope: 10 }, bins);
  assert.ok(windows);
  assert.deepEqual([windows.from[5], windows.to[5]], [4, 7]);
  assert.ok(Math.abs(windows.whole[5] - 0.905148) < 1e-6, `${windows.whole[5]}`);
  const reward = 1.1, // in the middle of bin 5
    row = Float64Array.from(
      { length: 10 },
      (_, h) => sigmoid(10 * (reward - thetas[h])) - sigmoid(10 * (reward - thetas[h + 1])),
    );
  assert.ok(Math.abs(onScale(row, 10, windows)[5] - 1) < 1e-9);
  // At an edge of theta half of a reward is cut off, and it reads as half.
  const cut = Float64Array.from({ length: 10 }, (_, h) => sigmoid(-10 * thetas[h]) - sigmoid(-10 * thetas[h + 1]));
  assert.ok(onScale(cut, 10, windows)[0] < 0.6);
});

test('the sums of windows are those of a plain loop', () => {
  const seen = see(model, state),
    windows = windowsOf(model, state, seen);
  assert.ok(windows);
  const { H, n, tau, thetas } = seen,
    shown = onScale(tau, H, windows),
    middle = (h) => (thetas[h] + thetas[h + 1]) / 2;
  for (let k = 0; k < n; k++)
    for (let h = 0; h < H; h++) {
      let sum = 0;
      for (let other = 0; other < H; other++)
        if (Math.abs(middle(other) - middle(h)) <= 2 / state.slope) sum += tau[k * H + other];
      assert.ok(Math.abs(shown[k * H + h] * windows.whole[h] - sum) < 1e-9);
    }
  // The reward of 5 may lie between two middles; then the window nearest to it holds a little less.
  const peak = Math.max(...shown.subarray(0, H));
  assert.ok(peak > 0.9 && peak < 1.02, `${peak}`);
});

test('where the slope is not known rows stay as they are', () => {
  const bare = /** @type {any} */ ({ arrays: {}, cache: {}, truth: false });
  assert.equal(windowsOf(bare, state, see(model, state)), null);
  const rows = Float64Array.of(1, 2);
  assert.equal(onScale(rows, 2, null), rows);
});

test('the range of rewards holds every reward that occurs, and leaves empty columns out', () => {
  const seen = see(model, state),
    [low, high] = rewardRange(model, seen);
  assert.ok(low < 0 && high > 10);
  assert.ok(low >= seen.thetas[0] && high <= seen.thetas[seen.H]);
  assert.deepEqual(rewardRange(model, see(model, { ...state, alpha: 1 })), [low, high]); // it does not follow alpha
});

test('the alphas where the choice turns are those of a search through all places', () => {
  const scale = { count: 120, at: (i) => 10 ** (-9 + i / 12) };
  for (const normalise of /** @type {const} */ (['paper', 'none'])) {
    const of = { ...state, normalise },
      search = turnsOf(model, of, scale);
    let step = search.next();
    while (!step.done) step = search.next();
    const wanted = [];
    for (let i = 0; i <= scale.count; i++) {
      const action = see(model, { ...of, alpha: scale.at(i) }, 0).chosen;
      if (wanted.at(-1)?.action !== action) wanted.push({ from: i, action });
    }
    assert.deepEqual(step.value, wanted);
    if (normalise === 'paper') assert.equal(wanted.length, 2); // else this shows nothing
  }
});

test('bands: none without noise or of rescaled rows, and a bias that a smaller alpha takes away', () => {
  const bands = (change) => bandsOf(model, { ...state, ...change }, see(model, { ...state, ...change }));
  assert.equal(bands({ noise: 0 }), null);
  assert.equal(bands({ noise: 0.01, normalise: 'paper' }), null);
  const size = (alpha) => Math.max(...(bands({ noise: 0.01, alpha })?.bias ?? []).map(Math.abs));
  assert.ok(size(1e-5) < 1e-2 * size(0.3));
});
