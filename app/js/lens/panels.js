// The pictures of the lens. Each draws itself with a pen into a box and says in words what it shows.
// `scene` is { model, state, seen, pinned, hover, colours, kernel, resolution, images }.
/** @import { Panel, Told } from '../types.js' */
import { NEUTRAL, actionColour, axes, line, rounded, short, ticks } from '../draw/drawing.js';
import { GHOST, disc, inside, markOf, marked, titled } from '../draw/frame.js';
import { shares } from '../core/filters.js';
import { gammaSpace } from '../core/maths.js';
import { bandsOf } from '../core/reading.js';
import { drawSimulated, simulatedFor } from './simulated.js';
import { gammaPanel, isAdded, tauPanel } from './spaces.js';
import { valuesPanel } from './values.js';
import { impossible } from './verdict.js';

/** @type {Panel} */
const spectrumPanel = {
  name: 'spectrum',
  title: 'Filter factors',
  why: [
    'The singular values of the transform. The bars are the share of each component that alpha keeps; the rest is ' +
      'removed as noise.',
    'f_i = s_i² / (s_i² + α²)',
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene,
      { s, r, free, U, V, G } = seen.grid,
      count = s.length,
      box = inside(w, h);
    const learned = (G - 1) / (model.header.added + 1) + 1; // what is interpolated adds none
    const factors = shares(seen.grid.filter, s, free, state.alpha)
        .lost.subarray(free)
        .map((lost) => 1 - lost),
      passing = factors.filter((f) => f > 0.5).length;
    titled(
      pen,
      w,
      'Filter factors',
      `${passing + free} of ${r} pass${learned < G ? `, ${learned} learned` : ''}`,
      scene,
    );
    const low = Math.floor(Math.log10(s[count - 1])) - 0.3,
      high = Math.max(0.6, Math.log10(s[0]) + 0.4),
      scale = axes(pen, box, {
        x: [0.4, count + 0.6],
        y: [low, high],
        xTitle: 'component; bars: share kept',
        yTitle: 'singular value',
        colours,
        xTicks: count <= 8 ? Array.from({ length: count }, (_, i) => i + 1) : undefined,
        yTicks: ticks(low, high, 6)
          .filter((tick) => Number.isInteger(tick))
          .map((tick) => [tick, tick ? `1e${tick}` : '1']),
      });
    const { X, Y } = scale,
      half = 0.36 * (X(2) - X(1)),
      floor = box.y + box.h;
    factors.forEach((factor, i) => {
      const x = X(i + 1),
        top = floor - factor * box.h;
      pen.path(
        [
          [x - half, floor],
          [x - half, top],
          [x + half, top],
          [x + half, floor],
        ],
        { fill: colours.wash, close: true },
      );
      pen.path(disc(x, Y(Math.log10(s[i])), 3.2), { fill: factor > 0.5 ? colours.primary : NEUTRAL, close: true });
    });
    const { gamma, tau } = hover;
    const weights =
      gamma !== undefined
        ? factors.map((_, i) => Math.abs(U[gamma * r + free + i]))
        : tau !== undefined
          ? factors.map((_, i) => Math.abs(V[tau * r + free + i]))
          : null;
    if (weights)
      line(
        pen,
        Array.from(weights, (_, i) => X(i + 1)),
        weights.map((value) => floor - value * box.h),
        { stroke: colours.mark, width: 1.4 },
      );
    const level = Math.log10(state.alpha);
    if (level > low && level < high) {
      pen.path(
        [
          [box.x, Y(level)],
          [box.x + box.w, Y(level)],
        ],
        { stroke: '#ff9f1c', width: 1.6, dash: [6, 4] },
      );
      pen.text('α', box.x + box.w - 3, Y(level) - 4, { size: 12, weight: 700, align: 'right', colour: '#ff9f1c' });
    }
    return scale;
  },
  point: () => ({}),
  words: ({ state, seen }) =>
    `Singular values of the transform: ${seen.grid.r} usable, the smallest ` +
    `${short(seen.grid.s[seen.grid.s.length - 1] / seen.grid.s[0])} of the largest. ` +
    `Alpha ${short(state.alpha)} lets ${seen.grid.s.filter((value) => value > state.alpha).length} of ` +
    `them through by more than half.`,
};

/** @type {Panel} */
const kernelPanel = {
  name: 'kernel',
  title: 'Effective discounting',
  why: [
    'Grey: the weight that each future step should have in the value. Line: the weight that it has at this ' + 'alpha.',
    'w(τ) = Σ_γ c_γ γ^τ against γ^τ [τ < T]',
  ],
  draw(pen, w, h, scene) {
    const { model, seen, hover, colours, kernel } = scene,
      { K, dt } = model,
      box = inside(w, h);
    const low = Math.min(0, ...kernel.actual),
      high = Math.max(1, ...kernel.actual);
    titled(
      pen,
      w,
      'Effective discounting',
      `noise gain ${short(kernel.gain)}${scene.state.normalise === 'none' ? '' : ', before rescaling'}`,
      scene,
    );
    const scale = axes(pen, box, {
      x: [-0.5 * dt, (K - 0.5) * dt],
      y: rounded(low, high, 1e-3),
      xTitle: 'future step τ',
      yTitle: 'weight',
      colours,
      xTicks: K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : undefined,
    });
    const { X, Y } = scale,
      xs = Array.from({ length: K }, (_, k) => X(k * dt)),
      steps = [];
    kernel.wanted.forEach((value, k) => steps.push([X((k - 0.5) * dt), Y(value)], [X((k + 0.5) * dt), Y(value)]));
    pen.path([[steps[0][0], Y(0)], ...steps, [steps[steps.length - 1][0], Y(0)]], {
      fill: 'rgba(138,143,152,0.22)',
      stroke: NEUTRAL,
      width: 1,
      close: true,
    });
    const gamma = hover.gamma === undefined ? undefined : seen.grid.gammas[hover.gamma];
    if (gamma !== undefined)
      line(
        pen,
        xs,
        xs.map((_, k) => Y(gamma ** (k * dt))),
        { stroke: colours.mark, width: 1.2, dash: [3, 3] },
      );
    line(pen, xs, kernel.actual.map(Y), { stroke: colours.primary, width: 2.2 });
    if (K <= 40)
      kernel.actual.forEach((value, k) => pen.path(disc(xs[k], Y(value), 2.6), { fill: colours.primary, close: true }));
    if (hover.tau !== undefined) marked(pen, scale, { x: hover.tau * dt }, colours);
    return scale;
  },
  point: ({ model }, x) => ({ tau: Math.min(model.K - 1, Math.max(0, Math.round(x / model.dt))) }),
  words: ({ model, seen, kernel }) => {
    let off = 0,
      all = 0;
    kernel.actual.forEach((value, k) => {
      off += Math.abs(value - kernel.wanted[k]);
      all += Math.abs(kernel.wanted[k]);
    });
    return (
      `Discount kernel for T = ${short(model.horizons[seen.readRow])}: it misses the wanted weights by ` +
      `${short((100 * off) / (all || 1), 2)} percent of their sum; noise gain ${short(kernel.gain)}.`
    );
  },
};

const CAME = 'rgba(138,143,152,0.55)';
const cameNote = ({ model, state }, followed) =>
  followed.action === state.action ? 'grey: observed' : `grey: observed after ${model.header.actions[followed.action]}`;

/** @type {Panel} */
const rewardsPanel = {
  name: 'rewards',
  title: 'Expected reward and survival',
  why: [
    'Above: the reward expected at each future step. Below: the probability that the episode still runs. With noise, ' +
      'the dark band is two standard deviations and the pale one adds the error of smoothing.',
    'E[r_τ] = Σ_θ θ P(τ, θ) ± (2 σ_τ + |bias_τ|)',
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene,
      { K, dt } = model,
      a = state.action,
      box = inside(w, h);
    const upper = { ...box, h: box.h * 0.62 },
      lower = { ...box, y: box.y + box.h * 0.74, h: box.h * 0.26 };
    const rewards = Array.from(seen.rewards[a], (value) => value / dt),
      true_ = seen.truth?.steps.rewards[a];
    const ghost = scene.pinned && Array.from(scene.pinned.rewards[a], (value) => value / dt);
    const followed = simulatedFor(scene) ? null : scene.followed,
      came = followed ? followed.rewards.slice(0, Math.ceil(K * dt)) : [];
    const simulated = simulatedFor(scene),
      edges = (side) => simulated?.reward.map((value, k) => value + side * simulated.rewardError[k]) ?? [];
    const bands = bandsOf(model, state, seen),
      spread = (k) => (bands ? (2 * bands.noise[k] + Math.abs(bands.bias?.[k] ?? 0)) / dt : 0),
      least = Math.max(...[...rewards, ...(true_ ?? [])].map(Math.abs)), // a band may be far wider than what it is of
      banded = bands
        ? rewards.flatMap((value, k) => [-1, 1].map((side) => value + side * Math.min(spread(k), least)))
        : [];
    const all = [0, ...rewards, ...(true_ ?? []), ...(ghost ?? []), ...came, ...banded, ...edges(2), ...edges(-2)];
    const low = Math.min(...all),
      high = Math.max(...all),
      x = [-0.5 * dt, (K - 0.5) * dt];
    titled(
      pen,
      w,
      'Expected reward and survival',
      hover.tau !== undefined && hover.tau < seen.n
        ? `τ ${short(hover.tau * dt)}: ${short(rewards[hover.tau])}, alive ${short(seen.survival[a][hover.tau] / dt)}`
        : impossible([seen.survival[a]], dt)
          ? 'survival above 1: impossible'
          : seen.truth
            ? 'grey: true'
            : simulated
              ? 'red: simulated, ± 2 errors'
              : followed
                ? cameNote(scene, followed)
                : '',
      scene,
    );
    const span = 1e-3 * (seen.thetas[seen.H] - seen.thetas[0]),
      scale = axes(pen, upper, { x, y: rounded(low, high, span), xTicks: [], yTitle: 'E[r] (reward)', colours });
    const few = K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : undefined;
    const alive = axes(pen, lower, {
      x,
      y: [-0.25, 1.35],
      yTicks: [0, 1],
      xTicks: few,
      xTitle: 'future step τ',
      yTitle: 'alive',
      colours,
    });
    const xs = Array.from({ length: K }, (_, k) => scale.X(k * dt)),
      { Y } = scale;
    pen.clip(upper.x, upper.y - 2, upper.w, upper.h + 4, () => {
      const bar = Math.max(0.8, 0.4 * (scale.X(dt) - scale.X(0)));
      true_?.forEach((value, n) => {
        const x = scale.X(n);
        if (value)
          pen.path(
            [
              [x - bar, Y(0)],
              [x - bar, Y(value)],
              [x + bar, Y(value)],
              [x + bar, Y(0)],
            ],
            { fill: 'rgba(138,143,152,0.45)', close: true },
          );
      });
      came.forEach((value, k) =>
        pen.path(
          [
            [scale.X(k - 0.35), Y(0)],
            [scale.X(k - 0.35), Y(value)],
            [scale.X(k + 0.35), Y(value)],
            [scale.X(k + 0.35), Y(0)],
          ],
          { fill: CAME, close: true },
        ),
      );
      const band = (width, fill) => {
        const edge = (side) =>
          rewards.slice(0, bands?.noise.length).map((value, k) => [xs[k], Y(value + side * width(k))]);
        pen.path([...edge(1), ...edge(-1).reverse()], { fill, close: true });
      };
      if (bands) {
        band(spread, `${actionColour(a)}2e`);
        band((k) => (2 * bands.noise[k]) / dt, `${actionColour(a)}52`);
      }
      if (ghost) line(pen, xs, ghost.map(Y), { ...GHOST, stroke: actionColour(a) });
      if (simulated) drawSimulated(pen, simulated.reward, simulated.rewardError, scale);
      line(pen, xs, rewards.map(Y), { stroke: actionColour(a), width: 2.2 });
      if (K <= 40)
        rewards.forEach((value, k) =>
          pen.path(markOf(a, xs[k], Y(value), 2.8), { fill: actionColour(a), close: true }),
        );
    });
    pen.clip(lower.x, lower.y, lower.w, lower.h, () => {
      const known = seen.truth?.steps.survival[a];
      if (known)
        line(
          pen,
          Array.from(known, (_, n) => alive.X(n)),
          known.map((value) => alive.Y(value)),
          { stroke: NEUTRAL, width: 5 },
        );
      if (followed) {
        // 1 until it was over; what is not known is not drawn
        const end = followed.over ?? came.length;
        pen.path(
          [
            [alive.X(-0.5), alive.Y(1)],
            [alive.X(end - 0.5), alive.Y(1)],
            ...(followed.over === null
              ? []
              : [
                  [alive.X(end - 0.5), alive.Y(0)],
                  [alive.X(K * dt), alive.Y(0)],
                ]),
          ],
          { stroke: NEUTRAL, width: 4 },
        );
      }
      if (simulated) drawSimulated(pen, simulated.survival, simulated.survivalError, alive);
      line(
        pen,
        xs,
        seen.survival[a].map((value) => alive.Y(value / dt)),
        { stroke: colours.text, width: 1.6 },
      );
    });
    for (const each of [scale, alive]) if (hover.tau !== undefined) marked(pen, each, { x: hover.tau * dt }, colours);
    return { ...scale, box };
  },
  point: kernelPanel.point,
  words: ({ model, state, seen }) => {
    const a = state.action,
      tell = (x, dt = model.dt) => Array.from(x.slice(0, 4), (value) => short(value / dt)).join(', ');
    const true_ = seen.truth?.steps,
      at = model.dt < 1 ? 'at the first rows' : 'at the first steps';
    return (
      `Expected reward of ${model.header.actions[a]} ${at}: decoded ` +
      `${tell(seen.rewards[a])}${true_ ? `, true at the first steps ${tell(true_.rewards[a], 1)}` : ''}. ` +
      `Survival: decoded ${tell(seen.survival[a])}${true_ ? `, true ${tell(true_.survival[a], 1)}` : ''}.`
    );
  },
};

/**
 * Whether the decoded timeline explains the gamma-space that it came from: (1 - gamma) times the value at each
 * discount.
 * @type {Panel}
 */
const fitPanel = {
  name: 'fit',
  title: 'Fit to gamma-space',
  why: [
    'Circles: the value at each discount. Line: the value that the decoded timeline implies. ' +
      'Where they differ, alpha smooths too much.',
    '(1 − γ) Q(γ) against (1 − γ) Σ_τ γ^τ E[r_τ]',
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene,
      { gammas, G } = seen.grid,
      { given, back } = fitOf(scene),
      box = inside(w, h);
    const times = gammas.map((gamma) => Math.log10(-1 / Math.log(gamma))),
      all = [0, ...given, ...back];
    titled(
      pen,
      w,
      'Fit to gamma-space',
      hover.gamma === undefined
        ? 'value a step at each discount'
        : `γ ${short(gammas[hover.gamma])}: ${short(given[hover.gamma])}, from tau-space ${short(back[hover.gamma])}`,
      scene,
    );
    const margin = 0.04 * (times[G - 1] - times[0]) || 0.5,
      x = [times[0] - margin, times[G - 1] + margin];
    const scale = axes(pen, box, {
      x,
      y: rounded(Math.min(...all), Math.max(...all), 1e-6),
      xTitle: 'time constant of γ (steps)',
      yTitle: '(1 − γ) value (reward)',
      colours,
      xTicks: ticks(x[0], x[1], 4)
        .filter((tick) => Number.isInteger(tick))
        .map((tick) => [tick, short(10 ** tick)]),
    });
    const xs = Array.from(times, scale.X);
    given.forEach((value, g) =>
      pen.path(disc(xs[g], scale.Y(value), G > 40 && isAdded(scene, g) ? 1.8 : 3.4), {
        stroke: colours.soft,
        width: 1.6,
        close: true,
        fill: model.header.added && !isAdded(scene, g) ? colours.soft : undefined,
      }),
    );
    line(pen, xs, back.map(scale.Y), { stroke: actionColour(state.action), width: 2.2 });
    if (hover.gamma !== undefined) marked(pen, scale, { x: times[hover.gamma] }, colours);
    return { ...scale, times };
  },
  point: ({ seen }, x) => ({
    gamma: seen.grid.gammas.reduce((best, gamma, g, all) => {
      const far = (other) => Math.abs(Math.log10(-1 / Math.log(all[other])) - x);
      return far(g) < far(best) ? g : best;
    }, 0),
  }),
  words: (scene) => {
    const { given, back } = fitOf(scene),
      off = Math.max(...given.map((value, g) => Math.abs(value - back[g])));
    return (
      `Value of ${scene.model.header.actions[scene.state.action]} at ${given.length} discounts, as learned ` +
      `and as tau-space gives it back: they differ by at most ${short(off)} a step.`
    );
  },
};

function fitOf({ state, seen, images, model }) {
  if (images.fitFor === seen) return images.fit;
  const { gammas, G } = seen.grid,
    Z = gammaSpace(seen, state),
    given = new Float64Array(G),
    back = new Float64Array(G);
  for (let g = 0; g < G; g++) {
    for (let h = 0; h < seen.H; h++) given[g] += Z[g * seen.H + h] * seen.midpoints[h] * (1 - gammas[g]);
    seen.rewards[state.action].forEach((reward, k) => {
      back[g] += (1 - gammas[g]) * gammas[g] ** (k * model.dt) * reward;
    });
  }
  Object.assign(images, { fitFor: seen, fit: { given, back } });
  return images.fit;
}

/**
 * The pictures in their order. Without a world to draw, its place shows how well the inverse fits the learned values.
 * @param {Pick<Told, 'world' | 'still'>} told
 * @returns {Panel[]}
 */
export const panelsOf = ({ world, still }) => [
  ...(world || still ? [] : [fitPanel]),
  gammaPanel,
  tauPanel,
  valuesPanel,
  rewardsPanel,
  kernelPanel,
  spectrumPanel,
];

/** Panels that explain the others: they are shown on demand. */
export const EXPLAINING = [kernelPanel, spectrumPanel];
