// The value of each action over the horizon, and which one is chosen.
/** @import { Model, Panel, Seen } from '../types.js' */
import { tieSize } from '../core/algebra.js';
import { actionColour, axes, line, rounded, short, ticks } from '../draw/drawing.js';
import { GHOST, disc, inside, leastSpan, markOf, marked, titled } from '../draw/frame.js';

const leader = (model, { chosenAt, values }, k) =>
  Number.isFinite(values[0][k])
    ? `T ${short(model.horizons[k])}: ${model.header.actions[chosenAt(k)]} ${short(values[chosenAt(k)][k])}`
    : '';

// Where each action is named, in up to two rows: in order, so that nothing jumps, or those that matter now before the
// others where there is no room for all.
function legendOf(pen, { model, seen, state }, w) {
  const names = model.header.actions,
    left = inside(w, 0).x,
    right = w - (names.length > 2 ? 26 : 0);
  const laid = (order) => {
    const found = [];
    let [x, row] = [left, 0];
    for (const a of order) {
      const name = names[a],
        words = name.length > 16 ? `${name.slice(0, 15)}…` : name,
        wide = pen.width(words, 11) + 24;
      if (x + wide > right && x > left) [x, row] = [left, row + 1];
      if (row > 1) break;
      found.push({ a, words, x, row });
      x += wide;
    }
    return found;
  };
  const inOrder = laid(names.keys()),
    first = [seen.chosen, seen.best, state.action].filter((a) => a !== undefined);
  return inOrder.length === names.length ? inOrder : laid(new Set([...first, ...names.keys()]));
}

/** @type {Panel} */
export const valuesPanel = {
  name: 'values',
  title: 'Values over T',
  why: [
    'The value of each action if the episode ended at T: expected rewards before T, added up. The strip compares the ' +
      'action that is chosen with the best one.',
    'V_T(a) = Σ_{τ<T} γ^τ Σ_θ θ P_a(τ, θ)',
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene,
      { horizons, K, dt } = model,
      names = model.header.actions;
    const legend = legendOf(pen, scene, w),
      rows = Math.max(...legend.map(({ row }) => row));
    const box = inside(w, h, { top: 44 + 15 * rows, bottom: 62 }),
      all = [...seen.values, ...(seen.truth?.values ?? []), ...(scene.pinned?.values ?? [])];
    let low = 0,
      high = 0;
    for (const values of all)
      for (const value of values)
        if (value === value) {
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
    const x = [horizons[0] - dt / 2, horizons[K - 1] + dt / 2];
    titled(
      pen,
      w,
      'Values over T',
      hover.tau !== undefined
        ? leader(model, seen, hover.tau)
        : [seen.truth && 'dotted: true', scene.pinned && 'dashed: A'].filter(Boolean).join(', '),
      scene,
      false,
    ); // the legend is there
    legend.forEach(({ a, words, x: at, row }) => {
      const y = 30 + 15 * row;
      pen.path(
        [
          [at, y],
          [at + 14, y],
        ],
        { stroke: actionColour(a), width: a === state.action ? 4 : 2 },
      );
      pen.path(markOf(a, at + 7, y, 3.6), { fill: actionColour(a), close: true });
      pen.text(words, at + 18, y + 4, { size: 11, colour: colours.text });
    });
    const left_ = names.length - legend.length;
    if (left_) pen.text(`+${left_}`, w - 4, 34, { size: 11, align: 'right', colour: colours.soft });
    const scale = axes(pen, box, {
        x,
        y: rounded(low, high, leastSpan(model)),
        xTicks: [],
        yTitle: 'value (reward)',
        colours,
      }),
      { X, Y } = scale;
    const xs = Array.from(horizons, X);
    pen.clip(box.x, box.y - 3, box.w, box.h + 6, () => {
      scene.pinned?.values.forEach((values, a) => line(pen, xs, values.map(Y), { ...GHOST, stroke: actionColour(a) }));
      seen.truth?.values.forEach((values, a) =>
        line(pen, xs, values.map(Y), { stroke: actionColour(a), width: 1.3, dash: [2, 3] }),
      );
      seen.values.forEach((values, a) => {
        const known = [...values.keys()].filter((k) => Number.isFinite(values[k]));
        pen.path(
          known.map((k) => [xs[k], Y(values[k])]),
          { stroke: actionColour(a), width: a === state.action ? 2.4 : 1.8 },
        );
        // Of many steps only some are marked, each action at steps of its own.
        const every = Math.ceil(K / 40) * (K > 40 ? 5 : 1),
          offset = Math.floor((a * every) / names.length);
        for (const k of known)
          if (k % every === offset)
            pen.path(markOf(a, xs[k], Y(values[k]), 2.8), { fill: actionColour(a), close: true });
      });
      for (const [T, value] of crossings(model, seen))
        pen.path(disc(X(T), Y(value), 4), { stroke: colours.text, width: 1.5, fill: colours.paper, close: true });
    });
    const strip = (top, chosenAt) => {
      let from = 0;
      for (let k = 1; k <= K; k++) {
        const now = chosenAt(from);
        if (k < K && chosenAt(k) === now) continue;
        const left = X(horizons[from] - dt / 2),
          right = X(horizons[k - 1] + dt / 2);
        if (now >= 0)
          pen.path(
            [
              [left, top],
              [right, top],
              [right, top + 10],
              [left, top + 10],
            ],
            { fill: actionColour(now), close: true },
          );
        from = k;
      }
    };
    const under = box.y + box.h + 5,
      used = seen.readRow - seen.leftRow;
    const chosen = Array.from({ length: K }, (_, k) => {
      // with constant T a step with less to go is read at T all the same
      const row = Math.min(K - 1, k + used);
      for (let back = row; back >= 0; back--) if (Number.isFinite(seen.values[0][back])) return seen.chosenAt(back);
      return -1;
    });
    strip(under, (k) => chosen[k]);
    pen.text('chosen', box.x - 5, under + 9, { size: 10.5, align: 'right', colour: colours.soft });
    if (seen.truth) {
      const best = Array.from({ length: K }, (_, k) => {
        // an action as good as the best is the best
        const optimum = seen.optimumAt(k),
          top_ = Math.max(...optimum),
          least = top_ - tieSize(top_, Math.max(...optimum.map(Math.abs)));
        return chosen[k] >= 0 && optimum[chosen[k]] >= least ? chosen[k] : seen.bestAt(k);
      });
      strip(under + 12, (k) => best[k]);
      pen.text('best', box.x - 5, under + 21, { size: 10.5, align: 'right', colour: colours.soft });
    }
    const spots = K <= 8 ? [...horizons] : ticks(x[0], x[1]).filter((tick) => tick >= x[0]);
    for (const tick of spots)
      pen.text(short(tick), X(tick), under + 36, { size: 10.5, align: 'center', colour: colours.soft });
    pen.text(used ? 'time to go (steps)' : 'horizon T (steps)', box.x + box.w / 2, under + 50, {
      size: 11,
      align: 'center',
      colour: colours.soft,
    });
    const rowsRead = [{ row: seen.leftRow, dash: [5, 4] }, ...(used ? [{ row: seen.readRow, dash: [1, 4] }] : [])];
    for (const { row, dash } of rowsRead) {
      pen.path(
        [
          [xs[row], box.y],
          [xs[row], under + 24],
        ],
        { stroke: '#ff9f1c', width: 1.8, dash },
      );
    }
    if (hover.tau !== undefined) marked(pen, scale, { x: horizons[hover.tau] }, colours);
    return scale;
  },
  point: ({ model }, x) => ({
    tau: Math.min(model.K - 1, Math.max(0, Math.round((x - model.horizons[0]) / model.dt))),
  }),
  words: ({ model, seen }) =>
    `Value of each action over the horizon T. Read at T = ${short(model.horizons[seen.readRow])}: ` +
    `${model.header.actions.map((name, a) => `${name} ${short(seen.values[a][seen.readRow], 4)}`).join(', ')}. ` +
    `Chosen: ${model.header.actions[seen.chosen]}.` +
    (seen.truth ? ` Best: ${model.header.actions[seen.best]}; ${short(seen.regret)} is lost.` : '') +
    ' ' +
    `The two leading lines cross ${crossings(model, seen).length} times.`,
};

/**
 * Where the leading action changes hands.
 * @param {Model} model
 * @param {Seen} seen
 * @returns {number[][]} T and value at each crossing of two lines
 */
function crossings({ horizons, K }, { values, chosenAt }) {
  const found = [],
    rows = [...Array(K).keys()].filter((k) => Number.isFinite(values[0][k]));
  for (let i = 1; i < rows.length; i++) {
    const [k, next] = [rows[i - 1], rows[i]],
      a = chosenAt(k),
      b = chosenAt(next);
    if (a === b) continue;
    const before = values[a][k] - values[b][k],
      after = values[b][next] - values[a][next],
      share = before + after > 0 ? before / (before + after) : 0;
    found.push([
      horizons[k] + share * (horizons[next] - horizons[k]),
      values[a][k] + share * (values[a][next] - values[a][k]),
    ]);
  }
  return found;
}
