// How tau-space is read by a person: on a scale on which a certain reward is 1, over the rewards that there are, with the
// error that noise makes, and with the alphas at which another action is chosen. Knows no page.
/** @import { Model, Seen, State, Windows } from '../types.js' */
import { product, remember, sigmoid } from './algebra.js';
import { see } from './maths.js';

const REACH = 2, // half a window, in units of 1 / slope: f rises from .12 to .88 within it
  SHOWN = 0.02; // of the largest entry: columns that hold less hold no reward

/**
 * The windows over which the probability of a reward is added up: the bins whose middle lies within 2 / slope of it. A
 * certain reward in the middle of a window of half width d leaves 2 f(d) - 1 in it, where f is the activation; a sum is
 * divided by that, so that it reads as 1. At an edge of theta a window has one side, and its width is that of this side:
 * what an edge cuts off stays missing.
 * @param {Model} model
 * @param {State} state
 * @param {Seen} seen
 * @returns {Windows | null} null where the slope of the activation is not known
 */
export function windowsOf({ arrays, cache, truth }, state, { thetas, H, open }) {
  const { places } = arrays;
  if (!truth && !places) return null;
  return remember(cache, 'windows', [state.slope, state.slope_share, thetas[0], H], () => {
    let x = thetas.map((theta) => theta * state.slope); // edges, (H+1,), in units of 1 / slope
    if (places) {
      const last = places.length - 1,
        padded = open ? [2 * places[0] - places[1], ...places, 2 * places[last] - places[last - 1]] : [...places];
      x = Float64Array.from(padded, (place) => place * state.slope_share);
    }
    const middle = Float64Array.from({ length: H }, (_, h) => (x[h] + x[h + 1]) / 2),
      from = new Int32Array(H),
      to = new Int32Array(H),
      whole = new Float64Array(H);
    for (let h = 0, low = 0, high = 0; h < H; h++) {
      while (middle[h] - middle[low] > REACH) low++;
      while (high < H && middle[high] - middle[h] <= REACH) high++;
      [from[h], to[h]] = [low, high];
      whole[h] = 2 * sigmoid(Math.max(middle[h] - x[low], x[high] - middle[h])) - 1;
    }
    return { from, to, whole };
  });
}

/**
 * Rows on the scale of `windowsOf`.
 * @param {Float64Array} rows - (n, H)
 * @param {number} H
 * @param {Windows | null} windows
 * @returns {Float64Array} (n, H); the rows themselves where there are no windows
 */
export function onScale(rows, H, windows) {
  if (!windows) return rows;
  const { from, to, whole } = windows,
    out = new Float64Array(rows.length),
    sums = new Float64Array(H + 1);
  for (let start = 0; start < rows.length; start += H) {
    for (let h = 0; h < H; h++) sums[h + 1] = sums[h] + rows[start + h];
    for (let h = 0; h < H; h++) out[start + h] = (sums[to[h]] - sums[from[h]]) / whole[h];
  }
  return out;
}

/**
 * The range of theta that holds the rewards of all actions, with a margin. It depends on the values and not on alpha, so
 * that nothing jumps while a hand moves.
 * @param {Model} model
 * @param {Seen} seen
 * @returns {number[]} low and high end, in reward
 */
export function rewardRange({ A, cache }, { thetas, H, masses, grid, map }) {
  const kinds = Object.values(grid.columns).filter(Boolean);
  return remember(cache, 'reward range', [thetas[0], H, thetas[H], masses?.[0], map?.[0], grid.name], () => {
    const held = new Float64Array(H);
    for (const { values, width } of kinds) {
      const all = Float64Array.from({ length: width }, (_, v) => {
        let most = 0;
        for (let a = 0; a < A; a++)
          for (let i = v; i < values[a].length; i += width) most = Math.max(most, Math.abs(values[a][i]));
        return most;
      });
      const least = 1e-9 * Math.max(...all);
      all.forEach((most, v) => {
        if (!masses) held[v] = Math.max(held[v], most);
        else if (most > least) for (let h = 0; h < H; h++) held[h] = Math.max(held[h], masses[v * H + h]);
      });
    }
    const least = SHOWN * Math.max(...held),
      first = held.findIndex((value) => value > least),
      last = held.findLastIndex((value) => value > least);
    if (first < 0) return [thetas[0], thetas[H]];
    const margin = Math.max(2, Math.ceil(0.08 * (last - first + 1)));
    return [thetas[Math.max(0, first - margin)], thetas[Math.min(H, last + 1 + margin)]];
  });
}

/**
 * Standard deviation that the noise of gamma-space gives each expected reward of the shown action, as the library's
 * laplace_core.inverse.bands: gain * |D diag(deviations)| by rows, where the gain is what one value at each sensitivity
 * counts in the expected reward. What smoothing adds is the rest, where there is a truth: the decoded reward without
 * noise, less the true one.
 * @param {Model} model
 * @param {State} state
 * @param {Seen} seen
 * @returns {{ noise: Float64Array, bias: Float64Array | null } | null} (n,) each, in reward a row; null without noise,
 *   where rows are rescaled, and for a solver that is not linear
 */
export function bandsOf(model, state, seen) {
  if (!(state.noise > 0) || state.normalise !== 'none' || state.shift) return null;
  if (seen.grid.reduced || model.arrays.decoded) return null; // this solver is not linear, or the server solved
  const { grid, midpoints, H, open, inverse, n, columns, map, truth } = seen,
    { G, Ut, r, gammas } = grid;
  let gain = midpoints[0] ** 2; // of the first value, or of the constant channel where the ends are open
  for (let h = 1; h < H; h++) gain += (midpoints[h] - midpoints[h - 1]) ** 2;
  if (!open) gain += midpoints[H - 1] ** 2;
  const D = inverse.decode(
    Ut.map((value, i) => (value * state.noise) / (1 - gammas[i % G])),
    G,
  );
  const noise = Float64Array.from(
    { length: n },
    (_, k) => Math.sqrt(gain) * Math.hypot(...D.subarray(k * G, (k + 1) * G)),
  );
  if (!truth) return { noise, bias: null };
  const means = map ? product(map, midpoints, columns.width, H, 1) : midpoints,
    clean = inverse.decode(product(columns.projected[state.action], means, r, columns.width, 1), 1),
    true_ = truth.rewards[state.action];
  return { noise, bias: clean.map((value, k) => value - true_[k]) };
}

const COARSE = 10; // places of the slider between two alphas that are tried at first

/**
 * Which action is chosen at each alpha, the others of the state unchanged: stretches of places of a slider. Between two
 * places that differ, the turn is found by halving; a turn and back within one coarse step is missed.
 * @param {Model} model
 * @param {State} state
 * @param {{ count: number, at(place: number): number }} scale
 * @returns {Generator<void, { from: number, action: number }[]>} one pause an alpha that was tried
 */
export function* turnsOf(model, state, { count, at }) {
  const known = new Map();
  function* chosen(place) {
    if (!known.has(place)) {
      known.set(place, see(model, { ...state, alpha: at(place) }, 0).chosen);
      yield;
    }
    return known.get(place);
  }
  const found = [{ from: 0, action: yield* chosen(0) }];
  for (let low = 0; low < count; low += COARSE) {
    const high = Math.min(count, low + COARSE),
      last = yield* chosen(high);
    let before = low;
    while ((yield* chosen(before)) !== last) {
      let after = high;
      while (after - before > 1) {
        const middle = (before + after) >> 1;
        if ((yield* chosen(middle)) === (yield* chosen(before))) before = middle;
        else after = middle;
      }
      found.push({ from: after, action: yield* chosen(after) });
      before = after;
    }
  }
  return found;
}
