// The theta axis of the spaces: all columns are equally wide, as all rows are equally high, whatever they stand for. So
// sensitivities that are close together around reward 0 and far apart at +-100 can all be seen.
/** @import { Bins, Range } from '../types.js' */
import { short, ticks } from './drawing.js';

const APART = 34; // pixels between two labels

/**
 * The column that holds a reward.
 * @param {Bins} seen
 * @param {number} theta
 * @returns {number} from 0 to H - 1
 */
export function columnAt({ thetas, H }, theta) {
  let low = 0,
    high = H - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (thetas[middle] <= theta) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * The reward under the cursor in words: an open end has one edge only.
 * @param {Bins} seen
 * @param {number} theta
 * @returns {string}
 */
export function rewardWords(seen, theta) {
  const { thetas, H, open } = seen,
    h = columnAt(seen, theta);
  return open && !h ? `below ${short(thetas[1])}` : open && h === H - 1 ? `above ${short(thetas[h])}` : short(theta);
}

/**
 * Where a reward is drawn: one beyond the sensitivities in the middle of its open end.
 * @param {Bins} seen
 * @param {number} reward
 * @returns {number} in reward
 */
export function placeOf({ thetas, H, open }, reward) {
  if (open && reward < thetas[1]) return (thetas[0] + thetas[1]) / 2;
  return open && reward > thetas[H - 1] ? (thetas[H - 1] + thetas[H]) / 2 : reward;
}

/**
 * Columns from the left, with fractions; beyond the outermost the outermost goes on.
 * @param {Bins} seen
 * @param {number} theta
 * @returns {number}
 */
export function acrossOf(seen, theta) {
  const h = columnAt(seen, theta),
    { thetas } = seen;
  return h + (theta - thetas[h]) / (thetas[h + 1] - thetas[h]);
}

/**
 * The reward at so many columns from the left: the way back of `acrossOf`.
 * @param {Bins} seen
 * @param {number} across
 * @returns {number}
 */
export function thetaOf({ thetas, H }, across) {
  const h = Math.min(H - 1, Math.max(0, Math.floor(across)));
  return thetas[h] + (across - h) * (thetas[h + 1] - thetas[h]);
}

function even({ thetas, H }) {
  const step = (thetas[H] - thetas[0]) / H;
  return thetas.every((theta, h) => Math.abs(theta - thetas[0] - step * h) < 1e-3 * step);
}

/**
 * Labels of a range: evenly stepped where columns are, else 0 and powers of ten first, and others where they have
 * room.
 * @param {Bins} seen
 * @param {Range} range - in reward
 * @param {number} width - in pixels
 * @returns {number[]} in reward
 */
export function thetaTicks(seen, [first, last], width) {
  const { thetas, H, open } = seen,
    low = open ? Math.max(first, thetas[1]) : first,
    high = open ? Math.min(last, thetas[H - 1]) : last;
  if (low >= high) return [];
  if (even(seen)) return ticks(low, high);
  const most = Math.ceil(Math.log10(Math.max(-low, high))),
    powers = Array.from({ length: 7 }, (_, i) => 10 ** (most - i));
  const [left, right] = [first, last].map((theta) => acrossOf(seen, theta)),
    found = [];
  const place = (theta) => (width * (acrossOf(seen, theta) - left)) / (right - left);
  const wished = [
    0,
    ...[1, 5, 2].flatMap((n) => powers.flatMap((power) => [n * power, -n * power])),
    ...ticks(low, high),
  ];
  for (const theta of wished) {
    const apart = found.every((other) => Math.abs(place(other) - place(theta)) >= APART);
    if (theta >= low && theta <= high && apart) found.push(theta);
  }
  return found;
}
