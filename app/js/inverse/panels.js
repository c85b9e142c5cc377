// The pictures of the page of the inverse. Each draws itself with a pen; those with `drag` can be taken hold of.
/** @import { InverseModel, InversePanel, InverseTold, Range } from '../types.js' */
import { thetaTicks } from '../draw/columns.js';
import { actionColour, axes, heatmap, line, rounded, rowTicks, short, ticks } from '../draw/drawing.js';
import { disc, inside, top } from '../draw/frame.js';
import { averagingKernel, nearest } from './maths.js';

export const CURSOR = '#e8590c';
const TRUTH = '#7048e8',
  FINGER = 28; // pixels within which a finger takes hold of a handle

/**
 * Powers of ten in a range of logarithms, so many that their labels have room.
 * @param {Range} range
 * @param {number} width - in pixels
 * @returns {(number | string)[][]}
 */
function decades([low, high], width) {
  const every = Math.max(1, Math.ceil((high - low) / Math.max(2, width / 44))),
    first = Math.ceil(low / every - 1e-9) * every;
  return Array.from({ length: Math.max(0, Math.floor((high - first) / every + 1e-9) + 1) }, (_, i) => {
    const power = first + i * every;
    return [power, Math.abs(power) < 3 ? short(10 ** power) : `1e${power}`];
  });
}

const rangeOf = (values, margin = 0.04) => {
  const found = Array.from(values).filter(Number.isFinite),
    low = Math.min(...found),
    high = Math.max(...found),
    room = (high - low || 1) * margin;
  return [low - room, high + room];
};

// Ticks at whole steps.
const wholes = (last) => ticks(0, last, 5).filter(Number.isInteger);

// A line of names in their colours, as far as there is room.
function legend(pen, box, styles, colours) {
  let at = box.x;
  for (const [stroke, words] of styles) {
    const wide = pen.width(words, 11);
    if (at + 18 + wide > box.x + box.w - 4) return;
    pen.path(
      [
        [at, 11],
        [at + 14, 11],
      ],
      { stroke, width: 3 },
    );
    pen.text(words, at + 18, 15, { size: 11, colour: colours.text });
    at += 30 + wide;
  }
}

const upright = (pen, { box, X }, value, style) => {
  const x = X(value);
  if (x >= box.x - 1 && x <= box.x + box.w + 1)
    pen.path(
      [
        [x, box.y],
        [x, box.y + box.h],
      ],
      style,
    );
};

const clipped = (pen, { box }, draw) => pen.clip(box.x, box.y - 1, box.w, box.h + 2, draw);
/**
 * An alpha of the sweep, from its logarithm.
 * @param {number} logarithm
 * @param {InverseModel} model
 * @returns {number}
 */
const alphaOf = (logarithm, { arrays: { alphas }, header: { first } }) =>
  +Math.min(alphas[alphas.length - 1], Math.max(alphas[first], 10 ** logarithm)).toPrecision(4);

/**
 * The alphas that are drawn, as logarithms.
 * @param {InverseModel} model
 * @returns {Range}
 */
const alphaRange = ({ arrays: { alphas }, header: { first } }) => {
  const [low, high] = [Math.log10(alphas[first]), Math.log10(alphas[alphas.length - 1])];
  return high > low ? [low, high] : [low - 1, high + 1];
};

// The place of an alpha on the L-curve; that of an alpha beyond the sweep is at the edge.
function dotOf({ residual, size }, { X, Y, box }) {
  const within = (value, low, high) => Math.min(high, Math.max(low, value));
  return [within(X(Math.log10(residual)), box.x, box.x + box.w), within(Y(Math.log10(size)), box.y, box.y + box.h)];
}

/** @type {InversePanel} */
const lcurve = {
  name: 'lcurve',
  title: 'L-curve',
  why: [
    'Each alpha trades the misfit against the size of the timeline. At the bend, a little less misfit begins to cost much size. Drag the dot.',
    'horizontal |W(Fx − z)|, vertical |Lx|, both over all actions and sensitivities',
  ],
  note: ({ made }) => `misfit ${short(made.residual)}, size ${short(made.size)}`,
  draw(pen, w, h, { model, made, colours, images }) {
    const { residual, size } = model.arrays,
      xs = (images.misfits ??= residual.map(Math.log10).slice(model.header.first)),
      ys = (images.sizes ??= size.map(Math.log10).slice(model.header.first)),
      x = rangeOf(xs),
      y = rangeOf(ys),
      box = inside(w, h, { top: 8, left: 50 });
    const scale = axes(pen, box, {
      x,
      y,
      xTicks: decades(x, box.w),
      yTicks: decades(y, box.h * 1.6),
      xTitle: 'misfit',
      yTitle: 'size',
      colours,
    });
    line(pen, xs.map(scale.X), ys.map(scale.Y), { stroke: colours.primary, width: 2 });
    const [px, py] = dotOf(made, scale);
    pen.path(disc(px, py, 6), { fill: CURSOR, stroke: colours.paper, width: 1.5, close: true });
    return scale;
  },
  handle(scene, scale, px, py) {
    const [x, y] = dotOf(scene.made, scale);
    return Math.hypot(px - x, py - y) < FINGER;
  },
  drag({ model, images }, { X, Y }, px, py) {
    const alphas = model.arrays.alphas.slice(model.header.first),
      xs = images.misfits,
      ys = images.sizes;
    let best = Infinity,
      found = 0;
    for (let i = 0; i + 1 < Math.max(2, alphas.length); i++) {
      const next = Math.min(i + 1, alphas.length - 1),
        [x, y] = [X(xs[i]), Y(ys[i])],
        [dx, dy] = [X(xs[next]) - x, Y(ys[next]) - y];
      const share = Math.min(1, Math.max(0, ((px - x) * dx + (py - y) * dy) / (dx * dx + dy * dy || 1))),
        far = Math.hypot(px - x - share * dx, py - y - share * dy);
      if (far < best) [best, found] = [far, Math.log10(alphas[i]) + share * Math.log10(alphas[next] / alphas[i])];
    }
    return { alpha: alphaOf(found, model) };
  },
};

/** @type {InversePanel} */
const picard = {
  name: 'picard',
  title: 'Picard plot',
  why: [
    'Where the data no longer fall faster than the singular values, components hold noise: the ratio rises there.',
    's_i, |u_i·z| (root mean square over the columns), and |u_i·z| / s_i',
  ],
  note: ({ model, made }) => `${model.arrays.s.filter((s) => s >= made.alpha).length} of ${model.r} lie above alpha`,
  draw(pen, w, h, { model, made, colours }) {
    const { s, energy } = model.arrays,
      { free, columns } = model.header,
      data = energy.slice(free).map((e) => Math.sqrt(e / columns)),
      count = Array.from(s, (_, i) => i + 1 + free);
    const log = (values) => values.map((value) => Math.log10(value)),
      lines = [log(s), log(data), log(data.map((value, i) => value / s[i]))],
      y = rangeOf(lines.flatMap((each) => Array.from(each))),
      box = inside(w, h, { top: 22, left: 50 }),
      x = [0.5 + free, model.r + 0.5];
    const scale = axes(pen, box, {
      x,
      y,
      xTicks: ticks(x[0], x[1], Math.min(6, model.r)).filter(Number.isInteger),
      yTicks: decades(y, box.h * 1.6),
      xTitle: 'component',
      colours,
    });
    const styles = [
      [colours.text, 's'],
      [colours.primary, '|u·z|'],
      ['#c2255c', '|u·z| / s'],
    ];
    legend(pen, box, styles, colours);
    styles.forEach(([stroke], i) => {
      const xs = count.map(scale.X),
        ys = lines[i].map(scale.Y);
      if (i)
        ys.forEach(
          (value, k) => Number.isFinite(value) && pen.path(disc(xs[k], value, 2.2), { fill: stroke, close: true }),
        );
      line(pen, xs, ys, { stroke, width: i ? 1 : 2, dash: i === 2 ? [4, 3] : [] });
    });
    clipped(pen, scale, () => {
      const level = scale.Y(Math.log10(made.alpha));
      pen.path(
        [
          [box.x, level],
          [box.x + box.w, level],
        ],
        { stroke: CURSOR, width: 1.6, dash: [5, 3] },
      );
    });
    return scale;
  },
};

/** @type {InversePanel} */
const filters = {
  name: 'filters',
  title: 'Filter factors',
  why: [
    'The share of each component that alpha keeps: those to the right of alpha are kept, those to the left are damped.',
    'φ_i = s_i · kept_i, for Tikhonov s² / (s² + α²)',
  ],
  note: ({ made, model }) => `${short(made.degrees)} of ${model.G} degrees of freedom`,
  draw(pen, w, h, { model, made, colours }) {
    const { s } = model.arrays,
      { free } = model.header,
      x = alphaRange(model),
      box = inside(w, h, { top: 8, left: 48 });
    const scale = axes(pen, box, {
      x,
      y: [0, 1.06],
      xTicks: decades(x, box.w),
      yTicks: [0, 0.5, 1],
      xTitle: 'singular value s; alpha',
      yTitle: 'share kept',
      colours,
    });
    s.forEach((value, i) => {
      if (Math.log10(value) < x[0]) return;
      const share = 1 - made.lost[i + free],
        at = scale.X(Math.log10(value));
      pen.path(
        [
          [at, scale.Y(0)],
          [at, scale.Y(share)],
        ],
        { stroke: colours.primary, width: 1.4 },
      );
      pen.path(disc(at, scale.Y(share), 3), { fill: colours.primary, close: true });
    });
    upright(pen, scale, Math.log10(made.alpha), { stroke: CURSOR, width: 2 });
    return scale;
  },
  drag: ({ model }, { toX }, px) => ({ alpha: alphaOf(toX(px), model) }),
};

// A curve as it is drawn: in the logarithm where it spans decades.
function drawn(values, at, least) {
  const shown = Array.from(values).filter((_, i) => at[i] >= least),
    found = shown.filter(Number.isFinite),
    low = Math.min(...found),
    high = Math.max(...found);
  const curved = low > 0 && high > 30 * low ? Array.from(values, Math.log10) : Array.from(values),
    sorted = curved.filter((value, i) => Number.isFinite(value) && at[i] >= least).sort((a, b) => a - b);
  return { curve: curved, y: rangeOf([sorted[0], sorted[Math.floor(0.97 * (sorted.length - 1))]], 0.12) };
}

/**
 * A small picture of the curve that a rule minimises.
 * @param {string} rule
 * @param {number} place - among the rules; -1: the distance from the truth
 * @param {InverseTold['rules'][string]} words
 * @returns {InversePanel}
 */
const ruled = (rule, place, words) => ({
  name: `rule rule-${rule}`,
  title: words.title,
  why: [words.why, words.formula],
  note({ model }) {
    const { alphas, course_alphas: others, time_error: error } = model.arrays;
    return `α ${short(place < 0 ? others[bestOf(error)] : alphas[model.header.chosen[place]], 2)}`;
  },
  draw(pen, w, h, { model, made, told, colours, images }) {
    const { alphas, curves, course_alphas: others, time_error: error } = model.arrays,
      a = alphas.length,
      at = place < 0 ? others : alphas,
      chosen = place < 0 ? bestOf(error) : model.header.chosen[place];
    const { curve, y } = (images[rule] ??= drawn(
        place < 0 ? error : curves.subarray(place * a, (place + 1) * a),
        at,
        alphas[model.header.first],
      )),
      x = alphaRange(model),
      box = inside(w, h, { top: 6, left: 6, right: 6, bottom: 17 });
    const scale = axes(pen, box, { x, y, xTicks: decades(x, box.w), yTicks: [], colours }),
      used = told.rule === rule;
    clipped(pen, scale, () => {
      line(
        pen,
        Array.from(at, (alpha) => scale.X(Math.log10(alpha))),
        curve.map(scale.Y),
        {
          stroke: place < 0 ? TRUTH : colours.primary,
          width: used ? 2.6 : 1.6,
        },
      );
      upright(pen, scale, Math.log10(made.alpha), { stroke: CURSOR, width: 1.6 });
    });
    const px = scale.X(Math.log10(at[chosen])),
      py = Math.min(box.y + box.h - 2, Math.max(box.y + 2, scale.Y(curve[chosen])));
    pen.path(disc(px, py, 4), {
      fill: place < 0 ? TRUTH : colours.primary,
      stroke: colours.paper,
      width: 1.4,
      close: true,
    });
    return scale;
  },
  drag: ({ model }, { toX }, px) => ({ alpha: alphaOf(toX(px), model) }),
});

const bestOf = (error) => {
  let best = 0;
  error.forEach((value, i) => {
    if (value <= error[best]) best = i;
  });
  return best;
};

// Five steps, the closer together the nearer they are.
const stepsOf = ({ K }) => [...new Set([0, 1, 2, 3, 4].map((i) => Math.round((K - 1) ** (i / 4) - (i ? 0 : 1))))];

/** @type {InversePanel} */
const kernels = {
  name: 'kernels',
  title: 'Averaging kernels',
  why: [
    'The window of each marked step: a reward at any step under the bump appears at the marked step.',
    'rows of R = D F, at five steps',
  ],
  words: ({ model, made }) =>
    stepsOf(model)
      .map((k) => {
        const kernel = averagingKernel(model, made.kept, k),
          peak = kernel.indexOf(top(kernel));
        return `step ${short(k * model.dt)} is seen most at step ${short(peak * model.dt)}, weight ${short(kernel[peak])}`;
      })
      .join('; '),
  draw(pen, w, h, { model, made, colours }) {
    const { K, dt } = model,
      steps = stepsOf(model),
      all = steps.map((k) => averagingKernel(model, made.kept, k)),
      last = Math.max(1, (K - 1) * dt);
    const y = rounded(
        Math.min(0, ...all.map((each) => Math.min(...each))),
        Math.max(...all.map((each) => Math.max(...each))),
      ),
      box = inside(w, h, { top: 8, left: 48 }),
      log = K > 20,
      to = log ? (value) => Math.log1p(value) : Number,
      from = log ? Math.expm1 : Number;
    const scale = axes(pen, box, {
      x: [0, last],
      y,
      across: [to, from],
      xTicks: log ? [0, 1, 3, 10, 30, 100, 300, 1000].filter((tick) => tick <= last) : wholes(last),
      xTitle: 'future step τ',
      yTitle: 'weight',
      colours,
    });
    const xs = Array.from({ length: K }, (_, k) => scale.X(k * dt));
    all.forEach((each, i) => {
      const stroke = actionColour(i);
      line(pen, xs, each.map(scale.Y), { stroke, width: 1.7 });
      pen.path(
        [
          [xs[steps[i]], scale.Y(y[0])],
          [xs[steps[i]], scale.Y(y[0]) - 9],
        ],
        { stroke, width: 3 },
      );
    });
    return scale;
  },
};

// How many standard deviations a residual is off, as a colour.
const offColour = (off, colours) =>
  off === undefined ? colours.soft : off < 1 ? '#2b8a3e' : off < 2 ? '#e8a100' : off < 3 ? '#e8590c' : '#c2255c';

/** @type {InversePanel} */
const fit = {
  name: 'fit',
  title: 'Fit over the discounts',
  why: [
    'Dots: the values. Line: the values that the timeline implies. Green: within one standard deviation; red: beyond three.',
    '(1 − γ) Q against (1 − γ) Σ γ^τ E[r_τ]',
  ],
  note({ model, made }) {
    const { deviations } = model.arrays;
    if (!deviations) return '';
    const off = offBy(model, made),
      beyond = off.filter((value) => value > 2).length;
    return `${beyond} of ${model.G} off by over 2 deviations`;
  },
  words({ model, made }) {
    const misses = Array.from(model.means, (value, g) =>
      Math.abs((1 - model.arrays.gammas[g]) * (value - made.back[g])),
    );
    return `${fit.note?.(/** @type {any} */ ({ model, made })) || `${model.G} values`}; the largest misfit is ${short(top(misses))}`;
  },
  draw(pen, w, h, { model, made, state, colours }) {
    const { gammas, deviations } = model.arrays,
      share = (values) => Array.from(values, (value, g) => (1 - gammas[g]) * value),
      given = share(model.means),
      back = share(made.back),
      off = deviations && offBy(model, made);
    const time = state.axis === 'time',
      at = Array.from(gammas, (gamma) => (time ? Math.log10(-1 / Math.log(gamma)) : gamma)),
      x = rangeOf(at),
      box = inside(w, h, { top: 8, left: 50 });
    const scale = axes(pen, box, {
      x,
      y: rounded(Math.min(...given, ...back), Math.max(...given, ...back), 1e-6),
      xTicks: time ? decades(x, box.w) : undefined,
      xTitle: time ? 'time constant of γ (steps)' : 'discount γ',
      yTitle: '(1 − γ) value',
      colours,
    });
    const xs = at.map(scale.X);
    line(pen, xs, back.map(scale.Y), { stroke: actionColour(model.header.action), width: 2 });
    given.forEach((value, g) =>
      pen.path(disc(xs[g], scale.Y(value), 3.4), {
        fill: offColour(off?.[g], colours),
        stroke: colours.paper,
        close: true,
      }),
    );
    return scale;
  },
};

const offBy = ({ arrays, header, means }, { back }) =>
  Array.from(means, (value, g) => Math.abs(value - back[g]) / (header.gain * arrays.deviations[g]));

function space(pen, w, h, { model, colours, images }, name, values) {
  const { B, K, dt, bins } = model,
    canvas = (images[name] ??= document.createElement('canvas')),
    box = inside(w, h, { top: 8, left: 48, right: 8 });
  images.limit ??= top(model.arrays.truth ?? values.map(Math.abs)) || 1;
  heatmap(canvas, values, K, B, images.limit);
  const across = [(theta) => placed(bins.thetas, theta), (at) => at],
    x = [bins.thetas[bins.open ? 0 : 0], bins.thetas[B]];
  const scale = axes(pen, box, {
    x,
    y: [-0.5, K - 0.5],
    across,
    xTicks: thetaTicks(bins, x, box.w),
    yTicks: rowTicks(
      Float64Array.from({ length: K }, (_, k) => k * dt),
      [-0.5, K - 0.5],
    ),
    xTitle: 'sensitivity θ (reward)',
    yTitle: 'future step τ',
    colours,
    grid: false,
  });
  pen.image(canvas, box.x, box.y, box.w, box.h);
  return scale;
}

// The largest and the smallest probability of a space, and where they lie.
function extremes({ B, dt, bins }, values) {
  const at = (found) => {
    const i = values.indexOf(found);
    return `${short(found)} at step ${short(Math.floor(i / B) * dt)} and reward ${short(bins.thetas[i % B])}`;
  };
  const [low, high] = values.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [0, 0]);
  return `the largest probability is ${at(high)}${low < 0 ? `, the smallest ${at(low)}` : ''}`;
}

const first = (values) => Array.from(values.subarray(0, 4), (value) => short(value)).join(', ');

// Columns from the left, with fractions.
function placed(thetas, theta) {
  let h = 0;
  while (h < thetas.length - 2 && thetas[h + 1] <= theta) h++;
  return h + (theta - thetas[h]) / (thetas[h + 1] - thetas[h]);
}

/** @type {InversePanel} */
const tauSpace = {
  name: 'tau-space',
  title: 'Tau-space',
  why: [
    'The probability of each reward at each future step, as the solver decodes it at this alpha. Magenta is below 0.',
    'x = argmin |W(Fx − z)|² + α²|Lx|², or another filter of the same components',
  ],
  note: ({ made, model }) =>
    made.still ? `${model.header.solver}: at alpha ${short(model.header.decoded_at ?? 0)}, until release` : '',
  words: ({ model, made }) => `${model.K} future steps; ${extremes(model, made.tau)}`,
  draw: (pen, w, h, scene) => space(pen, w, h, scene, 'decoded', scene.made.tau),
};

/** @type {InversePanel} */
const truth = {
  name: 'truth',
  title: 'Truth',
  why: [
    'The true timeline of the world, which no solver sees, blurred by the activation like the values.',
    'P(r_τ = v, episode still running), in the bins of tau-space',
  ],
  words: ({ model }) => `${model.K} future steps; ${extremes(model, model.arrays.truth)}`,
  draw: (pen, w, h, scene) => space(pen, w, h, scene, 'true', scene.model.arrays.truth),
};

// The band that the server has drawn, if it is that of this alpha.
const bandAt = ({ band }, { alpha }) => (band && Math.abs(alpha / band.alpha - 1) < 1e-6 ? band : undefined);

/** @type {InversePanel} */
const rewards = {
  name: 'rewards',
  title: 'Expected reward',
  why: [
    'Dark band: two standard deviations of the noise. Pale band: the error of the solver is added.',
    'E[r_τ] ± (2 σ_τ + |bias_τ|)',
  ],
  note: ({ model, told, state }) =>
    model.arrays.deviations && !model.arrays.reference && !bandAt(told, state) ? 'band: after release' : '',
  words: ({ model: { arrays }, made }) =>
    `at the first steps ${first(made.rewards)}` + (arrays.true_rewards ? `, true ${first(arrays.true_rewards)}` : ''),
  draw(pen, w, h, { model, made, told, state, colours }) {
    const { K, dt, arrays } = model,
      { rewards: found } = made,
      { noise, bias } = made.noise ? made : (bandAt(told, state) ?? {}),
      true_ = arrays.true_rewards,
      box = inside(w, h, { top: true_ ? 22 : 8, left: 48 });
    const spread = (k) => (noise && bias ? 2 * noise[k] + Math.abs(bias[k]) : 0);
    const all = Array.from(found).flatMap((value, k) => [
        value - Math.min(spread(k), 1e3),
        value + Math.min(spread(k), 1e3),
      ]),
      y = rounded(Math.min(0, ...all, ...(true_ ?? [])), Math.max(0, ...all, ...(true_ ?? [])), 1e-6),
      last = Math.max(1, (K - 1) * dt);
    const scale = axes(pen, box, {
        x: [0, last],
        y,
        xTicks: wholes(last),
        xTitle: 'future step τ',
        yTitle: 'reward',
        colours,
      }),
      xs = Array.from({ length: K }, (_, k) => scale.X(k * dt)),
      colour = actionColour(model.header.action);
    const band = (width, fill) => {
      const up = xs.map((x, k) => [x, scale.Y(found[k] + width(k))]),
        down = xs.map((x, k) => [x, scale.Y(found[k] - width(k))]).reverse();
      pen.path([...up, ...down], { fill, close: true });
    };
    clipped(pen, scale, () => {
      if (noise && bias) {
        band(spread, `${colour}2e`);
        band((k) => 2 * noise[k], `${colour}52`);
      }
      if (true_) {
        line(pen, xs, true_.map(scale.Y), { stroke: TRUTH, width: 1.6, dash: [5, 3] });
      }
      line(pen, xs, found.map(scale.Y), { stroke: colour, width: 2.2 });
    });
    if (true_)
      legend(
        pen,
        box,
        [
          [colour, 'decoded'],
          [TRUTH, 'truth'],
        ],
        colours,
      );
    return scale;
  },
};

/** @type {InversePanel} */
const flips = {
  name: 'flips',
  title: 'Where the choice turns',
  why: [
    'The action that is chosen at each alpha and deadline, one colour for each action. Hatched: certain for every alpha.',
    'argmax_a V_T(a); certain: the smallest V_T of one action lies above the largest of every other',
  ],
  note({ model, state }) {
    const { course_alphas: alphas, choices } = model.arrays,
      row = rowOf(model, state.horizon);
    if (!choices) return '';
    const { solver, mapped } = model.header,
      whose = solver === mapped ? '' : `by ${mapped}: `;
    return `${whose}${model.header.actions[choices[nearest(alphas, state.alpha) * model.K + row]]} at T ${short(state.horizon)}`;
  },
  draw(pen, w, h, { model, state, told, colours, images }) {
    const { course_alphas: alphas, choices, true_choice: best } = model.arrays,
      { K, horizons, dt } = model,
      count = alphas.length,
      box = inside(w, h, { top: 22, left: 48, right: best ? 26 : 10 });
    const x = alphaRange(model),
      y = [horizons[0] - dt / 2, horizons[K - 1] + dt / 2];
    const scale = axes(pen, box, {
      x,
      y,
      xTicks: decades(x, box.w),
      yTicks: K < 8 ? Array.from(horizons) : undefined,
      xTitle: 'alpha',
      yTitle: 'deadline T',
      colours,
      grid: false,
    });
    const seen = (images.acted ??= [...new Set([...choices, ...(best ?? [])])].sort((a, b) => a - b));
    legend(
      pen,
      box,
      seen.map((a) => [actionColour(a), model.header.actions[a]]),
      colours,
    );
    images.flips ??= picture(choices, count, K);
    const [left, right] = [alphas[0], alphas[count - 1]].map((alpha) => scale.X(Math.log10(alpha)));
    clipped(pen, scale, () => pen.image(images.flips, left, box.y, right - left, box.h));
    if (best) {
      images.best ??= picture(best, 1, K);
      pen.image(images.best, box.x + box.w + 5, box.y, 9, box.h);
      pen.text('best', box.x + box.w + 10, 15, { size: 10, align: 'center', colour: colours.soft });
    }
    clipped(pen, scale, () => {
      for (const [low, high] of certain(told.certified ?? [])) {
        const [from, to] = [scale.Y(low), scale.Y(high)];
        for (let at = box.x - box.h; at < box.x + box.w; at += 7)
          pen.clip(box.x, to, box.w, from - to, () =>
            pen.path(
              [
                [at, box.y + box.h],
                [at + box.h, box.y],
              ],
              { stroke: colours.halo, width: 1.3 },
            ),
          );
      }
      const level = scale.Y(state.horizon);
      for (const style of [
        { stroke: '#000000', width: 3.4 },
        { stroke: '#ffffff', width: 1.6 },
      ]) {
        upright(pen, scale, Math.log10(state.alpha), style);
        pen.path(
          [
            [box.x, level],
            [box.x + box.w, level],
          ],
          style,
        );
      }
    });
    return scale;
  },
  handle: ({ state }, { X, Y }, px, py) =>
    Math.min(Math.abs(px - X(Math.log10(state.alpha))), Math.abs(py - Y(state.horizon))) < FINGER,
  drag({ model }, { toX, toY }, px, py) {
    const row = rowOf(model, toY(py));
    return { alpha: alphaOf(toX(px), model), horizon: model.horizons[row] };
  },
};

const rowOf = ({ horizons, K, dt }, horizon) => Math.min(K - 1, Math.max(0, Math.round((horizon - horizons[0]) / dt)));

function picture(choices, width, height) {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  for (let i = 0; i < width; i++)
    for (let k = 0; k < height; k++) {
      context.fillStyle = actionColour(choices[i * height + k]);
      context.fillRect(i, height - 1 - k, 1, 1);
    }
  return canvas;
}

// Ranges of T that are certain: between neighbouring horizons that are certain of the same action.
function certain(certified) {
  const found = [];
  certified.forEach(([T, action], i) => {
    if (action < 0) return;
    const next = certified[i + 1];
    found.push([T - 0.5, next && next[1] === action ? next[0] : T + 0.5]);
  });
  return found;
}

const DISTANCE = {
  title: 'Error (truth)',
  why: 'The distance of the timeline from the true one. It needs the truth, so no real agent can choose alpha by it.',
  formula: 'W1 over time, in steps for each unit of mass',
};

/**
 * The large pictures of a model, in their order, and the small ones of its rules.
 * @param {InverseModel} model
 * @param {InverseTold['rules']} rules
 * @returns {{ above: InversePanel[], curve: InversePanel, rules: InversePanel[], below: InversePanel[] }}
 */
export function panelsOf({ header, arrays }, rules) {
  return {
    above: [tauSpace, ...(arrays.truth ? [truth] : []), rewards],
    curve: lcurve,
    rules: [
      ...(arrays.time_error ? [ruled('error', -1, DISTANCE)] : []),
      ...header.rules.map((name, place) => ruled(name, place, rules[name])),
    ],
    below: [...(arrays.choices ? [flips] : []), picard, filters, kernels, fit],
  };
}
