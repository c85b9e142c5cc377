// An episode as the server packs it: everything of each step, and the model that the lens shows for one. Knows no page.
/** @import { Followed, Model, Reel, SpaceReel } from '../types.js' */
import { remade } from '../core/model.js';

const KINDS = { f4: Float32Array, f8: Float64Array, u1: Uint8Array };

async function inflated(block) {
  const stream = new Blob([block]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Levels of all steps from 16-bit changes, whose low bytes come before their high ones; sums wrap around.
 * @param {Uint8Array} halves - twice as many as there are levels
 * @param {number} steps
 * @returns {Int16Array}
 */
export function levelsOf(halves, steps) {
  const count = halves.length / 2,
    width = count / steps,
    out = new Int16Array(count);
  for (let i = 0; i < count; i++) {
    const change = halves[i] | (halves[count + i] << 8);
    out[i] = i < width ? change : out[i - width] + change;
  }
  return out;
}

/**
 * An episode of a payload.
 * @param {Uint8Array} bytes - as laplace_core/payloads/player.py packs them
 * @returns {Promise<Omit<Reel, 'id'>>}
 */
export async function openReel(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset),
    length = view.getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))),
    reel = { ...header };
  for (const [name, [kind, at, size]] of Object.entries(header.blocks)) {
    const block = bytes.slice(4 + length + at, 4 + length + at + size);
    if (name === 'differences') reel.levels = levelsOf(await inflated(block), header.steps);
    else if (kind === 'z4' || name === 'constant') reel[name] = new Float32Array((await inflated(block)).buffer);
    else reel[name === 'actions' ? 'taken' : name] = new KINDS[kind](block.buffer);
  }
  return reel;
}

/**
 * The gamma-space of a step.
 * @param {SpaceReel} reel
 * @param {number} step
 * @returns {{ differences: Float64Array, constant: Float64Array }} (A, G, H+1), and the constant channel, (A, G)
 */
export function spaceAt({ levels, constant, scales, steps, actions }, step) {
  const size = levels.length / steps,
    G = scales.length,
    width = size / actions / G,
    from = step * size;
  const differences = Float64Array.from({ length: size }, (_, i) => levels[from + i] * scales[((i / width) | 0) % G]);
  const one = constant.length / steps;
  return { differences, constant: Float64Array.from(constant.subarray(step * one, (step + 1) * one)) };
}

/**
 * The lens's model of a step, by the factors of the one that it has.
 * @param {SpaceReel} reel
 * @param {number} step
 * @param {Model} base
 * @returns {Model}
 */
export function modelAt(reel, step, base) {
  const { differences, constant } = spaceAt(reel, step);
  return { ...remade(base, differences, constant), id: `${reel.id} ${step}` };
}

/**
 * The picture of a step; null where there is none.
 * @param {Pick<Reel, 'frames' | 'ends'>} reel
 * @param {number} step
 * @returns {Uint8Array<ArrayBuffer> | null} a JPEG file
 */
export const frameAt = ({ frames, ends }, step) =>
  ends.length ? frames.subarray(step ? ends[step - 1] : 0, ends[step]) : null;

/**
 * Whether the agent's own value, the bootstrapped remainder of a truncated episode, has more than 5% of the weight in
 * the observed return.
 * @param {Pick<Reel, 'acting_gamma' | 'steps' | 'terminated'>} reel
 * @param {number} step
 * @returns {boolean}
 */
export const ownAt = ({ acting_gamma: gamma, steps, terminated }, step) =>
  !terminated && gamma ** (steps - step) > 0.05;

/**
 * What the lens draws on the timeline of a step: see laplace_core/trained/rollouts.py.
 * @param {Reel} reel
 * @param {number} step
 * @returns {Followed}
 */
export function followedAt({ rewards, taken, steps, terminated }, step) {
  return { rewards: Array.from(rewards.subarray(step)), action: taken[step], over: terminated ? steps - step : null };
}

/**
 * The next step after this one that is marked; around the end to the first.
 * @param {ArrayLike<number>} marks - (N,)
 * @param {number} step
 * @returns {number} -1 where none is
 */
export function nextMarked(marks, step) {
  for (let i = 1; i <= marks.length; i++) if (marks[(step + i) % marks.length]) return (step + i) % marks.length;
  return -1;
}

/**
 * Steps in the order of how much they surprise, the largest first.
 * @param {Reel} reel
 * @returns {number[]} (N,)
 */
export const bySurprise = ({ surprise }) =>
  [...surprise.keys()].sort((a, b) => Math.abs(surprise[b]) - Math.abs(surprise[a]));
