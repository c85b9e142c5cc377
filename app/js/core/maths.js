// The mathematics of the lens: from a model and a state to everything that is drawn. Knows no page.
/** @import { Columns, DecodedWithTruth, Effect, Grid, Inverse, Kernel, Model, Resolution, Seen, State, Switch, Timelines, Truth } from '../types.js' */
import {
  ROUNDING,
  greedy,
  growing,
  inverseOf,
  masses,
  normalNoise,
  product,
  remember,
  rowNorms,
  sigmoid,
  transposed,
} from './algebra.js';
import { projections, rowAt } from './model.js';
import { softened } from './network.js';
import { columnsOf } from './nonnegative.js';

const LEAST_SHOWN = 0.05; // a picture that holds a smaller share of the true timeline shows nothing of it
const FLOOR = 0.05; // below this decoded survival a conditional distribution is noise over noise

// ---- reading

/**
 * How much of each row lies before a deadline.
 * @param {number} horizon - in steps of the world
 * @param {number} steps - K
 * @param {number} softness - width of the deadline as a share of the horizon
 * @param {number} [dt] - length of a row
 * @returns {Float64Array} (K,), from 0 to 1
 */
export function deadlineWeights(horizon, steps, softness, dt = 1) {
  return Float64Array.from({ length: steps }, (_, k) => {
    const left = horizon - 0.5 - k * dt;
    if (softness < 1e-9) return Math.abs(left) < 5e-10 ? 0.5 : Number(left > 0);
    return sigmoid(left / (softness * horizon));
  });
}

/**
 * d(tau) of every horizon, one row each; (K, K). A hard deadline counts the rows before it.
 * @param {Model} model
 * @param {number} softness
 * @param {number} gamma
 * @returns {Float64Array} (K, K)
 */
function discounts({ cache, horizons, K, dt }, softness, gamma) {
  return remember(cache, softness > 0 ? 'soft discounts' : 'hard discounts', [softness, gamma], () => {
    const out = new Float64Array(K * K);
    horizons.forEach((horizon, k) => {
      const weights = softness > 0 ? deadlineWeights(horizon, K, softness, dt) : null;
      for (let n = 0; n < K; n++) out[k * K + n] = (weights ? weights[n] : Number(n <= k)) * gamma ** (n * dt);
    });
    return out;
  });
}

/**
 * How much of the whole step n is held by row k, (K, N), as laplace_core.study.pipeline.row_shares: all of it where they meet.
 * @param {Model} model
 * @returns {Float64Array} (K, N)
 */
function shares({ K, dt, length }) {
  const out = new Float64Array(K * length);
  for (let n = 0; n < length; n++) {
    const place = n / dt,
      first = Math.floor(place + 1e-9),
      second = Math.min(1, Math.max(0, place - first));
    if (first < K) out[first * length + n] = 1 - second;
    if (first + 1 < K) out[(first + 1) * length + n] = second;
  }
  return out;
}
/**
 * The truth of a world under a state.
 * @param {Model} model
 * @param {State} state
 * @returns {Truth}
 */
function truthOf(model, state) {
  const { A, K, length, arrays, cache, header } = model,
    { timeline, rewards } = arrays,
    width = rewards.length;
  const rows = remember(cache, 'true rows', 0, () => {
    const spread = shares(model),
      flat = new Float64Array(A * length),
      alive = new Float64Array(A * length);
    for (let i = 0; i < A * length; i++) {
      for (let v = 0; v < width; v++) {
        flat[i] += timeline[i * width + v] * rewards[v];
        alive[i] += timeline[i * width + v];
      }
    }
    const spreadOver = (x, w, a) => product(spread, x.subarray(a * length * w, (a + 1) * length * w), K, length, w);
    const each = (x, w) => Array.from({ length: A }, (_, a) => spreadOver(x, w, a));
    const steps = (x) => Array.from({ length: A }, (_, a) => x.subarray(a * length, (a + 1) * length)); // by whole step
    return {
      rewards: each(flat, 1),
      survival: each(alive, 1),
      chances: each(timeline, width),
      steps: { rewards: steps(flat), survival: steps(alive) },
    };
  });
  const read = (name, softness, gamma) =>
    remember(cache, name, [softness, gamma], () => {
      const d = discounts(model, softness, gamma);
      return rows.rewards.map((line) => product(d, line, K, K, 1));
    });
  return {
    ...rows,
    values: read('true values', state.softness, state.value_gamma),
    get hard() {
      return read('hard true values', 0, header.acting_gamma);
    },
    acting: header.acting_gamma,
  };
}

/**
 * The share of the shown action's probability that its rows have at the wrong step or reward, as
 * laplace_core.study.grades.timeline_error: each midpoint counts for the nearest reward, each row for the nearest step.
 * @param {Model} model
 * @param {State} state
 * @param {DecodedWithTruth} seen
 * @returns {number} 0 is right; more than 1 is more than all that truly comes
 */
export function timelineError(model, state, seen) {
  const {
      dt,
      K,
      cache,
      arrays: { rewards },
    } = model,
    { H, midpoints, masses: M, truth, tau, n } = seen,
    V = rewards.length;
  const nearest = remember(cache, 'nearest', [midpoints[0], midpoints[H - 1], H], () => {
    let v = 0;
    return Int32Array.from(midpoints, (theta) => {
      while (v < V - 1 && theta > (rewards[v] + rewards[v + 1]) / 2) v++;
      return v;
    });
  });
  const step = (k) => Math.floor(k * dt + 0.5 + 1e-9),
    N = step(K - 1) + 1;
  const true_ = remember(
    cache,
    'true by reward',
    [state.action, state.slope, state.normalise === 'survival', H, midpoints[0]],
    () => {
      const out = new Float64Array(N * V),
        chances = truth.chances[state.action],
        alive = truth.survival[state.action];
      const seen = Float64Array.from({ length: V }, (_, v) =>
        M.subarray(v * H, (v + 1) * H).reduce((sum, mass) => sum + mass, 0),
      );
      let shown = 0,
        comes = 0;
      for (let i = 0; i < K * V; i++) {
        shown += chances[i] * seen[i % V];
        comes += chances[i];
      }
      if (shown < LEAST_SHOWN * comes) return null; // the picture lies beside what comes
      for (let k = 0; k < K; k++) {
        const whole = state.normalise !== 'survival' ? 1 : alive[k] > FLOOR ? 1 / alive[k] : 0;
        for (let v = 0; v < V; v++) {
          const chance = chances[k * V + v] * whole;
          if (chance) for (let h = 0; h < H; h++) out[step(k) * V + nearest[h]] += chance * M[v * H + h];
        }
      }
      return out;
    },
  );
  if (!true_) return 1;
  const rows = new Float64Array(N * V);
  for (let k = 0; k < n; k++) for (let h = 0; h < H; h++) rows[step(k) * V + nearest[h]] += tau[k * H + h];
  let off = 0,
    all = 0;
  for (let i = 0; i < rows.length; i++) {
    off += Math.abs(rows[i] - true_[i]);
    all += true_[i];
  }
  return (0.5 * off) / Math.max(all, 0.05);
}

// ---- everything at once

/**
 * What a state of the controls shows.
 * @param {Model} model
 * @param {State} state
 * @param {number} [most] - bounds the work on values over all horizons where every horizon has its own inverse:
 *   beyond it some horizons are left out (NaN); 0 leaves all out but the one that is read
 * @returns {Seen}
 */
export function see(model, state, most = Infinity) {
  const { A, K, dt, cache, arrays, header } = model;
  if (arrays.decoded)
    state = { ...state, ...header.decoded_for }; // the server's timeline is of these settings
  else if (state.fold && !model.grids.own.plain) state = { ...state, fold: false }; // until the server has answered
  const grid = (state.paper_grid && model.grids.paper) || model.grids.own;
  const columns = (state.mixed && grid.columns.per_gamma) || grid.columns.shared;
  const open = Boolean(arrays.bin_edges); // what lies beyond the sensitivities counts, in bins of its own
  const sensitivities = (state.clip && !columns.plain && arrays.clipped_thetas) || arrays.thetas;
  const thetas = arrays.bin_edges ?? sensitivities,
    H = thetas.length - 1; // edges of the bins, and how many bins
  const midpoints = arrays.bin_values ?? Float64Array.from({ length: H }, (_, h) => (thetas[h] + thetas[h + 1]) / 2);
  const spaceKey = [state.slope, sensitivities === arrays.thetas];
  const M = model.truth ? remember(cache, 'masses', spaceKey, () => masses(arrays.rewards, thetas, state.slope)) : null;
  const { places } = arrays;
  const soft =
    places && state.slope_share < 1
      ? remember(cache, 'soft', state.slope_share, () => softened(places, state.slope_share, open))
      : null;
  const map = columns.plain ? soft?.map : M,
    width = columns.width; // columns -> midpoints; null: they are the midpoints
  const drawn = () => noiseOf(model, grid, state.noise_seed);
  const hum = state.noise > 0 ? remember(cache, 'noise', [grid.name, state.noise_seed], drawn) : null;
  const readRow = rowAt(model, state.constant ? state.horizon : Math.max(0, state.horizon - state.used));
  const leftRow = rowAt(model, Math.max(0, state.horizon - state.used)),
    n = state.fold ? readRow + 1 : K;

  const means = map ? product(map, midpoints, width, H, 1) : midpoints;
  const plus = (x, y) => (hum ? x.map((value, i) => value + state.noise * y[i]) : x);
  // Everything of one action that an inverse is applied to, in components.
  const inComponents = state.shift ? columns.late : columns,
    humming = state.shift ? hum?.late : hum;
  const parts = Array.from({ length: A }, (_, a) => ({
    columns: inComponents.projected[a],
    hum: humming?.projected[a],
    mean: plus(
      product(inComponents.projected[a], means, grid.r, width, 1),
      humming && product(humming.projected[a], midpoints, grid.r, H, 1),
    ),
    constant: plus(inComponents.constants[a], humming?.constants[a]),
  }));
  const rawRows = (part, inverse) => {
    if (!hum && map) return product(inverse.decode(part.columns, width), map, inverse.n, width, H);
    return inverse.decode(plus(map ? product(part.columns, map, grid.r, width, H) : part.columns, part.hum), H);
  };
  // Below it a row holds nothing but rounding (laplace_core.inverse.rounding_of_rows); only rescaling asks.
  const sized = [
    state.slope,
    state.slope_share,
    thetas[0],
    H,
    columns === grid.columns.per_gamma,
    grid.name,
    state.noise,
    hum && state.noise_seed,
    state.shift,
  ];
  const roundingOf = (a, inverse) => {
    const size = remember(cache, `sizes ${a}`, sized, () => {
      const Z = differencesOf(columns, grid, map, H, a, hum, state.noise);
      return Math.hypot(
        ...Array.from({ length: state.shift ? grid.G - 1 : grid.G }, (_, g) =>
          Z.subarray(g * H, (g + 1) * H).reduce((sum, value) => sum + Math.abs(value), 0),
        ),
      );
    });
    return rowNorms(inverse, grid).map((norm) => ROUNDING * size * norm);
  };

  // ---- what a solver makes of an action: rows of tau-space, survival, and expected rewards, before any rescaling
  /** @type {(inverse: Inverse) => Timelines} */
  const linear = (inverse) => ({
    n: inverse.n,
    rows: (a) => rawRows(parts[a], inverse),
    survival: (a) => inverse.decode(parts[a].constant, 1),
    rewards: (a) => inverse.decode(parts[a].mean, 1),
    rounding: (a) => roundingOf(a, inverse),
  });
  /** @returns {Timelines} */
  const nonnegative = () => {
    const { reduced, turned } = grid,
      q = reduced.length / K,
      wide = open ? H : H + 2,
      end = open ? 0 : 1;
    const each = parts.map((_, a) => {
      const solver = remember(cache, `columns ${a}`, sized, () => {
        const full = allMasses(model, grid, { columns, map, hum, soft, thetas, H, open }, state, a);
        return columnsOf(reduced, transposed(product(turned, full, q, grid.G, wide), q, wide), K);
      });
      return solver.at(state.alpha);
    });
    const rows = (a) =>
      Float64Array.from({ length: K * H }, (_, i) => each[a][Math.floor(i / H) * wide + (i % H) + end]);
    return {
      n: K,
      rows,
      survival: (a) => product(each[a], new Float64Array(wide).fill(1), K, wide, 1),
      rewards: (a) => product(rows(a), midpoints, K, H, 1),
    };
  };
  const ready = /** @type {Float64Array} */ (arrays.decoded),
    alive = /** @type {Float64Array} */ (arrays.decoded_survival),
    folded = arrays.decoded_values;
  /** @returns {Timelines} */
  const served = () => {
    const rows = (a) => ready.slice(a * K * H, (a * K + n) * H);
    return {
      n,
      rows,
      survival: (a) => alive.slice(a * K, a * K + n),
      rewards: (a) => product(rows(a), midpoints, n, H, 1),
    };
  };
  const tauSpace = (timelines, a) => {
    const rows = timelines.rows(a);
    if (state.normalise !== 'none')
      normalise(
        rows,
        timelines.survival(a),
        state.normalise,
        H,
        dt,
        state.normalise === 'paper' ? timelines.rounding?.(a) : undefined,
      );
    return rows;
  };
  const rewardsOf = (timelines, a) => {
    if (state.normalise === 'paper') return product(tauSpace(timelines, a), midpoints, timelines.n, H, 1);
    const rows = timelines.rewards(a);
    if (state.normalise !== 'none') normalise(rows, timelines.survival(a), 'survival', 1, dt);
    return rows;
  };

  const inverse = inverseOf(grid, state, n);
  const timelines = ready ? served() : grid.reduced ? nonnegative() : linear(inverse);
  const tau = tauSpace(timelines, state.action);
  const survival = parts.map((_, a) => timelines.survival(a));
  const rewards = parts.map((_, a) =>
    a === state.action ? product(tau, midpoints, timelines.n, H, 1) : rewardsOf(timelines, a),
  );
  const d = discounts(model, state.softness, state.value_gamma);
  const valueAt = (row, expected) => {
    let sum = 0;
    for (let k = 0; k < expected.length; k++) sum += d[row * K + k] * expected[k];
    return sum;
  };
  const values = Array.from({ length: A }, () => new Float64Array(K).fill(NaN));
  if (!state.fold)
    values.forEach((line, a) =>
      line.forEach((_, k) => {
        line[k] = valueAt(k, rewards[a]);
      }),
    );
  else
    values.forEach((line, a) => {
      line[readRow] = valueAt(readRow, rewards[a]);
    });
  if (state.fold && folded) values.forEach((line, a) => line.set(folded.subarray(a * K, (a + 1) * K)));
  else if (state.fold && most) {
    // every other horizon has its own inverse
    const wide = state.normalise === 'paper' ? H * (hum ? grid.r : width) : grid.r;
    const stride = Math.max(1, Math.ceil((A * wide * K * K) / 2 / most));
    const grown = growing(grid, state.alpha);
    for (let k = 0; k < K; k++) {
      grown.add();
      if (k === readRow || (k % stride && k !== K - 1)) continue;
      const shorter = linear(grown);
      parts.forEach((_, a) => {
        values[a][k] = valueAt(k, rewardsOf(shorter, a));
      });
    }
  }
  const terms = rewards.map((line) => line.reduce((sum, value) => sum + Math.abs(value), 0));
  const scale = Math.max(...terms, ...midpoints.map(Math.abs)); // as scale_of_values in laplace_core.study.horizon
  const chosenAt = (row) =>
    greedy(
      values.map((line) => line[row]),
      scale,
    );
  const decoded = {
    grid,
    thetas,
    midpoints,
    H,
    open,
    n,
    inverse,
    readRow,
    leftRow,
    tau,
    survival,
    rewards,
    values,
    columns,
    map,
    hum,
    soft,
    scale,
    chosen: chosenAt(readRow),
    chosenAt,
    whole: !values[0].some(Number.isNaN),
    d,
  };
  if (!M) return { ...decoded, masses: null };
  const truth = truthOf(model, state),
    /** @type {(row: number) => number[]} */
    optimumAt = (row) => values.map((_, a) => arrays.optimum[a * K + row]);
  const optimum = optimumAt(leftRow);
  return {
    ...decoded,
    masses: M,
    truth,
    optimumAt,
    best: greedy(optimum),
    bestAt: (row) => greedy(optimumAt(row)),
    regret: Math.max(...optimum) - optimum[decoded.chosen],
  };
}

/**
 * Rescales rows in place: given survival, or to probability 1.
 * @param {Float64Array} rows - (n, width)
 * @param {Float64Array} survival - (n,)
 * @param {'survival' | 'paper'} how
 * @param {number} width
 * @param {number} dt - length of a row
 * @param {Float64Array} [rounding] - what a row holds at least that is not rounding, (n,)
 * @returns {void}
 */
export function normalise(rows, survival, how, width, dt, rounding) {
  for (let k = 0; k < survival.length; k++) {
    const row = rows.subarray(k * width, (k + 1) * width);
    if (how === 'survival') {
      const alive = survival[k] / dt;
      for (let h = 0; h < width; h++) row[h] = alive > FLOOR ? row[h] / alive : 0;
    } else {
      let mass = 0;
      for (let h = 0; h < width; h++) mass += row[h] = Math.max(0, row[h]);
      const least = rounding ? rounding[k] : 0;
      for (let h = 0; h < width; h++) row[h] = mass > least ? (dt * row[h]) / mass : 0;
    }
  }
}

/**
 * Noise of gamma-space for a seed at level 1, in components: of the differences, and of the constant channel.
 * @param {Model} model
 * @param {Grid} grid
 * @param {number} seed
 * @returns {NonNullable<Seen['hum']>}
 */
function noiseOf({ A, H, arrays }, grid, seed) {
  const open = arrays.bin_edges ? 1 : 0; // then the constant channel stands before the tails, and 0 after them
  const { G, gammas } = grid,
    width = H - 1 + 2 * open,
    differences = [],
    above = new Float64Array(A * G), // of the last tail
    constant = new Float64Array(A * G);
  const values = normalNoise(seed, A * G * H),
    more = normalNoise(seed, A * G, A * G * H);
  for (let a = 0; a < A; a++) {
    const out = new Float64Array(G * width);
    for (let g = 0; g < G; g++) {
      const scale = 1 / (1 - gammas[g]),
        from = (a * G + g) * H,
        tail = (h) => (h < 0 ? more[a * G + g] : h < H ? values[from + h] : 0);
      for (let h = 0; h < width; h++) out[g * width + h] = scale * (tail(h - open) - tail(h - open + 1));
      constant[a * G + g] = scale * more[a * G + g];
      above[a * G + g] = scale * tail(H - 1);
    }
    differences.push(out);
  }
  const steps = differences.map((_, a) => constant.subarray(a * G, (a + 1) * G));
  return Object.assign(projections(grid, differences, width, steps), { differences, above, steps });
}
/**
 * Differences of gamma-space of one action.
 * @param {Columns} columns
 * @param {Grid} grid
 * @param {Float64Array | null | undefined} map - (width, H)
 * @param {number} H
 * @param {number} a
 * @param {Seen['hum']} hum
 * @param {number} noise
 * @returns {Float64Array} (G, H)
 */
function differencesOf(columns, grid, map, H, a, hum, noise) {
  const Z = map ? product(columns.values[a], map, grid.G, columns.width, H) : columns.values[a];
  return hum ? Z.map((value, i) => value + noise * hum.differences[a][i]) : Z;
}

/**
 * Masses of one action over the discounts with those beyond the sensitivities, as a solver gets them that knows that all
 * of them sum to survival: filtered, and shifted where the index is.
 * @param {Model} model
 * @param {Grid} grid
 * @param {Pick<Seen, 'columns' | 'map' | 'hum' | 'soft' | 'thetas' | 'H' | 'open'>} seen
 * @param {State} state
 * @param {number} a
 * @returns {Float64Array} (G, bins)
 */
function allMasses({ arrays }, grid, { columns, map, hum, thetas, H, open }, state, a) {
  const { G, smoothing } = grid,
    { width, values } = columns,
    inner = differencesOf(columns, grid, map, H, a, hum, state.noise),
    wide = open ? H : H + 2;
  let full = inner;
  if (!open) {
    full = new Float64Array(G * wide);
    for (let g = 0; g < G; g++) {
      let above = 0,
        sum = columns.steps[a][g];
      if (columns.plain) above = arrays.above?.[a * G + g] ?? 0;
      else
        for (let v = 0; v < width; v++)
          above += values[a][g * width + v] * sigmoid(state.slope * (arrays.rewards[v] - thetas[H]));
      if (hum) {
        above += state.noise * hum.above[a * G + g];
        sum += state.noise * hum.steps[a][g];
      }
      full.set(inner.subarray(g * H, (g + 1) * H), g * wide + 1);
      full[g * wide + wide - 1] = above;
      for (let h = 1; h < wide; h++) sum -= full[g * wide + h];
      full[g * wide] = sum;
    }
  }
  if (smoothing) full = product(smoothing, full, G, G, wide);
  if (!state.shift) return full;
  const late = new Float64Array(G * wide);
  late.set(full.subarray(0, (G - 1) * wide), wide);
  return late;
}

/**
 * Differences of gamma-space of the shown action.
 * @param {Seen} seen
 * @param {State} state
 * @returns {Float64Array} (G, H)
 */
export const gammaSpace = ({ grid, columns, map, hum, H }, state) =>
  differencesOf(columns, grid, map, H, state.action, hum, state.noise);

/**
 * Weights over the discounts that give the sum of a target times the rows, (G,): decoding values that are shifted by one
 * is decoding by weights that are shifted back.
 * @param {Model} model
 * @param {Grid} grid
 * @param {State} state
 * @param {Inverse} inverse
 * @param {Float64Array} target - (K,)
 * @returns {Float64Array} (G,)
 */
function weightsOf({ arrays: { matrix } }, { Ut, G, r }, state, inverse, target) {
  const each = matrix
    ? product(target, matrix, 1, matrix.length / G, G)
    : product(inverse.weights(target), Ut, 1, r, G);
  return state.shift ? each.map((_, g) => (g + 1 < G ? each[g + 1] : 0)) : each;
}

/**
 * What alpha and T really weigh each future step with, what they should, and how much noise it lets through. Of a solver
 * that is not linear it is that of Tikhonov at the same alpha.
 * @param {Model} model
 * @param {State} state
 * @param {Seen} seen
 * @returns {Kernel}
 */
export function kernel(model, state, { grid, n, readRow, d, inverse }) {
  const { K } = model,
    wanted = d.slice(readRow * K, (readRow + 1) * K),
    target = new Float64Array(K);
  for (let k = 0; k < n; k++) target[k] = wanted[k];
  const weights = weightsOf(model, grid, state, inverse, target);
  return {
    wanted,
    actual: product(weights, grid.transform, 1, grid.G, K),
    gain: Math.hypot(...weights),
  };
}

/**
 * The averaging kernel: through which window of the true timeline a row is seen.
 * @param {Model} model
 * @param {State} state
 * @param {Seen} seen
 * @param {number} row
 * @returns {Resolution}
 */
export function resolution(model, state, { grid, n, inverse }, row) {
  const { K, dt } = model,
    kernel = new Float64Array(K);
  if (row < n) {
    const weights = weightsOf(
      model,
      grid,
      state,
      inverse,
      Float64Array.from({ length: K }, (_, k) => Number(k === row)),
    );
    product(weights, grid.transform, 1, grid.G, K, kernel);
  }
  let peak = 0;
  kernel.forEach((value, k) => {
    if (value > kernel[peak]) peak = k;
  });
  let low = peak,
    high = peak;
  while (low > 0 && kernel[low - 1] > kernel[peak] / 2) low--;
  while (high < K - 1 && kernel[high + 1] > kernel[peak] / 2) high++;
  return { kernel, peak: peak * dt, half: ((high - low) / 2) * dt, low: low * dt, high: high * dt };
}

/**
 * Whether the server has not answered yet for a state, of a solver that does not follow the hand.
 * @param {Model} model
 * @param {State} state
 * @returns {boolean}
 */
export function pending({ header: { decoded_for: held, follows }, arrays, grids }, state) {
  if (arrays.decoded && held) return Object.keys(held).some((name) => held[name] !== state[name]);
  return !follows || (state.fold && !grids.own.plain);
}

// ---- artefacts, each a switch

// An artefact that is a flag of the state.
const flag = (name, words) => ({
  ...words,
  on: { [name]: true },
  off: { [name]: false },
  isOn: (state) => Boolean(state[name]),
});

/**
 * The artefacts, each a switch: the settings with it, the settings without it, and whether a state has it.
 * @type {Record<string, Switch>}
 */
export const SWITCHES = {
  rescale: {
    label: 'row rescaling',
    on: { normalise: 'paper' },
    off: { normalise: 'none' },
    isOn: (s) => s.normalise === 'paper',
    help: 'Every row is rescaled to probability 1, even after the end of the episode.',
  },
  fold: flag('fold', {
    label: 'only T rows, K = T',
    help: 'Only T rows are decoded, so later rewards are folded into them.',
  }),
  mixed: flag('mixed', {
    label: 'mixed policies',
    help: 'Every discount follows its own greedy policy: no single process has such a gamma-space.',
  }),
  paper_grid: flag('paper_grid', {
    label: 'the paper’s grid',
    help: 'The paper’s 15 discounts, from .01 to .99, piecewise linear.',
  }),
  clip: flag('clip', {
    label: 'edge clipping',
    help: 'The sensitivities begin at a reward that occurs, so half of its probability is lost.',
  }),
  constant: flag('constant', {
    label: 'constant T',
    help: 'The agent acts with T at every step instead of with the time to go.',
  }),
  shift: flag('shift', {
    label: 'index shifted by one',
    help: 'Each discount is decoded by the row of the next one, as in the paper’s published notebook.',
  }),
};

/**
 * Whether a switch applies to a model.
 * @param {Model} model
 * @param {string} name
 * @returns {boolean}
 */
export function available({ grids, arrays, truth }, name) {
  const own = grids.own.columns;
  return (
    {
      mixed: Boolean(own.per_gamma),
      paper_grid: Boolean(grids.paper),
      clip: Boolean(arrays.clipped_thetas) && !own.shared.plain,
      constant: truth,
    }[name] ?? true
  );
}

/**
 * What a switch does to this picture: the probability that it adds to or takes from a row, in the worst row, and the
 * regret with and without it.
 * @param {Model} model
 * @param {State} state
 * @param {string} name
 * @returns {Effect}
 */
export function effect(model, state, name) {
  const rule = SWITCHES[name],
    least = 0; // of the values, only those of the horizon that is read
  const on = see(model, { ...state, ...rule.on }, least),
    off = see(model, { ...state, ...rule.off }, least);
  let size = 0;
  for (let k = 0; k < Math.min(on.n, off.n); k++) {
    let more = 0,
      less = 0,
      all = 0;
    for (let h = 0; h < on.H; h++) {
      const change = on.tau[k * on.H + h] - off.tau[k * off.H + h];
      if (change > 0) more += change;
      else less -= change;
      all += change;
    }
    // Other sensitivities have other cells, of which only the sums can be compared.
    size = Math.max(size, (name === 'clip' ? Math.abs(all) : Math.max(more, less)) / model.dt);
  }
  return { size, on: on.regret, off: off.regret, flips: on.chosen !== off.chosen };
}
