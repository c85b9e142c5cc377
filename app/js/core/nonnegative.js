// Non-negative Tikhonov of many columns: the Newton method of laplace_core/inverse/nonnegative.py on its dual, begun
// where the last alpha left it, so that a drag takes a step or two a frame.
/** @import { NonnegativeColumns } from '../types.js' */

const MOST_STEPS = 200, // as in the library
  FALL = 3,
  ON_THE_WAY = 2,
  SEARCHES = 12,
  IDLE = 8;

const dot = (a, b) => {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
};

/**
 * Solves H x = b for a symmetric positive definite H, which is overwritten.
 * @param {Float64Array} H - (n, n)
 * @param {Float64Array} b - (n,)
 * @returns {Float64Array} (n,)
 */
export function solved(H, b) {
  const n = b.length,
    x = Float64Array.from(b);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j <= i; j++) {
      let sum = H[i * n + j];
      for (let k = 0; k < j; k++) sum -= H[i * n + k] * H[j * n + k];
      H[i * n + j] = i === j ? Math.sqrt(Math.max(sum, Number.MIN_VALUE)) : sum / H[j * n + j];
    }
  }
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < i; k++) x[i] -= H[i * n + k] * x[k];
    x[i] /= H[i * n + i];
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) x[i] -= H[k * n + i] * x[k];
    x[i] /= H[i * n + i];
  }
  return x;
}

/**
 * The columns of a problem, to be solved at one alpha after another.
 * @param {Float64Array} A - the system in its components, (q, K), rows orthogonal, the longest first
 * @param {Float64Array} targets - (B, q)
 * @param {number} K
 * @returns {NonnegativeColumns}
 */
export function columnsOf(A, targets, K) {
  const q = A.length / K,
    B = targets.length / q,
    size = Math.hypot(...A.subarray(0, K)),
    lengths = Float64Array.from({ length: q }, (_, i) =>
      dot(A.subarray(i * K, (i + 1) * K), A.subarray(i * K, (i + 1) * K)),
    );
  const c = new Float64Array(B * q),
    x = new Float64Array(K),
    along = new Float64Array(K);
  let last = 0; // the alpha that c belongs to; 0: to none

  const rowsOf = (at, out) => {
    out.fill(0);
    for (let i = 0; i < q; i++) for (let k = 0, row = i * K; k < K; k++) out[k] += at[i] * A[row + k];
    return out;
  };

  // One step of a column; how far off it was, 0 where that is rounding.
  function moved(at, z, alpha) {
    rowsOf(at, x);
    const gradient = new Float64Array(q),
      hessian = new Float64Array(q * q);
    for (let i = 0; i < q; i++) {
      let sum = alpha * alpha * at[i] - z[i];
      for (let k = 0, row = i * K; k < K; k++) if (x[k] > 0) sum += A[row + k] * x[k];
      gradient[i] = sum;
    }
    const norm = (v) => Math.sqrt(dot(v, v)),
      rounding = 4 * Number.EPSILON * (size * size * norm(at) + norm(z));
    const off = norm(gradient);
    if (off <= rounding) return 0;
    for (let k = 0; k < K; k++) {
      if (!(x[k] > 0)) continue;
      for (let i = 0; i < q; i++) {
        const factor = A[i * K + k];
        for (let j = 0; j <= i; j++) hessian[i * q + j] += factor * A[j * K + k];
      }
    }
    for (let i = 0; i < q; i++) hessian[i * q + i] += alpha * alpha;
    const step = solved(hessian, gradient).map((value) => -value),
      share = shareOf(at, z, step, alpha);
    for (let i = 0; i < q; i++) at[i] += share * step[i];
    return off;
  }

  // How much of a step to go: to where the slope of the dual along it is a tenth of the first one.
  function shareOf(at, z, step, alpha) {
    rowsOf(step, along);
    let linear = 0;
    for (let i = 0; i < q; i++) linear += step[i] * (alpha * alpha * at[i] - z[i]);
    const quadratic = alpha * alpha * dot(step, step);
    const slope = (share) => {
      let sum = linear + share * quadratic;
      for (let k = 0; k < K; k++) {
        const value = x[k] + share * along[k];
        if (value > 0) sum += value * along[k];
      }
      return sum;
    };
    let low = 0,
      high = 1,
      atLow = slope(0),
      atHigh = slope(1),
      share = 1;
    const small = 0.1 * Math.abs(atLow);
    if (!(atHigh > small)) return 1;
    for (let n = 0; n < SEARCHES; n++) {
      const width = high - low,
        guess = low - (atLow * width) / (atHigh - atLow);
      share = Math.min(high - 0.1 * width, Math.max(low + 0.1 * width, guess));
      const found = slope(share);
      if (found < 0) [low, atLow] = [share, found];
      else [high, atHigh] = [share, found];
      if (Math.abs(found) <= small) break;
    }
    return share;
  }

  return {
    size,
    at(alpha) {
      const falling = [alpha],
        from = last || size; // on the way down from the last alpha, by thirds
      while (falling[falling.length - 1] * FALL < from) falling.push(falling[falling.length - 1] * FALL);
      if (!last) {
        const first = falling[falling.length - 1]; // rows of A are orthogonal: the first guess needs no solution
        for (let b = 0; b < B; b++)
          for (let i = 0; i < q; i++) c[b * q + i] = targets[b * q + i] / (lengths[i] + first * first);
      }
      const out = new Float64Array(K * B);
      for (let b = 0; b < B; b++) {
        const at = c.subarray(b * q, (b + 1) * q),
          z = targets.subarray(b * q, (b + 1) * q);
        for (let n = falling.length - 1; n >= 0; n--) {
          const most = n ? ON_THE_WAY : MOST_STEPS;
          let best = Infinity,
            idle = 0; // steps without progress: the column is as exact as doubles have it
          for (let i = 0; i < most && idle < IDLE; i++) {
            const off = moved(at, z, falling[n]);
            if (!off) break;
            idle = off < best / 2 ? 0 : idle + 1;
            best = Math.min(best, off);
          }
        }
        rowsOf(at, x);
        for (let k = 0; k < K; k++) out[k * B + b] = Math.max(0, x[k]);
      }
      last = alpha;
      return out;
    },
  };
}
