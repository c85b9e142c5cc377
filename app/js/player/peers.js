// The pictures of an agent without a gamma-space follow the cursor: what laplace_core/figures/returns.py draws at rest.
/** @import { ChartBox, Range, Reel } from '../types.js' */
import { short } from '../draw/drawing.js';

const TAIL = 0.002; // mass at either end of a law that the axis need not reach

/** @type {(name: string) => ChartBox | null} */
const boxOf = (name) => document.querySelector(`.laplace-chart[data-name="${name}"]`);

// Values and probabilities of the predicted return after an action.
function lawAt({ locations, masses, actions, steps }, step, action) {
  const width = locations.length / steps / actions,
    from = (step * actions + action) * width;
  return { places: locations.subarray(from, from + width), masses: masses.subarray(from, from + width) };
}

function belowOf({ masses }) {
  const below = Float64Array.from(masses);
  for (let i = 1; i < below.length; i++) below[i] += below[i - 1];
  return below.map((sum) => sum / below[below.length - 1]);
}

const first = (below, share) => {
  const at = below.findIndex((sum) => sum >= share);
  return at < 0 ? below.length - 1 : at;
};

// Corners of P(x at most this) from low to high.
function staircase({ places }, below, low, high) {
  const x = [low],
    y = [0];
  places.forEach((place, i) => {
    if (place <= low) y[0] = below[i];
    else if (place < high) {
      x.push(place);
      y.push(below[i]);
    }
  });
  let last = 0;
  places.forEach((place, i) => {
    if (place <= high) last = below[i];
  });
  return { x: [...x, high], y: [...y, last] };
}

/**
 * The predicted return of each action at a step: staircases of P(return at most x), then the means.
 * @param {Required<Pick<Reel, 'locations' | 'masses' | 'actions' | 'steps'>>} reel
 * @param {number} step
 * @returns {{ x: number[][], y: number[][], range: Range }} a line each, and the range of x, in reward
 */
export function lawsAt(reel, step) {
  const laws = Array.from({ length: reel.actions }, (_, a) => lawAt(reel, step, a)),
    below = laws.map(belowOf);
  const ends = laws.flatMap(({ places }, a) => [places[first(below[a], TAIL)], places[first(below[a], 1 - TAIL)]]);
  const low = Math.min(...ends),
    high = Math.max(...ends),
    room = 0.04 * (high - low) || 0.5,
    range = [low - room, high + room];
  const stairs = laws.map((law, a) => staircase(law, below[a], ...range));
  const means = laws.map(({ places, masses }) => {
    const sum = masses.reduce((s, mass) => s + mass, 0);
    return places.reduce((s, place, i) => s + place * masses[i], 0) / sum;
  });
  return {
    x: [...stairs.map(({ x }) => x), ...means.map((mean) => [mean])],
    y: [...stairs.map(({ y }) => y), ...means.map(() => [0])],
    range,
  };
}

function horizonsAt({ horizon_values: values, actions, steps, horizon }, step) {
  const longest = values.length / steps / actions,
    from = step * longest * actions;
  const y = Array.from({ length: actions }, (_, a) =>
    Array.from({ length: longest }, (_, t) => values[from + t * actions + a]),
  );
  return { y, left: horizon ? Math.min(longest, horizon - step) : longest };
}

function draw(box, data, layout, count) {
  if (!box?.data || box.data.length !== count) return; // not drawn yet, or of another agent
  box.drawn = null; // whatever the server sends next is drawn
  globalThis.Plotly.update(box, data, layout, [...Array(count).keys()]);
}

const cursor = (at) => ({ 'shapes[0].x0': at, 'shapes[0].x1': at });

let wanted; // the step to be drawn with the next frame: a hand is faster than plotly

/**
 * Draws a step with the next frame.
 * @param {Reel} reel
 * @param {number} step
 * @returns {void}
 */
export function follow(reel, step) {
  if (!wanted)
    requestAnimationFrame(() => {
      const now = wanted;
      wanted = undefined;
      drawAt(...now);
    });
  wanted = [reel, step];
}

function drawAt(reel, step) {
  const state = boxOf('state'),
    episode = boxOf('episode'),
    A = reel.actions;
  if (reel.locations) {
    const { x, y, range } = lawsAt(reel, step);
    draw(state, { x, y }, { 'xaxis.range': range }, 2 * A);
  } else if (reel.horizon_values) {
    const { y, left } = horizonsAt(reel, step);
    draw(state, { y }, cursor(left), A);
  } else {
    const values = Array.from(reel.greedy_values.subarray(step * A, (step + 1) * A));
    const low = Math.min(0, ...values),
      high = Math.max(0, ...values);
    const range = high > low ? [1.12 * low, 1.12 * high] : [0, 1];
    draw(
      state,
      { x: values.map((value) => [value]), text: values.map((value) => [short(value, 4)]) },
      { 'xaxis.range': range },
      A,
    );
  }
  if (episode?.layout?.shapes?.length) {
    episode.drawn = null;
    globalThis.Plotly.relayout(episode, cursor(step));
  }
}
