// Non-negative Tikhonov of many columns. At an alpha the answer is the same whatever was asked before: it is found from
// the nearest of a ladder of larger alphas, which is climbed down once, so that a drag takes a few steps a frame.
//
// Down to a small alpha by the Newton method of laplace_core/inverse/nonnegative.py on the dual. Below it the dual, which
// divides by alpha^2, loses more digits than it keeps; there by an active set, as scipy.optimize.nnls has it, whose
// systems are solved by an orthogonal factorisation.
/** @import { NonnegativeColumns } from '../types.js' */
import { transposed } from './algebra.js';

const MOST_STEPS = 200, // as in the library
  FALL = 1.5, // from one alpha of the ladder to the next
  FALL_BELOW = 3, // the same below LEAST
  SEARCHES = 12,
  IDLE = 8,
  ON_THE_WAY = 2,
  LEAST = 3e-3, // of the largest singular value
  FLOOR = 1e-9; // of the same: what is smaller is drawn as this

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
  const x = new Float64Array(K),
    along = new Float64Array(K),
    rows = transposed(A, q, K); // a row of the timeline after another, as the Hessian adds them up

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
      for (let i = 0, at = k * q; i < q; i++) {
        const factor = rows[at + i];
        for (let j = 0, to = i * q; j <= i; j++) hessian[to + j] += factor * rows[at + j];
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

  // Newton's method on a column from where it is, until it is as exact as doubles have it.
  function newton(at, z, alpha, most) {
    let best = Infinity,
      idle = 0; // steps without progress
    for (let i = 0; i < most && idle < IDLE; i++) {
      const off = moved(at, z, alpha);
      if (!off) break;
      idle = off < best / 2 ? 0 : idle + 1;
      best = Math.min(best, off);
    }
  }

  // Masses of all columns, (B, K).
  function massesOf(c) {
    const found = new Float64Array(B * K);
    for (let b = 0; b < B; b++) {
      rowsOf(c.subarray(b * q, (b + 1) * q), x);
      for (let k = 0; k < K; k++) found[b * K + k] = Math.max(0, x[k]);
    }
    return found;
  }

  // All columns at an alpha, from those at a larger one: the dual (B, q), and below LEAST the masses.
  /** @type {(above: { c: Float64Array, masses?: Float64Array }, alpha: number, most: number) => typeof above} */
  function below(above, alpha, most) {
    const c = Float64Array.from(above.c),
      z = (b) => targets.subarray(b * q, (b + 1) * q);
    if (alpha >= LEAST * size) {
      for (let b = 0; b < B; b++) newton(c.subarray(b * q, (b + 1) * q), z(b), alpha, most);
      return { c };
    }
    const masses = Float64Array.from(above.masses ?? massesOf(c));
    for (let b = 0; b < B; b++) activeSet(A, z(b), alpha, masses.subarray(b * K, (b + 1) * K));
    return { c: above.c, masses };
  }

  // The ladder: its alphas, and what was found at those that were passed.
  const alphas = [size];
  for (let last = size; last > FLOOR * size; alphas.push(last)) last /= last > LEAST * size ? FALL : FALL_BELOW;
  const ladder = /** @type {ReturnType<typeof below>[]} */ ([]);

  return {
    size,
    at(asked) {
      const alpha = Math.max(asked, FLOOR * size),
        depth = Math.max(
          0,
          alphas.findLastIndex((each) => each > alpha),
        );
      while (ladder.length <= depth) {
        const n = ladder.length, // rows of A are orthogonal: the first guess needs no solution
          guess = () => targets.map((value, i) => value / (lengths[i % q] + size * size));
        ladder.push(below(n ? ladder[n - 1] : { c: guess() }, alphas[n], ON_THE_WAY));
      }
      const { c, masses = massesOf(c) } = below(ladder[depth], alpha, MOST_STEPS);
      return transposed(masses, B, K);
    },
  };
}

/**
 * x >= 0 of least |A x - z|^2 + alpha^2 |x|^2, from any x >= 0 in its place: the active set of Lawson and Hanson (Solving
 * Least Squares Problems, 1974, chapter 23).
 * @param {Float64Array} A - (q, K)
 * @param {Float64Array} z - (q,)
 * @param {number} alpha - above 0
 * @param {Float64Array} x - (K,), overwritten
 */
export function activeSet(A, z, alpha, x) {
  const K = x.length,
    free = [],
    rounding = 4 * Number.EPSILON * Math.sqrt(dot(A, A) * dot(z, z)),
    barred = new Set(); // rows that only rounding would free
  for (let k = 0; k < K; k++) if (x[k] > 0) free.push(k);
  let found = settled(A, z, alpha, x, free, freed(A, z, alpha, K, free));
  for (let n = 0; n < 3 * K; n++) {
    let most = rounding,
      next = -1;
    for (let k = 0; k < K; k++) {
      if (x[k] > 0 || barred.has(k)) continue;
      let sum = 0;
      for (let i = 0; i < z.length; i++) sum += A[i * K + k] * found.residual[i];
      if (sum > most) [most, next] = [sum, k];
    }
    if (next < 0) return;
    const place = free.filter((k) => k < next).length; // in their order, whichever was freed first
    free.splice(place, 0, next);
    const wanted = freed(A, z, alpha, K, free);
    if (wanted.x[place] > 0) {
      barred.clear();
      found = settled(A, z, alpha, x, free, wanted);
    } else {
      barred.add(next);
      free.splice(place, 1);
    }
  }
}

// Goes to what is wanted of the rows that are free, and holds those at 0 that would fall below it.
function settled(A, z, alpha, x, free, wanted) {
  for (;;) {
    let share = 1,
      first = -1;
    free.forEach((k, i) => {
      if (wanted.x[i] > 0) return;
      const here = x[k] / (x[k] - wanted.x[i] || 1);
      if (here < share || first < 0) [share, first] = [here, k];
    });
    free.forEach((k, i) => (x[k] += share * (wanted.x[i] - x[k])));
    if (first < 0) return wanted;
    x[first] = 0;
    for (let i = free.length - 1; i >= 0; i--) {
      if (x[free[i]] > 0) continue;
      x[free[i]] = 0;
      free.splice(i, 1);
    }
    wanted = freed(A, z, alpha, x.length, free);
  }
}

/**
 * Tikhonov on some rows alone: the smallest (x, w) with A_free x + alpha w = z. An orthogonal factorisation of
 * [A_free^T; alpha] finds it and never forms alpha^2.
 * @param {Float64Array} A - (q, K)
 * @param {Float64Array} z - (q,)
 * @param {number} alpha - above 0
 * @param {number} K
 * @param {number[]} free - p rows
 * @returns {{ x: Float64Array, residual: Float64Array }} (p,), and z - A_free x, (q,)
 */
export function freed(A, z, alpha, K, free) {
  const q = z.length,
    p = free.length,
    long = p + q;
  // Reflections of Householder: from its diagonal on a column holds the vector that reflects it.
  const M = new Float64Array(q * long),
    diagonal = new Float64Array(q),
    halves = new Float64Array(q); // half of the square of each vector
  for (let j = 0; j < q; j++) {
    for (let i = 0; i < p; i++) M[j * long + i] = A[j * K + free[i]];
    M[j * long + p + j] = alpha;
  }
  const reflect = (j, out, at) => {
    const end = p + j + 1; // below it a column is still 0
    let sum = 0;
    for (let i = j; i < end; i++) sum += M[j * long + i] * out[at + i];
    sum /= halves[j];
    for (let i = j; i < end; i++) out[at + i] -= sum * M[j * long + i];
  };
  for (let j = 0; j < q; j++) {
    const at = j * long;
    for (let m = 0; m < j; m++) reflect(m, M, at);
    let sum = 0;
    for (let i = j; i < long; i++) sum += M[at + i] ** 2;
    diagonal[j] = M[at + j] > 0 ? -Math.sqrt(sum) : Math.sqrt(sum);
    halves[j] = sum - diagonal[j] * M[at + j];
    M[at + j] -= diagonal[j];
  }
  const y = new Float64Array(long);
  for (let j = 0; j < q; j++) {
    let sum = z[j];
    for (let m = 0; m < j; m++) sum -= M[j * long + m] * y[m];
    y[j] = sum / diagonal[j];
  }
  for (let j = q - 1; j >= 0; j--) reflect(j, y, 0);
  return { x: y.slice(0, p), residual: y.slice(p).map((value) => alpha * value) };
}
