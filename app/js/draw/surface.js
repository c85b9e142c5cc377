// A space as a surface: a mesh seen from a camera that only the hand moves, drawn from the back to the front.
/** @import { Box, Camera, Colours, Pen, Range } from '../types.js' */
import { NEUTRAL, heatColour, short } from './drawing.js';

const MOST = 46; // cells a side; larger spaces keep the largest value of each cell

function thinned(values, n, width) {
  const rows = Math.min(n, MOST),
    columns = Math.min(width, MOST * 2),
    out = new Float64Array(rows * columns);
  for (let k = 0; k < n; k++) {
    for (let h = 0; h < width; h++) {
      const at = Math.floor((k * rows) / n) * columns + Math.floor((h * columns) / width),
        value = values[k * width + h];
      if (Math.abs(value) > Math.abs(out[at])) out[at] = value;
    }
  }
  return { out, rows, columns };
}

/**
 * Draws a space as a surface.
 * @param {Pen} pen
 * @param {Box} box
 * @param {{ values: Float64Array, n: number, width: number, limit: number, x: (number | string)[][], y: Range, titles:
 *   string[], truth?: any[][] }} space - values (n, width), the value at the top of the scale, labels across at places
 *   from 0 to 1, low and high end along, titles of both, and true rows, (width,) each, with their heights from 0 to 1
 * @param {Camera} camera
 * @param {Colours} colours
 * @returns {void}
 */
export function drawSurface(pen, box, space, camera, colours) {
  const { out, rows, columns } = thinned(space.values, space.n, space.width),
    { turn, tilt } = camera;
  const [c, s, up, flat] = [Math.cos(turn), Math.sin(turn), Math.sin(tilt), Math.cos(tilt)],
    TALL = 0.55;
  const spread = Math.abs(c) + Math.abs(s),
    wide = (box.w * 0.84) / spread,
    tall = Math.min(wide, (box.h * 0.86) / (spread * up + TALL * flat));
  const place = (u, v, z) => {
    // u across theta, v up the rows, both in 0..1; z in limits
    const x = (u - 0.5) * c - (v - 0.5) * s,
      y = (u - 0.5) * s + (v - 0.5) * c;
    return [
      box.x + box.w / 2 + x * wide,
      box.y + box.h - 12 - tall * (spread * up * 0.5 + y * up + Math.max(-0.3, Math.min(1.2, z)) * TALL * flat),
    ];
  };
  const point = (i, k) =>
    place(i / Math.max(1, columns - 1), rows > 1 ? k / (rows - 1) : 0.5, out[k * columns + i] / space.limit);
  const edge = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
    [0, 0],
  ].map(([u, v]) => place(u, v, 0));
  pen.path(edge, { stroke: NEUTRAL, width: 1, fill: heatColour(0, 1), close: true });
  const across = [...Array(Math.max(1, columns - 1)).keys()],
    along = [...Array(Math.max(1, rows - 1)).keys()];
  if (s > 0) across.reverse();
  if (c > 0) along.reverse();
  for (const k of along) {
    for (const i of across) {
      const next = Math.min(rows - 1, k + 1),
        corners = [point(i, k), point(i + 1, k), point(i + 1, next), point(i, next)];
      const value =
        (out[k * columns + i] + out[next * columns + i + 1] + out[k * columns + i + 1] + out[next * columns + i]) / 4;
      const colour = heatColour(value, space.limit);
      pen.path(
        rows === 1
          ? [place(i / (columns - 1), 0.5, 0), corners[0], corners[1], place((i + 1) / (columns - 1), 0.5, 0)]
          : corners,
        { fill: colour, stroke: colour, width: 0.6, close: true },
      );
    }
  }
  for (const [v, row] of space.truth ?? []) {
    // the truth floats on the surface
    pen.path(
      Array.from(row, (value, h) => place(h / (row.length - 1), v, value / space.limit)).filter(
        (_, h) => row[h] > 1e-3 * space.limit,
      ),
      { stroke: '#ff7f0e', width: 1.6 },
    );
  }
  const label = (words, u, v, bold, aside = 0) => {
    const [x, y] = place(u, v, 0);
    pen.text(words, x + aside, y + 14, {
      size: bold ? 11 : 10,
      align: 'center',
      colour: bold ? colours.text : colours.soft,
    });
  };
  for (const [u, words] of space.x) label(words, u, -0.06);
  label(space.titles[0], 0.5, -0.2, true);
  label(short(space.y[0]), 1.06, 0, false, 10);
  label(short(space.y[1]), 1.06, 1);
  label(space.titles[1], 1.07, 0.5, true);
}
