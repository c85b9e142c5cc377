// A payload as a model: what Python sent, in the components of its transforms.
/** @import { Arrays, Components, Grid, Header, Model, Simulation } from '../types.js' */
import { product, transposed } from './algebra.js';
import { filled } from './network.js';

/**
 * Header and arrays of a payload.
 * @param {Uint8Array} bytes - as laplace_core/payloads/packing.py packs them
 * @returns {{ header: any, arrays: Record<string, Float64Array> }}
 */
export function unpacked(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset),
    length = view.getUint32(0, true),
    header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))),
    /** @type {Record<string, Float64Array>} */
    arrays = {};
  for (const [name, [kind, at, shape]] of Object.entries(header.arrays)) {
    const count = shape.reduce((a, b) => a * b, 1),
      size = { f8: 8, f4: 4, u2: 2 }[kind];
    const block = bytes.slice(4 + length + at, 4 + length + at + count * size).buffer; // aligned, whatever is before it
    arrays[name] =
      kind === 'f8'
        ? new Float64Array(block)
        : Float64Array.from(new (kind === 'f4' ? Float32Array : Uint16Array)(block));
  }
  return { header, arrays };
}

/**
 * A model of a payload of the lens.
 * @param {Uint8Array} bytes
 * @returns {Model & { bytes: Uint8Array }}
 */
export function read(bytes) {
  const { header, arrays } = unpacked(bytes);
  return { ...open(header, /** @type {Arrays} */ (/** @type {unknown} */ (arrays))), bytes };
}

/**
 * A model of the arrays of a payload.
 * @param {Header} header
 * @param {Arrays} arrays
 * @returns {Model}
 */
function open(header, arrays) {
  const A = header.actions.length,
    K = header.steps,
    dt = header.time_step,
    H = arrays.thetas.length;
  /** @type {(name: Grid['name']) => Grid} */
  const grid = (name) => {
    const part = (kind) => arrays[name + kind],
      gammas = part('gammas'),
      s = part('s'),
      U = part('U'),
      weights = part('weights'),
      smoothing = part('smoothing'),
      G = gammas.length,
      { free, filter } = header,
      r = s.length + free;
    const weighted = transposed(U, G, r).map((value, i) => (weights ? value * weights[i % G] : value));
    const found = {
      name,
      G,
      r,
      K,
      U,
      gammas,
      s,
      free,
      filter,
      plain: header.solver === 'tikhonov' && !weights && !smoothing,
      V: part('V'),
      Ut: smoothing ? product(weighted, smoothing, r, G, G) : weighted,
      smoothing,
      transform: Float64Array.from({ length: G * K }, (_, i) => gammas[Math.floor(i / K)] ** ((i % K) * dt)),
      reduced: part('reduced'),
      turned: part('turned'),
      columns: /** @type {Grid['columns']} */ ({}),
    };
    for (const kind of ['shared', 'per_gamma']) {
      const W = part(kind);
      if (W) found.columns[kind] = channels(found, W, A, arrays.rewards.length);
    }
    if (!name && arrays.differences) {
      const bins = arrays.bin_values?.length ?? H - 1;
      found.columns.shared = Object.assign(channels(found, arrays.differences, A, bins, arrays.constant), {
        plain: true,
      });
    }
    return found;
  };
  const horizons = Float64Array.from({ length: K }, (_, k) => k * dt + (1 + dt) / 2);
  return {
    header,
    A,
    K,
    dt,
    H,
    truth: Boolean(arrays.timeline),
    arrays,
    cache: {},
    grids: { own: grid(''), ...(arrays.paper_gammas ? { paper: grid('paper_') } : {}) },
    horizons,
    sloped: Boolean(arrays.shared),
    simulated:
      header.simulated && arrays.simulated_tails && arrays.simulated_lines
        ? simulation(header.simulated, arrays.simulated_tails, arrays.simulated_lines)
        : undefined,
    length: Math.ceil(horizons[K - 1] - 1e-9),
  };
}

/**
 * The same model of another gamma-space at the trained discounts; nothing of it is simulated, or decoded by the server.
 * @param {Model} model
 * @param {Float64Array} differences - (A, trained, bins)
 * @param {Float64Array} constant - the constant channel, (A, trained)
 * @returns {Model}
 */
export const remade = ({ header, arrays }, differences, constant) =>
  open(header, {
    ...arrays,
    differences: filled(header, arrays, differences),
    constant: filled(header, arrays, constant),
    simulated_tails: undefined,
    decoded: undefined,
    matrix: undefined,
  });

/**
 * What was simulated, line by line.
 * @param {{ action: number, count: number }} header
 * @param {Float64Array} tails - (N, width)
 * @param {Float64Array} lines - (5, N)
 * @returns {Simulation}
 */
function simulation({ action, count }, tails, lines) {
  const length = lines.length / 5,
    [reward, rewardError, survival, survivalError, chance] = Array.from({ length: 5 }, (_, i) =>
      lines.subarray(i * length, (i + 1) * length),
    );
  return {
    action,
    count,
    length,
    width: tails.length / length,
    tails,
    reward,
    rewardError,
    survival,
    survivalError,
    chance,
  };
}

/**
 * Values over the discounts in the components of a transform. `late` is what a decoder makes of them whose index was
 * raised before a row was stored: each discount goes through the row of the next one, and the last is lost.
 * @param {Pick<Grid, 'Ut' | 'r' | 'G'>} grid
 * @param {Float64Array[]} each - (G, width) an action
 * @param {number} width
 * @param {Float64Array[]} sums - the constant channel, (G,) an action
 * @returns {Components}
 */
export function projections({ Ut, r, G }, each, width, sums) {
  const under = (U) => ({
    projected: each.map((x) => product(U, x, r, G, width)),
    constants: sums.map((x) => product(U, x, r, G, 1)),
  });
  let late;
  return /** @type {Components} */ (
    Object.defineProperty(under(Ut), 'late', {
      get: () => (late ??= under(Ut.map((_, i) => (i % G === G - 1 ? 0 : Ut[i + 1])))),
    })
  );
}

// Columns of gamma-space (one a reward, or one a bin) in the components of the transform.
function channels(grid, values, A, width, constant) {
  const { G } = grid,
    each = Array.from({ length: A }, (_, a) => values.subarray(a * G * width, (a + 1) * G * width));
  const sums = (x) =>
    Float64Array.from({ length: G }, (_, g) => {
      let sum = 0;
      for (let v = 0; v < width; v++) sum += x[g * width + v];
      return sum;
    });
  const steps = each.map((x, a) => (constant ? constant.subarray(a * G, (a + 1) * G) : sums(x)));
  return Object.assign(projections(grid, each, width, steps), { width, values: each, steps });
}

/**
 * The row of the values that belongs to a horizon, or to the time that is left of it.
 * @param {Model} model
 * @param {number} horizon - in steps of the world
 * @returns {number} from 0 to K - 1
 */
export function rowAt(model, horizon) {
  return Math.min(model.K - 1, Math.max(0, Math.ceil((horizon - (1 + model.dt) / 2) / model.dt - 0.5)));
}
