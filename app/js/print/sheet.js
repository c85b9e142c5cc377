// A sheet of panels and a caption, drawn by any pen; and the sheet as an SVG and as a PNG.
/** @import { Pen, Sheet, SvgPen } from '../types.js' */
import { PAPER } from '../draw/colours.js';
import { contextOf, escaped, painted, svgPen } from '../draw/drawing.js';
import { CAPTION, PER_MM, captionLines, layoutOf, shifted } from './layout.js';
import { leadOf, outlineOf, widthOf } from './letters.js';

const DENSE = 300 / 96; // least dots to a pixel of CSS: 300 to the inch
const MOST = 16e6; // dots of a canvas that every browser can hold

/**
 * Draws panels and their caption.
 * @param {Pen} pen
 * @param {Sheet} sheet
 * @param {((pen: Pen, w: number, h: number) => void)[]} panels
 * @param {string[]} lines - of the caption
 * @returns {void}
 */
export function drawSheet(pen, { width, height, cells, caption, left }, panels, lines) {
  pen.path(
    [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height],
    ],
    { fill: PAPER.paper, close: true },
  );
  panels.forEach((draw, i) => {
    const { x, y, w, h } = cells[i];
    pen.clip(x, y, w, h, () => draw(shifted(pen, { x, y }), w, h));
  });
  lines.forEach((line, i) =>
    pen.text(line, left, caption + i * CAPTION.line, { size: CAPTION.size, colour: PAPER.text }),
  );
}

/**
 * The sheet of some panels and its caption in lines.
 * @param {number} count
 * @param {number} mm
 * @param {string} caption
 * @returns {{ sheet: Sheet, lines: string[] }}
 */
export function sheetOf(count, mm, caption) {
  const lines = captionLines(caption, mm, widthOf);
  return { sheet: layoutOf(count, mm, lines.length), lines };
}

/**
 * An image with its cells enlarged to whole dots, 300 to the inch or more: programs that show a picture smooth what is
 * smaller.
 * @param {HTMLCanvasElement} source
 * @param {number} w - as drawn, in pixels of CSS
 * @param {number} h
 * @returns {HTMLCanvasElement}
 */
export function enlarged(source, w, h) {
  const times = (drawn, given) => Math.max(1, Math.min(Math.ceil((drawn * DENSE) / given), Math.floor(4096 / given)));
  const [across, down] = [times(w, source.width), times(h, source.height)];
  if (across === 1 && down === 1) return source;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: source.width * across, height: source.height * down });
  const context = contextOf(canvas);
  context.imageSmoothingEnabled = false;
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}

/**
 * A pen for an SVG that writes words as outlines.
 * @returns {SvgPen}
 */
export function outlinedPen() {
  const pen = svgPen('', widthOf),
    near = (value) => +value.toFixed(2);
  return {
    ...pen,
    text(words, x, y, { size = 11, weight = 400, align, colour = PAPER.text, turn } = {}) {
      const lead = leadOf(widthOf(words, size, weight), align),
        [left, base] = turn ? [x, y + lead] : [x - lead, y];
      pen.parts.push(
        `<path role="img" aria-label="${escaped(words)}" ${painted('fill', colour)} ` +
          `transform="translate(${near(left)} ${near(base)})${turn ? ' rotate(-90)' : ''} scale(${+(size / 1000).toFixed(5)})" ` +
          `d="${outlineOf(words, weight)}"/>`,
      );
    },
    image: (source, x, y, w, h) => pen.image(enlarged(source, w, h), x, y, w, h),
  };
}

/**
 * A sheet as an SVG, as wide as it is on paper.
 * @param {Sheet} sheet
 * @param {(pen: Pen) => void} draw
 * @param {{ title: string, caption: string }} about
 * @returns {string}
 */
export function svgOf({ width, height }, draw, { title, caption }) {
  const pen = outlinedPen(),
    mm = (value) => `${+(value / PER_MM).toFixed(3)}mm`;
  draw(pen);
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${mm(width)}" height="${mm(height)}" ` +
    `viewBox="0 0 ${+width.toFixed(3)} ${+height.toFixed(3)}">` +
    `<title>${escaped(title)}</title><desc>${escaped(caption)}</desc>\n${pen.parts.join('\n')}\n</svg>\n`
  );
}

/**
 * Dots to the inch of a sheet: 600, or 300 where that is more than a browser can draw.
 * @param {Pick<Sheet, 'width' | 'height'>} sheet
 * @returns {number}
 */
export const densityOf = ({ width, height }) => (width * height * (600 / 96) ** 2 <= MOST ? 600 : 300);

/**
 * An SVG as a PNG that knows its size on paper.
 * @param {string} svg
 * @param {Sheet} sheet
 * @returns {Promise<Blob>}
 */
export async function pngOf(svg, sheet) {
  const dpi = densityOf(sheet),
    address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' })),
    image = Object.assign(new Image(), { src: address });
  try {
    await image.decode();
    const canvas = document.createElement('canvas');
    Object.assign(canvas, {
      width: Math.round((sheet.width * dpi) / 96),
      height: Math.round((sheet.height * dpi) / 96),
    });
    contextOf(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = /** @type {Blob | null} */ (await new Promise((done) => canvas.toBlob(done)));
    if (!blob) throw new Error('The browser cannot draw a picture of this size: choose fewer panels, or SVG.');
    return new Blob([withDensity(new Uint8Array(await blob.arrayBuffer()), dpi)], { type: 'image/png' });
  } finally {
    URL.revokeObjectURL(address);
  }
}

/**
 * Cyclic redundancy check of a chunk of a PNG: polynomial 0xedb88320, as ISO 3309 and the PNG specification have it.
 * @param {Uint8Array} bytes
 * @returns {number}
 */
export function crcOf(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/**
 * A PNG with a chunk pHYs, which says how many dots there are to the metre; it stands behind the header, which ends
 * after 33 bytes.
 * @param {Uint8Array} png
 * @param {number} dpi
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function withDensity(png, dpi) {
  const chunk = new Uint8Array(21),
    view = new DataView(chunk.buffer),
    dots = Math.round(dpi / 0.0254);
  view.setUint32(0, 9);
  chunk.set([112, 72, 89, 115], 4); // pHYs
  view.setUint32(8, dots);
  view.setUint32(12, dots);
  chunk[16] = 1; // the unit is the metre
  view.setUint32(17, crcOf(chunk.subarray(4, 17)));
  const out = new Uint8Array(png.length + chunk.length);
  out.set(png.subarray(0, 33));
  out.set(chunk, 33);
  out.set(png.subarray(33), 54);
  return out;
}
