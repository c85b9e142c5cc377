// What only a network's gamma-space can be asked for: discounts between those that were trained, and a softer slope.
// Both are linear maps of the learned values (laplace_core/code/interpolation.py, laplace_core/code/encoding.py).
/** @import { Arrays, Header, Model } from '../types.js' */
import { masses, product } from './algebra.js';

const logTime = (gamma) => Math.log(-1 / Math.log(gamma));

// What lies between two discounts as two weights of what lies at them: (1 - gamma) Q is a line over log time.
function weightsBetween(low, gamma, high) {
  const share = (logTime(gamma) - logTime(low)) / (logTime(high) - logTime(low));
  return [((1 - share) * (1 - low)) / (1 - gamma), (share * (1 - high)) / (1 - gamma)];
}

/**
 * Values at the trained discounts, and at those that are added between.
 * @param {Pick<Header, 'actions' | 'added'>} header
 * @param {Pick<Arrays, 'gammas'>} arrays
 * @param {Float64Array} values - (A, trained, width)
 * @returns {Float64Array} (A, G, width)
 */
export function filled({ actions, added }, { gammas }, values) {
  if (!added) return values;
  const A = actions.length,
    G = gammas.length,
    every = added + 1,
    T = (G - 1) / every + 1,
    width = values.length / A / T;
  const out = new Float64Array(A * G * width);
  for (let a = 0; a < A; a++) {
    for (let g = 0; g < G; g++) {
      const t = Math.floor(g / every),
        from = (a * T + t) * width,
        to = (a * G + g) * width,
        left = g % every;
      const [low, high] = left ? weightsBetween(gammas[g - left], gammas[g], gammas[g - left + every]) : [1, 0];
      for (let i = 0; i < width; i++) out[to + i] = low * values[from + i] + (left && high * values[from + width + i]);
    }
  }
  return out;
}

/**
 * The most that interpolation misses of (1 - gamma) Q where a trained discount is left out.
 * @param {Model} model
 * @param {Float64Array} Z - differences of one action, (G, bins)
 * @returns {Float64Array} of each trained discount but the outermost two
 */
export function leftOut({ header: { added }, arrays: { gammas } }, Z) {
  const every = added + 1,
    T = (gammas.length - 1) / every + 1,
    width = Z.length / gammas.length;
  return Float64Array.from({ length: Math.max(0, T - 2) }, (_, i) => {
    const [below, at, above] = [i * every, (i + 1) * every, (i + 2) * every];
    const [low, high] = weightsBetween(gammas[below], gammas[at], gammas[above]);
    let sum = 0,
      worst = 0;
    for (let h = width - 1; h >= 0; h--) {
      sum += low * Z[below * width + h] + high * Z[above * width + h] - Z[at * width + h];
      worst = Math.max(worst, Math.abs(sum));
    }
    return worst * (1 - gammas[at]);
  });
}

/**
 * A softer slope as a linear map. It is off for rewards across the middle gap; an open end holds all that is beyond
 * its edge.
 * @param {Float64Array} sensitivities - on the axis of the activation, (H,)
 * @param {number} share - of the trained slope, from 0 to 1
 * @param {boolean} open - whether there are bins beyond the outermost sensitivities
 * @returns {{ map: Float64Array, off: number }} what a difference leaves in each bin, (bins, bins), and the most that
 *   it misses of the chance to lie above a threshold
 */
export function softened(sensitivities, share, open) {
  const last = sensitivities.length - 1,
    steep = Math.tan((Math.PI * share) / 2),
    outer = (i, j) => 2 * sensitivities[i] - sensitivities[j];
  const places = open ? Float64Array.of(outer(0, 1), ...sensitivities, outer(last, last - 1)) : sensitivities;
  const ends = open ? Float64Array.of(-Infinity, ...sensitivities, Infinity) : sensitivities; // where a bin ends
  const H = places.length - 1,
    map = new Float64Array(H * H);
  const beyond = (x) => 0.5 + Math.atan(steep * Math.tanh((share * x) / 2)) / (Math.PI * share);
  const passed = (x) => (Number.isFinite(x) ? beyond(x) : Number(x > 0));
  for (let j = 0; j < H; j++) {
    const middle = (places[j] + places[j + 1]) / 2;
    for (let h = 0; h < H; h++) map[j * H + h] = passed(middle - ends[h]) - passed(middle - ends[h + 1]);
  }
  const first = places[H >> 1],
    gap = places[(H >> 1) + 1] - first;
  const rewards = Float64Array.from({ length: 9 }, (_, i) => first + (i / 8) * gap),
    exact = masses(rewards, ends, share);
  let off = 0,
    sum = 0;
  product(masses(rewards, ends, 1), map, 9, H, H).forEach((value, i) => {
    sum = (i % H ? sum : 0) + value - exact[i];
    off = Math.max(off, Math.abs(sum));
  });
  return { map, off };
}
