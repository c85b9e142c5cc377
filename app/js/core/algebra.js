// Products, filters and noise: the building blocks of the mathematics of the lens.
// Matrices are Float64Arrays in row-major order; (n, m) in a comment is their shape.
/** @import { Grid, GrowingInverse, Inverse, Model, State } from '../types.js' */
import { shares } from './filters.js';

// ---- small tools

/**
 * The product of two matrices.
 * @param {Float64Array} a - (n, m)
 * @param {Float64Array} b - (m, k)
 * @param {number} n
 * @param {number} m
 * @param {number} k
 * @param {Float64Array} [out] - (n, k), where the product is written
 * @returns {Float64Array} (n, k)
 */
export function product(a, b, n, m, k, out = new Float64Array(n * k)) {
  for (let i = 0; i < n; i++) {
    const row = out.subarray(i * k, (i + 1) * k).fill(0);
    for (let j = 0; j < m; j++) {
      const factor = a[i * m + j],
        other = j * k;
      if (factor !== 0) for (let l = 0; l < k; l++) row[l] += factor * b[other + l];
    }
  }
  return out;
}

/**
 * The transpose of a matrix.
 * @param {Float64Array} a - (n, m)
 * @param {number} n
 * @param {number} m
 * @returns {Float64Array} (m, n)
 */
export function transposed(a, n, m) {
  const out = new Float64Array(n * m);
  for (let i = 0; i < n; i++) for (let j = 0; j < m; j++) out[j * n + i] = a[i * m + j];
  return out;
}

/**
 * A value that is kept by name and made again when its key changes.
 * @template T
 * @param {Model['cache']} cache
 * @param {string} name
 * @param {unknown} key - whatever JSON tells apart
 * @param {() => T} make
 * @returns {T}
 */
export function remember(cache, name, key, make) {
  const text = JSON.stringify(key);
  if (cache[name]?.text !== text) cache[name] = { text, value: make() };
  return cache[name].value;
}

/**
 * The logistic function, exact to its last digits on both sides.
 * @param {number} x
 * @returns {number} from 0 to 1
 */
export const sigmoid = (x) => {
  const small = Math.exp(-Math.abs(x));
  return (x >= 0 ? 1 : small) / (1 + small);
};

// How far apart two values may be and still be equal, and the floor of rounding, as in laplace_core.code.ties.
export const ROUNDING = 1e-12;

/**
 * How far apart two values may be and still be equal, as in laplace_core.code.ties.
 * @param {number} best - the larger value, in reward
 * @param {number} scale - the size of the terms that values are sums of
 * @returns {number} in reward
 */
export const tieSize = (best, scale) => Math.max(1e-9 * Math.abs(best), ROUNDING * scale);

/**
 * The lowest action that ties with the best.
 * @param {number[]} values - (A,), in reward
 * @param {number} [scale] - the size of the terms that the values are sums of
 * @returns {number}
 */
export function greedy(values, scale = 0) {
  const best = Math.max(...values),
    least = best - tieSize(best, Math.max(scale, ...values.map(Math.abs)));
  return values.findIndex((value) => value >= least);
}

// ---- noise by counting: the numbers of the library

function hashed(x) {
  x ^= x >>> 16;
  x = Math.imul(x, 0x7feb352d);
  x ^= x >>> 15;
  x = Math.imul(x, 0x846ca68b);
  return (x ^ (x >>> 16)) >>> 0;
}

/**
 * Standard normal numbers of a seed: those of laplace_core.code.noise.
 * @param {number} seed - from 0 to 2^32 - 1
 * @param {number} count
 * @param {number} [skip] - how many numbers of the seed come before
 * @returns {Float64Array} (count,)
 */
export function normalNoise(seed, count, skip = 0) {
  const first = hashed(seed ^ 0x9e3779b9),
    out = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const number = ((i + skip) & 0x7fffffff) << 1;
    const radius = hashed((first + number) | 0),
      angle = hashed((first + number + 1) | 0);
    out[i] = Math.sqrt(-2 * Math.log((radius + 0.5) / 2 ** 32)) * Math.cos((2 * Math.PI * angle) / 2 ** 32);
  }
  return out;
}

// ---- encoding

/**
 * What each reward leaves between two neighbouring sensitivities: f_h(r) - f_{h+1}(r).
 * @param {Float64Array} rewards - (V,)
 * @param {Float64Array} thetas - (H+1,)
 * @param {number} slope - per reward
 * @returns {Float64Array} (V, H)
 */
export function masses(rewards, thetas, slope) {
  const width = thetas.length - 1,
    out = new Float64Array(rewards.length * width);
  rewards.forEach((reward, v) => {
    let before = sigmoid(slope * (reward - thetas[0]));
    for (let h = 0; h < width; h++) {
      const after = sigmoid(slope * (reward - thetas[h + 1]));
      out[v * width + h] = before - after;
      before = after;
    }
  });
  return out;
}

// ---- the inverse

// An inverse turns components (r, width) into its n rows, and a target (n,) into weights over the components.
const regular = ({ V, s, r, K, free, filter }, alpha) => {
  const f = shares(filter, s, free, alpha).kept,
    scaled = (x, width) => x.map((value, i) => value * f[(i / width) | 0]);
  return {
    n: K,
    decode: (right, width) => product(V, scaled(right, width), K, r, width),
    weights: (target) => scaled(product(target, V, 1, K, r), 1),
  };
};

/**
 * The 2-norm of every row of the decode matrix, the same for all actions.
 * @param {Inverse} inverse - of n rows; it keeps the norms
 * @param {Pick<Grid, 'Ut' | 'G'>} grid
 * @returns {Float64Array} (n,)
 */
export function rowNorms(inverse, { Ut, G }) {
  if (inverse.norms?.length === inverse.n) return inverse.norms;
  const rows = inverse.decode(Ut, G);
  inverse.norms = Float64Array.from({ length: inverse.n }, (_, k) => Math.hypot(...rows.subarray(k * G, (k + 1) * G)));
  return inverse.norms;
}

/**
 * The inverse of the first rows only (K = T), grown row by row: [F^T; alpha] = Q R by rotations, so that no square is
 * ever formed and a small alpha loses no digits. Of Q, only the part beside F^T is needed, kept by columns.
 * @param {Grid} grid
 * @param {number} alpha
 * @returns {GrowingInverse} of no row yet
 */
export function growing({ V, s, r, K }, alpha) {
  const R = Float64Array.from({ length: r * r }, (_, i) => (i % (r + 1) ? 0 : Math.max(alpha, 1e-9)));
  const Q = new Float64Array(r * K),
    row = new Float64Array(r),
    fresh = new Float64Array(K);
  const found = {
    n: 0,
    add() {
      const n = ++found.n;
      for (let i = 0; i < r; i++) row[i] = V[(n - 1) * r + i] * s[i];
      fresh.fill(0)[n - 1] = 1;
      for (let i = 0; i < r; i++) {
        const length = Math.hypot(R[i * r + i], row[i]),
          c = R[i * r + i] / length,
          d = row[i] / length;
        for (let j = i; j < r; j++) {
          const up = R[i * r + j],
            low = row[j];
          R[i * r + j] = c * up + d * low;
          row[j] = c * low - d * up;
        }
        for (let k = 0, at = i * K; k < n; k++, at++) {
          const up = Q[at],
            low = fresh[k];
          Q[at] = c * up + d * low;
          fresh[k] = c * low - d * up;
        }
      }
      return found;
    },
    decode(right, width) {
      // Q R^-T right
      const part = Float64Array.from(right),
        { n } = found,
        out = new Float64Array(n * width);
      for (let i = 0; i < r; i++) {
        for (let w = 0; w < width; w++) {
          let sum = part[i * width + w];
          for (let j = 0; j < i; j++) sum -= R[j * r + i] * part[j * width + w];
          part[i * width + w] = sum / R[i * r + i];
        }
        for (let k = 0; k < n; k++)
          for (let w = 0; w < width; w++) out[k * width + w] += Q[i * K + k] * part[i * width + w];
      }
      return out;
    },
    weights(target) {
      // R^-1 Q^T target
      const out = new Float64Array(r);
      for (let i = r - 1; i >= 0; i--) {
        for (let k = 0; k < found.n; k++) out[i] += Q[i * K + k] * target[k];
        for (let j = i + 1; j < r; j++) out[i] -= R[i * r + j] * out[j];
        out[i] /= R[i * r + i];
      }
      return out;
    },
  };
  return found;
}

/**
 * The inverse of all rows, or, where only those before the deadline are decoded, of these: by plain Tikhonov, for the
 * components of any other solver are those of all rows.
 * @param {Grid} grid
 * @param {Pick<State, 'fold' | 'alpha'>} state
 * @param {number} n - rows up to the deadline
 * @returns {Inverse}
 */
export function inverseOf(grid, { fold, alpha }, n) {
  if (!fold || !grid.plain) return regular(grid, alpha);
  const grown = growing(grid, alpha);
  while (grown.n < n) grown.add();
  return grown;
}
