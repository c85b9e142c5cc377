// Gamma-space and tau-space as maps.
/** @import { Panel, Range, Scene, Seen } from '../types.js' */
import { acrossOf, columnAt, placeOf, rewardWords, thetaOf, thetaTicks } from '../draw/columns.js';
import { NEUTRAL, axes, colourBar, heatmap, rowTicks, short } from '../draw/drawing.js';
import { inside, marked, titled, top } from '../draw/frame.js';
import { gammaSpace } from '../core/maths.js';
import { onScale, rewardRange, windowsOf } from '../core/reading.js';
import { leftOut } from '../core/network.js';
import { distancesOf, drawDistances, simulatedFor, simulatedRow, simulatedWords } from './simulated.js';

const TRUTH = { stroke: '#ffffff', width: 1.5 },
  HALO = { stroke: '#111111', width: 3.5 };

/**
 * Low and high end of the range of theta that is drawn.
 * @param {Seen} seen
 * @returns {Range} in reward
 */
export const thetaRange = ({ thetas }) => [thetas[0], thetas[thetas.length - 1]];

/**
 * What is drawn of theta before anybody zooms: where the rewards are, or all of it. Without a truth the range of the
 * rewards differs from step to step of an episode, and only ever grows.
 * @param {Scene} scene
 * @returns {Range} in reward
 */
export function drawnRange(scene) {
  const { model, seen, wide, reached } = scene;
  if (wide) return thetaRange(seen);
  const found = rewardRange(model, seen);
  if (model.truth) return found;
  const [low, high] = reached ?? found;
  return (scene.reached = [Math.min(low, found[0]), Math.max(high, found[1])]);
}

/**
 * The true row of an action, smeared by the activation; null where nothing is left. Few rewards share a row.
 * @param {Pick<Scene, 'model' | 'seen'>} scene
 * @param {number} a
 * @param {number} k
 * @returns {Float64Array | null} (H,)
 */
export function trueRow({ model, seen }, a, k) {
  if (!seen.truth) return simulatedRow(model, a, k);
  const { masses, H } = seen,
    chances = seen.truth.chances[a],
    V = model.arrays.rewards.length;
  let row = null;
  for (let v = 0; v < V; v++) {
    const chance = chances[k * V + v];
    if (chance < 1e-12) continue;
    row ??= new Float64Array(H);
    for (let h = 0; h < H; h++) row[h] += chance * masses[v * H + h];
  }
  return row;
}

/**
 * Tau-space as it is drawn: probabilities, on a scale on which a certain reward reads as 1 where the slope is known.
 * @param {Scene} scene
 * @returns {Float64Array} (n, H)
 */
export function drawnTau({ model, state, seen, images }) {
  if (images.drawnFor !== seen) {
    const windows = windowsOf(model, state, seen),
      values = onScale(seen.tau, seen.H, windows);
    Object.assign(images, {
      windows,
      drawn: model.dt === 1 ? values : values.map((value) => value / model.dt),
      drawnFor: seen,
    });
  }
  return images.drawn;
}

/**
 * The top of the colour scale: the truth's own peak, which knows the encoding, but not alpha or T.
 * @param {Scene} scene
 * @returns {number} a probability
 */
export const limitOfTau = (scene) => {
  const { model, seen, images } = scene,
    values = drawnTau(scene);
  if (!seen.truth) return top(values.map(Math.abs)) || 1;
  if (images.limitFor !== seen.masses) {
    let limit = 0;
    for (let a = 0; a < model.A; a++)
      for (let k = 0; k < model.K; k++) {
        const row = trueRow(scene, a, k);
        if (row) limit = Math.max(limit, top(onScale(row, seen.H, images.windows)));
      }
    Object.assign(images, { limitFor: seen.masses, limit: limit > 0.9 ? 1 : limit || 1 }); // between two bins: .97, say
  }
  return images.limit;
};

function drawSpace(pen, w, h, scene, { values, n, rows, limit, title, note, yTitle, labels, margin, image, version }) {
  const { seen, colours, images, zoom } = scene,
    box = inside(w, h, margin);
  if (images[`${image} of`] !== version) {
    heatmap((images[image] ??= document.createElement('canvas')), values, n, seen.H, limit);
    images[`${image} of`] = version;
  }
  titled(pen, w, title, note, scene);
  const x = zoom.theta ?? drawnRange(scene),
    y = zoom[image] ?? [-0.5, rows - 0.5];
  const scale = axes(pen, box, {
    x,
    y,
    across: [(theta) => acrossOf(seen, theta), (across) => thetaOf(seen, across)],
    xTicks: thetaTicks(seen, x, box.w),
    yTicks: rowTicks(labels, y),
    xTitle: 'sensitivity θ (reward)',
    yTitle,
    colours,
    grid: false,
  });
  pen.path(
    [
      [box.x, box.y],
      [box.x + box.w, box.y],
      [box.x + box.w, box.y + box.h],
      [box.x, box.y + box.h],
    ],
    { fill: colours.empty, close: true },
  );
  const [left, right] = thetaRange(seen).map(scale.X),
    upper = scale.Y(n - 0.5);
  pen.clip(box.x, box.y, box.w, box.h, () =>
    pen.image(images[image], left, upper, right - left, scale.Y(-0.5) - upper),
  );
  return scale;
}

/**
 * Whether a discount was added between trained ones.
 * @param {Pick<Scene, 'model'>} scene
 * @param {number} gamma - its index
 * @returns {boolean}
 */
export const isAdded = ({ model }, gamma) => Boolean(model.header.added && gamma % (model.header.added + 1));

// What interpolation misses at each trained discount that is left out; null where nothing is interpolated.
function missed({ model, seen, state, images }) {
  if (!model.header.added) return null;
  const Z = seen.columns.values[state.action];
  if (images.missedFor !== Z) Object.assign(images, { missedFor: Z, missed: leftOut(model, Z) });
  return images.missed;
}

/** @type {Panel} */
export const gammaPanel = {
  name: 'gamma-space',
  title: 'Gamma-space',
  why: [
    'The learned values: for each discount γ, how much future reward of each size θ is expected; nearer steps count more.',
    'Z(γ, θ) = Σ_τ γ^τ P(r_τ ≈ θ)',
  ],
  rows: 'gamma',
  draw(pen, w, h, scene) {
    const { seen, state, hover, colours, images } = scene;
    const version = JSON.stringify([
      state.slope,
      state.slope_share,
      state.action,
      state.noise && [state.noise, state.noise_seed],
      state.mixed,
      state.paper_grid,
      state.clip,
      scene.model.id,
    ]);
    if (images.gammaFor !== version) Object.assign(images, { Z: gammaSpace(seen, state), gammaFor: version });
    const { Z } = images,
      { gammas, G } = seen.grid,
      limit = top(Z) || 1;
    const margin = { right: 36 },
      found = missed(scene);
    const notes = [
      seen.soft && `soft ±${short(seen.soft.off, 2)}`,
      found && `dotted: interpolated ±${short(top(found), 2)}`,
    ];
    const scale = drawSpace(pen, w, h, scene, {
      values: Z,
      n: G,
      rows: G,
      limit,
      labels: gammas,
      title: 'Gamma-space',
      yTitle: 'discount γ',
      margin,
      image: 'gamma',
      version,
      note:
        hover.theta !== undefined && hover.gamma !== undefined
          ? `θ ${rewardWords(seen, hover.theta)} · γ ${short(gammas[hover.gamma])} · ` +
            short(Z[hover.gamma * seen.H + columnAt(seen, hover.theta)]) +
            (isAdded(scene, hover.gamma) ? ' interpolated' : '')
          : notes.filter(Boolean).join(' · ') || 'discounted steps',
    });
    pen.clip(scale.box.x - 5, scale.box.y, scale.box.w + 5, scale.box.h, () =>
      gammas.forEach((_, g) => {
        if (!isAdded(scene, g)) return;
        const { box, Y } = scale,
          y = Y(g),
          wide = Y(0) - Y(1) >= 5 ? box.w : 0; // of narrow rows only the ticks
        pen.path(
          [
            [box.x - 5, y],
            [box.x + wide, y],
          ],
          { stroke: NEUTRAL, dash: [1, 3] },
        );
      }),
    );
    colourBar(
      pen,
      (images.bar ??= document.createElement('canvas')),
      { x: w - 32, y: scale.box.y, w: 7, h: scale.box.h },
      limit,
      colours,
    );
    marked(pen, scale, { x: hover.theta, y: hover.gamma }, colours);
    return scale;
  },
  point: ({ seen }, x, y) => ({ theta: x, gamma: Math.min(seen.grid.G - 1, Math.max(0, Math.round(y))) }),
  words: (scene) => {
    const { model, state, seen, images } = scene,
      found = missed(scene),
      low = seen.thetas[seen.open ? 1 : 0],
      high = seen.thetas[seen.open ? seen.H - 1 : seen.H];
    return (
      `Gamma-space of ${model.header.actions[state.action]}: ${seen.grid.G} discounts from ` +
      `${short(seen.grid.gammas[0])} to ${short(seen.grid.gammas[seen.grid.G - 1])}, ` +
      `${seen.open ? seen.H - 1 : seen.H} sensitivities from ${short(low)} to ${short(high)}` +
      `${seen.open ? ' and what lies beyond them' : ''}; ` +
      `the largest entry is ${short(top(images.Z ?? []))} discounted steps.` +
      (found
        ? ` The dotted discounts are interpolated: where a trained one is left out, a probability is off ` +
          `by up to ${short(top(found), 2)}.`
        : '') +
      (seen.soft
        ? ` At ${short(state.slope_share)} of the trained slope, a probability is off by up to ` +
          `${short(seen.soft.off, 2)}.`
        : '')
    );
  },
};

// Boxes around the cells where the true probability rises above the foot of its row's peak; with many rows only sides.
function outline(scene) {
  const { model, seen, state, images } = scene,
    { masses, H, thetas } = seen,
    few = model.K <= 16,
    half = few ? 0.46 : 0.5;
  if (images.outlineFor === masses && images.outlineOf === state.action) return images.outline;
  const rows = Array.from({ length: model.K }, (_, k) => trueRow(scene, state.action, k)),
    peaks = rows.map((row) => top(row ?? []));
  const least = 1e-3 * top(peaks),
    found = [];
  rows.forEach((row, k) => {
    const foot = Math.max(0.02 * peaks[k], least),
      low = k - half,
      high = k + half;
    for (let h = 0; row && h < H; h++) {
      if (!(row[h] > foot)) continue;
      const left = thetas[h];
      while (h < H && row[h] > foot) h++;
      const right = thetas[h];
      found.push(
        ...(few
          ? [[left, low], [right, low], [right, high], [left, high], [left, low], null]
          : [[left, low], [left, high], null, [right, low], [right, high], null]),
      );
    }
  });
  Object.assign(images, { outline: found, outlineFor: masses, outlineOf: state.action });
  return found;
}

/** @type {Panel} */
export const tauPanel = {
  name: 'tau-space',
  title: 'Tau-space',
  why: [
    'The probability of each reward θ at each future step τ, decoded from gamma-space. A certain reward reads as 1; magenta is ' +
      'below 0.',
    'P = V diag(s / (s² + α²)) Uᵀ Z, with γ^τ = U diag(s) Vᵀ; summed over θ ± 2 / slope',
  ],
  rows: 'tau',
  draw(pen, w, h, scene) {
    const { model, seen, hover, colours, images, resolution } = scene,
      limit = limitOfTau(scene),
      values = drawnTau(scene),
      { K, dt } = model;
    const labels = Float64Array.from({ length: K }, (_, k) => k * dt),
      { theta, tau } = hover,
      cell = theta !== undefined && tau !== undefined && tau < seen.n;
    const simulated = simulatedFor(scene),
      far = simulated && cell ? distancesOf(scene)[tau * dt] : NaN,
      aside = simulated ? 42 : 0;
    const scale = drawSpace(pen, w, h, scene, {
      values,
      n: seen.n,
      rows: K,
      limit,
      labels,
      title: 'Tau-space',
      yTitle: 'future step τ',
      margin: { right: 84 + aside },
      image: 'tau',
      version: seen.tau,
      note: cell
        ? `θ ${rewardWords(seen, theta)} · τ ${short(tau * dt)} · P ` +
          short(values[tau * seen.H + columnAt(seen, theta)]) +
          (Number.isFinite(far) ? ` · W1 ${short(far)}` : '')
        : simulated
          ? `outlined: ${simulated.count} continuations`
          : scene.followed
            ? 'white: observed'
            : seen.truth
              ? 'probability; white boxes: the truth'
              : 'probability',
    });
    const { box, X, Y } = scale;
    if (seen.truth ? seen.masses : simulated) {
      const points = outline(scene).map((point) => point && [X(point[0]), Y(point[1])]);
      pen.clip(box.x - 2, box.y - 2, box.w + 4, box.h + 4, () => {
        pen.path(points, HALO);
        pen.path(points, K <= 16 ? TRUTH : { ...TRUTH, width: 1 });
      });
    }
    if (scene.followed && !simulated) {
      const found = scene.followed.rewards.slice(0, Math.ceil(K * dt)),
        size = found.length > 60 ? 1.6 : 2.6;
      pen.clip(box.x, box.y, box.w, box.h, () =>
        found.forEach((reward, k) => {
          const [x, y] = [X(placeOf(seen, reward)), Y(k / dt)];
          pen.path(
            [
              [x - size, y - size],
              [x + size, y - size],
              [x + size, y + size],
              [x - size, y + size],
            ],
            { fill: '#ffffff', stroke: '#111111', width: 0.8, close: true },
          );
        }),
      );
    }
    const deadline = Y(seen.readRow + 0.5),
      ruler = { x: box.x + box.w + 6 + aside, w: 38 };
    if (simulated) drawDistances(pen, scene, { ...box, x: box.x + box.w + 6, w: 32 }, Y);
    pen.clip(box.x, box.y - 1, box.w, box.h + 2, () => {
      pen.path(
        [
          [box.x, deadline],
          [box.x + box.w, deadline],
        ],
        { stroke: '#111', width: 3 },
      );
      pen.path(
        [
          [box.x, deadline],
          [box.x + box.w, deadline],
        ],
        { stroke: '#ff9f1c', width: 1.6, dash: [6, 4] },
      );
      pen.text('T', box.x + box.w - 4, deadline + (deadline < box.y + 14 ? 12 : -4), {
        size: 11,
        weight: 700,
        align: 'right',
        colour: '#ff9f1c',
      });
    });
    pen.clip(ruler.x - 2, box.y - 1, ruler.w + 4, box.h + 2, () => {
      // through which window the row under the cursor is seen
      const peak = top(resolution.kernel.map(Math.abs)) || 1,
        foot = ruler.x + 6;
      const at = Array.from(resolution.kernel, (value, k) => [foot + (28 * value) / peak, Y(k)]);
      pen.path([[foot, Y(0)], ...at, [foot, Y(K - 1)]], { fill: colours.wash, stroke: colours.primary, width: 1.2 });
      const low = Y(resolution.low / dt - 0.5),
        high = Y(resolution.high / dt + 0.5);
      pen.path(
        [
          [ruler.x + 3, low],
          [ruler.x, low],
          [ruler.x, high],
          [ruler.x + 3, high],
        ],
        { stroke: colours.text, width: 1.4 },
      );
    });
    pen.text(`window ±${short(resolution.half, 2)}`, ruler.x - 4, box.y + box.h + 27, {
      size: 10.5,
      colour: colours.text,
    });
    colourBar(
      pen,
      (images.bar ??= document.createElement('canvas')),
      { x: w - 32, y: box.y, w: 7, h: box.h },
      limit,
      colours,
    );
    marked(pen, scale, { x: hover.theta, y: hover.tau }, colours);
    return scale;
  },
  point: ({ model }, x, y) => ({ theta: x, tau: Math.min(model.K - 1, Math.max(0, Math.round(y))) }),
  words: ({ model, state, seen, resolution, at, images }) => {
    let mass = 0;
    for (let h = 0; h < seen.H; h++) mass += seen.tau[h] / model.dt;
    return (
      `Tau-space of ${model.header.actions[state.action]}: ${seen.n} future steps. Row 0 holds ` +
      `probability ${short(mass)} with mean reward ${short(seen.rewards[state.action][0] / model.dt)}. ` +
      `Step ${short(at * model.dt)} is seen through a window of plus or minus ` +
      `${short(resolution.half, 2)} steps.` +
      (seen.truth ? ' The truth is outlined in white.' : simulatedWords({ model, state, seen, images }))
    );
  },
};
