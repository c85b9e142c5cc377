// What a linear solver multiplies the components of the data by: laplace_core/inverse/linear.py.
/** @import { FilterKind } from '../types.js' */

// A whole number as NumPy rounds it: halves to even.
function rounded(value) {
  const low = Math.floor(value),
    off = value - low;
  return off < 0.5 || (off === 0.5 && low % 2 === 0) ? low : low + 1;
}

// The share of a component that an iteration has not fitted yet, as a logarithm.
const logLeft = (s, alpha, largest) => Math.max(1, rounded((largest / alpha) ** 2)) * Math.log1p(-((s / largest) ** 2));

// What the data of a component are multiplied by, and the share of it that stays in the residual.
const FILTERS = {
  tikhonov: (s, a) => [s / (s * s + a * a), (a * a) / (s * s + a * a)],
  truncated: (s, a) => [s >= a ? 1 / s : 0, s < a ? 1 : 0],
  damped: (s, a) => [1 / (s + a), a / (s + a)],
  iterative: (s, a, largest) => {
    const left = logLeft(s, a, largest);
    return [-Math.expm1(left) / s, Math.exp(left)];
  },
};

/**
 * What the data of each component are multiplied by, and the share of it that stays in the residual, (r,) each.
 * @param {FilterKind} kind
 * @param {Float64Array} s - singular values, (r - free,)
 * @param {number} free - how many components come first that no filter touches
 * @param {number} alpha
 * @returns {{ kept: Float64Array, lost: Float64Array }}
 */
export function shares(kind, s, free, alpha) {
  const r = s.length + free,
    kept = new Float64Array(r).fill(1),
    lost = new Float64Array(r);
  for (let i = free; i < r; i++) [kept[i], lost[i]] = FILTERS[kind](s[i - free], alpha, s[0]);
  return { kept, lost };
}
