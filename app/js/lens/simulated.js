// What simulated continuations of the state came to, and how far tau-space is off from it. Whole steps, no rescaling.
/** @import { Box, Model, ModelAndState, Pen, Scale, Scene, Seen, Simulation } from '../types.js' */
import { line, rounded, short } from '../draw/drawing.js';

const CAME_TRUE = '#d6336c';
const BAND = 'rgba(214,51,108,0.2)',
  TAIL = 65535; // levels of a probability

/**
 * What was simulated of the shown action; undefined where there is nothing.
 * @param {ModelAndState} scene
 * @returns {Simulation | undefined}
 */
export const simulatedFor = ({ model, state }) =>
  model.simulated?.action === state.action ? model.simulated : undefined;

// The step that belongs to a row, or -1 between two steps.
function stepAt(simulated, dt, row) {
  const step = Math.round(row * dt);
  return Math.abs(step - row * dt) < 1e-9 && step < simulated.length ? step : -1;
}

/**
 * Probabilities of a row's bins, averaged with its neighbours, since continuations are few; null where none is left.
 * @param {Model} model
 * @param {number} a
 * @param {number} row
 * @returns {Float64Array | null} (bins,)
 */
export function simulatedRow(model, a, row) {
  const { simulated, K } = model;
  if (!simulated || simulated.action !== a) return null;
  const step = stepAt(simulated, model.dt, row);
  if (step < 0) return null;
  const { tails, width, length } = simulated,
    far = Math.round(K / 80),
    found = new Float64Array(width - 1);
  const first = Math.max(0, step - far),
    last = Math.min(length - 1, step + far);
  if (!tails[step * width]) return null;
  for (let at = first; at <= last; at++)
    for (let h = 0; h < width - 1; h++) {
      found[h] += (tails[at * width + h] - tails[at * width + h + 1]) / TAIL / (last - first + 1);
    }
  return found;
}

/**
 * W1 of each step's reward between the picture and the simulation, as laplace_core.code.encoding.reward_distance. What lies
 * beyond the sensitivities counts at them: open ends have no width.
 * @param {Model} model
 * @param {Seen} seen
 * @returns {Float64Array} (N,), in reward; NaN where the picture has no row; empty where nothing is simulated
 */
export function distances({ simulated, dt }, { tau, thetas, H, n, open }) {
  if (!simulated) return new Float64Array();
  const { tails, width, length } = simulated,
    out = new Float64Array(length).fill(NaN),
    low = new Float64Array(H + 1);
  if (width !== H + 1) return out;
  for (let step = 0; step < length; step++) {
    const row = Math.round(step / dt),
      from = step * width;
    if (row >= n || Math.abs(row * dt - step) >= 1e-9) continue;
    for (let h = 0; h < H; h++)
      low[h + 1] = low[h] + tau[row * H + h] / dt - (tails[from + h] - tails[from + h + 1]) / TAIL;
    out[step] = 0;
    const area = (left, right, x, x2) => {
      out[step] += ((Math.abs(left) + Math.abs(right)) / 2) * (x2 - x);
    };
    for (let h = Number(open); h < H - Number(open); h++) {
      // an episode that is over pays 0: below it counts what is lower, above it what is higher
      const x = thetas[h],
        x2 = thetas[h + 1],
        zero = Math.min(x2, Math.max(x, 0));
      const middle = low[h] + ((zero - x) / (x2 - x)) * (low[h + 1] - low[h]);
      area(low[h], middle, x, zero);
      area(low[H] - middle, low[H] - low[h + 1], zero, x2);
    }
  }
  return out;
}

/**
 * Those distances of the picture that is shown.
 * @param {Pick<Scene, 'model' | 'seen' | 'images'>} scene
 * @returns {Float64Array} (N,), in reward
 */
export function distancesOf({ model, seen, images }) {
  if (images.distancesFor !== seen) Object.assign(images, { distances: distances(model, seen), distancesFor: seen });
  return images.distances;
}

/**
 * Draws beside tau-space, on its axis, W1 of every step, and in grey what few continuations alone would make of it.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {Box} strip
 * @param {(row: number) => number} Y
 * @returns {void}
 */
export function drawDistances(pen, scene, strip, Y) {
  const {
      model: { simulated, dt },
      colours,
    } = scene,
    found = distancesOf(scene);
  const steps = [...found.keys()].filter((step) => Number.isFinite(found[step]));
  if (!simulated || !steps.length) return;
  const [, most] = rounded(0, Math.max(...steps.map((step) => Math.max(found[step], simulated.chance[step]))));
  const X = (value) => strip.x + (strip.w * value) / most,
    half = 0.5 / dt,
    { y, h } = strip;
  const area = (values) => [
    [X(0), Y(steps[0] / dt - half)],
    ...steps.flatMap((step) => [
      [X(values[step]), Y(step / dt - half)],
      [X(values[step]), Y(step / dt + half)],
    ]),
    [X(0), Y(steps[steps.length - 1] / dt + half)],
  ];
  pen.clip(strip.x - 1, y, strip.w + 2, h, () => {
    pen.path(area(found), { fill: BAND, stroke: CAME_TRUE, width: 1, close: true });
    pen.path(area(simulated.chance), { fill: 'rgba(138,143,152,0.5)', close: true });
  });
  // Its 0 would stand beside the last label of theta.
  pen.text(short(most), X(most), y + h + 13, { size: 10, align: 'right', colour: colours.soft });
  pen.text('W1', strip.x + strip.w / 2, y + h + 27, { size: 11, align: 'center', colour: colours.text });
}

/**
 * Draws a simulated line with a band of two standard errors.
 * @param {Pen} pen
 * @param {Float64Array} mean - (N,)
 * @param {Float64Array} error - (N,)
 * @param {Scale} scale
 * @returns {void}
 */
export function drawSimulated(pen, mean, error, { X, Y }) {
  const xs = Array.from(mean, (_, step) => X(step)),
    edge = (side) => Array.from(mean, (value, step) => [xs[step], Y(value + side * error[step])]);
  pen.path([...edge(2), ...edge(-2).reverse()], { fill: BAND, close: true });
  line(pen, xs, mean.map(Y), { stroke: CAME_TRUE, width: 1.4 });
}

/**
 * What is simulated, in words; nothing where nothing is.
 * @param {Pick<Scene, 'model' | 'state' | 'seen' | 'images'>} scene
 * @returns {string}
 */
export const simulatedWords = (scene) => {
  const found = simulatedFor(scene),
    far = found && distancesOf(scene).filter(Number.isFinite);
  return found && far?.length
    ? ` ${found.count} simulated continuations are outlined; the distance to them is ` +
        `${short(far.reduce((a, b) => a + b) / far.length)} reward on average.`
    : '';
};
