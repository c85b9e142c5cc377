// What the pictures of the lens have in common: their box, their title, the mark of what is pointed at.
export const GHOST = { width: 1.2, dash: [7, 3] }; // the view pinned as A
export const inside = (w, h, { left = 46, right = 10, top = 28, bottom = 34 } = {}) => ({
  x: left,
  y: top,
  w: w - left - right,
  h: h - top - bottom,
});

// A title and a note: beside it where there is room, else under it, where `under` says so.
export function titled(pen, w, words, note, { colours }, under = true) {
  pen.text(words, 2, 15, { size: 14, weight: 600, colour: colours.text });
  if (!note) return;
  const beside = pen.width(words, 14, 600) + pen.width(note, 11) + 14 < w;
  if (beside || under)
    pen.text(note, w - 4, beside ? 15 : 26, { size: beside ? 11 : 10.5, align: 'right', colour: colours.soft });
}

export function marked(pen, { box, X, Y }, { x, y }, colours) {
  // where the other panels point to
  const lines = [];
  if (X(x) >= box.x && X(x) <= box.x + box.w)
    lines.push([
      [X(x), box.y],
      [X(x), box.y + box.h],
    ]);
  if (Y(y) >= box.y && Y(y) <= box.y + box.h)
    lines.push([
      [box.x, Y(y)],
      [box.x + box.w, Y(y)],
    ]);
  for (const each of lines) {
    pen.path(each, { stroke: colours.halo, width: 3 });
    pen.path(each, { stroke: colours.mark, width: 1.2 });
  }
}

export const top = (values) => values.reduce((a, b) => Math.max(a, b), 0);

// Below this a value is nothing beside the rewards of the world, and an axis should not blow it up.
export const leastSpan = ({ arrays }) =>
  arrays.rewards ? 0.05 * Math.max(1e-9, ...arrays.rewards.map(Math.abs)) : 1e-3;

export const disc = (x, y, r) =>
  Array.from({ length: 13 }, (_, i) => [x + r * Math.cos((i * Math.PI) / 6), y + r * Math.sin((i * Math.PI) / 6)]);
