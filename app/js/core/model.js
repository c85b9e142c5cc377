// A payload as a model: what Python sent, in the components of its transforms.
import { product, transposed } from './algebra.js';
import { filled } from './network.js';

export function read(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset),
    length = view.getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))),
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
  return { ...open(header, arrays), bytes };
}

function open(header, arrays) {
  const A = header.actions.length,
    K = header.steps,
    dt = header.time_step,
    H = arrays.thetas.length;
  const grid = (name) => {
    const G = arrays[`${name}gammas`].length,
      r = arrays[`${name}s`].length;
    const U = arrays[`${name}U`],
      found = {
        name,
        G,
        r,
        K,
        U,
        gammas: arrays[`${name}gammas`],
        s: arrays[`${name}s`],
        V: arrays[`${name}V`],
        Ut: transposed(U, G, r),
        columns: {},
      };
    for (const kind of ['shared', 'per_gamma']) {
      const W = arrays[name + kind];
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
  const model = {
    header,
    A,
    K,
    dt,
    H,
    truth: Boolean(arrays.timeline),
    arrays,
    cache: {},
    grids: { own: grid(''), ...(arrays.paper_gammas ? { paper: grid('paper_') } : {}) },
  };
  model.horizons = Float64Array.from({ length: K }, (_, k) => k * dt + (1 + dt) / 2);
  model.sloped = Boolean(arrays.shared);
  model.simulated = header.simulated && arrays.simulated_tails && simulation(header.simulated, arrays);
  model.length = Math.ceil(model.horizons[K - 1] - 1e-9);
  return model;
}

// The same model of another gamma-space at the trained discounts, of which nothing is simulated: differences
// (A, G, bins) and constant channel (A, G).
export const remade = ({ header, arrays }, differences, constant) =>
  open(header, {
    ...arrays,
    differences: filled(header, arrays, differences),
    constant: filled(header, arrays, constant),
    simulated_tails: undefined,
  });

function simulation({ action, count }, { simulated_tails: tails, simulated_lines: lines }) {
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

// Components of values over the discounts, (r, width) a time. `late` is what a decoder makes of them whose index was
// raised before a row was stored: each discount goes through the row of the next one, and the last is lost.
export function projections({ Ut, r, G }, each, width, sums) {
  const under = (U) => ({
    projected: each.map((x) => product(U, x, r, G, width)),
    constants: sums.map((x) => product(U, x, r, G, 1)),
  });
  let late;
  return Object.defineProperty(under(Ut), 'late', {
    get: () => (late ??= under(Ut.map((_, i) => (i % G === G - 1 ? 0 : Ut[i + 1])))),
  });
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
  return Object.assign(projections(grid, each, width, steps), { width, values: each });
}

// Which row of the values belongs to a horizon, or to the time that is left of it.
export function rowAt(model, horizon) {
  return Math.min(model.K - 1, Math.max(0, Math.ceil((horizon - (1 + model.dt) / 2) / model.dt - 0.5)));
}
