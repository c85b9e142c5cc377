// The pictures of the lens. Each draws itself with a pen into a box and says in words what it shows.
// `scene` is { model, state, seen, pinned, hover, colours, kernel, resolution, images }.
import { acrossOf, columnAt, thetaOf, thetaTicks } from './columns.js';
import { NEUTRAL, actionColour, axes, colourBar, heatmap, line, rounded, rowTicks, short, ticks } from './drawing.js';
import { gammaSpace } from './maths.js';
import { leftOut } from './network.js';
import { distancesOf, drawDistances, drawSimulated, simulatedFor, simulatedRow, simulatedWords } from './simulated.js';

const GHOST = { width: 1.2, dash: [7, 3] }; // the view pinned as A
const TRUTH = { stroke: '#ffffff', width: 1.5 }, HALO = { stroke: '#111111', width: 3.5 };
const inside = (w, h, { left = 46, right = 10, top = 28, bottom = 34 } = {}) =>
  ({ x: left, y: top, w: w - left - right, h: h - top - bottom });

function titled(pen, w, words, note, { colours }) {
  pen.text(words, 2, 15, { size: 14, weight: 600, colour: colours.text });
  if (note && pen.width(words, 14, 600) + pen.width(note, 11) + 14 < w) pen.text(note, w - 4, 15,
    { size: 11, align: 'right', colour: colours.soft });
}

function marked(pen, { box, X, Y }, { x, y }, colours) { // where the other panels point to
  const lines = [];
  if (X(x) >= box.x && X(x) <= box.x + box.w) lines.push([[X(x), box.y], [X(x), box.y + box.h]]);
  if (Y(y) >= box.y && Y(y) <= box.y + box.h) lines.push([[box.x, Y(y)], [box.x + box.w, Y(y)]]);
  for (const each of lines) {
    pen.path(each, { stroke: colours.halo, width: 3 });
    pen.path(each, { stroke: colours.mark, width: 1.2 });
  }
}

// ---- the two spaces

export const thetaRange = ({ thetas }) => [thetas[0], thetas[thetas.length - 1]];

// True rows of an action, smeared by the activation, (H,) each; null where nothing is left. Few rewards share a row.
export function trueRow({ model, seen }, a, k) {
  if (!seen.truth) return simulatedRow(model, a, k);
  const { masses, H } = seen, chances = seen.truth.chances[a], V = model.arrays.rewards.length;
  let row = null;
  for (let v = 0; v < V; v++) {
    const chance = chances[k * V + v];
    if (chance < 1e-12) continue;
    row ??= new Float64Array(H);
    for (let h = 0; h < H; h++) row[h] += chance * masses[v * H + h];
  }
  return row;
}

const top = (values) => values.reduce((a, b) => Math.max(a, b), 0);

// Top of the colour scale: the truth's own peak, which knows the encoding, but not alpha or T.
export const limitOfTau = (scene) => {
  const { model, seen, images } = scene;
  if (!seen.truth) return top(seen.tau.map(Math.abs)) / model.dt || 1;
  if (images.limitFor !== seen.masses) {
    let limit = 0;
    for (let a = 0; a < model.A; a++) for (let k = 0; k < model.K; k++) limit = Math.max(limit, top(trueRow(scene, a, k) ?? []));
    Object.assign(images, { limitFor: seen.masses, limit: limit / model.dt || 1 });
  }
  return images.limit;
};

function drawSpace(pen, w, h, scene, { values, n, rows, limit, title, note, yTitle, labels, margin, image, version }) {
  const { seen, colours, images, zoom } = scene, box = inside(w, h, margin);
  if (images[`${image} of`] !== version) {
    heatmap(images[image] ??= document.createElement('canvas'), values, n, seen.H, limit);
    images[`${image} of`] = version;
  }
  titled(pen, w, title, note, scene);
  const x = zoom.theta ?? thetaRange(seen), y = zoom[image] ?? [-0.5, rows - 0.5];
  const scale = axes(pen, box, { x, y, across: [(theta) => acrossOf(seen, theta), (across) => thetaOf(seen, across)],
    xTicks: thetaTicks(seen, x, box.w), yTicks: rowTicks(labels, y),
    xTitle: 'sensitivity θ (reward)', yTitle, colours, grid: false });
  pen.path([[box.x, box.y], [box.x + box.w, box.y], [box.x + box.w, box.y + box.h], [box.x, box.y + box.h]],
    { fill: colours.empty, close: true });
  const [left, right] = thetaRange(seen).map(scale.X), upper = scale.Y(n - 0.5);
  pen.clip(box.x, box.y, box.w, box.h, () => pen.image(images[image], left, upper, right - left, scale.Y(-0.5) - upper));
  return scale;
}

const isAdded = ({ model }, gamma) => Boolean(model.header.added && gamma % (model.header.added + 1));

// What interpolation misses at each trained discount that is left out; null where nothing is interpolated.
function missed({ model, seen, state, images }) {
  if (!model.header.added) return null;
  const Z = seen.columns.values[state.action];
  if (images.missedFor !== Z) Object.assign(images, { missedFor: Z, missed: leftOut(model, Z) });
  return images.missed;
}

export const gammaPanel = {
  name: 'gamma-space',
  rows: 'gamma',
  draw(pen, w, h, scene) {
    const { seen, state, hover, colours, images } = scene;
    const version = JSON.stringify([state.slope, state.slope_share, state.action, state.noise && [state.noise, state.noise_seed], state.mixed,
      state.paper_grid, state.clip, scene.model.id]);
    if (images.gammaFor !== version) Object.assign(images, { Z: gammaSpace(seen, state), gammaFor: version });
    const { Z } = images, { gammas, G } = seen.grid, limit = top(Z) || 1;
    const margin = { right: 36 }, found = missed(scene);
    const notes = [seen.soft && `soft ±${short(seen.soft.off, 2)}`, found && `dotted: interpolated ±${short(top(found), 2)}`];
    const scale = drawSpace(pen, w, h, scene, { values: Z, n: G, rows: G, limit, labels: gammas, title: 'gamma-space',
      yTitle: 'discount γ', margin, image: 'gamma', version,
      note: hover.theta !== undefined && hover.gamma !== undefined
        ? `θ ${short(hover.theta)} · γ ${short(gammas[hover.gamma])} · ${short(Z[hover.gamma * seen.H + columnAt(seen, hover.theta)])}${isAdded(scene, hover.gamma) ? ' interpolated' : ''}`
        : notes.filter(Boolean).join(' · ') || 'discounted steps' });
    pen.clip(scale.box.x - 5, scale.box.y, scale.box.w + 5, scale.box.h, () => gammas.forEach((_, g) => {
      if (!isAdded(scene, g)) return;
      const { box, Y } = scale, y = Y(g), wide = Y(0) - Y(1) >= 5 ? box.w : 0; // of narrow rows only the ticks
      pen.path([[box.x - 5, y], [box.x + wide, y]], { stroke: NEUTRAL, dash: [1, 3] });
    }));
    colourBar(pen, images.bar ??= document.createElement('canvas'), { x: w - 32, y: scale.box.y, w: 7, h: scale.box.h }, limit,
      colours);
    marked(pen, scale, { x: hover.theta, y: hover.gamma }, colours);
    return scale;
  },
  point: ({ seen }, x, y) => ({ theta: x, gamma: Math.min(seen.grid.G - 1, Math.max(0, Math.round(y))) }),
  words: (scene) => {
    const { model, state, seen, images } = scene, found = missed(scene);
    return `Gamma-space of ${model.header.actions[state.action]}: ${seen.grid.G} discounts from ${short(seen.grid.gammas[0])} to ${short(seen.grid.gammas[seen.grid.G - 1])}, `
    + `${seen.H} sensitivities from ${short(seen.thetas[0])} to ${short(seen.thetas[seen.H])}; the largest entry is ${short(top(images.Z ?? []))} discounted steps.`
      + (found ? ` The dotted discounts are interpolated: where a trained one is left out, a probability is off by up to ${short(top(found), 2)}.` : '')
      + (seen.soft ? ` At ${short(state.slope_share)} of the trained slope, a probability is off by up to ${short(seen.soft.off, 2)}.` : '');
  },
};

// Boxes around the cells where the true probability rises above the foot of its row's peak; with many rows only sides.
function outline(scene) {
  const { model, seen, state, images } = scene, { masses, H, thetas } = seen, few = model.K <= 16, half = few ? 0.46 : 0.5;
  if (images.outlineFor === masses && images.outlineOf === state.action) return images.outline;
  const rows = Array.from({ length: model.K }, (_, k) => trueRow(scene, state.action, k)),
    peaks = rows.map((row) => top(row ?? []));
  const least = 1e-3 * top(peaks), found = [];
  rows.forEach((row, k) => {
    const foot = Math.max(0.02 * peaks[k], least), low = k - half, high = k + half;
    for (let h = 0; row && h < H; h++) {
      if (!(row[h] > foot)) continue;
      const left = thetas[h];
      while (h < H && row[h] > foot) h++;
      const right = thetas[h];
      found.push(...(few ? [[left, low], [right, low], [right, high], [left, high], [left, low], null]
        : [[left, low], [left, high], null, [right, low], [right, high], null]));
    }
  });
  Object.assign(images, { outline: found, outlineFor: masses, outlineOf: state.action });
  return found;
}

export const tauPanel = {
  name: 'tau-space',
  rows: 'tau',
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours, images, resolution } = scene, limit = limitOfTau(scene);
    const values = model.dt === 1 ? seen.tau : seen.tau.map((value) => value / model.dt), { K, dt } = model;
    const labels = Float64Array.from({ length: K }, (_, k) => k * dt), cell = hover.theta !== undefined && hover.tau < seen.n;
    const simulated = simulatedFor(scene), far = simulated && cell ? distancesOf(scene)[hover.tau * dt] : NaN, aside = simulated ? 42 : 0;
    const scale = drawSpace(pen, w, h, scene, { values, n: seen.n, rows: K, limit, labels, title: 'tau-space',
      yTitle: 'future step τ', margin: { right: 84 + aside }, image: 'tau', version: seen.tau,
      note: cell && hover.tau !== undefined
        ? `θ ${short(hover.theta)} · τ ${short(hover.tau * dt)} · p ${short(seen.tau[hover.tau * seen.H + columnAt(seen, hover.theta)] / dt)}${Number.isFinite(far) ? ` · W1 ${short(far)}` : ''}`
        : simulated ? `outlined: ${simulated.count} continuations` : scene.followed ? 'white: what came' : 'probability' });
    const { box, X, Y } = scale;
    if (seen.truth ? seen.masses : simulated) {
      const points = outline(scene).map((point) => point && [X(point[0]), Y(point[1])]);
      pen.clip(box.x - 2, box.y - 2, box.w + 4, box.h + 4, () => {
        pen.path(points, HALO);
        pen.path(points, K <= 16 ? TRUTH : { ...TRUTH, width: 1 });
      });
    }
    if (scene.followed && !simulated) {
      const found = scene.followed.rewards.slice(0, Math.ceil(K * dt)), size = found.length > 60 ? 1.6 : 2.6;
      pen.clip(box.x, box.y, box.w, box.h, () => found.forEach((reward, k) => {
        const [x, y] = [X(reward), Y(k / dt)];
        pen.path([[x - size, y - size], [x + size, y - size], [x + size, y + size], [x - size, y + size]],
          { fill: '#ffffff', stroke: '#111111', width: 0.8, close: true });
      }));
    }
    const deadline = Y(seen.readRow + 0.5), ruler = { x: box.x + box.w + 6 + aside, w: 38 };
    if (simulated) drawDistances(pen, scene, { ...box, x: box.x + box.w + 6, w: 32 }, Y);
    pen.clip(box.x, box.y - 1, box.w, box.h + 2, () => {
      pen.path([[box.x, deadline], [box.x + box.w, deadline]], { stroke: '#111', width: 3 });
      pen.path([[box.x, deadline], [box.x + box.w, deadline]], { stroke: '#ff9f1c', width: 1.6, dash: [6, 4] });
      pen.text('T', box.x + box.w - 4, deadline + (deadline < box.y + 14 ? 12 : -4),
        { size: 11, weight: 700, align: 'right', colour: '#ff9f1c' });
    });
    pen.clip(ruler.x - 2, box.y - 1, ruler.w + 4, box.h + 2, () => { // through which window the row under the cursor is seen
      const peak = top(resolution.kernel.map(Math.abs)) || 1, foot = ruler.x + 6;
      const at = Array.from(resolution.kernel, (value, k) => [foot + (28 * value) / peak, Y(k)]);
      pen.path([[foot, Y(0)], ...at, [foot, Y(K - 1)]], { fill: colours.wash, stroke: colours.primary, width: 1.2 });
      const low = Y(resolution.low / dt - 0.5), high = Y(resolution.high / dt + 0.5);
      pen.path([[ruler.x + 3, low], [ruler.x, low], [ruler.x, high], [ruler.x + 3, high]], { stroke: colours.text, width: 1.4 });
    });
    pen.text(`window ±${short(resolution.half, 2)}`, ruler.x - 4, box.y + box.h + 27, { size: 10.5, colour: colours.text });
    colourBar(pen, images.bar ??= document.createElement('canvas'), { x: w - 32, y: box.y, w: 7, h: box.h }, limit, colours);
    marked(pen, scale, { x: hover.theta, y: hover.tau }, colours);
    return scale;
  },
  point: ({ model }, x, y) => ({ theta: x, tau: Math.min(model.K - 1, Math.max(0, Math.round(y))) }),
  words: ({ model, state, seen, resolution, at, images }) => {
    let mass = 0;
    for (let h = 0; h < seen.H; h++) mass += seen.tau[h] / model.dt;
    return `Tau-space of ${model.header.actions[state.action]}: ${seen.n} future steps. Row 0 holds probability ${short(mass)} with mean reward ${short(seen.rewards[state.action][0] / model.dt)}. `
      + `Step ${short(at * model.dt)} is seen through a window of plus or minus ${short(resolution.half, 2)} steps.${seen.truth ? ' The truth is outlined in white.' : simulatedWords({ model, state, seen, images })}`;
  },
};

// Below this a value is nothing beside the rewards of the world, and an axis should not blow it up.
const leastSpan = ({ arrays }) => (arrays.rewards ? 0.05 * Math.max(1e-9, ...arrays.rewards.map(Math.abs)) : 1e-3);

// ---- values over the horizon

const leader = (model, { chosenAt, values }, k) => (Number.isFinite(values[0][k])
  ? `T ${short(model.horizons[k])}: ${model.header.actions[chosenAt(k)]} ${short(values[chosenAt(k)][k])}` : '');

export const valuesPanel = {
  name: 'values',
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { horizons, K, dt } = model, names = model.header.actions;
    const box = inside(w, h, { top: 44, bottom: 62 }), all = [...seen.values, ...(seen.truth?.values ?? []), ...(scene.pinned?.values ?? [])];
    let low = 0, high = 0;
    for (const values of all) for (const value of values) if (value === value) { low = Math.min(low, value);
    high = Math.max(high, value); }
    const x = [horizons[0] - dt / 2, horizons[K - 1] + dt / 2];
    titled(pen, w, 'value of each action over T',
      hover.tau !== undefined
      ? leader(model, seen, hover.tau) : [seen.truth && 'dotted: true', scene.pinned && 'dashed: A'].filter(Boolean).join(', '), scene);
    let at = box.x;
    const first = [seen.chosen, seen.best, state.action].filter((a) => a !== undefined), order = new Set([...first, ...names.keys()]);
    const room = names.length > 2 ? w - 26 : w, left_ = [];
    [...order].forEach((a) => {
      const name = names[a], words = name.length > 16 ? `${name.slice(0, 15)}…` : name, wide = pen.width(words, 11) + 24;
      if (at + wide > room) { left_.push(a); return; }
      pen.path([[at, 30], [at + 14, 30]], { stroke: actionColour(a), width: a === state.action ? 4 : 2 });
      pen.text(words, at + 18, 34, { size: 11, colour: colours.text });
      at += wide;
    });
    if (left_.length) pen.text(`+${left_.length}`, w - 4, 34, { size: 11, align: 'right', colour: colours.soft });
    const scale = axes(pen, box, { x, y: rounded(low, high, leastSpan(model)), xTicks: [], yTitle: 'value', colours }), { X, Y } = scale;
    const xs = Array.from(horizons, X);
    pen.clip(box.x, box.y - 3, box.w, box.h + 6, () => {
      scene.pinned?.values.forEach((values, a) => line(pen, xs, values.map(Y), { ...GHOST, stroke: actionColour(a) }));
      seen.truth?.values.forEach((values, a) =>
        line(pen, xs, values.map(Y), { stroke: actionColour(a), width: 1.3, dash: [2, 3] }));
      seen.values.forEach((values, a) => {
        const known = [...values.keys()].filter((k) => Number.isFinite(values[k]));
        pen.path(known.map((k) => [xs[k], Y(values[k])]), { stroke: actionColour(a), width: a === state.action ? 2.4 : 1.8 });
        if (K <= 40) for (const k of known) pen.path(disc(xs[k], Y(values[k]), 2.6), { fill: actionColour(a), close: true });
      });
      for (const [T, value] of crossings(model, seen)) pen.path(disc(X(T), Y(value), 4),
        { stroke: colours.text, width: 1.5, fill: colours.paper, close: true });
    });
    const strip = (top, chosenAt) => {
      let from = 0;
      for (let k = 1; k <= K; k++) {
        const now = chosenAt(from);
        if (k < K && chosenAt(k) === now) continue;
        const left = X(horizons[from] - dt / 2), right = X(horizons[k - 1] + dt / 2);
        if (now >= 0) pen.path([[left, top], [right, top], [right, top + 10], [left, top + 10]],
          { fill: actionColour(now), close: true });
        from = k;
      }
    };
    const under = box.y + box.h + 5, used = seen.readRow - seen.leftRow;
    const chosen = Array.from({ length: K }, (_, k) => { // with constant T a step with less to go is read at T all the same
      const row = Math.min(K - 1, k + used);
      for (let back = row; back >= 0; back--) if (Number.isFinite(seen.values[0][back])) return seen.chosenAt(back);
      return -1;
    });
    strip(under, (k) => chosen[k]);
    pen.text('chosen', box.x - 5, under + 9, { size: 10.5, align: 'right', colour: colours.soft });
    if (seen.truth) {
      const best = Array.from({ length: K }, (_, k) => { // an action as good as the best is the best
        const optimum = seen.optimumAt(k), top_ = Math.max(...optimum), least = top_ - 1e-9 * Math.max(1, Math.abs(top_));
        return chosen[k] >= 0 && optimum[chosen[k]] >= least ? chosen[k] : seen.bestAt(k);
      });
      strip(under + 12, (k) => best[k]);
      pen.text('best', box.x - 5, under + 21, { size: 10.5, align: 'right', colour: colours.soft });
    }
    const spots = K <= 8 ? [...horizons] : ticks(...x).filter((tick) => tick >= x[0]);
    for (const tick of spots) pen.text(short(tick), X(tick), under + 36, { size: 10.5, align: 'center', colour: colours.soft });
    pen.text(used ? 'time to go (steps)' : 'horizon T (steps)', box.x + box.w / 2, under + 50,
      { size: 11, align: 'center', colour: colours.soft });
    for (const [row, dash] of [[seen.leftRow, [5, 4]], ...(used ? [[seen.readRow, [1, 4]]] : [])]) {
      pen.path([[xs[row], box.y], [xs[row], under + 24]], { stroke: '#ff9f1c', width: 1.8, dash });
    }
    if (hover.tau !== undefined) marked(pen, scale, { x: horizons[hover.tau] }, colours);
    return scale;
  },
  point: ({ model }, x) => ({ tau: Math.min(model.K - 1, Math.max(0, Math.round((x - model.horizons[0]) / model.dt))) }),
  words: ({ model, seen, state }) =>
    `Value of each action over the horizon T. Read at T = ${short(model.horizons[seen.readRow])}: ${model.header.actions.map((name, a) => `${name} ${short(seen.values[a][seen.readRow], 4)}`).join(', ')}. `
    + `Chosen: ${model.header.actions[seen.chosen]}.${seen.truth ? ` Best: ${model.header.actions[seen.best]}; ${short(seen.regret)} is lost.` : ''} The two leading lines cross ${crossings(model, seen).length} times.`,
};

const disc = (x, y, r) =>
  Array.from({ length: 13 }, (_, i) => [x + r * Math.cos((i * Math.PI) / 6), y + r * Math.sin((i * Math.PI) / 6)]);

// Where the leading action changes hands: T and value at the crossing of the two lines.
export function crossings({ horizons, K }, { values, chosenAt }) {
  const found = [], rows = [...Array(K).keys()].filter((k) => Number.isFinite(values[0][k]));
  for (let i = 1; i < rows.length; i++) {
    const [k, next] = [rows[i - 1], rows[i]], a = chosenAt(k), b = chosenAt(next);
    if (a === b) continue;
    const before = values[a][k] - values[b][k], after = values[b][next] - values[a][next],
      share = before + after > 0 ? before / (before + after) : 0;
    found.push([horizons[k] + share * (horizons[next] - horizons[k]), values[a][k] + share * (values[a][next] - values[a][k])]);
  }
  return found;
}

// ---- spectrum, kernel, rewards

export const spectrumPanel = {
  name: 'spectrum',
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { s, r, U, V, G } = seen.grid, box = inside(w, h);
    const learned = (G - 1) / (model.header.added + 1) + 1; // what is interpolated adds none
    const factors = s.map((value) => value ** 2 / (value ** 2 + state.alpha ** 2)), passing = factors.filter((f) => f > 0.5).length;
    titled(pen, w, 'what alpha lets through', `${passing} of ${r} pass${learned < G ? `, ${learned} learned` : ''}`,
      scene);
    const low = Math.floor(Math.log10(s[r - 1])) - 0.3, high = Math.max(0.6, Math.log10(s[0]) + 0.4),
      scale = axes(pen, box, { x: [0.4, r + 0.6], y: [low, high], xTitle: 'component; bars: share let through', yTitle: 'singular value', colours,
      xTicks: r <= 8 ? Array.from({ length: r }, (_, i) => i + 1) : undefined,
        yTicks: ticks(low, high, 6).filter((tick) => Number.isInteger(tick)).map((tick) => [tick, tick ? `1e${tick}` : '1']) });
    const { X, Y } = scale, half = 0.36 * (X(2) - X(1)), floor = box.y + box.h;
    factors.forEach((factor, i) => {
      const x = X(i + 1), top = floor - factor * box.h;
      pen.path([[x - half, floor], [x - half, top], [x + half, top], [x + half, floor]], { fill: colours.wash, close: true });
      pen.path(disc(x, Y(Math.log10(s[i])), 3.2), { fill: factor > 0.5 ? colours.primary : NEUTRAL, close: true });
    });
    const weights = hover.gamma !== undefined ? factors.map((_, i) => Math.abs(U[hover.gamma * r + i])) : hover.tau !== undefined
      ? factors.map((_, i) => Math.abs(V[hover.tau * r + i])) : null;
    if (weights) line(pen, Array.from(weights, (_, i) => X(i + 1)), weights.map((value) => floor - value * box.h),
      { stroke: colours.mark, width: 1.4 });
    const level = Math.log10(state.alpha);
    if (level > low && level < high) {
      pen.path([[box.x, Y(level)], [box.x + box.w, Y(level)]], { stroke: '#ff9f1c', width: 1.6, dash: [6, 4] });
      pen.text('α', box.x + box.w - 3, Y(level) - 4, { size: 12, weight: 700, align: 'right', colour: '#ff9f1c' });
    }
    return scale;
  },
  point: () => ({}),
  words: ({ state, seen }) =>
    `Singular values of the transform: ${seen.grid.r} usable, the smallest ${short(seen.grid.s[seen.grid.r - 1] / seen.grid.s[0])} of the largest. `
    + `Alpha ${short(state.alpha)} lets ${seen.grid.s.filter((value) => value > state.alpha).length} of them through by more than half.`,
};

export const kernelPanel = {
  name: 'kernel',
  draw(pen, w, h, scene) {
    const { model, seen, hover, colours, kernel } = scene, { K, dt } = model, box = inside(w, h);
    const low = Math.min(0, ...kernel.actual), high = Math.max(1, ...kernel.actual);
    titled(pen, w, 'what the value weighs',
      `noise gain ${short(kernel.gain)}${scene.state.normalise === 'none' ? '' : ', before rescaling'}`, scene);
    const scale = axes(pen, box, { x: [-0.5 * dt, (K - 0.5) * dt], y: rounded(low, high, 1e-3), xTitle: 'future step τ',
      yTitle: 'weight', colours, xTicks: K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : undefined });
    const { X, Y } = scale, xs = Array.from({ length: K }, (_, k) => X(k * dt)), steps = [];
    kernel.wanted.forEach((value, k) => steps.push([X((k - 0.5) * dt), Y(value)], [X((k + 0.5) * dt), Y(value)]));
    pen.path([[steps[0][0], Y(0)], ...steps, [steps[steps.length - 1][0], Y(0)]],
      { fill: 'rgba(138,143,152,0.22)', stroke: NEUTRAL, width: 1, close: true });
    if (hover.gamma !== undefined) line(pen, xs, xs.map((_, k) => Y(seen.grid.gammas[hover.gamma] ** (k * dt))),
      { stroke: colours.mark, width: 1.2, dash: [3, 3] });
    line(pen, xs, kernel.actual.map(Y), { stroke: colours.primary, width: 2.2 });
    if (K <= 40) kernel.actual.forEach((value, k) => pen.path(disc(xs[k], Y(value), 2.6), { fill: colours.primary, close: true }));
    if (hover.tau !== undefined) marked(pen, scale, { x: hover.tau * dt }, colours);
    return scale;
  },
  point: ({ model }, x) => ({ tau: Math.min(model.K - 1, Math.max(0, Math.round(x / model.dt))) }),
  words: ({ model, seen, kernel }) => {
    let off = 0, all = 0;
    kernel.actual.forEach((value, k) => { off += Math.abs(value - kernel.wanted[k]); all += Math.abs(kernel.wanted[k]); });
    return `Discount kernel for T = ${short(model.horizons[seen.readRow])}: it misses the wanted weights by ${short((100 * off) / (all || 1), 2)} percent of their sum; noise gain ${short(kernel.gain)}.`;
  },
};

const CAME = 'rgba(138,143,152,0.55)';
const cameNote = ({ model, state, followed }) => (followed.action === state.action ? 'grey: what came'
  : `grey: what came after ${model.header.actions[followed.action]}`);

export const rewardsPanel = {
  name: 'rewards',
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { K, dt } = model, a = state.action, box = inside(w, h);
    const upper = { ...box, h: box.h * 0.62 }, lower = { ...box, y: box.y + box.h * 0.74, h: box.h * 0.26 };
    const rewards = Array.from(seen.rewards[a], (value) => value / dt),
      true_ = seen.truth && Array.from(seen.truth.rewards[a], (value) => value / dt);
    const ghost = scene.pinned && Array.from(scene.pinned.rewards[a], (value) => value / dt);
    const followed = simulatedFor(scene) ? null : scene.followed, came = followed ? followed.rewards.slice(0, Math.ceil(K * dt)) : [];
    const simulated = simulatedFor(scene), edges = (side) => simulated?.reward.map((value, k) => value + side * simulated.rewardError[k]) ?? [];
    const all = [0, ...rewards, ...(true_ ?? []), ...(ghost ?? []), ...came, ...edges(2), ...edges(-2)];
    const low = Math.min(...all), high = Math.max(...all), x = [-0.5 * dt, (K - 0.5) * dt];
    titled(pen, w, 'expected reward and survival',
      hover.tau < seen.n ? `τ ${short(hover.tau * dt)}: ${short(rewards[hover.tau])}, alive ${short(seen.survival[a][hover.tau] / dt)}` : Math.max(...seen.survival[a]) / dt > 1.05 ? 'alive above 1: impossible' : seen.truth ? 'grey: true' : simulated ? 'red: simulated, ± 2 errors' : followed ? cameNote(scene) : '', scene);
    const span = 1e-3 * (seen.thetas[seen.H] - seen.thetas[0]),
      scale = axes(pen, upper, { x, y: rounded(low, high, span), xTicks: [], yTitle: 'E[r]', colours });
    const few = K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : undefined;
    const alive = axes(pen, lower, { x, y: [-0.25, 1.35], yTicks: [0, 1], xTicks: few, xTitle: 'future step τ', yTitle: 'alive',
      colours });
    const xs = Array.from({ length: K }, (_, k) => scale.X(k * dt)), { Y } = scale;
    pen.clip(upper.x, upper.y - 2, upper.w, upper.h + 4, () => {
      const bar = Math.max(0.8, 0.4 * (scale.X(dt) - scale.X(0)));
      true_?.forEach((value, k) => value
        && pen.path([[xs[k] - bar, Y(0)], [xs[k] - bar, Y(value)], [xs[k] + bar, Y(value)], [xs[k] + bar, Y(0)]],
        { fill: 'rgba(138,143,152,0.45)', close: true }));
      came.forEach((value, k) => pen.path([[scale.X(k - 0.35), Y(0)], [scale.X(k - 0.35), Y(value)], [scale.X(k + 0.35), Y(value)],
        [scale.X(k + 0.35), Y(0)]], { fill: CAME, close: true }));
      if (ghost) line(pen, xs, ghost.map(Y), { ...GHOST, stroke: actionColour(a) });
      if (simulated) drawSimulated(pen, simulated.reward, simulated.rewardError, scale);
      line(pen, xs, rewards.map(Y), { stroke: actionColour(a), width: 2.2 });
      if (K <= 40) rewards.forEach((value, k) => pen.path(disc(xs[k], Y(value), 2.8), { fill: actionColour(a), close: true }));
    });
    pen.clip(lower.x, lower.y, lower.w, lower.h, () => {
      if (seen.truth) line(pen, xs, seen.truth.survival[a].map((value) => alive.Y(value / dt)), { stroke: NEUTRAL, width: 5 });
      if (followed) { // 1 until it was over; what is not known is not drawn
        const end = followed.over ?? came.length;
        pen.path([[alive.X(-0.5), alive.Y(1)], [alive.X(end - 0.5), alive.Y(1)],
          ...(followed.over === null ? [] : [[alive.X(end - 0.5), alive.Y(0)], [alive.X(K * dt), alive.Y(0)]])], { stroke: NEUTRAL, width: 4 });
      }
      if (simulated) drawSimulated(pen, simulated.survival, simulated.survivalError, alive);
      line(pen, xs, seen.survival[a].map((value) => alive.Y(value / dt)), { stroke: colours.text, width: 1.6 });
    });
    for (const each of [scale, alive]) if (hover.tau !== undefined) marked(pen, each, { x: hover.tau * dt }, colours);
    return { ...scale, box };
  },
  point: kernelPanel.point,
  words: ({ model, state, seen }) => {
    const a = state.action, tell = (x) => Array.from(x.slice(0, 4), (value) => short(value / model.dt)).join(', ');
    return `Expected reward of ${model.header.actions[a]} at the first steps: decoded ${tell(seen.rewards[a])}${seen.truth ? `, true ${tell(seen.truth.rewards[a])}` : ''}. `
      + `Survival: decoded ${tell(seen.survival[a])}${seen.truth ? `, true ${tell(seen.truth.survival[a])}` : ''}.`;
  },
};

// Whether the decoded timeline explains the gamma-space that it came from: (1 - gamma) times the value at each discount.
export const fitPanel = {
  name: 'fit',
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { gammas, G } = seen.grid, { given, back } = fitOf(scene), box = inside(w, h);
    const times = gammas.map((gamma) => Math.log10(-1 / Math.log(gamma))), all = [0, ...given, ...back];
    titled(pen, w, 'does the timeline explain it?', hover.gamma === undefined ? 'value a step at each discount'
      : `γ ${short(gammas[hover.gamma])}: ${short(given[hover.gamma])}, from tau-space ${short(back[hover.gamma])}`, scene);
    const margin = 0.04 * (times[G - 1] - times[0]) || 0.5, x = [times[0] - margin, times[G - 1] + margin];
    const scale = axes(pen, box, { x, y: rounded(Math.min(...all), Math.max(...all), 1e-6), xTitle: 'time constant of γ (steps)',
      yTitle: '(1 − γ) value', colours, xTicks: ticks(...x, 4).filter((tick) => Number.isInteger(tick)).map((tick) => [tick, short(10 ** tick)]) });
    const xs = Array.from(times, scale.X);
    given.forEach((value, g) => pen.path(disc(xs[g], scale.Y(value), G > 40 && isAdded(scene, g) ? 1.8 : 3.4), { stroke: colours.soft, width: 1.6, close: true,
      fill: model.header.added && !isAdded(scene, g) ? colours.soft : undefined }));
    line(pen, xs, back.map(scale.Y), { stroke: actionColour(state.action), width: 2.2 });
    if (hover.gamma !== undefined) marked(pen, scale, { x: times[hover.gamma] }, colours);
    return { ...scale, times };
  },
  point: ({ seen }, x) => ({ gamma: seen.grid.gammas.reduce((best, gamma, g, all) => {
    const far = (other) => Math.abs(Math.log10(-1 / Math.log(all[other])) - x);
    return far(g) < far(best) ? g : best;
  }, 0) }),
  words: (scene) => {
    const { given, back } = fitOf(scene), off = Math.max(...given.map((value, g) => Math.abs(value - back[g])));
    return `Value of ${scene.model.header.actions[scene.state.action]} at ${given.length} discounts, as learned and as tau-space gives it back: they differ by at most ${short(off)} a step.`;
  },
};

function fitOf({ state, seen, images, model }) {
  if (images.fitFor === seen) return images.fit;
  const { gammas, G } = seen.grid, Z = gammaSpace(seen, state), given = new Float64Array(G), back = new Float64Array(G);
  for (let g = 0; g < G; g++) {
    for (let h = 0; h < seen.H; h++) given[g] += Z[g * seen.H + h] * seen.midpoints[h] * (1 - gammas[g]);
    seen.rewards[state.action].forEach((reward, k) => { back[g] += (1 - gammas[g]) * gammas[g] ** (k * model.dt) * reward; });
  }
  Object.assign(images, { fitFor: seen, fit: { given, back } });
  return images.fit;
}

// Without a world to draw, its place shows whether the inverse explains what was learned.
export const panelsOf = ({ world, still }) => [...(world || still ? [] : [fitPanel]), gammaPanel, tauPanel, valuesPanel, rewardsPanel, kernelPanel,
  spectrumPanel];
