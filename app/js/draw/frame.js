// What the pictures of the lens have in common: their box, their title, the mark under the pointer.
/** @import { Box, Colours, Model, Path, Pen, Scale, Scene } from '../types.js' */
const HELP = 22; // pixels of the button beside a title
export const GHOST = { width: 1.2, dash: [7, 3] }; // the view pinned as A

/**
 * The box that margins leave of a picture, in pixels.
 * @param {number} w
 * @param {number} h
 * @param {{ left?: number, right?: number, top?: number, bottom?: number }} [margins]
 * @returns {Box}
 */
export const inside = (w, h, { left = 46, right = 10, top = 31, bottom = 34 } = {}) => ({
  x: left,
  y: top,
  w: w - left - right,
  h: h - top - bottom,
});

/**
 * Writes a title and a note: beside it where there is room, else under it, where `under` says so. The corner stays free
 * for the button of the help. In a narrow picture the title is smaller, and a note that would run into the labels of the axis is left out.
 * @param {Pen} pen
 * @param {number} w - width of the picture
 * @param {string} words
 * @param {string} note
 * @param {Pick<Scene, 'colours'>} scene
 * @param {boolean} [under]
 * @returns {void}
 */
export function titled(pen, w, words, note, { colours }, under = true) {
  const end = w - HELP,
    full = pen.width(words, 14, 600),
    size = 14 * Math.min(1, (end - 4) / full);
  pen.text(words, 2, 15, { size, weight: 600, colour: colours.text });
  if (!note) return;
  const beside = full + pen.width(note, 11) + 14 < end;
  if (beside || (under && pen.width(note, 10.5) < w - 50))
    pen.text(note, beside ? end - 4 : w - 4, beside ? 15 : 26, {
      size: beside ? 11 : 10.5,
      align: 'right',
      colour: colours.soft,
    });
}

/**
 * Marks where the other panels point to.
 * @param {Pen} pen
 * @param {Scale} scale
 * @param {{ x?: number, y?: number }} place - in the units of the axes
 * @param {Colours} colours
 * @returns {void}
 */
export function marked(pen, { box, X, Y }, { x, y }, colours) {
  const across = x === undefined ? NaN : X(x),
    up = y === undefined ? NaN : Y(y),
    lines = [];
  if (across >= box.x && across <= box.x + box.w)
    lines.push([
      [across, box.y],
      [across, box.y + box.h],
    ]);
  if (up >= box.y && up <= box.y + box.h)
    lines.push([
      [box.x, up],
      [box.x + box.w, up],
    ]);
  for (const each of lines) {
    pen.path(each, { stroke: colours.halo, width: 3 });
    pen.path(each, { stroke: colours.mark, width: 1.2 });
  }
}

/**
 * The largest of the values, and at least 0.
 * @param {{ reduce(larger: (a: number, b: number) => number, first: number): number }} values
 * @returns {number}
 */
export const top = (values) => values.reduce((a, b) => Math.max(a, b), 0);

/**
 * Below this a value is nothing beside the rewards of the world, and an axis should not blow it up.
 * @param {Model} model
 * @returns {number} in reward
 */
export const leastSpan = ({ arrays }) =>
  arrays.rewards ? 0.05 * Math.max(1e-9, ...arrays.rewards.map(Math.abs)) : 1e-3;

// Of actions, so that their lines differ without their colours: disc, square, triangle, diamond.
const SHAPES = [
  { corners: 12, turn: 0, size: 1 },
  { corners: 4, turn: Math.PI / 4, size: 1.2 },
  { corners: 3, turn: -Math.PI / 2, size: 1.4 },
  { corners: 4, turn: 0, size: 1.4 },
];

/**
 * Corners of the mark of an action: four shapes, and again from the fifth action on.
 * @param {number} a
 * @param {number} x
 * @param {number} y
 * @param {number} r
 * @returns {Path}
 */
export function markOf(a, x, y, r) {
  const { corners, turn, size } = SHAPES[a % SHAPES.length];
  return Array.from({ length: corners }, (_, i) => {
    const angle = turn + (2 * Math.PI * i) / corners;
    return [x + size * r * Math.cos(angle), y + size * r * Math.sin(angle)];
  });
}

/**
 * Corners of a disc.
 * @param {number} x
 * @param {number} y
 * @param {number} r
 * @returns {Path}
 */
export const disc = (x, y, r) =>
  Array.from({ length: 13 }, (_, i) => [x + r * Math.cos((i * Math.PI) / 6), y + r * Math.sin((i * Math.PI) / 6)]);
