// What an alpha makes of the data: components filtered and multiplied, as laplace_core/inverse/linear.py does it.
/** @import { InverseModel, Made } from '../types.js' */
import { product } from '../core/algebra.js';
import { shares } from '../core/filters.js';

/**
 * Norms and degrees of freedom of the sweep at any alpha.
 * @param {InverseModel} model
 * @param {{ kept: Float64Array, lost: Float64Array }} found
 * @returns {{ residual: number, size: number, degrees: number }}
 */
export function norms({ header, arrays, r }, { kept, lost }) {
  let residual = header.outside,
    size = 0,
    degrees = 0;
  for (let i = 0; i < r; i++) {
    residual += arrays.energy[i] * lost[i] ** 2;
    if (i >= header.free) size += arrays.energy[i] * kept[i] ** 2;
    degrees += 1 - lost[i];
  }
  return { residual: Math.sqrt(residual), size: Math.sqrt(size), degrees };
}

/**
 * A row of the resolution matrix D F: through which window a step is seen, (K,).
 * @param {InverseModel} model
 * @param {Float64Array} kept
 * @param {number} k
 * @returns {Float64Array}
 */
export function averagingKernel({ arrays, r, K, seenThrough }, kept, k) {
  const weights = Float64Array.from({ length: r }, (_, i) => arrays.rows[k * r + i] * kept[i]);
  return product(weights, seenThrough, 1, r, K);
}

/**
 * All that is drawn at an alpha.
 * @param {InverseModel} model
 * @param {number} alpha
 * @returns {Made}
 */
export function made(model, alpha) {
  const { arrays, header, G, K, B, r, Ut, transform } = model,
    found = shares(header.filter, arrays.s, header.free, alpha),
    { kept } = found;
  const scaled = model.components.map((value, i) => value * kept[Math.floor(i / B)]);
  const follows = model.nonnegative,
    tau = follows ? follows.at(alpha) : (arrays.decoded ?? product(arrays.rows, scaled, K, r, B));
  const rewards = product(tau, arrays.bin_values, K, B, 1),
    back = product(transform, rewards, G, K, 1),
    still = Boolean(arrays.decoded) && Math.abs(alpha / (header.decoded_at ?? alpha) - 1) > 1e-6;
  const filtered = arrays.rows.map((value, i) => value * kept[i % r]); // rows of V, times the filter
  const spread = arrays.reference && noiseOf(model, filtered),
    mean = arrays.reference_values && product(filtered, product(Ut, arrays.reference_values, r, G, 1), K, r, 1);
  return {
    alpha,
    ...found,
    ...norms(model, found),
    tau,
    rewards,
    back,
    still,
    noise: spread,
    bias: mean?.map((value, k) => value - arrays.reference[k]),
  };
}

// Standard deviation that the noise gives each expected reward of the linear solver, (K,).
function noiseOf({ arrays, header, G, K, r, Ut }, filtered) {
  const weighted = Ut.map((value, i) => value * arrays.deviations[i % G]),
    D = product(filtered, weighted, K, r, G);
  return Float64Array.from({ length: K }, (_, k) => {
    let sum = 0;
    for (let g = 0; g < G; g++) sum += D[k * G + g] ** 2;
    return header.gain * Math.sqrt(sum);
  });
}

/**
 * The place of an alpha among increasing ones: the nearest in the logarithm.
 * @param {Float64Array} alphas
 * @param {number} alpha
 * @returns {number}
 */
export function nearest(alphas, alpha) {
  let best = 0;
  for (let i = 1; i < alphas.length; i++)
    if (Math.abs(Math.log(alphas[i] / alpha)) < Math.abs(Math.log(alphas[best] / alpha))) best = i;
  return best;
}
