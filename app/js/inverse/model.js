// A payload of the page of the inverse as a model: laplace_core/payloads/inverse.py says what it holds.
/** @import { InverseModel } from '../types.js' */
import { product, transposed } from '../core/algebra.js';
import { columnsOf } from './nonnegative.js';

/**
 * A model of a payload.
 * @param {Uint8Array} bytes
 * @returns {InverseModel}
 */
export function read(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset),
    length = view.getUint32(0, true),
    header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))),
    /** @type {Record<string, Float64Array>} */
    arrays = {};
  for (const [name, [kind, at, shape]] of Object.entries(header.arrays)) {
    const count = shape.reduce((a, b) => a * b, 1),
      size = { f8: 8, f4: 4, u2: 2 }[kind];
    const block = bytes.slice(4 + length + at, 4 + length + at + count * size).buffer; // aligned, whatever came before
    arrays[name] =
      kind === 'f8'
        ? new Float64Array(block)
        : Float64Array.from(new (kind === 'f4' ? Float32Array : Uint16Array)(block));
  }
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
