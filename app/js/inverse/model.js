// A payload of the page of the inverse as a model: laplace_core/payloads/inverse.py says what it holds.
/** @import { InverseModel } from '../types.js' */
import { product, transposed } from '../core/algebra.js';
import { unpacked } from '../core/model.js';
import { columnsOf } from '../core/nonnegative.js';

/**
 * A model of a payload.
 * @param {Uint8Array} bytes
 * @returns {InverseModel}
 */
export function read(bytes) {
  const { header, arrays } = unpacked(bytes);
  return open(header, arrays);
}

function open(header, arrays) {
  const { gammas, U, s, weights, masses, bin_values: values } = arrays,
    { free, steps: K, time_step: dt } = header;
  const G = gammas.length,
    r = s.length + free,
    B = values.length,
    Ut = transposed(U, G, r).map((value, i) => value * weights[i % G]); // U^T W
  const transform = Float64Array.from({ length: G * K }, (_, i) => gammas[Math.floor(i / K)] ** ((i % K) * dt));
  return {
    header,
    arrays,
    G,
    K,
    B,
    r,
    dt,
    Ut,
    transform,
    components: product(Ut, masses, r, G, B),
    means: product(masses, values, G, B, 1),
    seenThrough: product(Ut, transform, r, G, K),
    horizons: Float64Array.from({ length: K }, (_, k) => k * dt + (1 + dt) / 2),
    nonnegative: arrays.reduced ? columnsOf(arrays.reduced, arrays.targets, K) : undefined,
    bins: { thetas: arrays.bin_edges, H: B, open: header.open },
  };
}
