// The theta axis of the spaces: all columns are equally wide, as all rows are equally high, whatever they stand for. So
// sensitivities that are close together around reward 0 and far apart at +-100 can all be seen.
import { ticks } from './drawing.js';

const APART = 34; // pixels between two labels

export function columnAt({ thetas, H }, theta) { // the column that holds theta
  let low = 0, high = H - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (thetas[middle] <= theta) low = middle; else high = middle - 1;
  }
  return low;
}

// Columns from the left, with fractions, and back; beyond the outermost the outermost goes on.
export function acrossOf(seen, theta) {
  const h = columnAt(seen, theta), { thetas } = seen;
  return h + (theta - thetas[h]) / (thetas[h + 1] - thetas[h]);
}

export function thetaOf({ thetas, H }, across) {
  const h = Math.min(H - 1, Math.max(0, Math.floor(across)));
  return thetas[h] + (across - h) * (thetas[h + 1] - thetas[h]);
}

function even({ thetas, H }) {
  const step = (thetas[H] - thetas[0]) / H;
  return thetas.every((theta, h) => Math.abs(theta - thetas[0] - step * h) < 1e-3 * step);
}

// Labels of a range: evenly stepped where columns are, else 0 and powers of ten first, and others where they have room.
export function thetaTicks(seen, [low, high], width) {
  if (even(seen)) return ticks(low, high);
  const most = Math.ceil(Math.log10(Math.max(-low, high))), powers = Array.from({ length: 7 }, (_, i) => 10 ** (most - i));
  const [left, right] = [low, high].map((theta) => acrossOf(seen, theta)), found = [];
  const place = (theta) => (width * (acrossOf(seen, theta) - left)) / (right - left);
  const wished = [0, ...[1, 5, 2].flatMap((n) => powers.flatMap((power) => [n * power, -n * power])), ...ticks(low, high)];
  for (const theta of wished) {
    const apart = found.every((other) => Math.abs(place(other) - place(theta)) >= APART);
    if (theta >= low && theta <= high && apart) found.push(theta);
  }
  return found;
}
