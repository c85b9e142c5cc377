// Tools to draw with: pens that draw on a canvas or write an SVG, axes, colours, heat. Knows no lens.
/** @import { Axes, Box, Colours, LineStyle, Pen, Range, Scale, SvgPen } from '../types.js' */
import { inkOf } from './colours.js';

const ACTIONS = ['#0072B2', '#E69F00', '#009E73', '#D55E00', '#CC79A7', '#56B4E9', '#8B46FF', '#7A5C28'];

/**
 * The colour of an action.
 * @param {number} a
 * @returns {string} as CSS
 */
export const actionColour = (a) => ACTIONS[a % ACTIONS.length];
export const NEUTRAL = '#8a8f98',
  GRID = 'rgba(138,143,152,0.28)',
  UNDER = 0.25; // share of the limit drawn below zero
const VIRIDIS = ['#440154', '#472d7b', '#3b528b', '#2c728e', '#21918c', '#28ae80', '#5ec962', '#addc30', '#fde725'];

// ---- pens: path, text, image, clip

/**
 * A canvas as large as it is on the page, cleared, and a pen for it; nothing while it is not shown.
 * @param {HTMLCanvasElement} canvas
 * @param {string} font - a family
 * @returns {{ pen: Pen, width: number, height: number } | undefined}
 */
export function sheet(canvas, font) {
  const width = canvas.clientWidth,
    height = canvas.clientHeight,
    dense = Math.min(2, devicePixelRatio);
  if (!width) return undefined;
  const size = { width: Math.round(width * dense), height: Math.round(height * dense) };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  const context = contextOf(canvas);
  context.setTransform(dense, 0, 0, dense, 0, 0);
  context.clearRect(0, 0, width, height);
  return { pen: canvasPen(context, font), width, height };
}

/**
 * What draws on a canvas.
 * @param {HTMLCanvasElement} canvas
 * @returns {CanvasRenderingContext2D}
 */
export const contextOf = (canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));

/**
 * A pen that draws on a canvas.
 * @param {CanvasRenderingContext2D} context
 * @param {string} font - a family
 * @returns {Pen}
 */
export function canvasPen(context, font) {
  return {
    path(points, { stroke, width = 1, dash = [], fill, close } = {}) {
      context.beginPath();
      let down = false;
      for (const point of points) {
        if (!point) down = false;
        else if (down) context.lineTo(point[0], point[1]);
        else {
          context.moveTo(point[0], point[1]);
          down = true;
        }
      }
      if (close) context.closePath();
      if (fill) {
        context.fillStyle = fill;
        context.fill();
      }
      if (!stroke) return;
      Object.assign(context, { strokeStyle: stroke, lineWidth: width, lineJoin: 'round' });
      context.setLineDash(dash);
      context.stroke();
    },
    text(words, x, y, { size = 11, weight = 400, align = 'left', colour, turn } = {}) {
      Object.assign(context, {
        font: `${weight} ${size}px ${font}`,
        textAlign: align,
        fillStyle: colour,
        textBaseline: 'alphabetic',
      });
      if (!turn) {
        context.fillText(words, x, y);
        return;
      }
      context.save();
      context.translate(x, y);
      context.rotate(-Math.PI / 2);
      context.fillText(words, 0, 0);
      context.restore();
    },
    image(source, x, y, w, h) {
      context.imageSmoothingEnabled = false;
      context.drawImage(source, x, y, w, h);
    },
    clip(x, y, w, h, draw) {
      context.save();
      context.beginPath();
      context.rect(x, y, w, h);
      context.clip();
      draw();
      context.restore();
    },
    width: (words, size, weight = 400) => {
      context.font = `${weight} ${size}px ${font}`;
      return context.measureText(words).width;
    },
  };
}

/**
 * Words as they may stand in XML.
 * @param {unknown} words
 * @returns {string}
 */
export const escaped = (words) =>
  String(words).replace(/[&<>"]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[sign]);

/**
 * An attribute of SVG 1.1, which knows no rgba().
 * @param {'fill' | 'stroke'} name
 * @param {string} colour
 * @returns {string}
 */
export function painted(name, colour) {
  if (!colour.startsWith('rgba(')) return `${name}="${colour}"`;
  const { hex, alpha } = inkOf(colour);
  return `${name}="${hex}" ${name}-opacity="${alpha}"`;
}

/**
 * A pen that writes an SVG.
 * @param {string} font - a family
 * @param {Pen['width']} measure
 * @returns {SvgPen}
 */
export function svgPen(font, measure) {
  const parts = [],
    short = (value) => +value.toFixed(2);
  let clips = 0;
  return {
    parts,
    path(points, { stroke = 'none', width = 1, dash = [], fill = 'none', close } = {}) {
      let d = '',
        down = false;
      for (const point of points) {
        if (point) d += `${down ? 'L' : 'M'}${short(point[0])} ${short(point[1])}`;
        down = Boolean(point);
      }
      parts.push(
        `<path d="${d}${close ? 'Z' : ''}" ${painted('fill', fill)} ${painted('stroke', stroke)} ` +
          `stroke-width="${width}" stroke-dasharray="${dash}" stroke-linejoin="round"/>`,
      );
    },
    text(words, x, y, { size = 11, weight = 400, align = 'left', colour, turn } = {}) {
      const anchor = { left: 'start', center: 'middle', right: 'end' }[align];
      const place = turn
        ? `transform="translate(${short(x)} ${short(y)}) rotate(-90)"`
        : `x="${short(x)}" y="${short(y)}"`;
      parts.push(
        `<text ${place} font-family="${escaped(font)}" font-size="${size}" font-weight="${weight}" ` +
          `text-anchor="${anchor}" fill="${colour}">${escaped(words)}</text>`,
      );
    },
    image(source, x, y, w, h) {
      parts.push(
        `<image href="${source.toDataURL()}" x="${short(x)}" y="${short(y)}" width="${short(w)}" ` +
          `height="${short(h)}" preserveAspectRatio="none"` +
          `${source.width < w || source.height < h ? ' style="image-rendering:pixelated"' : ''}/>`,
      );
    },
    clip(x, y, w, h, draw) {
      const name = `clip${clips++}`;
      parts.push(
        `<clipPath id="${name}"><rect x="${x}" y="${y}" width="${w}" height="${h}"/></clipPath>` +
          `<g clip-path="url(#${name})">`,
      );
      draw();
      parts.push('</g>');
    },
    width: measure,
  };
}

// ---- axes

// The smallest round number that divides a range into about `count` parts or fewer.
function stepOf(low, high, count) {
  const rough = (high - low) / count || 1,
    ten = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5].map((n) => n * ten).find((size) => size >= rough * 0.999) ?? 10 * ten;
}

/**
 * Ticks of a linear axis: at most about `count`, at round numbers, inside the range.
 * @param {number} low
 * @param {number} high
 * @param {number} [count]
 * @returns {number[]}
 */
export function ticks(low, high, count = 5) {
  const step = stepOf(low, high, count),
    first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, i) => (first + i) * step);
}

/**
 * A range that holds the values and ends at round numbers, so that it moves in steps.
 * @param {number} low
 * @param {number} high
 * @param {number} [least] - below this the range is widened
 * @returns {Range}
 */
export function rounded(low, high, least = 1e-9) {
  if (!(high - low > least)) {
    low -= 0.5 * least || 0.5;
    high += 0.5 * least || 0.5;
  }
  const step = stepOf(low, high, 4);
  return [Math.floor(low / step + 1e-6) * step, Math.ceil(high / step - 1e-6) * step];
}

/**
 * A number in few digits, or a dash where there is none.
 * @param {number} value
 * @param {number} [digits]
 * @returns {string}
 */
export const short = (value, digits = 3) => {
  if (!Number.isFinite(value)) return '–';
  const found = +value.toPrecision(digits) || 0; // never a negative zero
  return found && Math.abs(found) < 1e-4 ? found.toExponential().replace('e-0', 'e-') : String(found);
};

/**
 * Draws frame and labels of one box.
 * @param {Pen} pen
 * @param {Box} box
 * @param {Axes} axes
 * @returns {Scale}
 */
export function axes(
  pen,
  box,
  { x, y, across = [Number, Number], xTicks, yTicks, xTitle, yTitle, colours, grid = true },
) {
  const [to, from] = across,
    [left, right] = x.map(to);
  const X = (value) => box.x + ((to(value) - left) / (right - left)) * box.w;
  const Y = (value) => box.y + box.h - ((value - y[0]) / (y[1] - y[0])) * box.h;
  const named = (list) => list.map((tick) => (Array.isArray(tick) ? tick : [tick, short(tick)]));
  for (const [value, words] of named(yTicks ?? ticks(y[0], y[1]))) {
    if (grid)
      pen.path(
        [
          [box.x, Y(value)],
          [box.x + box.w, Y(value)],
        ],
        { stroke: GRID },
      );
    pen.text(words, box.x - 5, Y(value) + 4, { align: 'right', colour: colours.soft, size: 10.5 });
  }
  for (const [value, words] of named(xTicks ?? ticks(x[0], x[1]))) {
    if (grid)
      pen.path(
        [
          [X(value), box.y],
          [X(value), box.y + box.h],
        ],
        { stroke: GRID },
      );
    pen.text(words, X(value), box.y + box.h + 13, { align: 'center', colour: colours.soft, size: 10.5 });
  }
  if (xTitle) {
    // in a narrow picture it ends with the axis, so that neither its edge nor its neighbour cuts it
    const fits = pen.width(xTitle, 11) <= box.w + 6;
    pen.text(xTitle, box.x + box.w / (fits ? 2 : 1), box.y + box.h + 27, {
      align: fits ? 'center' : 'right',
      colour: colours.soft,
      size: fits ? 11 : 10,
    });
  }
  if (yTitle)
    pen.text(yTitle, box.x - 36, box.y + box.h / 2, { align: 'center', colour: colours.soft, size: 11, turn: true });
  return {
    X,
    Y,
    x,
    y,
    box,
    toX: (px) => from(left + ((px - box.x) / box.w) * (right - left)),
    toY: (py) => y[0] + ((box.y + box.h - py) / box.h) * (y[1] - y[0]),
  };
}

/**
 * About six labelled rows, evenly spaced; rows are drawn at equal heights whatever they stand for.
 * @param {Float64Array} labels - what each row stands for
 * @param {Range} range - of rows
 * @returns {(number | string)[][]} rows and their labels
 */
export function rowTicks(labels, [low, high]) {
  const stride = [1, 2, 5, 10, 20, 50, 100, 200].find((n) => (high - low) / n <= 8) ?? 500;
  return Array.from({ length: Math.ceil(labels.length / stride) }, (_, i) => [
    i * stride,
    short(labels[i * stride]),
  ]).filter(([row]) => +row >= low && +row <= high);
}

/**
 * Draws a line through points, interrupted where a value is not finite.
 * @param {Pen} pen
 * @param {ArrayLike<number>} xs - in pixels
 * @param {ArrayLike<number>} ys - in pixels
 * @param {LineStyle} style
 * @returns {void}
 */
export const line = (pen, xs, ys, style) =>
  pen.path(
    Array.from(ys, (y, i) => (Number.isFinite(y) ? [xs[i], y] : null)),
    style,
  );

// ---- heat

const channelsOf = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));

// 512 colours from -UNDER to 1: magenta below zero, viridis above. The lightness of viridis grows from zero to the top; what
// is below zero stays far darker than the top, and is blue where that is yellow to eyes without the green cones.
const SCALE = (() => {
  const zero = UNDER / (1 + UNDER),
    /** @type {[number, string][]} */
    stops = [
      [0, '#d63af9'],
      [0.75 * zero, '#a01090'],
      ...VIRIDIS.map(
        (colour, i) => /** @type {[number, string]} */ ([zero + ((1 - zero) * i) / (VIRIDIS.length - 1), colour]),
      ),
    ];
  return Uint32Array.from({ length: 512 }, (_, i) => {
    const at = i / 511,
      next = Math.max(
        1,
        stops.findIndex(([stop]) => stop >= at),
      );
    const [[a, from], [b, to]] = [stops[next - 1], stops[next]],
      share = (at - a) / (b - a);
    const [red, green, blue] = channelsOf(from).map((low, c) => Math.round(low + share * (channelsOf(to)[c] - low)));
    return (255 << 24) | (blue << 16) | (green << 8) | red;
  });
})();

/**
 * The place of a value on the colour scale.
 * @param {number} value
 * @param {number} limit - the value at the top of the scale
 * @returns {number} from 0 to 511
 */
export const heatIndex = (value, limit) =>
  Math.min(511, Math.max(0, Math.round(((value / limit + UNDER) / (1 + UNDER)) * 511)));

/**
 * The colour of a value.
 * @param {number} value
 * @param {number} limit - the value at the top of the scale
 * @returns {string} as CSS
 */
export const heatColour = (value, limit) => {
  const word = SCALE[heatIndex(value, limit)];
  return `rgb(${word & 255},${(word >> 8) & 255},${(word >> 16) & 255})`;
};

/**
 * Draws a picture of values, a pixel each, the first row at the bottom.
 * @param {HTMLCanvasElement} canvas
 * @param {Float64Array} values - (n, width)
 * @param {number} n
 * @param {number} width
 * @param {number} limit - the value at the top of the scale
 * @returns {HTMLCanvasElement} the canvas
 */
export function heatmap(canvas, values, n, width, limit) {
  canvas.width = width;
  canvas.height = n;
  const context = contextOf(canvas),
    image = context.createImageData(width, n),
    words = new Uint32Array(image.data.buffer);
  const factor = 511 / (limit * (1 + UNDER)),
    zero = (511 * UNDER) / (1 + UNDER) + 0.5;
  for (let k = 0; k < n; k++) {
    for (let x = 0, at = (n - 1 - k) * width; x < width; x++, at++) {
      const index = (values[k * width + x] * factor + zero) | 0;
      words[at] = SCALE[index < 0 ? 0 : index > 511 ? 511 : index];
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

/**
 * Draws the colour scale with its labels.
 * @param {Pen} pen
 * @param {HTMLCanvasElement} canvas - where the scale is kept
 * @param {Box} box
 * @param {number} limit - the value at the top of the scale
 * @param {Pick<Colours, 'soft'>} colours
 * @returns {void}
 */
export function colourBar(pen, canvas, box, limit, colours) {
  if (!canvas.height || canvas.height !== 128)
    heatmap(
      canvas,
      Float64Array.from({ length: 128 }, (_, i) => -UNDER + (i / 127) * (1 + UNDER)),
      128,
      1,
      1,
    );
  pen.image(canvas, box.x, box.y, box.w, box.h);
  for (const value of [0, limit]) {
    const y = box.y + box.h * (1 - (value / limit + UNDER) / (1 + UNDER));
    pen.text(short(value, 2), box.x + box.w + 3, y + (value ? 9 : 3), { size: 9.5, colour: colours.soft });
  }
}
