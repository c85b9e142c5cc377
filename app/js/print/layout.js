// Where the panels and the caption of a printed sheet lie. Places are in CSS pixels, 96 to the inch, so that letters of
// 10 px are letters of 7.5 pt on paper.
/** @import { Box, Pen, Sheet } from '../types.js' */

export const PER_MM = 96 / 25.4;
export const WIDTHS = [85, 180]; // mm: one column and two columns of a journal
const EDGE = 4,
  GAP = 14;
export const CAPTION = { size: 10, line: 13.5, before: 10 };

/**
 * The size of a sheet and the places of its panels. The last row of two columns has one panel in its middle where their
 * number is odd, so that there is no hole.
 * @param {number} count - of panels
 * @param {number} mm - width of the sheet
 * @param {number} lines - of the caption
 * @returns {Sheet}
 */
export function layoutOf(count, mm, lines) {
  const width = mm * PER_MM,
    columns = mm > 100 && count > 1 ? 2 : 1,
    rows = Math.ceil(count / columns);
  const inner = width - 2 * EDGE,
    w = (inner - (columns - 1) * GAP) / columns,
    h = w * (w > 400 ? 0.5 : 0.66);
  const cells = Array.from({ length: count }, (_, i) => {
    const row = Math.floor(i / columns),
      filled = Math.min(columns, count - row * columns),
      first = EDGE + (inner - filled * w - (filled - 1) * GAP) / 2;
    return { x: first + (i % columns) * (w + GAP), y: EDGE + row * (h + GAP), w, h };
  });
  const caption = EDGE + rows * h + (rows - 1) * GAP + CAPTION.before + CAPTION.size;
  return {
    width,
    height: caption + (lines - 1) * CAPTION.line + CAPTION.size * 0.3 + EDGE,
    cells,
    caption,
    left: EDGE,
  };
}

/**
 * Words in lines that fit; a word that is too long for a line is broken.
 * @param {string} words
 * @param {number} width
 * @param {(words: string) => number} measure
 * @returns {string[]}
 */
export function wrapped(words, width, measure) {
  const lines = [''];
  for (const word of words.split(' ')) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim();
    if (measure(longer) <= width) {
      lines[lines.length - 1] = longer;
      continue;
    }
    if (lines[lines.length - 1]) lines.push('');
    for (const sign of word) {
      const last = lines[lines.length - 1];
      if (last && measure(last + sign) > width) lines.push(sign);
      else lines[lines.length - 1] = last + sign;
    }
  }
  return lines;
}

/**
 * Lines of a caption on a sheet of a width.
 * @param {string} words
 * @param {number} mm
 * @param {Pen['width']} measure
 * @returns {string[]}
 */
export const captionLines = (words, mm, measure) =>
  wrapped(words, mm * PER_MM - 2 * EDGE, (line) => measure(line, CAPTION.size));

/**
 * Words with a true minus before a number.
 * @param {string} words
 * @returns {string}
 */
export const typeset = (words) => String(words).replace(/(^|[\s(])-(?=[\d.])/g, '$1−');

/**
 * A pen whose 0 lies elsewhere, and that typesets its words.
 * @param {Pen} pen
 * @param {Pick<Box, 'x' | 'y'>} origin
 * @returns {Pen}
 */
export const shifted = (pen, { x: left, y: top }) => ({
  path: (points, style) =>
    pen.path(
      points.map((point) => point && [point[0] + left, point[1] + top]),
      style,
    ),
  text: (words, x, y, style) => pen.text(typeset(words), x + left, y + top, style),
  image: (source, x, y, w, h) => pen.image(source, x + left, y + top, w, h),
  clip: (x, y, w, h, draw) => pen.clip(x + left, y + top, w, h, draw),
  width: (words, ...style) => pen.width(typeset(words), ...style),
});
