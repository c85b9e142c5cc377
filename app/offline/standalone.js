var __defProp = Object.defineProperty;
var __getOwnPropNames = Object.getOwnPropertyNames;
var __esm = (fn, res, err) => function __init() {
  if (err) throw err[0];
  try {
    return fn && (res = (0, fn[__getOwnPropNames(fn)[0]])(fn = 0)), res;
  } catch (e) {
    throw err = [e], e;
  }
};
var __export = (target, all) => {
  for (var name in all)
    __defProp(target, name, { get: all[name], enumerable: true });
};

// app/js/draw/elements.js
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made[name] = value;
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== void 0) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}
var init_elements = __esm({
  "app/js/draw/elements.js"() {
  }
});

// app/js/draw/colours.js
function inkOf(colour) {
  if (/^#[0-9a-f]{6}$/i.test(colour)) return { hex: colour, alpha: 1 };
  if (/^#[0-9a-f]{3}$/i.test(colour)) return { hex: colour.replace(/[0-9a-f]/gi, "$&$&"), alpha: 1 };
  const [red, green, blue, alpha = 1] = (colour.match(/[\d.]+/g) ?? []).map(Number);
  if (!/^rgba?\(/.test(colour) || blue === void 0) throw new Error(`${colour} is no colour that can be printed`);
  return { hex: `#${[red, green, blue].map((each) => each.toString(16).padStart(2, "0")).join("")}`, alpha };
}
function coloursOf(host) {
  const style = getComputedStyle(host), named = (name, other) => style.getPropertyValue(name).trim() || other;
  const text = style.color, primary = named("--st-primary-color", "#0b7285"), paper = named("--st-background-color", "#ffffff");
  const light = (text.match(/\d+/g) ?? ["0"]).slice(0, 3).reduce((a, b) => a + +b, 0) > 382;
  return {
    text,
    primary,
    paper,
    font: style.fontFamily,
    ...shadesFor(light)
  };
}
var shadesFor, PAPER;
var init_colours = __esm({
  "app/js/draw/colours.js"() {
    shadesFor = (light) => ({
      soft: light ? "#a9b1ba" : "#5b636d",
      wash: light ? "rgba(59,201,219,0.22)" : "rgba(11,114,133,0.16)",
      mark: light ? "#ffffff" : "#000000",
      halo: light ? "rgba(0,0,0,0.65)" : "rgba(255,255,255,0.75)",
      empty: light ? "#1b2026" : "#eceff2"
    });
    PAPER = { text: "#1d2127", primary: "#0b7285", paper: "#ffffff", font: "sans-serif", ...shadesFor(false) };
  }
});

// app/js/draw/drawing.js
function sheet(canvas, font) {
  const width = canvas.clientWidth, height = canvas.clientHeight, dense = Math.min(2, devicePixelRatio);
  if (!width) return void 0;
  const size = { width: Math.round(width * dense), height: Math.round(height * dense) };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  const context = contextOf(canvas);
  context.setTransform(dense, 0, 0, dense, 0, 0);
  context.clearRect(0, 0, width, height);
  return { pen: canvasPen(context, font), width, height };
}
function canvasPen(context, font) {
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
      Object.assign(context, { strokeStyle: stroke, lineWidth: width, lineJoin: "round" });
      context.setLineDash(dash);
      context.stroke();
    },
    text(words, x, y, { size = 11, weight = 400, align = "left", colour, turn } = {}) {
      Object.assign(context, {
        font: `${weight} ${size}px ${font}`,
        textAlign: align,
        fillStyle: colour,
        textBaseline: "alphabetic"
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
    }
  };
}
function painted(name, colour) {
  if (!colour.startsWith("rgba(")) return `${name}="${colour}"`;
  const { hex, alpha } = inkOf(colour);
  return `${name}="${hex}" ${name}-opacity="${alpha}"`;
}
function svgPen(font, measure) {
  const parts = [], short2 = (value) => +value.toFixed(2);
  let clips = 0;
  return {
    parts,
    path(points, { stroke = "none", width = 1, dash = [], fill = "none", close } = {}) {
      let d = "", down = false;
      for (const point of points) {
        if (point) d += `${down ? "L" : "M"}${short2(point[0])} ${short2(point[1])}`;
        down = Boolean(point);
      }
      parts.push(
        `<path d="${d}${close ? "Z" : ""}" ${painted("fill", fill)} ${painted("stroke", stroke)} stroke-width="${width}" stroke-dasharray="${dash}" stroke-linejoin="round"/>`
      );
    },
    text(words, x, y, { size = 11, weight = 400, align = "left", colour, turn } = {}) {
      const anchor = { left: "start", center: "middle", right: "end" }[align];
      const place2 = turn ? `transform="translate(${short2(x)} ${short2(y)}) rotate(-90)"` : `x="${short2(x)}" y="${short2(y)}"`;
      parts.push(
        `<text ${place2} font-family="${escaped(font)}" font-size="${size}" font-weight="${weight}" text-anchor="${anchor}" fill="${colour}">${escaped(words)}</text>`
      );
    },
    image(source, x, y, w, h) {
      parts.push(
        `<image href="${source.toDataURL()}" x="${short2(x)}" y="${short2(y)}" width="${short2(w)}" height="${short2(h)}" preserveAspectRatio="none"${source.width < w || source.height < h ? ' style="image-rendering:pixelated"' : ""}/>`
      );
    },
    clip(x, y, w, h, draw) {
      const name = `clip${clips++}`;
      parts.push(
        `<clipPath id="${name}"><rect x="${x}" y="${y}" width="${w}" height="${h}"/></clipPath><g clip-path="url(#${name})">`
      );
      draw();
      parts.push("</g>");
    },
    width: measure
  };
}
function stepOf(low, high, count) {
  const rough = (high - low) / count || 1, ten = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5].map((n) => n * ten).find((size) => size >= rough * 0.999) ?? 10 * ten;
}
function ticks(low, high, count = 5) {
  const step = stepOf(low, high, count), first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, i) => (first + i) * step);
}
function rounded(low, high, least = 1e-9) {
  if (!(high - low > least)) {
    low -= 0.5 * least || 0.5;
    high += 0.5 * least || 0.5;
  }
  const step = stepOf(low, high, 4);
  return [Math.floor(low / step + 1e-6) * step, Math.ceil(high / step - 1e-6) * step];
}
function axes(pen, box, { x, y, across = [Number, Number], xTicks, yTicks, xTitle, yTitle, colours, grid = true }) {
  const [to, from] = across, [left, right] = x.map(to);
  const X = (value) => box.x + (to(value) - left) / (right - left) * box.w;
  const Y = (value) => box.y + box.h - (value - y[0]) / (y[1] - y[0]) * box.h;
  const named = (list) => list.map((tick) => Array.isArray(tick) ? tick : [tick, short(tick)]);
  for (const [value, words] of named(yTicks ?? ticks(y[0], y[1]))) {
    if (grid)
      pen.path(
        [
          [box.x, Y(value)],
          [box.x + box.w, Y(value)]
        ],
        { stroke: GRID }
      );
    pen.text(words, box.x - 5, Y(value) + 4, { align: "right", colour: colours.soft, size: 10.5 });
  }
  for (const [value, words] of named(xTicks ?? ticks(x[0], x[1]))) {
    if (grid)
      pen.path(
        [
          [X(value), box.y],
          [X(value), box.y + box.h]
        ],
        { stroke: GRID }
      );
    pen.text(words, X(value), box.y + box.h + 13, { align: "center", colour: colours.soft, size: 10.5 });
  }
  if (xTitle) {
    const fits = pen.width(xTitle, 11) <= box.w + 6;
    pen.text(xTitle, box.x + box.w / (fits ? 2 : 1), box.y + box.h + 27, {
      align: fits ? "center" : "right",
      colour: colours.soft,
      size: fits ? 11 : 10
    });
  }
  if (yTitle)
    pen.text(yTitle, box.x - 36, box.y + box.h / 2, { align: "center", colour: colours.soft, size: 11, turn: true });
  return {
    X,
    Y,
    x,
    y,
    box,
    toX: (px) => from(left + (px - box.x) / box.w * (right - left)),
    toY: (py) => y[0] + (box.y + box.h - py) / box.h * (y[1] - y[0])
  };
}
function rowTicks(labels, [low, high]) {
  const stride = [1, 2, 5, 10, 20, 50, 100, 200].find((n) => (high - low) / n <= 8) ?? 500;
  return Array.from({ length: Math.ceil(labels.length / stride) }, (_, i) => [
    i * stride,
    short(labels[i * stride])
  ]).filter(([row]) => +row >= low && +row <= high);
}
function heatmap(canvas, values, n, width, limit) {
  canvas.width = width;
  canvas.height = n;
  const context = contextOf(canvas), image = context.createImageData(width, n), words = new Uint32Array(image.data.buffer);
  const factor = 511 / (limit * (1 + UNDER)), zero = 511 * UNDER / (1 + UNDER) + 0.5;
  for (let k = 0; k < n; k++) {
    for (let x = 0, at = (n - 1 - k) * width; x < width; x++, at++) {
      const index = values[k * width + x] * factor + zero | 0;
      words[at] = SCALE[index < 0 ? 0 : index > 511 ? 511 : index];
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
function colourBar(pen, canvas, box, limit, colours) {
  if (!canvas.height || canvas.height !== 128)
    heatmap(
      canvas,
      Float64Array.from({ length: 128 }, (_, i) => -UNDER + i / 127 * (1 + UNDER)),
      128,
      1,
      1
    );
  pen.image(canvas, box.x, box.y, box.w, box.h);
  for (const value of [0, limit]) {
    const y = box.y + box.h * (1 - (value / limit + UNDER) / (1 + UNDER));
    pen.text(short(value, 2), box.x + box.w + 3, y + (value ? 9 : 3), { size: 9.5, colour: colours.soft });
  }
}
var ACTIONS, actionColour, NEUTRAL, GRID, UNDER, VIRIDIS, contextOf, escaped, short, line, channelsOf, SCALE, heatIndex, heatColour;
var init_drawing = __esm({
  "app/js/draw/drawing.js"() {
    init_colours();
    ACTIONS = ["#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#8B46FF", "#7A5C28"];
    actionColour = (a) => ACTIONS[a % ACTIONS.length];
    NEUTRAL = "#8a8f98";
    GRID = "rgba(138,143,152,0.28)";
    UNDER = 0.25;
    VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
    contextOf = (canvas) => (
      /** @type {CanvasRenderingContext2D} */
      canvas.getContext("2d")
    );
    escaped = (words) => String(words).replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);
    short = (value, digits = 3) => {
      if (!Number.isFinite(value)) return "–";
      const found = +value.toPrecision(digits) || 0;
      return found && Math.abs(found) < 1e-4 ? found.toExponential().replace("e-0", "e-") : String(found);
    };
    line = (pen, xs, ys, style) => pen.path(
      Array.from(ys, (y, i) => Number.isFinite(y) ? [xs[i], y] : null),
      style
    );
    channelsOf = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
    SCALE = (() => {
      const zero = UNDER / (1 + UNDER), stops = [
        [0, "#d63af9"],
        [0.75 * zero, "#a01090"],
        ...VIRIDIS.map(
          (colour, i) => (
            /** @type {[number, string]} */
            [zero + (1 - zero) * i / (VIRIDIS.length - 1), colour]
          )
        )
      ];
      return Uint32Array.from({ length: 512 }, (_, i) => {
        const at = i / 511, next = Math.max(
          1,
          stops.findIndex(([stop]) => stop >= at)
        );
        const [[a, from], [b, to]] = [stops[next - 1], stops[next]], share = (at - a) / (b - a);
        const [red, green, blue] = channelsOf(from).map((low, c) => Math.round(low + share * (channelsOf(to)[c] - low)));
        return 255 << 24 | blue << 16 | green << 8 | red;
      });
    })();
    heatIndex = (value, limit) => Math.min(511, Math.max(0, Math.round((value / limit + UNDER) / (1 + UNDER) * 511)));
    heatColour = (value, limit) => {
      const word = SCALE[heatIndex(value, limit)];
      return `rgb(${word & 255},${word >> 8 & 255},${word >> 16 & 255})`;
    };
  }
});

// app/js/core/filters.js
function rounded2(value) {
  const low = Math.floor(value), off = value - low;
  return off < 0.5 || off === 0.5 && low % 2 === 0 ? low : low + 1;
}
function shares(kind, s, free, alpha) {
  const r = s.length + free, kept = new Float64Array(r).fill(1), lost = new Float64Array(r);
  for (let i = free; i < r; i++) [kept[i], lost[i]] = FILTERS[kind](s[i - free], alpha, s[0]);
  return { kept, lost };
}
var logLeft, FILTERS;
var init_filters = __esm({
  "app/js/core/filters.js"() {
    logLeft = (s, alpha, largest) => Math.max(1, rounded2((largest / alpha) ** 2)) * Math.log1p(-((s / largest) ** 2));
    FILTERS = {
      tikhonov: (s, a) => [s / (s * s + a * a), a * a / (s * s + a * a)],
      truncated: (s, a) => [s >= a ? 1 / s : 0, s < a ? 1 : 0],
      damped: (s, a) => [1 / (s + a), a / (s + a)],
      iterative: (s, a, largest) => {
        const left = logLeft(s, a, largest);
        return [-Math.expm1(left) / s, Math.exp(left)];
      }
    };
  }
});

// app/js/core/algebra.js
function product(a, b, n, m, k, out = new Float64Array(n * k)) {
  for (let i = 0; i < n; i++) {
    const row = out.subarray(i * k, (i + 1) * k).fill(0);
    for (let j = 0; j < m; j++) {
      const factor = a[i * m + j], other = j * k;
      if (factor !== 0) for (let l = 0; l < k; l++) row[l] += factor * b[other + l];
    }
  }
  return out;
}
function transposed(a, n, m) {
  const out = new Float64Array(n * m);
  for (let i = 0; i < n; i++) for (let j = 0; j < m; j++) out[j * n + i] = a[i * m + j];
  return out;
}
function remember(cache, name, key, make) {
  const text = JSON.stringify(key);
  if (cache[name]?.text !== text) cache[name] = { text, value: make() };
  return cache[name].value;
}
function greedy(values, scale = 0) {
  const best = Math.max(...values), least = best - tieSize(best, Math.max(scale, ...values.map(Math.abs)));
  return values.findIndex((value) => value >= least);
}
function hashed(x) {
  x ^= x >>> 16;
  x = Math.imul(x, 2146121005);
  x ^= x >>> 15;
  x = Math.imul(x, 2221713035);
  return (x ^ x >>> 16) >>> 0;
}
function normalNoise(seed, count, skip = 0) {
  const first = hashed(seed ^ 2654435769), out = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const number = (i + skip & 2147483647) << 1;
    const radius = hashed(first + number | 0), angle = hashed(first + number + 1 | 0);
    out[i] = Math.sqrt(-2 * Math.log((radius + 0.5) / 2 ** 32)) * Math.cos(2 * Math.PI * angle / 2 ** 32);
  }
  return out;
}
function masses(rewards, thetas, slope) {
  const width = thetas.length - 1, out = new Float64Array(rewards.length * width);
  rewards.forEach((reward, v) => {
    let before = sigmoid(slope * (reward - thetas[0]));
    for (let h = 0; h < width; h++) {
      const after = sigmoid(slope * (reward - thetas[h + 1]));
      out[v * width + h] = before - after;
      before = after;
    }
  });
  return out;
}
function rowNorms(inverse, { Ut, G }) {
  if (inverse.norms?.length === inverse.n) return inverse.norms;
  const rows = inverse.decode(Ut, G);
  inverse.norms = Float64Array.from({ length: inverse.n }, (_, k) => Math.hypot(...rows.subarray(k * G, (k + 1) * G)));
  return inverse.norms;
}
function growing({ V, s, r, K }, alpha) {
  const R = Float64Array.from({ length: r * r }, (_, i) => i % (r + 1) ? 0 : Math.max(alpha, 1e-9));
  const Q = new Float64Array(r * K), row = new Float64Array(r), fresh = new Float64Array(K);
  const found = {
    n: 0,
    add() {
      const n = ++found.n;
      for (let i = 0; i < r; i++) row[i] = V[(n - 1) * r + i] * s[i];
      fresh.fill(0)[n - 1] = 1;
      for (let i = 0; i < r; i++) {
        const length = Math.hypot(R[i * r + i], row[i]), c = R[i * r + i] / length, d = row[i] / length;
        for (let j = i; j < r; j++) {
          const up = R[i * r + j], low = row[j];
          R[i * r + j] = c * up + d * low;
          row[j] = c * low - d * up;
        }
        for (let k = 0, at = i * K; k < n; k++, at++) {
          const up = Q[at], low = fresh[k];
          Q[at] = c * up + d * low;
          fresh[k] = c * low - d * up;
        }
      }
      return found;
    },
    decode(right, width) {
      const part = Float64Array.from(right), { n } = found, out = new Float64Array(n * width);
      for (let i = 0; i < r; i++) {
        for (let w = 0; w < width; w++) {
          let sum = part[i * width + w];
          for (let j = 0; j < i; j++) sum -= R[j * r + i] * part[j * width + w];
          part[i * width + w] = sum / R[i * r + i];
        }
        for (let k = 0; k < n; k++)
          for (let w = 0; w < width; w++) out[k * width + w] += Q[i * K + k] * part[i * width + w];
      }
      return out;
    },
    weights(target) {
      const out = new Float64Array(r);
      for (let i = r - 1; i >= 0; i--) {
        for (let k = 0; k < found.n; k++) out[i] += Q[i * K + k] * target[k];
        for (let j = i + 1; j < r; j++) out[i] -= R[i * r + j] * out[j];
        out[i] /= R[i * r + i];
      }
      return out;
    }
  };
  return found;
}
function inverseOf(grid, { fold, alpha }, n) {
  if (!fold || !grid.plain) return regular(grid, alpha);
  const grown = growing(grid, alpha);
  while (grown.n < n) grown.add();
  return grown;
}
var sigmoid, ROUNDING, tieSize, regular;
var init_algebra = __esm({
  "app/js/core/algebra.js"() {
    init_filters();
    sigmoid = (x) => {
      const small = Math.exp(-Math.abs(x));
      return (x >= 0 ? 1 : small) / (1 + small);
    };
    ROUNDING = 1e-12;
    tieSize = (best, scale) => Math.max(1e-9 * Math.abs(best), ROUNDING * scale);
    regular = ({ V, s, r, K, free, filter }, alpha) => {
      const f = shares(filter, s, free, alpha).kept, scaled = (x, width) => x.map((value, i) => value * f[i / width | 0]);
      return {
        n: K,
        decode: (right, width) => product(V, scaled(right, width), K, r, width),
        weights: (target) => scaled(product(target, V, 1, K, r), 1)
      };
    };
  }
});

// app/js/core/network.js
function weightsBetween(low, gamma, high) {
  const share = (logTime(gamma) - logTime(low)) / (logTime(high) - logTime(low));
  return [(1 - share) * (1 - low) / (1 - gamma), share * (1 - high) / (1 - gamma)];
}
function leftOut({ header: { added }, arrays: { gammas } }, Z) {
  const every = added + 1, T = (gammas.length - 1) / every + 1, width = Z.length / gammas.length;
  return Float64Array.from({ length: Math.max(0, T - 2) }, (_, i) => {
    const [below, at, above] = [i * every, (i + 1) * every, (i + 2) * every];
    const [low, high] = weightsBetween(gammas[below], gammas[at], gammas[above]);
    let sum = 0, worst = 0;
    for (let h = width - 1; h >= 0; h--) {
      sum += low * Z[below * width + h] + high * Z[above * width + h] - Z[at * width + h];
      worst = Math.max(worst, Math.abs(sum));
    }
    return worst * (1 - gammas[at]);
  });
}
function softened(sensitivities, share, open2) {
  const last = sensitivities.length - 1, steep = Math.tan(Math.PI * share / 2), outer = (i, j) => 2 * sensitivities[i] - sensitivities[j];
  const places = open2 ? Float64Array.of(outer(0, 1), ...sensitivities, outer(last, last - 1)) : sensitivities;
  const ends = open2 ? Float64Array.of(-Infinity, ...sensitivities, Infinity) : sensitivities;
  const H = places.length - 1, map = new Float64Array(H * H);
  const beyond = (x) => 0.5 + Math.atan(steep * Math.tanh(share * x / 2)) / (Math.PI * share);
  const passed = (x) => Number.isFinite(x) ? beyond(x) : Number(x > 0);
  for (let j = 0; j < H; j++) {
    const middle = (places[j] + places[j + 1]) / 2;
    for (let h = 0; h < H; h++) map[j * H + h] = passed(middle - ends[h]) - passed(middle - ends[h + 1]);
  }
  const first = places[H >> 1], gap = places[(H >> 1) + 1] - first;
  const rewards = Float64Array.from({ length: 9 }, (_, i) => first + i / 8 * gap), exact = masses(rewards, ends, share);
  let off = 0, sum = 0;
  product(masses(rewards, ends, 1), map, 9, H, H).forEach((value, i) => {
    sum = (i % H ? sum : 0) + value - exact[i];
    off = Math.max(off, Math.abs(sum));
  });
  return { map, off };
}
var logTime;
var init_network = __esm({
  "app/js/core/network.js"() {
    init_algebra();
    logTime = (gamma) => Math.log(-1 / Math.log(gamma));
  }
});

// app/js/core/model.js
function unpacked(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset), length = view.getUint32(0, true), header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))), arrays = {};
  for (const [name, [kind, at, shape]] of Object.entries(header.arrays)) {
    const count = shape.reduce((a, b) => a * b, 1), size = { f8: 8, f4: 4, u2: 2 }[kind];
    const block = bytes.slice(4 + length + at, 4 + length + at + count * size).buffer;
    arrays[name] = kind === "f8" ? new Float64Array(block) : Float64Array.from(new (kind === "f4" ? Float32Array : Uint16Array)(block));
  }
  return { header, arrays };
}
function read(bytes) {
  const { header, arrays } = unpacked(bytes);
  return { ...open(
    header,
    /** @type {Arrays} */
    /** @type {unknown} */
    arrays
  ), bytes };
}
function open(header, arrays) {
  const A = header.actions.length, K = header.steps, dt = header.time_step, H = arrays.thetas.length;
  const grid = (name) => {
    const part = (kind) => arrays[name + kind], gammas = part("gammas"), s = part("s"), U = part("U"), weights = part("weights"), smoothing = part("smoothing"), G = gammas.length, { free, filter } = header, r = s.length + free;
    const weighted = transposed(U, G, r).map((value, i) => weights ? value * weights[i % G] : value);
    const found = {
      name,
      G,
      r,
      K,
      U,
      gammas,
      s,
      free,
      filter,
      plain: header.solver === "tikhonov" && !weights && !smoothing,
      V: part("V"),
      Ut: smoothing ? product(weighted, smoothing, r, G, G) : weighted,
      smoothing,
      transform: Float64Array.from({ length: G * K }, (_, i) => gammas[Math.floor(i / K)] ** (i % K * dt)),
      reduced: part("reduced"),
      turned: part("turned"),
      columns: (
        /** @type {Grid['columns']} */
        {}
      )
    };
    for (const kind of ["shared", "per_gamma"]) {
      const W = part(kind);
      if (W) found.columns[kind] = channels(found, W, A, arrays.rewards.length);
    }
    if (!name && arrays.differences) {
      const bins = arrays.bin_values?.length ?? H - 1;
      found.columns.shared = Object.assign(channels(found, arrays.differences, A, bins, arrays.constant), {
        plain: true
      });
    }
    return found;
  };
  const horizons = Float64Array.from({ length: K }, (_, k) => k * dt + (1 + dt) / 2);
  return {
    header,
    A,
    K,
    dt,
    H,
    truth: Boolean(arrays.timeline),
    arrays,
    cache: {},
    grids: { own: grid(""), ...arrays.paper_gammas ? { paper: grid("paper_") } : {} },
    horizons,
    sloped: Boolean(arrays.shared),
    simulated: header.simulated && arrays.simulated_tails && arrays.simulated_lines ? simulation(header.simulated, arrays.simulated_tails, arrays.simulated_lines) : void 0,
    length: Math.ceil(horizons[K - 1] - 1e-9)
  };
}
function simulation({ action, count }, tails, lines) {
  const length = lines.length / 5, [reward, rewardError, survival, survivalError, chance] = Array.from(
    { length: 5 },
    (_, i) => lines.subarray(i * length, (i + 1) * length)
  );
  return {
    action,
    count,
    length,
    width: tails.length / length,
    tails,
    reward,
    rewardError,
    survival,
    survivalError,
    chance
  };
}
function projections({ Ut, r, G }, each, width, sums) {
  const under = (U) => ({
    projected: each.map((x) => product(U, x, r, G, width)),
    constants: sums.map((x) => product(U, x, r, G, 1))
  });
  let late;
  return (
    /** @type {Components} */
    Object.defineProperty(under(Ut), "late", {
      get: () => late ??= under(Ut.map((_, i) => i % G === G - 1 ? 0 : Ut[i + 1]))
    })
  );
}
function channels(grid, values, A, width, constant) {
  const { G } = grid, each = Array.from({ length: A }, (_, a) => values.subarray(a * G * width, (a + 1) * G * width));
  const sums = (x) => Float64Array.from({ length: G }, (_, g) => {
    let sum = 0;
    for (let v = 0; v < width; v++) sum += x[g * width + v];
    return sum;
  });
  const steps = each.map((x, a) => constant ? constant.subarray(a * G, (a + 1) * G) : sums(x));
  return Object.assign(projections(grid, each, width, steps), { width, values: each, steps });
}
function rowAt(model, horizon) {
  return Math.min(model.K - 1, Math.max(0, Math.ceil((horizon - (1 + model.dt) / 2) / model.dt - 0.5)));
}
var init_model = __esm({
  "app/js/core/model.js"() {
    init_algebra();
    init_network();
  }
});

// app/js/core/nonnegative.js
function solved(H, b) {
  const n = b.length, x = Float64Array.from(b);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j <= i; j++) {
      let sum = H[i * n + j];
      for (let k = 0; k < j; k++) sum -= H[i * n + k] * H[j * n + k];
      H[i * n + j] = i === j ? Math.sqrt(Math.max(sum, Number.MIN_VALUE)) : sum / H[j * n + j];
    }
  }
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < i; k++) x[i] -= H[i * n + k] * x[k];
    x[i] /= H[i * n + i];
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) x[i] -= H[k * n + i] * x[k];
    x[i] /= H[i * n + i];
  }
  return x;
}
function columnsOf(A, targets, K) {
  const q = A.length / K, B = targets.length / q, size = Math.hypot(...A.subarray(0, K)), lengths = Float64Array.from(
    { length: q },
    (_, i) => dot(A.subarray(i * K, (i + 1) * K), A.subarray(i * K, (i + 1) * K))
  );
  const x = new Float64Array(K), along = new Float64Array(K), rows = transposed(A, q, K);
  const rowsOf = (at, out) => {
    out.fill(0);
    for (let i = 0; i < q; i++) for (let k = 0, row = i * K; k < K; k++) out[k] += at[i] * A[row + k];
    return out;
  };
  function moved(at, z, alpha) {
    rowsOf(at, x);
    const gradient = new Float64Array(q), hessian = new Float64Array(q * q);
    for (let i = 0; i < q; i++) {
      let sum = alpha * alpha * at[i] - z[i];
      for (let k = 0, row = i * K; k < K; k++) if (x[k] > 0) sum += A[row + k] * x[k];
      gradient[i] = sum;
    }
    const norm = (v) => Math.sqrt(dot(v, v)), rounding = 4 * Number.EPSILON * (size * size * norm(at) + norm(z));
    const off = norm(gradient);
    if (off <= rounding) return 0;
    for (let k = 0; k < K; k++) {
      if (!(x[k] > 0)) continue;
      for (let i = 0, at2 = k * q; i < q; i++) {
        const factor = rows[at2 + i];
        for (let j = 0, to = i * q; j <= i; j++) hessian[to + j] += factor * rows[at2 + j];
      }
    }
    for (let i = 0; i < q; i++) hessian[i * q + i] += alpha * alpha;
    const step = solved(hessian, gradient).map((value) => -value), share = shareOf(at, z, step, alpha);
    for (let i = 0; i < q; i++) at[i] += share * step[i];
    return off;
  }
  function shareOf(at, z, step, alpha) {
    rowsOf(step, along);
    let linear2 = 0;
    for (let i = 0; i < q; i++) linear2 += step[i] * (alpha * alpha * at[i] - z[i]);
    const quadratic = alpha * alpha * dot(step, step);
    const slope = (share2) => {
      let sum = linear2 + share2 * quadratic;
      for (let k = 0; k < K; k++) {
        const value = x[k] + share2 * along[k];
        if (value > 0) sum += value * along[k];
      }
      return sum;
    };
    let low = 0, high = 1, atLow = slope(0), atHigh = slope(1), share = 1;
    const small = 0.1 * Math.abs(atLow);
    if (!(atHigh > small)) return 1;
    for (let n = 0; n < SEARCHES; n++) {
      const width = high - low, guess = low - atLow * width / (atHigh - atLow);
      share = Math.min(high - 0.1 * width, Math.max(low + 0.1 * width, guess));
      const found = slope(share);
      if (found < 0) [low, atLow] = [share, found];
      else [high, atHigh] = [share, found];
      if (Math.abs(found) <= small) break;
    }
    return share;
  }
  function newton(at, z, alpha, most) {
    let best = Infinity, idle = 0;
    for (let i = 0; i < most && idle < IDLE; i++) {
      const off = moved(at, z, alpha);
      if (!off) break;
      idle = off < best / 2 ? 0 : idle + 1;
      best = Math.min(best, off);
    }
  }
  function massesOf(c) {
    const found = new Float64Array(B * K);
    for (let b = 0; b < B; b++) {
      rowsOf(c.subarray(b * q, (b + 1) * q), x);
      for (let k = 0; k < K; k++) found[b * K + k] = Math.max(0, x[k]);
    }
    return found;
  }
  function below(above, alpha, most) {
    const c = Float64Array.from(above.c), z = (b) => targets.subarray(b * q, (b + 1) * q);
    if (alpha >= LEAST * size) {
      for (let b = 0; b < B; b++) newton(c.subarray(b * q, (b + 1) * q), z(b), alpha, most);
      return { c };
    }
    const masses2 = Float64Array.from(above.masses ?? massesOf(c));
    for (let b = 0; b < B; b++) activeSet(A, z(b), alpha, masses2.subarray(b * K, (b + 1) * K));
    return { c: above.c, masses: masses2 };
  }
  const alphas = [size];
  for (let last = size; last > FLOOR * size; alphas.push(last)) last /= last > LEAST * size ? FALL : FALL_BELOW;
  const ladder = (
    /** @type {ReturnType<typeof below>[]} */
    []
  );
  return {
    size,
    at(asked) {
      const alpha = Math.max(asked, FLOOR * size), depth = Math.max(
        0,
        alphas.findLastIndex((each) => each > alpha)
      );
      while (ladder.length <= depth) {
        const n = ladder.length, guess = () => targets.map((value, i) => value / (lengths[i % q] + size * size));
        ladder.push(below(n ? ladder[n - 1] : { c: guess() }, alphas[n], ON_THE_WAY));
      }
      const { c, masses: masses2 = massesOf(c) } = below(ladder[depth], alpha, MOST_STEPS);
      return transposed(masses2, B, K);
    }
  };
}
function activeSet(A, z, alpha, x) {
  const K = x.length, free = [], rounding = 4 * Number.EPSILON * Math.sqrt(dot(A, A) * dot(z, z)), barred = /* @__PURE__ */ new Set();
  for (let k = 0; k < K; k++) if (x[k] > 0) free.push(k);
  let found = settled(A, z, alpha, x, free, freed(A, z, alpha, K, free));
  for (let n = 0; n < 3 * K; n++) {
    let most = rounding, next = -1;
    for (let k = 0; k < K; k++) {
      if (x[k] > 0 || barred.has(k)) continue;
      let sum = 0;
      for (let i = 0; i < z.length; i++) sum += A[i * K + k] * found.residual[i];
      if (sum > most) [most, next] = [sum, k];
    }
    if (next < 0) return;
    const place2 = free.filter((k) => k < next).length;
    free.splice(place2, 0, next);
    const wanted = freed(A, z, alpha, K, free);
    if (wanted.x[place2] > 0) {
      barred.clear();
      found = settled(A, z, alpha, x, free, wanted);
    } else {
      barred.add(next);
      free.splice(place2, 1);
    }
  }
}
function settled(A, z, alpha, x, free, wanted) {
  for (; ; ) {
    let share = 1, first = -1;
    free.forEach((k, i) => {
      if (wanted.x[i] > 0) return;
      const here = x[k] / (x[k] - wanted.x[i] || 1);
      if (here < share || first < 0) [share, first] = [here, k];
    });
    free.forEach((k, i) => x[k] += share * (wanted.x[i] - x[k]));
    if (first < 0) return wanted;
    x[first] = 0;
    for (let i = free.length - 1; i >= 0; i--) {
      if (x[free[i]] > 0) continue;
      x[free[i]] = 0;
      free.splice(i, 1);
    }
    wanted = freed(A, z, alpha, x.length, free);
  }
}
function freed(A, z, alpha, K, free) {
  const q = z.length, p = free.length, long = p + q;
  const M = new Float64Array(q * long), diagonal = new Float64Array(q), halves = new Float64Array(q);
  for (let j = 0; j < q; j++) {
    for (let i = 0; i < p; i++) M[j * long + i] = A[j * K + free[i]];
    M[j * long + p + j] = alpha;
  }
  const reflect = (j, out, at) => {
    const end = p + j + 1;
    let sum = 0;
    for (let i = j; i < end; i++) sum += M[j * long + i] * out[at + i];
    sum /= halves[j];
    for (let i = j; i < end; i++) out[at + i] -= sum * M[j * long + i];
  };
  for (let j = 0; j < q; j++) {
    const at = j * long;
    for (let m = 0; m < j; m++) reflect(m, M, at);
    let sum = 0;
    for (let i = j; i < long; i++) sum += M[at + i] ** 2;
    diagonal[j] = M[at + j] > 0 ? -Math.sqrt(sum) : Math.sqrt(sum);
    halves[j] = sum - diagonal[j] * M[at + j];
    M[at + j] -= diagonal[j];
  }
  const y = new Float64Array(long);
  for (let j = 0; j < q; j++) {
    let sum = z[j];
    for (let m = 0; m < j; m++) sum -= M[j * long + m] * y[m];
    y[j] = sum / diagonal[j];
  }
  for (let j = q - 1; j >= 0; j--) reflect(j, y, 0);
  return { x: y.slice(0, p), residual: y.slice(p).map((value) => alpha * value) };
}
var MOST_STEPS, FALL, FALL_BELOW, SEARCHES, IDLE, ON_THE_WAY, LEAST, FLOOR, dot;
var init_nonnegative = __esm({
  "app/js/core/nonnegative.js"() {
    init_algebra();
    MOST_STEPS = 200;
    FALL = 1.5;
    FALL_BELOW = 3;
    SEARCHES = 12;
    IDLE = 8;
    ON_THE_WAY = 2;
    LEAST = 3e-3;
    FLOOR = 1e-9;
    dot = (a, b) => {
      let sum = 0;
      for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
      return sum;
    };
  }
});

// app/js/core/maths.js
function deadlineWeights(horizon, steps, softness, dt = 1) {
  return Float64Array.from({ length: steps }, (_, k) => {
    const left = horizon - 0.5 - k * dt;
    if (softness < 1e-9) return Math.abs(left) < 5e-10 ? 0.5 : Number(left > 0);
    return sigmoid(left / (softness * horizon));
  });
}
function discounts({ cache, horizons, K, dt }, softness, gamma) {
  return remember(cache, softness > 0 ? "soft discounts" : "hard discounts", [softness, gamma], () => {
    const out = new Float64Array(K * K);
    horizons.forEach((horizon, k) => {
      const weights = softness > 0 ? deadlineWeights(horizon, K, softness, dt) : null;
      for (let n = 0; n < K; n++) out[k * K + n] = (weights ? weights[n] : Number(n <= k)) * gamma ** (n * dt);
    });
    return out;
  });
}
function shares2({ K, dt, length }) {
  const out = new Float64Array(K * length);
  for (let n = 0; n < length; n++) {
    const place2 = n / dt, first = Math.floor(place2 + 1e-9), second = Math.min(1, Math.max(0, place2 - first));
    if (first < K) out[first * length + n] = 1 - second;
    if (first + 1 < K) out[(first + 1) * length + n] = second;
  }
  return out;
}
function truthOf(model, state) {
  const { A, K, length, arrays, cache, header } = model, { timeline, rewards } = arrays, width = rewards.length;
  const rows = remember(cache, "true rows", 0, () => {
    const spread = shares2(model), flat = new Float64Array(A * length), alive = new Float64Array(A * length);
    for (let i = 0; i < A * length; i++) {
      for (let v = 0; v < width; v++) {
        flat[i] += timeline[i * width + v] * rewards[v];
        alive[i] += timeline[i * width + v];
      }
    }
    const spreadOver = (x, w, a) => product(spread, x.subarray(a * length * w, (a + 1) * length * w), K, length, w);
    const each = (x, w) => Array.from({ length: A }, (_, a) => spreadOver(x, w, a));
    const steps = (x) => Array.from({ length: A }, (_, a) => x.subarray(a * length, (a + 1) * length));
    return {
      rewards: each(flat, 1),
      survival: each(alive, 1),
      chances: each(timeline, width),
      steps: { rewards: steps(flat), survival: steps(alive) }
    };
  });
  const read2 = (name, softness, gamma) => remember(cache, name, [softness, gamma], () => {
    const d = discounts(model, softness, gamma);
    return rows.rewards.map((line2) => product(d, line2, K, K, 1));
  });
  return {
    ...rows,
    values: read2("true values", state.softness, state.value_gamma),
    get hard() {
      return read2("hard true values", 0, header.acting_gamma);
    },
    acting: header.acting_gamma
  };
}
function timelineError(model, state, seen) {
  const {
    dt,
    K,
    cache,
    arrays: { rewards }
  } = model, { H, midpoints, masses: M, truth, tau, n } = seen, V = rewards.length;
  const nearest = remember(cache, "nearest", [midpoints[0], midpoints[H - 1], H], () => {
    let v = 0;
    return Int32Array.from(midpoints, (theta) => {
      while (v < V - 1 && theta > (rewards[v] + rewards[v + 1]) / 2) v++;
      return v;
    });
  });
  const step = (k) => Math.floor(k * dt + 0.5 + 1e-9), N = step(K - 1) + 1;
  const true_ = remember(
    cache,
    "true by reward",
    [state.action, state.slope, state.normalise === "survival", H, midpoints[0]],
    () => {
      const out = new Float64Array(N * V), chances = truth.chances[state.action], alive = truth.survival[state.action];
      const seen2 = Float64Array.from(
        { length: V },
        (_, v) => M.subarray(v * H, (v + 1) * H).reduce((sum, mass) => sum + mass, 0)
      );
      let shown = 0, comes = 0;
      for (let i = 0; i < K * V; i++) {
        shown += chances[i] * seen2[i % V];
        comes += chances[i];
      }
      if (shown < LEAST_SHOWN * comes) return null;
      for (let k = 0; k < K; k++) {
        const whole = state.normalise !== "survival" ? 1 : alive[k] > FLOOR2 ? 1 / alive[k] : 0;
        for (let v = 0; v < V; v++) {
          const chance = chances[k * V + v] * whole;
          if (chance) for (let h = 0; h < H; h++) out[step(k) * V + nearest[h]] += chance * M[v * H + h];
        }
      }
      return out;
    }
  );
  if (!true_) return 1;
  const rows = new Float64Array(N * V);
  for (let k = 0; k < n; k++) for (let h = 0; h < H; h++) rows[step(k) * V + nearest[h]] += tau[k * H + h];
  let off = 0, all = 0;
  for (let i = 0; i < rows.length; i++) {
    off += Math.abs(rows[i] - true_[i]);
    all += true_[i];
  }
  return 0.5 * off / Math.max(all, 0.05);
}
function see(model, state, most = Infinity) {
  const { A, K, dt, cache, arrays, header } = model;
  if (arrays.decoded)
    state = { ...state, ...header.decoded_for };
  else if (state.fold && !model.grids.own.plain) state = { ...state, fold: false };
  const grid = state.paper_grid && model.grids.paper || model.grids.own;
  const columns = state.mixed && grid.columns.per_gamma || grid.columns.shared;
  const open2 = Boolean(arrays.bin_edges);
  const sensitivities = state.clip && !columns.plain && arrays.clipped_thetas || arrays.thetas;
  const thetas = arrays.bin_edges ?? sensitivities, H = thetas.length - 1;
  const midpoints = arrays.bin_values ?? Float64Array.from({ length: H }, (_, h) => (thetas[h] + thetas[h + 1]) / 2);
  const spaceKey = [state.slope, sensitivities === arrays.thetas];
  const M = model.truth ? remember(cache, "masses", spaceKey, () => masses(arrays.rewards, thetas, state.slope)) : null;
  const { places } = arrays;
  const soft = places && state.slope_share < 1 ? remember(cache, "soft", state.slope_share, () => softened(places, state.slope_share, open2)) : null;
  const map = columns.plain ? soft?.map : M, width = columns.width;
  const drawn = () => noiseOf(model, grid, state.noise_seed);
  const hum = state.noise > 0 ? remember(cache, "noise", [grid.name, state.noise_seed], drawn) : null;
  const readRow = rowAt(model, state.constant ? state.horizon : Math.max(0, state.horizon - state.used));
  const leftRow = rowAt(model, Math.max(0, state.horizon - state.used)), n = state.fold ? readRow + 1 : K;
  const means = map ? product(map, midpoints, width, H, 1) : midpoints;
  const plus = (x, y) => hum ? x.map((value, i) => value + state.noise * y[i]) : x;
  const inComponents = state.shift ? columns.late : columns, humming = state.shift ? hum?.late : hum;
  const parts = Array.from({ length: A }, (_, a) => ({
    columns: inComponents.projected[a],
    hum: humming?.projected[a],
    mean: plus(
      product(inComponents.projected[a], means, grid.r, width, 1),
      humming && product(humming.projected[a], midpoints, grid.r, H, 1)
    ),
    constant: plus(inComponents.constants[a], humming?.constants[a])
  }));
  const rawRows = (part, inverse2) => {
    if (!hum && map) return product(inverse2.decode(part.columns, width), map, inverse2.n, width, H);
    return inverse2.decode(plus(map ? product(part.columns, map, grid.r, width, H) : part.columns, part.hum), H);
  };
  const sized = [
    state.slope,
    state.slope_share,
    thetas[0],
    H,
    columns === grid.columns.per_gamma,
    grid.name,
    state.noise,
    hum && state.noise_seed,
    state.shift
  ];
  const roundingOf = (a, inverse2) => {
    const size = remember(cache, `sizes ${a}`, sized, () => {
      const Z = differencesOf(columns, grid, map, H, a, hum, state.noise);
      return Math.hypot(
        ...Array.from(
          { length: state.shift ? grid.G - 1 : grid.G },
          (_, g) => Z.subarray(g * H, (g + 1) * H).reduce((sum, value) => sum + Math.abs(value), 0)
        )
      );
    });
    return rowNorms(inverse2, grid).map((norm) => ROUNDING * size * norm);
  };
  const linear2 = (inverse2) => ({
    n: inverse2.n,
    rows: (a) => rawRows(parts[a], inverse2),
    survival: (a) => inverse2.decode(parts[a].constant, 1),
    rewards: (a) => inverse2.decode(parts[a].mean, 1),
    rounding: (a) => roundingOf(a, inverse2)
  });
  const nonnegative = () => {
    const { reduced, turned } = grid, q = reduced.length / K, wide = open2 ? H : H + 2, end = open2 ? 0 : 1;
    const each = parts.map((_, a) => {
      const solver = remember(cache, `columns ${a}`, sized, () => {
        const full = allMasses(model, grid, { columns, map, hum, soft, thetas, H, open: open2 }, state, a);
        return columnsOf(reduced, transposed(product(turned, full, q, grid.G, wide), q, wide), K);
      });
      return solver.at(state.alpha);
    });
    const rows = (a) => Float64Array.from({ length: K * H }, (_, i) => each[a][Math.floor(i / H) * wide + i % H + end]);
    return {
      n: K,
      rows,
      survival: (a) => product(each[a], new Float64Array(wide).fill(1), K, wide, 1),
      rewards: (a) => product(rows(a), midpoints, K, H, 1)
    };
  };
  const ready = (
    /** @type {Float64Array} */
    arrays.decoded
  ), alive = (
    /** @type {Float64Array} */
    arrays.decoded_survival
  ), folded = arrays.decoded_values;
  const served = () => {
    const rows = (a) => ready.slice(a * K * H, (a * K + n) * H);
    return {
      n,
      rows,
      survival: (a) => alive.slice(a * K, a * K + n),
      rewards: (a) => product(rows(a), midpoints, n, H, 1)
    };
  };
  const tauSpace = (timelines2, a) => {
    const rows = timelines2.rows(a);
    if (state.normalise !== "none")
      normalise(
        rows,
        timelines2.survival(a),
        state.normalise,
        H,
        dt,
        state.normalise === "paper" ? timelines2.rounding?.(a) : void 0
      );
    return rows;
  };
  const rewardsOf = (timelines2, a) => {
    if (state.normalise === "paper") return product(tauSpace(timelines2, a), midpoints, timelines2.n, H, 1);
    const rows = timelines2.rewards(a);
    if (state.normalise !== "none") normalise(rows, timelines2.survival(a), "survival", 1, dt);
    return rows;
  };
  const inverse = inverseOf(grid, state, n);
  const timelines = ready ? served() : grid.reduced ? nonnegative() : linear2(inverse);
  const tau = tauSpace(timelines, state.action);
  const survival = parts.map((_, a) => timelines.survival(a));
  const rewards = parts.map(
    (_, a) => a === state.action ? product(tau, midpoints, timelines.n, H, 1) : rewardsOf(timelines, a)
  );
  const d = discounts(model, state.softness, state.value_gamma);
  const valueAt = (row, expected) => {
    let sum = 0;
    for (let k = 0; k < expected.length; k++) sum += d[row * K + k] * expected[k];
    return sum;
  };
  const values = Array.from({ length: A }, () => new Float64Array(K).fill(NaN));
  if (!state.fold)
    values.forEach(
      (line2, a) => line2.forEach((_, k) => {
        line2[k] = valueAt(k, rewards[a]);
      })
    );
  else
    values.forEach((line2, a) => {
      line2[readRow] = valueAt(readRow, rewards[a]);
    });
  if (state.fold && folded) values.forEach((line2, a) => line2.set(folded.subarray(a * K, (a + 1) * K)));
  else if (state.fold && most) {
    const wide = state.normalise === "paper" ? H * (hum ? grid.r : width) : grid.r;
    const stride = Math.max(1, Math.ceil(A * wide * K * K / 2 / most));
    const grown = growing(grid, state.alpha);
    for (let k = 0; k < K; k++) {
      grown.add();
      if (k === readRow || k % stride && k !== K - 1) continue;
      const shorter = linear2(grown);
      parts.forEach((_, a) => {
        values[a][k] = valueAt(k, rewardsOf(shorter, a));
      });
    }
  }
  const terms = rewards.map((line2) => line2.reduce((sum, value) => sum + Math.abs(value), 0));
  const scale = Math.max(...terms, ...midpoints.map(Math.abs));
  const chosenAt = (row) => greedy(
    values.map((line2) => line2[row]),
    scale
  );
  const decoded = {
    grid,
    thetas,
    midpoints,
    H,
    open: open2,
    n,
    inverse,
    readRow,
    leftRow,
    tau,
    survival,
    rewards,
    values,
    columns,
    map,
    hum,
    soft,
    scale,
    chosen: chosenAt(readRow),
    chosenAt,
    whole: !values[0].some(Number.isNaN),
    d
  };
  if (!M) return { ...decoded, masses: null };
  const truth = truthOf(model, state), optimumAt = (row) => values.map((_, a) => arrays.optimum[a * K + row]);
  const optimum = optimumAt(leftRow);
  return {
    ...decoded,
    masses: M,
    truth,
    optimumAt,
    best: greedy(optimum),
    bestAt: (row) => greedy(optimumAt(row)),
    regret: Math.max(...optimum) - optimum[decoded.chosen]
  };
}
function normalise(rows, survival, how, width, dt, rounding) {
  for (let k = 0; k < survival.length; k++) {
    const row = rows.subarray(k * width, (k + 1) * width);
    if (how === "survival") {
      const alive = survival[k] / dt;
      for (let h = 0; h < width; h++) row[h] = alive > FLOOR2 ? row[h] / alive : 0;
    } else {
      let mass = 0;
      for (let h = 0; h < width; h++) mass += row[h] = Math.max(0, row[h]);
      const least = rounding ? rounding[k] : 0;
      for (let h = 0; h < width; h++) row[h] = mass > least ? dt * row[h] / mass : 0;
    }
  }
}
function noiseOf({ A, H, arrays }, grid, seed) {
  const open2 = arrays.bin_edges ? 1 : 0;
  const { G, gammas } = grid, width = H - 1 + 2 * open2, differences = [], above = new Float64Array(A * G), constant = new Float64Array(A * G);
  const values = normalNoise(seed, A * G * H), more = normalNoise(seed, A * G, A * G * H);
  for (let a = 0; a < A; a++) {
    const out = new Float64Array(G * width);
    for (let g = 0; g < G; g++) {
      const scale = 1 / (1 - gammas[g]), from = (a * G + g) * H, tail = (h) => h < 0 ? more[a * G + g] : h < H ? values[from + h] : 0;
      for (let h = 0; h < width; h++) out[g * width + h] = scale * (tail(h - open2) - tail(h - open2 + 1));
      constant[a * G + g] = scale * more[a * G + g];
      above[a * G + g] = scale * tail(H - 1);
    }
    differences.push(out);
  }
  const steps = differences.map((_, a) => constant.subarray(a * G, (a + 1) * G));
  return Object.assign(projections(grid, differences, width, steps), { differences, above, steps });
}
function differencesOf(columns, grid, map, H, a, hum, noise) {
  const Z = map ? product(columns.values[a], map, grid.G, columns.width, H) : columns.values[a];
  return hum ? Z.map((value, i) => value + noise * hum.differences[a][i]) : Z;
}
function allMasses({ arrays }, grid, { columns, map, hum, thetas, H, open: open2 }, state, a) {
  const { G, smoothing } = grid, { width, values } = columns, inner = differencesOf(columns, grid, map, H, a, hum, state.noise), wide = open2 ? H : H + 2;
  let full = inner;
  if (!open2) {
    full = new Float64Array(G * wide);
    for (let g = 0; g < G; g++) {
      let above = 0, sum = columns.steps[a][g];
      if (columns.plain) above = arrays.above?.[a * G + g] ?? 0;
      else
        for (let v = 0; v < width; v++)
          above += values[a][g * width + v] * sigmoid(state.slope * (arrays.rewards[v] - thetas[H]));
      if (hum) {
        above += state.noise * hum.above[a * G + g];
        sum += state.noise * hum.steps[a][g];
      }
      full.set(inner.subarray(g * H, (g + 1) * H), g * wide + 1);
      full[g * wide + wide - 1] = above;
      for (let h = 1; h < wide; h++) sum -= full[g * wide + h];
      full[g * wide] = sum;
    }
  }
  if (smoothing) full = product(smoothing, full, G, G, wide);
  if (!state.shift) return full;
  const late = new Float64Array(G * wide);
  late.set(full.subarray(0, (G - 1) * wide), wide);
  return late;
}
function weightsOf({ arrays: { matrix } }, { Ut, G, r }, state, inverse, target) {
  const each = matrix ? product(target, matrix, 1, matrix.length / G, G) : product(inverse.weights(target), Ut, 1, r, G);
  return state.shift ? each.map((_, g) => g + 1 < G ? each[g + 1] : 0) : each;
}
function kernel(model, state, { grid, n, readRow, d, inverse }) {
  const { K } = model, wanted = d.slice(readRow * K, (readRow + 1) * K), target = new Float64Array(K);
  for (let k = 0; k < n; k++) target[k] = wanted[k];
  const weights = weightsOf(model, grid, state, inverse, target);
  return {
    wanted,
    actual: product(weights, grid.transform, 1, grid.G, K),
    gain: Math.hypot(...weights)
  };
}
function resolution(model, state, { grid, n, inverse }, row) {
  const { K, dt } = model, kernel2 = new Float64Array(K);
  if (row < n) {
    const weights = weightsOf(
      model,
      grid,
      state,
      inverse,
      Float64Array.from({ length: K }, (_, k) => Number(k === row))
    );
    product(weights, grid.transform, 1, grid.G, K, kernel2);
  }
  let peak = 0;
  kernel2.forEach((value, k) => {
    if (value > kernel2[peak]) peak = k;
  });
  let low = peak, high = peak;
  while (low > 0 && kernel2[low - 1] > kernel2[peak] / 2) low--;
  while (high < K - 1 && kernel2[high + 1] > kernel2[peak] / 2) high++;
  return { kernel: kernel2, peak: peak * dt, half: (high - low) / 2 * dt, low: low * dt, high: high * dt };
}
function pending({ header: { decoded_for: held, follows }, arrays, grids }, state) {
  if (arrays.decoded && held) return Object.keys(held).some((name) => held[name] !== state[name]);
  return !follows || state.fold && !grids.own.plain;
}
function available({ grids, arrays, truth }, name) {
  const own = grids.own.columns;
  return {
    mixed: Boolean(own.per_gamma),
    paper_grid: Boolean(grids.paper),
    clip: Boolean(arrays.clipped_thetas) && !own.shared.plain,
    constant: truth
  }[name] ?? true;
}
function effect(model, state, name) {
  const rule = SWITCHES[name], least = 0;
  const on = see(model, { ...state, ...rule.on }, least), off = see(model, { ...state, ...rule.off }, least);
  let size = 0;
  for (let k = 0; k < Math.min(on.n, off.n); k++) {
    let more = 0, less = 0, all = 0;
    for (let h = 0; h < on.H; h++) {
      const change = on.tau[k * on.H + h] - off.tau[k * off.H + h];
      if (change > 0) more += change;
      else less -= change;
      all += change;
    }
    size = Math.max(size, (name === "clip" ? Math.abs(all) : Math.max(more, less)) / model.dt);
  }
  return { size, on: on.regret, off: off.regret, flips: on.chosen !== off.chosen };
}
var LEAST_SHOWN, FLOOR2, gammaSpace, flag, SWITCHES;
var init_maths = __esm({
  "app/js/core/maths.js"() {
    init_algebra();
    init_model();
    init_network();
    init_nonnegative();
    LEAST_SHOWN = 0.05;
    FLOOR2 = 0.05;
    gammaSpace = ({ grid, columns, map, hum, H }, state) => differencesOf(columns, grid, map, H, state.action, hum, state.noise);
    flag = (name, words) => ({
      ...words,
      on: { [name]: true },
      off: { [name]: false },
      isOn: (state) => Boolean(state[name])
    });
    SWITCHES = {
      rescale: {
        label: "row rescaling",
        on: { normalise: "paper" },
        off: { normalise: "none" },
        isOn: (s) => s.normalise === "paper",
        help: "Every row is rescaled to probability 1, even after the end of the episode."
      },
      fold: flag("fold", {
        label: "only T rows, K = T",
        help: "Only T rows are decoded, so later rewards are folded into them."
      }),
      mixed: flag("mixed", {
        label: "mixed policies",
        help: "Every discount follows its own greedy policy: no single process has such a gamma-space."
      }),
      paper_grid: flag("paper_grid", {
        label: "the paper’s grid",
        help: "The paper’s 15 discounts, from .01 to .99, piecewise linear."
      }),
      clip: flag("clip", {
        label: "edge clipping",
        help: "The sensitivities begin at a reward that occurs, so half of its probability is lost."
      }),
      constant: flag("constant", {
        label: "constant T",
        help: "The agent acts with T at every step instead of with the time to go."
      }),
      shift: flag("shift", {
        label: "index shifted by one",
        help: "Each discount is decoded by the row of the next one, as in the paper’s published notebook."
      })
    };
  }
});

// app/js/lens/simulated.js
function stepAt(simulated, dt, row) {
  const step = Math.round(row * dt);
  return Math.abs(step - row * dt) < 1e-9 && step < simulated.length ? step : -1;
}
function simulatedRow(model, a, row) {
  const { simulated, K } = model;
  if (!simulated || simulated.action !== a) return null;
  const step = stepAt(simulated, model.dt, row);
  if (step < 0) return null;
  const { tails, width, length } = simulated, far = Math.round(K / 80), found = new Float64Array(width - 1);
  const first = Math.max(0, step - far), last = Math.min(length - 1, step + far);
  if (!tails[step * width]) return null;
  for (let at = first; at <= last; at++)
    for (let h = 0; h < width - 1; h++) {
      found[h] += (tails[at * width + h] - tails[at * width + h + 1]) / TAIL / (last - first + 1);
    }
  return found;
}
function distances({ simulated, dt }, { tau, thetas, H, n, open: open2 }) {
  if (!simulated) return new Float64Array();
  const { tails, width, length } = simulated, out = new Float64Array(length).fill(NaN), low = new Float64Array(H + 1);
  if (width !== H + 1) return out;
  for (let step = 0; step < length; step++) {
    const row = Math.round(step / dt), from = step * width;
    if (row >= n || Math.abs(row * dt - step) >= 1e-9) continue;
    for (let h = 0; h < H; h++)
      low[h + 1] = low[h] + tau[row * H + h] / dt - (tails[from + h] - tails[from + h + 1]) / TAIL;
    out[step] = 0;
    const area = (left, right, x, x2) => {
      out[step] += (Math.abs(left) + Math.abs(right)) / 2 * (x2 - x);
    };
    for (let h = Number(open2); h < H - Number(open2); h++) {
      const x = thetas[h], x2 = thetas[h + 1], zero = Math.min(x2, Math.max(x, 0));
      const middle = low[h] + (zero - x) / (x2 - x) * (low[h + 1] - low[h]);
      area(low[h], middle, x, zero);
      area(low[H] - middle, low[H] - low[h + 1], zero, x2);
    }
  }
  return out;
}
function distancesOf({ model, seen, images }) {
  if (images.distancesFor !== seen) Object.assign(images, { distances: distances(model, seen), distancesFor: seen });
  return images.distances;
}
function drawDistances(pen, scene, strip, Y) {
  const {
    model: { simulated, dt },
    colours
  } = scene, found = distancesOf(scene);
  const steps = [...found.keys()].filter((step) => Number.isFinite(found[step]));
  if (!simulated || !steps.length) return;
  const [, most] = rounded(0, Math.max(...steps.map((step) => Math.max(found[step], simulated.chance[step]))));
  const X = (value) => strip.x + strip.w * value / most, half = 0.5 / dt, { y, h } = strip;
  const area = (values) => [
    [X(0), Y(steps[0] / dt - half)],
    ...steps.flatMap((step) => [
      [X(values[step]), Y(step / dt - half)],
      [X(values[step]), Y(step / dt + half)]
    ]),
    [X(0), Y(steps[steps.length - 1] / dt + half)]
  ];
  pen.clip(strip.x - 1, y, strip.w + 2, h, () => {
    pen.path(area(found), { fill: BAND, stroke: CAME_TRUE, width: 1, close: true });
    pen.path(area(simulated.chance), { fill: "rgba(138,143,152,0.5)", close: true });
  });
  pen.text(short(most), X(most), y + h + 13, { size: 10, align: "right", colour: colours.soft });
  pen.text("W1", strip.x + strip.w / 2, y + h + 27, { size: 11, align: "center", colour: colours.text });
}
function drawSimulated(pen, mean, error, { X, Y }) {
  const xs = Array.from(mean, (_, step) => X(step)), edge = (side) => Array.from(mean, (value, step) => [xs[step], Y(value + side * error[step])]);
  pen.path([...edge(2), ...edge(-2).reverse()], { fill: BAND, close: true });
  line(pen, xs, mean.map(Y), { stroke: CAME_TRUE, width: 1.4 });
}
var CAME_TRUE, BAND, TAIL, simulatedFor, simulatedWords;
var init_simulated = __esm({
  "app/js/lens/simulated.js"() {
    init_drawing();
    CAME_TRUE = "#d6336c";
    BAND = "rgba(214,51,108,0.2)";
    TAIL = 65535;
    simulatedFor = ({ model, state }) => model.simulated?.action === state.action ? model.simulated : void 0;
    simulatedWords = (scene) => {
      const found = simulatedFor(scene), far = found && distancesOf(scene).filter(Number.isFinite);
      return found && far?.length ? ` ${found.count} simulated continuations are outlined; the distance to them is ${short(far.reduce((a, b) => a + b) / far.length)} reward on average.` : "";
    };
  }
});

// app/js/lens/export.js
function save(content, name, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
}
function heading(pen, { verdict, scene: { model, state, colours } }) {
  const lines = [""];
  for (const word of verdict.split(" ")) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim();
    if (pen.width(longer, 14) > WIDE - 2 * SIZE.gap) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  lines.slice(0, 2).forEach((line2, i) => pen.text(line2, SIZE.gap, 20 + 17 * i, { size: 14, colour: colours.text }));
  const { header } = model, rows = { none: "as decoded", survival: "given survival", paper: "rescaled to 1" }[state.normalise];
  pen.text(
    [
      header.world,
      header.state,
      header.actions[state.action],
      `α ${short(state.alpha)}`,
      `T ${short(state.horizon)}`,
      `rows ${rows}`
    ].filter(Boolean).join(" · "),
    SIZE.gap,
    56,
    { size: 12, colour: colours.soft }
  );
}
async function savePng(lens2) {
  const dense = 2, { colours } = lens2.scene, worlds = await worldOf(lens2, "png");
  const canvas = document.createElement("canvas"), high = heightOf(worlds.length + lens2.panels.length);
  Object.assign(canvas, { width: WIDE * dense, height: high * dense });
  const context = contextOf(canvas), pen = canvasPen(context, colours.font);
  context.scale(dense, dense);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, WIDE, high);
  heading(pen, lens2);
  for (const address of worlds) {
    const image = Object.assign(new Image(), { src: address });
    await image.decode();
    const [x, y] = place(0);
    context.drawImage(image, x, y, SIZE.w, SIZE.h);
  }
  lens2.panels.forEach((each, i) => {
    context.save();
    const [x, y] = place(i + worlds.length);
    context.translate(x, y);
    lens2.drawOne(pen, each, SIZE.w, SIZE.h);
    context.restore();
  });
  canvas.toBlob((blob) => blob && save(blob, `${nameOf(lens2)}.png`));
}
async function svgOf(lens2) {
  const { colours } = lens2.scene, measure = canvasPen(contextOf(document.createElement("canvas")), colours.font).width;
  const worlds = await worldOf(lens2, "svg"), pen = svgPen(colours.font, measure), high = heightOf(worlds.length + lens2.panels.length);
  heading(pen, lens2);
  for (const address of worlds) {
    const [x, y] = place(0);
    pen.parts.push(`<image href="${escaped(address)}" x="${x}" y="${y}" width="${SIZE.w}" height="${SIZE.h}"/>`);
  }
  lens2.panels.forEach((each, i) => {
    pen.parts.push(`<g transform="translate(${place(i + worlds.length).join(" ")})">`);
    lens2.drawOne(pen, each, SIZE.w, SIZE.h);
    pen.parts.push("</g>");
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDE} ${high}" width="${WIDE}" height="${high}"><rect width="100%" height="100%" fill="${colours.paper}"/>${pen.parts.join("\n")}</svg>`;
}
function savePanel(lens2, each, format) {
  const { colours } = lens2.scene, canvas = document.createElement("canvas"), name = `${nameOf(lens2)}_${each.panel.name}`, { w, h } = SIZE;
  if (format === "svg") {
    const pen = svgPen(colours.font, canvasPen(contextOf(canvas), colours.font).width);
    lens2.drawOne(pen, each, w, h);
    const content = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${w} ${h}" width="${w}" height="${h}"><rect width="100%" height="100%" fill="${colours.paper}"/>${pen.parts.join("\n")}</svg>`;
    save(content, `${name}.svg`, "image/svg+xml");
    return;
  }
  Object.assign(canvas, { width: 2 * w, height: 2 * h });
  const context = contextOf(canvas);
  context.scale(2, 2);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, w, h);
  lens2.drawOne(canvasPen(context, colours.font), each, w, h);
  canvas.toBlob((blob) => blob && save(blob, `${name}.png`));
}
function csvOf({ scene }) {
  const { model, seen, state } = scene, simulated = simulatedFor(scene), far = simulated && distancesOf(scene);
  const came = (tau) => simulated && far ? [...["reward", "rewardError", "survival", "survivalError"].map((name) => simulated[name][tau]), far[tau]] : [];
  const names = model.header.actions, a = state.action;
  const head = [
    "tau",
    "reward",
    "survival",
    ...seen.truth ? ["true reward", "true survival"] : [],
    "horizon",
    ...names.map((name) => `value of ${name}`),
    ...simulated ? ["simulated reward", "its error", "simulated survival", "its error", "W1"] : [],
    ...seen.truth ? ["best action"] : [],
    ...Array.from(
      seen.midpoints,
      (theta, h) => `P ${!seen.open || h && h < seen.H - 1 ? "at" : h ? "above" : "below"} ${+theta.toPrecision(8)}`
    )
  ];
  const rows = Array.from({ length: model.K }, (_, k) => [
    k * model.dt,
    seen.rewards[a][k],
    seen.survival[a][k],
    ...seen.truth ? [seen.truth.rewards[a][k], seen.truth.survival[a][k]] : [],
    model.horizons[k],
    ...seen.values.map((line2) => line2[k]),
    ...came(k * model.dt),
    ...seen.truth ? [quoted(names[seen.bestAt(k)])] : [],
    ...k < seen.n ? seen.tau.slice(k * seen.H, (k + 1) * seen.H) : Array(seen.H).fill("")
  ]);
  const { world, state: from_state } = model.header, gammas = Array.from(seen.grid.gammas);
  return [
    `# ${commented({ world, from_state, ...state, action: names[a], gammas })}`,
    head.map(quoted).join(","),
    ...rows.map((row) => row.map((x) => x ?? "").join(","))
  ].join("\n");
}
function htmlOf({ told, scene: { model, state } }, still, template) {
  const bytes = model.bytes ?? new Uint8Array();
  let text = "";
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  const held = { state, base: told.base, still, payload: btoa(text) };
  return template.replace(HELD, (tag) => tag + JSON.stringify(held).replace(/</g, "\\u003c"));
}
var SIZE, WIDE, place, heightOf, commented, quoted, nameOf, worldOf, saveSvg, saveCsv, HELD, saveHtml;
var init_export = __esm({
  "app/js/lens/export.js"() {
    init_drawing();
    init_simulated();
    SIZE = { w: 440, h: 260, gap: 16, head: 66, columns: 3 };
    WIDE = SIZE.columns * (SIZE.w + SIZE.gap) + SIZE.gap;
    place = (i) => [
      SIZE.gap + i % SIZE.columns * (SIZE.w + SIZE.gap),
      SIZE.head + Math.floor(i / SIZE.columns) * (SIZE.h + SIZE.gap)
    ];
    heightOf = (count) => SIZE.head + Math.ceil(count / SIZE.columns) * (SIZE.h + SIZE.gap);
    commented = (value) => JSON.stringify(value, (_, each) => typeof each === "string" ? each.replaceAll(",", "\0") : each).replaceAll(
      "\\u0000",
      "\\u002c"
    );
    quoted = (words) => `"${`${/^[=+@\t\r\n-]/.test(words) ? "'" : ""}${words}`.replace(/"/g, '""')}"`;
    nameOf = ({ scene: { model } }) => `lens_${model.header.world.replace(/[^A-Za-z0-9_-]+/g, "_").slice(0, 40)}`;
    worldOf = async (lens2, format) => lens2.world ? [await lens2.world.picture(format)] : [];
    saveSvg = async (lens2) => save(await svgOf(lens2), `${nameOf(lens2)}.svg`, "image/svg+xml");
    saveCsv = (lens2) => save(csvOf(lens2), `${nameOf(lens2)}.csv`, "text/csv");
    HELD = '<script id="held" type="application/json">';
    saveHtml = async (lens2) => {
      const { template } = lens2.told;
      if (!lens2.scene.model.bytes || !template) return;
      const [still] = await worldOf(lens2, "svg");
      save(htmlOf(lens2, still, await template()), `${nameOf(lens2)}.html`, "text/html");
    };
  }
});

// app/js/lens/help.js
function framed({ name, title, why: [words, formula] }, picture, files) {
  const help = element(
    "details",
    { class: "help" },
    element("summary", { "aria-label": `what ${title} shows`, title: `what ${title} shows` }, "?"),
    element(
      "div",
      { tabindex: -1 },
      // a click on its words leaves it open
      element("p", {}, words),
      element("code", {}, formula),
      element(
        "span",
        { class: "group" },
        "Save this picture",
        ...files.map(
          ([format, save2]) => element(
            "button",
            { type: "button", class: "tool", "aria-label": `save ${title} as ${format}`, onclick: save2 },
            format
          )
        )
      )
    )
  );
  help.onkeydown = (event) => {
    if (event.key !== "Escape" || !help.open) return;
    help.open = false;
    help.querySelector("summary")?.focus();
  };
  help.addEventListener("focusout", ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && help.contains(relatedTarget))) help.open = false;
  });
  return element("div", { class: `picture of-${name}` }, element("h2", { class: "unseen" }, title), picture, help);
}
var WORLD;
var init_help = __esm({
  "app/js/lens/help.js"() {
    init_elements();
    WORLD = {
      name: "world",
      title: "World",
      why: [
        "The states and actions of the world; numbers are rewards. The state and the action of this view are highlighted. Click a state to see its timeline.",
        "P(s′, r | s, a)"
      ]
    };
  }
});

// app/js/print/layout.js
function layoutOf(count, mm, lines) {
  const width = mm * PER_MM, columns = mm > 100 && count > 1 ? 2 : 1, rows = Math.ceil(count / columns);
  const inner = width - 2 * EDGE, w = (inner - (columns - 1) * GAP) / columns, h = w * (w > 400 ? 0.5 : 0.66);
  const cells = Array.from({ length: count }, (_, i) => {
    const row = Math.floor(i / columns), filled2 = Math.min(columns, count - row * columns), first = EDGE + (inner - filled2 * w - (filled2 - 1) * GAP) / 2;
    return { x: first + i % columns * (w + GAP), y: EDGE + row * (h + GAP), w, h };
  });
  const caption = EDGE + rows * h + (rows - 1) * GAP + CAPTION.before + CAPTION.size;
  return {
    width,
    height: caption + (lines - 1) * CAPTION.line + CAPTION.size * 0.3 + EDGE,
    cells,
    caption,
    left: EDGE
  };
}
function wrapped(words, width, measure) {
  const lines = [""];
  for (const word of words.split(" ")) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim();
    if (measure(longer) <= width) {
      lines[lines.length - 1] = longer;
      continue;
    }
    if (lines[lines.length - 1]) lines.push("");
    for (const sign of word) {
      const last = lines[lines.length - 1];
      if (last && measure(last + sign) > width) lines.push(sign);
      else lines[lines.length - 1] = last + sign;
    }
  }
  return lines;
}
var PER_MM, WIDTHS, EDGE, GAP, CAPTION, captionLines, typeset, shifted;
var init_layout = __esm({
  "app/js/print/layout.js"() {
    PER_MM = 96 / 25.4;
    WIDTHS = [85, 180];
    EDGE = 4;
    GAP = 14;
    CAPTION = { size: 10, line: 13.5, before: 10 };
    captionLines = (words, mm, measure) => wrapped(words, mm * PER_MM - 2 * EDGE, (line2) => measure(line2, CAPTION.size));
    typeset = (words) => String(words).replace(/(^|[\s(])-(?=[\d.])/g, "$1−");
    shifted = (pen, { x: left, y: top2 }) => ({
      path: (points, style) => pen.path(
        points.map((point) => point && [point[0] + left, point[1] + top2]),
        style
      ),
      text: (words, x, y, style) => pen.text(typeset(words), x + left, y + top2, style),
      image: (source, x, y, w, h) => pen.image(source, x + left, y + top2, w, h),
      clip: (x, y, w, h, draw) => pen.clip(x + left, y + top2, w, h, draw),
      width: (words, ...style) => pen.width(typeset(words), ...style)
    });
  }
});

// app/js/print/caption.js
function captionOf(scene, names) {
  const { model, state, seen } = scene, { header, sloped, arrays } = model, { gammas, G } = seen.grid, { thetas, H, open: open2 } = seen;
  const slope = arrays.places ? `${short(state.slope_share)} of the trained slope` : `slope ${short(state.slope)} / reward`;
  const parts = [
    `World ${header.world}`,
    header.state && `state ${header.state}`,
    `action ${header.actions[state.action]}`,
    `α = ${short(state.alpha)}`,
    header.solver === "tikhonov" ? "solver Tikhonov, filter factors s²/(s² + α²)" : `solver ${header.solver}`,
    `T = ${some(+short(state.horizon), "step")}`,
    state.used && `${some(state.used, "step")} used`,
    state.softness && `deadline softness ${short(state.softness)} T`,
    state.value_gamma < 1 && `γ in the value ${short(state.value_gamma, 4)}`,
    (sloped || arrays.places) && slope,
    state.noise && `noise ${short(state.noise)}, seed ${state.noise_seed}`
  ];
  const grid = [
    `${some(G, "discount")} γ from ${range(gammas, 0, G - 1)}${header.added ? `, ${header.added} added in each gap` : ""}`,
    `${some(open2 ? H - 1 : H + 1, "sensitivit").replace(/t$/, "ty").replace(/ts$/, "ties")} θ from ${open2 ? range(thetas, 1, H - 1) : range(thetas, 0, H)} reward`,
    `${some(model.K, "row")} τ of ${some(+short(model.dt), "step")}`
  ];
  const switched = Object.entries(SWITCHES).filter(([name, each]) => name !== "rescale" && available(model, name) && each.isOn(state)).map(([, each]) => each.label);
  const mark = state.look === "surface" ? "Orange line" : "White outline", drawn = [];
  if (names.includes("tau-space") && seen.truth) drawn.push(`${mark}: true timeline.`);
  if (names.includes("tau-space") && !seen.truth && simulatedFor(scene))
    drawn.push(`${mark}: simulated continuations.`);
  if (names.includes("values") && seen.truth) drawn.push("Dotted: true values.");
  if (scene.pinned && names.some((name) => name === "values" || name === "rewards")) drawn.push("Dashed: view A.");
  return typeset(
    [
      `${parts.filter(Boolean).join(", ")}.`,
      `Grid: ${grid.join("; ")}.`,
      `Rows ${ROWS[state.normalise]}.`,
      switched.length ? `Switched on: ${switched.join(", ")}.` : "",
      ...drawn
    ].filter(Boolean).join(" ")
  );
}
var ROWS, range, some;
var init_caption = __esm({
  "app/js/print/caption.js"() {
    init_maths();
    init_drawing();
    init_layout();
    init_simulated();
    ROWS = { none: "as decoded", survival: "given survival", paper: "rescaled to probability 1" };
    range = (values, first, last) => `${short(values[first])} to ${short(values[last])}`;
    some = (number, words) => `${number} ${words}${number === 1 ? "" : "s"}`;
  }
});

// app/js/print/glyphs.js
var regular2, bold;
var init_glyphs = __esm({
  "app/js/print/glyphs.js"() {
    regular2 = { "": [653, "m89 0l0-660l476 0l0 660zm108-58l257 0l-73-132l-52-103l-4 0l-54 103zm128-329l4 0l49-94l66-119l-236 0l67 119zm-171 277l127-230l-127-233zm344 0l0-463l-126 233z"], " ": [200, ""], "!": [289, "m116-198l-11-378l-2-94l83 0l-2 94l-11 378zm29 210q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], '"': [426, "m99-431l-16-167l-3-92l88 0l-3 92l-16 167zm177 0l-16-167l-3-92l88 0l-3 92l-16 167z"], "#": [497, "m88 0l25-201l-79 0l0-63l85 0l18-143l-83 0l0-63l90 0l24-180l60 0l-24 180l125 0l24-180l60 0l-24 180l80 0l0 63l-86 0l-19 143l85 0l0 63l-92 0l-24 201l-60 0l24-201l-124 0l-25 201zm91-264l125 0l19-143l-126 0z"], "$": [497, "m245 12q-57 0-108.5-21.5q-51.5-21.5-84.5-59.5l39-51q31 29 69.5 46.5q38.5 17.5 84.5 17.5q55 0 83-30q28-30 28-79q0-35-20-60q-20-25-52-44.5q-32-19.5-67.5-39q-35.5-19.5-67.5-42.5q-32-23-52-54q-20-31-20-76q0-50 22.5-88q22.5-38 63-59.5q40.5-21.5 93.5-21.5q58 0 98.5 22q40.5 22 69.5 57l-44 45q-23-27-52.5-41q-29.5-14-70.5-14q-45 0-72 26.5q-27 26.5-27 69.5q0 32 20 55q20 23 52 41.5q32 18.5 67.5 37.5q35.5 19 67.5 42.5q32 23.5 52 56.5q20 33 20 81q0 55-24 96q-24 41-67 64q-43 23-101 23zm-23 98l0-127l60 0l0 127zm0-729l0-129l60 0l0 129z"], "%": [824, "m184-254q-45 0-78.5-24.5q-33.5-24.5-52-71q-18.5-46.5-18.5-112.5q0-99 41-152.5q41-53.5 108-53.5q67 0 108 53.5q41 53.5 41 152.5q0 66-18.5 112.5q-18.5 46.5-52 71q-33.5 24.5-78.5 24.5zm0-51q39 0 62.5-39.5q23.5-39.5 23.5-117.5q0-79-23.5-117q-23.5-38-62.5-38q-38 0-62.5 38q-24.5 38-24.5 117q0 78 24.5 117.5q24.5 39.5 62.5 39.5zm19 317l362-680l56 0l-362 680zm438 0q-45 0-78.5-24.5q-33.5-24.5-52-71q-18.5-46.5-18.5-112.5q0-99 41-152.5q41-53.5 108-53.5q67 0 108 53.5q41 53.5 41 152.5q0 66-18.5 112.5q-18.5 46.5-52 71q-33.5 24.5-78.5 24.5zm0-51q39 0 62.5-39.5q23.5-39.5 23.5-117.5q0-79-23.5-117q-23.5-38-62.5-38q-38 0-62.5 38q-24.5 38-24.5 117q0 78 24.5 117.5q24.5 39.5 62.5 39.5z"], "&": [609, "m236 12q-59 0-105-22q-46-22-72.5-63q-26.5-41-26.5-97q0-48 21.5-85q21.5-37 56-65.5q34.5-28.5 72.5-53q38-24.5 72-49q34-24.5 56-52q22-27.5 22-62.5q0-29-14.5-50.5q-14.5-21.5-47.5-21.5q-36 0-58.5 27q-22.5 27-22.5 68q0 47 23 98.5q23 51.5 60.5 102.5q37.5 51 84 97q46.5 46 93.5 82q39 30 77.5 49q38.5 19 66.5 29l-22 68q-39-11-82.5-34q-43.5-23-89.5-57q-53-42-104-95q-51-53-91-111.5q-40-58.5-63.5-116.5q-23.5-58-23.5-111q0-43 19-78.5q19-35.5 53-56q34-20.5 80-20.5q61 0 95 36q34 36 34 94q0 42-21 75.5q-21 33.5-53.5 61.5q-32.5 28-69.5 54q-37 26-69.5 51.5q-32.5 25.5-53 55q-20.5 29.5-20.5 65.5q0 38 17.5 65q17.5 27 47 41.5q29.5 14.5 64.5 14.5q42 0 80-21.5q38-21.5 71-55.5q40-43 70-99.5q30-56.5 47-123.5l77 0q-20 73-54.5 140q-34.5 67-82.5 123q-40 45-91.5 74q-51.5 29-121.5 29z"], "'": [249, "m99-431l-16-167l-3-92l88 0l-3 92l-16 167z"], "(": [303, "m214 176q-62-101-97-211.5q-35-110.5-35-242.5q0-132 35-243q35-111 97-211l51 24q-58 95-86.5 205.5q-28.5 110.5-28.5 224.5q0 114 28.5 224q28.5 110 86.5 206z"], ")": [303, "m89 176l-51-24q58-96 86.5-206q28.5-110 28.5-224q0-114-28.5-224.5q-28.5-110.5-86.5-205.5l51-24q63 100 97.5 211q34.5 111 34.5 243q0 132-34.5 242.5q-34.5 110.5-97.5 211.5z"], "*": [418, "m138-420l-40-29l57-94l-97-40l15-46l102 25l9-108l49 0l9 107l103-24l15 46l-97 40l56 94l-39 29l-71-86z"], "+": [497, "m216-104l0-195l-182 0l0-62l182 0l0-195l65 0l0 195l182 0l0 62l-182 0l0 195z"], ",": [249, "m67 170l-20-48q43-19 67-51.5q24-32.5 23-72.5l-9-74l41 60q-9 9-19.5 13q-10.5 4-22.5 4q-24 0-41.5-15q-17.5-15-17.5-42q0-27 18.5-42.5q18.5-15.5 42.5-15.5q33 0 51 25.5q18 25.5 18 71.5q0 64-35 113q-35 49-96 74z"], "-": [311, "m41-219l0-63l230 0l0 63z"], ".": [249, "m125 12q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], "/": [350, "m10 160l267-870l60 0l-267 870z"], "0": [497, "m249 12q-96 0-150.5-86.5q-54.5-86.5-54.5-246.5q0-161 54.5-245q54.5-84 150.5-84q95 0 149.5 84.5q54.5 84.5 54.5 244.5q0 160-54.5 246.5q-54.5 86.5-149.5 86.5zm0-66q37 0 65-28q28-28 43.5-87q15.5-59 15.5-152q0-94-15.5-152q-15.5-58-43.5-84.5q-28-26.5-65-26.5q-38 0-66 26.5q-28 26.5-43.5 84.5q-15.5 58-15.5 152q0 93 15.5 152q15.5 59 43.5 87q28 28 66 28z"], "1": [497, "m79 0l0-68l146 0l0-470l-116 0l0-53q43-8 76-19.5q33-11.5 59-27.5l63 0l0 570l132 0l0 68z"], "2": [497, "m40 0l0-50q95-94 162.5-166.5q67.5-72.5 102.5-131.5q35-59 35-110q0-55-30-90q-30-35-91-35q-40 0-74 22q-34 22-62 55l-46-45q40-45 85.5-72q45.5-27 106.5-27q59 0 102 23.5q43 23.5 66 65.5q23 42 23 98q0 62-34.5 123q-34.5 61-94.5 128q-60 67-138 147q26-3 54-4.5q28-1.5 53-1.5l192 0l0 71z"], "3": [497, "m236 12q-51 0-90.5-13q-39.5-13-68.5-33q-29-20-51-44l42-54q29 30 67.5 53q38.5 23 95.5 23q58 0 95-32q37-32 37-85q0-38-19.5-66.5q-19.5-28.5-64-44.5q-44.5-16-120.5-16l0-63q68 0 107.5-16q39.5-16 56.5-42.5q17-26.5 17-60.5q0-47-29.5-74q-29.5-27-80.5-27q-40 0-74 18q-34 18-62 47l-44-52q37-35 82-57.5q45-22.5 101-22.5q56 0 99 19q43 19 67.5 55q24.5 36 24.5 88q0 58-32 95q-32 37-84 57l0 4q39 9 70 30.5q31 21.5 49.5 54.5q18.5 33 18.5 77q0 57-28 97.5q-28 40.5-76 62.5q-48 22-106 22z"], "4": [497, "m304 0l0-427q0-25 2-61.5q2-36.5 3-61.5l-4 0q-12 23-25 44.5q-13 21.5-27 45.5l-149 218l365 0l0 66l-452 0l0-54l273-408l92 0l0 638z"], "5": [497, "m234 12q-51 0-90-12.5q-39-12.5-68-32.5q-29-20-51-42l40-54q29 28 67 50.5q38 22.5 94 22.5q39 0 70.5-18q31.5-18 50.5-50.5q19-32.5 19-77.5q0-66-37-103q-37-37-99-37q-32 0-56 10q-24 10-53 29l-44-28l21-307l319 0l0 71l-247 0l-17 189q23-12 46-19q23-7 52-7q55 0 100 21q45 21 71.5 65.5q26.5 44.5 26.5 113.5q0 69-30.5 117.5q-30.5 48.5-79.5 73.5q-49 25-105 25z"], "6": [497, "m268 12q-47 0-87-19q-40-19-69.5-57.5q-29.5-38.5-46.5-96q-17-57.5-17-134.5q0-96 20-163.5q20-67.5 54-109.5q34-42 77.5-62q43.5-20 91.5-20q52 0 89.5 19.5q37.5 19.5 64.5 48.5l-46 51q-19-23-47-36.5q-28-13.5-58-13.5q-45 0-83.5 27q-38.5 27-61.5 89.5q-23 62.5-23 169.5q0 79 16.5 133q16.5 54 48.5 81.5q32 27.5 77 27.5q31 0 56.5-17.5q25.5-17.5 40-49q14.5-31.5 14.5-73.5q0-41-13-71.5q-13-30.5-39-47q-26-16.5-66-16.5q-31 0-67.5 20.5q-36.5 20.5-69.5 69.5l-3-65q31-40 72-63.5q41-23.5 82-23.5q55 0 96 22q41 22 63.5 66q22.5 44 22.5 109q0 61-26 107q-26 46-69 72q-43 26-94 26z"], "7": [497, "m171 0q4-90 16.5-165.5q12.5-75.5 35-142q22.5-66.5 57-130q34.5-63.5 83.5-129.5l-319 0l0-71l411 0l0 51q-57 72-94.5 138.5q-37.5 66.5-59 134.5q-21.5 68-31.5 144q-10 76-14 170z"], "8": [497, "m250 12q-60 0-107.5-22.5q-47.5-22.5-74.5-62.5q-27-40-27-90q0-42 17.5-74.5q17.5-32.5 45-57q27.5-24.5 57.5-40.5l0-4q-35-25-62-61q-27-36-27-86q0-49 24-86q24-37 64.5-57.5q40.5-20.5 92.5-20.5q83 0 131.5 47.5q48.5 47.5 48.5 122.5q0 33-14 62.5q-14 29.5-34 53q-20 23.5-40 38.5l0 4q28 16 53.5 38q25.5 22 41.5 52.5q16 30.5 16 73.5q0 47-25.5 85.5q-25.5 38.5-72 61.5q-46.5 23-108.5 23zm45-360q33-29 50-61q17-32 17-67q0-31-13-56.5q-13-25.5-38-41q-25-15.5-60-15.5q-44 0-73.5 28.5q-29.5 28.5-29.5 74.5q0 38 20.5 63q20.5 25 54 42.5q33.5 17.5 72.5 32.5zm-43 299q37 0 65-14q28-14 44-39.5q16-25.5 16-58.5q0-41-24-67q-24-26-63-44.5q-39-18.5-86-37.5q-38 25-63.5 60q-25.5 35-25.5 79q0 35 18 62.5q18 27.5 49 43.5q31 16 70 16z"], "9": [497, "m205 12q-51 0-89-19.5q-38-19.5-65-47.5l46-52q20 23 47.5 37q27.5 14 57.5 14q46 0 84-27.5q38-27.5 61.5-90q23.5-62.5 23.5-169.5q0-79-17-132.5q-17-53.5-48.5-81.5q-31.5-28-77.5-28q-31 0-56 17.5q-25 17.5-40 49q-15 31.5-15 73.5q0 41 13.5 71.5q13.5 30.5 39.5 47q26 16.5 65 16.5q31 0 68-20.5q37-20.5 69-69.5l3 65q-29 40-71 63.5q-42 23.5-83 23.5q-55 0-96-22q-41-22-63-66q-22-44-22-109q0-61 25.5-107.5q25.5-46.5 68.5-72q43-25.5 94-25.5q47 0 87.5 19q40.5 19 70 57.5q29.5 38.5 46 96q16.5 57.5 16.5 134.5q0 96-20 164q-20 68-54 110q-34 42-77.5 61.5q-43.5 19.5-91.5 19.5z"], ":": [249, "m125-349q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5zm0 361q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], ";": [249, "m125-349q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5zm-58 519l-20-48q43-19 67-51.5q24-32.5 23-72.5l-9-74l41 60q-9 9-19.5 13q-10.5 4-22.5 4q-24 0-41.5-15q-17.5-15-17.5-42q0-27 18.5-42.5q18.5-15.5 42.5-15.5q33 0 51 25.5q18 25.5 18 71.5q0 64-35 113q-35 49-96 74z"], "<": [497, "m463-131l-429-168l0-66l429-168l0 71l-211 78l-134 50l0 4l134 50l211 78z"], "=": [497, "m34-406l0-62l429 0l0 62zm0 214l0-62l429 0l0 62z"], ">": [497, "m34-131l0-71l211-78l134-50l0-4l-134-50l-211-78l0-71l429 168l0 66z"], "?": [425, "m160-198q-7-47 5-83.5q12-36.5 33.5-66q21.5-29.5 44-56.5q22.5-27 38.5-54q16-27 16-59q0-27-11-49q-11-22-32.5-35q-21.5-13-53.5-13q-32 0-61.5 15.5q-29.5 15.5-53.5 42.5l-47-43q32-36 74.5-59.5q42.5-23.5 97.5-23.5q50 0 88 19.5q38 19.5 58.5 55q20.5 35.5 20.5 85.5q0 39-16 70.5q-16 31.5-39.5 60q-23.5 28.5-45.5 57q-22 28.5-35 61.5q-13 33-9 75zm38 210q-24 0-41.5-17.5q-17.5-17.5-17.5-44.5q0-29 17.5-46.5q17.5-17.5 41.5-17.5q25 0 42.5 17.5q17.5 17.5 17.5 46.5q0 27-17.5 44.5q-17.5 17.5-42.5 17.5z"], "@": [847, "m403 155q-73 0-137-23q-64-23-112.5-68.5q-48.5-45.5-75.5-112.5q-27-67-27-154q0-101 33-182.5q33-81.5 91-140q58-58.5 133.5-89.5q75.5-31 159.5-31q101 0 174.5 41.5q73.5 41.5 114 116q40.5 74.5 40.5 173.5q0 66-18 116.5q-18 50.5-47.5 84q-29.5 33.5-65 50.5q-35.5 17-69.5 17q-42 0-70.5-19.5q-28.5-19.5-33.5-58.5l-2 0q-24 31-56.5 51q-32.5 20-65.5 20q-52 0-87.5-37.5q-35.5-37.5-35.5-106.5q0-41 13.5-82q13.5-41 39.5-75.5q26-34.5 62-55.5q36-21 80-21q26 0 46 12q20 12 34 38l2 0l11-41l55 0l-39 201q-13 60 0.5 87.5q13.5 27.5 52.5 27.5q31 0 60-24.5q29-24.5 48.5-70.5q19.5-46 19.5-110q0-58-17-107.5q-17-49.5-51.5-86q-34.5-36.5-84.5-57q-50-20.5-117-20.5q-65 0-126 26.5q-61 26.5-110 76q-49 49.5-77.5 119q-28.5 69.5-28.5 155.5q0 71 21.5 126.5q21.5 55.5 61 93.5q39.5 38 92.5 58q53 20 115 20q45 0 85.5-11.5q40.5-11.5 74.5-29.5l24 53q-44 25-91 38q-47 13-99 13zm-18-270q21 0 44-14q23-14 48-44l29-158q-14-22-29.5-31q-15.5-9-34.5-9q-39 0-66.5 26.5q-27.5 26.5-43 65q-15.5 38.5-15.5 76.5q0 47 19.5 67.5q19.5 20.5 48.5 20.5z"], "A": [543, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66z"], "B": [588, "m90 0l0-656l195 0q66 0 117 16q51 16 79.5 51.5q28.5 35.5 28.5 92.5q0 51-24.5 89.5q-24.5 38.5-71.5 53.5l0 4q62 11 98 49.5q36 38.5 36 104.5q0 66-31.5 109q-31.5 43-87.5 64.5q-56 21.5-130 21.5zm83-377l97 0q84 0 121-29q37-29 37-79q0-58-39-81.5q-39-23.5-115-23.5l-101 0zm0 311l114 0q85 0 132-31.5q47-31.5 47-97.5q0-61-46-89.5q-46-28.5-133-28.5l-114 0z"], "C": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5z"], "D": [615, "m90 0l0-656l164 0q101 0 170 38q69 38 104.5 110.5q35.5 72.5 35.5 176.5q0 104-35.5 178.5q-35.5 74.5-103.5 113.5q-68 39-167 39zm83-68l75 0q77 0 128-31.5q51-31.5 76-89.5q25-58 25-142q0-82-25-140q-25-58-76-87.5q-51-29.5-128-29.5l-75 0z"], "E": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71z"], "F": [494, "m90 0l0-656l378 0l0 70l-295 0l0 222l250 0l0 70l-250 0l0 294z"], "G": [617, "m348 12q-87 0-153.5-40.5q-66.5-40.5-104.5-116.5q-38-76-38-183q0-79 22.5-142q22.5-63 63-107.5q40.5-44.5 95.5-67.5q55-23 120-23q68 0 114.5 25q46.5 25 74.5 56l-46 52q-24-26-57.5-43q-33.5-17-83.5-17q-66 0-115 32.5q-49 32.5-75.5 91.5q-26.5 59-26.5 141q0 83 25.5 143q25.5 60 74 93q48.5 33 118.5 33q35 0 67-10.5q32-10.5 51-28.5l0-171l-139 0l0-69l215 0l0 276q-31 33-83.5 54.5q-52.5 21.5-118.5 21.5z"], "H": [652, "m90 0l0-656l83 0l0 275l306 0l0-275l83 0l0 656l-83 0l0-309l-306 0l0 309z"], "I": [263, "m90 0l0-656l83 0l0 656z"], "J": [479, "m207 12q-59 0-103-26.5q-44-26.5-71-79.5l56-37q20 36 48.5 52.5q28.5 16.5 64.5 16.5q54 0 80.5-32.5q26.5-32.5 26.5-108.5l0-453l83 0l0 461q0 57-18.5 104q-18.5 47-59.5 75q-41 28-107 28z"], "K": [579, "m90 0l0-656l83 0l0 329l3 0l273-329l94 0l-205 250l237 406l-93 0l-196-341l-113 133l0 208z"], "L": [486, "m90 0l0-656l83 0l0 585l287 0l0 71z"], "M": [727, "m90 0l0-656l105 0l124 351q12 33 22.5 66q10.5 33 21.5 70l4 0q11-37 21-70q10-33 21-66l124-351l104 0l0 656l-78 0l0-361q0-29 2-65q2-36 4.5-71.5q2.5-35.5 5.5-64.5l-4 0l-51 158l-123 339l-61 0l-123-339l-51-158l-4 0q3 29 5.5 64.5q2.5 35.5 4.5 71.5q2 36 2 65l0 361z"], "N": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343z"], "O": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33z"], "P": [566, "m90 0l0-656l187 0q74 0 129 18.5q55 18.5 86 60.5q31 42 31 114q0 69-30.5 113.5q-30.5 44.5-85 67q-54.5 22.5-126.5 22.5l-108 0l0 260zm83-328l98 0q86 0 127.5-33q41.5-33 41.5-102q0-71-43.5-98.5q-43.5-27.5-129.5-27.5l-94 0z"], "Q": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-118.5q-35.5-76.5-35.5-182.5q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 106-36 182.5q-36 76.5-99 118.5q-63 42-146 42zm0-69q59 0 102.5-33.5q43.5-33.5 67.5-95q24-61.5 24-145.5q0-81-24-140.5q-24-59.5-67.5-91.5q-43.5-32-102.5-32q-58 0-102 32q-44 32-68 91.5q-24 59.5-24 140.5q0 84 24 145.5q24 61.5 68 95q44 33.5 102 33.5zm201 222q-94 0-157-48q-63-48-89-119l87-7q13 35 37.5 58q24.5 23 58 34.5q33.5 11.5 72.5 11.5q22 0 39-2.5q17-2.5 30-6.5l16 63q-15 6-39.5 11q-24.5 5-54.5 5z"], "R": [569, "m90 0l0-656l205 0q67 0 119 17.5q52 17.5 81.5 58q29.5 40.5 29.5 108.5q0 66-29.5 109q-29.5 43-81.5 64.5q-52 21.5-119 21.5l-122 0l0 277zm83-345l110 0q77 0 118-31.5q41-31.5 41-95.5q0-64-41-90.5q-41-26.5-118-26.5l-110 0zm277 345l-171-300l65-44l200 344z"], "S": [534, "m272 12q-70 0-128-26.5q-58-26.5-102-71.5l47-54q35 37 83.5 58q48.5 21 100.5 21q65 0 101-29.5q36-29.5 36-77.5q0-34-14.5-54q-14.5-20-39-34q-24.5-14-55.5-28l-94-41q-32-14-62.5-35q-30.5-21-50.5-53.5q-20-32.5-20-80.5q0-50 26.5-89.5q26.5-39.5 73-62q46.5-22.5 106.5-22.5q60 0 110 22q50 22 84 57l-45 54q-31-27-68-43.5q-37-16.5-81-16.5q-55 0-88.5 26q-33.5 26-33.5 70q0 31 16 51q16 20 41.5 33q25.5 13 51.5 25l93 40q39 17 69.5 39q30.5 22 48 55q17.5 33 17.5 81q0 52-26.5 94.5q-26.5 42.5-77 67.5q-50.5 25-119.5 25z"], "T": [536, "m226 0l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585z"], "U": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5z"], "V": [515, "m206 0l-206-656l89 0l101 354q12 40 22 74.5q10 34.5 20 69q10 34.5 22 73.5l4 0q11-39 21-73.5q10-34.5 20-69q10-34.5 22-74.5l109-354l85 0l-212 656z"], "W": [786, "m159 0l-136-656l89 0l67 357q10 53 19 106q9 53 17 109l4 0q10-56 21.5-109q11.5-53 23.5-106l89-357l84 0l86 357q12 52 24 105.5q12 53.5 23 109.5l4 0q8-56 17-109q9-53 18-106l69-357l85 0l-137 656l-107 0l-94-394q-8-37-15.5-74.5q-7.5-37.5-14.5-79.5l-4 0q-6 42-13.5 79.5q-7.5 37.5-15.5 74.5l-96 394z"], "X": [513, "m15 0l191-339l-178-317l92 0l89 168q13 22 24.5 44q11.5 22 26.5 51l4 0q14-29 24.5-51q10.5-22 22.5-44l87-168l88 0l-179 321l191 335l-92 0l-96-177q-13-24-26.5-49.5q-13.5-25.5-29.5-55.5l-4 0q-14 30-26.5 55.5q-12.5 25.5-25.5 49.5l-95 177z"], "Y": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254z"], "Z": [539, "m45 0l0-50l345-536l-314 0l0-70l418 0l0 49l-346 536l349 0l0 71z"], "[": [303, "m94 152l0-860l179 0l0 47l-117 0l0 766l117 0l0 47z"], "\\": [350, "m281 160l-267-870l59 0l267 870z"], "]": [303, "m31 152l0-47l116 0l0-766l-116 0l0-47l178 0l0 860z"], "^": [497, "m60-284l152-386l73 0l152 386l-72 0l-65-176l-49-133l-4 0l-50 133l-65 176z"], "_": [500, "m12 126l0-55l476 0l0 55z"], "`": [542, "m282-570l-158-156l5-9l90 0l129 165z"], "a": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5z"], "b": [553, "m297 12q-34 0-70-16.5q-36-16.5-69-45.5l-3 0l-7 50l-66 0l0-712l82 0l0 194l-2 88q33-29 72.5-48.5q39.5-19.5 79.5-19.5q63 0 106 30.5q43 30.5 65 86q22 55.5 22 130.5q0 83-29.5 142q-29.5 59-77.5 90q-48 31-103 31zm-14-69q40 0 71.5-23q31.5-23 49.5-66.5q18-43.5 18-103.5q0-53-13-93.5q-13-40.5-41-63q-28-22.5-74-22.5q-30 0-62.5 16.5q-32.5 16.5-67.5 49.5l0 255q32 28 63.5 39.5q31.5 11.5 55.5 11.5z"], "c": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5z"], "d": [555, "m248 12q-92 0-146.5-66.5q-54.5-66.5-54.5-187.5q0-79 29.5-136.5q29.5-57.5 77.5-88.5q48-31 104-31q43 0 73.5 14.5q30.5 14.5 62.5 41.5l-4-83l0-187l83 0l0 712l-68 0l-7-57l-3 0q-28 28-66 48.5q-38 20.5-81 20.5zm18-69q34 0 64-17q30-17 60-50l0-254q-30-28-59-39.5q-29-11.5-59-11.5q-39 0-70.5 23.5q-31.5 23.5-50.5 65q-19 41.5-19 97.5q0 87 35 136.5q35 49.5 99 49.5z"], "e": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14z"], "f": [292, "m96 0l0-563q0-49 15-85.5q15-36.5 46.5-56q31.5-19.5 80.5-19.5q22 0 43.5 4.5q21.5 4.5 37.5 11.5l-18 60q-29-9-55-9q-34 0-51 23.5q-17 23.5-17 70.5l0 563zm-72-419l0-62l76-5l181 0l0 67z"], "g": [504, "m246 224q-59 0-104.5-15.5q-45.5-15.5-71-44.5q-25.5-29-25.5-71q0-31 19-59.5q19-28.5 52-50.5l0-4q-18-12-30.5-31.5q-12.5-19.5-12.5-47.5q0-31 17.5-54q17.5-23 35.5-36l0-4q-23-20-43-54q-20-34-20-77q0-53 25.5-92q25.5-39 67-60q41.5-21 90.5-21q20 0 38 3.5q18 3.5 31 8.5l169 0l0 63l-101 0l0 4q18 16 29.5 40q11.5 24 11.5 57q0 52-24 89.5q-24 37.5-64 58q-40 20.5-90 20.5q-18 0-37-4.5q-19-4.5-36-12.5q-12 11-21.5 24q-9.5 13-9.5 34q0 23 18.5 38q18.5 15 67.5 15l94 0q85 0 127.5 27.5q42.5 27.5 42.5 88.5q0 45-30 83q-30 38-85.5 61.5q-55.5 23.5-130.5 23.5zm0-433q28 0 51.5-14.5q23.5-14.5 37.5-40.5q14-26 14-61q0-54-30-83.5q-30-29.5-73-29.5q-43 0-73 29.5q-30 29.5-30 83.5q0 35 14 61q14 26 37.5 40.5q23.5 14.5 51.5 14.5zm12 376q46 0 80.5-14q34.5-14 54-37q19.5-23 19.5-48q0-34-25.5-47q-25.5-13-72.5-13l-84 0q-14 0-30.5-2q-16.5-2-32.5-6q-27 19-38.5 40q-11.5 21-11.5 42q0 39 37.5 62q37.5 23 103.5 23z"], "h": [544, "m82 0l0-712l82 0l0 194l-3 100q35-33 73.5-56.5q38.5-23.5 88.5-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352z"], "i": [246, "m82 0l0-486l82 0l0 486zm41-586q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "j": [247, "m32 217q-21 0-40-4q-19-4-32-10l17-62q9 3 21.5 6q12.5 3 24.5 3q36 0 48-25.5q12-25.5 12-70.5l0-540l82 0l0 541q0 49-13.5 85.5q-13.5 36.5-42.5 56.5q-29 20-77 20zm91-803q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "k": [495, "m82 0l0-712l82 0l0 481l2 0l206-255l92 0l-162 196l184 290l-90 0l-142-234l-90 106l0 128z"], "l": [255, "m169 9q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7 27.5q7 7.5 17 7.5q4 0 7.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5z"], "m": [829, "m82 0l0-486l68 0l7 70l3 0q32-34 69.5-58q37.5-24 81.5-24q56 0 87.5 25q31.5 25 46.5 68q38-42 77-67.5q39-25.5 83-25.5q76 0 112 48.5q36 48.5 36 141.5l0 308l-82 0l0-297q0-69-22-99.5q-22-30.5-68-30.5q-29 0-58.5 18.5q-29.5 18.5-63.5 56.5l0 352l-82 0l0-297q0-69-22-99.5q-22-30.5-69-30.5q-55 0-122 75l0 352z"], "n": [547, "m82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352z"], "o": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5z"], "p": [555, "m82 205l0-691l68 0l7 56l3 0q33-28 73-48q40-20 82-20q62 0 105 30.5q43 30.5 65 86q22 55.5 22 131.5q0 82-29.5 141q-29.5 59-77.5 90q-48 31-103 31q-33 0-67-15q-34-15-68-41l2 85l0 164zm201-262q40 0 71.5-23q31.5-23 49.5-66.5q18-43.5 18-103.5q0-53-13-93.5q-13-40.5-41-63q-28-22.5-74-22.5q-30 0-62 16.5q-32 16.5-68 49.5l0 255q34 28 64.5 39.5q30.5 11.5 54.5 11.5z"], "q": [555, "m390 205l0-173l4-88q-29 28-66.5 48q-37.5 20-79.5 20q-92 0-146.5-66.5q-54.5-66.5-54.5-187.5q0-79 29.5-136.5q29.5-57.5 77.5-88.5q48-31 104-31q42 0 74.5 15q32.5 15 64.5 43l2 0l8-46l66 0l0 691zm-124-262q34 0 64-17q30-17 60-50l0-254q-30-28-59-39.5q-29-11.5-59-11.5q-39 0-70.5 23.5q-31.5 23.5-50.5 65q-19 41.5-19 97.5q0 87 35 136.5q35 49.5 99 49.5z"], "r": [347, "m82 0l0-486l68 0l7 88l3 0q24-46 60-73q36-27 78-27q16 0 28 2q12 2 24 8l-18 70q-11-3-20.5-4.5q-9.5-1.5-24.5-1.5q-31 0-64.5 25q-33.5 25-58.5 87l0 312z"], "s": [419, "m209 12q-53 0-100.5-18.5q-47.5-18.5-80.5-51.5l38-48q32 26 66.5 40q34.5 14 79.5 14q48 0 72-22.5q24-22.5 24-53.5q0-25-16.5-41.5q-16.5-16.5-41-28q-24.5-11.5-52.5-21.5q-36-13-69-30.5q-33-17.5-53.5-44q-20.5-26.5-20.5-66.5q0-59 44.5-98.5q44.5-39.5 123.5-39.5q45 0 84 15.5q39 15.5 67 39.5l-38 47q-26-18-53-28q-27-10-60-10q-46 0-67.5 21q-21.5 21-21.5 49q0 22 13 36.5q13 14.5 36.5 25.5q23.5 11 53.5 21q38 14 72.5 31.5q34.5 17.5 56 45q21.5 27.5 21.5 71.5q0 40-20.5 72.5q-20.5 32.5-60 52.5q-39.5 20-97.5 20z"], "t": [338, "m235 9q-77 0-108-45q-31-45-31-117l0-266l-72 0l0-62l76-5l10-156l69 0l0 156l132 0l0 67l-132 0l0 267q0 44 16.5 69q16.5 25 58.5 25q13 0 27-2.5q14-2.5 28-9.5l18 58q-19 9-43 15q-24 6-49 6z"], "u": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24z"], "v": [467, "m187 0l-175-486l85 0l92 276q11 35 22.5 71.5q11.5 36.5 22.5 71.5l4 0q10-35 22-71.5q12-36.5 22-71.5l92-276l81 0l-172 486z"], "w": [719, "m159 0l-135-486l86 0l71 281q8 33 15 66q7 33 13 72l4 0q8-39 15.5-72q7.5-33 15.5-66l72-281l90 0l73 281q9 33 16.5 66q7.5 33 15.5 72l4 0q8-39 15-72q7-33 14-66l71-281l80 0l-131 486l-107 0l-65-260q-8-34-15.5-67.5q-7.5-33.5-15.5-76.5l-4 0q-7 43-14.5 77q-7.5 34-16.5 67l-65 260z"], "x": [446, "m14 0l159-254l-147-232l89 0l65 107q11 19 23.5 39.5q12.5 20.5 24.5 41.5l4 0q11-21 22-41.5q11-20.5 22-39.5l59-107l86 0l-147 241l158 245l-89 0l-71-113q-13-22-26.5-44q-13.5-22-26.5-43l-4 0q-13 21-25 42.5q-12 21.5-24 44.5l-66 113z"], "y": [467, "m90 209q-16 0-30.5-3q-14.5-3-26.5-7l18-64q9 3 18 4.5q9 1.5 17 1.5q42 0 68.5-29.5q26.5-29.5 41.5-74.5l11-36l-195-487l85 0l99 269q12 31 24 67q12 36 23 70l4 0q11-34 21.5-69.5q10.5-35.5 19.5-67.5l87-269l80 0l-183 526q-17 48-41 86.5q-24 38.5-58 60.5q-34 22-83 22z"], "z": [425, "m31 0l0-44l256-375l-228 0l0-67l332 0l0 44l-256 375l264 0l0 67z"], "{": [303, "m228 152q-60 0-88.5-28q-28.5-28-28.5-105q0-37 2-68q2-31 4.5-61q2.5-30 2.5-64q0-29-17.5-53.5q-17.5-24.5-68.5-24.5l0-52q34 0 52.5-11.5q18.5-11.5 26-29q7.5-17.5 7.5-36.5q0-34-2.5-64.5q-2.5-30.5-4.5-61.5q-2-31-2-68q0-78 28.5-105.5q28.5-27.5 88.5-27.5l45 0l0 47l-27 0q-40 0-54 21.5q-14 21.5-14 69.5q0 45 3 87.5q3 42.5 3 93.5q0 49-13.5 74.5q-13.5 25.5-46.5 34.5l0 4q33 9 46.5 35q13.5 26 13.5 74q0 50-3 92.5q-3 42.5-3 88.5q0 48 14 69.5q14 21.5 54 21.5l27 0l0 47z"], "|": [241, "m92 250l0-1000l58 0l0 1000z"], "}": [303, "m31 152l0-47l26 0q40 0 54-21.5q14-21.5 14-69.5q0-46-2.5-88.5q-2.5-42.5-2.5-92.5q0-48 13.5-74q13.5-26 45.5-35l0-4q-32-9-45.5-34.5q-13.5-25.5-13.5-74.5q0-51 2.5-93.5q2.5-42.5 2.5-87.5q0-48-14-69.5q-14-21.5-54-21.5l-26 0l0-47l44 0q60 0 88.5 27.5q28.5 27.5 28.5 105.5q0 37-2 68q-2 31-4.5 61.5q-2.5 30.5-2.5 64.5q0 19 7.5 36.5q7.5 17.5 26 29q18.5 11.5 52.5 11.5l0 52q-50 0-68 24.5q-18 24.5-18 53.5q0 34 2.5 64q2.5 30 4.5 61q2 31 2 68q0 77-28.5 105q-28.5 28-88.5 28z"], "~": [497, "m336-257q-29 0-52.5-13q-23.5-13-44-29.5q-20.5-16.5-40-29q-19.5-12.5-40.5-12.5q-21 0-40.5 14q-19.5 14-36.5 47l-46-33q28-48 60.5-69q32.5-21 64.5-21q30 0 53 13q23 13 43.5 29.5q20.5 16.5 40 29q19.5 12.5 40.5 12.5q22 0 41-14.5q19-14.5 36-46.5l46 34q-27 47-59.5 68q-32.5 21-65.5 21z"], " ": [200, ""], "¡": [289, "m103 184l2-94l11-378l57 0l11 378l2 94zm42-556q-24 0-42-18q-18-18-18-46q0-27 18-44.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 44.5q0 28-17 46q-17 18-42 18z"], "¢": [497, "m297-69q-69 0-122-28.5q-53-28.5-83.5-82q-30.5-53.5-30.5-130.5q0-77 33-131q33-54 88-81.5q55-27.5 120-27.5q49 0 83.5 17q34.5 17 59.5 41l-40 52q-21-20-45.5-31q-24.5-11-53.5-11q-49 0-86 21.5q-37 21.5-57 60q-20 38.5-20 90.5q0 78 43.5 125q43.5 47 117.5 47q35 0 63.5-14q28.5-14 50.5-33l36 52q-32 30-72.5 47q-40.5 17-84.5 17zm-35 102l0-686l52 0l0 686z"], "£": [497, "m54 0l0-50q51-28 78.5-76q27.5-48 27.5-104q0-41-12.5-80q-12.5-39-24.5-78q-12-39-12-78q0-57 23.5-98q23.5-41 65-63.5q41.5-22.5 97.5-22.5q54 0 92.5 22q38.5 22 62.5 56l-45 42q-19-26-44-38.5q-25-12.5-60-12.5q-53 0-82 33q-29 33-29 84q0 39 10.5 75.5q10.5 36.5 21 75.5q10.5 39 10.5 84q0 52-16 87.5q-16 35.5-46 66.5l0 4l281 0l0 71zm-1-285l0-52l67-4l255 0l0 56z"], "¤": [497, "m70-103l-44-45l64-65q-17-23-26.5-52.5q-9.5-29.5-9.5-63.5q0-35 9.5-64.5q9.5-29.5 26.5-52.5l-64-66l44-45l68 70q49-37 111-37q61 0 110 37l68-70l44 45l-65 66q17 23 27 52.5q10 29.5 10 64.5q0 34-10 63.5q-10 29.5-27 52.5l65 65l-44 45l-68-69q-23 19-52 28.5q-29 9.5-58 9.5q-63 0-111-38zm179-92q32 0 59-17q27-17 43-47q16-30 16-70q0-40-16-70q-16-30-43-47q-27-17-59-17q-33 0-59.5 17q-26.5 17-43 47q-16.5 30-16.5 70q0 40 16.5 70q16.5 30 43 47q26.5 17 59.5 17z"], "¥": [497, "m207 0l0-151l-162 0l0-52l162 0l0-67l-162 0l0-53l141 0l-163-315l87 0l77 171q16 33 30 66.5q14 33.5 30 68.5l4 0q17-35 32-68q15-33 29-67l78-171l84 0l-164 315l142 0l0 53l-163 0l0 67l163 0l0 52l-163 0l0 151z"], "¦": [241, "m92-291l0-459l58 0l0 459zm0 541l0-464l58 0l0 464z"], "§": [497, "m236 64q-53 0-97.5-19q-44.5-19-75.5-52l50-45q25 24 54 38q29 14 69 14q40 0 62.5-20q22.5-20 22.5-49q0-28-19.5-47q-19.5-19-51-33.5q-31.5-14.5-67-29.5q-35.5-15-67-35.5q-31.5-20.5-51.5-51.5q-20-31-20-77q0-50 31.5-85.5q31.5-35.5 78.5-55.5l39 41q-35 17-56 38.5q-21 21.5-21 56.5q0 33 20.5 55q20.5 22 52 38q31.5 16 67.5 31q36 15 67.5 34q31.5 19 52 47q20.5 28 20.5 70q0 40-21 70.5q-21 30.5-57 48.5q-36 18-83 18zm106-205l-45-42q40-16 61.5-36q21.5-20 21.5-59q0-35-20.5-57.5q-20.5-22.5-52.5-38.5q-32-16-68-31q-36-15-67.5-33.5q-31.5-18.5-52-46.5q-20.5-28-20.5-69q0-34 17-64q17-30 51-48q34-18 84-18q47 0 86.5 17q39.5 17 67.5 40l-40 53q-24-20-51-33q-27-13-60-13q-42 0-60.5 18.5q-18.5 18.5-18.5 44.5q0 27 20 45q20 18 51.5 32.5q31.5 14.5 66.5 30q35 15.5 66.5 37q31.5 21.5 52 52q20.5 30.5 20.5 76.5q0 36-14 62.5q-14 26.5-39 45.5q-25 19-57 35z"], "¨": [542, "m175-587q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "©": [744, "m372 11q-65 0-123.5-23.5q-58.5-23.5-103.5-67q-45-43.5-70.5-105.5q-25.5-62-25.5-138q0-77 25.5-138q25.5-61 70.5-104q45-43 103.5-65.5q58.5-22.5 123.5-22.5q66 0 124 23q58 23 103 65.5q45 42.5 70.5 103.5q25.5 61 25.5 138q0 76-25.5 138q-25.5 62-70.5 105.5q-45 43.5-103 67q-58 23.5-124 23.5zm0-42q57 0 107-21q50-21 88-59.5q38-38.5 59.5-92.5q21.5-54 21.5-119q0-66-21.5-119q-21.5-53-59.5-91q-38-38-88-58.5q-50-20.5-107-20.5q-57 0-107 20.5q-50 20.5-88 58.5q-38 38-59.5 91q-21.5 53-21.5 119q0 65 21.5 119q21.5 54 59.5 92.5q38 38.5 88 59.5q50 21 107 21zm8-98q-51 0-92-23q-41-23-65.5-65.5q-24.5-42.5-24.5-102.5q0-60 26.5-104q26.5-44 68-67.5q41.5-23.5 90.5-23.5q42 0 73 16.5q31 16.5 53 41.5l-36 37q-17-20-38.5-30q-21.5-10-48.5-10q-36 0-63.5 17.5q-27.5 17.5-43 49.5q-15.5 32-15.5 73q0 62 32.5 99q32.5 37 86.5 37q35 0 56.5-11.5q21.5-11.5 42.5-31.5l32 40q-26 26-57.5 42q-31.5 16-76.5 16z"], "ª": [345, "m136-386q-44 0-71-26q-27-26-27-69q0-54 47.5-82.5q47.5-28.5 150.5-37.5q-1-32-14-51.5q-13-19.5-48-19.5q-26 0-53 10.5q-27 10.5-48 23.5l-24-43q25-16 60-29.5q35-13.5 74-13.5q60 0 87.5 35q27.5 35 27.5 98l0 196l-50 0l-7-37l-4 0q-20 18-45.5 32q-25.5 14-55.5 14zm19-51q20 0 39.5-9.5q19.5-9.5 41.5-29.5l0-83q-76 9-106 28q-30 19-30 46q0 24 14.5 36q14.5 12 40.5 12z"], "«": [429, "m181-66l-136-155l0-62l136-155l36 30l-118 156l118 158zm158 0l-136-155l0-62l136-155l36 30l-118 156l118 158z"], "¬": [497, "m397-104l0-195l-363 0l0-62l429 0l0 257z"], "­": [311, "m41-219l0-63l230 0l0 63z"], "®": [423, "m211-319q-51 0-94-25q-43-25-68.5-69q-25.5-44-25.5-103q0-58 25.5-102.5q25.5-44.5 68.5-69.5q43-25 94-25q52 0 95 25q43 25 68.5 69.5q25.5 44.5 25.5 102.5q0 59-25.5 103q-25.5 44-68.5 69q-43 25-95 25zm0-37q42 0 76-20q34-20 53.5-56.5q19.5-36.5 19.5-83.5q0-47-19.5-83.5q-19.5-36.5-53.5-57q-34-20.5-76-20.5q-42 0-75.5 20.5q-33.5 20.5-53 57q-19.5 36.5-19.5 83.5q0 47 19.5 83.5q19.5 36.5 53 56.5q33.5 20 75.5 20zm-72-61l0-203l76 0q32 0 55 14q23 14 23 51q0 18-10 33q-10 15-27 22l46 83l-46 0l-35-70l-41 0l0 70zm41-102l26 0q20 0 31.5-8.5q11.5-8.5 11.5-25.5q0-15-9-24q-9-9-32-9l-28 0z"], "¯": [542, "m138-601l0-57l266 0l0 57z"], "°": [331, "m166-429q-34 0-62.5-15.5q-28.5-15.5-45.5-44.5q-17-29-17-67q0-39 17-68q17-29 45.5-45q28.5-16 62.5-16q34 0 62 16q28 16 45.5 45q17.5 29 17.5 68q0 38-17.5 67q-17.5 29-45.5 44.5q-28 15.5-62 15.5zm0-46q33 0 54-23q21-23 21-58q0-37-21-60q-21-23-54-23q-33 0-54 23q-21 23-21 60q0 35 21 58q21 23 54 23z"], "±": [497, "m216-133l0-173l-182 0l0-62l182 0l0-188l65 0l0 188l182 0l0 62l-182 0l0 173zm-182 133l0-62l429 0l0 62z"], "²": [367, "m52-395l0-37q61-54 102-94.5q41-40.5 62-73q21-32.5 21-61.5q0-38-20-60q-20-22-55-22q-25 0-46 16q-21 16-38 41l-38-35q23-34 57-55q34-21 73-21q59 0 94.5 32q35.5 32 35.5 94q0 38-19 72.5q-19 34.5-51.5 70.5q-32.5 36-74.5 78l165 0l0 55z"], "³": [367, "m180-383q-47 0-84.5-22q-37.5-22-60.5-54l43-33q18 27 43.5 42.5q25.5 15.5 55.5 15.5q32 0 55-18q23-18 23-52q0-34-32-51.5q-32-17.5-89-17.5l0-41q50 0 78-20.5q28-20.5 28-49.5q0-29-19-45.5q-19-16.5-52-16.5q-22 0-42 13.5q-20 13.5-37 33.5l-39-34q26-29 56.5-46.5q30.5-17.5 71.5-17.5q33 0 62 12.5q29 12.5 45.5 36q16.5 23.5 16.5 56.5q0 34-19 58q-19 24-49 38q33 8 58.5 32.5q25.5 24.5 25.5 63.5q0 36-19 62.5q-19 26.5-50.5 40.5q-31.5 14-69.5 14z"], "´": [542, "m194-570l129-165l90 0l5 9l-158 156z"], "µ": [562, "m82 179l0-665l82 0l0 297q0 64 21 97q21 33 68 33q22 0 43-7q21-7 42.5-27.5q21.5-20.5 43.5-60.5l0-332l83 0q-1 66-2.5 133.5q-1.5 67.5-2.5 132q-1 64.5-1 122.5q0 21 10 30q10 9 26 9q7 0 14-1.5q7-1.5 15-4.5l11 63q-11 4-24.5 7.5q-13.5 3.5-33.5 3.5q-41 0-62-22q-21-22-26-69l-2 0q-27 46-61 69q-34 23-74 23q-29 0-53-9q-24-9-41-38q0 48 1 82q1 34 2 64.5q1 30.5 4 69.5z"], "¶": [560, "m380 80l0-736l84 0l0 736zm-87-306q-73 0-130-23q-57-23-89.5-71q-32.5-48-32.5-123q0-78 31.5-125q31.5-47 86-67.5q54.5-20.5 123.5-20.5l44 0l0 430z"], "·": [249, "m125-259q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], "¸": [542, "m190 226l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "¹": [367, "m172-395l0-308l-85 0l0-42q33-6 55-15.5q22-9.5 42-24.5l52 0l0 390z"], "º": [365, "m182-387q-41 0-75.5-20q-34.5-20-55.5-57.5q-21-37.5-21-90.5q0-54 21-91.5q21-37.5 55.5-57.5q34.5-20 75.5-20q41 0 75.5 20q34.5 20 55.5 57.5q21 37.5 21 91.5q0 53-21 90.5q-21 37.5-55.5 57.5q-34.5 20-75.5 20zm0-51q41 0 64.5-32.5q23.5-32.5 23.5-84.5q0-54-23.5-86q-23.5-32-64.5-32q-42 0-65.5 32q-23.5 32-23.5 86q0 52 23.5 84.5q23.5 32.5 65.5 32.5z"], "»": [429, "m89-66l-35-28l118-158l-118-156l35-30l137 155l0 62zm158 0l-35-28l118-158l-118-156l35-30l137 155l0 62z"], "¼": [781, "m148-266l0-308l-85 0l0-42q33-6 55-15.5q22-9.5 42-24.5l52 0l0 390zm32 278l362-680l56 0l-362 680zm453-12l0-220l4-109l-4 0l-50 81l-61 98l227 0l0 46l-294 0l0-33l164-253l72 0l0 390z"], "½": [808, "m148-266l0-308l-85 0l0-42q33-6 55-15.5q22-9.5 42-24.5l52 0l0 390zm12 278l362-680l56 0l-362 680zm333-12l0-37q61-54 102-94.5q41-40.5 62-73q21-32.5 21-61.5q0-38-20-60q-20-22-55-22q-25 0-46 16q-21 16-38 41l-38-35q23-34 57-55q34-21 73-21q59 0 94.5 32q35.5 32 35.5 94q0 38-19 72.5q-19 34.5-51.5 70.5q-32.5 36-74.5 78l165 0l0 55z"], "¾": [796, "m179-254q-47 0-84.5-22q-37.5-22-60.5-54l43-33q18 27 43.5 42.5q25.5 15.5 55.5 15.5q32 0 55-18q23-18 23-52q0-34-32-51.5q-32-17.5-89-17.5l0-41q50 0 78-20.5q28-20.5 28-49.5q0-29-19-45.5q-19-16.5-52-16.5q-22 0-42 13.5q-20 13.5-37 33.5l-39-34q26-29 56.5-46.5q30.5-17.5 71.5-17.5q33 0 62 12.5q29 12.5 45.5 36q16.5 23.5 16.5 56.5q0 34-19 58q-19 24-49 38q33 8 58.5 32.5q25.5 24.5 25.5 63.5q0 36-19 62.5q-19 26.5-50.5 40.5q-31.5 14-69.5 14zm39 266l362-680l56 0l-362 680zm430-12l0-220l4-109l-4 0l-50 81l-61 98l227 0l0 46l-294 0l0-33l164-253l72 0l0 390z"], "¿": [425, "m215 196q-50 0-88-19.5q-38-19.5-58.5-55.5q-20.5-36-20.5-85q0-39 16-70.5q16-31.5 39.5-60q23.5-28.5 45.5-57q22-28.5 35-61.5q13-33 8-75l73 0q7 47-5 83.5q-12 36.5-33.5 66q-21.5 29.5-44 56.5q-22.5 27-38.5 54q-16 27-16 59q0 27 11 49q11 22 32.5 34.5q21.5 12.5 53.5 12.5q33 0 62.5-15.5q29.5-15.5 51.5-41.5l48 43q-32 35-74.5 59q-42.5 24-97.5 24zm12-568q-24 0-42-18q-18-18-18-46q0-27 18-44.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 44.5q0 28-17 46q-17 18-42 18z"], "À": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm155-506l-163-126l4-9l101 0l132 135z"], "Á": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm75-506l132-135l101 0l4 9l-163 126z"], "Â": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm-24-506l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Ã": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm227-509q-28 0-48-10.5q-20-10.5-36-24.5q-16-14-31-25q-15-11-33-11q-19 0-32 17q-13 17-16 49l-56-4q3-58 30-90.5q27-32.5 72-32.5q28 0 48.5 11q20.5 11 36.5 24.5q16 13.5 30.5 24.5q14.5 11 32.5 11q19 0 32-17q13-17 16-49l56 4q-2 58-29.5 90.5q-27.5 32.5-72.5 32.5z"], "Ä": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm49-515q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Å": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm152-499q-50 0-80.5-24.5q-30.5-24.5-30.5-65.5q0-42 30.5-66.5q30.5-24.5 80.5-24.5q51 0 81 24.5q30 24.5 30 66.5q0 41-30 65.5q-30 24.5-81 24.5zm0-36q25 0 41-14q16-14 16-40q0-27-16-41q-16-14-41-14q-24 0-40.5 14q-16.5 14-16.5 41q0 26 16.5 40q16.5 14 40.5 14z"], "Æ": [822, "m8 0l344-656l411 0l0 70l-278 0l0 206l232 0l0 71l-232 0l0 238l288 0l0 71l-372 0l0-590l-4 0q-26 53-53 107q-27 54-54 107l-194 376zm150-191l0-67l294 0l0 67z"], "Ç": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5zm-82 214l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "È": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm203-706l-163-126l4-9l101 0l132 135z"], "É": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm123-706l132-135l101 0l4 9l-163 126z"], "Ê": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm24-706l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Ë": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm97-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Ì": [263, "m90 0l0-656l83 0l0 656zm45-706l-163-126l4-9l101 0l132 135z"], "Í": [263, "m90 0l0-656l83 0l0 656zm-35-706l132-135l101 0l4 9l-163 126z"], "Î": [263, "m90 0l0-656l83 0l0 656zm-134-706l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Ï": [263, "m90 0l0-656l83 0l0 656zm-61-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Ð": [639, "m27-313l0-60l88-5l231 0l0 65zm86 313l0-656l165 0q101 0 169.5 38q68.5 38 104 110.5q35.5 72.5 35.5 176.5q0 104-35 178.5q-35 74.5-103.5 113.5q-68.5 39-167.5 39zm84-68l74 0q77 0 128-31.5q51-31.5 76.5-89.5q25.5-58 25.5-142q0-82-25.5-140q-25.5-58-76.5-87.5q-51-29.5-128-29.5l-74 0z"], "Ñ": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343zm319-709q-28 0-48-10.5q-20-10.5-36-24.5q-16-14-31-25q-15-11-33-11q-19 0-32 17q-13 17-16 49l-56-4q3-58 30-90.5q27-32.5 72-32.5q28 0 48.5 11q20.5 11 36.5 24.5q16 13.5 30.5 24.5q14.5 11 32.5 11q19 0 32-17q13-17 16-49l56 4q-2 58-29.5 90.5q-27.5 32.5-72.5 32.5z"], "Ò": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm3-644l-163-126l4-9l101 0l132 135z"], "Ó": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm-77-644l132-135l101 0l4 9l-163 126z"], "Ô": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm-176-644l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Õ": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm75-647q-28 0-48-10.5q-20-10.5-36-24.5q-16-14-31-25q-15-11-33-11q-19 0-32 17q-13 17-16 49l-56-4q3-58 30-90.5q27-32.5 72-32.5q28 0 48.5 11q20.5 11 36.5 24.5q16 13.5 30.5 24.5q14.5 11 32.5 11q19 0 32-17q13-17 16-49l56 4q-2 58-29.5 90.5q-27.5 32.5-72.5 32.5z"], "Ö": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm-103-653q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "×": [497, "m94-126l-44-45l155-159l-155-158l44-45l155 159l154-159l44 45l-155 158l155 159l-44 45l-154-160z"], "Ø": [664, "m98 32l-50-40l522-681l52 41zm237-20q-83 0-146-42q-63-42-99-119q-36-77-36-182q0-105 36-180.5q36-75.5 99-116q63-40.5 146-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102-33q43-33 67.5-93.5q24.5-60.5 24.5-142.5q0-81-24.5-140q-24.5-59-67.5-91.5q-43-32.5-102-32.5q-59 0-102.5 32.5q-43.5 32.5-67.5 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 67.5 93.5q43.5 33 102.5 33z"], "Ù": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm2-718l-163-126l4-9l101 0l132 135z"], "Ú": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-78-718l132-135l101 0l4 9l-163 126z"], "Û": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-177-718l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Ü": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-104-727q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Ý": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254zm-35-706l132-135l101 0l4 9l-163 126z"], "Þ": [583, "m90 0l0-656l83 0l0 110l118 0q73 0 127.5 18.5q54.5 18.5 84.5 60.5q30 42 30 114q0 69-30.5 114q-30.5 45-85 67q-54.5 22-126.5 22l-118 0l0 150zm83-218l108 0q86 0 127.5-32.5q41.5-32.5 41.5-102.5q0-71-42-98q-42-27-127-27l-108 0z"], "ß": [576, "m387 12q-40 0-74.5-12q-34.5-12-65.5-39l31-50q26 20 52 28.5q26 8.5 55 8.5q42 0 63-24.5q21-24.5 21-55.5q0-29-13-48q-13-19-34.5-33q-21.5-14-45-26.5q-23.5-12.5-45-28q-21.5-15.5-34.5-39q-13-23.5-13-57.5q0-34 14.5-58.5q14.5-24.5 33.5-45.5q19-21 33.5-45q14.5-24 14.5-55q0-38-24.5-63q-24.5-25-68.5-25q-56 0-89.5 39.5q-33.5 39.5-33.5 118.5l0 498l-82 0l0-514q0-63 25-110q25-47 70.5-72.5q45.5-25.5 110.5-25.5q54 0 93 19.5q39 19.5 59.5 53q20.5 33.5 20.5 73.5q0 37-15 64q-15 27-34.5 48.5q-19.5 21.5-34.5 42.5q-15 21-15 47q0 24 13 40.5q13 16.5 34.5 28.5q21.5 12 45 25q23.5 13 45 31q21.5 18 34.5 44.5q13 26.5 13 67.5q0 42-19.5 75.5q-19.5 33.5-55.5 53.5q-36 20-85 20z"], "à": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm61-514l-158-156l5-9l90 0l129 165z"], "á": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm-27-514l129-165l90 0l5 9l-158 156z"], "â": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm-122-514l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "ã": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm122-521q-26 0-45.5-12.5q-19.5-12.5-35.5-29.5q-16-17-30.5-29.5q-14.5-12.5-31.5-12.5q-22 0-33 21.5q-11 21.5-14 57.5l-55-3q1-40 12-70.5q11-30.5 32.5-48q21.5-17.5 56.5-17.5q27 0 46 12.5q19 12.5 35 29.5q16 17 30.5 29.5q14.5 12.5 32.5 12.5q22 0 33-22q11-22 13-57l55 4q-1 38-12 68.5q-11 30.5-32.5 48.5q-21.5 18-56.5 18z"], "ä": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm-46-531q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "å": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm50-498q-50 0-80-28q-30-28-30-71q0-42 30-70q30-28 80-28q51 0 80.5 28q29.5 28 29.5 70q0 43-29.5 71q-29.5 28-80.5 28zm0-37q24 0 40.5-17q16.5-17 16.5-45q0-28-16.5-44.5q-16.5-16.5-40.5-16.5q-24 0-40.5 16.5q-16.5 16.5-16.5 44.5q0 28 17 45q17 17 40 17z"], "æ": [778, "m194 12q-40 0-72.5-16q-32.5-16-51.5-47q-19-31-19-75q0-82 72-124q72-42 223-59q0-31-8.5-58.5q-8.5-27.5-29.5-44.5q-21-17-62-17q-38 0-75 15.5q-37 15.5-66 34.5l-32-56q22-15 51-29.5q29-14.5 62.5-24q33.5-9.5 69.5-9.5q54 0 90 28q36 28 50 75q28-47 68-75q40-28 91-28q61 0 102.5 28.5q41.5 28.5 62.5 79.5q21 51 21 121q0 13-1 25.5q-1 12.5-3 22.5l-314 0q2 50 22 87q20 37 53.5 58q33.5 21 75.5 21q35 0 64-9.5q29-9.5 55-27.5l29 54q-32 22-70.5 36q-38.5 14-87.5 14q-41 0-72.5-12.5q-31.5-12.5-56-33.5q-24.5-21-43.5-45q-49 44-100 67.5q-51 23.5-98 23.5zm23-68q34 0 74.5-18.5q40.5-18.5 72.5-53.5q-8-20-12.5-46.5q-4.5-26.5-5.5-53.5l-1-22q-115 14-163 42.5q-48 28.5-48 76.5q0 40 24 57.5q24 17.5 59 17.5zm207-228l242 0q0-73-30.5-110q-30.5-37-82.5-37q-33 0-60.5 18.5q-27.5 18.5-45.5 51.5q-18 33-23 77z"], "ç": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5zm-96 214l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "è": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-4-582l-158-156l5-9l90 0l129 165z"], "é": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-92-582l129-165l90 0l5 9l-158 156z"], "ê": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-187-582l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "ë": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-111-599q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "ì": [246, "m82 0l0-486l82 0l0 486zm52-570l-158-156l5-9l90 0l129 165z"], "í": [246, "m82 0l0-486l82 0l0 486zm-36-570l129-165l90 0l5 9l-158 156z"], "î": [246, "m82 0l0-486l82 0l0 486zm-131-570l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "ï": [246, "m82 0l0-486l82 0l0 486zm-55-587q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "ð": [544, "m269 12q-56 0-105.5-28.5q-49.5-28.5-80-81q-30.5-52.5-30.5-124.5q0-68 27.5-118.5q27.5-50.5 74.5-78.5q47-28 105-28q44 0 83.5 21.5q39.5 21.5 64.5 67.5l1 56q-34-49-68-65q-34-16-70-16q-44 0-75.5 21q-31.5 21-48 57.5q-16.5 36.5-16.5 82.5q0 50 19 87.5q19 37.5 51 58q32 20.5 70 20.5q45 0 75-25q30-25 45-69.5q15-44.5 15-103.5q0-88-21.5-154.5q-21.5-66.5-61-116.5q-39.5-50-94.5-87q-55-37-124-67l36-52q69 28 131 68q62 40 110 96.5q48 56.5 75.5 132.5q27.5 76 27.5 177q0 80-27 140.5q-27 60.5-75.5 94.5q-48.5 34-113.5 34zm-138-505l-29-55l332-172l32 55z"], "ñ": [547, "m82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352zm285-577q-26 0-45.5-12.5q-19.5-12.5-35.5-29.5q-16-17-30.5-29.5q-14.5-12.5-31.5-12.5q-22 0-33 21.5q-11 21.5-14 57.5l-55-3q1-40 12-70.5q11-30.5 32.5-48q21.5-17.5 56.5-17.5q27 0 46 12.5q19 12.5 35 29.5q16 17 30.5 29.5q14.5 12.5 32.5 12.5q22 0 33-22q11-22 13-57l55 4q-1 38-12 68.5q-11 30.5-32.5 48.5q-21.5 18-56.5 18z"], "ò": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm11-514l-158-156l5-9l90 0l129 165z"], "ó": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm-77-514l129-165l90 0l5 9l-158 156z"], "ô": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm-172-514l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "õ": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm72-521q-26 0-45.5-12.5q-19.5-12.5-35.5-29.5q-16-17-30.5-29.5q-14.5-12.5-31.5-12.5q-22 0-33 21.5q-11 21.5-14 57.5l-55-3q1-40 12-70.5q11-30.5 32.5-48q21.5-17.5 56.5-17.5q27 0 46 12.5q19 12.5 35 29.5q16 17 30.5 29.5q14.5 12.5 32.5 12.5q22 0 33-22q11-22 13-57l55 4q-1 38-12 68.5q-11 30.5-32.5 48.5q-21.5 18-56.5 18z"], "ö": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm-96-531q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "÷": [497, "m34-299l0-62l429 0l0 62zm215 203q-23 0-39-15q-16-15-16-39q0-23 16-38q16-15 39-15q23 0 38.5 15q15.5 15 15.5 38q0 24-15.5 39q-15.5 15-38.5 15zm0-360q-23 0-39-15q-16-15-16-39q0-23 16-38q16-15 39-15q23 0 38.5 15q15.5 15 15.5 38q0 24-15.5 39q-15.5 15-38.5 15z"], "ø": [542, "m272 12q-60 0-112-30q-52-30-83.5-86.5q-31.5-56.5-31.5-137.5q0-82 31.5-139q31.5-57 83-87q51.5-30 111.5-30q60 0 111.5 30q51.5 30 83.5 87q32 57 32 139q0 81-32 137.5q-32 56.5-83 86.5q-51 30-111 30zm0-66q41 0 73.5-23q32.5-23 51-65q18.5-42 18.5-96q0-60-18-104q-18-44-51-67.5q-33-23.5-75-23.5q-42 0-74 24q-32 24-50.5 65.5q-18.5 41.5-18.5 96.5q0 60 18.5 103.5q18.5 43.5 51 66.5q32.5 23 74.5 23zm-186 83l-46-38l417-506l46 39z"], "ù": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm58-582l-158-156l5-9l90 0l129 165z"], "ú": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm-30-582l129-165l90 0l5 9l-158 156z"], "û": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm-125-582l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "ü": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm-49-599q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "ý": [467, "m90 209q-16 0-30.5-3q-14.5-3-26.5-7l18-64q9 3 18 4.5q9 1.5 17 1.5q42 0 68.5-29.5q26.5-29.5 41.5-74.5l11-36l-195-487l85 0l99 269q12 31 24 67q12 36 23 70l4 0q11-34 21.5-69.5q10.5-35.5 19.5-67.5l87-269l80 0l-183 526q-17 48-41 86.5q-24 38.5-58 60.5q-34 22-83 22zm74-779l129-165l90 0l5 9l-158 156z"], "þ": [555, "m82 205l0-917l82 0l0 193l-1 84q32-26 70-44.5q38-18.5 78-18.5q64 0 107.5 30.5q43.5 30.5 66 86q22.5 55.5 22.5 131.5q0 82-29.5 141q-29.5 59-77.5 90q-48 31-103 31q-35 0-68-14.5q-33-14.5-66-39.5l1 83l0 164zm201-262q40 0 71.5-23q31.5-23 49.5-66.5q18-43.5 18-103.5q0-53-13-93.5q-13-40.5-41-63q-28-22.5-74-22.5q-30 0-62 16.5q-32 16.5-68 49.5l0 255q34 28 64.5 39.5q30.5 11.5 54.5 11.5z"], "ÿ": [467, "m90 209q-16 0-30.5-3q-14.5-3-26.5-7l18-64q9 3 18 4.5q9 1.5 17 1.5q42 0 68.5-29.5q26.5-29.5 41.5-74.5l11-36l-195-487l85 0l99 269q12 31 24 67q12 36 23 70l4 0q11-34 21.5-69.5q10.5-35.5 19.5-67.5l87-269l80 0l-183 526q-17 48-41 86.5q-24 38.5-58 60.5q-34 22-83 22zm55-796q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "Ā": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm17-535l0-57l270 0l0 57z"], "ā": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm-83-545l0-57l266 0l0 57z"], "Ă": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66zm152-506q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ă": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5zm50-513q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Ą": [544, "m494 219q-44 0-75-22.5q-31-22.5-31-69.5q0-28 12.5-52.5q12.5-24.5 31-43.5q18.5-19 36.5-31l-16 0l-114-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-115 367l-85 0l222-656l94 0l222 656q-36 16-60.5 46q-24.5 30-24.5 61q0 26 16.5 38q16.5 12 37.5 12q15 0 27.5-5q12.5-5 23.5-12l23 47q-16 13-40.5 22.5q-24.5 9.5-49.5 9.5zm-375-419l0-67l303 0l0 67z"], "ą": [504, "m388 215q-42 0-71-22.5q-29-22.5-29-70.5q0-27 11-51q11-24 29-43q18-19 37-31l-7-55l-3 0q-35 29-75 49.5q-40 20.5-86 20.5q-40 0-72.5-16q-32.5-16-51.5-47q-19-31-19-75q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298q-36 16-58 47q-22 31-22 59q0 25 16 37q16 12 35 12q15 0 27-4.5q12-4.5 24-12.5l21 46q-16 12-39.5 21.5q-23.5 9.5-48.5 9.5zm-171-271q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5z"], "Ć": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5zm-85-718l132-135l101 0l4 9l-163 126z"], "ć": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5zm-78-582l129-165l90 0l5 9l-158 156z"], "Ĉ": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5zm-184-718l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ĉ": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5zm-173-582l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ċ": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5zm-8-726q-24 0-40.5-15q-16.5-15-16.5-39q0-24 16.5-38.5q16.5-14.5 40.5-14.5q24 0 40.5 14.5q16.5 14.5 16.5 38.5q0 24-16.5 39q-16.5 15-40.5 15z"], "ċ": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5zm-1-598q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "Č": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5zm-47-720l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "č": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5zm-37-582l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "Ď": [615, "m90 0l0-656l164 0q101 0 170 38q69 38 104.5 110.5q35.5 72.5 35.5 176.5q0 104-35.5 178.5q-35.5 74.5-103.5 113.5q-68 39-167 39zm83-68l75 0q77 0 128-31.5q51-31.5 76-89.5q25-58 25-142q0-82-25-140q-25-58-76-87.5q-51-29.5-128-29.5l-75 0zm99-640l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ď": [573, "m248 12q-92 0-146.5-66.5q-54.5-66.5-54.5-187.5q0-79 29.5-136.5q29.5-57.5 77.5-88.5q48-31 104-31q43 0 73.5 14.5q30.5 14.5 62.5 41.5l-4-83l0-187l83 0l0 712l-68 0l-7-57l-3 0q-28 28-66 48.5q-38 20.5-81 20.5zm18-69q34 0 64-17q30-17 60-50l0-254q-30-28-59-39.5q-29-11.5-59-11.5q-39 0-70.5 23.5q-31.5 23.5-50.5 65q-19 41.5-19 97.5q0 87 35 136.5q35 49.5 99 49.5zm264-491l-4-212l59 0l-1 57l-14 155z"], "Đ": [635, "m27-313l0-60l88-5l231 0l0 65zm86 313l0-656l165 0q101 0 169.5 38q68.5 38 104 110.5q35.5 72.5 35.5 176.5q0 104-35 178.5q-35 74.5-103.5 113.5q-68.5 39-167.5 39zm84-68l74 0q77 0 128-31.5q51-31.5 76.5-89.5q25.5-58 25.5-142q0-82-25.5-140q-25.5-58-76.5-87.5q-51-29.5-128-29.5l-74 0z"], "đ": [562, "m248 12q-61 0-106.5-28q-45.5-28-70-80.5q-24.5-52.5-24.5-126.5q0-72 29.5-125q29.5-53 78-82q48.5-29 103.5-29q42 0 73 14.5q31 14.5 63 41.5l-3-84l0-225l82 0l0 712l-70 0l-6-55l-3 0q-29 28-65 47.5q-36 19.5-81 19.5zm18-69q34 0 64-17q30-17 61-49l0-215q-31-29-59.5-40.5q-28.5-11.5-59.5-11.5q-39 0-70.5 21q-31.5 21-50 58.5q-18.5 37.5-18.5 86.5q0 76 34.5 121.5q34.5 45.5 98.5 45.5zm-57-500l0-65l344 0l0 60l-83 5z"], "Ē": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm65-735l0-57l270 0l0 57z"], "ē": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-148-613l0-57l266 0l0 57z"], "Ĕ": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm200-706q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ĕ": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-15-581q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Ė": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm200-714q-24 0-40.5-15q-16.5-15-16.5-39q0-24 16.5-38.5q16.5-14.5 40.5-14.5q24 0 40.5 14.5q16.5 14.5 16.5 38.5q0 24-16.5 39q-16.5 15-40.5 15z"], "ė": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-15-598q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "Ę": [527, "m412 219q-43 0-74-23q-31-23-31-69q0-42 24.5-75q24.5-33 55.5-52l-297 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71l-6 0q-20 0-42.5 16q-22.5 16-38.5 40.5q-16 24.5-16 50.5q0 26 16 38q16 12 37 12q15 0 27.5-5q12.5-5 23.5-12l23 47q-16 13-40 22.5q-24 9.5-50 9.5z"], "ę": [496, "m360 214q-42 0-71.5-22q-29.5-22-29.5-70q0-37 23-69.5q23-32.5 62-59.5l3 5q-15 7-33.5 10.5q-18.5 3.5-34.5 3.5q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-40 25-65.5 49.5q-25.5 24.5-37.5 48q-12 23.5-12 46.5q0 26 16 37.5q16 11.5 34 11.5q16 0 28.5-4.5q12.5-4.5 23.5-12.5l21 46q-16 13-39.5 21.5q-23.5 8.5-48.5 8.5z"], "Ě": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm161-708l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ě": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-51-582l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "Ĝ": [617, "m348 12q-87 0-153.5-40.5q-66.5-40.5-104.5-116.5q-38-76-38-183q0-79 22.5-142q22.5-63 63-107.5q40.5-44.5 95.5-67.5q55-23 120-23q68 0 114.5 25q46.5 25 74.5 56l-46 52q-24-26-57.5-43q-33.5-17-83.5-17q-66 0-115 32.5q-49 32.5-75.5 91.5q-26.5 59-26.5 141q0 83 25.5 143q25.5 60 74 93q48.5 33 118.5 33q35 0 67-10.5q32-10.5 51-28.5l0-171l-139 0l0-69l215 0l0 276q-31 33-83.5 54.5q-52.5 21.5-118.5 21.5zm-173-718l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ĝ": [504, "m246 224q-59 0-104.5-15.5q-45.5-15.5-71-44.5q-25.5-29-25.5-71q0-31 19-59.5q19-28.5 52-50.5l0-4q-18-12-30.5-31.5q-12.5-19.5-12.5-47.5q0-31 17.5-54q17.5-23 35.5-36l0-4q-23-20-43-54q-20-34-20-77q0-53 25.5-92q25.5-39 67-60q41.5-21 90.5-21q20 0 38 3.5q18 3.5 31 8.5l169 0l0 63l-101 0l0 4q18 16 29.5 40q11.5 24 11.5 57q0 52-24 89.5q-24 37.5-64 58q-40 20.5-90 20.5q-18 0-37-4.5q-19-4.5-36-12.5q-12 11-21.5 24q-9.5 13-9.5 34q0 23 18.5 38q18.5 15 67.5 15l94 0q85 0 127.5 27.5q42.5 27.5 42.5 88.5q0 45-30 83q-30 38-85.5 61.5q-55.5 23.5-130.5 23.5zm0-433q28 0 51.5-14.5q23.5-14.5 37.5-40.5q14-26 14-61q0-54-30-83.5q-30-29.5-73-29.5q-43 0-73 29.5q-30 29.5-30 83.5q0 35 14 61q14 26 37.5 40.5q23.5 14.5 51.5 14.5zm12 376q46 0 80.5-14q34.5-14 54-37q19.5-23 19.5-48q0-34-25.5-47q-25.5-13-72.5-13l-84 0q-14 0-30.5-2q-16.5-2-32.5-6q-27 19-38.5 40q-11.5 21-11.5 42q0 39 37.5 62q37.5 23 103.5 23zm-170-737l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ğ": [617, "m348 12q-87 0-153.5-40.5q-66.5-40.5-104.5-116.5q-38-76-38-183q0-79 22.5-142q22.5-63 63-107.5q40.5-44.5 95.5-67.5q55-23 120-23q68 0 114.5 25q46.5 25 74.5 56l-46 52q-24-26-57.5-43q-33.5-17-83.5-17q-66 0-115 32.5q-49 32.5-75.5 91.5q-26.5 59-26.5 141q0 83 25.5 143q25.5 60 74 93q48.5 33 118.5 33q35 0 67-10.5q32-10.5 51-28.5l0-171l-139 0l0-69l215 0l0 276q-31 33-83.5 54.5q-52.5 21.5-118.5 21.5zm3-718q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ğ": [504, "m246 224q-59 0-104.5-15.5q-45.5-15.5-71-44.5q-25.5-29-25.5-71q0-31 19-59.5q19-28.5 52-50.5l0-4q-18-12-30.5-31.5q-12.5-19.5-12.5-47.5q0-31 17.5-54q17.5-23 35.5-36l0-4q-23-20-43-54q-20-34-20-77q0-53 25.5-92q25.5-39 67-60q41.5-21 90.5-21q20 0 38 3.5q18 3.5 31 8.5l169 0l0 63l-101 0l0 4q18 16 29.5 40q11.5 24 11.5 57q0 52-24 89.5q-24 37.5-64 58q-40 20.5-90 20.5q-18 0-37-4.5q-19-4.5-36-12.5q-12 11-21.5 24q-9.5 13-9.5 34q0 23 18.5 38q18.5 15 67.5 15l94 0q85 0 127.5 27.5q42.5 27.5 42.5 88.5q0 45-30 83q-30 38-85.5 61.5q-55.5 23.5-130.5 23.5zm0-433q28 0 51.5-14.5q23.5-14.5 37.5-40.5q14-26 14-61q0-54-30-83.5q-30-29.5-73-29.5q-43 0-73 29.5q-30 29.5-30 83.5q0 35 14 61q14 26 37.5 40.5q23.5 14.5 51.5 14.5zm12 376q46 0 80.5-14q34.5-14 54-37q19.5-23 19.5-48q0-34-25.5-47q-25.5-13-72.5-13l-84 0q-14 0-30.5-2q-16.5-2-32.5-6q-27 19-38.5 40q-11.5 21-11.5 42q0 39 37.5 62q37.5 23 103.5 23zm2-736q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Ġ": [617, "m348 12q-87 0-153.5-40.5q-66.5-40.5-104.5-116.5q-38-76-38-183q0-79 22.5-142q22.5-63 63-107.5q40.5-44.5 95.5-67.5q55-23 120-23q68 0 114.5 25q46.5 25 74.5 56l-46 52q-24-26-57.5-43q-33.5-17-83.5-17q-66 0-115 32.5q-49 32.5-75.5 91.5q-26.5 59-26.5 141q0 83 25.5 143q25.5 60 74 93q48.5 33 118.5 33q35 0 67-10.5q32-10.5 51-28.5l0-171l-139 0l0-69l215 0l0 276q-31 33-83.5 54.5q-52.5 21.5-118.5 21.5zm3-726q-24 0-40.5-15q-16.5-15-16.5-39q0-24 16.5-38.5q16.5-14.5 40.5-14.5q24 0 40.5 14.5q16.5 14.5 16.5 38.5q0 24-16.5 39q-16.5 15-40.5 15z"], "ġ": [504, "m246 224q-59 0-104.5-15.5q-45.5-15.5-71-44.5q-25.5-29-25.5-71q0-31 19-59.5q19-28.5 52-50.5l0-4q-18-12-30.5-31.5q-12.5-19.5-12.5-47.5q0-31 17.5-54q17.5-23 35.5-36l0-4q-23-20-43-54q-20-34-20-77q0-53 25.5-92q25.5-39 67-60q41.5-21 90.5-21q20 0 38 3.5q18 3.5 31 8.5l169 0l0 63l-101 0l0 4q18 16 29.5 40q11.5 24 11.5 57q0 52-24 89.5q-24 37.5-64 58q-40 20.5-90 20.5q-18 0-37-4.5q-19-4.5-36-12.5q-12 11-21.5 24q-9.5 13-9.5 34q0 23 18.5 38q18.5 15 67.5 15l94 0q85 0 127.5 27.5q42.5 27.5 42.5 88.5q0 45-30 83q-30 38-85.5 61.5q-55.5 23.5-130.5 23.5zm0-433q28 0 51.5-14.5q23.5-14.5 37.5-40.5q14-26 14-61q0-54-30-83.5q-30-29.5-73-29.5q-43 0-73 29.5q-30 29.5-30 83.5q0 35 14 61q14 26 37.5 40.5q23.5 14.5 51.5 14.5zm12 376q46 0 80.5-14q34.5-14 54-37q19.5-23 19.5-48q0-34-25.5-47q-25.5-13-72.5-13l-84 0q-14 0-30.5-2q-16.5-2-32.5-6q-27 19-38.5 40q-11.5 21-11.5 42q0 39 37.5 62q37.5 23 103.5 23zm2-753q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "Ģ": [617, "m348 12q-87 0-153.5-40.5q-66.5-40.5-104.5-116.5q-38-76-38-183q0-79 22.5-142q22.5-63 63-107.5q40.5-44.5 95.5-67.5q55-23 120-23q68 0 114.5 25q46.5 25 74.5 56l-46 52q-24-26-57.5-43q-33.5-17-83.5-17q-66 0-115 32.5q-49 32.5-75.5 91.5q-26.5 59-26.5 141q0 83 25.5 143q25.5 60 74 93q48.5 33 118.5 33q35 0 67-10.5q32-10.5 51-28.5l0-171l-139 0l0-69l215 0l0 276q-31 33-83.5 54.5q-52.5 21.5-118.5 21.5zm-84 214l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ģ": [504, "m246 224q-59 0-104.5-15.5q-45.5-15.5-71-44.5q-25.5-29-25.5-71q0-31 19-59.5q19-28.5 52-50.5l0-4q-18-12-30.5-31.5q-12.5-19.5-12.5-47.5q0-31 17.5-54q17.5-23 35.5-36l0-4q-23-20-43-54q-20-34-20-77q0-53 25.5-92q25.5-39 67-60q41.5-21 90.5-21q20 0 38 3.5q18 3.5 31 8.5l169 0l0 63l-101 0l0 4q18 16 29.5 40q11.5 24 11.5 57q0 52-24 89.5q-24 37.5-64 58q-40 20.5-90 20.5q-18 0-37-4.5q-19-4.5-36-12.5q-12 11-21.5 24q-9.5 13-9.5 34q0 23 18.5 38q18.5 15 67.5 15l94 0q85 0 127.5 27.5q42.5 27.5 42.5 88.5q0 45-30 83q-30 38-85.5 61.5q-55.5 23.5-130.5 23.5zm0-433q28 0 51.5-14.5q23.5-14.5 37.5-40.5q14-26 14-61q0-54-30-83.5q-30-29.5-73-29.5q-43 0-73 29.5q-30 29.5-30 83.5q0 35 14 61q14 26 37.5 40.5q23.5 14.5 51.5 14.5zm12 376q46 0 80.5-14q34.5-14 54-37q19.5-23 19.5-48q0-34-25.5-47q-25.5-13-72.5-13l-84 0q-14 0-30.5-2q-16.5-2-32.5-6q-27 19-38.5 40q-11.5 21-11.5 42q0 39 37.5 62q37.5 23 103.5 23zm41-742q-65-8-91-26q-26-18-26-51q0-44 43-66q43-22 122-26l8 41q-63 4-86 15.5q-23 11.5-23 32.5q0 19 18 29q18 10 53 13z"], "Ĥ": [652, "m90 0l0-656l83 0l0 275l306 0l0-275l83 0l0 656l-83 0l0-309l-306 0l0 309zm59-706l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ĥ": [544, "m82 0l0-712l82 0l0 194l-3 100q35-33 73.5-56.5q38.5-23.5 88.5-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352zm37-756l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "Ħ": [692, "m22-484l0-59l91-6l554 0l0 65zm88 484l0-656l83 0l0 275l306 0l0-275l83 0l0 656l-83 0l0-309l-306 0l0 309z"], "ħ": [557, "m95 0l0-712l82 0l0 232l-3 101q35-34 73.5-57q38.5-23 87.5-23q78 0 113.5 48q35.5 48 35.5 141l0 270l-82 0l0-259q0-67-21.5-98q-21.5-31-70.5-31q-37 0-67 19q-30 19-66 56l0 313zm-84-557l0-60l87-5l261 0l0 65z"], "Ĩ": [263, "m90 0l0-656l83 0l0 656zm117-709q-28 0-48-10.5q-20-10.5-36-24.5q-16-14-31-25q-15-11-33-11q-19 0-32 17q-13 17-16 49l-56-4q3-58 30-90.5q27-32.5 72-32.5q28 0 48.5 11q20.5 11 36.5 24.5q16 13.5 30.5 24.5q14.5 11 32.5 11q19 0 32-17q13-17 16-49l56 4q-2 58-29.5 90.5q-27.5 32.5-72.5 32.5z"], "ĩ": [246, "m82 0l0-486l82 0l0 486zm113-577q-26 0-45.5-12.5q-19.5-12.5-35.5-29.5q-16-17-30.5-29.5q-14.5-12.5-31.5-12.5q-22 0-33 21.5q-11 21.5-14 57.5l-55-3q1-40 12-70.5q11-30.5 32.5-48q21.5-17.5 56.5-17.5q27 0 46 12.5q19 12.5 35 29.5q16 17 30.5 29.5q14.5 12.5 32.5 12.5q22 0 33-22q11-22 13-57l55 4q-1 38-12 68.5q-11 30.5-32.5 48.5q-21.5 18-56.5 18z"], "Ī": [263, "m90 0l0-656l83 0l0 656zm-93-735l0-57l270 0l0 57z"], "ī": [246, "m82 0l0-486l82 0l0 486zm-92-601l0-57l266 0l0 57z"], "Ĭ": [263, "m90 0l0-656l83 0l0 656zm42-706q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ĭ": [246, "m82 0l0-486l82 0l0 486zm41-569q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Į": [263, "m139 219q-44 0-75-23q-31-23-31-69q0-40 23.5-72q23.5-32 50.5-55l-17 0l0-656l83 0l0 656q-31 22-51 50q-20 28-20 57q0 26 16 38q16 12 37 12q15 0 27.5-5q12.5-5 23.5-12l23 47q-16 13-40 22.5q-24 9.5-50 9.5z"], "į": [246, "m131 215q-41 0-70.5-22.5q-29.5-22.5-29.5-70.5q0-26 10-48.5q10-22.5 25.5-41q15.5-18.5 31.5-32.5l-16 0l0-486l82 0l0 486q-31 22-50 50q-19 28-19 56q0 26 16 38q16 12 35 12q16 0 27.5-4.5q11.5-4.5 23.5-12.5l21 45q-15 12-38 21.5q-23 9.5-49 9.5zm-7-801q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "İ": [263, "m90 0l0-656l83 0l0 656zm42-714q-24 0-40.5-15q-16.5-15-16.5-39q0-24 16.5-38.5q16.5-14.5 40.5-14.5q24 0 40.5 14.5q16.5 14.5 16.5 38.5q0 24-16.5 39q-16.5 15-40.5 15z"], "ı": [247, "m82 0l0-486l82 0l0 486z"], "Ĳ": [526, "m90 0l0-656l83 0l0 656zm212 165q-22 0-40.5-4q-18.5-4-31.5-8l16-66q10 3 22 6q12 3 24 3q37 0 49-26q12-26 12-70l0-656l83 0l0 659q0 50-13 86q-13 36-43 56q-30 20-78 20z"], "ĳ": [493, "m82 0l0-486l82 0l0 486zm41-586q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15zm155 803q-21 0-40-4q-19-4-32-10l17-62q9 3 21.5 6q12.5 3 24.5 3q36 0 48-25.5q12-25.5 12-70.5l0-540l82 0l0 541q0 49-13.5 85.5q-13.5 36.5-42.5 56.5q-29 20-77 20zm91-803q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "Ĵ": [480, "m207 12q-59 0-103-26.5q-44-26.5-71-79.5l56-37q20 36 48.5 52.5q28.5 16.5 64.5 16.5q54 0 80.5-32.5q26.5-32.5 26.5-108.5l0-453l83 0l0 461q0 57-18.5 104q-18.5 47-59.5 75q-41 28-107 28zm-35-718l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ĵ": [247, "m32 217q-21 0-40-4q-19-4-32-10l17-62q9 3 21.5 6q12.5 3 24.5 3q36 0 48-25.5q12-25.5 12-70.5l0-540l82 0l0 541q0 49-13.5 85.5q-13.5 36.5-42.5 56.5q-29 20-77 20zm-79-787l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ķ": [579, "m90 0l0-656l83 0l0 329l3 0l273-329l94 0l-205 250l237 406l-93 0l-196-341l-113 133l0 208zm151 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ķ": [495, "m82 0l0-712l82 0l0 481l2 0l206-255l92 0l-162 196l184 290l-90 0l-142-234l-90 106l0 128zm106 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ĸ": [495, "m82 0l0-486l82 0l0 258l3 0l206-258l91 0l-161 195l183 291l-90 0l-142-231l-90 106l0 125z"], "Ĺ": [486, "m90 0l0-656l83 0l0 585l287 0l0 71zm-34-706l132-135l101 0l4 9l-163 126z"], "ĺ": [255, "m169 9q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7 27.5q7 7.5 17 7.5q4 0 7.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5zm-121-765l132-135l101 0l4 9l-163 126z"], "Ļ": [486, "m90 0l0-656l83 0l0 585l287 0l0 71zm112 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ļ": [255, "m169 9q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7 27.5q7 7.5 17 7.5q4 0 7.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5zm-111 217l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "Ľ": [486, "m90 0l0-656l83 0l0 585l287 0l0 71zm244-514l-4-212l59 0l-1 57l-14 155z"], "ľ": [265, "m169 9q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7 27.5q7 7.5 17 7.5q4 0 7.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5zm52-557l-4-212l59 0l-1 57l-14 155z"], "Ŀ": [486, "m90 0l0-656l83 0l0 585l287 0l0 71zm287-263q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], "ŀ": [362, "m169 9q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7 27.5q7 7.5 17 7.5q4 0 7.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5zm135-272q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], "Ł": [500, "m25-208l-32-63l117-50l62-28l203-90l31 63l-229 99l-62 28zm82 208l0-656l83 0l0 585l287 0l0 71z"], "ł": [298, "m23-312l-32-62l119-55l62-28l95-46l32 62l-122 56l-62 28zm167 321q-31 0-50-12.5q-19-12.5-28-37q-9-24.5-9-59.5l0-612l82 0l0 618q0 20 7.5 27.5q7.5 7.5 17.5 7.5q3 0 6.5-0.5q3.5-0.5 9.5-1.5l12 62q-9 3-20.5 5.5q-11.5 2.5-27.5 2.5z"], "Ń": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343zm167-706l132-135l101 0l4 9l-163 126z"], "ń": [547, "m82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352zm136-570l129-165l90 0l5 9l-158 156z"], "Ņ": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343zm154 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ņ": [547, "m82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352zm108 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "Ň": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343zm205-708l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ň": [547, "m82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352zm177-570l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "ŉ": [769, "m87-435l-24-43q34-16 53.5-36q19.5-20 28-41.5q8.5-21.5 8.5-42.5q0-13-3-21.5q-3-8.5-10-16.5l12 0q-6 12-19 18q-13 6-27 6q-20 0-37.5-13.5q-17.5-13.5-17.5-39.5q0-27 19-43q19-16 46-16q40 0 68.5 28q28.5 28 28.5 80q0 38-12 72.5q-12 34.5-39.5 62q-27.5 27.5-74.5 46.5zm217 435l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 308l-82 0l0-297q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352z"], "Ŋ": [635, "m406 12q-18 0-41-4q-23-4-37-11l20-74q11 5 22.5 7.5q11.5 2.5 27.5 2.5q27 0 49.5-23.5q22.5-23.5 36-82q13.5-58.5 13.5-162.5q0-99-20.5-155.5q-20.5-56.5-56.5-80.5q-36-24-85-24q-26 0-56 13q-30 13-58 34.5q-28 21.5-48 50.5l0 497l-83 0l0-656l81 0l0 81q24-27 53.5-48q29.5-21 63-33q33.5-12 68.5-12q65 0 116.5 32q51.5 32 81 105.5q29.5 73.5 29.5 195.5q0 126-21.5 202.5q-21.5 76.5-61.5 110.5q-40 34-94 34z"], "ŋ": [547, "m338 217q-21 0-39.5-4q-18.5-4-31.5-10l16-61q9 3 21.5 5.5q12.5 2.5 24.5 2.5q36 0 48-26q12-26 12-69l0-352q0-69-21.5-99.5q-21.5-30.5-70.5-30.5q-37 0-66.5 19q-29.5 19-66.5 56l0 352l-82 0l0-486l68 0l7 70l3 0q35-35 74-58.5q39-23.5 89-23.5q77 0 112.5 48.5q35.5 48.5 35.5 141.5l0 363q0 50-13 86q-13 36-42.5 56q-29.5 20-77.5 20z"], "Ō": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm-135-673l0-57l270 0l0 57z"], "ō": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm-133-545l0-57l266 0l0 57z"], "Ŏ": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm0-644q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ŏ": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm0-513q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Ő": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33zm-138-644l106-135l81 0l5 9l-134 126zm187 0l107-135l80 0l5 9l-134 126z"], "ő": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5zm-112-514l86-165l68 0l5 9l-110 156zm161 0l86-165l68 0l5 9l-109 156z"], "Œ": [847, "m369 0q-100 0-171-39q-71-39-108.5-113q-37.5-74-37.5-179q0-104 37.5-177q37.5-73 109.5-110.5q72-37.5 174-37.5l415 0l0 70l-278 0l0 206l232 0l0 71l-232 0l0 238l288 0l0 71zm10-68l48 0l0-520l-48 0q-79 0-133 29.5q-54 29.5-81 87q-27 57.5-27 140.5q0 84 27 142.5q27 58.5 81 89.5q54 31 133 31z"], "œ": [839, "m263 12q-58 0-107.5-30q-49.5-30-80-87q-30.5-57-30.5-137q0-82 30.5-139q30.5-57 80.5-87q50-30 107-30q59 0 107 31.5q48 31.5 72 89.5q26-57 70.5-89q44.5-32 99.5-32q60 0 102.5 28.5q42.5 28.5 65 80q22.5 51.5 22.5 120.5q0 14-0.5 26q-0.5 12-2.5 22l-318 0q3 49 23 86.5q20 37.5 53 58.5q33 21 74 21q35 0 65.5-10q30.5-10 55.5-27l30 54q-31 22-70.5 36q-39.5 14-83.5 14q-61 0-109-32q-48-32-76-89q-27 59-72.5 90q-45.5 31-107.5 31zm3-70q40 0 70.5-23q30.5-23 47.5-64.5q17-41.5 17-96.5q0-56-17-98q-17-42-47.5-65.5q-30.5-23.5-70.5-23.5q-41 0-71 23.5q-30 23.5-47.5 65.5q-17.5 42-17.5 98q0 55 17.5 96.5q17.5 41.5 47.5 64.5q30 23 71 23zm215-227l247 0q0-71-31.5-108.5q-31.5-37.5-87.5-37.5q-32 0-59.5 18.5q-27.5 18.5-45.5 51.5q-18 33-23 76z"], "Ŕ": [569, "m90 0l0-656l205 0q67 0 119 17.5q52 17.5 81.5 58q29.5 40.5 29.5 108.5q0 66-29.5 109q-29.5 43-81.5 64.5q-52 21.5-119 21.5l-122 0l0 277zm83-345l110 0q77 0 118-31.5q41-31.5 41-95.5q0-64-41-90.5q-41-26.5-118-26.5l-110 0zm277 345l-171-300l65-44l200 344zm-232-706l132-135l101 0l4 9l-163 126z"], "ŕ": [347, "m82 0l0-486l68 0l7 88l3 0q24-46 60-73q36-27 78-27q16 0 28 2q12 2 24 8l-18 70q-11-3-20.5-4.5q-9.5-1.5-24.5-1.5q-31 0-64.5 25q-33.5 25-58.5 87l0 312zm63-570l129-165l90 0l5 9l-158 156z"], "Ŗ": [569, "m90 0l0-656l205 0q67 0 119 17.5q52 17.5 81.5 58q29.5 40.5 29.5 108.5q0 66-29.5 109q-29.5 43-81.5 64.5q-52 21.5-119 21.5l-122 0l0 277zm83-345l110 0q77 0 118-31.5q41-31.5 41-95.5q0-64-41-90.5q-41-26.5-118-26.5l-110 0zm277 345l-171-300l65-44l200 344zm-227 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "ŗ": [347, "m82 0l0-486l68 0l7 88l3 0q24-46 60-73q36-27 78-27q16 0 28 2q12 2 24 8l-18 70q-11-3-20.5-4.5q-9.5-1.5-24.5-1.5q-31 0-64.5 25q-33.5 25-58.5 87l0 312zm-48 226l-8-40q63-5 86-16.5q23-11.5 23-31.5q0-19-18-29q-18-10-53-13l18-38q66 7 91.5 25q25.5 18 25.5 52q0 43-42.5 65q-42.5 22-122.5 26z"], "Ř": [569, "m90 0l0-656l205 0q67 0 119 17.5q52 17.5 81.5 58q29.5 40.5 29.5 108.5q0 66-29.5 109q-29.5 43-81.5 64.5q-52 21.5-119 21.5l-122 0l0 277zm83-345l110 0q77 0 118-31.5q41-31.5 41-95.5q0-64-41-90.5q-41-26.5-118-26.5l-110 0zm277 345l-171-300l65-44l200 344zm-194-708l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ř": [347, "m82 0l0-486l68 0l7 88l3 0q24-46 60-73q36-27 78-27q16 0 28 2q12 2 24 8l-18 70q-11-3-20.5-4.5q-9.5-1.5-24.5-1.5q-31 0-64.5 25q-33.5 25-58.5 87l0 312zm104-570l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "Ś": [534, "m272 12q-70 0-128-26.5q-58-26.5-102-71.5l47-54q35 37 83.5 58q48.5 21 100.5 21q65 0 101-29.5q36-29.5 36-77.5q0-34-14.5-54q-14.5-20-39-34q-24.5-14-55.5-28l-94-41q-32-14-62.5-35q-30.5-21-50.5-53.5q-20-32.5-20-80.5q0-50 26.5-89.5q26.5-39.5 73-62q46.5-22.5 106.5-22.5q60 0 110 22q50 22 84 57l-45 54q-31-27-68-43.5q-37-16.5-81-16.5q-55 0-88.5 26q-33.5 26-33.5 70q0 31 16 51q16 20 41.5 33q25.5 13 51.5 25l93 40q39 17 69.5 39q30.5 22 48 55q17.5 33 17.5 81q0 52-26.5 94.5q-26.5 42.5-77 67.5q-50.5 25-119.5 25zm-69-718l132-135l101 0l4 9l-163 126z"], "ś": [419, "m209 12q-53 0-100.5-18.5q-47.5-18.5-80.5-51.5l38-48q32 26 66.5 40q34.5 14 79.5 14q48 0 72-22.5q24-22.5 24-53.5q0-25-16.5-41.5q-16.5-16.5-41-28q-24.5-11.5-52.5-21.5q-36-13-69-30.5q-33-17.5-53.5-44q-20.5-26.5-20.5-66.5q0-59 44.5-98.5q44.5-39.5 123.5-39.5q45 0 84 15.5q39 15.5 67 39.5l-38 47q-26-18-53-28q-27-10-60-10q-46 0-67.5 21q-21.5 21-21.5 49q0 22 13 36.5q13 14.5 36.5 25.5q23.5 11 53.5 21q38 14 72.5 31.5q34.5 17.5 56 45q21.5 27.5 21.5 71.5q0 40-20.5 72.5q-20.5 32.5-60 52.5q-39.5 20-97.5 20zm-71-582l129-165l90 0l5 9l-158 156z"], "Ŝ": [534, "m272 12q-70 0-128-26.5q-58-26.5-102-71.5l47-54q35 37 83.5 58q48.5 21 100.5 21q65 0 101-29.5q36-29.5 36-77.5q0-34-14.5-54q-14.5-20-39-34q-24.5-14-55.5-28l-94-41q-32-14-62.5-35q-30.5-21-50.5-53.5q-20-32.5-20-80.5q0-50 26.5-89.5q26.5-39.5 73-62q46.5-22.5 106.5-22.5q60 0 110 22q50 22 84 57l-45 54q-31-27-68-43.5q-37-16.5-81-16.5q-55 0-88.5 26q-33.5 26-33.5 70q0 31 16 51q16 20 41.5 33q25.5 13 51.5 25l93 40q39 17 69.5 39q30.5 22 48 55q17.5 33 17.5 81q0 52-26.5 94.5q-26.5 42.5-77 67.5q-50.5 25-119.5 25zm-168-718l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ŝ": [419, "m209 12q-53 0-100.5-18.5q-47.5-18.5-80.5-51.5l38-48q32 26 66.5 40q34.5 14 79.5 14q48 0 72-22.5q24-22.5 24-53.5q0-25-16.5-41.5q-16.5-16.5-41-28q-24.5-11.5-52.5-21.5q-36-13-69-30.5q-33-17.5-53.5-44q-20.5-26.5-20.5-66.5q0-59 44.5-98.5q44.5-39.5 123.5-39.5q45 0 84 15.5q39 15.5 67 39.5l-38 47q-26-18-53-28q-27-10-60-10q-46 0-67.5 21q-21.5 21-21.5 49q0 22 13 36.5q13 14.5 36.5 25.5q23.5 11 53.5 21q38 14 72.5 31.5q34.5 17.5 56 45q21.5 27.5 21.5 71.5q0 40-20.5 72.5q-20.5 32.5-60 52.5q-39.5 20-97.5 20zm-166-582l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ş": [534, "m272 12q-70 0-128-26.5q-58-26.5-102-71.5l47-54q35 37 83.5 58q48.5 21 100.5 21q65 0 101-29.5q36-29.5 36-77.5q0-34-14.5-54q-14.5-20-39-34q-24.5-14-55.5-28l-94-41q-32-14-62.5-35q-30.5-21-50.5-53.5q-20-32.5-20-80.5q0-50 26.5-89.5q26.5-39.5 73-62q46.5-22.5 106.5-22.5q60 0 110 22q50 22 84 57l-45 54q-31-27-68-43.5q-37-16.5-81-16.5q-55 0-88.5 26q-33.5 26-33.5 70q0 31 16 51q16 20 41.5 33q25.5 13 51.5 25l93 40q39 17 69.5 39q30.5 22 48 55q17.5 33 17.5 81q0 52-26.5 94.5q-26.5 42.5-77 67.5q-50.5 25-119.5 25zm-86 214l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "ş": [419, "m209 12q-53 0-100.5-18.5q-47.5-18.5-80.5-51.5l38-48q32 26 66.5 40q34.5 14 79.5 14q48 0 72-22.5q24-22.5 24-53.5q0-25-16.5-41.5q-16.5-16.5-41-28q-24.5-11.5-52.5-21.5q-36-13-69-30.5q-33-17.5-53.5-44q-20.5-26.5-20.5-66.5q0-59 44.5-98.5q44.5-39.5 123.5-39.5q45 0 84 15.5q39 15.5 67 39.5l-38 47q-26-18-53-28q-27-10-60-10q-46 0-67.5 21q-21.5 21-21.5 49q0 22 13 36.5q13 14.5 36.5 25.5q23.5 11 53.5 21q38 14 72.5 31.5q34.5 17.5 56 45q21.5 27.5 21.5 71.5q0 40-20.5 72.5q-20.5 32.5-60 52.5q-39.5 20-97.5 20zm-82 214l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "Š": [534, "m272 12q-70 0-128-26.5q-58-26.5-102-71.5l47-54q35 37 83.5 58q48.5 21 100.5 21q65 0 101-29.5q36-29.5 36-77.5q0-34-14.5-54q-14.5-20-39-34q-24.5-14-55.5-28l-94-41q-32-14-62.5-35q-30.5-21-50.5-53.5q-20-32.5-20-80.5q0-50 26.5-89.5q26.5-39.5 73-62q46.5-22.5 106.5-22.5q60 0 110 22q50 22 84 57l-45 54q-31-27-68-43.5q-37-16.5-81-16.5q-55 0-88.5 26q-33.5 26-33.5 70q0 31 16 51q16 20 41.5 33q25.5 13 51.5 25l93 40q39 17 69.5 39q30.5 22 48 55q17.5 33 17.5 81q0 52-26.5 94.5q-26.5 42.5-77 67.5q-50.5 25-119.5 25zm-31-720l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "š": [419, "m209 12q-53 0-100.5-18.5q-47.5-18.5-80.5-51.5l38-48q32 26 66.5 40q34.5 14 79.5 14q48 0 72-22.5q24-22.5 24-53.5q0-25-16.5-41.5q-16.5-16.5-41-28q-24.5-11.5-52.5-21.5q-36-13-69-30.5q-33-17.5-53.5-44q-20.5-26.5-20.5-66.5q0-59 44.5-98.5q44.5-39.5 123.5-39.5q45 0 84 15.5q39 15.5 67 39.5l-38 47q-26-18-53-28q-27-10-60-10q-46 0-67.5 21q-21.5 21-21.5 49q0 22 13 36.5q13 14.5 36.5 25.5q23.5 11 53.5 21q38 14 72.5 31.5q34.5 17.5 56 45q21.5 27.5 21.5 71.5q0 40-20.5 72.5q-20.5 32.5-60 52.5q-39.5 20-97.5 20zm-30-582l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "Ţ": [536, "m226 0l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585zm-51 226l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "ţ": [338, "m235 9q-77 0-108-45q-31-45-31-117l0-266l-72 0l0-62l76-5l10-156l69 0l0 156l132 0l0 67l-132 0l0 267q0 44 16.5 69q16.5 25 58.5 25q13 0 27-2.5q14-2.5 28-9.5l18 58q-19 9-43 15q-24 6-49 6zm-107 217l-8-40q63-5 86-16.5q23-11.5 23-33.5q0-20-17-31q-17-11-60-17l44-91l53 0l-29 67q35 8 54 24q19 16 19 47q0 43-42.5 65q-42.5 22-122.5 26z"], "Ť": [536, "m226 0l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585zm2-708l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ť": [338, "m235 9q-77 0-108-45q-31-45-31-117l0-266l-72 0l0-62l76-5l10-156l69 0l0 156l132 0l0 67l-132 0l0 267q0 44 16.5 69q16.5 25 58.5 25q13 0 27-2.5q14-2.5 28-9.5l18 58q-19 9-43 15q-24 6-49 6zm21-557l-4-212l59 0l-1 57l-14 155z"], "Ŧ": [536, "m103-303l0-61l88-4l242 0l0 65zm123 303l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585z"], "ŧ": [338, "m24-218l0-60l76-5l211 0l0 65zm211 227q-77 0-108-45q-31-45-31-117l0-266l-72 0l0-62l76-5l10-156l69 0l0 156l132 0l0 67l-132 0l0 267q0 44 16.5 69q16.5 25 58.5 25q13 0 27-2.5q14-2.5 28-9.5l18 58q-19 9-43 15q-24 6-49 6z"], "Ũ": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm74-721q-28 0-48-10.5q-20-10.5-36-24.5q-16-14-31-25q-15-11-33-11q-19 0-32 17q-13 17-16 49l-56-4q3-58 30-90.5q27-32.5 72-32.5q28 0 48.5 11q20.5 11 36.5 24.5q16 13.5 30.5 24.5q14.5 11 32.5 11q19 0 32-17q13-17 16-49l56 4q-2 58-29.5 90.5q-27.5 32.5-72.5 32.5z"], "ũ": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm119-589q-26 0-45.5-12.5q-19.5-12.5-35.5-29.5q-16-17-30.5-29.5q-14.5-12.5-31.5-12.5q-22 0-33 21.5q-11 21.5-14 57.5l-55-3q1-40 12-70.5q11-30.5 32.5-48q21.5-17.5 56.5-17.5q27 0 46 12.5q19 12.5 35 29.5q16 17 30.5 29.5q14.5 12.5 32.5 12.5q22 0 33-22q11-22 13-57l55 4q-1 38-12 68.5q-11 30.5-32.5 48.5q-21.5 18-56.5 18z"], "Ū": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-136-747l0-57l270 0l0 57z"], "ū": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm-86-613l0-57l266 0l0 57z"], "Ŭ": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-1-718q-46 0-77-17.5q-31-17.5-48-47q-17-29.5-21-64.5l50-8q6 35 29.5 59.5q23.5 24.5 66.5 24.5q43 0 66.5-24.5q23.5-24.5 29.5-59.5l50 8q-4 35-21 64.5q-17 29.5-47.5 47q-30.5 17.5-77.5 17.5z"], "ŭ": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm47-581q-53 0-86.5-22.5q-33.5-22.5-50-57.5q-16.5-35-19.5-71l51-9q4 26 16.5 50q12.5 24 34.5 39q22 15 54 15q33 0 55-15q22-15 34-39q12-24 16-50l51 9q-3 36-19.5 71q-16.5 35-49.5 57.5q-33 22.5-87 22.5z"], "Ů": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-1-711q-50 0-80.5-24.5q-30.5-24.5-30.5-65.5q0-42 30.5-66.5q30.5-24.5 80.5-24.5q51 0 81 24.5q30 24.5 30 66.5q0 41-30 65.5q-30 24.5-81 24.5zm0-36q25 0 41-14q16-14 16-40q0-27-16-41q-16-14-41-14q-24 0-40.5 14q-16.5 14-16.5 41q0 26 16.5 40q16.5 14 40.5 14z"], "ů": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm47-566q-50 0-80-28q-30-28-30-71q0-42 30-70q30-28 80-28q51 0 80.5 28q29.5 28 29.5 70q0 43-29.5 71q-29.5 28-80.5 28zm0-37q24 0 40.5-17q16.5-17 16.5-45q0-28-16.5-44.5q-16.5-16.5-40.5-16.5q-24 0-40.5 16.5q-16.5 16.5-16.5 44.5q0 28 17 45q17 17 40 17z"], "Ű": [645, "m323 12q-51 0-93.5-14.5q-42.5-14.5-74.5-47q-32-32.5-50-86.5q-18-54-18-131l0-389l83 0l0 391q0 77 20.5 121.5q20.5 44.5 55 63q34.5 18.5 77.5 18.5q43 0 78.5-18.5q35.5-18.5 56.5-63q21-44.5 21-121.5l0-391l79 0l0 389q0 77-17.5 131q-17.5 54-49.5 86.5q-32 32.5-75 47q-43 14.5-93 14.5zm-139-718l106-135l81 0l5 9l-134 126zm187 0l107-135l80 0l5 9l-134 126z"], "ű": [544, "m224 12q-77 0-112.5-48.5q-35.5-48.5-35.5-141.5l0-308l82 0l0 297q0 68 21.5 98.5q21.5 30.5 69.5 30.5q37 0 66.5-19.5q29.5-19.5 64.5-61.5l0-345l82 0l0 486l-68 0l-7-76l-3 0q-33 40-71.5 64q-38.5 24-88.5 24zm-65-582l86-165l68 0l5 9l-110 156zm161 0l86-165l68 0l5 9l-109 156z"], "Ų": [645, "m336 219q-43 0-74-23q-31-23-31-69q0-41 24.5-75.5q24.5-34.5 52.5-54.5l15 15q-50 0-93.5-15q-43.5-15-75.5-47.5q-32-32.5-49.5-87q-17.5-54.5-17.5-133.5l0-385l83 0l0 387q0 80 20.5 125.5q20.5 45.5 55 64.5q34.5 19 77.5 19q43 0 78.5-19q35.5-19 56-64.5q20.5-45.5 20.5-125.5l0-387l80 0l0 385q0 85-21 142.5q-21 57.5-61 90.5q-40 33-98 47q-23 6-41 21.5q-18 15.5-28 36q-10 20.5-10 40.5q0 26 16 38q16 12 37 12q15 0 27.5-5q12.5-5 23.5-12l23 47q-16 13-40 22.5q-24 9.5-50 9.5z"], "ų": [544, "m417 215q-41 0-70.5-22.5q-29.5-22.5-29.5-70.5q0-26 11.5-50q11.5-24 29.5-43.5q18-19.5 37-32.5l-8-72l-3 0q-34 40-72 64q-38 24-88 24q-76 0-112.5-48.5q-36.5-48.5-36.5-141.5l0-308l83 0l0 297q0 68 21.5 99q21.5 31 69.5 31q38 0 67-19.5q29-19.5 64-62.5l0-345l82 0l0 486q-38 17-59.5 47.5q-21.5 30.5-21.5 58.5q0 26 16 38q16 12 35 12q16 0 27.5-4.5q11.5-4.5 23.5-12.5l21 45q-15 12-38 21.5q-23 9.5-49 9.5z"], "Ŵ": [786, "m159 0l-136-656l89 0l67 357q10 53 19 106q9 53 17 109l4 0q10-56 21.5-109q11.5-53 23.5-106l89-357l84 0l86 357q12 52 24 105.5q12 53.5 23 109.5l4 0q8-56 17-109q9-53 18-106l69-357l85 0l-137 656l-107 0l-94-394q-8-37-15.5-74.5q-7.5-37.5-14.5-79.5l-4 0q-6 42-13.5 79.5q-7.5 37.5-15.5 74.5l-96 394zm58-706l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ŵ": [718, "m159 0l-135-486l86 0l71 281q8 33 15 66q7 33 13 72l4 0q8-39 15.5-72q7.5-33 15.5-66l72-281l90 0l73 281q9 33 16.5 66q7.5 33 15.5 72l4 0q8-39 15-72q7-33 14-66l71-281l80 0l-131 486l-107 0l-65-260q-8-34-15.5-67.5q-7.5-33.5-15.5-76.5l-4 0q-7 43-14.5 77q-7.5 34-16.5 67l-65 260zm29-570l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ŷ": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254zm-134-706l137-135l78 0l137 135l-70 0l-104-81l-4 0l-104 81z"], "ŷ": [467, "m90 209q-16 0-30.5-3q-14.5-3-26.5-7l18-64q9 3 18 4.5q9 1.5 17 1.5q42 0 68.5-29.5q26.5-29.5 41.5-74.5l11-36l-195-487l85 0l99 269q12 31 24 67q12 36 23 70l4 0q11-34 21.5-69.5q10.5-35.5 19.5-67.5l87-269l80 0l-183 526q-17 48-41 86.5q-24 38.5-58 60.5q-34 22-83 22zm-21-779l136-165l72 0l136 165l-67 0l-103-103l-4 0l-103 103z"], "Ÿ": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254zm-61-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Ź": [539, "m45 0l0-50l345-536l-314 0l0-70l418 0l0 49l-346 536l349 0l0 71zm158-706l132-135l101 0l4 9l-163 126z"], "ź": [425, "m31 0l0-44l256-375l-228 0l0-67l332 0l0 44l-256 375l264 0l0 67zm123-570l129-165l90 0l5 9l-158 156z"], "Ż": [539, "m45 0l0-50l345-536l-314 0l0-70l418 0l0 49l-346 536l349 0l0 71zm235-714q-24 0-40.5-15q-16.5-15-16.5-39q0-24 16.5-38.5q16.5-14.5 40.5-14.5q24 0 40.5 14.5q16.5 14.5 16.5 38.5q0 24-16.5 39q-16.5 15-40.5 15z"], "ż": [425, "m31 0l0-44l256-375l-228 0l0-67l332 0l0 44l-256 375l264 0l0 67zm200-586q-24 0-39.5-15q-15.5-15-15.5-39q0-24 15.5-39q15.5-15 39.5-15q24 0 39.5 15q15.5 15 15.5 39q0 24-15.5 39q-15.5 15-39.5 15z"], "Ž": [539, "m45 0l0-50l345-536l-314 0l0-70l418 0l0 49l-346 536l349 0l0 71zm196-708l-137-133l70 0l104 78l4 0l104-78l70 0l-137 133z"], "ž": [425, "m31 0l0-44l256-375l-228 0l0-67l332 0l0 44l-256 375l264 0l0 67zm164-570l-136-165l67 0l103 103l4 0l103-103l67 0l-136 165z"], "ſ": [271, "m96 0l0-563q0-49 15-85.5q15-36.5 46.5-56q31.5-19.5 80.5-19.5q22 0 43.5 4.5q21.5 4.5 37.5 11.5l-18 62q-29-11-55-11q-34 0-51 23.5q-17 23.5-17 70.5l0 563zm-66-419l0-62l69-5l63 0l0 67z"], "Α": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66z"], "Β": [588, "m90 0l0-656l195 0q66 0 117 16q51 16 79.5 51.5q28.5 35.5 28.5 92.5q0 51-24.5 89.5q-24.5 38.5-71.5 53.5l0 4q62 11 98 49.5q36 38.5 36 104.5q0 66-31.5 109q-31.5 43-87.5 64.5q-56 21.5-130 21.5zm83-377l97 0q84 0 121-29q37-29 37-79q0-58-39-81.5q-39-23.5-115-23.5l-101 0zm0 311l114 0q85 0 132-31.5q47-31.5 47-97.5q0-61-46-89.5q-46-28.5-133-28.5l-114 0z"], "Γ": [498, "m90 0l0-656l378 0l0 71l-295 0l0 585z"], "Δ": [588, "m30 0l0-50l216-606l96 0l216 606l0 50zm90-71l346 0l-102-300l-69-210l-4 0l-69 210z"], "Ε": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71z"], "Ζ": [539, "m45 0l0-50l345-536l-314 0l0-70l418 0l0 49l-346 536l349 0l0 71z"], "Η": [652, "m90 0l0-656l83 0l0 275l306 0l0-275l83 0l0 656l-83 0l0-309l-306 0l0 309z"], "Θ": [664, "m220-309l0-72l224 0l0 72zm112 321q-82 0-145.5-42q-63.5-42-99-118.5q-35.5-76.5-35.5-182.5q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 106-36 182.5q-36 76.5-99 118.5q-63 42-146 42zm0-73q59 0 102.5-33.5q43.5-33.5 67.5-94q24-60.5 24-142.5q0-81-24-140.5q-24-59.5-67.5-91.5q-43.5-32-102.5-32q-58 0-102 32q-44 32-68 91.5q-24 59.5-24 140.5q0 82 24 142.5q24 60.5 68 94q44 33.5 102 33.5z"], "Ι": [263, "m90 0l0-656l83 0l0 656z"], "Κ": [579, "m90 0l0-656l83 0l0 329l3 0l273-329l94 0l-205 250l237 406l-93 0l-196-341l-113 133l0 208z"], "Λ": [515, "m0 0l209-656l96 0l210 656l-88 0l-106-355q-17-58-31-108.5q-14-50.5-33-108.5l-4 0q-18 58-31.5 108.5q-13.5 50.5-31.5 108.5l-105 355z"], "Μ": [727, "m90 0l0-656l105 0l124 351q12 33 22.5 66q10.5 33 21.5 70l4 0q11-37 21-70q10-33 21-66l124-351l104 0l0 656l-78 0l0-361q0-29 2-65q2-36 4.5-71.5q2.5-35.5 5.5-64.5l-4 0l-51 158l-123 339l-61 0l-123-339l-51-158l-4 0q3 29 5.5 64.5q2.5 35.5 4.5 71.5q2 36 2 65l0 361z"], "Ν": [647, "m90 0l0-656l91 0l233 408q19 33 36 68.5q17 35.5 34 72.5l4 0q-3-51-7-104.5q-4-53.5-4-103.5l0-341l80 0l0 656l-91 0l-233-408q-18-33-36.5-69q-18.5-36-34.5-72l-4 0q4 49 7.5 101q3.5 52 3.5 105l0 343z"], "Ξ": [533, "m49 0l0-71l435 0l0 71zm75-309l0-71l285 0l0 71zm-65-277l0-70l415 0l0 70z"], "Ο": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33z"], "Π": [645, "m90 0l0-656l465 0l0 656l-83 0l0-586l-299 0l0 586z"], "Ρ": [566, "m90 0l0-656l187 0q74 0 129 18.5q55 18.5 86 60.5q31 42 31 114q0 69-30.5 113.5q-30.5 44.5-85 67q-54.5 22.5-126.5 22.5l-108 0l0 260zm83-328l98 0q86 0 127.5-33q41.5-33 41.5-102q0-71-43.5-98.5q-43.5-27.5-129.5-27.5l-94 0z"], "Σ": [538, "m44 0l0-50l226-283l-222-274l0-49l423 0l0 70l-318 0l201 251l-204 264l351 0l0 71z"], "Τ": [536, "m226 0l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585z"], "Υ": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254z"], "Φ": [719, "m343-71q-89 0-155.5-31.5q-66.5-31.5-103-89.5q-36.5-58-36.5-139q0-80 36.5-137q36.5-57 103-87.5q66.5-30.5 155.5-30.5l33 0q89 0 155 30.5q66 30.5 103 87.5q37 57 37 137q0 81-37 139q-37 58-103 89.5q-66 31.5-155 31.5zm-4-65l41 0q64 0 111-24.5q47-24.5 73-68q26-43.5 26-102.5q0-58-26-100.5q-26-42.5-73-66q-47-23.5-111-23.5l-41 0q-64 0-111 23.5q-47 23.5-73 66q-26 42.5-26 100.5q0 59 26 102.5q26 43.5 73 68q47 24.5 111 24.5zm-17 158l0-700l75 0l0 700z"], "Χ": [513, "m15 0l191-339l-178-317l92 0l89 168q13 22 24.5 44q11.5 22 26.5 51l4 0q14-29 24.5-51q10.5-22 22.5-44l87-168l88 0l-179 321l191 335l-92 0l-96-177q-13-24-26.5-49.5q-13.5-25.5-29.5-55.5l-4 0q-14 30-26.5 55.5q-12.5 25.5-25.5 49.5l-95 177z"], "Ψ": [699, "m331-245q-84 0-144-26q-60-26-92-81q-32-55-32-143l0-161l82 0l0 157q0 66 20.5 107.5q20.5 41.5 61 60.5q40.5 19 100.5 19l45 0q60 0 100.5-19q40.5-19 60.5-60.5q20-41.5 20-107.5l0-157l83 0l0 161q0 88-32.5 143q-32.5 55-92 81q-59.5 26-143.5 26zm-21 245l0-656l79 0l0 656z"], "Ω": [678, "m45 0l0-68l131 0l0-4q-28-28-55-68q-27-40-44.5-92.5q-17.5-52.5-17.5-118.5q0-92 34.5-163.5q34.5-71.5 97.5-112.5q63-41 148-41q85 0 148 41q63 41 98 112.5q35 71.5 35 163.5q0 66-17.5 118.5q-17.5 52.5-44.5 92.5q-27 40-56 68l0 4l131 0l0 68l-233 0l0-61q38-29 68-69.5q30-40.5 48-93.5q18-53 18-122q0-71-23-127.5q-23-56.5-67-89q-44-32.5-105-32.5q-61 0-104.5 32.5q-43.5 32.5-66.5 89q-23 56.5-23 127.5q0 69 17.5 122q17.5 53 48 93.5q30.5 40.5 67.5 69.5l0 61z"], "Ϊ": [263, "m90 0l0-656l83 0l0 656zm-61-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "Ϋ": [476, "m196 0l0-254l-197-402l89 0l85 185q15 36 30.5 71q15.5 35 32.5 72l4 0q18-37 34.5-72q16.5-35 31.5-71l84-185l87 0l-198 402l0 254zm-61-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "ά": [560, "m233 12q-83 0-135-63.5q-52-63.5-52-182.5q0-84 30-143q30-59 78.5-90q48.5-31 104.5-31q30 0 59.5 12.5q29.5 12.5 53 40.5q23.5 28 37.5 74l2 0l21-115l81 0q-10 48-20.5 100.5q-10.5 52.5-19.5 104q-9 51.5-15 96.5q-6 45-6 78q0 25 14.5 38q14.5 13 33.5 13q9 0 18-2.5q9-2.5 16-5.5l12 63q-10 5-25.5 9q-15.5 4-37.5 4q-43 0-69.5-24q-26.5-24-26.5-75l-3 0q-55 99-151 99zm17-69q32 0 61-20.5q29-20.5 48.5-55q19.5-34.5 22.5-75.5l8-91q-14-53-34-81q-20-28-42.5-38.5q-22.5-10.5-45.5-10.5q-35 0-66 22q-31 22-51 65q-20 43-20 107q0 84 32 131q32 47 87 47zm-8-507l39-188l84 0l5 9l-68 179z"], "έ": [448, "m251 12q-60 0-106-17.5q-46-17.5-72-49.5q-26-32-26-75q0-54 30.5-85q30.5-31 71.5-41l0-4q-38-14-58-43.5q-20-29.5-20-64.5q0-44 25.5-72.5q25.5-28.5 67.5-43q42-14.5 91-14.5q45 0 85 14q40 14 73 40l-33 54q-28-21-58-32q-30-11-64-11q-45 0-75.5 18.5q-30.5 18.5-30.5 55.5q0 33 27 54q27 21 84 21q15 0 29-1.5q14-1.5 33-2.5l0 70q-20-2-37-2.5q-17-0.5-34-0.5q-63 0-94.5 20.5q-31.5 20.5-31.5 59.5q0 41 35 64q35 23 97 23q35 0 67-11.5q32-11.5 67-38.5l34 55q-44 34-84.5 47.5q-40.5 13.5-92.5 13.5zm-47-576l39-188l84 0l5 9l-68 179z"], "ή": [541, "m382 179q2-60 3-122q1-62 1.5-123.5q0.5-61.5 1-120q0.5-58.5 0.5-110.5q0-69-18-99.5q-18-30.5-61-30.5q-27 0-49.5 10.5q-22.5 10.5-45.5 34q-23 23.5-50 64.5l0 318l-82 0l0-353q0-29-1-62q-1-33-6-71l75 0l7 101l3 0q37-56 78.5-84.5q41.5-28.5 94.5-28.5q70 0 101 48.5q31 48.5 31 141.5l0 487zm-135-743l39-188l84 0l5 9l-68 179z"], "ί": [262, "m175 9q-34 0-54-13q-20-13-29.5-38.5q-9.5-25.5-9.5-61.5l0-382l83 0q-1 66-2.5 133.5q-1.5 67.5-2.5 132q-1 64.5-1 122.5q0 21 9.5 30q9.5 9 24.5 9q7 0 14-1.5q7-1.5 16-4.5l11 63q-11 4-25 7.5q-14 3.5-34 3.5zm-97-573l39-188l84 0l5 9l-68 179z"], "ΰ": [510, "m249 12q-58 0-99.5-21.5q-41.5-21.5-63.5-64.5q-22-43-22-106q0-44 2-87q2-43 2-86q0-29-1-62q-1-33-7-71l80 0q5 25 6.5 53q1.5 28 1.5 60q0 41-3 96.5q-3 55.5-3 100.5q0 44 15 70q15 26 39.5 38q24.5 12 53.5 12q35 0 62.5-20q27.5-20 43.5-60.5q16-40.5 16-103.5q0-56-8.5-114q-8.5-58-31.5-125l80-19q22 63 32.5 126.5q10.5 63.5 10.5 128.5q0 82-26 139q-26 57-72.5 86.5q-46.5 29.5-107.5 29.5zm-119-601q-20 0-33.5-13.5q-13.5-13.5-13.5-32.5q0-21 13.5-34q13.5-13 33.5-13q21 0 34 13q13 13 13 34q0 19-13 32.5q-13 13.5-34 13.5zm230 0q-20 0-33.5-13.5q-13.5-13.5-13.5-32.5q0-21 13.5-34q13.5-13 33.5-13q21 0 34 13q13 13 13 34q0 19-13 32.5q-13 13.5-34 13.5zm-156 25l39-190l65 0l5 10l-68 180z"], "α": [560, "m233 12q-83 0-135-63.5q-52-63.5-52-182.5q0-84 30-143q30-59 78.5-90q48.5-31 104.5-31q30 0 59.5 12.5q29.5 12.5 53 40.5q23.5 28 37.5 74l2 0l21-115l81 0q-10 48-20.5 100.5q-10.5 52.5-19.5 104q-9 51.5-15 96.5q-6 45-6 78q0 25 14.5 38q14.5 13 33.5 13q9 0 18-2.5q9-2.5 16-5.5l12 63q-10 5-25.5 9q-15.5 4-37.5 4q-43 0-69.5-24q-26.5-24-26.5-75l-3 0q-55 99-151 99zm17-69q32 0 61-20.5q29-20.5 48.5-55q19.5-34.5 22.5-75.5l8-91q-14-53-34-81q-20-28-42.5-38.5q-22.5-10.5-45.5-10.5q-35 0-66 22q-31 22-51 65q-20 43-20 107q0 84 32 131q32 47 87 47z"], "β": [565, "m79 179l0-670q0-67 22-119.5q22-52.5 66.5-83q44.5-30.5 111.5-30.5q48 0 89.5 18.5q41.5 18.5 67.5 57q26 38.5 26 97.5q0 54-25 95.5q-25 41.5-71 70.5l0 4q47 7 82 32q35 25 54 65q19 40 19 91q0 66-27 111.5q-27 45.5-70.5 69.5q-43.5 24-92.5 24q-46 0-91-16.5q-45-16.5-83-57.5q2 61 3 120q1 59 2 121zm233-236q35 0 64-17q29-17 46-48.5q17-31.5 17-75.5q0-58-33.5-97q-33.5-39-102.5-39q-26 0-50 6l-13-63q52-10 83-34.5q31-24.5 45-56q14-31.5 14-63.5q0-57-30-84.5q-30-27.5-71-27.5q-57 0-89 45q-32 45-32 132q-2 88-2.5 174q-0.5 86-0.5 173q36 45 76.5 60.5q40.5 15.5 78.5 15.5z"], "γ": [484, "m196 179q2-22 3-39.5q1-17.5 1.5-36q0.5-18.5 0.5-45.5q0-60-16.5-132.5q-16.5-72.5-44.5-147q-28-74.5-62.5-141q-34.5-66.5-71.5-114.5l83-21q22 31 46 76q24 45 46 98.5q22 53.5 39.5 111.5q17.5 58 28.5 115l4 0q32-61 59-125q27-64 45.5-130q18.5-66 23.5-134l83 0q-10 61-24.5 117q-14.5 56-37 112q-22.5 56-54.5 117.5q-32 61.5-77 134.5q6 43 8 92.5q2 49.5 2 91.5z"], "δ": [531, "m268 12q-58 0-107.5-27.5q-49.5-27.5-79-80.5q-29.5-53-29.5-128q0-48 16.5-90q16.5-42 44-74.5q27.5-32.5 62-52q34.5-19.5 71.5-22.5l41 48q-46 4-81 31q-35 27-54.5 69q-19.5 42-19.5 89q0 53 18 91q18 38 49 58.5q31 20.5 71 20.5q43 0 72.5-21q29.5-21 45-59q15.5-38 15.5-89q0-56-18-94.5q-18-38.5-51.5-65.5q-33.5-27-81.5-49q-42-19-77-46q-35-27-56-60.5q-21-33.5-21-71.5q0-48 38.5-80q38.5-32 121.5-32q46 0 98.5 10.5q52.5 10.5 110.5 32.5l-20 62q-62-23-108.5-32q-46.5-9-81.5-9q-42 0-61 14.5q-19 14.5-19 38.5q0 32 37.5 65.5q37.5 33.5 100.5 65.5q55 27 93 60q38 33 57 78.5q19 45.5 19 112.5q0 70-26 123.5q-26 53.5-74.5 83.5q-48.5 30-115.5 30z"], "ε": [448, "m251 12q-60 0-106-17.5q-46-17.5-72-49.5q-26-32-26-75q0-54 30.5-85q30.5-31 71.5-41l0-4q-38-14-58-43.5q-20-29.5-20-64.5q0-44 25.5-72.5q25.5-28.5 67.5-43q42-14.5 91-14.5q45 0 85 14q40 14 73 40l-33 54q-28-21-58-32q-30-11-64-11q-45 0-75.5 18.5q-30.5 18.5-30.5 55.5q0 33 27 54q27 21 84 21q15 0 29-1.5q14-1.5 33-2.5l0 70q-20-2-37-2.5q-17-0.5-34-0.5q-63 0-94.5 20.5q-31.5 20.5-31.5 59.5q0 41 35 64q35 23 97 23q35 0 67-11.5q32-11.5 67-38.5l34 55q-44 34-84.5 47.5q-40.5 13.5-92.5 13.5z"], "ζ": [424, "m360 184l-66-27q26-32 37-50q11-18 11-38q0-15-9-25q-9-10-32.5-18.5q-23.5-8.5-69.5-17.5q-49-10-90.5-33.5q-41.5-23.5-67-70.5q-25.5-47-25.5-126q0-45 16-93q16-48 43-96q27-48 62-92q35-44 72.5-81.5q37.5-37.5 74.5-65.5q-27 0-70.5 0.5q-43.5 0.5-89 1.5q-45.5 1-77.5 3l0-67l330 0l0 67l-5 0q-37 26-75.5 63.5q-38.5 37.5-73.5 82q-35 44.5-62.5 92q-27.5 47.5-43.5 94q-16 46.5-16 87.5q0 57 17.5 91q17.5 34 50.5 51.5q33 17.5 78 25.5q70 14 103.5 36q33.5 22 33.5 72q0 22-13 57.5q-13 35.5-43 76.5z"], "η": [541, "m382 179q2-60 3-122q1-62 1.5-123.5q0.5-61.5 1-120q0.5-58.5 0.5-110.5q0-69-18-99.5q-18-30.5-61-30.5q-27 0-49.5 10.5q-22.5 10.5-45.5 34q-23 23.5-50 64.5l0 318l-82 0l0-353q0-29-1-62q-1-33-6-71l75 0l7 101l3 0q37-56 78.5-84.5q41.5-28.5 94.5-28.5q70 0 101 48.5q31 48.5 31 141.5l0 487z"], "θ": [522, "m261 12q-94 0-148-89.5q-54-89.5-54-281.5q0-119 24.5-200.5q24.5-81.5 70-123q45.5-41.5 107.5-41.5q62 0 107.5 41.5q45.5 41.5 70 123q24.5 81.5 24.5 200.5q0 192-54 281.5q-54 89.5-148 89.5zm0-68q35 0 62.5-28.5q27.5-28.5 43-95q15.5-66.5 15.5-179.5q0-79-9-135.5q-9-56.5-25.5-92.5q-16.5-36-38.5-52.5q-22-16.5-48-16.5q-26 0-48 16.5q-22 16.5-38.5 52.5q-16.5 36-25.5 92.5q-9 56.5-9 135.5q0 113 15.5 179.5q15.5 66.5 43 95q27.5 28.5 62.5 28.5zm-157-272l0-65l314 0l0 65z"], "ι": [262, "m175 9q-34 0-54-13q-20-13-29.5-38.5q-9.5-25.5-9.5-61.5l0-382l83 0q-1 66-2.5 133.5q-1.5 67.5-2.5 132q-1 64.5-1 122.5q0 21 9.5 30q9.5 9 24.5 9q7 0 14-1.5q7-1.5 16-4.5l11 63q-11 4-25 7.5q-14 3.5-34 3.5z"], "κ": [494, "m82 0l0-353q0-29-1.5-65q-1.5-36-7.5-68l81 0q5 19 7 50q2 31 2 63l0 152l4 0q38-66 85.5-124.5q47.5-58.5 100-99q52.5-40.5 103.5-53.5l8 78q-41 13-83 44q-42 31-87 80q-45 49-95 117q-22 29-30.5 67.5q-8.5 38.5-9.5 86.5l0 25zm324 8q-27-31-57-74q-30-43-58.5-90.5q-28.5-47.5-52.5-93.5l54-53q25 49 58.5 103.5q33.5 54.5 71.5 106.5q38 52 75 93z"], "λ": [494, "m103 8l-87-8l211-497l-6-21q-20-66-46.5-101q-26.5-35-68.5-35q-20 0-34.5 5q-14.5 5-28.5 11l-20-68q17-8 38.5-13q21.5-5 53.5-5q48 0 82 23.5q34 23.5 59.5 70.5q25.5 47 46.5 116l184 514l-87 0l-134-403l-4 0z"], "μ": [562, "m82 179l0-665l82 0l0 297q0 64 21 97q21 33 68 33q22 0 43-7q21-7 42.5-27.5q21.5-20.5 43.5-60.5l0-332l83 0q-1 66-2.5 133.5q-1.5 67.5-2.5 132q-1 64.5-1 122.5q0 21 10 30q10 9 26 9q7 0 14-1.5q7-1.5 15-4.5l11 63q-11 4-24.5 7.5q-13.5 3.5-33.5 3.5q-41 0-62-22q-21-22-26-69l-2 0q-27 46-61 69q-34 23-74 23q-29 0-53-9q-24-9-41-38q0 48 1 82q1 34 2 64.5q1 30.5 4 69.5z"], "ν": [474, "m193 0q-18-89-46-175.5q-28-86.5-63.5-163q-35.5-76.5-77.5-138.5l83-21q25 38 48.5 89q23.5 51 44.5 107.5q21 56.5 37 112q16 55.5 27 104.5l4 0q30-62 55.5-130q25.5-68 42.5-137q17-69 23-134l83 0q-13 84-36 163q-23 79-58.5 158q-35.5 79-85.5 165z"], "ξ": [431, "m367 184l-66-27q26-32 37-50q11-18 11-38q0-15-9-25.5q-9-10.5-33.5-18.5q-24.5-8-68.5-17q-51-11-94-31.5q-43-20.5-69-59q-26-38.5-26-102.5q0-48 20.5-87.5q20.5-39.5 54.5-67q34-27.5 75-39.5l0-4q-45-19-73.5-55.5q-28.5-36.5-28.5-88.5q0-42 19-74q19-32 53-49q-26 0-47 0.5q-21 0.5-42 1.5q-21 1-52 3l0-67l382 0l0 67l-108 0q-32 0-60 14q-28 14-45 41q-17 27-17 65q0 36 19.5 62.5q19.5 26.5 49 41.5q29.5 15 59.5 15q18 0 30-1q12-1 31-4l0 74q-19-4-35-4.5q-16-0.5-35-0.5q-41 0-79 17q-38 17-62 50.5q-24 33.5-24 80.5q0 46 20.5 73q20.5 27 55.5 41q35 14 80 22q48 9 77.5 21.5q29.5 12.5 43 33q13.5 20.5 13.5 53.5q0 22-13.5 57.5q-13.5 35.5-43.5 76.5z"], "ο": [535, "m267 12q-60 0-110.5-29.5q-50.5-29.5-80.5-86.5q-30-57-30-138q0-82 30-139q30-57 80.5-87q50.5-30 110.5-30q61 0 111.5 30q50.5 30 80.5 87q30 57 30 139q0 81-30 138q-30 57-80.5 86.5q-50.5 29.5-111.5 29.5zm0-68q65 0 101-51q36-51 36-135q0-57-16.5-99q-16.5-42-47-65.5q-30.5-23.5-73.5-23.5q-43 0-73.5 23.5q-30.5 23.5-46.5 65.5q-16 42-16 99q0 84 36 135q36 51 100 51z"], "π": [586, "m488 9q-39 0-63-14q-24-14-34.5-41q-10.5-27-10.5-67q0-19 0.5-53.5q0.5-34.5 1-78q0.5-43.5 1-88.5q0.5-45 1.5-85l-172 0q0 102-9 211.5q-9 109.5-20 211.5l-83-5q16-103 25.5-211.5q9.5-108.5 9.5-206.5l-113 0l0-63l70-5l469 0l0 68l-98 0q-1 41-2.5 88q-1.5 47-2 91.5q-0.5 44.5-1 79.5q-0.5 35-0.5 52q0 25 12 36.5q12 11.5 36 11.5q6 0 15-1.5q9-1.5 21-3.5l11 63q-12 4-28 7q-16 3-36 3z"], "ρ": [549, "m78 179l0-427q0-85 29-140q29-55 77.5-82.5q48.5-27.5 107.5-27.5q102 0 156 66.5q54 66.5 54 181.5q0 82-28.5 141q-28.5 59-74.5 90q-46 31-97 31q-39 0-76-15q-37-15-71-54q2 44 3 81.5q1 37.5 1.5 74.5q0.5 37 1.5 80zm209-236q36 0 66-23q30-23 47-66.5q17-43.5 17-103.5q0-53-13.5-93.5q-13.5-40.5-41.5-63q-28-22.5-73-22.5q-35 0-65.5 20.5q-30.5 20.5-48.5 60.5q-18 40-18 101l0 124q34 41 66.5 53.5q32.5 12.5 63.5 12.5z"], "ς": [432, "m316 180l-66-26q26-33 39.5-55q13.5-22 13.5-44q0-26-14-43q-14-17-57-30q-34-11-67.5-28.5q-33.5-17.5-60-44q-26.5-26.5-42.5-66.5q-16-40-16-97q0-78 30-132.5q30-54.5 79.5-83q49.5-28.5 107.5-28.5q49 0 82 17q33 17 58 40l-42 54q-21-19-42.5-31q-21.5-12-50.5-12q-40 0-71 22q-31 22-48.5 61.5q-17.5 39.5-17.5 92.5q0 54 19 86.5q19 32.5 50.5 51q31.5 18.5 68.5 31.5q40 13 63.5 27.5q23.5 14.5 34 37q10.5 22.5 10.5 57.5q0 25-15 63.5q-15 38.5-46 79.5z"], "σ": [546, "m264 12q-59 0-108.5-29q-49.5-29-79.5-84.5q-30-55.5-30-136.5q0-85 31.5-140q31.5-55 82-81.5q50.5-26.5 108.5-26.5l266 0l0 70q-41-3-77-5q-36-2-77-3l0 4q45 25 70.5 74.5q25.5 49.5 25.5 118.5q0 75-28 128.5q-28 53.5-76.5 82q-48.5 28.5-107.5 28.5zm1-68q38 0 67.5-22q29.5-22 46.5-61.5q17-39.5 17-94.5q0-49-15.5-91q-15.5-42-44.5-67.5q-29-25.5-70-25.5q-39 0-69.5 20q-30.5 20-48 60q-17.5 40-17.5 100q0 56 17.5 96.5q17.5 40.5 47.5 63q30 22.5 69 22.5z"], "τ": [458, "m288 9q-37 0-59-14q-22-14-31.5-41q-9.5-27-9.5-67l0-306l-164 0l0-62l70-5l340 0l0 67l-165 0q-2 82-3 160.5q-1 78.5-1 151.5q0 25 10.5 36.5q10.5 11.5 30.5 11.5q12 0 23.5-2.5q11.5-2.5 24.5-5.5l12 64q-15 4-35.5 8q-20.5 4-42.5 4z"], "υ": [510, "m249 12q-58 0-99.5-21.5q-41.5-21.5-63.5-64.5q-22-43-22-106q0-44 2-87q2-43 2-86q0-29-1-62q-1-33-7-71l80 0q5 25 6.5 53q1.5 28 1.5 60q0 41-3 96.5q-3 55.5-3 100.5q0 44 15 70q15 26 39.5 38q24.5 12 53.5 12q35 0 62.5-20q27.5-20 43.5-60.5q16-40.5 16-103.5q0-56-8.5-114q-8.5-58-31.5-125l80-19q22 63 32.5 126.5q10.5 63.5 10.5 128.5q0 82-26 139q-26 57-72.5 86.5q-46.5 29.5-107.5 29.5z"], "φ": [680, "m302 179l0-821l76 0l0 821zm10-170q-69 0-130-29.5q-61-29.5-98.5-86q-37.5-56.5-37.5-137.5q0-81 37.5-137q37.5-56 98.5-85q61-29 130-29l-4 63q-48 1-88.5 23q-40.5 22-64.5 64.5q-24 42.5-24 100.5q0 59 24 101.5q24 42.5 64.5 65q40.5 22.5 88.5 23.5zm57 0l3-63q49-1 89.5-23.5q40.5-22.5 64-65q23.5-42.5 23.5-101.5q0-58-22.5-100.5q-22.5-42.5-62.5-64.5q-40-22-92-23l-3-63q71 0 131.5 29q60.5 29 97 85q36.5 56 36.5 137q0 81-37 137.5q-37 56.5-98 86q-61 29.5-130 29.5z"], "χ": [481, "m92 191l-83-12l193-342l-190-314l82-21l147 260l4 0l125-248l87 0l-173 321l204 335l-80 21l-163-287l-4 0z"], "ψ": [689, "m310 12q-63 0-108.5-17q-45.5-17-75.5-48q-30-31-44-74q-14-43-14-96l0-130q0-29-1-62q-1-33-6-71l80 0q4 25 5 53q1 28 1 60q0 27-0.5 57q-0.5 30-1 56.5q-0.5 26.5-0.5 41.5q0 49 18 86q18 37 53.5 57q35.5 20 90.5 20zm61 0l1-67q57 0 96.5-22.5q39.5-22.5 60-68.5q20.5-46 20.5-117q0-37-3.5-70q-3.5-33-12-68q-8.5-35-24.5-78l80-19q15 41 24.5 78q9.5 37 14.5 74q5 37 5 80q0 133-69 205.5q-69 72.5-193 72.5zm-67 167l0-821l77 0l0 821z"], "ω": [701, "m205 12q-45 0-79.5-28q-34.5-28-54.5-80.5q-20-52.5-20-127.5q0-47 11.5-95.5q11.5-48.5 31-94.5q19.5-46 44.5-84l75 33q-41 59-62 121q-21 62-21 128q0 74 24 117q24 43 65 43q23 0 44.5-16q21.5-16 35-52q13.5-36 13.5-96q0-19-1.5-36.5q-1.5-17.5-2.5-38q-1-20.5-4-43.5l90 0q-2 23-3.5 43.5q-1.5 20.5-3 38q-1.5 17.5-1.5 36.5q0 62 13.5 98q13.5 36 34.5 51q21 15 44 15q41 0 64.5-44q23.5-44 23.5-127q0-66-17-122.5q-17-56.5-59-117.5l75-31q40 58 62.5 125.5q22.5 67.5 22.5 144.5q0 76-18.5 129.5q-18.5 53.5-53.5 82q-35 28.5-85 28.5q-49 0-89-33.5q-40-33.5-52-101.5l-4 0q-13 68-51.5 101.5q-38.5 33.5-91.5 33.5z"], "ϑ": [522, "m256 12q-71 0-114.5-39.5q-43.5-39.5-62.5-126.5q-9-38-15-61q-6-23-17-43l75-17q9 14 15.5 37q6.5 23 13.5 58q15 68 43.5 96q28.5 28 67.5 28q25 0 46.5-13.5q21.5-13.5 38.5-47q17-33.5 26-93.5q9-60 9-152q0-108-15-172.5q-15-64.5-42-93q-27-28.5-65-28.5q-33 0-58.5 21.5q-25.5 21.5-40.5 56.5q-15 35-15 74q0 37 10 60.5q10 23.5 36 37.5q26 14 73.5 20q47.5 6 122.5 6l-1 64q-97 0-159-9.5q-62-9.5-97-31q-35-21.5-49-57q-14-35.5-14-86.5q0-58 25.5-109.5q25.5-51.5 68.5-83q43-31.5 96-31.5q101 0 153 91.5q52 91.5 52 270.5q0 105-14.5 176.5q-14.5 71.5-42 115q-27.5 43.5-65.5 63q-38 19.5-85 19.5z"], "ϕ": [680, "m302 179l0-821l76 0l0 821zm10-170q-69 0-130-29.5q-61-29.5-98.5-86q-37.5-56.5-37.5-137.5q0-81 37.5-137q37.5-56 98.5-85q61-29 130-29l-4 63q-48 1-88.5 23q-40.5 22-64.5 64.5q-24 42.5-24 100.5q0 59 24 101.5q24 42.5 64.5 65q40.5 22.5 88.5 23.5zm57 0l3-63q49-1 89.5-23.5q40.5-22.5 64-65q23.5-42.5 23.5-101.5q0-58-22.5-100.5q-22.5-42.5-62.5-64.5q-40-22-92-23l-3-63q71 0 131.5 29q60.5 29 97 85q36.5 56 36.5 137q0 81-37 137.5q-37 56.5-98 86q-61 29.5-130 29.5z"], "Ё": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71zm97-715q-20 0-34.5-14q-14.5-14-14.5-35q0-22 14.5-35.5q14.5-13.5 34.5-13.5q22 0 35.5 13.5q13.5 13.5 13.5 35.5q0 21-13.5 35q-13.5 14-35.5 14zm206 0q-21 0-35-14q-14-14-14-35q0-22 14-35.5q14-13.5 35-13.5q21 0 35 13.5q14 13.5 14 35.5q0 21-14 35q-14 14-35 14z"], "А": [544, "m3 0l222-656l94 0l222 656l-88 0l-115-367q-18-55-34-109.5q-16-54.5-32-111.5l-4 0q-15 57-31 111.5q-16 54.5-34 109.5l-116 367zm116-200l0-66l303 0l0 66z"], "Б": [580, "m90 0l0-656l405 0l0 70l-322 0l0 206l126 0q69 0 123.5 18q54.5 18 85.5 58q31 40 31 105q0 69-29 113q-29 44-82 65q-53 21-125 21zm83-66l116 0q84 0 126-31.5q42-31.5 42-99.5q0-63-43-91q-43-28-127-28l-114 0z"], "В": [588, "m90 0l0-656l195 0q66 0 117 16q51 16 79.5 51.5q28.5 35.5 28.5 92.5q0 51-24.5 89.5q-24.5 38.5-71.5 53.5l0 4q62 11 98 49.5q36 38.5 36 104.5q0 66-31.5 109q-31.5 43-87.5 64.5q-56 21.5-130 21.5zm83-377l97 0q84 0 121-29q37-29 37-79q0-58-39-81.5q-39-23.5-115-23.5l-101 0zm0 311l114 0q85 0 132-31.5q47-31.5 47-97.5q0-61-46-89.5q-46-28.5-133-28.5l-114 0z"], "Г": [498, "m90 0l0-656l378 0l0 71l-295 0l0 585z"], "Д": [638, "m108 0l0 188l-73 0l-9-209l0-50l586 0l0 50l-9 209l-73 0l0-188zm347-31l0-555l-177 0q-8 57-16 102.5q-8 45.5-17 90.5q-9 45-21 101q-15 72-30.5 121.5q-15.5 49.5-33 81q-17.5 31.5-37 47.5q-19.5 16-43.5 20l-24-49q14-5 28.5-27.5q14.5-22.5 31-72q16.5-49.5 34.5-136.5q14-65 24.5-117.5q10.5-52.5 19.5-107q9-54.5 19-124.5l326 0l0 625z"], "Е": [527, "m90 0l0-656l378 0l0 70l-295 0l0 206l249 0l0 71l-249 0l0 238l305 0l0 71z"], "Ж": [830, "m6 0l200-348l-69-157q-16-36-30-53q-14-17-26.5-22q-12.5-5-25.5-5q-5 0-10.5 1q-5.5 1-9.5 3l-15-79q8-3 17.5-4.5q9.5-1.5 18.5-1.5q30 0 55 9.5q25 9.5 47 35.5q22 26 43 75l71 167l103 0l0-277l80 0l0 277l103 0l71-167q21-49 43.5-75q22.5-26 47.5-35.5q25-9.5 54-9.5q10 0 19.5 1.5q9.5 1.5 16.5 4.5l-14 79q-4-2-9.5-3q-5.5-1-10.5-1q-14 0-26.5 5q-12.5 5-26.5 22q-14 17-29 53l-70 157l200 348l-92 0l-170-311l-107 0l0 311l-80 0l0-311l-107 0l-170 311z"], "З": [550, "m281 12q-76 0-134.5-21.5q-58.5-21.5-108.5-75.5l46-52q43 43 89.5 59.5q46.5 16.5 99.5 16.5q43 0 78.5-15.5q35.5-15.5 56-44q20.5-28.5 20.5-69.5q0-64-46-93.5q-46-29.5-131-29.5l-74 0l0-64l59 0q83 0 120.5-28.5q37.5-28.5 37.5-83.5q0-51-36-78.5q-36-27.5-92-27.5q-46 0-84.5 16.5q-38.5 16.5-69.5 43.5l-44-52q34-35 86.5-58q52.5-23 113.5-23q62 0 109 20q47 20 73.5 57q26.5 37 26.5 91q0 54-27 92q-27 38-71 56l0 4q36 7 65.5 28q29.5 21 47.5 54.5q18 33.5 18 79.5q0 63-31.5 107.5q-31.5 44.5-83.5 67.5q-52 23-114 23z"], "И": [658, "m90 0l0-656l82 0l0 339q0 52-3 106q-3 54-8 104l4 0l70-136l240-413l91 0l0 656l-83 0l0-343q0-53 4.5-105q4.5-52 7.5-101l-4 0l-70 135l-240 414z"], "Й": [656, "m90 0l0-656l82 0l0 339q0 52-3 106q-3 54-8 104l4 0l70-136l240-413l91 0l0 656l-83 0l0-343q0-53 4.5-105q4.5-52 7.5-101l-4 0l-70 135l-240 414zm242-710q-56 0-88-19q-32-19-46.5-49q-14.5-30-16.5-63l72 0q2 35 19.5 60q17.5 25 59.5 25q42 0 60-25q18-25 19-60l72 0q-2 33-16.5 63q-14.5 30-46.5 49q-32 19-88 19z"], "К": [579, "m90 0l0-656l83 0l0 277l115 0l84-167q26-50 48-76q22-26 45.5-35q23.5-9 51.5-9q11 0 21 1.5q10 1.5 17 4.5l-14 77q-5-2-10.5-2q-5.5 0-12.5 0q-14 0-25.5 5q-11.5 5-25 22q-13.5 17-31.5 53l-83 156l223 349l-93 0l-196-311l-114 0l0 311z"], "Л": [630, "m56 9q-15 0-28.5-2q-13.5-2-27.5-6l17-77q8 2 14.5 3.5q6.5 1.5 13.5 1.5q18 0 33-11q15-11 29.5-48.5q14.5-37.5 33.5-113.5q24-104 42.5-204q18.5-100 33.5-208l323 0l0 656l-83 0l0-586l-175 0q-11 90-27.5 176.5q-16.5 86.5-36.5 174.5q-22 99-44 152q-22 53-50 72.5q-28 19.5-68 19.5z"], "М": [727, "m90 0l0-656l105 0l124 351q12 33 22.5 66q10.5 33 21.5 70l4 0q11-37 21-70q10-33 21-66l124-351l104 0l0 656l-78 0l0-361q0-29 2-65q2-36 4.5-71.5q2.5-35.5 5.5-64.5l-4 0l-51 158l-123 339l-61 0l-123-339l-51-158l-4 0q3 29 5.5 64.5q2.5 35.5 4.5 71.5q2 36 2 65l0 361z"], "Н": [652, "m90 0l0-656l83 0l0 275l306 0l0-275l83 0l0 656l-83 0l0-309l-306 0l0 309z"], "О": [664, "m332 12q-82 0-145.5-42q-63.5-42-99-119q-35.5-77-35.5-182q0-105 35.5-180.5q35.5-75.5 99-116q63.5-40.5 145.5-40.5q83 0 146 40.5q63 40.5 99 116q36 75.5 36 180.5q0 105-36 182q-36 77-99 119q-63 42-146 42zm0-74q59 0 102.5-33q43.5-33 67.5-93.5q24-60.5 24-142.5q0-81-24-140q-24-59-67.5-91.5q-43.5-32.5-102.5-32.5q-58 0-102 32.5q-44 32.5-68 91.5q-24 59-24 140q0 82 24 142.5q24 60.5 68 93.5q44 33 102 33z"], "П": [645, "m90 0l0-656l465 0l0 656l-83 0l0-586l-299 0l0 586z"], "Р": [566, "m90 0l0-656l187 0q74 0 129 18.5q55 18.5 86 60.5q31 42 31 114q0 69-30.5 113.5q-30.5 44.5-85 67q-54.5 22.5-126.5 22.5l-108 0l0 260zm83-328l98 0q86 0 127.5-33q41.5-33 41.5-102q0-71-43.5-98.5q-43.5-27.5-129.5-27.5l-94 0z"], "С": [571, "m339 12q-82 0-147.5-40.5q-65.5-40.5-102.5-116.5q-37-76-37-183q0-79 21.5-142q21.5-63 61.5-107.5q40-44.5 92.5-67.5q52.5-23 115.5-23q59 0 105.5 24q46.5 24 74.5 57l-45 51q-26-28-59.5-43.5q-33.5-15.5-74.5-15.5q-61 0-107.5 32.5q-46.5 32.5-72.5 92q-26 59.5-26 140.5q0 83 25 143q25 60 72 92.5q47 32.5 110 32.5q46 0 82.5-17.5q36.5-17.5 66.5-51.5l44 49q-39 45-87 69.5q-48 24.5-112 24.5z"], "Т": [536, "m226 0l0-585l-198 0l0-71l480 0l0 71l-198 0l0 585z"], "У": [514, "m136 12q-22 0-36.5-2.5q-14.5-2.5-28.5-7.5l17-75q9 3 18.5 5q9.5 2 23.5 2q32 0 52-13q20-13 33-40l14-35l-224-502l89 0l122 292l50 129l4 0l46-129l113-292l85 0l-215 537q-25 60-63 95.5q-38 35.5-100 35.5z"], "Ф": [732, "m346-82q-94 0-161-29q-67-29-102.5-84.5q-35.5-55.5-35.5-135.5q0-79 35.5-133.5q35.5-54.5 102.5-82.5q67-28 161-28l40 0q94 0 160.5 28q66.5 28 102.5 82.5q36 54.5 36 133.5q0 80-36 135.5q-36 55.5-102.5 84.5q-66.5 29-160.5 29zm-5-64l50 0q104 0 159-49q55-49 55-136q0-87-55-133.5q-55-46.5-159-46.5l-50 0q-103 0-158.5 46.5q-55.5 46.5-55.5 133.5q0 87 55.5 136q55.5 49 158.5 49zm-12 158l0-680l74 0l0 680z"], "Х": [513, "m15 0l191-339l-178-317l92 0l89 168q13 22 24.5 44q11.5 22 26.5 51l4 0q14-29 24.5-51q10.5-22 22.5-44l87-168l88 0l-179 321l191 335l-92 0l-96-177q-13-24-26.5-49.5q-13.5-25.5-29.5-55.5l-4 0q-14 30-26.5 55.5q-12.5 25.5-25.5 49.5l-95 177z"], "Ц": [642, "m534 188l0-188l-444 0l0-656l83 0l0 585l287 0l0-585l83 0l0 585l73 0l0 50l-9 209z"], "Ч": [598, "m425 0l0-276q-25 4-55 8q-30 4-71 4q-75 0-127-20.5q-52-20.5-78.5-67.5q-26.5-47-26.5-126l0-178l82 0l0 178q0 55 18 86.5q18 31.5 53.5 45q35.5 13.5 86.5 13.5q39 0 68-3.5q29-3.5 50-7.5l0-312l83 0l0 656z"], "Ш": [877, "m90 0l0-656l82 0l0 585l226 0l0-585l81 0l0 585l227 0l0-585l82 0l0 656z"], "Щ": [880, "m773 188l0-188l-38 0l0-71l120 0l0 50l-9 209zm-683-188l0-656l82 0l0 585l226 0l0-585l81 0l0 585l227 0l0-585l82 0l0 656z"], "Ъ": [720, "m238 0l0-586l-210 0l0-70l294 0l0 269l108 0q70 0 125.5 19.5q55.5 19.5 88 60.5q32.5 41 32.5 105q0 70-29.5 115q-29.5 45-83.5 66q-54 21-127 21zm84-68l104 0q83 0 125.5-31.5q42.5-31.5 42.5-100.5q0-60-44.5-90q-44.5-30-130.5-30l-97 0z"], "Ы": [798, "m90 0l0-656l83 0l0 269l102 0q72 0 126.5 18.5q54.5 18.5 85 60q30.5 41.5 30.5 106.5q0 70-29.5 115q-29.5 45-84 66q-54.5 21-127.5 21zm83-68l93 0q83 0 126-31.5q43-31.5 43-100.5q0-62-43-91q-43-29-129-29l-90 0zm452 68l0-656l83 0l0 656z"], "Ь": [580, "m90 0l0-656l83 0l0 269l121 0q72 0 126.5 18.5q54.5 18.5 85 60q30.5 41.5 30.5 106.5q0 70-29.5 115q-29.5 45-84 66q-54.5 21-127.5 21zm83-68l111 0q84 0 127-31.5q43-31.5 43-100.5q0-62-43-91q-43-29-129-29l-109 0z"], "Э": [571, "m243 12q-67 0-118.5-25q-51.5-25-92.5-70l46-50q33 35 72.5 53.5q39.5 18.5 90.5 18.5q91 0 143-68.5q52-68.5 52-204.5q0-126-51-193.5q-51-67.5-145-67.5q-43 0-81 15.5q-38 15.5-66 44.5l-43-52q32-34 82-57.5q50-23.5 111-23.5q83 0 145 38.5q62 38.5 96.5 114.5q34.5 76 34.5 187q0 112-35.5 187.5q-35.5 75.5-98 114q-62.5 38.5-142.5 38.5zm-83-321l0-71l319 0l0 71z"], "Ю": [908, "m90 0l0-656l83 0l0 275l192 0l0 72l-192 0l0 309zm496 12q-80 0-140-42q-60-42-93.5-118.5q-33.5-76.5-33.5-182.5q0-105 33.5-180.5q33.5-75.5 93.5-116q60-40.5 140-40.5q81 0 142 40.5q61 40.5 94.5 116q33.5 75.5 33.5 180.5q0 106-33.5 182.5q-33.5 76.5-94.5 118.5q-61 42-142 42zm0-73q57 0 98.5-33.5q41.5-33.5 63.5-94q22-60.5 22-142.5q0-81-22-140.5q-22-59.5-63.5-91.5q-41.5-32-98.5-32q-56 0-97.5 32q-41.5 32-63.5 91.5q-22 59.5-22 140.5q0 82 22 142.5q22 60.5 63.5 94q41.5 33.5 97.5 33.5z"], "Я": [582, "m409 0l0-277l-135 0q-60-2-109.5-23.5q-49.5-21.5-78.5-63.5q-29-42-29-108q0-68 29.5-108.5q29.5-40.5 81.5-58q52-17.5 119-17.5l205 0l0 656zm-110-345l110 0l0-244l-110 0q-77 0-118 26.5q-41 26.5-41 90.5q0 64 41 95.5q41 31.5 118 31.5zm-277 345l215-336l65 36l-184 300z"], "а": [504, "m194 12q-40 0-72.5-16.5q-32.5-16.5-51.5-47q-19-30.5-19-74.5q0-82 72-124q72-42 228-59q-1-30-9.5-58q-8.5-28-30.5-45q-22-17-61-17q-42 0-79 15.5q-37 15.5-66 34.5l-32-56q22-15 52-29.5q30-14.5 65-24q35-9.5 74-9.5q59 0 96.5 24.5q37.5 24.5 55 69.5q17.5 45 17.5 106l0 298l-68 0l-7-58l-3 0q-35 29-75 49.5q-40 20.5-86 20.5zm23-68q36 0 67.5-16q31.5-16 66.5-47l0-131q-82 10-129.5 25.5q-47.5 15.5-68.5 38.5q-21 23-21 55q0 40 25 57.5q25 17.5 60 17.5z"], "б": [544, "m282 12q-109 0-169-80q-60-80-60-227q0-98 14-166q14-68 40-111.5q26-43.5 63.5-69q37.5-25.5 84.5-39q47-13.5 103-22.5q27-4 43.5-7.5q16.5-3.5 29.5-8q13-4.5 28-11.5l16 75q-19 12-44 19q-25 7-56 12q-54 8-94.5 17.5q-40.5 9.5-69 28.5q-28.5 19-45.5 54q-17 35-25.5 94.5q-8.5 59.5-8.5 150.5q0 105 38 164q38 59 112 59q37 0 66-23.5q29-23.5 46-65q17-41.5 17-96.5q0-50-15-87q-15-37-44.5-57q-29.5-20-71.5-20q-35 0-73 19q-38 19-76 71l-3-62q33-45 78.5-68q45.5-23 94.5-23q57 0 101.5 27q44.5 27 69 78q24.5 51 24.5 122q0 78-29 134.5q-29 56.5-77 87.5q-48 31-108 31z"], "в": [508, "m82 0l0-486l187 0q53 0 93.5 12q40.5 12 63 39.5q22.5 27.5 22.5 71.5q0 40-21.5 66.5q-21.5 26.5-59.5 37.5l0 4q28 5 51 19.5q23 14.5 37 38q14 23.5 14 57.5q0 49-24.5 80q-24.5 31-68 45.5q-43.5 14.5-99.5 14.5zm81-284l92 0q60 0 86-19.5q26-19.5 26-51.5q0-35-25-53.5q-25-18.5-81-18.5l-98 0zm0 225l105 0q61 0 90-22q29-22 29-63q0-36-31.5-56.5q-31.5-20.5-93.5-20.5l-99 0z"], "г": [411, "m82 0l0-486l303 0l0 67l-221 0l0 419z"], "д": [533, "m99 0l0 172l-71 0l-9-187l0-52l491 0l0 52l-8 187l-71 0l0-172zm258-25l0-394l-155 0l-19 164q-7 67-19.5 111.5q-12.5 44.5-29 70.5q-16.5 26-35 38q-18.5 12-37.5 16l-19-48q14-7 26-25q12-18 22.5-59q10.5-41 19.5-120l26-215l302 0l0 461z"], "е": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14z"], "ж": [688, "m13 0l148-255l-39-97q-16-40-32-52q-16-12-34-12q-5 0-8 0.5q-3 0.5-8 2.5l-15-77q12-6 29-6q39 0 69 21q30 21 55 81l44 108l85 0l0-200l74 0l0 200l85 0l45-108q25-60 55.5-81q30.5-21 68.5-21q16 0 28 6l-14 77q-4-2-7.5-2.5q-3.5-0.5-8.5-0.5q-18 0-34 12q-16 12-33 52l-39 97l149 255l-90 0l-117-219l-88 0l0 219l-74 0l0-219l-88 0l-117 219z"], "з": [456, "m220 12q-49 0-95-13q-46-13-88-49l36-53q34 27 69 38q35 11 72 11q33 0 60.5-10.5q27.5-10.5 44-30q16.5-19.5 16.5-46.5q0-40-32-60q-32-20-92-20l-68 0l0-63l56 0q59 0 87.5-20q28.5-20 28.5-55q0-37-28-55.5q-28-18.5-72-18.5q-42 0-72.5 11q-30.5 11-59.5 32l-35-54q35-25 76.5-39.5q41.5-14.5 94.5-14.5q48 0 88 14.5q40 14.5 64.5 43q24.5 28.5 24.5 72.5q0 36-21 65q-21 29-60 45l0 4q44 10 73 39q29 29 29 81q0 45-27.5 78q-27.5 33-72 50.5q-44.5 17.5-97.5 17.5z"], "и": [565, "m82 0l0-486l80 0l0 202q0 40-2 85q-2 45-6 97l4 0q14-27 31.5-57.5q17.5-30.5 31.5-52.5l172-274l90 0l0 486l-80 0l0-202q0-39 2-84.5q2-45.5 6-97.5l-4 0q-14 27-31 57.5q-17 30.5-32 53.5l-173 273z"], "й": [565, "m82 0l0-486l80 0l0 202q0 40-2 85q-2 45-6 97l4 0q14-27 31.5-57.5q17.5-30.5 31.5-52.5l172-274l90 0l0 486l-80 0l0-202q0-39 2-84.5q2-45.5 6-97.5l-4 0q-14 27-31 57.5q-17 30.5-32 53.5l-173 273zm203-572q-56 0-89.5-22q-33.5-22-49-57q-15.5-35-18.5-73l68 0q1 28 9.5 52q8.5 24 27.5 38q19 14 52 14q33 0 52-14q19-14 27.5-38q8.5-24 9.5-52l68 0q-2 38-18 73q-16 35-49.5 57q-33.5 22-89.5 22z"], "к": [495, "m82 0l0-486l82 0l0 200l102 0l48-108q20-43 39.5-64.5q19.5-21.5 41-29.5q21.5-8 48.5-8q16 0 29 6l-15 77q-4-2-7.5-2.5q-3.5-0.5-8.5-0.5q-19 0-35.5 11q-16.5 11-34.5 53l-42 96l157 256l-90 0l-127-219l-105 0l0 219z"], "л": [531, "m54 9q-13 0-23-2q-10-2-21-6l16-75q5 1 10.5 2.5q5.5 1.5 11.5 1.5q25 0 42-24.5q17-24.5 23-76.5q10-78 19-157q9-79 18-158l299 0l0 486l-83 0l0-419l-151 0q-8 67-15.5 134.5q-7.5 67.5-16.5 134.5q-10 79-42.5 119q-32.5 40-86.5 40z"], "м": [633, "m82 0l0-486l99 0l94 226q11 28 21.5 57q10.5 29 19.5 63l4 0q11-34 20.5-63q9.5-29 20.5-57l91-226l100 0l0 486l-76 0l0-218q0-23 1.5-52.5q1.5-29.5 3.5-60.5q2-31 4-57l-4 0q-10 31-21.5 62q-11.5 31-22.5 59l-89 221l-62 0l-91-221q-10-28-21.5-59q-11.5-31-22.5-62l-4 0q2 26 4.5 57q2.5 31 3.5 60.5q1 29.5 1 52.5l0 218z"], "н": [562, "m82 0l0-486l82 0l0 197l234 0l0-197l82 0l0 486l-82 0l0-216l-234 0l0 216z"], "о": [542, "m271 12q-59 0-110.5-30q-51.5-30-83-87q-31.5-57-31.5-137q0-82 31.5-139q31.5-57 83-87q51.5-30 110.5-30q60 0 111 30q51 30 82.5 87q31.5 57 31.5 139q0 80-31.5 137q-31.5 57-82.5 87q-51 30-111 30zm0-68q42 0 74-23.5q32-23.5 49-65.5q17-42 17-97q0-56-17-98.5q-17-42.5-49-66q-32-23.5-74-23.5q-42 0-73.5 23.5q-31.5 23.5-49 66q-17.5 42.5-17.5 98.5q0 55 17.5 97q17.5 42 49 65.5q31.5 23.5 73.5 23.5z"], "п": [553, "m82 0l0-486l389 0l0 486l-82 0l0-419l-225 0l0 419z"], "р": [555, "m82 205l0-691l68 0l7 56l3 0q33-28 73-48q40-20 82-20q62 0 105 30.5q43 30.5 65 86q22 55.5 22 131.5q0 82-29.5 141q-29.5 59-77.5 90q-48 31-103 31q-33 0-67-15q-34-15-68-41l2 85l0 164zm201-262q40 0 71.5-23q31.5-23 49.5-66.5q18-43.5 18-103.5q0-53-13-93.5q-13-40.5-41-63q-28-22.5-74-22.5q-30 0-62 16.5q-32 16.5-68 49.5l0 255q34 28 64.5 39.5q30.5 11.5 54.5 11.5z"], "с": [456, "m275 12q-65 0-117-30q-52-30-82-87q-30-57-30-137q0-82 32.5-139q32.5-57 86-87q53.5-30 115.5-30q48 0 82.5 16q34.5 16 59.5 41l-41 51q-18-18-42.5-28.5q-24.5-10.5-55.5-10.5q-43 0-77.5 23.5q-34.5 23.5-54.5 65.5q-20 42-20 98q0 55 19 97q19 42 53 65.5q34 23.5 79 23.5q34 0 63-13q29-13 50-33l36 50q-31 29-70 46.5q-39 17.5-86 17.5z"], "т": [460, "m189 0l0-419l-163 0l0-67l408 0l0 67l-163 0l0 419z"], "у": [467, "m90 209q-16 0-30.5-3q-14.5-3-26.5-7l18-64q9 3 18 4.5q9 1.5 17 1.5q42 0 68.5-29.5q26.5-29.5 41.5-74.5l11-36l-195-487l85 0l99 269q12 31 24 67q12 36 23 70l4 0q11-34 21.5-69.5q10.5-35.5 19.5-67.5l87-269l80 0l-183 526q-17 48-41 86.5q-24 38.5-58 60.5q-34 22-83 22z"], "ф": [734, "m327 205l0-156l2-73q-20 15-44.5 25.5q-24.5 10.5-53.5 10.5q-83 0-133.5-66.5q-50.5-66.5-50.5-187.5q0-79 25.5-136.5q25.5-57.5 67.5-88.5q42-31 91-31q29 0 52.5 10q23.5 10 45.5 25l-2-72l0-177l80 0l0 177l-2 74q23-17 50.5-27q27.5-10 54.5-10q57 0 96.5 30.5q39.5 30.5 60 86q20.5 55.5 20.5 131.5q0 82-25.5 141q-25.5 59-68 90q-42.5 31-92.5 31q-23 0-47.5-9.5q-24.5-9.5-48.5-25.5l2 72l0 156zm-78-262q22 0 40.5-7.5q18.5-7.5 39.5-27.5l0-304q-20-19-41.5-26q-21.5-7-42.5-7q-32 0-57.5 23.5q-25.5 23.5-40.5 65q-15 41.5-15 97.5q0 87 31 136.5q31 49.5 86 49.5zm238 0q34 0 60-23q26-23 40.5-66.5q14.5-43.5 14.5-103.5q0-53-11.5-93.5q-11.5-40.5-36-63q-24.5-22.5-64.5-22.5q-20 0-41 7q-21 7-44 27l0 305q23 19 44.5 26q21.5 7 37.5 7z"], "х": [446, "m14 0l159-254l-147-232l89 0l65 107q11 19 23.5 39.5q12.5 20.5 24.5 41.5l4 0q11-21 22-41.5q11-20.5 22-39.5l59-107l86 0l-147 241l158 245l-89 0l-71-113q-13-22-26.5-44q-13.5-22-26.5-43l-4 0q-13 21-25 42.5q-12 21.5-24 44.5l-66 113z"], "ц": [558, "m456 172l0-172l-374 0l0-486l82 0l0 419l218 0l0-419l82 0l0 419l71 0l0 52l-8 187z"], "ч": [512, "m348 0l0-194q-26 6-44 8q-18 2-51 2q-62 0-105-17q-43-17-66-54.5q-23-37.5-23-97.5l0-133l82 0l0 133q0 54 31 78q31 24 97 24q22 0 40-2.5q18-2.5 39-6.5l0-226l82 0l0 486z"], "ш": [749, "m82 0l0-486l82 0l0 419l171 0l0-419l79 0l0 419l172 0l0-419l81 0l0 486z"], "щ": [761, "m659 172l0-172l-38 0l0-67l117 0l0 52l-8 187zm-577-172l0-486l82 0l0 419l171 0l0-419l79 0l0 419l172 0l0-419l81 0l0 486z"], "ъ": [596, "m198 0l0-419l-172 0l0-67l254 0l0 179l81 0q58 0 101.5 16q43.5 16 67.5 49.5q24 33.5 24 86.5q0 54-24 88q-24 34-67.5 50.5q-43.5 16.5-101.5 16.5zm82-66l73 0q61 0 91-21.5q30-21.5 30-67.5q0-46-30-67q-30-21-91-21l-73 0z"], "ы": [674, "m82 0l0-486l82 0l0 179l69 0q57 0 101 16q44 16 68 49.5q24 33.5 24 86.5q0 54-24 88q-24 34-68 50.5q-44 16.5-101 16.5zm82-66l60 0q62 0 91.5-21.5q29.5-21.5 29.5-67.5q0-46-29.5-67q-29.5-21-91.5-21l-60 0zm346 66l0-486l82 0l0 486z"], "ь": [491, "m82 0l0-486l82 0l0 179l92 0q57 0 101 16q44 16 68 49.5q24 33.5 24 86.5q0 54-24 88q-24 34-68 50.5q-44 16.5-101 16.5zm82-66l83 0q62 0 91.5-21.5q29.5-21.5 29.5-67.5q0-46-29.5-67q-29.5-21-91.5-21l-83 0z"], "э": [456, "m184 12q-47 0-88.5-16.5q-41.5-16.5-71.5-46.5l35-50q23 21 52.5 34q29.5 13 64.5 13q70 0 111-47.5q41-47.5 41-140.5q0-96-40-143.5q-40-47.5-105-47.5q-36 0-62 12q-26 12-48 31l-39-49q26-24 63.5-41.5q37.5-17.5 90.5-17.5q61 0 111.5 27.5q50.5 27.5 80.5 84q30 56.5 30 144.5q0 84-29 140.5q-29 56.5-80.5 85q-51.5 28.5-116.5 28.5zm-68-233l0-65l255 0l0 65z"], "ю": [738, "m82 0l0-486l82 0l0 200l123 0l0 73l-123 0l0 213zm400 12q-61 0-109.5-30q-48.5-30-76.5-87.5q-28-57.5-28-136.5q0-81 28-138q28-57 76.5-87.5q48.5-30.5 109.5-30.5q58 0 106 30q48 30 76 87q28 57 28 139q0 80-28 137q-28 57-76 87q-48 30-106 30zm-4-68q40 0 69-23.5q29-23.5 44.5-65.5q15.5-42 15.5-97q0-56-15.5-98.5q-15.5-42.5-44.5-66q-29-23.5-69-23.5q-40 0-69.5 23.5q-29.5 23.5-46 66q-16.5 42.5-16.5 98.5q0 55 16.5 97q16.5 42 46 65.5q29.5 23.5 69.5 23.5z"], "я": [515, "m350 0l0-190l-91 0q-35 0-69-8.5q-34-8.5-61-27q-27-18.5-43.5-47.5q-16.5-29-16.5-69q0-54 25.5-85.5q25.5-31.5 68.5-45q43-13.5 97-13.5l172 0l0 486zm-76-254l76 0l0-168l-76 0q-57 0-89.5 19.5q-32.5 19.5-32.5 61.5q0 42 32.5 64.5q32.5 22.5 89.5 22.5zm-241 254l169-231l69 25l-144 206z"], "ё": [496, "m279 12q-65 0-118.5-30.5q-53.5-30.5-84.5-87q-31-56.5-31-137.5q0-79 32-136q32-57 82-88q50-31 106-31q62 0 105.5 28.5q43.5 28.5 65.5 79.5q22 51 22 120q0 13-0.5 25q-0.5 12-3.5 24l-350 0l0-65l280 0q0-70-30.5-107.5q-30.5-37.5-87.5-37.5q-33 0-65 18.5q-32 18.5-52.5 59.5q-20.5 41-20.5 109q0 62 21.5 104q21.5 42 58.5 63.5q37 21.5 81 21.5q35 0 65.5-10q30.5-10 55.5-27l30 54q-32 22-71.5 36q-39.5 14-89.5 14zm-111-599q-21 0-35.5-14.5q-14.5-14.5-14.5-35.5q0-21 14.5-35.5q14.5-14.5 35.5-14.5q21 0 35 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-35 14.5zm192 0q-21 0-35-14.5q-14-14.5-14-35.5q0-21 14-35.5q14-14.5 35-14.5q22 0 36 14.5q14 14.5 14 35.5q0 21-14 35.5q-14 14.5-36 14.5z"], "‐": [311, "m41-219l0-63l230 0l0 63z"], "‑": [311, "m41-219l0-63l230 0l0 63z"], "‒": [497, "m41-223l0-57l416 0l0 57z"], "–": [480, "m41-223l0-57l398 0l0 57z"], "—": [800, "m41-223l0-57l718 0l0 57z"], "―": [800, "m41-223l0-57l718 0l0 57z"], "‖": [391, "m92 250l0-1000l58 0l0 1000zm149 0l0-1000l58 0l0 1000z"], "‗": [500, "m12 126l0-55l476 0l0 55zm0 122l0-55l476 0l0 55z"], "‘": [249, "m120-435q-30 0-46.5-24q-16.5-24-16.5-67q0-59 27-103.5q27-44.5 79-73.5l24 39q-38 24-57 53q-19 29-19 72l12 66l-42-51q10-9 18.5-13q8.5-4 20.5-4q20 0 36.5 13q16.5 13 16.5 37q0 26-15 41q-15 15-38 15z"], "’": [249, "m86-431l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5z"], "‚": [249, "m86 145l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5z"], "‛": [249, "m163-431q-52-30-79-73.5q-27-43.5-27-103.5q0-44 16.5-67.5q16.5-23.5 46.5-23.5q23 0 38 15q15 15 15 41q0 24-16.5 37q-16.5 13-36.5 13q-12 0-20.5-4q-8.5-4-18.5-13l42-51l-12 66q0 43 19 72q19 29 57 54z"], "“": [426, "m120-435q-30 0-46.5-24q-16.5-24-16.5-67q0-59 27-103.5q27-44.5 79-73.5l24 39q-38 24-57 53q-19 29-19 72l12 66l-42-51q10-9 18.5-13q8.5-4 20.5-4q20 0 36.5 13q16.5 13 16.5 37q0 26-15 41q-15 15-38 15zm177 0q-30 0-46.5-24q-16.5-24-16.5-67q0-59 27-103.5q27-44.5 79-73.5l24 39q-38 24-57 53q-19 29-19 72l12 66l-42-51q10-9 18.5-13q8.5-4 20.5-4q20 0 36.5 13q16.5 13 16.5 37q0 26-15 41q-15 15-38 15z"], "”": [426, "m86-431l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5zm177 0l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5z"], "„": [426, "m86 145l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5zm177 0l-23-38q38-25 56.5-54q18.5-29 18.5-72l-11-66l41 51q-9 9-17.5 13q-8.5 4-20.5 4q-21 0-37-13q-16-13-16-37q0-26 15-41q15-15 38-15q30 0 46.5 23.5q16.5 23.5 16.5 67.5q0 60-27.5 103.5q-27.5 43.5-79.5 73.5z"], "†": [454, "m192 80l5-564l-143 5l0-70l143 5l-5-168l70 0l-5 168l143-5l0 70l-143-5l5 564z"], "‡": [454, "m192 80l5-168l-143 5l0-70l143 6l-5-169l5-169l-143 6l0-70l143 5l-5-168l70 0l-5 168l143-5l0 70l-143-6l5 169l-5 169l143-6l0 70l-143-5l5 168z"], "•": [304, "m152-143q-30 0-55.5-15q-25.5-15-41-42q-15.5-27-15.5-63q0-36 15.5-63q15.5-27 41-42.5q25.5-15.5 55.5-15.5q30 0 55.5 15.5q25.5 15.5 41 42.5q15.5 27 15.5 63q0 36-15.5 63q-15.5 27-41 42q-25.5 15-55.5 15z"], "‣": [304, "m34-117l0-291l3 0l260 144l0 3l-260 144z"], "…": [948, "m154 12q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5zm335 0q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5zm335 0q-24 0-42-17.5q-18-17.5-18-44.5q0-29 18-46.5q18-17.5 42-17.5q25 0 42 17.5q17 17.5 17 46.5q0 27-17 44.5q-17 17.5-42 17.5z"], "′": [249, "m131-449l-53-4l30-240l80 7l-17 89z"], "⁰": [367, "m184-383q-45 0-78.5-24.5q-33.5-24.5-52-71q-18.5-46.5-18.5-112.5q0-99 41-152.5q41-53.5 108-53.5q67 0 108 53.5q41 53.5 41 152.5q0 66-18.5 112.5q-18.5 46.5-52 71q-33.5 24.5-78.5 24.5zm0-51q39 0 62.5-39.5q23.5-39.5 23.5-117.5q0-79-23.5-117q-23.5-38-62.5-38q-38 0-62.5 38q-24.5 38-24.5 117q0 78 24.5 117.5q24.5 39.5 62.5 39.5z"], "ⁱ": [166, "m52-395l0-321l62 0l0 321zm32-383q-18 0-30-11.5q-12-11.5-12-27.5q0-18 12-29q12-11 30-11q18 0 30 11q12 11 12 28q0 17-12 28.5q-12 11.5-30 11.5z"], "⁴": [367, "m220-395l0-220l4-109l-4 0l-50 81l-61 98l227 0l0 46l-294 0l0-33l164-253l72 0l0 390z"], "⁵": [367, "m183-383q-51 0-87.5-22q-36.5-22-60.5-54l43-33q19 27 43.5 42.5q24.5 15.5 57.5 15.5q34 0 57-24.5q23-24.5 23-61.5q0-40-23.5-63q-23.5-23-58.5-23q-23 0-40.5 9q-17.5 9-33.5 23l-31-23l18-188l213 0l0 56l-160 0l-11 95q14-6 30-10.5q16-4.5 33-4.5q53 0 90.5 34q37.5 34 37.5 97q0 40-18.5 70.5q-18.5 30.5-50 47.5q-31.5 17-71.5 17z"], "⁶": [367, "m196-383q-69 0-110-52.5q-41-52.5-41-144.5q0-73 22.5-121.5q22.5-48.5 61-72q38.5-23.5 86.5-23.5q34 0 56.5 9q22.5 9 38.5 21l-26 45q-14-10-30.5-17q-16.5-7-36.5-7q-32 0-57 18.5q-25 18.5-40 57q-15 38.5-15 96.5q0 70 25.5 105q25.5 35 64.5 35q32 0 51.5-22.5q19.5-22.5 19.5-57.5q0-35-18.5-57q-18.5-22-56.5-22q-23 0-44.5 10.5q-21.5 10.5-46.5 38.5l-2-48q23-24 49.5-36q26.5-12 56.5-12q58 0 90 34.5q32 34.5 32 90.5q0 37-17 67q-17 30-46.5 47.5q-29.5 17.5-66.5 17.5z"], "⁷": [367, "m131-395q4-67 17.5-122.5q13.5-55.5 38-107q24.5-51.5 64.5-105.5l-201 0l0-55l273 0l0 36q-47 60-72.5 115.5q-25.5 55.5-37 113q-11.5 57.5-15.5 125.5z"], "⁸": [367, "m182-383q-61 0-99-32.5q-38-32.5-38-76.5q0-37 22.5-65q22.5-28 51.5-44l0-4q-25-17-41.5-37.5q-16.5-20.5-16.5-51.5q0-47 35.5-75q35.5-28 85.5-28q53 0 89 28q36 28 36 75q0 23-9.5 40.5q-9.5 17.5-23 31q-13.5 13.5-27.5 22.5l0 4q34 17 53.5 41q19.5 24 19.5 60q0 47-39 79.5q-39 32.5-99 32.5zm23-235q42-33 42-74q0-26-19-41q-19-15-46-15q-26 0-44 15.5q-18 15.5-18 39.5q0 30 25 46.5q25 16.5 60 28.5zm-23 188q33 0 55.5-20q22.5-20 22.5-47q0-24-14-38q-14-14-37.5-23.5q-23.5-9.5-49.5-20.5q-54 32-54 81q0 26 21 47q21 21 56 21z"], "⁹": [367, "m150-383q-34 0-56-9q-22-9-40-21l27-45q14 10 30.5 17q16.5 7 36.5 7q32 0 57-18.5q25-18.5 40-57q15-38.5 15-96.5q0-70-25-105q-25-35-66-35q-30 0-50.5 22.5q-20.5 22.5-20.5 57.5q0 35 19.5 57q19.5 22 55.5 22q24 0 46-11q22-11 46-38l1 48q-21 23-48 35.5q-27 12.5-57 12.5q-58 0-90-34.5q-32-34.5-32-90.5q0-37 17-67q17-30 46.5-47.5q29.5-17.5 65.5-17.5q70 0 111 52q41 52 41 145q0 73-22.5 121.5q-22.5 48.5-61 72q-38.5 23.5-86.5 23.5z"], "⁺": [367, "m155-430l0-137l-125 0l0-53l125 0l0-136l56 0l0 136l126 0l0 53l-126 0l0 137z"], "⁻": [367, "m30-567l0-53l307 0l0 53z"], "⁼": [367, "m30-651l0-53l307 0l0 53zm0 168l0-53l307 0l0 53z"], "⁽": [237, "m153-316q-29-41-48.5-82.5q-19.5-41.5-29.5-88q-10-46.5-10-103.5q0-56 10-102.5q10-46.5 29.5-87.5q19.5-41 48.5-82l45 22q-38 59-54.5 121.5q-16.5 62.5-16.5 128.5q0 67 16.5 129.5q16.5 62.5 54.5 122.5z"], "⁾": [237, "m86-316l-47-22q38-60 54.5-122.5q16.5-62.5 16.5-129.5q0-66-16.5-128.5q-16.5-62.5-54.5-121.5l47-22q27 41 46.5 82q19.5 41 29.5 87.5q10 46.5 10 102.5q0 57-10 103.5q-10 46.5-29.5 88q-19.5 41.5-46.5 82.5z"], "ⁿ": [369, "m52-395l0-321l49 0l6 45l4 0q22-22 49-37.5q27-15.5 59-15.5q56 0 79 35q23 35 23 91l0 203l-62 0l0-194q0-38-11.5-60q-11.5-22-48.5-22q-20 0-40.5 11.5q-20.5 11.5-44.5 35.5l0 229z"], "₀": [367, "m184 189q-45 0-78.5-24.5q-33.5-24.5-52-71q-18.5-46.5-18.5-112.5q0-99 41-152.5q41-53.5 108-53.5q67 0 108 53.5q41 53.5 41 152.5q0 66-18.5 112.5q-18.5 46.5-52 71q-33.5 24.5-78.5 24.5zm0-51q39 0 62.5-39.5q23.5-39.5 23.5-117.5q0-79-23.5-117q-23.5-38-62.5-38q-38 0-62.5 38q-24.5 38-24.5 117q0 78 24.5 117.5q24.5 39.5 62.5 39.5z"], "₁": [367, "m172 177l0-308l-85 0l0-42q33-6 55-15.5q22-9.5 42-24.5l52 0l0 390z"], "₂": [367, "m52 177l0-37q61-54 102-94.5q41-40.5 62-73q21-32.5 21-61.5q0-38-20-60q-20-22-55-22q-25 0-46 16q-21 16-38 41l-38-35q23-34 57-55q34-21 73-21q59 0 94.5 32q35.5 32 35.5 94q0 38-19 72.5q-19 34.5-51.5 70.5q-32.5 36-74.5 78l165 0l0 55z"], "₃": [367, "m180 189q-47 0-84.5-22q-37.5-22-60.5-54l43-33q18 27 43.5 42.5q25.5 15.5 55.5 15.5q32 0 55-18q23-18 23-52q0-34-32-51.5q-32-17.5-89-17.5l0-41q50 0 78-20.5q28-20.5 28-49.5q0-29-19-45.5q-19-16.5-52-16.5q-22 0-42 13.5q-20 13.5-37 33.5l-39-34q26-29 56.5-46.5q30.5-17.5 71.5-17.5q33 0 62 12.5q29 12.5 45.5 36q16.5 23.5 16.5 56.5q0 34-19 58q-19 24-49 38q33 8 58.5 32.5q25.5 24.5 25.5 63.5q0 36-19 62.5q-19 26.5-50.5 40.5q-31.5 14-69.5 14z"], "₄": [367, "m220 177l0-220l4-109l-4 0l-50 81l-61 98l227 0l0 46l-294 0l0-33l164-253l72 0l0 390z"], "₅": [367, "m183 189q-51 0-87.5-22q-36.5-22-60.5-54l43-33q19 27 43.5 42.5q24.5 15.5 57.5 15.5q34 0 57-24.5q23-24.5 23-61.5q0-40-23.5-63q-23.5-23-58.5-23q-23 0-40.5 9q-17.5 9-33.5 23l-31-23l18-188l213 0l0 56l-160 0l-11 95q14-6 30-10.5q16-4.5 33-4.5q53 0 90.5 34q37.5 34 37.5 97q0 40-18.5 70.5q-18.5 30.5-50 47.5q-31.5 17-71.5 17z"], "₆": [367, "m196 189q-69 0-110-52.5q-41-52.5-41-144.5q0-73 22.5-121.5q22.5-48.5 61-72q38.5-23.5 86.5-23.5q34 0 56.5 9q22.5 9 38.5 21l-26 45q-14-10-30.5-17q-16.5-7-36.5-7q-32 0-57 18.5q-25 18.5-40 57q-15 38.5-15 96.5q0 70 25.5 105q25.5 35 64.5 35q32 0 51.5-22.5q19.5-22.5 19.5-57.5q0-35-18.5-57q-18.5-22-56.5-22q-23 0-44.5 10.5q-21.5 10.5-46.5 38.5l-2-48q23-24 49.5-36q26.5-12 56.5-12q58 0 90 34.5q32 34.5 32 90.5q0 37-17 67q-17 30-46.5 47.5q-29.5 17.5-66.5 17.5z"], "₇": [367, "m131 177q4-67 17.5-122.5q13.5-55.5 38-107q24.5-51.5 64.5-105.5l-201 0l0-55l273 0l0 36q-47 60-72.5 115.5q-25.5 55.5-37 113q-11.5 57.5-15.5 125.5z"], "₈": [367, "m182 189q-61 0-99-32.5q-38-32.5-38-76.5q0-37 22.5-65q22.5-28 51.5-44l0-4q-25-17-41.5-37.5q-16.5-20.5-16.5-51.5q0-47 35.5-75q35.5-28 85.5-28q53 0 89 28q36 28 36 75q0 23-9.5 40.5q-9.5 17.5-23 31q-13.5 13.5-27.5 22.5l0 4q34 17 53.5 41q19.5 24 19.5 60q0 47-39 79.5q-39 32.5-99 32.5zm23-235q42-33 42-74q0-26-19-41q-19-15-46-15q-26 0-44 15.5q-18 15.5-18 39.5q0 30 25 46.5q25 16.5 60 28.5zm-23 188q33 0 55.5-20q22.5-20 22.5-47q0-24-14-38q-14-14-37.5-23.5q-23.5-9.5-49.5-20.5q-54 32-54 81q0 26 21 47q21 21 56 21z"], "₉": [367, "m150 189q-34 0-56-9q-22-9-40-21l27-45q14 10 30.5 17q16.5 7 36.5 7q32 0 57-18.5q25-18.5 40-57q15-38.5 15-96.5q0-70-25-105q-25-35-66-35q-30 0-50.5 22.5q-20.5 22.5-20.5 57.5q0 35 19.5 57q19.5 22 55.5 22q24 0 46-11q22-11 46-38l1 48q-21 23-48 35.5q-27 12.5-57 12.5q-58 0-90-34.5q-32-34.5-32-90.5q0-37 17-67q17-30 46.5-47.5q29.5-17.5 65.5-17.5q70 0 111 52q41 52 41 145q0 73-22.5 121.5q-22.5 48.5-61 72q-38.5 23.5-86.5 23.5z"], "€": [497, "m323 12q-72 0-126.5-39.5q-54.5-39.5-85-113.5q-30.5-74-30.5-177q0-103 31.5-177.5q31.5-74.5 87-114.5q55.5-40 127.5-40q52 0 91 23q39 23 61 60l-45 38q-20-27-45-41q-25-14-59-14q-53 0-89.5 32q-36.5 32-56 91q-19.5 59-19.5 140q0 82 19 142q19 60 55.5 92.5q36.5 32.5 87.5 32.5q37 0 65-16.5q28-16.5 49-49.5l45 31q-26 47-66.5 74q-40.5 27-96.5 27zm-300-244l0-47l68-5l295 0l0 52zm0-120l0-47l69-5l334 0l0 52z"], "←": [619, "m299 15l-273-265l0-4l273-265l42 46l-201 187l439 0l0 68l-439 0l201 187z"], "↑": [619, "m275 25l0-439l-187 201l-46-42l265-272l4 0l266 272l-47 42l-187-201l0 439z"], "→": [619, "m319 15l-43-46l201-187l-438 0l0-68l438 0l-201-187l43-46l272 265l0 4z"], "↓": [619, "m307 25l-265-273l46-42l187 201l0-438l68 0l0 438l187-201l47 42l-266 273z"], "↔": [619, "m621-254l0 4l-178 213l-46-38l126-143l-427 0l126 143l-46 38l-179-213l0-4l179-213l46 38l-126 143l427 0l-126-143l46-38z"], "↕": [619, "m311 57l-4 0l-213-178l38-46l143 126l0-421l-143 126l-38-45l213-179l4 0l213 179l-38 45l-143-126l0 421l143-126l38 46z"], "∂": [528, "m222 12q-48 0-89.5-23q-41.5-23-67-66q-25.5-43-25.5-103q0-66 26-116.5q26-50.5 74.5-79q48.5-28.5 116.5-28.5q43 0 84 20.5q41 20.5 71 57.5l-10 66q-33-43-68.5-61q-35.5-18-69.5-18q-49 0-81.5 20q-32.5 20-48.5 55q-16 35-16 79q0 40 15.5 68.5q15.5 28.5 41 44.5q25.5 16 55.5 16q41 0 73-21.5q32-21.5 55.5-61.5q23.5-40 36-98q12.5-58 12.5-130q0-84-17-135q-17-51-48.5-74.5q-31.5-23.5-74.5-23.5q-31 0-60 13q-29 13-52 37l-38-51q32-32 72-49.5q40-17.5 86-17.5q65 0 112.5 32q47.5 32 73.5 98.5q26 66.5 26 168.5q0 114-33.5 200q-33.5 86-93 133.5q-59.5 47.5-138.5 47.5z"], "∆": [588, "m30 0l0-50l216-606l96 0l216 606l0 50zm90-71l346 0l-102-300l-69-210l-4 0l-69 210z"], "∏": [673, "m89 120l0-758l496 0l0 758l-85 0l0-685l-328 0l0 685z"], "∑": [504, "m22 120l0-53l238-326l-227-326l0-53l440 0l0 71l-337 0l0 4l212 303l-222 305l0 4l375 0l0 71z"], "−": [497, "m34-299l0-62l429 0l0 62z"], "√": [557, "m281 95l-150-428l-71 32l-19-45l133-59l116 346q5 16 9.5 32q4.5 16 7.5 32l4 0q3-16 6-32q3-16 6-32l178-761l60 0l-217 915z"], "∞": [782, "m570-147q-43 0-77-15q-34-15-64-42.5q-30-27.5-61-64.5l-4 0q-17 20-42 44q-25 24-57 41.5q-32 17.5-74 17.5q-41 0-75.5-21.5q-34.5-21.5-55-57.5q-20.5-36-20.5-79q0-53 21.5-91.5q21.5-38.5 58-59q36.5-20.5 83.5-20.5q41 0 72 16.5q31 16.5 55.5 40.5q24.5 24 42.5 48l4 0q24-32 52.5-59.5q28.5-27.5 64-44.5q35.5-17 77.5-17q50 0 88.5 22.5q38.5 22.5 60.5 62q22 39.5 22 90.5q0 57-22.5 99.5q-22.5 42.5-61.5 66q-39 23.5-88 23.5zm-371-82q41 0 75-27q34-27 59-65q-31-43-64.5-69q-33.5-26-71.5-26q-41 0-67 23.5q-26 23.5-26 65.5q0 42 27.5 70q27.5 28 67.5 28zm372 4q50 0 78-32q28-32 28-76q0-50-29.5-82q-29.5-32-84.5-32q-43 0-81 27.5q-38 27.5-75 79.5q42 55 80 85q38 30 84 30z"], "∫": [355, "m100 144q-16 0-28.5-2q-12.5-2-19.5-5l10-62q6 2 15 3q9 1 19 1q43 0 55-41.5q12-41.5 12-118.5q0-55-6.5-118q-6.5-63-14.5-128.5q-8-65.5-14.5-129q-6.5-63.5-6.5-118.5q0-65 11-116.5q11-51.5 41-81.5q30-30 87-30q15 0 28 2q13 2 19 4l-10 62q-6-2-15-3q-9-1-20-1q-40 0-52.5 42q-12.5 42-12.5 120q0 54 6 117q6 63 14 128q8 65 14.5 128.5q6.5 63.5 6.5 118.5q0 65-11 117q-11 52-40.5 82q-29.5 30-86.5 30z"], "≈": [497, "m336-364q-29 0-52.5-13q-23.5-13-44-29.5q-20.5-16.5-40-29q-19.5-12.5-40.5-12.5q-21 0-40.5 14q-19.5 14-36.5 47l-46-33q28-48 60.5-69q32.5-21 64.5-21q30 0 53 13q23 13 43.5 29.5q20.5 16.5 40 29q19.5 12.5 40.5 12.5q22 0 41-14.5q19-14.5 36-46.5l46 34q-27 47-59.5 68q-32.5 21-65.5 21zm0 214q-29 0-52.5-13q-23.5-13-44-29.5q-20.5-16.5-40-29q-19.5-12.5-40.5-12.5q-21 0-40.5 14q-19.5 14-36.5 47l-46-33q28-48 60.5-69q32.5-21 64.5-21q30 0 53 13q23 13 43.5 29.5q20.5 16.5 40 29q19.5 12.5 40.5 12.5q22 0 41-14.5q19-14.5 36-46.5l46 34q-27 47-59.5 68q-32.5 21-65.5 21z"], "≠": [497, "m61-65l76-127l-103 0l0-62l139 0l91-152l-230 0l0-62l266 0l76-127l60 0l-76 127l103 0l0 62l-139 0l-91 152l230 0l0 62l-266 0l-76 127z"], "≤": [497, "m463-153l-429-153l0-74l429-153l0 71l-210 73l-135 44l0 4l135 44l210 73zm-429 153l0-62l429 0l0 62z"], "≥": [497, "m34-153l0-71l210-73l135-44l0-4l-135-44l-210-73l0-71l429 153l0 74zm0 153l0-62l429 0l0 62z"] };
    bold = { "": [672, "m84 0l0-660l504 0l0 660zm146-75l210 0l-56-104l-46-100l-4 0l-47 100zm104-326l4 0l46-94l48-89l-193 0l49 89zm-168 268l111-207l-111-209zm339 0l0-416l-110 209z"], " ": [200, ""], "!": [315, "m119-215l-16-341l-3-114l116 0l-4 114l-16 341zm39 227q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], '"': [482, "m104-392l-22-183l-4-113l118 0l-3 113l-23 183zm207 0l-22-183l-4-113l118 0l-3 113l-23 183z"], "#": [513, "m84 0l24-190l-76 0l0-86l84 0l16-120l-80 0l0-86l90 0l22-168l80 0l-22 168l105 0l23-168l80 0l-23 168l79 0l0 86l-88 0l-16 120l84 0l0 86l-93 0l-23 190l-80 0l23-190l-105 0l-24 190zm112-276l106 0l16-120l-106 0z"], "$": [513, "m245 12q-56 0-109-21q-53-21-91-61l53-71q34 30 70.5 44.5q36.5 14.5 76.5 14.5q49 0 73-24q24-24 24-64q0-31-19.5-52q-19.5-21-51-39q-31.5-18-66-36.5q-34.5-18.5-65.5-41.5q-31-23-50.5-54q-19.5-31-19.5-76q0-54 24-94.5q24-40.5 67.5-62.5q43.5-22 101.5-22q61 0 104.5 22.5q43.5 22.5 75.5 59.5l-59 63q-24-25-52.5-38q-28.5-13-65.5-13q-39 0-62 21q-23 21-23 59q0 27 19.5 47q19.5 20 50.5 36.5q31 16.5 66 34.5q35 18 66 41q31 23 50.5 55.5q19.5 32.5 19.5 79.5q0 57-24.5 100q-24.5 43-71 67.5q-46.5 24.5-112.5 24.5zm-27 98l0-143l80 0l0 143zm0-720l0-136l80 0l0 136z"], "%": [841, "m186-252q-46 0-81-24.5q-35-24.5-55-71q-20-46.5-20-112.5q0-98 43.5-152q43.5-54 112.5-54q69 0 112.5 54q43.5 54 43.5 152q0 66-20 112.5q-20 46.5-55 71q-35 24.5-81 24.5zm0-67q32 0 52.5-33.5q20.5-33.5 20.5-107.5q0-74-20.5-106.5q-20.5-32.5-52.5-32.5q-31 0-52 32.5q-21 32.5-21 106.5q0 74 21 107.5q21 33.5 52 33.5zm21 331l357-678l70 0l-356 678zm448 0q-46 0-81-24.5q-35-24.5-55-71q-20-46.5-20-112.5q0-98 43.5-152q43.5-54 112.5-54q69 0 112.5 54q43.5 54 43.5 152q0 66-20 112.5q-20 46.5-55 71q-35 24.5-81 24.5zm0-67q32 0 52.5-33.5q20.5-33.5 20.5-107.5q0-74-20.5-106.5q-20.5-32.5-52.5-32.5q-31 0-52 32.5q-21 32.5-21 106.5q0 74 21 107.5q21 33.5 52 33.5z"], "&": [639, "m243 12q-64 0-112.5-22.5q-48.5-22.5-75.5-64q-27-41.5-27-97.5q0-51 22-88q22-37 56.5-65q34.5-28 73-50.5q38.5-22.5 73-44.5q34.5-22 56-47.5q21.5-25.5 21.5-58.5q0-26-12.5-44q-12.5-18-40.5-18q-30 0-49.5 23q-19.5 23-19.5 61q0 43 23 91q23 48 62 95q39 47 86.5 89.5q47.5 42.5 95.5 76.5q40 28 80 45q40 17 67 25l-29 94q-43-10-91-33q-48-23-96-57q-58-41-111-93q-53-52-94.5-110q-41.5-58-65.5-114.5q-24-56.5-24-107.5q0-45 20.5-82q20.5-37 57.5-59q37-22 87-22q67 0 105.5 38q38.5 38 38.5 101q0 43-20 76.5q-20 33.5-52 61q-32 27.5-68.5 51.5q-36.5 24-68.5 48q-32 24-52.5 51q-20.5 27-20.5 60q0 33 15.5 55.5q15.5 22.5 41 34.5q25.5 12 56.5 12q38 0 74.5-20q36.5-20 68.5-52q40-41 69.5-94.5q29.5-53.5 46.5-117.5l106 0q-20 72-55.5 139q-35.5 67-86.5 126q-43 48-98 78q-55 30-133 30z"], "'": [275, "m104-392l-22-183l-4-113l118 0l-3 113l-23 183z"], "(": [324, "m209 178q-62-102-97-213q-35-111-35-243q0-132 35-243q35-111 97-213l72 32q-57 95-83.5 204.5q-26.5 109.5-26.5 219.5q0 110 26.5 219q26.5 109 83.5 205z"], ")": [324, "m115 178l-72-32q57-96 83.5-205q26.5-109 26.5-219q0-110-26.5-219.5q-26.5-109.5-83.5-204.5l72-32q63 102 97.5 213q34.5 111 34.5 243q0 132-34.5 243q-34.5 111-97.5 213z"], "*": [438, "m143-384l-51-37l58-98l-102-45l19-60l109 25l11-113l63 0l11 113l110-25l19 60l-103 45l58 98l-51 37l-75-87z"], "+": [513, "m213-99l0-189l-179 0l0-84l179 0l0-189l87 0l0 189l179 0l0 84l-179 0l0 189z"], ",": [275, "m72 182l-25-63q49-19 75.5-52q26.5-33 25.5-72l-5-87l44 72q-10 9-22 13.5q-12 4.5-26 4.5q-29 0-51.5-18.5q-22.5-18.5-22.5-52.5q0-33 23-52q23-19 54-19q41 0 63.5 31q22.5 31 22.5 87q0 74-41 128.5q-41 54.5-115 79.5z"], "-": [322, "m42-210l0-84l238 0l0 84z"], ".": [275, "m138 12q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], "/": [344, "m12 160l233-870l78 0l-233 870z"], "0": [513, "m256 12q-99 0-157.5-85.5q-58.5-85.5-58.5-247.5q0-161 58.5-244q58.5-83 157.5-83q99 0 157.5 83q58.5 83 58.5 244q0 162-58.5 247.5q-58.5 85.5-157.5 85.5zm0-90q31 0 55-23q24-23 37.5-76.5q13.5-53.5 13.5-143.5q0-90-13.5-142q-13.5-52-37.5-73.5q-24-21.5-55-21.5q-30 0-54 21.5q-24 21.5-38 73.5q-14 52-14 142q0 90 14 143.5q14 53.5 38 76.5q24 23 54 23z"], "1": [513, "m74 0l0-94l142 0l0-418l-117 0l0-72q47-9 82-21.5q35-12.5 65-30.5l86 0l0 542l125 0l0 94z"], "2": [513, "m38 0l0-71q88-82 152.5-149.5q64.5-67.5 100-123q35.5-55.5 35.5-103.5q0-51-26.5-80.5q-26.5-29.5-78.5-29.5q-37 0-67.5 21q-30.5 21-56.5 50l-62-61q43-48 90-74.5q47-26.5 111-26.5q61 0 106 24q45 24 70 67.5q25 43.5 25 102.5q0 59-32.5 117q-32.5 58-87.5 118.5q-55 60.5-122 127.5q25-3 54.5-5q29.5-2 52.5-2l166 0l0 98z"], "3": [513, "m240 12q-51 0-91.5-12q-40.5-12-71.5-32.5q-31-20.5-53-45.5l55-74q29 29 66 49.5q37 20.5 85 20.5q52 0 84.5-25.5q32.5-25.5 32.5-70.5q0-33-16.5-57q-16.5-24-57-37.5q-40.5-13.5-113.5-13.5l0-84q63 0 99-13.5q36-13.5 51.5-36q15.5-22.5 15.5-52.5q0-40-25-62.5q-25-22.5-69-22.5q-37 0-68 16.5q-31 16.5-60 43.5l-59-71q41-36 88-58q47-22 103-22q61 0 107 19.5q46 19.5 72.5 57q26.5 37.5 26.5 91.5q0 53-29.5 89q-29.5 36-81.5 57l0 4q37 10 67 31q30 21 47.5 53q17.5 32 17.5 74q0 58-30.5 99.5q-30.5 41.5-81 63q-50.5 21.5-111.5 21.5z"], "4": [513, "m299 0l0-397q0-27 2-66q2-39 3-66l-4 0q-12 24-25 48.5q-13 24.5-27 50.5l-116 177l355 0l0 89l-469 0l0-78l252-394l137 0l0 636z"], "5": [513, "m241 12q-52 0-92-12q-40-12-71-32.5q-31-20.5-54-43.5l53-74q29 27 65 47.5q36 20.5 84 20.5q36 0 63.5-14.5q27.5-14.5 43.5-42q16-27.5 16-65.5q0-57-32.5-88q-32.5-31-84.5-31q-30 0-51.5 8.5q-21.5 8.5-50.5 27.5l-55-35l19-314l340 0l0 97l-240 0l-13 154q20-10 39.5-15.5q19.5-5.5 44.5-5.5q54 0 99.5 21.5q45.5 21.5 73 65.5q27.5 44 27.5 112q0 70-31.5 119q-31.5 49-82.5 74.5q-51 25.5-110 25.5z"], "6": [513, "m275 12q-47 0-88.5-18.5q-41.5-18.5-73.5-56.5q-32-38-50.5-97q-18.5-59-18.5-139q0-92 20.5-158.5q20.5-66.5 56-108.5q35.5-42 80-62q44.5-20 93.5-20q58 0 100 21q42 21 70 51l-62 70q-17-21-44.5-34.5q-27.5-13.5-56.5-13.5q-41 0-75.5 24q-34.5 24-54.5 80q-20 56-20 151q0 79 15.5 128q15.5 49 43 72q27.5 23 63.5 23q27 0 48.5-14q21.5-14 34-41q12.5-27 12.5-66q0-38-12-63q-12-25-34-37.5q-22-12.5-54-12.5q-28 0-59.5 17.5q-31.5 17.5-58.5 61.5l-4-81q27-39 67-60.5q40-21.5 76-21.5q55 0 97 21.5q42 21.5 65.5 65.5q23.5 44 23.5 110q0 64-27.5 111q-27.5 47-73 72.5q-45.5 25.5-99.5 25.5z"], "7": [513, "m160 0q5-85 16.5-155.5q11.5-70.5 33.5-134q22-63.5 55-124q33-60.5 81-125.5l-302 0l0-97l427 0l0 70q-57 70-93.5 133q-36.5 63-56.5 127.5q-20 64.5-29.5 138.5q-9.5 74-14.5 167z"], "8": [513, "m257 12q-62 0-111-22.5q-49-22.5-77-62q-28-39.5-28-90.5q0-40 16-70.5q16-30.5 42.5-53.5q26.5-23 56.5-39l0-4q-36-27-62-63q-26-36-26-86q0-51 25-89.5q25-38.5 68.5-59q43.5-20.5 98.5-20.5q86 0 136.5 47.5q50.5 47.5 50.5 124.5q0 31-12.5 59q-12.5 28-32 50q-19.5 22-40.5 37l0 4q29 16 54 38.5q25 22.5 40.5 53q15.5 30.5 15.5 73.5q0 49-27 88q-27 39-75 62q-48 23-113 23zm42-371q26-26 39.5-53q13.5-27 13.5-57q0-28-11-50q-11-22-32-34.5q-21-12.5-51-12.5q-37 0-62 23q-25 23-25 64q0 32 17.5 53.5q17.5 21.5 46.5 37q29 15.5 64 29.5zm-40 289q31 0 54.5-11.5q23.5-11.5 37-32.5q13.5-21 13.5-51q0-34-20.5-56.5q-20.5-22.5-55-39q-34.5-16.5-77.5-33.5q-29 21-49 51.5q-20 30.5-20 67.5q0 32 15.5 55.5q15.5 23.5 42 36.5q26.5 13 59.5 13z"], "9": [513, "m217 12q-57 0-99-21.5q-42-21.5-71-50.5l62-70q18 20 45.5 34q27.5 14 56.5 14q41 0 75-24q34-24 54.5-80q20.5-56 20.5-152q0-78-15.5-127.5q-15.5-49.5-43-72q-27.5-22.5-64.5-22.5q-26 0-47.5 14q-21.5 14-34.5 40.5q-13 26.5-13 65.5q0 38 12 63q12 25 34.5 38q22.5 13 54.5 13q28 0 59-18q31-18 58-61l5 81q-27 37-67.5 59q-40.5 22-76.5 22q-54 0-96-21.5q-42-21.5-65.5-65q-23.5-43.5-23.5-110.5q0-63 27.5-110q27.5-47 72.5-72.5q45-25.5 100-25.5q47 0 88.5 18.5q41.5 18.5 73 56.5q31.5 38 50 96.5q18.5 58.5 18.5 138.5q0 93-20.5 159.5q-20.5 66.5-55.5 108.5q-35 42-80 62q-45 20-94 20z"], ":": [275, "m138-330q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5zm0 342q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], ";": [275, "m138-330q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5zm-66 512l-25-63q49-19 75.5-52q26.5-33 25.5-72l-5-87l44 72q-10 9-22 13.5q-12 4.5-26 4.5q-29 0-51.5-18.5q-22.5-18.5-22.5-52.5q0-33 23-52q23-19 54-19q41 0 63.5 31q22.5 31 22.5 87q0 74-41 128.5q-41 54.5-115 79.5z"], "<": [513, "m479-117l-445-173l0-84l445-173l0 97l-193 68l-135 48l0 4l135 48l193 68z"], "=": [513, "m34-400l0-84l445 0l0 84zm0 224l0-84l445 0l0 84z"], ">": [513, "m34-117l0-97l193-68l135-48l0-4l-135-48l-193-68l0-97l445 173l0 84z"], "?": [444, "m157-215q-7-44 4.5-78.5q11.5-34.5 32-62.5q20.5-28 42.5-52.5q22-24.5 37-48.5q15-24 15-51q0-24-9.5-42q-9.5-18-27.5-28q-18-10-44-10q-30 0-55.5 14q-25.5 14-47.5 38l-64-59q33-38 78.5-62.5q45.5-24.5 102.5-24.5q52 0 92.5 18.5q40.5 18.5 63.5 55.5q23 37 23 92q0 38-15.5 68q-15.5 30-38.5 56q-23 26-44.5 52q-21.5 26-34.5 56q-13 30-9 69zm51 227q-31 0-52.5-22.5q-21.5-22.5-21.5-55.5q0-34 21.5-56q21.5-22 52.5-22q32 0 53.5 22q21.5 22 21.5 56q0 33-21.5 55.5q-21.5 22.5-53.5 22.5z"], "@": [875, "m416 164q-74 0-140-23q-66-23-117-69.5q-51-46.5-80-115.5q-29-69-29-160q0-103 34.5-186.5q34.5-83.5 94.5-143.5q60-60 138.5-92q78.5-32 166.5-32q105 0 181.5 43.5q76.5 43.5 118.5 121q42 77.5 42 179.5q0 68-19 119.5q-19 51.5-50 86q-31 34.5-69 51.5q-38 17-76 17q-43 0-73.5-20q-30.5-20-36.5-60l-2 0q-21 34-55 53q-34 19-67 19q-56 0-93-40q-37-40-37-110q0-44 15-86.5q15-42.5 42-78q27-35.5 64-56.5q37-21 81-21q26 0 45.5 12.5q19.5 12.5 32.5 39.5l2 0l13-42l73 0l-42 212q-10 52 2 75q12 23 46 23q29 0 55.5-23.5q26.5-23.5 43.5-66q17-42.5 17-100.5q0-54-15.5-101.5q-15.5-47.5-48-83.5q-32.5-36-82-56.5q-49.5-20.5-117.5-20.5q-63 0-122.5 25.5q-59.5 25.5-107 73.5q-47.5 48-75.5 115q-28 67-28 150q0 70 22 123.5q22 53.5 60.5 90q38.5 36.5 90 54.5q51.5 18 109.5 18q42 0 81.5-10q39.5-10 72.5-26l31 72q-46 24-93 37q-47 13-100 13zm-13-294q18 0 37.5-11.5q19.5-11.5 41.5-38.5l26-146q-10-17-24-24.5q-14-7.5-31-7.5q-33 0-57 24.5q-24 24.5-37 59.5q-13 35-13 69q0 39 15.5 57q15.5 18 41.5 18z"], "A": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91z"], "B": [597, "m83 0l0-654l209 0q68 0 120.5 15.5q52.5 15.5 83 50.5q30.5 35 30.5 95q0 50-23.5 88.5q-23.5 38.5-67.5 53.5l0 4q58 12 91.5 48.5q33.5 36.5 33.5 101.5q0 67-32.5 111q-32.5 44-89.5 65q-57 21-129 21zm116-384l83 0q68 0 99-25q31-25 31-67q0-48-32-68q-32-20-96-20l-85 0zm0 294l98 0q72 0 111-26.5q39-26.5 39-81.5q0-52-38-75.5q-38-23.5-112-23.5l-98 0z"], "C": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24z"], "D": [625, "m83 0l0-654l175 0q100 0 171 36q71 36 109 108q38 72 38 180q0 108-37.5 181.5q-37.5 73.5-107.5 111q-70 37.5-167 37.5zm116-94l51 0q66 0 112.5-25.5q46.5-25.5 70.5-77.5q24-52 24-133q0-80-24-131q-24-51-70.5-75q-46.5-24-112.5-24l-51 0z"], "E": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98z"], "F": [510, "m83 0l0-654l395 0l0 98l-279 0l0 185l238 0l0 98l-238 0l0 273z"], "G": [628, "m357 12q-88 0-158-39q-70-39-110-114.5q-40-75.5-40-183.5q0-80 23.5-143q23.5-63 66-107.5q42.5-44.5 98.5-67.5q56-23 121-23q70 0 119 25q49 25 79 58l-62 71q-24-24-55-38.5q-31-14.5-77-14.5q-58 0-102 28.5q-44 28.5-68 81.5q-24 53-24 127q0 74 23 128q23 54 67.5 82.5q44.5 28.5 109.5 28.5q28 0 53-7.5q25-7.5 41-21.5l0-141l-124 0l0-95l228 0l0 288q-33 33-87.5 55.5q-54.5 22.5-121.5 22.5z"], "H": [663, "m83 0l0-654l116 0l0 263l265 0l0-263l116 0l0 654l-116 0l0-290l-265 0l0 290z"], "I": [282, "m83 0l0-654l116 0l0 654z"], "J": [494, "m212 12q-64 0-110.5-27.5q-46.5-27.5-75.5-85.5l75-51q17 31 43.5 47q26.5 16 57.5 16q49 0 72.5-29q23.5-29 23.5-101l0-435l116 0l0 445q0 61-21 111q-21 50-65.5 80q-44.5 30-115.5 30z"], "K": [597, "m83 0l0-654l116 0l0 297l3 0l233-297l129 0l-201 255l235 399l-128 0l-177-308l-94 117l0 191z"], "L": [502, "m83 0l0-654l116 0l0 556l272 0l0 98z"], "M": [745, "m83 0l0-654l139 0l112 320q11 31 20 61.5q9 30.5 18 66.5l4 0q9-36 17.5-66.5q8.5-30.5 18.5-61.5l112-320l138 0l0 654l-107 0l0-298q0-31 2.5-71q2.5-40 6.5-79.5q4-39.5 8-69.5l-4 0l-52 166l-106 292l-78 0l-106-292l-50-166l-4 0q4 30 7.5 69.5q3.5 39.5 6 79.5q2.5 40 2.5 71l0 298z"], "N": [657, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286z"], "O": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5z"], "P": [582, "m83 0l0-654l206 0q73 0 130 19q57 19 90 63q33 44 33 120q0 72-32.5 119q-32.5 47-89 70q-56.5 23-127.5 23l-94 0l0 240zm116-333l85 0q73 0 108.5-30q35.5-30 35.5-89q0-62-37.5-85.5q-37.5-23.5-110.5-23.5l-81 0z"], "Q": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-105 36.5-180.5q36.5-75.5 101.5-115.5q65-40 150-40q85 0 150 40q65 40 102 115.5q37 75.5 37 180.5q0 106-37 182.5q-37 76.5-102 118q-65 41.5-150 41.5zm0-95q52 0 90-30q38-30 58.5-85q20.5-55 20.5-132q0-73-20.5-125.5q-20.5-52.5-58.5-81q-38-28.5-90-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 77 21 132q21 55 59 85q38 30 89 30zm208 257q-101 0-169-51q-68-51-98-127l119-10q13 32 37.5 53q24.5 21 56.5 30.5q32 9.5 67 9.5q22 0 39.5-2.5q17.5-2.5 31.5-6.5l21 84q-16 8-43.5 14q-27.5 6-61.5 6z"], "R": [592, "m83 0l0-654l221 0q68 0 122 18q54 18 86 60.5q32 42.5 32 115.5q0 70-32 115q-32 45-86 67q-54 22-122 22l-105 0l0 256zm116-348l93 0q67 0 102.5-28q35.5-28 35.5-84q0-56-35.5-78.5q-35.5-22.5-102.5-22.5l-93 0zm241 348l-158-287l84-69l204 356z"], "S": [545, "m274 12q-68 0-128.5-25q-60.5-25-107.5-71l63-76q35 34 81.5 52.5q46.5 18.5 93.5 18.5q56 0 85-23q29-23 29-61q0-27-13-43.5q-13-16.5-35.5-28.5q-22.5-12-52.5-24l-90-39q-32-14-62.5-36.5q-30.5-22.5-50-56q-19.5-33.5-19.5-81.5q0-52 28.5-93.5q28.5-41.5 78-66q49.5-24.5 113.5-24.5q59 0 111.5 21.5q52.5 21.5 89.5 58.5l-61 76q-32-26-67-40.5q-35-14.5-73-14.5q-46 0-74.5 20.5q-28.5 20.5-28.5 56.5q0 25 14.5 41.5q14.5 16.5 39 28q24.5 11.5 50.5 22.5l89 37q39 17 69 40q30 23 46.5 56q16.5 33 16.5 81q0 53-28 97q-28 44-80.5 70.5q-52.5 26.5-126.5 26.5z"], "T": [546, "m215 0l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556z"], "U": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16z"], "V": [536, "m196 0l-200-654l123 0l88 329q10 37 19 71.5q9 34.5 18.5 69q9.5 34.5 20.5 71.5l4 0q10-37 19-71.5q9-34.5 18.5-69q9.5-34.5 19.5-71.5l95-329l119 0l-207 654z"], "W": [800, "m144 0l-126-654l124 0l56 330q8 52 15 104.5q7 52.5 13 109.5l4 0q9-57 19-109.5q10-52.5 21-104.5l76-330l114 0l74 330q11 51 22 104q11 53 20 110l4 0q6-57 13.5-109.5q7.5-52.5 14.5-104.5l56-330l118 0l-126 654l-154 0l-74-344q-7-36-13.5-74.5q-6.5-38.5-12.5-83.5l-4 0q-4 45-10 83.5q-6 38.5-14 74.5l-76 344z"], "X": [541, "m13 0l186-337l-174-317l129 0l72 145q13 22 24 46q11 24 26 54l4 0q12-30 22.5-54q10.5-24 21.5-46l69-145l123 0l-174 322l186 332l-129 0l-80-154q-13-26-25.5-51.5q-12.5-25.5-27.5-55.5l-4 0q-12 30-24 55.5q-12 25.5-24 51.5l-78 154z"], "Y": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243z"], "Z": [540, "m40 0l0-70l316-486l-287 0l0-98l431 0l0 70l-317 486l319 0l0 98z"], "[": [324, "m90 152l0-860l196 0l0 63l-109 0l0 734l109 0l0 63z"], "\\": [344, "m255 160l-234-870l78 0l234 870z"], "]": [324, "m38 152l0-63l109 0l0-734l-109 0l0-63l196 0l0 860z"], "^": [513, "m55-279l153-391l96 0l154 391l-97 0l-55-151l-48-135l-4 0l-47 135l-55 151z"], "_": [500, "m12 133l0-69l476 0l0 69z"], "`": [549, "m266-570l-162-162l7-12l123 0l122 174z"], "a": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5z"], "b": [563, "m311 12q-33 0-67.5-16.5q-34.5-16.5-66.5-47.5l-3 0l-10 52l-91 0l0-706l115 0l0 182l-3 82q31-27 67.5-44q36.5-17 74.5-17q61 0 104.5 31q43.5 31 66.5 86.5q23 55.5 23 131.5q0 84-30 143.5q-30 59.5-77.5 91q-47.5 31.5-102.5 31.5zm-24-95q33 0 59-19q26-19 41-56.5q15-37.5 15-93.5q0-49-11-84q-11-35-34.5-53.5q-23.5-18.5-60.5-18.5q-27 0-53 13.5q-26 13.5-55 41.5l0 229q26 22 52 31.5q26 9.5 47 9.5z"], "c": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17z"], "d": [564, "m245 12q-92 0-147-68q-55-68-55-189q0-80 29.5-138q29.5-58 77-89q47.5-31 101.5-31q42 0 71.5 14q29.5 14 57.5 40l-4-79l0-178l115 0l0 706l-95 0l-8-53l-4 0q-27 27-63 46q-36 19-76 19zm28-95q29 0 54-13.5q25-13.5 49-41.5l0-229q-25-23-50-32q-25-9-50-9q-32 0-57.5 19q-25.5 19-41 55q-15.5 36-15.5 88q0 79 29 121q29 42 82 42z"], "e": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14z"], "f": [317, "m93 0l0-542q0-51 16.5-91q16.5-40 52.5-62.5q36-22.5 94-22.5q27 0 50.5 5q23.5 5 39.5 12l-24 83q-26-9-52-9q-30 0-46 20q-16 20-16 63l0 544zm-73-400l0-86l80-5l204 0l0 91z"], "g": [520, "m244 217q-59 0-105-14q-46-14-72.5-42.5q-26.5-28.5-26.5-71.5q0-31 18.5-57.5q18.5-26.5 51.5-47.5l0-4q-18-12-31-32q-13-20-13-50q0-28 16.5-52q16.5-24 37.5-39l0-4q-25-19-44.5-53q-19.5-34-19.5-77q0-56 27-95.5q27-39.5 71-60q44-20.5 96-20.5q20 0 39 3q19 3 33 9l176 0l0 85l-92 0l0 4q14 15 22 34.5q8 19.5 8 45.5q0 54-25 91q-25 37-67 56q-42 19-94 19q-16 0-33-3q-17-3-34-10q-10 10-17 20q-7 10-7 27q0 21 18 33q18 12 62 12l87 0q89 0 134.5 28.5q45.5 28.5 45.5 92.5q0 48-32 87.5q-32 39.5-91 62.5q-59 23-139 23zm6-445q23 0 42.5-11.5q19.5-11.5 31-34q11.5-22.5 11.5-53.5q0-47-24.5-72q-24.5-25-60.5-25q-36 0-61 25q-25 25-25 72q0 31 12 53.5q12 22.5 31 34q19 11.5 43 11.5zm12 370q39 0 69-10.5q30-10.5 47-29q17-18.5 17-39.5q0-29-22.5-39q-22.5-10-64.5-10l-67 0q-20 0-36-2q-16-2-31-5q-19 15-28.5 31q-9.5 16-9.5 34q0 33 34 51.5q34 18.5 92 18.5z"], "h": [558, "m73 0l0-706l115 0l0 182l-4 95q31-29 69-51.5q38-22.5 88-22.5q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343z"], "i": [262, "m73 0l0-491l115 0l0 491zm57-577q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "j": [263, "m34 206q-26 0-46-4q-20-4-34-10l22-85q10 3 21 5.5q11 2.5 21 2.5q33 0 44.5-22.5q11.5-22.5 11.5-65.5l0-518l116 0l0 516q0 52-15 93q-15 41-49 64.5q-34 23.5-92 23.5zm98-783q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "k": [522, "m73 0l0-706l114 0l0 440l3 0l180-225l127 0l-167 201l184 290l-125 0l-126-213l-76 87l0 126z"], "l": [271, "m185 10q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3z"], "m": [843, "m73 0l0-491l95 0l8 67l4 0q31-33 67.5-56q36.5-23 82.5-23q55 0 87 23q32 23 49 65q35-38 73-63q38-25 85-25q78 0 115 51q37 51 37 144l0 308l-116 0l0-293q0-61-18-86q-18-25-57-25q-24 0-49 15q-25 15-54 46l0 343l-115 0l0-293q0-61-18.5-86q-18.5-25-57.5-25q-46 0-103 61l0 343z"], "n": [560, "m73 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343z"], "o": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20z"], "p": [564, "m73 194l0-685l95 0l8 52l4 0q31-27 69-45.5q38-18.5 79-18.5q61 0 104 31q43 31 66 87q23 56 23 132q0 84-30 143q-30 59-77.5 90.5q-47.5 31.5-102.5 31.5q-32 0-64-14q-32-14-62-40l3 82l0 154zm214-277q33 0 59-19q26-19 41-56.5q15-37.5 15-93.5q0-49-11-84q-11-35-34.5-53.5q-23.5-18.5-60.5-18.5q-27 0-53 13.5q-26 13.5-55 41.5l0 229q27 22 52.5 31.5q25.5 9.5 46.5 9.5z"], "q": [564, "m376 194l0-161l4-82q-26 25-61.5 43q-35.5 18-73.5 18q-92 0-147-68q-55-68-55-189q0-80 29.5-138q29.5-58 77-89q47.5-31 101.5-31q42 0 73.5 14.5q31.5 14.5 62.5 44.5l3 0l10-47l91 0l0 685zm-103-277q29 0 54-13.5q25-13.5 49-41.5l0-229q-25-23-50-32q-25-9-50-9q-32 0-57.5 19q-25.5 19-41 55q-15.5 36-15.5 88q0 79 29 121q29 42 82 42z"], "r": [373, "m73 0l0-491l95 0l8 87l4 0q26-48 62.5-73.5q36.5-25.5 76.5-25.5q19 0 32 2q13 2 24 8l-23 98q-12-3-22-4.5q-10-1.5-26-1.5q-29 0-61 22.5q-32 22.5-55 78.5l0 300z"], "s": [431, "m210 12q-51 0-100.5-19q-49.5-19-85.5-53l51-66q33 27 67 39q34 12 72 12q40 0 59-17q19-17 19-42q0-20-14.5-34q-14.5-14-37.5-24q-23-10-51-20q-36-13-67-31.5q-31-18.5-50.5-46q-19.5-27.5-19.5-66.5q0-65 48-106q48-41 130-41q50 0 92 16.5q42 16.5 72 42.5l-51 65q-26-19-53-28q-27-9-57-9q-37 0-55 16q-18 16-18 38q0 18 11.5 30.5q11.5 12.5 33.5 22q22 9.5 53 19.5q38 13 71 31.5q33 18.5 52.5 47q19.5 28.5 19.5 71.5q0 42-22 76.5q-22 34.5-64.5 55q-42.5 20.5-104.5 20.5z"], "t": [361, "m246 10q-85 0-120.5-49.5q-35.5-49.5-35.5-128.5l0-232l-70 0l0-86l76-5l14-154l96 0l0 154l125 0l0 91l-125 0l0 232q0 43 17 64.5q17 21.5 52 21.5q13 0 26-2q13-2 25-8l21 81q-19 9-45 15q-26 6-56 6z"], "u": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23z"], "v": [495, "m183 0l-171-491l117 0l78 255q10 35 20.5 72.5q10.5 37.5 20.5 75.5l4 0q11-38 21.5-75.5q10.5-37.5 20.5-72.5l78-255l111 0l-167 491z"], "w": [748, "m154 0l-130-491l118 0l58 255q8 33 14 67.5q6 34.5 11 78.5l4 0q7-44 13.5-78.5q6.5-34.5 13.5-67.5l60-255l120 0l62 255q8 33 15 67.5q7 34.5 14 78.5l4 0q7-44 12.5-78.5q5.5-34.5 12.5-67.5l58-255l110 0l-125 491l-147 0l-50-228q-7-33-13.5-66.5q-6.5-33.5-12.5-81.5l-4 0q-6 48-12 81.5q-6 33.5-14 66.5l-50 228z"], "x": [481, "m14 0l156-256l-146-235l124 0l55 93q11 20 22 41q11 21 23 42l4 0q9-21 19-42q10-21 19-41l47-93l119 0l-145 248l156 243l-124 0l-60-97q-12-22-24.5-44q-12.5-22-25.5-43l-4 0q-11 21-22 42.5q-11 21.5-21 44.5l-52 97z"], "y": [495, "m106 202q-20 0-35.5-3q-15.5-3-28.5-9l22-86q10 3 18 4q8 1 16 1q39 0 62.5-24q23.5-24 35.5-60l9-31l-193-485l117 0l85 241q11 32 21.5 67.5q10.5 35.5 21.5 70.5l4 0q9-34 18.5-69.5q9.5-35.5 18.5-68.5l74-241l111 0l-178 513q-20 55-46 95.5q-26 40.5-63 62.5q-37 22-90 22z"], "z": [443, "m34 0l0-62l232-338l-206 0l0-91l350 0l0 61l-231 338l239 0l0 92z"], "{": [324, "m232 152q-63 0-93-29.5q-30-29.5-30-108.5q0-36 2.5-64.5q2.5-28.5 4.5-56.5q2-28 2-60q0-29-18-52.5q-18-23.5-68-23.5l0-70q34 0 52.5-11.5q18.5-11.5 26-28.5q7.5-17 7.5-35q0-33-2-61q-2-28-4.5-56.5q-2.5-28.5-2.5-64.5q0-80 30-109q30-29 93-29l54 0l0 63l-23 0q-36 0-48.5 17.5q-12.5 17.5-12.5 62.5q0 43 2.5 83q2.5 40 2.5 89q0 53-15.5 78.5q-15.5 25.5-51.5 34.5l0 4q36 9 51.5 34.5q15.5 25.5 15.5 78.5q0 48-2.5 88.5q-2.5 40.5-2.5 83.5q0 45 12.5 62.5q12.5 17.5 48.5 17.5l23 0l0 63z"], "|": [255, "m89 250l0-1000l77 0l0 1000z"], "}": [324, "m38 152l0-63l23 0q36 0 48.5-17.5q12.5-17.5 12.5-62.5q0-43-2.5-83.5q-2.5-40.5-2.5-88.5q0-53 16-78.5q16-25.5 51-34.5l0-4q-35-9-51-34.5q-16-25.5-16-78.5q0-49 2.5-89q2.5-40 2.5-83q0-45-12.5-62.5q-12.5-17.5-48.5-17.5l-23 0l0-63l54 0q63 0 93 29q30 29 30 109q0 36-2.5 64.5q-2.5 28.5-4.5 56.5q-2 28-2 61q0 18 7.5 35q7.5 17 26 28.5q18.5 11.5 52.5 11.5l0 70q-50 0-68 23.5q-18 23.5-18 52.5q0 32 2 60q2 28 4.5 56.5q2.5 28.5 2.5 64.5q0 79-30 108.5q-30 29.5-93 29.5z"], "~": [513, "m343-248q-30 0-53.5-12.5q-23.5-12.5-43.5-28q-20-15.5-38.5-27.5q-18.5-12-39.5-12q-20 0-39 14.5q-19 14.5-35 44.5l-62-46q33-52 68-74.5q35-22.5 70-22.5q31 0 54 12.5q23 12.5 43 28q20 15.5 38.5 27.5q18.5 12 39.5 12q21 0 39.5-14.5q18.5-14.5 34.5-44.5l61 47q-31 51-66.5 73.5q-35.5 22.5-70.5 22.5z"], " ": [200, ""], "¡": [315, "m100 179l3-114l16-341l77 0l16 341l4 114zm58-526q-31 0-53-22.5q-22-22.5-22-56.5q0-33 22-55q22-22 53-22q32 0 53 22q21 22 21 55q0 34-21 56.5q-21 22.5-53 22.5z"], "¢": [513, "m310-60q-74 0-130-29q-56-29-87.5-84.5q-31.5-55.5-31.5-134.5q0-80 34.5-135.5q34.5-55.5 93.5-84.5q59-29 130-29q47 0 83 16.5q36 16.5 61 41.5l-54 71q-19-17-39.5-26q-20.5-9-44.5-9q-48 0-82 19q-34 19-52 54q-18 35-18 82q0 70 39.5 112q39.5 42 109.5 42q30 0 56-12.5q26-12.5 45-29.5l48 73q-34 31-76.5 47q-42.5 16-84.5 16zm-41 97l0-691l66 0l0 691z"], "£": [513, "m51 0l0-71q48-24 77-68q29-44 29-98q0-37-11.5-73.5q-11.5-36.5-23-72.5q-11.5-36-11.5-71q0-60 25.5-103.5q25.5-43.5 70-67q44.5-23.5 103.5-23.5q57 0 97.5 22.5q40.5 22.5 67.5 58.5l-61 58q-18-23-40-34q-22-11-52-11q-47 0-73.5 28.5q-26.5 28.5-26.5 77.5q0 34 9 67.5q9 33.5 18.5 69q9.5 35.5 9.5 75.5q0 44-13 74.5q-13 30.5-40 59.5l0 4l270 0l0 98zm2-278l0-69l67-5l273 0l0 74z"], "¤": [513, "m82-93l-59-60l62-63q-16-23-25.5-51.5q-9.5-28.5-9.5-61.5q0-34 9.5-62.5q9.5-28.5 25.5-51.5l-62-63l59-60l68 70q49-31 106-31q58 0 106 31l69-70l59 60l-63 63q17 23 26 51.5q9 28.5 9 62.5q0 33-9.5 61.5q-9.5 28.5-25.5 51.5l63 63l-59 60l-69-70q-23 16-50.5 23.5q-27.5 7.5-55.5 7.5q-58 0-105-31zm174-121q29 0 52-14q23-14 36.5-40q13.5-26 13.5-61q0-35-13.5-61q-13.5-26-36.5-40.5q-23-14.5-52-14.5q-28 0-51 14.5q-23 14.5-37 40.5q-14 26-14 61q0 35 14 61q14 26 37 40q23 14 51 14z"], "¥": [513, "m198 0l0-144l-158 0l0-68l158 0l0-58l-158 0l0-68l132 0l-154-298l119 0l64 151q14 33 27 66q13 33 28 67l4 0q14-34 28-67q14-33 27-66l64-151l116 0l-155 298l132 0l0 68l-158 0l0 58l158 0l0 68l-158 0l0 144z"], "¦": [255, "m89-302l0-448l77 0l0 448zm0 552l0-459l77 0l0 459z"], "§": [513, "m238 74q-53 0-102-20q-49-20-82-58l68-60q25 25 53.5 38.5q28.5 13.5 62.5 13.5q35 0 53.5-16q18.5-16 18.5-40q0-24-19-40q-19-16-50-30q-31-14-65.5-29q-34.5-15-65-36q-30.5-21-50-53q-19.5-32-19.5-78q0-48 31.5-86q31.5-38 81.5-57l56 51q-33 14-51.5 34q-18.5 20-18.5 50q0 29 19.5 49q19.5 20 51 35.5q31.5 15.5 66.5 30.5q35 15 66.5 34.5q31.5 19.5 51.5 48q20 28.5 20 71.5q0 42-21.5 75.5q-21.5 33.5-61 52.5q-39.5 19-94.5 19zm125-213l-64-51q37-15 55.5-33.5q18.5-18.5 18.5-51.5q0-31-20-51.5q-20-20.5-52-36q-32-15.5-68-30.5q-36-15-67.5-34q-31.5-19-51.5-47.5q-20-28.5-20-70.5q0-40 19-72.5q19-32.5 56-51q37-18.5 89-18.5q53 0 96 18.5q43 18.5 72 42.5l-54 73q-23-20-50.5-33.5q-27.5-13.5-57.5-13.5q-34 0-50 14q-16 14-16 36q0 23 20 39q20 16 51 29.5q31 13.5 66 29.5q35 16 66 38q31 22 51 53q20 31 20 77q0 35-13.5 61.5q-13.5 26.5-37.5 47q-24 20.5-58 36.5z"], "¨": [549, "m171-578q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "©": [747, "m374 10q-66 0-125-23.5q-59-23.5-104.5-67q-45.5-43.5-71.5-105q-26-61.5-26-138.5q0-77 26-138q26-61 71.5-104q45.5-43 104.5-65.5q59-22.5 125-22.5q66 0 124.5 22.5q58.5 22.5 104 65.5q45.5 43 71.5 104q26 61 26 138q0 77-26 138.5q-26 61.5-71.5 105q-45.5 43.5-104 67q-58.5 23.5-124.5 23.5zm0-52q56 0 104.5-20q48.5-20 85.5-57.5q37-37.5 57.5-89.5q20.5-52 20.5-115q0-64-20.5-115.5q-20.5-51.5-57.5-88q-37-36.5-85.5-56q-48.5-19.5-104.5-19.5q-57 0-105.5 19.5q-48.5 19.5-85 56q-36.5 36.5-57.5 88q-21 51.5-21 115.5q0 63 21 115q21 52 57.5 89.5q36.5 37.5 85 57.5q48.5 20 105.5 20zm10-87q-54 0-96.5-23q-42.5-23-67-66.5q-24.5-43.5-24.5-103.5q0-59 27-103q27-44 69.5-67.5q42.5-23.5 92.5-23.5q44 0 75.5 17q31.5 17 53.5 42l-45 49q-16-18-35-28q-19-10-43-10q-33 0-57.5 16q-24.5 16-38 44.5q-13.5 28.5-13.5 63.5q0 57 28.5 89.5q28.5 32.5 76.5 32.5q30 0 49.5-10q19.5-10 39.5-28l40 54q-27 25-58.5 40q-31.5 15-73.5 15z"], "ª": [352, "m133-376q-45 0-72-27.5q-27-27.5-27-70.5q0-54 46-83.5q46-29.5 146-38.5q-1-26-13.5-40q-12.5-14-42.5-14q-23 0-47.5 9.5q-24.5 9.5-47.5 22.5l-31-56q29-18 65-31q36-13 75-13q62 0 94 35.5q32 35.5 32 104.5l0 193l-68 0l-8-35l-4 0q-19 18-43.5 31q-24.5 13-53.5 13zm27-66q18 0 33-8q15-8 33-24l0-66q-61 7-85.5 23q-24.5 16-24.5 37q0 19 11.5 28.5q11.5 9.5 32.5 9.5z"], "«": [455, "m182-61l-135-149l0-84l135-149l46 37l-115 154l115 155zm174 0l-135-149l0-84l135-149l46 37l-115 154l115 155z"], "¬": [513, "m392-99l0-189l-358 0l0-84l445 0l0 273z"], "­": [322, "m42-210l0-84l238 0l0 84z"], "®": [443, "m221-315q-53 0-97-25.5q-44-25.5-70-70.5q-26-45-26-103q0-59 26-104q26-45 70-70.5q44-25.5 97-25.5q53 0 97 25.5q44 25.5 70 70.5q26 45 26 104q0 58-26 103q-26 45-70 70.5q-44 25.5-97 25.5zm0-43q42 0 75-19.5q33-19.5 52-55q19-35.5 19-81.5q0-47-19-82.5q-19-35.5-52-55.5q-33-20-75-20q-42 0-75 20q-33 20-52 55.5q-19 35.5-19 82.5q0 46 19 81.5q19 35.5 52 55q33 19.5 75 19.5zm-77-59l0-199l83 0q33 0 56.5 15q23.5 15 23.5 50q0 17-9.5 32q-9.5 15-27.5 23l44 79l-53 0l-33-65l-34 0l0 65zm50-101l23 0q18 0 27.5-8q9.5-8 9.5-22q0-13-8.5-21.5q-8.5-8.5-27.5-8.5l-24 0z"], "¯": [549, "m134-596l0-76l280 0l0 76z"], "°": [348, "m175-413q-37 0-68-17q-31-17-49-48q-18-31-18-71q0-40 18-71q18-31 49-48q31-17 68-17q37 0 67.5 17q30.5 17 49 48q18.5 31 18.5 71q0 40-18.5 71q-18.5 31-49 48q-30.5 17-67.5 17zm0-59q32 0 51.5-21.5q19.5-21.5 19.5-55.5q0-35-19.5-56.5q-19.5-21.5-51.5-21.5q-31 0-51 21.5q-20 21.5-20 56.5q0 34 20 55.5q20 21.5 51 21.5z"], "±": [513, "m213-147l0-153l-179 0l0-84l179 0l0-177l87 0l0 177l179 0l0 84l-179 0l0 153zm-179 147l0-83l445 0l0 83z"], "²": [372, "m48-385l0-48q56-47 95.5-85q39.5-38 61-68.5q21.5-30.5 21.5-57.5q0-33-17.5-52q-17.5-19-48.5-19q-22 0-41 14.5q-19 14.5-36 37.5l-50-46q27-37 62.5-57.5q35.5-20.5 77.5-20.5q62 0 99.5 33.5q37.5 33.5 37.5 95.5q0 34-16.5 66.5q-16.5 32.5-44.5 65q-28 32.5-63 68.5l141 0l0 73z"], "³": [372, "m183-373q-49 0-88.5-21q-39.5-21-63.5-57l54-42q18 26 41 39.5q23 13.5 50 13.5q27 0 47-15q20-15 20-43q0-30-27.5-45q-27.5-15-79.5-15l0-51q43 0 67.5-16.5q24.5-16.5 24.5-43.5q0-24-16-37.5q-16-13.5-43-13.5q-21 0-39 12q-18 12-33 31l-50-44q29-32 61-49q32-17 75-17q35 0 64.5 13q29.5 13 47.5 37q18 24 18 57q0 33-16.5 55.5q-16.5 22.5-45.5 37.5q32 10 54.5 34.5q22.5 24.5 22.5 60.5q0 36-20 63q-20 27-53 41.5q-33 14.5-72 14.5z"], "´": [549, "m192-570l122-174l123 0l7 12l-162 162z"], "µ": [578, "m73 178l0-669l115 0l0 293q0 58 18 84.5q18 26.5 57 26.5q20 0 37.5-6.5q17.5-6.5 34.5-24q17-17.5 35-48.5l0-325l116 0q-2 62-4 128q-2 66-3 127.5q-1 61.5-1 111.5q0 22 11 31q11 9 29 9q7 0 15-1.5q8-1.5 15-4.5l15 86q-14 6-30.5 10q-16.5 4-42.5 4q-47 0-73.5-21.5q-26.5-21.5-34.5-64.5l-4 0q-22 42-52.5 63q-30.5 21-66.5 21q-24 0-43.5-6.5q-19.5-6.5-34.5-27.5q0 42 1 74.5q1 32.5 2.5 62.5q1.5 30 5.5 67z"], "¶": [599, "m387 80l0-734l116 0l0 734zm-92-292q-72 0-129.5-24q-57.5-24-91.5-74q-34-50-34-126q0-81 33-129q33-48 89-68.5q56-20.5 126-20.5l44 0l0 442z"], "·": [275, "m138-243q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], "¸": [549, "m184 233l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "¹": [372, "m168-385l0-294l-86 0l0-54q37-6 59-16q22-10 45-26l69 0l0 390z"], "º": [369, "m184-377q-42 0-77.5-20q-35.5-20-57.5-58.5q-22-38.5-22-91.5q0-54 22-92.5q22-38.5 57.5-58.5q35.5-20 77.5-20q42 0 77.5 20q35.5 20 57.5 58.5q22 38.5 22 92.5q0 53-22 91.5q-22 38.5-57.5 58.5q-35.5 20-77.5 20zm0-67q35 0 53.5-28.5q18.5-28.5 18.5-74.5q0-47-18.5-76q-18.5-29-53.5-29q-35 0-53.5 29q-18.5 29-18.5 76q0 46 18.5 74.5q18.5 28.5 53.5 28.5z"], "»": [455, "m99-61l-45-36l114-155l-114-154l45-37l136 149l0 84zm174 0l-45-36l114-155l-114-154l45-37l136 149l0 84z"], "¼": [795, "m141-264l0-294l-86 0l0-54q37-6 59-16q22-10 45-26l69 0l0 390zm42 276l357-678l70 0l-356 678zm457-12l0-209l5-113l-4 0l-45 79l-51 89l230 0l0 59l-314 0l0-44l152-251l104 0l0 390z"], "½": [827, "m141-264l0-294l-86 0l0-54q37-6 59-16q22-10 45-26l69 0l0 390zm24 276l357-678l70 0l-356 678zm338-12l0-48q56-47 95.5-85q39.5-38 61-68.5q21.5-30.5 21.5-57.5q0-33-17.5-52q-17.5-19-48.5-19q-22 0-41 14.5q-19 14.5-36 37.5l-50-46q27-37 62.5-57.5q35.5-20.5 77.5-20.5q62 0 99.5 33.5q37.5 33.5 37.5 95.5q0 34-16.5 66.5q-16.5 32.5-44.5 65q-28 32.5-63 68.5l141 0l0 73z"], "¾": [807, "m181-252q-49 0-88.5-21q-39.5-21-63.5-57l54-42q18 26 41 39.5q23 13.5 50 13.5q27 0 47-15q20-15 20-43q0-30-27.5-45q-27.5-15-79.5-15l0-51q43 0 67.5-16.5q24.5-16.5 24.5-43.5q0-24-16-37.5q-16-13.5-43-13.5q-21 0-39 12q-18 12-33 31l-50-44q29-32 61-49q32-17 75-17q35 0 64.5 13q29.5 13 47.5 37q18 24 18 57q0 33-16.5 55.5q-16.5 22.5-45.5 37.5q32 10 54.5 34.5q22.5 24.5 22.5 60.5q0 36-20 63q-20 27-53 41.5q-33 14.5-72 14.5zm32 264l357-678l70 0l-356 678zm439-12l0-209l5-113l-4 0l-45 79l-51 89l230 0l0 59l-314 0l0-44l152-251l104 0l0 390z"], "¿": [444, "m224 191q-53 0-93-19q-40-19-63-56q-23-37-23-91q0-38 15.5-68q15.5-30 38-56q22.5-26 44-52q21.5-26 35-56q13.5-30 8.5-69l102 0q6 44-5.5 78.5q-11.5 34.5-32 62.5q-20.5 28-42.5 52.5q-22 24.5-37 48.5q-15 24-15 51q0 24 10 42q10 18 28 28q18 10 44 10q30 0 55.5-14.5q25.5-14.5 46.5-37.5l65 59q-34 38-79.5 62.5q-45.5 24.5-101.5 24.5zm12-538q-31 0-52.5-22.5q-21.5-22.5-21.5-56.5q0-33 21.5-55q21.5-22 52.5-22q32 0 53 22q21 22 21 55q0 34-21 56.5q-21 22.5-53 22.5z"], "À": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm138-527l-170-132l7-12l133 0l128 144z"], "Á": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm72-527l128-144l133 0l7 12l-170 132z"], "Â": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm-38-527l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Ã": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm227-523q-27 0-47.5-10q-20.5-10-36.5-22.5q-16-12.5-29.5-22q-13.5-9.5-29.5-9.5q-16 0-27.5 13.5q-11.5 13.5-14.5 43.5l-76-6q4-67 35-100q31-33 80-33q27 0 47.5 9.5q20.5 9.5 36.5 22q16 12.5 30 22.5q14 10 29 10q16 0 27.5-14q11.5-14 14.5-44l76 6q-3 66-34.5 100q-31.5 34-80.5 34z"], "Ä": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm47-531q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Å": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm154-521q-56 0-89-25.5q-33-25.5-33-69.5q0-43 33-68.5q33-25.5 89-25.5q57 0 89.5 25.5q32.5 25.5 32.5 69.5q0 43-32.5 68.5q-32.5 25.5-89.5 25.5zm0-44q22 0 36-13.5q14-13.5 14-36.5q0-24-14-37q-14-13-36-13q-22 0-36 13q-14 13-14 37q0 23 14 36.5q14 13.5 36 13.5z"], "Æ": [834, "m-3 0l327-654l449 0l0 98l-263 0l0 167l221 0l0 98l-221 0l0 193l273 0l0 98l-389 0l0-565l-4 0q-24 50-47 100.5q-23 50.5-46 98.5l-178 366zm151-170l0-91l310 0l0 91z"], "Ç": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24zm-94 221l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "È": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm191-704l-170-132l7-12l133 0l128 144z"], "É": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm125-704l128-144l133 0l7 12l-170 132z"], "Ê": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm15-704l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Ë": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm100-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Ì": [282, "m83 0l0-654l116 0l0 654zm43-704l-170-132l7-12l133 0l128 144z"], "Í": [282, "m83 0l0-654l116 0l0 654zm-23-704l128-144l133 0l7 12l-170 132z"], "Î": [282, "m83 0l0-654l116 0l0 654zm-133-704l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Ï": [282, "m83 0l0-654l116 0l0 654zm-48-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Ð": [651, "m30-298l0-82l80-6l252 0l0 88zm79 298l0-654l175 0q100 0 171 36q71 36 109 108q38 72 38 180q0 108-37.5 181.5q-37.5 73.5-107.5 111q-70 37.5-167 37.5zm116-94l51 0q66 0 112.5-25.5q46.5-25.5 70.5-77.5q24-52 24-133q0-80-24-131q-24-51-70.5-75q-46.5-24-112.5-24l-51 0z"], "Ñ": [656, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286zm326-700q-27 0-47.5-10q-20.5-10-36.5-22.5q-16-12.5-29.5-22q-13.5-9.5-29.5-9.5q-16 0-27.5 13.5q-11.5 13.5-14.5 43.5l-76-6q4-67 35-100q31-33 80-33q27 0 47.5 9.5q20.5 9.5 36.5 22q16 12.5 30 22.5q14 10 29 10q16 0 27.5-14q11.5-14 14.5-44l76 6q-3 66-34.5 100q-31.5 34-80.5 34z"], "Ò": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-16-615l-170-132l7-12l133 0l128 144z"], "Ó": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-82-615l128-144l133 0l7 12l-170 132z"], "Ô": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-192-615l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Õ": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm73-611q-27 0-47.5-10q-20.5-10-36.5-22.5q-16-12.5-29.5-22q-13.5-9.5-29.5-9.5q-16 0-27.5 13.5q-11.5 13.5-14.5 43.5l-76-6q4-67 35-100q31-33 80-33q27 0 47.5 9.5q20.5 9.5 36.5 22q16 12.5 30 22.5q14 10 29 10q16 0 27.5-14q11.5-14 14.5-44l76 6q-3 66-34.5 100q-31.5 34-80.5 34z"], "Ö": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-107-619q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "×": [513, "m108-119l-59-60l148-150l-148-151l59-60l148 152l149-152l59 60l-149 151l149 150l-59 60l-149-151z"], "Ø": [674, "m110 40l-69-56l533-678l70 56zm229-28q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5z"], "Ù": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-17-716l-170-132l7-12l133 0l128 144z"], "Ú": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-83-716l128-144l133 0l7 12l-170 132z"], "Û": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-193-716l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Ü": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-108-720q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Ý": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243zm-24-704l128-144l133 0l7 12l-170 132z"], "Þ": [600, "m83 0l0-654l116 0l0 104l104 0q72 0 128 19q56 19 88.5 63q32.5 44 32.5 120q0 73-32.5 119.5q-32.5 46.5-89 69.5q-56.5 23-127.5 23l-104 0l0 136zm116-229l95 0q73 0 108.5-29.5q35.5-29.5 35.5-89.5q0-61-36.5-85q-36.5-24-107.5-24l-95 0z"], "ß": [604, "m404 12q-40 0-75.5-11.5q-35.5-11.5-68.5-38.5l39-70q25 19 50.5 26q25.5 7 51.5 7q33 0 51-19q18-19 18-45q0-24-12-40q-12-16-32-28.5q-20-12.5-42.5-25.5q-22.5-13-42.5-28.5q-20-15.5-32.5-38.5q-12.5-23-12.5-57q0-31 13.5-54q13.5-23 30.5-42.5q17-19.5 30-42q13-22.5 13-51.5q0-34-23-56.5q-23-22.5-60-22.5q-51 0-82 37q-31 37-31 107l0 482l-114 0l0-498q0-64 26.5-113.5q26.5-49.5 77-77q50.5-27.5 123.5-27.5q62 0 105.5 21.5q43.5 21.5 66 57.5q22.5 36 22.5 77q0 37-14 63q-14 26-31.5 46q-17.5 20-31.5 38.5q-14 18.5-14 41.5q0 20 12.5 34q12.5 14 32 26q19.5 12 42 25q22.5 13 42.5 31q20 18 32.5 44.5q12.5 26.5 12.5 66.5q0 43-20.5 78.5q-20.5 35.5-59 56.5q-38.5 21-93.5 21z"], "à": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm36-488l-162-162l7-12l123 0l122 174z"], "á": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm-38-488l122-174l123 0l7 12l-162 162z"], "â": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm-142-488l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "ã": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm113-493q-25 0-44-11q-19-11-34.5-26q-15.5-15-29-26q-13.5-11-28.5-11q-19 0-28.5 17q-9.5 17-12.5 50l-74-4q2-46 15-78q13-32 37-49q24-17 61-17q26 0 44.5 11q18.5 11 34 25.5q15.5 14.5 29.5 26q14 11.5 29 11.5q18 0 27.5-17.5q9.5-17.5 12.5-49.5l74 4q-2 45-14.5 77q-12.5 32-37 49.5q-24.5 17.5-61.5 17.5z"], "ä": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm-59-496q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "å": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm44-477q-58 0-89.5-29.5q-31.5-29.5-31.5-72.5q0-43 31.5-72q31.5-29 89.5-29q58 0 89.5 29q31.5 29 31.5 72q0 43-31.5 72.5q-31.5 29.5-89.5 29.5zm0-46q21 0 35.5-15.5q14.5-15.5 14.5-40.5q0-25-14.5-40q-14.5-15-35.5-15q-21 0-35.5 15q-14.5 15-14.5 41q0 24 14.5 39.5q14.5 15.5 35.5 15.5z"], "æ": [780, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69-125.5q69-42.5 217-58.5q-1-26-9-47q-8-21-26.5-33q-18.5-12-52.5-12q-34 0-68.5 13q-34.5 13-67.5 33l-42-77q27-18 58-32.5q31-14.5 65-23q34-8.5 69-8.5q51 0 87.5 23.5q36.5 23.5 52.5 65.5q29-42 66.5-65.5q37.5-23.5 85.5-23.5q65 0 108 30q43 30 64 83q21 53 21 122q0 17-1.5 32q-1.5 15-3.5 26l-300 0q4 41 22 70q18 29 47 44.5q29 15.5 65 15.5q32 0 59.5-9q27.5-9 54.5-25l38 74q-34 24-77 38q-43 14-90 14q-38 0-69.5-11q-31.5-11-56.5-30q-25-19-45-43q-51 43-98.5 63.5q-47.5 20.5-95.5 20.5zm36-94q30 0 62-13.5q32-13.5 58-40.5q-7-17-10.5-38.5q-3.5-21.5-5.5-43.5l-2-18q-93 12-131.5 34.5q-38.5 22.5-38.5 61.5q0 31 19 44.5q19 13.5 49 13.5zm212-214l200 0q0-57-25-86.5q-25-29.5-67-29.5q-28 0-50.5 14q-22.5 14-37.5 40q-15 26-20 62z"], "ç": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17zm-110 221l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "è": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-26-582l-162-162l7-12l123 0l122 174z"], "é": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-100-582l122-174l123 0l7 12l-162 162z"], "ê": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-204-582l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "ë": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-121-590q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "ì": [262, "m73 0l0-491l115 0l0 491zm49-570l-162-162l7-12l123 0l122 174z"], "í": [262, "m73 0l0-491l115 0l0 491zm-25-570l122-174l123 0l7 12l-162 162z"], "î": [262, "m73 0l0-491l115 0l0 491zm-129-570l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "ï": [262, "m73 0l0-491l115 0l0 491zm-46-578q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "ð": [552, "m271 12q-59 0-110-29q-51-29-82-82q-31-53-31-126q0-70 28.5-120.5q28.5-50.5 75.5-78q47-27.5 102-27.5q41 0 78.5 20q37.5 20 59.5 66l1 67q-28-39-58-52.5q-30-13.5-62-13.5q-36 0-63 17q-27 17-41.5 48q-14.5 31-14.5 74q0 44 16.5 76.5q16.5 32.5 44 49.5q27.5 17 59.5 17q37 0 62.5-20.5q25.5-20.5 39-59.5q13.5-39 13.5-94q0-83-19.5-145.5q-19.5-62.5-57-110.5q-37.5-48-91.5-85q-54-37-124-68l50-71q68 29 131 69.5q63 40.5 112.5 96.5q49.5 56 78.5 131.5q29 75.5 29 176.5q0 80-28 142q-28 62-78.5 97q-50.5 35-120.5 35zm-147-488l-40-76l352-180l44 76z"], "ñ": [560, "m73 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343zm300-575q-25 0-44-11q-19-11-34.5-26q-15.5-15-29-26q-13.5-11-28.5-11q-19 0-28.5 17q-9.5 17-12.5 50l-74-4q2-46 15-78q13-32 37-49q24-17 61-17q26 0 44.5 11q18.5 11 34 25.5q15.5 14.5 29.5 26q14 11.5 29 11.5q18 0 27.5-17.5q9.5-17.5 12.5-49.5l74 4q-2 45-14.5 77q-12.5 32-37 49.5q-24.5 17.5-61.5 17.5z"], "ò": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-8-488l-162-162l7-12l123 0l122 174z"], "ó": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-82-488l122-174l123 0l7 12l-162 162z"], "ô": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-186-488l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "õ": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm69-493q-25 0-44-11q-19-11-34.5-26q-15.5-15-29-26q-13.5-11-28.5-11q-19 0-28.5 17q-9.5 17-12.5 50l-74-4q2-46 15-78q13-32 37-49q24-17 61-17q26 0 44.5 11q18.5 11 34 25.5q15.5 14.5 29.5 26q14 11.5 29 11.5q18 0 27.5-17.5q9.5-17.5 12.5-49.5l74 4q-2 45-14.5 77q-12.5 32-37 49.5q-24.5 17.5-61.5 17.5z"], "ö": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-103-496q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "÷": [513, "m34-288l0-84l445 0l0 84zm222 204q-28 0-48-18.5q-20-18.5-20-47.5q0-29 20-47q20-18 48-18q29 0 48.5 18q19.5 18 19.5 47q0 29-19.5 47.5q-19.5 18.5-48.5 18.5zm0-360q-28 0-48-18.5q-20-18.5-20-47.5q0-29 20-47q20-18 48-18q29 0 48.5 18q19.5 18 19.5 47q0 29-19.5 47.5q-19.5 18.5-48.5 18.5z"], "ø": [549, "m276 12q-62 0-116-30q-54-30-87-87.5q-33-57.5-33-138.5q0-83 33-140.5q33-57.5 86.5-88q53.5-30.5 114.5-30.5q62 0 115.5 30.5q53.5 30.5 87 88q33.5 57.5 33.5 140.5q0 81-33.5 138.5q-33.5 57.5-86.5 87.5q-53 30-114 30zm0-90q35 0 62-20q27-20 42.5-56.5q15.5-36.5 15.5-83.5q0-57-15-96.5q-15-39.5-42.5-59.5q-27.5-20-64.5-20q-36 0-63 20.5q-27 20.5-42 57q-15 36.5-15 84.5q0 56 15 95q15 39 42.5 59q27.5 20 64.5 20zm-178 112l-62-52l416-508l62 52z"], "ù": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm51-582l-162-162l7-12l123 0l122 174z"], "ú": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm-23-582l122-174l123 0l7 12l-162 162z"], "û": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm-127-582l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "ü": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm-44-590q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "ý": [495, "m106 202q-20 0-35.5-3q-15.5-3-28.5-9l22-86q10 3 18 4q8 1 16 1q39 0 62.5-24q23.5-24 35.5-60l9-31l-193-485l117 0l85 241q11 32 21.5 67.5q10.5 35.5 21.5 70.5l4 0q9-34 18.5-69.5q9.5-35.5 18.5-68.5l74-241l111 0l-178 513q-20 55-46 95.5q-26 40.5-63 62.5q-37 22-90 22zm66-772l122-174l123 0l7 12l-162 162z"], "þ": [564, "m73 194l0-900l115 0l0 182l-2 77q29-24 64-40q35-16 72-16q63 0 107.5 31q44.5 31 68 87q23.5 56 23.5 132q0 84-30 143q-30 59-77.5 90.5q-47.5 31.5-102.5 31.5q-35 0-65.5-13.5q-30.5-13.5-59.5-36.5l2 78l0 154zm214-277q33 0 59-19q26-19 41-56.5q15-37.5 15-93.5q0-49-11-84q-11-35-34.5-53.5q-23.5-18.5-60.5-18.5q-27 0-53 13.5q-26 13.5-55 41.5l0 229q27 22 52.5 31.5q25.5 9.5 46.5 9.5z"], "ÿ": [495, "m106 202q-20 0-35.5-3q-15.5-3-28.5-9l22-86q10 3 18 4q8 1 16 1q39 0 62.5-24q23.5-24 35.5-60l9-31l-193-485l117 0l85 241q11 32 21.5 67.5q10.5 35.5 21.5 70.5l4 0q9-34 18.5-69.5q9.5-35.5 18.5-68.5l74-241l111 0l-178 513q-20 55-46 95.5q-26 40.5-63 62.5q-37 22-90 22zm45-780q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "Ā": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm10-551l0-76l288 0l0 76z"], "ā": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm-96-514l0-76l280 0l0 76z"], "Ă": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91zm154-525q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ă": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5zm44-487q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Ą": [558, "m498 222q-49 0-83-24q-34-24-34-71q0-30 13-55q13-25 31.5-43.5q18.5-18.5 35.5-28.5l-23 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 54-28 109q-15 55-30 107l-101 348l-118 0l213-654l136 0l213 654q-38 10-62.5 38q-24.5 28-24.5 57q0 23 14.5 33.5q14.5 10.5 34.5 10.5q14 0 26.5-5q12.5-5 21.5-11l28 65q-18 14-45.5 24q-27.5 10-54.5 10zm-374-399l0-91l308 0l0 91z"], "ą": [516, "m395 217q-46 0-78-24q-32-24-32-73q0-28 11-51.5q11-23.5 27.5-41q16.5-17.5 32.5-27.5l-8-54l-4 0q-34 28-71 47q-37 19-81 19q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290q-38 13-58 41q-20 28-20 53q0 22 14.5 32.5q14.5 10.5 31.5 10.5q14 0 26-4q12-4 23-11l26 62q-19 14-46 23.5q-27 9.5-53 9.5zm-167-299q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5z"], "Ć": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24zm-90-716l128-144l133 0l7 12l-170 132z"], "ć": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17zm-86-582l122-174l123 0l7 12l-162 162z"], "Ĉ": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24zm-200-716l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ĉ": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17zm-190-582l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ċ": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24zm-8-719q-30 0-50.5-19q-20.5-19-20.5-47q0-29 20.5-47q20.5-18 50.5-18q31 0 51 18q20 18 20 47q0 28-20 47q-20 19-51 19z"], "ċ": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17zm-4-589q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "Č": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24zm-66-717l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "č": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17zm-56-582l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "Ď": [625, "m83 0l0-654l175 0q100 0 171 36q71 36 109 108q38 72 38 180q0 108-37.5 181.5q-37.5 73.5-107.5 111q-70 37.5-167 37.5zm116-94l51 0q66 0 112.5-25.5q46.5-25.5 70.5-77.5q24-52 24-133q0-80-24-131q-24-51-70.5-75q-46.5-24-112.5-24l-51 0zm61-611l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ď": [594, "m245 12q-92 0-147-68q-55-68-55-189q0-80 29.5-138q29.5-58 77-89q47.5-31 101.5-31q42 0 71.5 14q29.5 14 57.5 40l-4-79l0-178l115 0l0 706l-95 0l-8-53l-4 0q-27 27-63 46q-36 19-76 19zm28-95q29 0 54-13.5q25-13.5 49-41.5l0-229q-25-23-50-32q-25-9-50-9q-32 0-57.5 19q-25.5 19-41 55q-15.5 36-15.5 88q0 79 29 121q29 42 82 42zm268-465l-5-217l77 0l-1 63l-19 154z"], "Đ": [645, "m30-298l0-82l80-6l252 0l0 88zm79 298l0-654l175 0q100 0 171 36q71 36 109 108q38 72 38 180q0 108-37.5 181.5q-37.5 73.5-107.5 111q-70 37.5-167 37.5zm116-94l51 0q66 0 112.5-25.5q46.5-25.5 70.5-77.5q24-52 24-133q0-80-24-131q-24-51-70.5-75q-46.5-24-112.5-24l-51 0z"], "đ": [564, "m246 12q-62 0-108-28.5q-46-28.5-71-81.5q-25-53-25-126q0-72 30-125q30-53 78-82q48-29 101-29q42 0 71.5 14q29.5 14 57.5 40l-4-80l0-220l115 0l0 706l-97 0l-8-50l-4 0q-27 27-61 44.5q-34 17.5-75 17.5zm27-95q29 0 53.5-13.5q24.5-13.5 49.5-41.5l0-184q-25-24-49.5-33.5q-24.5-9.5-50.5-9.5q-31 0-57 17q-26 17-41.5 48q-15.5 31-15.5 74q0 67 29 105q29 38 82 38zm-73-457l0-88l362 0l0 82l-76 6z"], "Ē": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm63-728l0-76l288 0l0 76z"], "ē": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-158-608l0-76l280 0l0 76z"], "Ĕ": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm207-702q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ĕ": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-18-581q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Ė": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm207-707q-30 0-50.5-19q-20.5-19-20.5-47q0-29 20.5-47q20.5-18 50.5-18q31 0 51 18q20 18 20 47q0 28-20 47q-20 19-51 19z"], "ė": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-18-589q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "Ę": [538, "m410 222q-49 0-83-24q-34-24-34-71q0-44 25.5-77q25.5-33 54.5-50l-290 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98l-9 0q-21 0-42.5 14.5q-21.5 14.5-35.5 36q-14 21.5-14 44.5q0 23 14.5 33.5q14.5 10.5 34.5 10.5q14 0 26-5q12-5 21-11l29 65q-18 14-46 24q-28 10-55 10z"], "ę": [507, "m363 216q-46 0-78.5-23.5q-32.5-23.5-32.5-72.5q0-35 20.5-66q20.5-31 59.5-56l2 4q-12 5-25.5 7.5q-13.5 2.5-24.5 2.5q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-41 26-66 49q-25 23-35.5 43.5q-10.5 20.5-10.5 41.5q0 24 15 33q15 9 31 9q15 0 27.5-3.5q12.5-3.5 22.5-10.5l26 62q-18 15-45.5 23.5q-27.5 8.5-53.5 8.5z"], "Ě": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm149-705l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ě": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-70-582l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "Ĝ": [628, "m357 12q-88 0-158-39q-70-39-110-114.5q-40-75.5-40-183.5q0-80 23.5-143q23.5-63 66-107.5q42.5-44.5 98.5-67.5q56-23 121-23q70 0 119 25q49 25 79 58l-62 71q-24-24-55-38.5q-31-14.5-77-14.5q-58 0-102 28.5q-44 28.5-68 81.5q-24 53-24 127q0 74 23 128q23 54 67.5 82.5q44.5 28.5 109.5 28.5q28 0 53-7.5q25-7.5 41-21.5l0-141l-124 0l0-95l228 0l0 288q-33 33-87.5 55.5q-54.5 22.5-121.5 22.5zm-191-716l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ĝ": [520, "m244 217q-59 0-105-14q-46-14-72.5-42.5q-26.5-28.5-26.5-71.5q0-31 18.5-57.5q18.5-26.5 51.5-47.5l0-4q-18-12-31-32q-13-20-13-50q0-28 16.5-52q16.5-24 37.5-39l0-4q-25-19-44.5-53q-19.5-34-19.5-77q0-56 27-95.5q27-39.5 71-60q44-20.5 96-20.5q20 0 39 3q19 3 33 9l176 0l0 85l-92 0l0 4q14 15 22 34.5q8 19.5 8 45.5q0 54-25 91q-25 37-67 56q-42 19-94 19q-16 0-33-3q-17-3-34-10q-10 10-17 20q-7 10-7 27q0 21 18 33q18 12 62 12l87 0q89 0 134.5 28.5q45.5 28.5 45.5 92.5q0 48-32 87.5q-32 39.5-91 62.5q-59 23-139 23zm6-445q23 0 42.5-11.5q19.5-11.5 31-34q11.5-22.5 11.5-53.5q0-47-24.5-72q-24.5-25-60.5-25q-36 0-61 25q-25 25-25 72q0 31 12 53.5q12 22.5 31 34q19 11.5 43 11.5zm12 370q39 0 69-10.5q30-10.5 47-29q17-18.5 17-39.5q0-29-22.5-39q-22.5-10-64.5-10l-67 0q-20 0-36-2q-16-2-31-5q-19 15-28.5 31q-9.5 16-9.5 34q0 33 34 51.5q34 18.5 92 18.5zm-182-712l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ğ": [628, "m357 12q-88 0-158-39q-70-39-110-114.5q-40-75.5-40-183.5q0-80 23.5-143q23.5-63 66-107.5q42.5-44.5 98.5-67.5q56-23 121-23q70 0 119 25q49 25 79 58l-62 71q-24-24-55-38.5q-31-14.5-77-14.5q-58 0-102 28.5q-44 28.5-68 81.5q-24 53-24 127q0 74 23 128q23 54 67.5 82.5q44.5 28.5 109.5 28.5q28 0 53-7.5q25-7.5 41-21.5l0-141l-124 0l0-95l228 0l0 288q-33 33-87.5 55.5q-54.5 22.5-121.5 22.5zm1-714q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ğ": [520, "m244 217q-59 0-105-14q-46-14-72.5-42.5q-26.5-28.5-26.5-71.5q0-31 18.5-57.5q18.5-26.5 51.5-47.5l0-4q-18-12-31-32q-13-20-13-50q0-28 16.5-52q16.5-24 37.5-39l0-4q-25-19-44.5-53q-19.5-34-19.5-77q0-56 27-95.5q27-39.5 71-60q44-20.5 96-20.5q20 0 39 3q19 3 33 9l176 0l0 85l-92 0l0 4q14 15 22 34.5q8 19.5 8 45.5q0 54-25 91q-25 37-67 56q-42 19-94 19q-16 0-33-3q-17-3-34-10q-10 10-17 20q-7 10-7 27q0 21 18 33q18 12 62 12l87 0q89 0 134.5 28.5q45.5 28.5 45.5 92.5q0 48-32 87.5q-32 39.5-91 62.5q-59 23-139 23zm6-445q23 0 42.5-11.5q19.5-11.5 31-34q11.5-22.5 11.5-53.5q0-47-24.5-72q-24.5-25-60.5-25q-36 0-61 25q-25 25-25 72q0 31 12 53.5q12 22.5 31 34q19 11.5 43 11.5zm12 370q39 0 69-10.5q30-10.5 47-29q17-18.5 17-39.5q0-29-22.5-39q-22.5-10-64.5-10l-67 0q-20 0-36-2q-16-2-31-5q-19 15-28.5 31q-9.5 16-9.5 34q0 33 34 51.5q34 18.5 92 18.5zm4-711q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Ġ": [628, "m357 12q-88 0-158-39q-70-39-110-114.5q-40-75.5-40-183.5q0-80 23.5-143q23.5-63 66-107.5q42.5-44.5 98.5-67.5q56-23 121-23q70 0 119 25q49 25 79 58l-62 71q-24-24-55-38.5q-31-14.5-77-14.5q-58 0-102 28.5q-44 28.5-68 81.5q-24 53-24 127q0 74 23 128q23 54 67.5 82.5q44.5 28.5 109.5 28.5q28 0 53-7.5q25-7.5 41-21.5l0-141l-124 0l0-95l228 0l0 288q-33 33-87.5 55.5q-54.5 22.5-121.5 22.5zm1-719q-30 0-50.5-19q-20.5-19-20.5-47q0-29 20.5-47q20.5-18 50.5-18q31 0 51 18q20 18 20 47q0 28-20 47q-20 19-51 19z"], "ġ": [520, "m244 217q-59 0-105-14q-46-14-72.5-42.5q-26.5-28.5-26.5-71.5q0-31 18.5-57.5q18.5-26.5 51.5-47.5l0-4q-18-12-31-32q-13-20-13-50q0-28 16.5-52q16.5-24 37.5-39l0-4q-25-19-44.5-53q-19.5-34-19.5-77q0-56 27-95.5q27-39.5 71-60q44-20.5 96-20.5q20 0 39 3q19 3 33 9l176 0l0 85l-92 0l0 4q14 15 22 34.5q8 19.5 8 45.5q0 54-25 91q-25 37-67 56q-42 19-94 19q-16 0-33-3q-17-3-34-10q-10 10-17 20q-7 10-7 27q0 21 18 33q18 12 62 12l87 0q89 0 134.5 28.5q45.5 28.5 45.5 92.5q0 48-32 87.5q-32 39.5-91 62.5q-59 23-139 23zm6-445q23 0 42.5-11.5q19.5-11.5 31-34q11.5-22.5 11.5-53.5q0-47-24.5-72q-24.5-25-60.5-25q-36 0-61 25q-25 25-25 72q0 31 12 53.5q12 22.5 31 34q19 11.5 43 11.5zm12 370q39 0 69-10.5q30-10.5 47-29q17-18.5 17-39.5q0-29-22.5-39q-22.5-10-64.5-10l-67 0q-20 0-36-2q-16-2-31-5q-19 15-28.5 31q-9.5 16-9.5 34q0 33 34 51.5q34 18.5 92 18.5zm4-719q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "Ģ": [628, "m357 12q-88 0-158-39q-70-39-110-114.5q-40-75.5-40-183.5q0-80 23.5-143q23.5-63 66-107.5q42.5-44.5 98.5-67.5q56-23 121-23q70 0 119 25q49 25 79 58l-62 71q-24-24-55-38.5q-31-14.5-77-14.5q-58 0-102 28.5q-44 28.5-68 81.5q-24 53-24 127q0 74 23 128q23 54 67.5 82.5q44.5 28.5 109.5 28.5q28 0 53-7.5q25-7.5 41-21.5l0-141l-124 0l0-95l228 0l0 288q-33 33-87.5 55.5q-54.5 22.5-121.5 22.5zm-93 221l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ģ": [520, "m244 217q-59 0-105-14q-46-14-72.5-42.5q-26.5-28.5-26.5-71.5q0-31 18.5-57.5q18.5-26.5 51.5-47.5l0-4q-18-12-31-32q-13-20-13-50q0-28 16.5-52q16.5-24 37.5-39l0-4q-25-19-44.5-53q-19.5-34-19.5-77q0-56 27-95.5q27-39.5 71-60q44-20.5 96-20.5q20 0 39 3q19 3 33 9l176 0l0 85l-92 0l0 4q14 15 22 34.5q8 19.5 8 45.5q0 54-25 91q-25 37-67 56q-42 19-94 19q-16 0-33-3q-17-3-34-10q-10 10-17 20q-7 10-7 27q0 21 18 33q18 12 62 12l87 0q89 0 134.5 28.5q45.5 28.5 45.5 92.5q0 48-32 87.5q-32 39.5-91 62.5q-59 23-139 23zm6-445q23 0 42.5-11.5q19.5-11.5 31-34q11.5-22.5 11.5-53.5q0-47-24.5-72q-24.5-25-60.5-25q-36 0-61 25q-25 25-25 72q0 31 12 53.5q12 22.5 31 34q19 11.5 43 11.5zm12 370q39 0 69-10.5q30-10.5 47-29q17-18.5 17-39.5q0-29-22.5-39q-22.5-10-64.5-10l-67 0q-20 0-36-2q-16-2-31-5q-19 15-28.5 31q-9.5 16-9.5 34q0 33 34 51.5q34 18.5 92 18.5zm46-714q-72-7-100.5-26q-28.5-19-28.5-54q0-48 47.5-71q47.5-23 133.5-27l10 50q-61 4-83.5 14q-22.5 10-22.5 30q0 16 16.5 25.5q16.5 9.5 51.5 12.5z"], "Ĥ": [663, "m83 0l0-654l116 0l0 263l265 0l0-263l116 0l0 654l-116 0l0-290l-265 0l0 290zm55-704l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ĥ": [558, "m73 0l0-706l115 0l0 182l-4 95q31-29 69-51.5q38-22.5 88-22.5q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343zm39-754l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "Ħ": [703, "m22-476l0-82l86-6l571 0l0 88zm81 476l0-654l116 0l0 263l265 0l0-263l116 0l0 654l-116 0l0-290l-265 0l0 290z"], "ħ": [566, "m81 0l0-706l115 0l0 224l-4 96q32-30 69.5-52q37.5-22 86.5-22q80 0 116 50.5q36 50.5 36 143.5l0 266l-115 0l0-250q0-60-18-86q-18-26-59-26q-31 0-56.5 16q-25.5 16-55.5 46l0 300zm-77-540l0-82l82-6l286 0l0 88z"], "Ĩ": [282, "m83 0l0-654l116 0l0 654zm132-700q-27 0-47.5-10q-20.5-10-36.5-22.5q-16-12.5-29.5-22q-13.5-9.5-29.5-9.5q-16 0-27.5 13.5q-11.5 13.5-14.5 43.5l-76-6q4-67 35-100q31-33 80-33q27 0 47.5 9.5q20.5 9.5 36.5 22q16 12.5 30 22.5q14 10 29 10q16 0 27.5-14q11.5-14 14.5-44l76 6q-3 66-34.5 100q-31.5 34-80.5 34z"], "ĩ": [262, "m73 0l0-491l115 0l0 491zm126-575q-25 0-44-11q-19-11-34.5-26q-15.5-15-29-26q-13.5-11-28.5-11q-19 0-28.5 17q-9.5 17-12.5 50l-74-4q2-46 15-78q13-32 37-49q24-17 61-17q26 0 44.5 11q18.5 11 34 25.5q15.5 14.5 29.5 26q14 11.5 29 11.5q18 0 27.5-17.5q9.5-17.5 12.5-49.5l74 4q-2 45-14.5 77q-12.5 32-37 49.5q-24.5 17.5-61.5 17.5z"], "Ī": [282, "m83 0l0-654l116 0l0 654zm-85-728l0-76l288 0l0 76z"], "ī": [262, "m73 0l0-491l115 0l0 491zm-83-596l0-76l280 0l0 76z"], "Ĭ": [282, "m83 0l0-654l116 0l0 654zm59-702q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ĭ": [262, "m73 0l0-491l115 0l0 491zm57-569q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Į": [282, "m150 222q-49 0-83-24q-34-24-34-71q0-42 24.5-74.5q24.5-32.5 51.5-52.5l-26 0l0-654l116 0l0 654q-36 19-55 44q-19 25-19 51q0 23 14.5 33.5q14.5 10.5 34.5 10.5q14 0 26.5-5q12.5-5 21.5-11l28 65q-18 14-45.5 24q-27.5 10-54.5 10z"], "į": [262, "m141 217q-45 0-77.5-24q-32.5-24-32.5-73q0-27 11-50q11-23 26.5-40.5q15.5-17.5 29.5-29.5l-25 0l0-491l115 0l0 491q-35 18-52.5 43.5q-17.5 25.5-17.5 51.5q0 22 14.5 32.5q14.5 10.5 31.5 10.5q15 0 26.5-4q11.5-4 22.5-11l26 61q-18 14-44.5 23.5q-26.5 9.5-53.5 9.5zm-10-794q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "İ": [282, "m83 0l0-654l116 0l0 654zm59-707q-30 0-50.5-19q-20.5-19-20.5-47q0-29 20.5-47q20.5-18 50.5-18q31 0 51 18q20 18 20 47q0 28-20 47q-20 19-51 19z"], "ı": [262, "m73 0l0-491l115 0l0 491z"], "Ĳ": [565, "m83 0l0-654l116 0l0 654zm242 174q-26 0-45.5-4q-19.5-4-33.5-10l21-87q10 3 20.5 5q10.5 2 21.5 2q33 0 45-22.5q12-22.5 12-64.5l0-647l116 0l0 646q0 52-15 93q-15 41-49.5 65q-34.5 24-92.5 24z"], "ĳ": [524, "m73 0l0-491l115 0l0 491zm57-577q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18zm166 783q-26 0-46-4q-20-4-34-10l22-85q10 3 21 5.5q11 2.5 21 2.5q33 0 44.5-22.5q11.5-22.5 11.5-65.5l0-518l116 0l0 516q0 52-15 93q-15 41-49 64.5q-34 23.5-92 23.5zm98-783q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "Ĵ": [494, "m212 12q-64 0-110.5-27.5q-46.5-27.5-75.5-85.5l75-51q17 31 43.5 47q26.5 16 57.5 16q49 0 72.5-29q23.5-29 23.5-101l0-435l116 0l0 445q0 61-21 111q-21 50-65.5 80q-44.5 30-115.5 30zm-50-716l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ĵ": [263, "m34 206q-26 0-46-4q-20-4-34-10l22-85q10 3 21 5.5q11 2.5 21 2.5q33 0 44.5-22.5q11.5-22.5 11.5-65.5l0-518l116 0l0 516q0 52-15 93q-15 41-49 64.5q-34 23.5-92 23.5zm-88-776l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ķ": [597, "m83 0l0-654l116 0l0 297l3 0l233-297l129 0l-201 255l235 399l-128 0l-177-308l-94 117l0 191zm153 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ķ": [522, "m73 0l0-706l114 0l0 440l3 0l180-225l127 0l-167 201l184 290l-125 0l-126-213l-76 87l0 126zm117 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ĸ": [522, "m73 0l0-491l115 0l0 228l4 0l179-228l126 0l-166 200l183 291l-125 0l-126-210l-75 89l0 121z"], "Ĺ": [502, "m83 0l0-654l116 0l0 556l272 0l0 98zm-21-704l128-144l133 0l7 12l-170 132z"], "ĺ": [271, "m185 10q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3zm-133-764l128-144l133 0l7 12l-170 132z"], "Ļ": [502, "m83 0l0-654l116 0l0 556l272 0l0 98zm113 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ļ": [271, "m185 10q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3zm-125 223l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "Ľ": [502, "m83 0l0-654l116 0l0 556l272 0l0 98zm260-512l-5-217l77 0l-1 63l-19 154z"], "ľ": [292, "m185 10q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3zm54-558l-5-217l77 0l-1 63l-19 154z"], "Ŀ": [502, "m83 0l0-654l116 0l0 556l272 0l0 98zm311-249q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], "ŀ": [408, "m185 10q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3zm150-259q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], "Ł": [522, "m30-192l-44-86l120-52l94-44l194-88l44 86l-230 100l-94 44zm75 192l0-654l116 0l0 556l272 0l0 98z"], "ł": [329, "m30-286l-44-86l120-52l94-44l94-44l44 86l-130 56l-94 44zm183 296q-41 0-65.5-16.5q-24.5-16.5-35.5-47.5q-11-31-11-74l0-578l115 0l0 584q0 22 8 30q8 8 18 8q4 0 7.5-0.5q3.5-0.5 9.5-1.5l15 86q-10 4-25.5 7q-15.5 3-35.5 3z"], "Ń": [656, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286zm171-704l128-144l133 0l7 12l-170 132z"], "ń": [560, "m73 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343zm149-570l122-174l123 0l7 12l-162 162z"], "Ņ": [656, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286zm161 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ņ": [560, "m73 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343zm115 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "Ň": [656, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286zm195-705l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ň": [560, "m73 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343zm179-570l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "ŉ": [810, "m96-402l-30-57q34-14 54.5-34q20.5-20 30-42q9.5-22 9.5-42q0-10-1.5-16.5q-1.5-6.5-6.5-12.5l18 0q-8 10-23 17q-15 7-31 7q-24 0-45.5-16.5q-21.5-16.5-21.5-47.5q0-33 23.5-52.5q23.5-19.5 55.5-19.5q48 0 79.5 31.5q31.5 31.5 31.5 87.5q0 42-13.5 80q-13.5 38-45 68q-31.5 30-84.5 49zm228 402l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 308l-115 0l0-293q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343z"], "Ŋ": [651, "m409 12q-20 0-45-4.5q-25-4.5-39-12.5l26-100q10 4 20.5 6q10.5 2 24.5 2q24 0 43.5-20q19.5-20 31.5-71q12-51 12-145q0-87-17-137.5q-17-50.5-48.5-72.5q-31.5-22-73.5-22q-24 0-50.5 11q-26.5 11-51.5 31q-25 20-43 47l0 476l-116 0l0-654l113 0l0 76q24-27 53-46.5q29-19.5 61.5-30.5q32.5-11 65.5-11q65 0 116 32.5q51 32.5 80.5 105.5q29.5 73 29.5 195q0 121-22 197.5q-22 76.5-65 112q-43 35.5-106 35.5z"], "ŋ": [560, "m336 206q-25 0-45-4q-20-4-34-10l21-85q10 3 21 5.5q11 2.5 21 2.5q33 0 45-22.5q12-22.5 12-65.5l0-320q0-61-18-86q-18-25-59-25q-32 0-56.5 15.5q-24.5 15.5-55.5 45.5l0 343l-115 0l0-491l95 0l8 66l4 0q33-32 72-55q39-23 89-23q79 0 115 51q36 51 36 144l0 333q0 52-14.5 93q-14.5 41-48.5 64.5q-34 23.5-93 23.5z"], "Ō": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-144-639l0-76l288 0l0 76z"], "ō": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-140-514l0-76l280 0l0 76z"], "Ŏ": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm0-613q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ŏ": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm0-487q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Ő": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5zm-150-615l97-144l102 0l7 12l-132 132zm192 0l97-144l102 0l7 12l-132 132z"], "ő": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20zm-126-488l80-174l91 0l7 12l-114 162zm168 0l80-174l91 0l7 12l-114 162z"], "Œ": [859, "m371 0q-96 0-168.5-37q-72.5-37-113-110.5q-40.5-73.5-40.5-182.5q0-108 40.5-180q40.5-72 114.5-108q74-36 173-36l421 0l0 98l-262 0l0 167l220 0l0 98l-220 0l0 193l272 0l0 98zm13-94l36 0l0-466l-36 0q-67 0-115.5 24q-48.5 24-74.5 74.5q-26 50.5-26 131.5q0 81 26 133q26 52 74.5 77.5q48.5 25.5 115.5 25.5z"], "œ": [830, "m264 12q-60 0-111-30.5q-51-30.5-82-88q-31-57.5-31-138.5q0-82 31.5-139.5q31.5-57.5 82.5-88q51-30.5 110-30.5q59 0 103.5 27.5q44.5 27.5 68.5 75.5q26-50 68.5-76.5q42.5-26.5 93.5-26.5q64 0 107.5 30.5q43.5 30.5 66 83.5q22.5 53 22.5 121q0 18-1 32.5q-1 14.5-3 25.5l-300 0q4 40 22 69q18 29 46 45q28 16 62 16q32 0 61-9.5q29-9.5 53-24.5l40 74q-33 24-76.5 38q-43.5 14-81.5 14q-57 0-103-26.5q-46-26.5-75-77.5q-28 51-71.5 77.5q-43.5 26.5-102.5 26.5zm4-96q34 0 58.5-20q24.5-20 38-56.5q13.5-36.5 13.5-84.5q0-50-13.5-86.5q-13.5-36.5-38-56.5q-24.5-20-58.5-20q-34 0-58.5 20q-24.5 20-38 56.5q-13.5 36.5-13.5 86.5q0 48 13.5 84.5q13.5 36.5 38 56.5q24.5 20 58.5 20zm222-214l202 0q0-53-25-83.5q-25-30.5-73-30.5q-26 0-48 14.5q-22 14.5-37 40q-15 25.5-19 59.5z"], "Ŕ": [592, "m83 0l0-654l221 0q68 0 122 18q54 18 86 60.5q32 42.5 32 115.5q0 70-32 115q-32 45-86 67q-54 22-122 22l-105 0l0 256zm116-348l93 0q67 0 102.5-28q35.5-28 35.5-84q0-56-35.5-78.5q-35.5-22.5-102.5-22.5l-93 0zm241 348l-158-287l84-69l204 356zm-220-704l128-144l133 0l7 12l-170 132z"], "ŕ": [373, "m73 0l0-491l95 0l8 87l4 0q26-48 62.5-73.5q36.5-25.5 76.5-25.5q19 0 32 2q13 2 24 8l-23 98q-12-3-22-4.5q-10-1.5-26-1.5q-29 0-61 22.5q-32 22.5-55 78.5l0 300zm81-570l122-174l123 0l7 12l-162 162z"], "Ŗ": [592, "m83 0l0-654l221 0q68 0 122 18q54 18 86 60.5q32 42.5 32 115.5q0 70-32 115q-32 45-86 67q-54 22-122 22l-105 0l0 256zm116-348l93 0q67 0 102.5-28q35.5-28 35.5-84q0-56-35.5-78.5q-35.5-22.5-102.5-22.5l-93 0zm241 348l-158-287l84-69l204 356zm-215 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ŗ": [373, "m73 0l0-491l95 0l8 87l4 0q26-48 62.5-73.5q36.5-25.5 76.5-25.5q19 0 32 2q13 2 24 8l-23 98q-12-3-22-4.5q-10-1.5-26-1.5q-29 0-61 22.5q-32 22.5-55 78.5l0 300zm-39 233l-10-50q61-4 83.5-14.5q22.5-10.5 22.5-28.5q0-17-16.5-26.5q-16.5-9.5-51.5-12.5l24-46q73 7 101 26q28 19 28 54q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "Ř": [592, "m83 0l0-654l221 0q68 0 122 18q54 18 86 60.5q32 42.5 32 115.5q0 70-32 115q-32 45-86 67q-54 22-122 22l-105 0l0 256zm116-348l93 0q67 0 102.5-28q35.5-28 35.5-84q0-56-35.5-78.5q-35.5-22.5-102.5-22.5l-93 0zm241 348l-158-287l84-69l204 356zm-196-705l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ř": [373, "m73 0l0-491l95 0l8 87l4 0q26-48 62.5-73.5q36.5-25.5 76.5-25.5q19 0 32 2q13 2 24 8l-23 98q-12-3-22-4.5q-10-1.5-26-1.5q-29 0-61 22.5q-32 22.5-55 78.5l0 300zm111-570l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "Ś": [545, "m274 12q-68 0-128.5-25q-60.5-25-107.5-71l63-76q35 34 81.5 52.5q46.5 18.5 93.5 18.5q56 0 85-23q29-23 29-61q0-27-13-43.5q-13-16.5-35.5-28.5q-22.5-12-52.5-24l-90-39q-32-14-62.5-36.5q-30.5-22.5-50-56q-19.5-33.5-19.5-81.5q0-52 28.5-93.5q28.5-41.5 78-66q49.5-24.5 113.5-24.5q59 0 111.5 21.5q52.5 21.5 89.5 58.5l-61 76q-32-26-67-40.5q-35-14.5-73-14.5q-46 0-74.5 20.5q-28.5 20.5-28.5 56.5q0 25 14.5 41.5q14.5 16.5 39 28q24.5 11.5 50.5 22.5l89 37q39 17 69 40q30 23 46.5 56q16.5 33 16.5 81q0 53-28 97q-28 44-80.5 70.5q-52.5 26.5-126.5 26.5zm-69-716l128-144l133 0l7 12l-170 132z"], "ś": [431, "m210 12q-51 0-100.5-19q-49.5-19-85.5-53l51-66q33 27 67 39q34 12 72 12q40 0 59-17q19-17 19-42q0-20-14.5-34q-14.5-14-37.5-24q-23-10-51-20q-36-13-67-31.5q-31-18.5-50.5-46q-19.5-27.5-19.5-66.5q0-65 48-106q48-41 130-41q50 0 92 16.5q42 16.5 72 42.5l-51 65q-26-19-53-28q-27-9-57-9q-37 0-55 16q-18 16-18 38q0 18 11.5 30.5q11.5 12.5 33.5 22q22 9.5 53 19.5q38 13 71 31.5q33 18.5 52.5 47q19.5 28.5 19.5 71.5q0 42-22 76.5q-22 34.5-64.5 55q-42.5 20.5-104.5 20.5zm-67-582l122-174l123 0l7 12l-162 162z"], "Ŝ": [545, "m274 12q-68 0-128.5-25q-60.5-25-107.5-71l63-76q35 34 81.5 52.5q46.5 18.5 93.5 18.5q56 0 85-23q29-23 29-61q0-27-13-43.5q-13-16.5-35.5-28.5q-22.5-12-52.5-24l-90-39q-32-14-62.5-36.5q-30.5-22.5-50-56q-19.5-33.5-19.5-81.5q0-52 28.5-93.5q28.5-41.5 78-66q49.5-24.5 113.5-24.5q59 0 111.5 21.5q52.5 21.5 89.5 58.5l-61 76q-32-26-67-40.5q-35-14.5-73-14.5q-46 0-74.5 20.5q-28.5 20.5-28.5 56.5q0 25 14.5 41.5q14.5 16.5 39 28q24.5 11.5 50.5 22.5l89 37q39 17 69 40q30 23 46.5 56q16.5 33 16.5 81q0 53-28 97q-28 44-80.5 70.5q-52.5 26.5-126.5 26.5zm-179-716l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ŝ": [431, "m210 12q-51 0-100.5-19q-49.5-19-85.5-53l51-66q33 27 67 39q34 12 72 12q40 0 59-17q19-17 19-42q0-20-14.5-34q-14.5-14-37.5-24q-23-10-51-20q-36-13-67-31.5q-31-18.5-50.5-46q-19.5-27.5-19.5-66.5q0-65 48-106q48-41 130-41q50 0 92 16.5q42 16.5 72 42.5l-51 65q-26-19-53-28q-27-9-57-9q-37 0-55 16q-18 16-18 38q0 18 11.5 30.5q11.5 12.5 33.5 22q22 9.5 53 19.5q38 13 71 31.5q33 18.5 52.5 47q19.5 28.5 19.5 71.5q0 42-22 76.5q-22 34.5-64.5 55q-42.5 20.5-104.5 20.5zm-172-582l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ş": [545, "m274 12q-68 0-128.5-25q-60.5-25-107.5-71l63-76q35 34 81.5 52.5q46.5 18.5 93.5 18.5q56 0 85-23q29-23 29-61q0-27-13-43.5q-13-16.5-35.5-28.5q-22.5-12-52.5-24l-90-39q-32-14-62.5-36.5q-30.5-22.5-50-56q-19.5-33.5-19.5-81.5q0-52 28.5-93.5q28.5-41.5 78-66q49.5-24.5 113.5-24.5q59 0 111.5 21.5q52.5 21.5 89.5 58.5l-61 76q-32-26-67-40.5q-35-14.5-73-14.5q-46 0-74.5 20.5q-28.5 20.5-28.5 56.5q0 25 14.5 41.5q14.5 16.5 39 28q24.5 11.5 50.5 22.5l89 37q39 17 69 40q30 23 46.5 56q16.5 33 16.5 81q0 53-28 97q-28 44-80.5 70.5q-52.5 26.5-126.5 26.5zm-92 221l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ş": [431, "m210 12q-51 0-100.5-19q-49.5-19-85.5-53l51-66q33 27 67 39q34 12 72 12q40 0 59-17q19-17 19-42q0-20-14.5-34q-14.5-14-37.5-24q-23-10-51-20q-36-13-67-31.5q-31-18.5-50.5-46q-19.5-27.5-19.5-66.5q0-65 48-106q48-41 130-41q50 0 92 16.5q42 16.5 72 42.5l-51 65q-26-19-53-28q-27-9-57-9q-37 0-55 16q-18 16-18 38q0 18 11.5 30.5q11.5 12.5 33.5 22q22 9.5 53 19.5q38 13 71 31.5q33 18.5 52.5 47q19.5 28.5 19.5 71.5q0 42-22 76.5q-22 34.5-64.5 55q-42.5 20.5-104.5 20.5zm-88 221l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "Š": [545, "m274 12q-68 0-128.5-25q-60.5-25-107.5-71l63-76q35 34 81.5 52.5q46.5 18.5 93.5 18.5q56 0 85-23q29-23 29-61q0-27-13-43.5q-13-16.5-35.5-28.5q-22.5-12-52.5-24l-90-39q-32-14-62.5-36.5q-30.5-22.5-50-56q-19.5-33.5-19.5-81.5q0-52 28.5-93.5q28.5-41.5 78-66q49.5-24.5 113.5-24.5q59 0 111.5 21.5q52.5 21.5 89.5 58.5l-61 76q-32-26-67-40.5q-35-14.5-73-14.5q-46 0-74.5 20.5q-28.5 20.5-28.5 56.5q0 25 14.5 41.5q14.5 16.5 39 28q24.5 11.5 50.5 22.5l89 37q39 17 69 40q30 23 46.5 56q16.5 33 16.5 81q0 53-28 97q-28 44-80.5 70.5q-52.5 26.5-126.5 26.5zm-45-717l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "š": [431, "m210 12q-51 0-100.5-19q-49.5-19-85.5-53l51-66q33 27 67 39q34 12 72 12q40 0 59-17q19-17 19-42q0-20-14.5-34q-14.5-14-37.5-24q-23-10-51-20q-36-13-67-31.5q-31-18.5-50.5-46q-19.5-27.5-19.5-66.5q0-65 48-106q48-41 130-41q50 0 92 16.5q42 16.5 72 42.5l-51 65q-26-19-53-28q-27-9-57-9q-37 0-55 16q-18 16-18 38q0 18 11.5 30.5q11.5 12.5 33.5 22q22 9.5 53 19.5q38 13 71 31.5q33 18.5 52.5 47q19.5 28.5 19.5 71.5q0 42-22 76.5q-22 34.5-64.5 55q-42.5 20.5-104.5 20.5zm-38-582l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "Ţ": [546, "m215 0l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556zm-41 233l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "ţ": [361, "m246 10q-85 0-120.5-49.5q-35.5-49.5-35.5-128.5l0-232l-70 0l0-86l76-5l14-154l96 0l0 154l125 0l0 91l-125 0l0 232q0 43 17 64.5q17 21.5 52 21.5q13 0 26-2q13-2 25-8l21 81q-19 9-45 15q-26 6-56 6zm-116 223l-10-50q61-4 83.5-15q22.5-11 22.5-32q0-18-16.5-28.5q-16.5-10.5-60.5-16.5l46-94l70 0l-29 65q36 9 55.5 25.5q19.5 16.5 19.5 47.5q0 47-47.5 70.5q-47.5 23.5-133.5 27.5z"], "Ť": [546, "m215 0l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556zm-1-705l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ť": [361, "m246 10q-85 0-120.5-49.5q-35.5-49.5-35.5-128.5l0-232l-70 0l0-86l76-5l14-154l96 0l0 154l125 0l0 91l-125 0l0 232q0 43 17 64.5q17 21.5 52 21.5q13 0 26-2q13-2 25-8l21 81q-19 9-45 15q-26 6-56 6zm22-558l-5-217l77 0l-1 63l-19 154z"], "Ŧ": [546, "m94-282l0-84l92-4l266 0l0 88zm121 282l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556z"], "ŧ": [361, "m20-206l0-82l76-6l236 0l0 88zm226 216q-85 0-120.5-49.5q-35.5-49.5-35.5-128.5l0-232l-70 0l0-86l76-5l14-154l96 0l0 154l125 0l0 91l-125 0l0 232q0 43 17 64.5q17 21.5 52 21.5q13 0 26-2q13-2 25-8l21 81q-19 9-45 15q-26 6-56 6z"], "Ũ": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm72-712q-27 0-47.5-10q-20.5-10-36.5-22.5q-16-12.5-29.5-22q-13.5-9.5-29.5-9.5q-16 0-27.5 13.5q-11.5 13.5-14.5 43.5l-76-6q4-67 35-100q31-33 80-33q27 0 47.5 9.5q20.5 9.5 36.5 22q16 12.5 30 22.5q14 10 29 10q16 0 27.5-14q11.5-14 14.5-44l76 6q-3 66-34.5 100q-31.5 34-80.5 34z"], "ũ": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm128-587q-25 0-44-11q-19-11-34.5-26q-15.5-15-29-26q-13.5-11-28.5-11q-19 0-28.5 17q-9.5 17-12.5 50l-74-4q2-46 15-78q13-32 37-49q24-17 61-17q26 0 44.5 11q18.5 11 34 25.5q15.5 14.5 29.5 26q14 11.5 29 11.5q18 0 27.5-17.5q9.5-17.5 12.5-49.5l74 4q-2 45-14.5 77q-12.5 32-37 49.5q-24.5 17.5-61.5 17.5z"], "Ū": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-145-740l0-76l288 0l0 76z"], "ū": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm-81-608l0-76l280 0l0 76z"], "Ŭ": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-1-714q-48 0-80.5-17q-32.5-17-51-47q-18.5-30-23.5-69l66-11q6 33 28.5 53.5q22.5 20.5 60.5 20.5q38 0 60.5-20.5q22.5-20.5 28.5-53.5l66 11q-4 39-23 69q-19 30-51.5 47q-32.5 17-80.5 17z"], "ŭ": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm59-581q-55 0-90.5-21.5q-35.5-21.5-53-57q-17.5-35.5-19.5-75.5l68-11q4 23 15 44q11 21 31 34q20 13 49 13q30 0 49.5-13q19.5-13 30.5-34q11-21 15-44l68 11q-2 40-19.5 75.5q-17.5 35.5-52.5 57q-35 21.5-91 21.5z"], "Ů": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-1-710q-56 0-89-25.5q-33-25.5-33-69.5q0-43 33-68.5q33-25.5 89-25.5q57 0 89.5 25.5q32.5 25.5 32.5 69.5q0 43-32.5 68.5q-32.5 25.5-89.5 25.5zm0-44q22 0 36-13.5q14-13.5 14-36.5q0-24-14-37q-14-13-36-13q-22 0-36 13q-14 13-14 37q0 23 14 36.5q14 13.5 36 13.5z"], "ů": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm59-571q-58 0-89.5-29.5q-31.5-29.5-31.5-72.5q0-43 31.5-72q31.5-29 89.5-29q58 0 89.5 29q31.5 29 31.5 72q0 43-31.5 72.5q-31.5 29.5-89.5 29.5zm0-46q21 0 35.5-15.5q14.5-15.5 14.5-40.5q0-25-14.5-40q-14.5-15-35.5-15q-21 0-35.5 15q-14.5 15-14.5 41q0 24 14.5 39.5q14.5 15.5 35.5 15.5z"], "Ű": [655, "m328 12q-57 0-102.5-16q-45.5-16-78-51q-32.5-35-50-91q-17.5-56-17.5-135l0-373l116 0l0 382q0 69 16.5 109q16.5 40 46.5 57q30 17 69 17q40 0 70.5-17q30.5-17 48-57q17.5-40 17.5-109l0-382l111 0l0 373q0 79-17 135q-17 56-49.5 91q-32.5 35-78 51q-45.5 16-102.5 16zm-151-716l97-144l102 0l7 12l-132 132zm192 0l97-144l102 0l7 12l-132 132z"], "ű": [556, "m219 12q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 61 18 86q18 25 58 25q32 0 56.5-16q24.5-16 52.5-52l0-336l115 0l0 491l-94 0l-9-72l-3 0q-32 38-70 61q-38 23-88 23zm-67-582l80-174l91 0l7 12l-114 162zm168 0l80-174l91 0l7 12l-114 162z"], "Ų": [655, "m343 222q-49 0-83-24q-34-24-34-71q0-40 24.5-75q24.5-35 52.5-55l25 15q-56 0-102-17q-46-17-78.5-52q-32.5-35-50-92.5q-17.5-57.5-17.5-137.5l0-367l116 0l0 376q0 72 16.5 114q16.5 42 46.5 60q30 18 69 18q40 0 70.5-18q30.5-18 48-60q17.5-42 17.5-114l0-376l111 0l0 367q0 89-20.5 149q-20.5 60-61 95q-40.5 35-101.5 52q-23 6-39.5 20q-16.5 14-25.5 31.5q-9 17.5-9 34.5q0 23 14.5 33.5q14.5 10.5 35.5 10.5q14 0 26-5q12-5 21-11l29 65q-18 14-46 24q-28 10-55 10z"], "ų": [556, "m427 217q-45 0-77.5-24q-32.5-24-32.5-73q0-27 11.5-50.5q11.5-23.5 28.5-41.5q17-18 33-29l-10-71l-3 0q-33 38-70.5 61q-37.5 23-87.5 23q-79 0-115-51q-36-51-36-144l0-308l115 0l0 293q0 60 18 85.5q18 25.5 58 25.5q33 0 57-16q24-16 52-52l0-336l115 0l0 491q-40 14-59.5 42q-19.5 28-19.5 53q0 22 14.5 32.5q14.5 10.5 31.5 10.5q15 0 26.5-4q11.5-4 22.5-11l26 61q-18 14-44.5 23.5q-26.5 9.5-53.5 9.5z"], "Ŵ": [800, "m144 0l-126-654l124 0l56 330q8 52 15 104.5q7 52.5 13 109.5l4 0q9-57 19-109.5q10-52.5 21-104.5l76-330l114 0l74 330q11 51 22 104q11 53 20 110l4 0q6-57 13.5-109.5q7.5-52.5 14.5-104.5l56-330l118 0l-126 654l-154 0l-74-344q-7-36-13.5-74.5q-6.5-38.5-12.5-83.5l-4 0q-4 45-10 83.5q-6 38.5-14 74.5l-76 344zm64-704l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ŵ": [748, "m154 0l-130-491l118 0l58 255q8 33 14 67.5q6 34.5 11 78.5l4 0q7-44 13.5-78.5q6.5-34.5 13.5-67.5l60-255l120 0l62 255q8 33 15 67.5q7 34.5 14 78.5l4 0q7-44 12.5-78.5q5.5-34.5 12.5-67.5l58-255l110 0l-125 491l-147 0l-50-228q-7-33-13.5-66.5q-6.5-33.5-12.5-81.5l-4 0q-6 48-12 81.5q-6 33.5-14 66.5l-50 228zm34-570l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ŷ": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243zm-134-704l134-144l116 0l134 144l-92 0l-98-76l-4 0l-98 76z"], "ŷ": [495, "m106 202q-20 0-35.5-3q-15.5-3-28.5-9l22-86q10 3 18 4q8 1 16 1q39 0 62.5-24q23.5-24 35.5-60l9-31l-193-485l117 0l85 241q11 32 21.5 67.5q10.5 35.5 21.5 70.5l4 0q9-34 18.5-69.5q9.5-35.5 18.5-68.5l74-241l111 0l-178 513q-20 55-46 95.5q-26 40.5-63 62.5q-37 22-90 22zm-38-772l134-174l104 0l134 174l-90 0l-94-94l-4 0l-94 94z"], "Ÿ": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243zm-49-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Ź": [540, "m40 0l0-70l316-486l-287 0l0-98l431 0l0 70l-317 486l319 0l0 98zm160-704l128-144l133 0l7 12l-170 132z"], "ź": [443, "m34 0l0-62l232-338l-206 0l0-91l350 0l0 61l-231 338l239 0l0 92zm122-570l122-174l123 0l7 12l-162 162z"], "Ż": [540, "m40 0l0-70l316-486l-287 0l0-98l431 0l0 70l-317 486l319 0l0 98zm242-707q-30 0-50.5-19q-20.5-19-20.5-47q0-29 20.5-47q20.5-18 50.5-18q31 0 51 18q20 18 20 47q0 28-20 47q-20 19-51 19z"], "ż": [443, "m34 0l0-62l232-338l-206 0l0-91l350 0l0 61l-231 338l239 0l0 92zm204-577q-30 0-49.5-18q-19.5-18-19.5-48q0-30 19.5-47.5q19.5-17.5 49.5-17.5q31 0 50 17.5q19 17.5 19 47.5q0 30-19 48q-19 18-50 18z"], "Ž": [540, "m40 0l0-70l316-486l-287 0l0-98l431 0l0 70l-317 486l319 0l0 98zm184-705l-134-143l92 0l98 71l4 0l98-71l92 0l-134 143z"], "ž": [443, "m34 0l0-62l232-338l-206 0l0-91l350 0l0 61l-231 338l239 0l0 92zm152-570l-134-174l90 0l94 94l4 0l94-94l90 0l-134 174z"], "ſ": [292, "m93 0l0-542q0-51 16.5-91q16.5-40 52.5-62.5q36-22.5 94-22.5q27 0 50.5 5q23.5 5 39.5 12l-22 85q-29-11-54-11q-30 0-46 20q-16 20-16 63l0 544zm-66-400l0-86l72-5l93 0l0 91z"], "Α": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91z"], "Β": [597, "m83 0l0-654l209 0q68 0 120.5 15.5q52.5 15.5 83 50.5q30.5 35 30.5 95q0 50-23.5 88.5q-23.5 38.5-67.5 53.5l0 4q58 12 91.5 48.5q33.5 36.5 33.5 101.5q0 67-32.5 111q-32.5 44-89.5 65q-57 21-129 21zm116-384l83 0q68 0 99-25q31-25 31-67q0-48-32-68q-32-20-96-20l-85 0zm0 294l98 0q72 0 111-26.5q39-26.5 39-81.5q0-52-38-75.5q-38-23.5-112-23.5l-98 0z"], "Γ": [510, "m83 0l0-654l395 0l0 98l-279 0l0 556z"], "Δ": [614, "m32 0l0-70l207-584l137 0l206 584l0 70zm125-98l298 0l-85-259l-63-203l-4 0l-62 203z"], "Ε": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98z"], "Ζ": [540, "m40 0l0-70l316-486l-287 0l0-98l431 0l0 70l-317 486l319 0l0 98z"], "Η": [663, "m83 0l0-654l116 0l0 263l265 0l0-263l116 0l0 654l-116 0l0-290l-265 0l0 290z"], "Θ": [674, "m232-290l0-101l210 0l0 101zm105 302q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-105 36.5-180.5q36.5-75.5 101.5-115.5q65-40 150-40q85 0 150 40q65 40 102 115.5q37 75.5 37 180.5q0 106-37 182.5q-37 76.5-102 118q-65 41.5-150 41.5zm0-101q52 0 90-29.5q38-29.5 58.5-83.5q20.5-54 20.5-128q0-73-20.5-125.5q-20.5-52.5-58.5-81q-38-28.5-90-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 74 21 128q21 54 59 83.5q38 29.5 89 29.5z"], "Ι": [282, "m83 0l0-654l116 0l0 654z"], "Κ": [597, "m83 0l0-654l116 0l0 297l3 0l233-297l129 0l-201 255l235 399l-128 0l-177-308l-94 117l0 191z"], "Λ": [536, "m-4 0l203-654l137 0l204 654l-123 0l-92-329q-16-56-28.5-106.5q-12.5-50.5-29.5-106.5l-4 0q-16 56-29 106.5q-13 50.5-28 106.5l-91 329z"], "Μ": [745, "m83 0l0-654l139 0l112 320q11 31 20 61.5q9 30.5 18 66.5l4 0q9-36 17.5-66.5q8.5-30.5 18.5-61.5l112-320l138 0l0 654l-107 0l0-298q0-31 2.5-71q2.5-40 6.5-79.5q4-39.5 8-69.5l-4 0l-52 166l-106 292l-78 0l-106-292l-50-166l-4 0q4 30 7.5 69.5q3.5 39.5 6 79.5q2.5 40 2.5 71l0 298z"], "Ν": [656, "m83 0l0-654l127 0l196 360q18 33 34.5 71q16.5 38 31.5 77l4 0q-4-53-9-110.5q-5-57.5-5-111.5l0-286l111 0l0 654l-127 0l-196-360q-18-33-35.5-71q-17.5-38-32.5-77l-4 0q6 51 11 108.5q5 57.5 5 113.5l0 286z"], "Ξ": [552, "m51 0l0-98l451 0l0 98zm71-291l0-98l308 0l0 98zm-61-265l0-98l431 0l0 98z"], "Ο": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5z"], "Π": [654, "m83 0l0-654l488 0l0 654l-116 0l0-556l-256 0l0 556z"], "Ρ": [582, "m83 0l0-654l206 0q73 0 130 19q57 19 90 63q33 44 33 120q0 72-32.5 119q-32.5 47-89 70q-56.5 23-127.5 23l-94 0l0 240zm116-333l85 0q73 0 108.5-30q35.5-30 35.5-89q0-62-37.5-85.5q-37.5-23.5-110.5-23.5l-81 0z"], "Σ": [544, "m41 0l0-70l213-261l-210-253l0-70l436 0l0 98l-290 0l181 222l-184 236l321 0l0 98z"], "Τ": [546, "m215 0l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556z"], "Υ": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243z"], "Φ": [740, "m350-67q-90 0-158.5-31q-68.5-31-106-90q-37.5-59-37.5-142q0-83 37.5-140.5q37.5-57.5 106-87.5q68.5-30 158.5-30l40 0q90 0 158 30q68 30 106 87.5q38 57.5 38 140.5q0 83-38 142q-38 59-106 90q-68 31-158 31zm-6-88l52 0q56 0 97.5-21.5q41.5-21.5 64.5-61q23-39.5 23-92.5q0-52-23-90.5q-23-38.5-64.5-59q-41.5-20.5-97.5-20.5l-52 0q-56 0-97.5 20.5q-41.5 20.5-64.5 59q-23 38.5-23 90.5q0 53 23 92.5q23 39.5 64.5 61q41.5 21.5 97.5 21.5zm-26 177l0-698l104 0l0 698z"], "Χ": [541, "m13 0l186-337l-174-317l129 0l72 145q13 22 24 46q11 24 26 54l4 0q12-30 22.5-54q10.5-24 21.5-46l69-145l123 0l-174 322l186 332l-129 0l-80-154q-13-26-25.5-51.5q-12.5-25.5-27.5-55.5l-4 0q-12 30-24 55.5q-12 25.5-24 51.5l-78 154z"], "Ψ": [726, "m340-231q-88 0-151-27q-63-27-97-85q-34-58-34-150l0-161l113 0l0 155q0 65 18.5 103.5q18.5 38.5 55 55.5q36.5 17 89.5 17l58 0q53 0 89.5-17q36.5-17 54.5-55.5q18-38.5 18-103.5l0-155l114 0l0 161q0 92-34 150q-34 58-97.5 85q-63.5 27-150.5 27zm-32 231l0-654l109 0l0 654z"], "Ω": [695, "m45 0l0-94l120 0l0-4q-25-25-49.5-62q-24.5-37-40.5-86q-16-49-16-108q0-92 36-162q36-70 101-110q65-40 152-40q86 0 151 40q65 40 101 110q36 70 36 162q0 59-16 108q-16 49-40.5 86q-24.5 37-49.5 62l0 4l120 0l0 94l-250 0l0-84q36-30 62-68q26-38 40.5-85.5q14.5-47.5 14.5-106.5q0-64-20-114q-20-50-58-78.5q-38-28.5-91-28.5q-53 0-91 28.5q-38 28.5-58.5 78.5q-20.5 50-20.5 114q0 59 14.5 106.5q14.5 47.5 41 85.5q26.5 38 61.5 68l0 84z"], "Ϊ": [282, "m83 0l0-654l116 0l0 654zm-48-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "Ϋ": [501, "m192 0l0-243l-196-411l124 0l71 167q14 37 28 71.5q14 34.5 30 72.5l4 0q16-38 31-72.5q15-34.5 29-71.5l71-167l121 0l-197 411l0 243zm-49-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "ά": [578, "m234 12q-87 0-140-66q-53-66-53-186q0-83 30.5-142q30.5-59 79.5-90q49-31 106-31q29 0 56 11q27 11 49.5 36q22.5 25 37.5 66l4 0l18-101l114 0q-10 45-21 95.5q-11 50.5-20.5 100q-9.5 49.5-15.5 92q-6 42.5-6 73.5q0 25 14 36.5q14 11.5 34 11.5q8 0 16.5-2q8.5-2 16.5-5l15 86q-12 6-31 10.5q-19 4.5-44 4.5q-48 0-77-21.5q-29-21.5-35-68.5l-4 0q-52 90-144 90zm26-95q27 0 51.5-17.5q24.5-17.5 41-47q16.5-29.5 18.5-64.5l7-88q-12-41-28.5-64.5q-16.5-23.5-35.5-33.5q-19-10-41-10q-29 0-55 18q-26 18-42.5 55q-16.5 37-16.5 94q0 78 27.5 118q27.5 40 73.5 40zm-22-483l36-200l115 0l7 12l-76 188z"], "έ": [460, "m260 12q-62 0-111.5-17.5q-49.5-17.5-78-49.5q-28.5-32-28.5-77q0-54 29.5-85q29.5-31 72.5-41l0-4q-40-14-59-43.5q-19-29.5-19-62.5q0-46 27.5-76q27.5-30 72-44.5q44.5-14.5 96.5-14.5q45 0 88.5 13.5q43.5 13.5 77.5 39.5l-44 74q-27-20-55.5-29q-28.5-9-60.5-9q-40 0-65 15.5q-25 15.5-25 44.5q0 27 22.5 42.5q22.5 15.5 67.5 15.5q15 0 31.5-1.5q16.5-1.5 34.5-2.5l0 94q-19-2-37-3q-18-1-35-1q-55 0-81.5 15q-26.5 15-26.5 47q0 33 30.5 51.5q30.5 18.5 86.5 18.5q29 0 60-10q31-10 63-34l46 74q-46 34-88 47q-42 13-92 13zm-58-578l36-200l115 0l7 12l-76 188z"], "ή": [552, "m368 178q1-59 3-122q2-63 2.5-125q0.5-62 1.5-119.5q1-57.5 1-104.5q0-61-15.5-86q-15.5-25-53.5-25q-22 0-41 9q-19 9-37.5 28.5q-18.5 19.5-40.5 52.5l0 314l-115 0l0-348q0-30-1.5-67q-1.5-37-7.5-76l104 0l8 93l4 0q34-49 73.5-77q39.5-28 91.5-28q75 0 107 51q32 51 32 144l0 486zm-123-744l36-200l115 0l7 12l-76 188z"], "ί": [282, "m191 10q-45 0-70.5-16.5q-25.5-16.5-36.5-48.5q-11-32-11-75l0-361l117 0q-2 62-4 128q-2 66-3 127.5q-1 61.5-1 111.5q0 22 9.5 31q9.5 9 27.5 9q7 0 15-1.5q8-1.5 16-4.5l14 86q-14 6-30.5 10q-16.5 4-42.5 4zm-115-576l36-200l115 0l7 12l-76 188z"], "ΰ": [521, "m254 12q-66 0-110-24q-44-24-65.5-70q-21.5-46-21.5-108q0-40 2-79.5q2-39.5 2-78.5q0-30-1.5-67q-1.5-37-8.5-76l112 0q5 25 6.5 54.5q1.5 29.5 1.5 63.5q0 36-3 90q-3 54-3 101q0 35 12.5 57q12.5 22 33 32.5q20.5 10.5 44.5 10.5q31 0 53.5-17.5q22.5-17.5 35-54q12.5-36.5 12.5-93.5q0-52-7.5-108q-7.5-56-28.5-123l112-25q19 61 29.5 124.5q10.5 63.5 10.5 126.5q0 84-26 143q-26 59-75 90q-49 31-117 31zm-126-591q-25 0-41-17q-16-17-16-40q0-25 16-41.5q16-16.5 41-16.5q26 0 42 16.5q16 16.5 16 41.5q0 23-16 40q-16 17-42 17zm252 0q-25 0-41.5-17q-16.5-17-16.5-40q0-25 16.5-41.5q16.5-16.5 41.5-16.5q25 0 41 16.5q16 16.5 16 41.5q0 23-16 40q-16 17-41 17zm-174 12l36-201l85 0l7 12l-76 189z"], "α": [578, "m234 12q-87 0-140-66q-53-66-53-186q0-83 30.5-142q30.5-59 79.5-90q49-31 106-31q29 0 56 11q27 11 49.5 36q22.5 25 37.5 66l4 0l18-101l114 0q-10 45-21 95.5q-11 50.5-20.5 100q-9.5 49.5-15.5 92q-6 42.5-6 73.5q0 25 14 36.5q14 11.5 34 11.5q8 0 16.5-2q8.5-2 16.5-5l15 86q-12 6-31 10.5q-19 4.5-44 4.5q-48 0-77-21.5q-29-21.5-35-68.5l-4 0q-52 90-144 90zm26-95q27 0 51.5-17.5q24.5-17.5 41-47q16.5-29.5 18.5-64.5l7-88q-12-41-28.5-64.5q-16.5-23.5-35.5-33.5q-19-10-41-10q-29 0-55 18q-26 18-42.5 55q-16.5 37-16.5 94q0 78 27.5 118q27.5 40 73.5 40z"], "β": [583, "m72 178l0-656q0-69 23-123q23-54 71-85.5q48-31.5 122-31.5q51 0 96.5 19q45.5 19 74.5 58.5q29 39.5 29 99.5q0 52-23.5 91.5q-23.5 39.5-66.5 66.5l0 4q43 7 75.5 32q32.5 25 51.5 63.5q19 38.5 19 87.5q0 69-28.5 115.5q-28.5 46.5-73 69.5q-44.5 23-93.5 23q-43 0-87-15q-44-15-82-55q3 60 4.5 118q1.5 58 3.5 118zm246-261q30 0 55.5-14q25.5-14 41-41q15.5-27 15.5-66q0-48-28.5-81q-28.5-33-85.5-33q-24 0-45 6l-15-86q44-8 71-28q27-20 38.5-47.5q11.5-27.5 11.5-57.5q0-48-26.5-72q-26.5-24-62.5-24q-49 0-76.5 41.5q-27.5 41.5-28.5 117.5q-2 80-2.5 158.5q-0.5 78.5-0.5 158.5q32 41 68.5 54.5q36.5 13.5 69.5 13.5z"], "γ": [509, "m190 178q3-22 4-39.5q1-17.5 1.5-38q0.5-20.5 0.5-51.5q0-53-15.5-122q-15.5-69-43-142q-27.5-73-62-141.5q-34.5-68.5-73.5-120.5l117-26q20 28 40.5 68.5q20.5 40.5 40.5 89.5q20 49 37 103.5q17 54.5 29 109.5l4 0q28-57 50.5-115q22.5-58 36.5-119q14-61 19-125l114 0q-10 62-24 118q-14 56-35.5 111.5q-21.5 55.5-53.5 117q-32 61.5-79 135.5q7 45 9 95q2 50 2 92z"], "δ": [540, "m271 12q-62 0-113-27.5q-51-27.5-81.5-80.5q-30.5-53-30.5-128q0-47 16.5-88q16.5-41 44.5-73q28-32 62-50.5q34-18.5 68-20.5l54 64q-38 2-68.5 25.5q-30.5 23.5-48.5 60.5q-18 37-18 80q0 46 15.5 78.5q15.5 32.5 42 49q26.5 16.5 60.5 16.5q34 0 59-16.5q25-16.5 38-48.5q13-32 13-78q0-49-17-85q-17-36-48-61.5q-31-25.5-73-45.5q-41-19-76-46q-35-27-56.5-61.5q-21.5-34.5-21.5-76.5q0-49 41.5-83q41.5-34 129.5-34q50 0 105 10.5q55 10.5 110 30.5l-27 86q-57-20-104-30.5q-47-10.5-85-10.5q-32 0-47 11q-15 11-15 30q0 27 39 57q39 30 101 64q51 27 86 60q35 33 52.5 78q17.5 45 17.5 107q0 71-27 124q-27 53-77.5 83q-50.5 30-120.5 30z"], "ε": [460, "m260 12q-62 0-111.5-17.5q-49.5-17.5-78-49.5q-28.5-32-28.5-77q0-54 29.5-85q29.5-31 72.5-41l0-4q-40-14-59-43.5q-19-29.5-19-62.5q0-46 27.5-76q27.5-30 72-44.5q44.5-14.5 96.5-14.5q45 0 88.5 13.5q43.5 13.5 77.5 39.5l-44 74q-27-20-55.5-29q-28.5-9-60.5-9q-40 0-65 15.5q-25 15.5-25 44.5q0 27 22.5 42.5q22.5 15.5 67.5 15.5q15 0 31.5-1.5q16.5-1.5 34.5-2.5l0 94q-19-2-37-3q-18-1-35-1q-55 0-81.5 15q-26.5 15-26.5 47q0 33 30.5 51.5q30.5 18.5 86.5 18.5q29 0 60-10q31-10 63-34l46 74q-46 34-88 47q-42 13-92 13z"], "ζ": [445, "m374 186l-90-33q24-30 35.5-49q11.5-19 11.5-38q0-15-8.5-24.5q-8.5-9.5-31-17q-22.5-7.5-63.5-16.5q-48-10-90-33.5q-42-23.5-68-71q-26-47.5-26-128.5q0-40 13.5-82.5q13.5-42.5 38-85.5q24.5-43 56.5-84.5q32-41.5 69-77.5q37-36 76-67q-24 1-64 1.5q-40 0.5-83 2q-43 1.5-74 3.5l0-91l349 0l0 91l-5 0q-38 25-75.5 60.5q-37.5 35.5-70 76.5q-32.5 41-58 84.5q-25.5 43.5-39.5 85q-14 41.5-14 77.5q0 49 14 78q14 29 43.5 45.5q29.5 16.5 74.5 24.5q72 15 105 40q33 25 33 79q0 24-13.5 64.5q-13.5 40.5-45.5 85.5z"], "η": [552, "m368 178q1-59 3-122q2-63 2.5-125q0.5-62 1.5-119.5q1-57.5 1-104.5q0-61-15.5-86q-15.5-25-53.5-25q-22 0-41 9q-19 9-37.5 28.5q-18.5 19.5-40.5 52.5l0 314l-115 0l0-348q0-30-1.5-67q-1.5-37-7.5-76l104 0l8 93l4 0q34-49 73.5-77q39.5-28 91.5-28q75 0 107 51q32 51 32 144l0 486z"], "θ": [536, "m268 12q-98 0-156-90q-58-90-58-278q0-120 26.5-201q26.5-81 74.5-121q48-40 113-40q65 0 113 40.5q48 40.5 74.5 121q26.5 80.5 26.5 200.5q0 188-58 278q-58 90-156 90zm0-94q29 0 52-24q23-24 36.5-84q13.5-60 13.5-166q0-77-7.5-128.5q-7.5-51.5-21.5-82.5q-14-31-32.5-44q-18.5-13-40.5-13q-22 0-40.5 13q-18.5 13-32.5 44q-14 31-21.5 82.5q-7.5 51.5-7.5 128.5q0 106 13.5 166q13.5 60 36.5 84q23 24 52 24zm-152-230l0-88l304 0l0 88z"], "ι": [282, "m191 10q-45 0-70.5-16.5q-25.5-16.5-36.5-48.5q-11-32-11-75l0-361l117 0q-2 62-4 128q-2 66-3 127.5q-1 61.5-1 111.5q0 22 9.5 31q9.5 9 27.5 9q7 0 15-1.5q8-1.5 16-4.5l14 86q-14 6-30.5 10q-16.5 4-42.5 4z"], "κ": [520, "m73 0l0-348q0-30-1.5-68.5q-1.5-38.5-8.5-74.5l114 0q5 21 7 52.5q2 31.5 2 65.5l0 122l4 0q38-62 82.5-115.5q44.5-53.5 95.5-90q51-36.5 106-46.5l10 108q-40 11-79 36q-39 25-82 68q-43 43-96 107q-25 28-35 66.5q-10 38.5-10 90.5l0 27zm323 10q-24-29-49.5-66.5q-25.5-37.5-50.5-81.5q-25-44-49-90l75-74q24 49 58 104q34 55 71.5 107q37.5 52 73.5 91z"], "λ": [524, "m138 10l-124-10l213-497l-5-18q-14-52-40-79q-26-27-62-27q-22 0-37 4.5q-15 4.5-30 11.5l-26-94q21-9 44.5-14q23.5-5 61.5-5q53 0 91 22.5q38 22.5 65.5 69q27.5 46.5 48.5 117.5l180 509l-123 0l-115-368l-4 0z"], "μ": [578, "m73 178l0-669l115 0l0 293q0 58 18 84.5q18 26.5 57 26.5q20 0 37.5-6.5q17.5-6.5 34.5-24q17-17.5 35-48.5l0-325l116 0q-2 62-4 128q-2 66-3 127.5q-1 61.5-1 111.5q0 22 11 31q11 9 29 9q7 0 15-1.5q8-1.5 15-4.5l15 86q-14 6-30.5 10q-16.5 4-42.5 4q-47 0-73.5-21.5q-26.5-21.5-34.5-64.5l-4 0q-22 42-52.5 63q-30.5 21-66.5 21q-24 0-43.5-6.5q-19.5-6.5-34.5-27.5q0 42 1 74.5q1 32.5 2.5 62.5q1.5 30 5.5 67z"], "ν": [499, "m188 0q-17-91-45-177q-28-86-64-162.5q-36-76.5-77-137.5l117-26q23 36 44.5 84q21.5 48 40.5 100.5q19 52.5 33.5 104.5q14.5 52 23.5 96l4 0q27-59 48-122q21-63 34-126.5q13-63.5 19-124.5l114 0q-14 86-36 164.5q-22 78.5-57.5 158q-35.5 79.5-88.5 168.5z"], "ξ": [450, "m380 186l-91-33q24-30 35.5-49q11.5-19 11.5-38q0-15-8.5-24.5q-8.5-9.5-31-17.5q-22.5-8-63.5-16q-51-11-93.5-32q-42.5-21-68-59.5q-25.5-38.5-25.5-101.5q0-45 19.5-83q19.5-38 52-65q32.5-27 71.5-39l0-4q-44-18-70.5-54q-26.5-36-26.5-84q0-34 15.5-62.5q15.5-28.5 43.5-45.5q-23 1-41.5 1.5q-18.5 0.5-38.5 2q-20 1.5-49 3.5l0-91l400 0l0 91l-108 0q-29 0-53 12.5q-24 12.5-38.5 36q-14.5 23.5-14.5 55.5q0 31 16 53.5q16 22.5 41.5 35q25.5 12.5 53.5 12.5q19 0 31.5-1q12.5-1 31.5-5l0 100q-21-4-38.5-5q-17.5-1-37.5-1q-37 0-69.5 14.5q-32.5 14.5-52.5 42q-20 27.5-20 66.5q0 38 17.5 60.5q17.5 22.5 49 35q31.5 12.5 75.5 20.5q51 9 80 23q29 14 40.5 37q11.5 23 11.5 59q0 24-13.5 64.5q-13.5 40.5-44.5 85.5z"], "ο": [544, "m272 12q-62 0-114.5-30q-52.5-30-84.5-87.5q-32-57.5-32-139.5q0-82 32-139.5q32-57.5 84.5-88q52.5-30.5 114.5-30.5q62 0 114.5 30.5q52.5 30.5 84.5 88q32 57.5 32 139.5q0 82-32 139.5q-32 57.5-84.5 87.5q-52.5 30-114.5 30zm0-94q55 0 84-44.5q29-44.5 29-118.5q0-50-13-87q-13-37-38-57q-25-20-62-20q-37 0-62 20q-25 20-38 57q-13 37-13 87q0 74 29 118.5q29 44.5 84 44.5z"], "π": [611, "m506 10q-48 0-76-17.5q-28-17.5-40.5-50q-12.5-32.5-12.5-78.5q0-15 0.5-44q0.5-29 1-67q0.5-38 1-77.5q0.5-39.5 1.5-74.5l-143 0q0 95-8.5 200.5q-8.5 105.5-18.5 205.5l-116-7q17-101 26-205q9-104 9-194l-110 0l0-87l72-5l495 0l0 92l-96 0q-1 37-2.5 78.5q-1.5 41.5-2 80q-0.5 38.5-1 68q-0.5 29.5-0.5 42.5q0 25 12 35.5q12 10.5 35 10.5q6 0 15.5-1.5q9.5-1.5 20.5-2.5l14 86q-13 4-32.5 8q-19.5 4-43.5 4z"], "ρ": [559, "m69 178l0-421q0-89 30.5-146.5q30.5-57.5 81.5-85.5q51-28 114-28q105 0 163 66q58 66 58 184q0 84-29 143q-29 59-75.5 90.5q-46.5 31.5-98.5 31.5q-35 0-70-13.5q-35-13.5-65-48.5q1 41 2.5 78q1.5 37 2.5 73.5q1 36.5 3 76.5zm219-261q30 0 55-19q25-19 40-56.5q15-37.5 15-93.5q0-49-11.5-84q-11.5-35-35-53.5q-23.5-18.5-60.5-18.5q-31 0-56.5 18.5q-25.5 18.5-41 54q-15.5 35.5-15.5 86.5l0 113q29 33 56 43q27 10 54 10z"], "ς": [439, "m333 183l-92-32q24-31 37.5-53q13.5-22 13.5-42q0-26-13-42.5q-13-16.5-50-27.5q-34-12-68-29.5q-34-17.5-60.5-44.5q-26.5-27-43-68q-16.5-41-16.5-100q0-78 32-133.5q32-55.5 85-84.5q53-29 115-29q48 0 83 15.5q35 15.5 61 39.5l-56 75q-19-18-38-27q-19-9-43-9q-36 0-63 19q-27 19-42.5 53.5q-15.5 34.5-15.5 80.5q0 46 15.5 74.5q15.5 28.5 42.5 45.5q27 17 61 28q43 15 68.5 31.5q25.5 16.5 36.5 41q11 24.5 11 63.5q0 26-14.5 68q-14.5 42-46.5 87z"], "σ": [560, "m268 12q-62 0-113.5-29q-51.5-29-82.5-85.5q-31-56.5-31-137.5q0-86 33-141.5q33-55.5 86-82.5q53-27 113-27l275 0l0 96q-41-4-74.5-6.5q-33.5-2.5-72.5-3.5l0 4q41 23 63.5 69q22.5 46 22.5 109q0 73-28.5 126q-28.5 53-78 81q-49.5 28-112.5 28zm1-94q32 0 56.5-18.5q24.5-18.5 38-52.5q13.5-34 13.5-81q0-44-12.5-81q-12.5-37-36.5-59.5q-24-22.5-58-22.5q-33 0-57.5 16.5q-24.5 16.5-39 51.5q-14.5 35-14.5 89q0 49 14 84.5q14 35.5 38.5 54.5q24.5 19 57.5 19z"], "τ": [474, "m299 10q-45 0-71-17.5q-26-17.5-37.5-50q-11.5-32.5-11.5-78.5l0-264l-155 0l0-86l72-5l354 0l0 91l-158 0q-2 73-3 142.5q-1 69.5-1 127.5q0 25 10.5 35.5q10.5 10.5 28.5 10.5q13 0 25-2q12-2 27-6l15 88q-19 5-43.5 9.5q-24.5 4.5-51.5 4.5z"], "υ": [521, "m254 12q-66 0-110-24q-44-24-65.5-70q-21.5-46-21.5-108q0-40 2-79.5q2-39.5 2-78.5q0-30-1.5-67q-1.5-37-8.5-76l112 0q5 25 6.5 54.5q1.5 29.5 1.5 63.5q0 36-3 90q-3 54-3 101q0 35 12.5 57q12.5 22 33 32.5q20.5 10.5 44.5 10.5q31 0 53.5-17.5q22.5-17.5 35-54q12.5-36.5 12.5-93.5q0-52-7.5-108q-7.5-56-28.5-123l112-25q19 61 29.5 124.5q10.5 63.5 10.5 126.5q0 84-26 143q-26 59-75 90q-49 31-117 31z"], "φ": [710, "m302 178l0-823l106 0l0 823zm12-169q-72-1-134.5-30.5q-62.5-29.5-100.5-86q-38-56.5-38-138.5q0-82 38-138.5q38-56.5 100.5-85.5q62.5-29 134.5-30l-6 87q-42 1-76 20.5q-34 19.5-53.5 56.5q-19.5 37-19.5 90q0 53 19.5 90.5q19.5 37.5 53.5 57q34 19.5 76 20.5zm82 0l6-87q42-1 76-20.5q34-19.5 53-57q19-37.5 19-90.5q0-53-18.5-90q-18.5-37-52-56.5q-33.5-19.5-77.5-20.5l-6-87q74 1 136 30q62 29 99.5 85.5q37.5 56.5 37.5 138.5q0 82-38 138.5q-38 56.5-100.5 86q-62.5 29.5-134.5 30.5z"], "χ": [504, "m127 190l-118-12l190-342l-189-313l114-26l131 237l4 0l106-225l120 0l-171 324l200 330l-113 27l-142-262l-4 0z"], "ψ": [721, "m314 12q-69 0-117-18.5q-48-18.5-78-51.5q-30-33-44-77q-14-44-14-95l0-118q0-30-1.5-67q-1.5-37-7.5-76l112 0q5 25 6.5 54.5q1.5 29.5 1.5 63.5q0 23-0.5 52q-0.5 29-1 55.5q-0.5 26.5-0.5 43.5q0 41 14 73q14 32 44.5 50.5q30.5 18.5 79.5 18.5zm89 0l1-92q48 0 81.5-19q33.5-19 51-60.5q17.5-41.5 17.5-109.5q0-33-3.5-65q-3.5-32-11.5-67q-8-35-21-77l111-25q14 38 23 75.5q9 37.5 13.5 75q4.5 37.5 4.5 78.5q0 138-69 212q-69 74-198 74zm-97 166l0-823l105 0l0 823z"], "ω": [724, "m208 12q-48 0-84.5-29.5q-36.5-29.5-57-84.5q-20.5-55-20.5-131q0-44 10-92.5q10-48.5 28.5-94.5q18.5-46 42.5-83l107 43q-38 59-58.5 118q-20.5 59-20.5 119q0 65 19.5 103q19.5 38 55.5 38q22 0 40-14.5q18-14.5 28.5-47q10.5-32.5 10.5-83.5q0-20-1.5-38q-1.5-18-3.5-38.5q-2-20.5-5-46.5l123 0q-3 26-5 46.5q-2 20.5-3.5 38.5q-1.5 18-1.5 38q0 55 10 86.5q10 31.5 27.5 45q17.5 13.5 38.5 13.5q35 0 54.5-40q19.5-40 19.5-115q0-62-15-114q-15-52-54-112l105-40q37 57 58.5 122.5q21.5 65.5 21.5 142.5q0 77-19 133q-19 56-56 86.5q-37 30.5-92 30.5q-51 0-93-34q-42-34-55-101l-4 0q-13 67-53.5 101q-40.5 34-97.5 34z"], "ϑ": [536, "m260 12q-77 0-122.5-40q-45.5-40-63.5-120q-8-36-15-59q-7-23-18-43l105-23q9 12 16 35q7 23 13 52q13 58 36.5 81q23.5 23 56.5 23q22 0 40.5-11.5q18.5-11.5 32.5-41.5q14-30 21.5-84q7.5-54 7.5-139q0-101-13.5-159q-13.5-58-37-82.5q-23.5-24.5-55.5-24.5q-29 0-51 18.5q-22 18.5-34.5 47.5q-12.5 29-12.5 61q0 30 8.5 50q8.5 20 30.5 32.5q22 12.5 63 17.5q41 5 106 5l0 88q-97 0-158.5-11q-61.5-11-95.5-33.5q-34-22.5-47.5-58.5q-13.5-36-13.5-86q0-58 26.5-109.5q26.5-51.5 72-83.5q45.5-32 102.5-32q109 0 165.5 92.5q56.5 92.5 56.5 267.5q0 99-14.5 169q-14.5 70-43 114.5q-28.5 44.5-70 65.5q-41.5 21-94.5 21z"], "ϕ": [710, "m302 178l0-823l106 0l0 823zm12-169q-72-1-134.5-30.5q-62.5-29.5-100.5-86q-38-56.5-38-138.5q0-82 38-138.5q38-56.5 100.5-85.5q62.5-29 134.5-30l-6 87q-42 1-76 20.5q-34 19.5-53.5 56.5q-19.5 37-19.5 90q0 53 19.5 90.5q19.5 37.5 53.5 57q34 19.5 76 20.5zm82 0l6-87q42-1 76-20.5q34-19.5 53-57q19-37.5 19-90.5q0-53-18.5-90q-18.5-37-52-56.5q-33.5-19.5-77.5-20.5l-6-87q74 1 136 30q62 29 99.5 85.5q37.5 56.5 37.5 138.5q0 82-38 138.5q-38 56.5-100.5 86q-62.5 29.5-134.5 30.5z"], "Ё": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98zm100-708q-25 0-42-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 42-17q27 0 43.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-43.5 16.5zm214 0q-26 0-43-16.5q-17-16.5-17-42.5q0-26 17-43q17-17 43-17q26 0 42.5 17q16.5 17 16.5 43q0 26-16.5 42.5q-16.5 16.5-42.5 16.5z"], "А": [558, "m-2 0l213-654l136 0l213 654l-122 0l-100-348q-16-52-30.5-107q-14.5-55-28.5-109l-4 0q-13 55-27.5 109.5q-14.5 54.5-30.5 106.5l-101 348zm126-177l0-91l308 0l0 91z"], "Б": [590, "m83 0l0-654l426 0l0 98l-310 0l0 167l107 0q70 0 125.5 18q55.5 18 88 58.5q32.5 40.5 32.5 109.5q0 72-31 116.5q-31 44.5-85.5 65.5q-54.5 21-125.5 21zm116-90l97 0q72 0 107-27q35-27 35-84q0-54-36.5-77.5q-36.5-23.5-107.5-23.5l-95 0z"], "В": [597, "m83 0l0-654l209 0q68 0 120.5 15.5q52.5 15.5 83 50.5q30.5 35 30.5 95q0 50-23.5 88.5q-23.5 38.5-67.5 53.5l0 4q58 12 91.5 48.5q33.5 36.5 33.5 101.5q0 67-32.5 111q-32.5 44-89.5 65q-57 21-129 21zm116-384l83 0q68 0 99-25q31-25 31-67q0-48-32-68q-32-20-96-20l-85 0zm0 294l98 0q72 0 111-26.5q39-26.5 39-81.5q0-52-38-75.5q-38-23.5-112-23.5l-98 0z"], "Г": [510, "m83 0l0-654l395 0l0 98l-279 0l0 556z"], "Д": [654, "m133 0l0 188l-103 0l-11-214l0-72l616 0l0 72l-11 214l-103 0l0-188zm309-38l0-518l-150 0q-8 47-14.5 84.5q-6.5 37.5-13.5 75q-7 37.5-17 85.5q-14 71-31.5 123.5q-17.5 52.5-38.5 87q-21 34.5-46.5 52.5q-25.5 18-57.5 21l-24-71q15-5 30-28q15-23 31-71.5q16-48.5 33-130.5q13-62 22.5-110.5q9.5-48.5 18-99q8.5-50.5 18.5-116.5l356 0l0 616z"], "Е": [538, "m83 0l0-654l394 0l0 98l-278 0l0 167l235 0l0 98l-235 0l0 193l288 0l0 98z"], "Ж": [853, "m4 0l193-346l-61-140q-13-29-25-44q-12-15-24-20q-12-5-25-5q-5 0-10.5 1q-5.5 1-9.5 3l-19-106q9-4 21-5.5q12-1.5 24-1.5q32 0 60 9.5q28 9.5 51.5 35.5q23.5 26 42.5 73l66 158l83 0l0-266l111 0l0 266l82 0l66-158q20-47 43.5-73q23.5-26 51-35.5q27.5-9.5 60.5-9.5q12 0 24.5 1.5q12.5 1.5 20.5 5.5l-20 106q-3-2-8.5-3q-5.5-1-11.5-1q-12 0-24 5q-12 5-24 20q-12 15-25 44l-61 140l193 346l-126 0l-153-294l-88 0l0 294l-111 0l0-294l-88 0l-153 294z"], "З": [553, "m282 12q-78 0-138-22q-60-22-112-76l62-72q40 38 84 53.5q44 15.5 91 15.5q38 0 68.5-12.5q30.5-12.5 48-36.5q17.5-24 17.5-59q0-52-37.5-76q-37.5-24-109.5-24l-81 0l0-87l64 0q69 0 100.5-23.5q31.5-23.5 31.5-68.5q0-44-31-66.5q-31-22.5-79-22.5q-42 0-77 14.5q-35 14.5-67 40.5l-59-72q38-38 91-61q53-23 115-23q69 0 118 20.5q49 20.5 75.5 59q26.5 38.5 26.5 92.5q0 51-24 88q-24 37-66 56l0 4q34 8 62 29q28 21 44.5 53.5q16.5 32.5 16.5 74.5q0 65-32.5 110q-32.5 45-86 68q-53.5 23-116.5 23z"], "И": [670, "m83 0l0-654l115 0l0 284q0 55-5 114.5q-5 59.5-11 109.5l4 0l66-140l204-368l127 0l0 654l-115 0l0-286q0-56 6-113.5q6-57.5 10-108.5l-4 0l-66 140l-204 368z"], "Й": [666, "m83 0l0-654l115 0l0 284q0 55-5 114.5q-5 59.5-11 109.5l4 0l66-140l204-368l127 0l0 654l-115 0l0-286q0-56 6-113.5q6-57.5 10-108.5l-4 0l-66 140l-204 368zm254-708q-60 0-95-18.5q-35-18.5-51.5-49q-16.5-30.5-18.5-67.5l99 0q2 33 17 54q15 21 49 21q34 0 49.5-21q15.5-21 16.5-54l99 0q-2 37-18.5 67.5q-16.5 30.5-51.5 49q-35 18.5-95 18.5z"], "К": [597, "m83 0l0-654l116 0l0 266l95 0l76-158q23-48 47-73.5q24-25.5 50.5-35q26.5-9.5 58.5-9.5q14 0 26.5 1.5q12.5 1.5 21.5 5.5l-19 105q-5-2-11.5-2.5q-6.5-0.5-14.5-0.5q-13 0-24 5q-11 5-22.5 20q-11.5 15-26.5 44l-72 139l215 347l-128 0l-177-294l-95 0l0 294z"], "Л": [644, "m61 10q-21 0-36-2.5q-15-2.5-30-6.5l22-105q7 2 13.5 3.5q6.5 1.5 14.5 1.5q17 0 31.5-10.5q14.5-10.5 28.5-45.5q14-35 31-108q23-98 40.5-194q17.5-96 33.5-197l351 0l0 654l-116 0l0-556l-146 0q-11 79-25 154q-14 75-31 151q-22 104-46.5 161q-24.5 57-57 78.5q-32.5 21.5-78.5 21.5z"], "М": [745, "m83 0l0-654l139 0l112 320q11 31 20 61.5q9 30.5 18 66.5l4 0q9-36 17.5-66.5q8.5-30.5 18.5-61.5l112-320l138 0l0 654l-107 0l0-298q0-31 2.5-71q2.5-40 6.5-79.5q4-39.5 8-69.5l-4 0l-52 166l-106 292l-78 0l-106-292l-50-166l-4 0q4 30 7.5 69.5q3.5 39.5 6 79.5q2.5 40 2.5 71l0 298z"], "Н": [663, "m83 0l0-654l116 0l0 263l265 0l0-263l116 0l0 654l-116 0l0-290l-265 0l0 290z"], "О": [674, "m337 12q-85 0-150-41.5q-65-41.5-101.5-118q-36.5-76.5-36.5-182.5q0-106 36.5-181q36.5-75 101.5-115q65-40 150-40q86 0 151 40q65 40 101.5 115q36.5 75 36.5 181q0 106-36.5 182.5q-36.5 76.5-101.5 118q-65 41.5-151 41.5zm0-101q52 0 89.5-29.5q37.5-29.5 58.5-84q21-54.5 21-127.5q0-73-21-125.5q-21-52.5-58.5-81q-37.5-28.5-89.5-28.5q-51 0-89 28.5q-38 28.5-59 81q-21 52.5-21 125.5q0 73 21 127.5q21 54.5 59 84q38 29.5 89 29.5z"], "П": [654, "m83 0l0-654l488 0l0 654l-116 0l0-556l-256 0l0 556z"], "Р": [582, "m83 0l0-654l206 0q73 0 130 19q57 19 90 63q33 44 33 120q0 72-32.5 119q-32.5 47-89 70q-56.5 23-127.5 23l-94 0l0 240zm116-333l85 0q73 0 108.5-30q35.5-30 35.5-89q0-62-37.5-85.5q-37.5-23.5-110.5-23.5l-81 0z"], "С": [576, "m346 12q-83 0-150.5-39q-67.5-39-107-114.5q-39.5-75.5-39.5-183.5q0-80 23-143.5q23-63.5 64.5-107.5q41.5-44 95.5-67q54-23 116-23q62 0 110 24.5q48 24.5 79 58.5l-62 71q-25-26-55.5-39.5q-30.5-13.5-68.5-13.5q-52 0-93.5 29q-41.5 29-65.5 82q-24 53-24 126q0 75 23 128.5q23 53.5 65 82q42 28.5 98 28.5q42 0 75-17q33-17 60-45l59 69q-40 46-90 70q-50 24-112 24z"], "Т": [546, "m215 0l0-556l-189 0l0-98l494 0l0 98l-189 0l0 556z"], "У": [535, "m147 12q-25 0-42.5-3q-17.5-3-31.5-9l22-101q8 3 18 5q10 2 27 2q27 0 45-10q18-10 29-31l12-27l-223-492l123 0l99 240l52 143l4 0l49-143l90-240l117 0l-208 520q-27 68-70 107q-43 39-112 39z"], "Ф": [748, "m350-78q-95 0-163-28.5q-68-28.5-104.5-84.5q-36.5-56-36.5-139q0-82 36.5-137q36.5-55 104.5-82.5q68-27.5 163-27.5l48 0q95 0 163 27.5q68 27.5 104.5 82.5q36.5 55 36.5 137q0 83-36.5 139q-36.5 56-104.5 84.5q-68 28.5-163 28.5zm-9-87l66 0q88 0 137-42q49-42 49-123q0-80-49-120q-49-40-137-40l-66 0q-87 0-136.5 40q-49.5 40-49.5 120q0 81 49.5 123q49.5 42 136.5 42zm-17 177l0-678l100 0l0 678z"], "Х": [541, "m13 0l186-337l-174-317l129 0l72 145q13 22 24 46q11 24 26 54l4 0q12-30 22.5-54q10.5-24 21.5-46l69-145l123 0l-174 322l186 332l-129 0l-80-154q-13-26-25.5-51.5q-12.5-25.5-27.5-55.5l-4 0q-12 30-24 55.5q-12 25.5-24 51.5l-78 154z"], "Ц": [656, "m523 188l0-188l-440 0l0-654l116 0l0 556l245 0l0-556l116 0l0 556l77 0l0 72l-11 214z"], "Ч": [614, "m415 0l0-260q-24 4-50 7q-26 3-63 3q-76 0-129.5-22q-53.5-22-81-71.5q-27.5-49.5-27.5-132.5l0-178l113 0l0 178q0 49 15.5 78q15.5 29 45.5 41.5q30 12.5 76 12.5q34 0 58.5-2.5q24.5-2.5 42.5-6.5l0-301l116 0l0 654z"], "Ш": [896, "m83 0l0-654l114 0l0 556l195 0l0-556l112 0l0 556l195 0l0-556l114 0l0 654z"], "Щ": [904, "m772 188l0-188l-33 0l0-98l146 0l0 72l-11 214zm-689-188l0-654l114 0l0 556l195 0l0-556l112 0l0 556l195 0l0-556l114 0l0 654z"], "Ъ": [725, "m227 0l0-556l-201 0l0-98l317 0l0 253l89 0q70 0 127 20.5q57 20.5 91.5 63q34.5 42.5 34.5 109.5q0 75-32 120.5q-32 45.5-88 66.5q-56 21-127 21zm116-93l85 0q70 0 106.5-26.5q36.5-26.5 36.5-86.5q0-51-37.5-76.5q-37.5-25.5-111.5-25.5l-79 0z"], "Ы": [826, "m83 0l0-654l116 0l0 253l83 0q73 0 129 19.5q56 19.5 88 62.5q32 43 32 111q0 75-32 120.5q-32 45.5-88.5 66.5q-56.5 21-129.5 21zm116-93l73 0q70 0 107.5-26.5q37.5-26.5 37.5-86.5q0-52-36.5-77q-36.5-25-110.5-25l-71 0zm428 93l0-654l116 0l0 654z"], "Ь": [590, "m83 0l0-654l116 0l0 253l102 0q73 0 129 19.5q56 19.5 88 62.5q32 43 32 111q0 75-32 120.5q-32 45.5-88.5 66.5q-56.5 21-129.5 21zm116-93l92 0q70 0 107.5-26.5q37.5-26.5 37.5-86.5q0-52-36.5-77q-36.5-25-110.5-25l-90 0z"], "Э": [576, "m241 12q-65 0-118.5-24.5q-53.5-24.5-95.5-70.5l62-69q30 31 66.5 47q36.5 16 83.5 16q81 0 127.5-59q46.5-59 46.5-183q0-117-46-175.5q-46-58.5-130-58.5q-40 0-74.5 13q-34.5 13-62.5 40l-56-71q35-36 85-59.5q50-23.5 114-23.5q82 0 146.5 38q64.5 38 101.5 114q37 76 37 189q0 114-38 188.5q-38 74.5-103 111.5q-65 37-146 37zm-81-303l0-98l305 0l0 98z"], "Ю": [929, "m83 0l0-654l116 0l0 263l193 0l0 101l-193 0l0 290zm519 12q-84 0-146-41.5q-62-41.5-96-118q-34-76.5-34-182.5q0-105 34-180.5q34-75.5 96-115.5q62-40 146-40q84 0 146.5 40q62.5 40 97 115.5q34.5 75.5 34.5 180.5q0 106-34.5 182.5q-34.5 76.5-97 118q-62.5 41.5-146.5 41.5zm0-101q50 0 86-29.5q36-29.5 54.5-83.5q18.5-54 18.5-128q0-73-18.5-125.5q-18.5-52.5-54.5-81q-36-28.5-86-28.5q-51 0-86.5 28.5q-35.5 28.5-54.5 81q-19 52.5-19 125.5q0 74 19 128q19 54 54.5 83.5q35.5 29.5 86.5 29.5z"], "Я": [600, "m400 0l0-256l-112 0q-64-1-117-22.5q-53-21.5-84.5-66.5q-31.5-45-31.5-115q0-73 32-115.5q32-42.5 86.5-60.5q54.5-18 122.5-18l220 0l0 654zm-92-348l92 0l0-213l-92 0q-67 0-102.5 22.5q-35.5 22.5-35.5 78.5q0 56 35.5 84q35.5 28 102.5 28zm-291 348l222-344l83 57l-172 287z"], "а": [516, "m192 12q-43 0-76-18q-33-18-51.5-50.5q-18.5-32.5-18.5-75.5q0-83 69.5-125.5q69.5-42.5 220.5-58.5q-1-25-9.5-46q-8.5-21-28-33.5q-19.5-12.5-52.5-12.5q-36 0-70.5 13q-34.5 13-67.5 33l-42-78q27-17 59-31.5q32-14.5 68-23q36-8.5 75-8.5q61 0 101.5 24.5q40.5 24.5 61 72q20.5 47.5 20.5 116.5l0 290l-95 0l-8-54l-4 0q-34 28-71 47q-37 19-81 19zm36-94q30 0 55.5-12.5q25.5-12.5 52.5-37.5l0-104q-67 8-106 21q-39 13-55.5 31.5q-16.5 18.5-16.5 43.5q0 31 20 44.5q20 13.5 50 13.5z"], "б": [553, "m285 12q-113 0-175-82.5q-62-82.5-62-231.5q0-94 14-160q14-66 41-109q27-43 65-68.5q38-25.5 85.5-40q47.5-14.5 102.5-22.5q29-4 47.5-8q18.5-4 33-8.5q14.5-4.5 29.5-11.5l23 102q-19 13-47.5 21q-28.5 8-61.5 13q-53 8-91.5 16q-38.5 8-64 25q-25.5 17-40 49.5q-14.5 32.5-20.5 87q-6 54.5-6 139.5q0 95 32.5 145q32.5 50 93.5 50q32 0 56-20q24-20 37-55.5q13-35.5 13-83.5q0-47-12.5-79q-12.5-32-36.5-48q-24-16-59-16q-30 0-62 16.5q-32 16.5-63 59.5l-5-78q30-41 73-62.5q43-21.5 90-21.5q55 0 99 26.5q44 26.5 69 77.5q25 51 25 125q0 77-29.5 133.5q-29.5 56.5-80 88q-50.5 31.5-113.5 31.5z"], "в": [518, "m73 0l0-491l199 0q55 0 97.5 12q42.5 12 67.5 40q25 28 25 75q0 36-20.5 64q-20.5 28-61.5 39l0 4q29 6 52 20.5q23 14.5 36.5 37.5q13.5 23 13.5 57q0 50-26.5 81.5q-26.5 31.5-71.5 46q-45 14.5-102 14.5zm113-296l75 0q47 0 68-15.5q21-15.5 21-40.5q0-29-20-45q-20-16-66-16l-78 0zm0 218l88 0q50 0 72-19q22-19 22-51q0-29-24-45.5q-24-16.5-74-16.5l-84 0z"], "г": [422, "m73 0l0-491l323 0l0 91l-208 0l0 400z"], "д": [559, "m126 0l0 172l-100 0l-11-189l0-75l527 0l0 75l-12 189l-99 0l0-172zm226-34l0-366l-131 0l-15 140q-8 65-21.5 109q-13.5 44-33 71q-19.5 27-43.5 40q-24 13-50 16l-15-68q12-6 23.5-23q11.5-17 21-56.5q9.5-39.5 18.5-113.5l24-206l337 0l0 457z"], "е": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14z"], "ж": [726, "m10 0l147-255l-33-80q-15-35-29.5-46q-14.5-11-31.5-11q-5 0-8.5 1q-3.5 1-8.5 3l-19-107q14-7 34-7q45 0 78 22q33 22 59 81l43 99l71 0l0-191l102 0l0 191l71 0l44-99q26-59 59-81q33-22 77-22q20 0 35 7l-19 107q-4-2-8.5-3q-4.5-1-9.5-1q-16 0-30.5 11q-14.5 11-29.5 46l-33 80l147 255l-124 0l-105-208l-74 0l0 208l-102 0l0-208l-74 0l-104 208z"], "з": [466, "m220 12q-49 0-96-12q-47-12-92-48l48-74q32 24 65.5 34q33.5 10 64.5 10q30 0 54-8.5q24-8.5 38-24q14-15.5 14-37.5q0-32-25-47q-25-15-75-15l-74 0l0-86l64 0q47 0 69.5-15.5q22.5-15.5 22.5-42.5q0-30-23.5-45q-23.5-15-62.5-15q-37 0-66.5 9q-29.5 9-58.5 29l-45-75q38-25 81.5-38.5q43.5-13.5 95.5-13.5q51 0 94.5 14.5q43.5 14.5 70 44.5q26.5 30 26.5 76q0 34-19.5 64q-19.5 30-60.5 44l0 4q45 10 72.5 38.5q27.5 28.5 27.5 79.5q0 48-30 81.5q-30 33.5-78 51q-48 17.5-102 17.5z"], "и": [574, "m73 0l0-491l112 0l0 169q0 40-3 84q-3 44-8 98l4 0q14-29 29.5-60.5q15.5-31.5 28.5-53.5l138-237l127 0l0 491l-112 0l0-170q0-38 2.5-82.5q2.5-44.5 8.5-99.5l-4 0q-13 31-28.5 62q-15.5 31-29.5 54l-138 236z"], "й": [574, "m73 0l0-491l112 0l0 169q0 40-3 84q-3 44-8 98l4 0q14-29 29.5-60.5q15.5-31.5 28.5-53.5l138-237l127 0l0 491l-112 0l0-170q0-38 2.5-82.5q2.5-44.5 8.5-99.5l-4 0q-13 31-28.5 62q-15.5 31-29.5 54l-138 236zm217-571q-57 0-92.5-21q-35.5-21-53-57q-17.5-36-18.5-80l91 0q1 28 8 49.5q7 21.5 22.5 33.5q15.5 12 42.5 12q27 0 42.5-12q15.5-12 22.5-33.5q7-21.5 8-49.5l91 0q-1 44-18.5 80q-17.5 36-53 57q-35.5 21-92.5 21z"], "к": [522, "m73 0l0-491l114 0l0 191l84 0l46-99q20-43 41.5-65q21.5-22 46.5-30q25-8 56-8q20 0 34 7l-19 107q-4-2-8-3q-4-1-9-1q-19 0-34.5 10q-15.5 10-32.5 47l-33 77l155 258l-125 0l-115-208l-87 0l0 208z"], "л": [552, "m60 10q-16 0-28-2q-12-2-24-7l20-105q6 1 11.5 2.5q5.5 1.5 12.5 1.5q22 0 37.5-20q15.5-20 21.5-66q10-76 18.5-152.5q8.5-76.5 16.5-152.5l333 0l0 491l-115 0l0-400l-126 0q-8 61-15 122.5q-7 61.5-15 122.5q-12 81-48.5 123q-36.5 42-99.5 42z"], "м": [647, "m73 0l0-491l139 0l76 195q11 27 20 55q9 28 16 63l4 0q8-35 15.5-63q7.5-28 17.5-55l73-195l140 0l0 491l-104 0l0-172q0-25 2-60q2-35 4.5-71q2.5-36 5.5-63l-4 0q-10 34-22 70q-12 36-23 66l-70 186l-80 0l-71-186q-10-30-22-66q-12-36-23-70l-4 0q3 27 6 63q3 36 4.5 71q1.5 35 1.5 60l0 172z"], "н": [572, "m73 0l0-491l115 0l0 188l196 0l0-188l115 0l0 491l-115 0l0-202l-196 0l0 202z"], "о": [549, "m274 12q-61 0-114-30.5q-53-30.5-86-88q-33-57.5-33-138.5q0-82 33-139.5q33-57.5 86-88q53-30.5 114-30.5q62 0 115 30.5q53 30.5 86 88q33 57.5 33 139.5q0 81-33 138.5q-33 57.5-86 88q-53 30.5-115 30.5zm0-94q36 0 62-20q26-20 40-57q14-37 14-86q0-49-14-86q-14-37-40-57.5q-26-20.5-62-20.5q-36 0-61.5 20.5q-25.5 20.5-39.5 57.5q-14 37-14 86q0 49 14 86q14 37 39.5 57q25.5 20 61.5 20z"], "п": [564, "m73 0l0-491l417 0l0 491l-115 0l0-400l-187 0l0 400z"], "р": [564, "m73 194l0-685l95 0l8 52l4 0q31-27 69-45.5q38-18.5 79-18.5q61 0 104 31q43 31 66 87q23 56 23 132q0 84-30 143q-30 59-77.5 90.5q-47.5 31.5-102.5 31.5q-32 0-64-14q-32-14-62-40l3 82l0 154zm214-277q33 0 59-19q26-19 41-56.5q15-37.5 15-93.5q0-49-11-84q-11-35-34.5-53.5q-23.5-18.5-60.5-18.5q-27 0-53 13.5q-26 13.5-55 41.5l0 229q27 22 52.5 31.5q25.5 9.5 46.5 9.5z"], "с": [462, "m280 12q-68 0-122-30.5q-54-30.5-85.5-88q-31.5-57.5-31.5-138.5q0-82 34-139.5q34-57.5 90.5-88q56.5-30.5 121.5-30.5q47 0 82.5 15.5q35.5 15.5 61.5 39.5l-55 72q-16-15-36.5-24q-20.5-9-46.5-9q-39 0-69 20.5q-30 20.5-47.5 57q-17.5 36.5-17.5 86.5q0 49 17 85.5q17 36.5 46.5 57q29.5 20.5 68.5 20.5q29 0 54.5-11q25.5-11 45.5-28l47 71q-31 28-71.5 45q-40.5 17-86.5 17z"], "т": [476, "m180 0l0-400l-154 0l0-91l424 0l0 91l-154 0l0 400z"], "у": [495, "m106 202q-20 0-35.5-3q-15.5-3-28.5-9l22-86q10 3 18 4q8 1 16 1q39 0 62.5-24q23.5-24 35.5-60l9-31l-193-485l117 0l85 241q11 32 21.5 67.5q10.5 35.5 21.5 70.5l4 0q9-34 18.5-69.5q9.5-35.5 18.5-68.5l74-241l111 0l-178 513q-20 55-46 95.5q-26 40.5-63 62.5q-37 22-90 22z"], "ф": [757, "m322 194l0-141l4-74q-20 13-44.5 23q-24.5 10-50.5 10q-85 0-136.5-68q-51.5-68-51.5-189q0-80 26.5-138q26.5-58 69.5-89q43-31 92-31q29 0 51.5 8.5q22.5 8.5 43.5 22.5l-4-72l0-162l113 0l0 162l-4 75q22-15 49.5-24.5q27.5-9.5 53.5-9.5q57 0 97 31q40 31 61.5 87q21.5 56 21.5 132q0 84-26.5 143q-26.5 59-70 90.5q-43.5 31.5-93.5 31.5q-24 0-47.5-8q-23.5-8-45.5-23l4 72l0 141zm-63-277q19 0 34.5-6q15.5-6 32.5-22l0-271q-17-15-35-20.5q-18-5.5-36-5.5q-26 0-47 19q-21 19-33.5 55q-12.5 36-12.5 88q0 79 25.5 121q25.5 42 71.5 42zm240 0q28 0 50-19q22-19 34-56.5q12-37.5 12-93.5q0-49-9.5-84q-9.5-35-30-53.5q-20.5-18.5-53.5-18.5q-17 0-34.5 5.5q-17.5 5.5-36.5 21.5l0 272q18 15 36 20.5q18 5.5 32 5.5z"], "х": [481, "m14 0l156-256l-146-235l124 0l55 93q11 20 22 41q11 21 23 42l4 0q9-21 19-42q10-21 19-41l47-93l119 0l-145 248l156 243l-124 0l-60-97q-12-22-24.5-44q-12.5-22-25.5-43l-4 0q-11 21-22 42.5q-11 21.5-21 44.5l-52 97z"], "ц": [577, "m449 172l0-172l-376 0l0-491l115 0l0 399l182 0l0-399l115 0l0 399l75 0l0 75l-12 189z"], "ч": [531, "m343 0l0-181q-23 5-41 7q-18 2-50 2q-60 0-104.5-18q-44.5-18-69-58.5q-24.5-40.5-24.5-104.5l0-138l115 0l0 138q0 46 25.5 67.5q25.5 21.5 81.5 21.5q19 0 34.5-2q15.5-2 32.5-5l0-220l115 0l0 491z"], "ш": [777, "m73 0l0-491l114 0l0 399l146 0l0-399l111 0l0 399l146 0l0-399l114 0l0 491z"], "щ": [796, "m668 172l0-172l-34 0l0-92l144 0l0 75l-11 189zm-595-172l0-491l114 0l0 399l146 0l0-399l111 0l0 399l146 0l0-399l114 0l0 491z"], "ъ": [610, "m186 0l0-400l-160 0l0-91l275 0l0 168l67 0q59 0 105 16q46 16 72 51q26 35 26 93q0 59-26 95q-26 36-72 52q-46 16-105 16zm115-89l59 0q51 0 75.5-18.5q24.5-18.5 24.5-56.5q0-37-24.5-54.5q-24.5-17.5-75.5-17.5l-59 0z"], "ы": [707, "m73 0l0-491l115 0l0 168l52 0q59 0 105 16q46 16 72.5 51q26.5 35 26.5 93q0 59-26.5 95q-26.5 36-72.5 52q-46 16-105 16zm115-89l45 0q51 0 75-18.5q24-18.5 24-56.5q0-37-24-54.5q-24-17.5-75-17.5l-45 0zm331 89l0-491l115 0l0 491z"], "ь": [504, "m73 0l0-491l115 0l0 168l74 0q59 0 105 16q46 16 72 51q26 35 26 93q0 59-26 95q-26 36-72 52q-46 16-105 16zm115-89l66 0q51 0 75.5-18.5q24.5-18.5 24.5-56.5q0-37-24.5-54.5q-24.5-17.5-75.5-17.5l-66 0z"], "э": [462, "m186 12q-46 0-89-15.5q-43-15.5-75-46.5l46-68q21 18 48 29q27 11 58 11q62 0 98-41q36-41 36-126q0-88-34.5-128.5q-34.5-40.5-93.5-40.5q-30 0-53.5 9.5q-23.5 9.5-44.5 26.5l-50-66q27-26 66-42.5q39-16.5 88-16.5q66 0 119.5 28q53.5 28 85 85q31.5 57 31.5 145q0 84-30.5 141.5q-30.5 57.5-84 86.5q-53.5 29-121.5 29zm-68-222l0-88l255 0l0 88z"], "ю": [757, "m73 0l0-491l115 0l0 189l111 0l0 102l-111 0l0 200zm425 12q-64 0-114-30.5q-50-30.5-79.5-88.5q-29.5-58-29.5-138q0-81 29.5-138.5q29.5-57.5 79.5-88.5q50-31 114-31q60 0 109.5 30.5q49.5 30.5 79 88q29.5 57.5 29.5 139.5q0 81-29.5 138.5q-29.5 57.5-79 88q-49.5 30.5-109.5 30.5zm-6-94q34 0 57.5-20q23.5-20 36-57q12.5-37 12.5-86q0-49-12.5-86q-12.5-37-36-57.5q-23.5-20.5-57.5-20.5q-33 0-57.5 20.5q-24.5 20.5-38 57.5q-13.5 37-13.5 86q0 49 13.5 86q13.5 37 38 57q24.5 20 57.5 20z"], "я": [530, "m341 0l0-174l-73 0q-36 0-72-9q-36-9-65.5-28.5q-29.5-19.5-47.5-50.5q-18-31-18-75q0-58 26.5-91.5q26.5-33.5 71.5-48q45-14.5 101-14.5l192 0l0 491zm-61-260l61 0l0-144l-61 0q-48 0-74 16.5q-26 16.5-26 51.5q0 36 26 56q26 20 74 20zm-256 260l166-232l96 34l-130 198z"], "ё": [507, "m284 12q-69 0-124.5-30.5q-55.5-30.5-87.5-88q-32-57.5-32-139.5q0-80 33-137.5q33-57.5 85-88.5q52-31 110-31q67 0 112 30q45 30 67.5 82.5q22.5 52.5 22.5 120.5q0 16-1.5 31q-1.5 15-4.5 29l-338 0l0-88l242 0q0-53-24-83.5q-24-30.5-74-30.5q-28 0-54.5 15q-26.5 15-44 51q-17.5 36-17.5 100q0 58 20 94.5q20 36.5 53 54q33 17.5 71 17.5q32 0 60.5-9q28.5-9 53.5-25l40 74q-34 24-77.5 38q-43.5 14-90.5 14zm-121-590q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q27 0 44 17.5q17 17.5 17 43.5q0 26-17 43.5q-17 17.5-44 17.5zm206 0q-26 0-43.5-17.5q-17.5-17.5-17.5-43.5q0-26 17.5-43.5q17.5-17.5 43.5-17.5q26 0 43.5 17.5q17.5 17.5 17.5 43.5q0 26-17.5 43.5q-17.5 17.5-43.5 17.5z"], "‐": [322, "m42-210l0-84l238 0l0 84z"], "‑": [322, "m42-210l0-84l238 0l0 84z"], "‒": [513, "m42-214l0-76l429 0l0 76z"], "–": [480, "m42-214l0-76l396 0l0 76z"], "—": [800, "m42-214l0-76l716 0l0 76z"], "―": [800, "m42-214l0-76l716 0l0 76z"], "‖": [423, "m89 250l0-1000l77 0l0 1000zm168 0l0-1000l77 0l0 1000z"], "‗": [500, "m12 133l0-69l476 0l0 69zm0 136l0-69l476 0l0 69z"], "‘": [275, "m134-394q-37 0-57.5-29.5q-20.5-29.5-20.5-81.5q0-66 31.5-115q31.5-49 92.5-81l28 51q-41 24-62 53.5q-21 29.5-21 73.5l8 76l-45-59q10-9 21.5-14q11.5-5 24.5-5q27 0 46.5 16q19.5 16 19.5 46q0 31-18.5 50q-18.5 19-47.5 19z"], "’": [275, "m95-391l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5z"], "‚": [275, "m95 157l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5z"], "‛": [275, "m180-391q-61-33-92.5-81.5q-31.5-48.5-31.5-114.5q0-53 20.5-82q20.5-29 57.5-29q29 0 47.5 18.5q18.5 18.5 18.5 50.5q0 29-19.5 45.5q-19.5 16.5-46.5 16.5q-13 0-24.5-5q-11.5-5-21.5-14l45-59l-8 76q0 44 21 73.5q21 29.5 62 53.5z"], "“": [482, "m134-394q-37 0-57.5-29.5q-20.5-29.5-20.5-81.5q0-66 31.5-115q31.5-49 92.5-81l28 51q-41 24-62 53.5q-21 29.5-21 73.5l8 76l-45-59q10-9 21.5-14q11.5-5 24.5-5q27 0 46.5 16q19.5 16 19.5 46q0 31-18.5 50q-18.5 19-47.5 19zm207 0q-37 0-57.5-29.5q-20.5-29.5-20.5-81.5q0-66 31.5-115q31.5-49 92.5-81l28 51q-41 24-62 53.5q-21 29.5-21 73.5l8 76l-45-59q10-9 21.5-14q11.5-5 24.5-5q27 0 46.5 16q19.5 16 19.5 46q0 31-18.5 50q-18.5 19-47.5 19z"], "”": [482, "m95-391l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5zm207 0l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5z"], "„": [482, "m95 157l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5zm207 0l-28-51q41-24 62-53.5q21-29.5 21-73.5l-8-76l45 59q-10 9-21 14q-11 5-25 5q-27 0-46-16.5q-19-16.5-19-45.5q0-32 18.5-50.5q18.5-18.5 46.5-18.5q38 0 58.5 29q20.5 29 20.5 82q0 66-31.5 114.5q-31.5 48.5-93.5 81.5z"], "†": [482, "m194 80l7-540l-152 7l0-94l152 7l-7-172l94 0l-6 172l152-7l0 94l-152-7l6 540z"], "‡": [482, "m194 80l7-172l-152 7l0-94l152 9l-7-146l7-146l-152 9l0-94l152 7l-7-172l94 0l-6 172l152-7l0 94l-152-9l6 146l-6 146l152-9l0 94l-152-7l6 172z"], "•": [325, "m162-133q-33 0-61-17q-28-17-44.5-46q-16.5-29-16.5-67q0-38 16.5-67q16.5-29 44.5-46q28-17 61-17q34 0 61.5 17q27.5 17 44.5 46q17 29 17 67q0 38-17 67q-17 29-44.5 46q-27.5 17-61.5 17z"], "‣": [325, "m32-106l0-312l4 0l280 154l0 3l-280 155z"], "…": [964, "m160 12q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5zm333 0q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5zm333 0q-31 0-53-22.5q-22-22.5-22-55.5q0-34 22-56q22-22 53-22q32 0 53 22q21 22 21 56q0 33-21 55.5q-21 22.5-53 22.5z"], "′": [275, "m150-418l-75-5l35-269l113 10l-24 106z"], "⁰": [372, "m186-373q-46 0-81-24.5q-35-24.5-55-71q-20-46.5-20-112.5q0-98 43.5-152q43.5-54 112.5-54q69 0 112.5 54q43.5 54 43.5 152q0 66-20 112.5q-20 46.5-55 71q-35 24.5-81 24.5zm0-67q32 0 52.5-33.5q20.5-33.5 20.5-107.5q0-74-20.5-106.5q-20.5-32.5-52.5-32.5q-31 0-52 32.5q-21 32.5-21 106.5q0 74 21 107.5q21 33.5 52 33.5z"], "ⁱ": [177, "m47-385l0-325l83 0l0 325zm42-379q-22 0-36.5-13q-14.5-13-14.5-33q0-20 14.5-33q14.5-13 36.5-13q22 0 36.5 13q14.5 13 14.5 33q0 20-14.5 33q-14.5 13-36.5 13z"], "⁴": [372, "m217-385l0-209l5-113l-4 0l-45 79l-51 89l230 0l0 59l-314 0l0-44l152-251l104 0l0 390z"], "⁵": [372, "m185-373q-52 0-90.5-21q-38.5-21-63.5-57l54-42q19 26 41 39.5q22 13.5 51 13.5q30 0 49-20.5q19-20.5 19-51.5q0-34-20-53q-20-19-50-19q-20 0-35.5 7.5q-15.5 7.5-30.5 19.5l-39-27l18-191l225 0l0 74l-156 0l-8 74q13-5 27.5-7.5q14.5-2.5 26.5-2.5q52 0 89.5 33.5q37.5 33.5 37.5 95.5q0 39-19 69.5q-19 30.5-51.5 48q-32.5 17.5-74.5 17.5z"], "⁶": [372, "m199-373q-74 0-116.5-54.5q-42.5-54.5-42.5-146.5q0-68 22-115.5q22-47.5 62-72.5q40-25 92-25q39 0 64 11q25 11 42 25l-34 56q-15-10-31-17.5q-16-7.5-36-7.5q-33 0-55.5 18q-22.5 18-34.5 53q-12 35-12 86q0 64 22.5 93.5q22.5 29.5 54.5 29.5q25 0 42-17.5q17-17.5 17-48.5q0-30-16-48q-16-18-47-18q-19 0-37.5 9.5q-18.5 9.5-38.5 31.5l-3-55q20-23 45-34.5q25-11.5 53-11.5q58 0 90 34q32 34 32 90q0 38-17.5 68.5q-17.5 30.5-48 48.5q-30.5 18-68.5 18z"], "⁷": [372, "m124-385q4-64 16.5-116q12.5-52 36-100q23.5-48 60.5-101l-187 0l0-73l284 0l0 47q-46 58-70.5 111.5q-24.5 53.5-34.5 109q-10 55.5-14 122.5z"], "⁸": [372, "m185-373q-63 0-103-33q-40-33-40-77q0-35 22.5-62q22.5-27 49.5-43l0-4q-25-17-41.5-38.5q-16.5-21.5-16.5-51.5q0-48 38-76.5q38-28.5 91-28.5q55 0 93 28q38 28 38 77q0 20-8.5 37.5q-8.5 17.5-22 30.5q-13.5 13-28.5 22l0 4q32 16 52 41q20 25 20 62q0 47-40.5 79.5q-40.5 32.5-103.5 32.5zm20-242q33-29 33-62q0-23-15.5-35.5q-15.5-12.5-37.5-12.5q-21 0-36 12.5q-15 12.5-15 32.5q0 25 20.5 39.5q20.5 14.5 50.5 25.5zm-20 182q27 0 46-17q19-17 19-40q0-20-12-31.5q-12-11.5-31.5-20q-19.5-8.5-42.5-18.5q-43 27-43 69q0 23 17.5 40.5q17.5 17.5 46.5 17.5z"], "⁹": [372, "m154-373q-38 0-63-11q-25-11-43-25l35-56q14 10 30 17.5q16 7.5 37 7.5q32 0 54.5-18q22.5-18 34.5-53q12-35 12-86q0-64-22-93.5q-22-29.5-55-29.5q-24 0-41.5 17.5q-17.5 17.5-17.5 48.5q0 30 16.5 48q16.5 18 46.5 18q20 0 38.5-9.5q18.5-9.5 38.5-31.5l3 55q-20 22-45 34q-25 12-54 12q-57 0-89.5-34q-32.5-34-32.5-90q0-38 18-68.5q18-30.5 48-48.5q30-18 68-18q75 0 117 54q42 54 42 147q0 67-22 115q-22 48-61.5 73q-39.5 25-92.5 25z"], "⁺": [372, "m150-417l0-133l-122 0l0-68l122 0l0-132l72 0l0 132l122 0l0 68l-122 0l0 133z"], "⁻": [372, "m28-550l0-68l316 0l0 68z"], "⁼": [372, "m28-636l0-68l316 0l0 68zm0 172l0-68l316 0l0 68z"], "⁽": [253, "m153-301q-28-42-48-84q-20-42-30.5-89.5q-10.5-47.5-10.5-105.5q0-58 10.5-105.5q10.5-47.5 30.5-89.5q20-42 48-84l63 27q-36 60-53 122.5q-17 62.5-17 129.5q0 66 17 128.5q17 62.5 53 123.5z"], "⁾": [253, "m100-301l-63-27q36-61 52.5-123.5q16.5-62.5 16.5-128.5q0-67-16.5-129.5q-16.5-62.5-52.5-122.5l63-27q29 42 48.5 84q19.5 42 30 89.5q10.5 47.5 10.5 105.5q0 58-10.5 105.5q-10.5 47.5-30 89.5q-19.5 42-48.5 84z"], "ⁿ": [376, "m47-385l0-325l66 0l8 44l3 0q21-22 47.5-37q26.5-15 59.5-15q56 0 79.5 35.5q23.5 35.5 23.5 94.5l0 203l-84 0l0-192q0-34-9-52.5q-9-18.5-40-18.5q-18 0-34.5 10q-16.5 10-36.5 29l0 224z"], "₀": [372, "m186 194q-46 0-81-24.5q-35-24.5-55-71q-20-46.5-20-112.5q0-98 43.5-152q43.5-54 112.5-54q69 0 112.5 54q43.5 54 43.5 152q0 66-20 112.5q-20 46.5-55 71q-35 24.5-81 24.5zm0-67q32 0 52.5-33.5q20.5-33.5 20.5-107.5q0-74-20.5-106.5q-20.5-32.5-52.5-32.5q-31 0-52 32.5q-21 32.5-21 106.5q0 74 21 107.5q21 33.5 52 33.5z"], "₁": [372, "m168 182l0-294l-86 0l0-54q37-6 59-16q22-10 45-26l69 0l0 390z"], "₂": [372, "m48 182l0-48q56-47 95.5-85q39.5-38 61-68.5q21.5-30.5 21.5-57.5q0-33-17.5-52q-17.5-19-48.5-19q-22 0-41 14.5q-19 14.5-36 37.5l-50-46q27-37 62.5-57.5q35.5-20.5 77.5-20.5q62 0 99.5 33.5q37.5 33.5 37.5 95.5q0 34-16.5 66.5q-16.5 32.5-44.5 65q-28 32.5-63 68.5l141 0l0 73z"], "₃": [372, "m183 194q-49 0-88.5-21q-39.5-21-63.5-57l54-42q18 26 41 39.5q23 13.5 50 13.5q27 0 47-15q20-15 20-43q0-30-27.5-45q-27.5-15-79.5-15l0-51q43 0 67.5-16.5q24.5-16.5 24.5-43.5q0-24-16-37.5q-16-13.5-43-13.5q-21 0-39 12q-18 12-33 31l-50-44q29-32 61-49q32-17 75-17q35 0 64.5 13q29.5 13 47.5 37q18 24 18 57q0 33-16.5 55.5q-16.5 22.5-45.5 37.5q32 10 54.5 34.5q22.5 24.5 22.5 60.5q0 36-20 63q-20 27-53 41.5q-33 14.5-72 14.5z"], "₄": [372, "m217 182l0-209l5-113l-4 0l-45 79l-51 89l230 0l0 59l-314 0l0-44l152-251l104 0l0 390z"], "₅": [372, "m185 194q-52 0-90.5-21q-38.5-21-63.5-57l54-42q19 26 41 39.5q22 13.5 51 13.5q30 0 49-20.5q19-20.5 19-51.5q0-34-20-53q-20-19-50-19q-20 0-35.5 7.5q-15.5 7.5-30.5 19.5l-39-27l18-191l225 0l0 74l-156 0l-8 74q13-5 27.5-7.5q14.5-2.5 26.5-2.5q52 0 89.5 33.5q37.5 33.5 37.5 95.5q0 39-19 69.5q-19 30.5-51.5 48q-32.5 17.5-74.5 17.5z"], "₆": [372, "m199 194q-74 0-116.5-54.5q-42.5-54.5-42.5-146.5q0-68 22-115.5q22-47.5 62-72.5q40-25 92-25q39 0 64 11q25 11 42 25l-34 56q-15-10-31-17.5q-16-7.5-36-7.5q-33 0-55.5 18q-22.5 18-34.5 53q-12 35-12 86q0 64 22.5 93.5q22.5 29.5 54.5 29.5q25 0 42-17.5q17-17.5 17-48.5q0-30-16-48q-16-18-47-18q-19 0-37.5 9.5q-18.5 9.5-38.5 31.5l-3-55q20-23 45-34.5q25-11.5 53-11.5q58 0 90 34q32 34 32 90q0 38-17.5 68.5q-17.5 30.5-48 48.5q-30.5 18-68.5 18z"], "₇": [372, "m124 182q4-64 16.5-116q12.5-52 36-100q23.5-48 60.5-101l-187 0l0-73l284 0l0 47q-46 58-70.5 111.5q-24.5 53.5-34.5 109q-10 55.5-14 122.5z"], "₈": [372, "m185 194q-63 0-103-33q-40-33-40-77q0-35 22.5-62q22.5-27 49.5-43l0-4q-25-17-41.5-38.5q-16.5-21.5-16.5-51.5q0-48 38-76.5q38-28.5 91-28.5q55 0 93 28q38 28 38 77q0 20-8.5 37.5q-8.5 17.5-22 30.5q-13.5 13-28.5 22l0 4q32 16 52 41q20 25 20 62q0 47-40.5 79.5q-40.5 32.5-103.5 32.5zm20-242q33-29 33-62q0-23-15.5-35.5q-15.5-12.5-37.5-12.5q-21 0-36 12.5q-15 12.5-15 32.5q0 25 20.5 39.5q20.5 14.5 50.5 25.5zm-20 182q27 0 46-17q19-17 19-40q0-20-12-31.5q-12-11.5-31.5-20q-19.5-8.5-42.5-18.5q-43 27-43 69q0 23 17.5 40.5q17.5 17.5 46.5 17.5z"], "₉": [372, "m154 194q-38 0-63-11q-25-11-43-25l35-56q14 10 30 17.5q16 7.5 37 7.5q32 0 54.5-18q22.5-18 34.5-53q12-35 12-86q0-64-22-93.5q-22-29.5-55-29.5q-24 0-41.5 17.5q-17.5 17.5-17.5 48.5q0 30 16.5 48q16.5 18 46.5 18q20 0 38.5-9.5q18.5-9.5 38.5-31.5l3 55q-20 22-45 34q-25 12-54 12q-57 0-89.5-34q-32.5-34-32.5-90q0-38 18-68.5q18-30.5 48-48.5q30-18 68-18q75 0 117 54q42 54 42 147q0 67-22 115q-22 48-61.5 73q-39.5 25-92.5 25z"], "€": [513, "m332 12q-74 0-131.5-38.5q-57.5-38.5-90-111.5q-32.5-73-32.5-178q0-104 33.5-178.5q33.5-74.5 90.5-114q57-39.5 129-39.5q56 0 97 23.5q41 23.5 65 61.5l-61 53q-19-24-42-36q-23-12-53-12q-46 0-78 28.5q-32 28.5-48.5 82q-16.5 53.5-16.5 127.5q0 75 17 129.5q17 54.5 49 83.5q32 29 77 29q33 0 58-15q25-15 44-44l61 43q-25 49-68 77.5q-43 28.5-100 28.5zm-310-232l0-62l71-6l303 0l0 68zm0-128l0-62l72-6l342 0l0 68z"], "←": [618, "m299 16l-275-266l0-4l275-266l56 63l-175 159l398 0l0 92l-398 0l175 159z"], "↑": [618, "m262 25l0-397l-158 175l-64-56l267-275l4 0l266 275l-63 56l-159-175l0 397z"], "→": [618, "m318 16l-56-63l174-159l-397 0l0-92l397 0l-174-159l56-63l275 266l0 4z"], "↓": [618, "m307 25l-267-275l64-56l158 175l0-397l93 0l0 397l159-175l63 56l-266 275z"], "↔": [618, "m621-254l0 4l-179 218l-62-48l108-126l-358 0l108 126l-62 48l-179-218l0-4l179-218l62 48l-108 126l358 0l-108-126l62-48z"], "↕": [618, "m311 57l-4 0l-219-179l49-62l125 108l0-351l-125 108l-49-62l219-179l4 0l218 179l-49 62l-125-108l0 351l125-108l49 62z"], "∂": [553, "m233 12q-50 0-93.5-23.5q-43.5-23.5-69.5-67q-26-43.5-26-104.5q0-67 27-118q27-51 75.5-79.5q48.5-28.5 113.5-28.5q41 0 79.5 20q38.5 20 66.5 56l-14 85q-27-40-58-56q-31-16-62-16q-38 0-65 15.5q-27 15.5-41.5 44.5q-14.5 29-14.5 71q0 34 13 58q13 24 35 36.5q22 12.5 47 12.5q32 0 59.5-17.5q27.5-17.5 48.5-52.5q21-35 32.5-89.5q11.5-54.5 11.5-128.5q0-70-13.5-114.5q-13.5-44.5-41.5-66q-28-21.5-69-21.5q-30 0-57 12q-27 12-50 36l-51-72q36-33 78-51.5q42-18.5 92-18.5q72 0 121 33.5q49 33.5 75 99q26 65.5 26 160.5q0 116-34.5 202.5q-34.5 86.5-96.5 134.5q-62 48-144 48z"], "∆": [614, "m32 0l0-70l207-584l137 0l206 584l0 70zm125-98l298 0l-85-259l-63-203l-4 0l-62 203z"], "∏": [692, "m84 120l0-756l524 0l0 756l-117 0l0-655l-291 0l0 655z"], "∑": [520, "m24 120l0-70l222-308l-211-308l0-70l452 0l0 97l-311 0l0 4l190 277l-198 276l0 4l345 0l0 98z"], "−": [513, "m34-288l0-84l445 0l0 84z"], "√": [573, "m279 88l-150-420l-73 31l-22-57l154-65l107 320q6 18 10.5 36q4.5 18 8.5 37l4 0q3-19 6.5-37q3.5-18 7.5-36l167-717l79 0l-216 908z"], "∞": [798, "m575-130q-42 0-76.5-13.5q-34.5-13.5-65-40q-30.5-26.5-61.5-66.5l-4 0q-18 22-42.5 44.5q-24.5 22.5-55.5 38q-31 15.5-71 15.5q-44 0-81-23.5q-37-23.5-58.5-61.5q-21.5-38-21.5-83q0-60 23-102q23-42 63-64.5q40-22.5 91-22.5q40 0 70.5 14.5q30.5 14.5 54.5 37q24 22.5 42 46.5l4 0q25-32 54-58q29-26 63.5-41q34.5-15 75.5-15q52 0 92.5 24q40.5 24 64.5 66.5q24 42.5 24 96.5q0 64-25 111q-25 47-66.5 72q-41.5 25-93.5 25zm-365-108q36 0 65.5-22q29.5-22 52.5-56q-27-38-57.5-62q-30.5-24-64.5-24q-38 0-59.5 21.5q-21.5 21.5-21.5 56.5q0 36 23.5 61q23.5 25 61.5 25zm365 1q46 0 72-29.5q26-29.5 26-68.5q0-47-28-76q-28-29-77-29q-38 0-73.5 24q-35.5 24-68.5 71q36 48 70.5 78q34.5 30 78.5 30z"], "∫": [376, "m99 144q-16 0-30-2.5q-14-2.5-22-4.5l12-85q7 2 16 3q9 1 19 1q41 0 53-36q12-36 12-110q0-57-6-116q-6-59-14-119.5q-8-60.5-14-121.5q-6-61-6-119q0-68 12.5-121.5q12.5-53.5 48-85q35.5-31.5 103.5-31.5q17 0 31 2q14 2 21 5l-12 85q-6-2-15-3q-9-1-20-1q-39 0-51.5 36q-12.5 36-12.5 110q0 56 5.5 115.5q5.5 59.5 13.5 120q8 60.5 14 121q6 60.5 6 119.5q0 68-12.5 121.5q-12.5 53.5-47.5 85q-35 31.5-104 31.5z"], "≈": [513, "m343-360q-30 0-53.5-12.5q-23.5-12.5-43.5-28q-20-15.5-38.5-27.5q-18.5-12-39.5-12q-20 0-39 14.5q-19 14.5-35 44.5l-62-46q33-52 68-74.5q35-22.5 70-22.5q31 0 54 12.5q23 12.5 43 28q20 15.5 38.5 27.5q18.5 12 39.5 12q21 0 39.5-14.5q18.5-14.5 34.5-44.5l61 47q-31 51-66.5 73.5q-35.5 22.5-70.5 22.5zm0 224q-30 0-53.5-12.5q-23.5-12.5-43.5-28q-20-15.5-38.5-27.5q-18.5-12-39.5-12q-20 0-39 14.5q-19 14.5-35 44.5l-62-46q33-52 68-74.5q35-22.5 70-22.5q31 0 54 12.5q23 12.5 43 28q20 15.5 38.5 27.5q18.5 12 39.5 12q21 0 39.5-14.5q18.5-14.5 34.5-44.5l61 47q-31 51-66.5 73.5q-35.5 22.5-70.5 22.5z"], "≠": [513, "m56-52l74-124l-96 0l0-84l143 0l82-140l-225 0l0-84l272 0l74-124l77 0l-74 124l96 0l0 84l-143 0l-82 140l225 0l0 84l-272 0l-74 124z"], "≤": [513, "m479-153l-445-148l0-98l445-148l0 97l-191 59l-137 39l0 4l137 39l191 59zm-445 153l0-83l445 0l0 83z"], "≥": [513, "m34-153l0-97l191-59l137-39l0-4l-137-39l-191-59l0-97l445 148l0 98zm0 153l0-83l445 0l0 83z"] };
  }
});

// app/js/print/letters.js
function widthOf(words, size, weight = 400) {
  const letters = lettersOf(weight);
  let advance = 0;
  for (const sign of String(words)) advance += (letters[sign] ?? letters[""])[0];
  return advance * size / 1e3;
}
function outlineOf(words, weight = 400) {
  const letters = lettersOf(weight);
  let advance = 0, path = "";
  for (const sign of String(words)) {
    const [width, outline2] = letters[sign] ?? letters[""];
    if (outline2) path += `M${advance} 0${outline2}`;
    advance += width;
  }
  return path;
}
var lettersOf, missingFrom, leadOf;
var init_letters = __esm({
  "app/js/print/letters.js"() {
    init_glyphs();
    lettersOf = (weight) => weight >= 600 ? bold : regular2;
    missingFrom = (words) => [...new Set(words)].filter((sign) => !(sign in regular2));
    leadOf = (width, align = "left") => ({ left: 0, center: width / 2, right: width })[align];
  }
});

// app/js/print/sheet.js
function drawSheet(pen, { width, height, cells, caption, left }, panels, lines) {
  pen.path(
    [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height]
    ],
    { fill: PAPER.paper, close: true }
  );
  panels.forEach((draw, i) => {
    const { x, y, w, h } = cells[i];
    pen.clip(x, y, w, h, () => draw(shifted(pen, { x, y }), w, h));
  });
  lines.forEach(
    (line2, i) => pen.text(line2, left, caption + i * CAPTION.line, { size: CAPTION.size, colour: PAPER.text })
  );
}
function sheetOf(count, mm, caption) {
  const lines = captionLines(caption, mm, widthOf);
  return { sheet: layoutOf(count, mm, lines.length), lines };
}
function enlarged(source, w, h) {
  const times = (drawn, given) => Math.max(1, Math.min(Math.ceil(drawn * DENSE / given), Math.floor(4096 / given)));
  const [across, down] = [times(w, source.width), times(h, source.height)];
  if (across === 1 && down === 1) return source;
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: source.width * across, height: source.height * down });
  const context = contextOf(canvas);
  context.imageSmoothingEnabled = false;
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}
function outlinedPen() {
  const pen = svgPen("", widthOf), near = (value) => +value.toFixed(2);
  return {
    ...pen,
    text(words, x, y, { size = 11, weight = 400, align, colour = PAPER.text, turn } = {}) {
      const lead = leadOf(widthOf(words, size, weight), align), [left, base] = turn ? [x, y + lead] : [x - lead, y];
      pen.parts.push(
        `<path role="img" aria-label="${escaped(words)}" ${painted("fill", colour)} transform="translate(${near(left)} ${near(base)})${turn ? " rotate(-90)" : ""} scale(${+(size / 1e3).toFixed(5)})" d="${outlineOf(words, weight)}"/>`
      );
    },
    image: (source, x, y, w, h) => pen.image(enlarged(source, w, h), x, y, w, h)
  };
}
function svgOf2({ width, height }, draw, { title, caption }) {
  const pen = outlinedPen(), mm = (value) => `${+(value / PER_MM).toFixed(3)}mm`;
  draw(pen);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${mm(width)}" height="${mm(height)}" viewBox="0 0 ${+width.toFixed(3)} ${+height.toFixed(3)}"><title>${escaped(title)}</title><desc>${escaped(caption)}</desc>
${pen.parts.join("\n")}
</svg>
`;
}
async function pngOf(svg, sheet2) {
  const dpi = densityOf(sheet2), address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })), image = Object.assign(new Image(), { src: address });
  try {
    await image.decode();
    const canvas = document.createElement("canvas");
    Object.assign(canvas, {
      width: Math.round(sheet2.width * dpi / 96),
      height: Math.round(sheet2.height * dpi / 96)
    });
    contextOf(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = (
      /** @type {Blob | null} */
      await new Promise((done) => canvas.toBlob(done))
    );
    if (!blob) throw new Error("The browser cannot draw a picture of this size: choose fewer panels, or SVG.");
    return new Blob([withDensity(new Uint8Array(await blob.arrayBuffer()), dpi)], { type: "image/png" });
  } finally {
    URL.revokeObjectURL(address);
  }
}
function crcOf(bytes) {
  let crc = 4294967295;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? crc >>> 1 ^ 3988292384 : crc >>> 1;
  }
  return (crc ^ 4294967295) >>> 0;
}
function withDensity(png, dpi) {
  const chunk = new Uint8Array(21), view = new DataView(chunk.buffer), dots = Math.round(dpi / 0.0254);
  view.setUint32(0, 9);
  chunk.set([112, 72, 89, 115], 4);
  view.setUint32(8, dots);
  view.setUint32(12, dots);
  chunk[16] = 1;
  view.setUint32(17, crcOf(chunk.subarray(4, 17)));
  const out = new Uint8Array(png.length + chunk.length);
  out.set(png.subarray(0, 33));
  out.set(chunk, 33);
  out.set(png.subarray(33), 54);
  return out;
}
var DENSE, MOST2, densityOf;
var init_sheet = __esm({
  "app/js/print/sheet.js"() {
    init_colours();
    init_drawing();
    init_layout();
    init_letters();
    DENSE = 300 / 96;
    MOST2 = 16e6;
    densityOf = ({ width, height }) => width * height * (600 / 96) ** 2 <= MOST2 ? 600 : 300;
  }
});

// app/js/print/document.js
function penOf(pdf) {
  const opaque = (fill, stroke) => pdf.setGState(pdf.GState({ opacity: fill, "stroke-opacity": stroke }));
  return {
    path(points, { stroke, width = 1, dash = [], fill, close } = {}) {
      const lines = stroke && stroke !== "none" ? inkOf(stroke) : null, area = fill && fill !== "none" ? inkOf(fill) : null;
      if (!lines && !area || !points.some(Boolean)) return;
      opaque(area?.alpha ?? 1, lines?.alpha ?? 1);
      if (area) pdf.setFillColor(area.hex);
      if (lines) pdf.setDrawColor(lines.hex).setLineWidth(width).setLineJoin("round").setLineDashPattern(dash, 0);
      let down = false;
      for (const point of points) {
        if (point) down ? pdf.lineTo(point[0], point[1]) : pdf.moveTo(point[0], point[1]);
        down = Boolean(point);
      }
      if (close) pdf.close();
      if (area && lines) pdf.fillStroke();
      else if (area) pdf.fill();
      else pdf.stroke();
    },
    text(words, x, y, { size = 11, weight = 400, align, colour = PAPER.text, turn } = {}) {
      if (!words) return;
      const lead = leadOf(widthOf(words, size, weight), align), { hex, alpha } = inkOf(colour);
      opaque(alpha, 1);
      pdf.setFont(FAMILY, weight >= 600 ? "bold" : "normal").setFontSize(size * 0.75).setTextColor(hex);
      if (turn) pdf.text(String(words), x, y + lead, { angle: 90 });
      else pdf.text(String(words), x - lead, y);
    },
    image(source, x, y, w, h) {
      opaque(1, 1);
      pdf.addImage(enlarged(source, w, h), "PNG", x, y, w, h, void 0, "FAST");
    },
    clip(x, y, w, h, draw) {
      pdf.saveGraphicsState();
      pdf.rect(x, y, w, h, null).clip().discardPath();
      draw();
      pdf.restoreGraphicsState();
    },
    width: widthOf
  };
}
function pdfOf({ jsPDF, regular: regular3, bold: bold2 }, { width, height }, draw, { title, caption }) {
  const pdf = new jsPDF({
    unit: "px",
    hotfixes: ["px_scaling"],
    // a pixel is 1/96 inch, not 1/72 of something else
    format: [width, height],
    orientation: width > height ? "landscape" : "portrait",
    compress: true,
    putOnlyUsedFonts: true
    // the others would be named without being embedded, which printers refuse
  });
  for (const [weight, font] of Object.entries({ normal: regular3, bold: bold2 })) {
    pdf.addFileToVFS(`${weight}.ttf`, font);
    pdf.addFont(`${weight}.ttf`, FAMILY, weight);
  }
  pdf.setProperties({ title, subject: caption });
  draw(penOf(pdf));
  return pdf.output("arraybuffer");
}
var FAMILY;
var init_document = __esm({
  "app/js/print/document.js"() {
    init_colours();
    init_letters();
    init_sheet();
    FAMILY = "Workbench";
  }
});

// app/js/print/print.js
var print_exports = {};
__export(print_exports, {
  openPrint: () => openPrint,
  printable: () => printable,
  sheetFor: () => sheetFor
});
async function worldOf2(box, w, h) {
  const { data, layout } = (
    /** @type {any} */
    box
  );
  const annotations = layout.annotations?.map((each) => each.bgcolor ? { ...each, bgcolor: PAPER.paper } : each);
  const light = { ...layout, annotations, paper_bgcolor: PAPER.paper, plot_bgcolor: PAPER.paper, width: w, height: h };
  const address = await globalThis.Plotly.toImage(
    { data, layout: { ...light, font: { ...layout.font, color: PAPER.text, size: 11 } } },
    { format: "png", width: w, height: h, scale: 600 / 96 }
  );
  const image = Object.assign(new Image(), { src: address });
  await image.decode();
  const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
  canvas.getContext("2d")?.drawImage(image, 0, 0);
  return canvas;
}
function onPaper(scene, draw) {
  const { model, state, seen } = scene, { colours, hover, band, at, resolution: window2 } = scene, row = seen.readRow;
  Object.assign(scene, { colours: PAPER, hover: {}, band: void 0, at: row });
  scene.resolution = resolution(model, state, seen, row);
  try {
    draw();
  } finally {
    Object.assign(scene, { colours, hover, band, at, resolution: window2 });
  }
}
async function sheetFor(lens2, names, mm) {
  const { scene } = lens2, chosen = printable(lens2).filter((name) => names.includes(name)), caption = captionOf(scene, chosen), { sheet: sheet2, lines } = sheetOf(chosen.length, mm, caption);
  const graph = chosen[0] === "world" && lens2.world ? await worldOf2(lens2.world.box, sheet2.cells[0].w, sheet2.cells[0].h) : null;
  const panels = chosen.map((name) => {
    const each = lens2.panels.find(({ panel }) => panel.name === name);
    return (pen, w, h) => each ? lens2.drawOne(pen, each, w, h) : pen.image(graph, 0, 0, w, h);
  });
  return {
    sheet: sheet2,
    about: {
      title: `${scene.model.header.world}: ${chosen.map((name) => titleOf(lens2, name)).join(", ")}`,
      caption
    },
    draw: (pen) => onPaper(scene, () => drawSheet(pen, sheet2, panels, lines))
  };
}
async function fileOf({ sheet: sheet2, draw, about }, format) {
  if (format === "PDF")
    return new Blob([pdfOf(await import("./pdf.js"), sheet2, draw, about)], { type: "application/pdf" });
  const svg = svgOf2(sheet2, draw, about);
  return format === "PNG" ? pngOf(svg, sheet2) : new Blob([svg], { type: "image/svg+xml" });
}
function openPrint(lens2) {
  const { host } = lens2, names = printable(lens2), live = Boolean(lens2.told.live);
  const field = (type, name, value, words, checked, disabled = false) => element("label", {}, element("input", { type, name, value, checked, disabled }), ` ${words}`);
  const boxes = names.map((name) => field("checkbox", "panel", name, titleOf(lens2, name), name === "tau-space"));
  const group = (legend, ...parts) => element("fieldset", {}, element("legend", {}, legend), ...parts);
  const preview = element("img", { alt: "" }), status = element("p", { role: "status" }), saver = element("button", { type: "submit", class: "remedy" }, "Save");
  const form = element(
    "form",
    { method: "dialog" },
    group("Panels", ...boxes, element("button", { type: "button", class: "tool", onclick: all }, "All panels")),
    group("Width", ...WIDTHS.map((mm, i) => field("radio", "mm", mm, `${mm} mm`, !i))),
    group(
      "File",
      ...FORMATS.map(
        (name) => field("radio", "format", name, name, name === (live ? "PDF" : "SVG"), !live && name === "PDF")
      )
    ),
    ...live ? [] : [element("p", {}, "A PDF is saved in the workbench: its writer is too large for this file.")],
    element(
      "span",
      { class: "group" },
      saver,
      element("button", { type: "button", class: "tool", onclick: () => dialog.close() }, "Close")
    ),
    status
  );
  const dialog = element(
    "dialog",
    { class: "print", "aria-label": "Save for print" },
    form,
    element("figure", {}, preview)
  );
  const chosen = () => {
    const data = new FormData(form);
    return { panels: data.getAll("panel").map(String), mm: Number(data.get("mm")), format: String(data.get("format")) };
  };
  let asked = 0;
  function all() {
    form.querySelectorAll("input[name=panel]").forEach((box) => Object.assign(box, { checked: true }));
    show();
  }
  const say = (words) => {
    status.textContent = words;
  };
  async function show() {
    const { panels, mm, format } = chosen(), mine = ++asked;
    saver.disabled = !panels.length;
    if (!panels.length) {
      say("Tick at least one panel.");
      return;
    }
    const made = await sheetFor(lens2, panels, mm), file = await fileOf(made, "SVG");
    if (mine !== asked || !dialog.isConnected) return;
    URL.revokeObjectURL(preview.src);
    preview.src = URL.createObjectURL(file);
    preview.alt = made.about.caption;
    const { sheet: sheet2 } = made, boxed = missingFrom(made.about.title + made.about.caption);
    say(
      `${mm} × ${Math.round(sheet2.height / PER_MM)} mm${format === "PNG" ? `, ${densityOf(sheet2)} dots per inch` : ""}` + (boxed.length ? `. The font has no ${boxed.join(" ")}: a box is printed instead.` : "")
    );
  }
  form.onchange = show;
  form.onsubmit = async (event) => {
    event.preventDefault();
    const { panels, mm, format } = chosen();
    try {
      const file = await fileOf(await sheetFor(lens2, panels, mm), format);
      const what = panels.length === 1 ? panels[0] : `${panels.length}_panels`;
      save(file, `${nameOf(lens2)}_${what}_${mm}mm.${format.toLowerCase()}`);
      say(`Saved as ${format}.`);
    } catch (error) {
      say(`The picture could not be saved: ${error.message}`);
    }
  };
  dialog.onclose = () => {
    URL.revokeObjectURL(preview.src);
    dialog.remove();
  };
  host.append(dialog);
  dialog.showModal();
  show();
}
var FORMATS, printable, titleOf;
var init_print = __esm({
  "app/js/print/print.js"() {
    init_colours();
    init_elements();
    init_maths();
    init_export();
    init_help();
    init_caption();
    init_layout();
    init_document();
    init_letters();
    init_sheet();
    FORMATS = ["PDF", "SVG", "PNG"];
    printable = ({ world, panels }) => [...world ? ["world"] : [], ...panels.map(({ panel }) => panel.name)];
    titleOf = ({ panels }, name) => panels.find(({ panel }) => panel.name === name)?.panel.title ?? WORLD.title;
  }
});

// app/js/lens/standalone.js
init_elements();

// app/js/draw/columns.js
init_drawing();
var APART = 34;
function columnAt({ thetas, H }, theta) {
  let low = 0, high = H - 1;
  while (low < high) {
    const middle = low + high + 1 >> 1;
    if (thetas[middle] <= theta) low = middle;
    else high = middle - 1;
  }
  return low;
}
function rewardWords(seen, theta) {
  const { thetas, H, open: open2 } = seen, h = columnAt(seen, theta);
  return open2 && !h ? `below ${short(thetas[1])}` : open2 && h === H - 1 ? `above ${short(thetas[h])}` : short(theta);
}
function placeOf({ thetas, H, open: open2 }, reward) {
  if (open2 && reward < thetas[1]) return (thetas[0] + thetas[1]) / 2;
  return open2 && reward > thetas[H - 1] ? (thetas[H - 1] + thetas[H]) / 2 : reward;
}
function acrossOf(seen, theta) {
  const h = columnAt(seen, theta), { thetas } = seen;
  return h + (theta - thetas[h]) / (thetas[h + 1] - thetas[h]);
}
function thetaOf({ thetas, H }, across) {
  const h = Math.min(H - 1, Math.max(0, Math.floor(across)));
  return thetas[h] + (across - h) * (thetas[h + 1] - thetas[h]);
}
function even({ thetas, H }) {
  const step = (thetas[H] - thetas[0]) / H;
  return thetas.every((theta, h) => Math.abs(theta - thetas[0] - step * h) < 1e-3 * step);
}
function thetaTicks(seen, [first, last], width) {
  const { thetas, H, open: open2 } = seen, low = open2 ? Math.max(first, thetas[1]) : first, high = open2 ? Math.min(last, thetas[H - 1]) : last;
  if (low >= high) return [];
  if (even(seen)) return ticks(low, high);
  const most = Math.ceil(Math.log10(Math.max(-low, high))), powers = Array.from({ length: 7 }, (_, i) => 10 ** (most - i));
  const [left, right] = [first, last].map((theta) => acrossOf(seen, theta)), found = [];
  const place2 = (theta) => width * (acrossOf(seen, theta) - left) / (right - left);
  const wished = [
    0,
    ...[1, 5, 2].flatMap((n) => powers.flatMap((power) => [n * power, -n * power])),
    ...ticks(low, high)
  ];
  for (const theta of wished) {
    const apart = found.every((other) => Math.abs(place2(other) - place2(theta)) >= APART);
    if (theta >= low && theta <= high && apart) found.push(theta);
  }
  return found;
}

// app/js/lens/lens.js
init_colours();
init_elements();

// app/js/lens/controls.js
init_drawing();
init_elements();
init_maths();
var logarithmic = (low, high, perDecade = 40) => {
  const count = Math.round(perDecade * Math.log10(high / low));
  const of = (value) => Math.round(count * Math.log10(Math.max(low, value) / low) / Math.log10(high / low));
  return {
    count,
    of,
    at: (i) => {
      const exact = low * (high / low) ** (i / count), plain = +exact.toPrecision(2);
      return of(plain) === i ? plain : +exact.toPrecision(3);
    }
  };
};
var linear = (low, step, count) => ({
  count,
  at: (i) => +(low + i * step).toPrecision(12),
  of: (value) => Math.round((value - low) / step)
});
var withZero = (scale) => ({
  count: scale.count + 1,
  at: (i) => i ? scale.at(i - 1) : 0,
  of: (value) => value > 0 ? scale.of(value) + 1 : 0
});
var near1 = {
  count: 120,
  at: (i) => +(1 - 10 ** (-0.3 - i * 2.7 / 120)).toPrecision(5),
  of: (value) => Math.round((-Math.log10(1 - value) - 0.3) * 120 / 2.7)
};
var SLIDERS = [
  [
    "alpha",
    "regularisation α",
    "",
    "Regularisation of the inverse: it keeps the share s²/(s²+α²) of each singular value s.",
    logarithmic(1e-9, 10)
  ],
  [
    "slope",
    "slope",
    "/ reward",
    "Steepness of the reward activation.",
    (model, base) => model.sloped && logarithmic(base.slope / 30, base.slope * 30, 60)
  ],
  [
    "slope_share",
    "slope",
    "· trained",
    "Softer than the trained activation, by a linear map over θ; its error is given under gamma-space. Rewards that are softened beyond the range of θ count in the outermost column, which moves means.",
    ({ arrays }) => arrays.places && linear(0.1, 0.05, 18)
  ],
  [
    "horizon",
    "horizon T",
    "steps",
    "Deadline of the episode, in steps of the world.",
    ({ horizons, dt, K }) => linear(horizons[0], dt, K - 1)
  ],
  [
    "used",
    "steps used",
    "",
    "Steps of the episode that are over: the time to go is T minus these.",
    ({ truth, K, dt }) => truth && linear(0, 1, Math.max(0, Math.floor(K * dt) - 1))
  ],
  [
    "softness",
    "deadline softness",
    "· T",
    "Width of the deadline, as a share of the horizon; 0 is a hard one.",
    linear(0, 0.05, 20)
  ],
  ["value_gamma", "γ in the value", "", "Discount of the values that are compared.", near1],
  [
    "noise",
    "noise",
    "",
    "Noise in gamma-space: standard deviation of (1 − γ) Q, seeded.",
    withZero(logarithmic(1e-7, 0.1, 6))
  ]
];
var LEADING = ["alpha", "horizon"];
var MOST_TURNS = 3;
var ALPHAS = (
  /** @type {Places} */
  SLIDERS[0][4]
);
function sliders(model, base, wish, leading) {
  const box = element("div", { class: leading ? "sliders leading" : "sliders" }), shown = {};
  for (const [name, label, unit, help, made] of SLIDERS) {
    if (LEADING.includes(name) !== leading) continue;
    const scale = typeof made === "function" ? made(model, base) : made;
    if (!scale) continue;
    const output = element("output", {}), input = element("input", {
      type: "range",
      min: 0,
      max: Math.max(1, scale.count),
      step: 1,
      title: help,
      name,
      "aria-label": label,
      disabled: scale.count < 1
    });
    const byHand = name === "alpha" ? { selector: "typed" } : {};
    input.oninput = () => wish({ [name]: scale.at(+input.value), ...byHand }, false);
    input.onchange = () => wish({}, true);
    const extra = name === "alpha" ? [
      element(
        "button",
        {
          type: "button",
          class: "small play",
          "aria-label": "sweep alpha",
          title: "Sweep alpha up and down",
          onclick: () => wish("play", true)
        },
        "▶"
      )
    ] : name === "noise" ? [
      element(
        "button",
        {
          type: "button",
          class: "small",
          "aria-label": "another noise",
          title: "Another seed",
          onclick: () => wish("seed", true)
        },
        "⚄"
      )
    ] : [];
    box.append(element("div", { class: "slider" }, element("span", { class: "name" }, label), ...extra, output, input));
    shown[name] = (state, rule) => {
      if (name === "noise") extra[0].disabled = !state.noise;
      const at = scale.of(state[name]), chosen = name === "alpha" && state.selector !== "typed" ? ` · ${rule ?? state.selector}` : "", words = `${short(state[name], 4)}${unit ? ` ${unit}` : ""}${chosen}`;
      if (+input.value !== at) input.value = String(at);
      if (output.value !== words) {
        output.value = words;
        input.setAttribute("aria-valuetext", words);
      }
    };
  }
  return { box, sync: (state, rule) => Object.values(shown).forEach((show) => show(state, rule)) };
}
function turnsStrip({ header: { actions } }, wish) {
  const strip = element("div", { class: "strip", "aria-hidden": "true" }), words = element("span", { class: "group" }), box = element("div", { class: "turns" }, strip, words);
  return {
    box,
    show(turns) {
      if (!turns) {
        box.classList.add("old");
        return;
      }
      box.classList.remove("old");
      strip.replaceChildren(
        ...turns.map(({ from, action }, i) => {
          const to = turns[i + 1]?.from ?? ALPHAS.count;
          return element("i", { style: `flex: ${to - from || 1}; background: ${actionColour(action)}` });
        })
      );
      const found = turns.slice(1), button = ({ from, action }) => element(
        "button",
        {
          type: "button",
          class: "tool",
          title: `from there on ${actions[action]} is chosen`,
          onclick: () => wish({ alpha: ALPHAS.at(from) }, true)
        },
        short(ALPHAS.at(from))
      );
      words.replaceChildren(
        ...found.length ? ["choice turns at α =", ...found.slice(-MOST_TURNS).map(button)] : [`${actions[turns[0].action]} is chosen at every α`]
      );
    }
  };
}
function switchboard(model, wish) {
  const box = element("div", { class: "switches", role: "group", "aria-label": "artefacts" }), shown = {};
  const together = (words, on) => element("button", { type: "button", class: "together", onclick: () => wish(on, true) }, words);
  const names = Object.keys(SWITCHES).filter((name) => available(model, name));
  const all = (on) => Object.assign({}, ...names.map((name) => on && name !== "shift" ? SWITCHES[name].on : SWITCHES[name].off));
  box.append(
    element("div", { class: "pair" }, together("As the paper", all(true)), together("All repaired", all(false)))
  );
  for (const [name, each] of Object.entries(SWITCHES)) {
    const there = names.includes(name), size = element("span", { class: "size" }, there ? " " : "not available here");
    const button = element(
      "button",
      { type: "button", role: "switch", class: "switch", name, title: each.help, disabled: !there },
      element("i", {}),
      element("b", {}, each.label),
      size
    );
    box.append(button);
    shown[name] = {
      size,
      show: (state) => {
        button.setAttribute("aria-checked", String(there && each.isOn(state)));
        button.onclick = () => wish(each.isOn(state) ? each.off : each.on, true);
      }
    };
  }
  return {
    box,
    sync: (state) => Object.values(shown).forEach(({ show }) => show(state)),
    sizes(effects2) {
      for (const [name, found] of Object.entries(effects2)) {
        const moves = name === "constant" ? "" : found.size < 5e-4 ? "no effect here" : `moves ${short(found.size, 2)} probability`;
        const more = (found.on ?? NaN) - (found.off ?? NaN), told = found.on === void 0 || found.off === void 0 || model.A === 1 ? "" : Math.abs(more) > 1e-6 ? `regret ${short(found.off)} → ${short(found.on)}` : "same choice";
        shown[name].size.textContent = [moves, told].filter(Boolean).join(" · ");
        shown[name].size.classList.toggle("large", more > 1e-6 || found.size >= 0.05 && !(more < -1e-6));
      }
    }
  };
}
function toolbar(model, wish, told) {
  const button = (kind, words, does2, more) => element("button", { type: "button", class: kind, onclick: does2, ...more }, words);
  const chips = model.header.actions.map(
    (name, a) => button("chip", name, () => wish({ action: a }, true), {
      style: `--chip: ${actionColour(a)}`,
      title: `show ${name}`
    })
  );
  const looks = ["heatmap", "surface"].map((look) => button("chip", look, () => wish({ look }, true)));
  const rows = element(
    "select",
    {
      "aria-label": "rows of tau-space",
      onchange: () => wish({ normalise: (
        /** @type {State['normalise']} */
        rows.value
      ) }, true)
    },
    ...[
      ["none", "rows as decoded"],
      ["survival", "rows given survival"],
      ["paper", "rows rescaled to 1"]
    ].map(([value, words]) => element("option", { value }, words))
  );
  const added = element(
    "select",
    {
      name: "added",
      "aria-label": "discounts added",
      title: "Discounts that were never trained, each interpolated between its two neighbours. They add no information, and let more noise through at the same α.",
      onchange: () => wish({ added: +added.value }, true)
    },
    ...["trained discounts", "+ 1 in each gap", "+ 2 in each gap", "+ 3 in each gap"].map(
      (words, value) => element("option", { value }, words)
    )
  );
  const does = (words, name, title = name, keys = "") => button("tool", words, () => wish(name, true), {
    "aria-label": name,
    title,
    "aria-keyshortcuts": keys || void 0
  });
  const undo = does("↶", "undo", "undo (Ctrl+Z)", "Control+Z"), redo = does("↷", "redo", "redo (Ctrl+Shift+Z)", "Control+Shift+Z"), reset = does("reset", "reset", "back to the world’s own settings");
  const pin = button("tool", "pin as A", () => wish("pin", true), {
    title: "keep this view as A and compare what you change with it"
  });
  const link = button(
    "tool",
    "copy link",
    async () => {
      await navigator.clipboard.writeText(location.href).then(
        () => {
          link.textContent = "copied";
        },
        () => {
          link.textContent = "copy the address bar";
        }
      );
      setTimeout(() => {
        link.textContent = "copy link";
      }, 1500);
    },
    { title: "the address bar is a link to exactly this view" }
  );
  const wide = button("chip", "all θ", () => wish("wide", true), {
    title: "draw all sensitivities, not only those where rewards are"
  }), taken = button("chip", "action taken", () => wish("follow", true), {
    title: "look at the action that was taken at each step of the episode"
  });
  const group = (name, ...parts) => element("span", { class: "group", role: "group", "aria-label": name }, ...parts);
  const box = element(
    "div",
    { class: "toolbar" },
    group("action", ...chips, taken),
    group("drawing", ...looks, wide),
    rows,
    ...model.arrays.places && told.live ? [added] : [],
    group("history", undo, redo, reset),
    ...told.live ? [group("keep", ...told.pinnable ? [pin] : [], link)] : []
  );
  return {
    box,
    sync(state, history, { pinned, followed, follows }, isWide) {
      wide.setAttribute("aria-pressed", String(isWide));
      taken.hidden = !followed;
      taken.setAttribute("aria-pressed", String(Boolean(follows)));
      chips.forEach((chip, a) => chip.setAttribute("aria-pressed", String(a === state.action)));
      looks.forEach((chip) => chip.setAttribute("aria-pressed", String(chip.textContent === state.look)));
      rows.value = state.normalise;
      added.value = String(state.added);
      undo.disabled = history.at <= 0;
      redo.disabled = history.at >= history.states.length - 1;
      pin.textContent = pinned ? "unpin A" : "pin as A";
    }
  };
}
function footer(presets, files, wish) {
  const box = element("div", { class: "footer" });
  if (presets.length)
    box.append(
      element(
        "span",
        { class: "group", role: "group", "aria-label": "examples" },
        element("span", { class: "name" }, "See"),
        ...presets.map(
          (preset) => element("button", { type: "button", class: "tool", onclick: () => wish({ preset }, true) }, preset.name)
        )
      )
    );
  box.append(
    element(
      "span",
      { class: "group", role: "group", "aria-label": "downloads" },
      element("span", { class: "name" }, "Save"),
      ...files.map(
        ([words, save2]) => element("button", { type: "button", class: "tool", "aria-label": `save ${words}`, onclick: save2 }, words)
      )
    )
  );
  return box;
}

// app/js/lens/lens.js
init_drawing();

// app/js/draw/keys.js
var TYPED = "input:not([type=range], [type=checkbox], [type=radio], [type=button]), textarea, [contenteditable]";
function onUndo(host, does) {
  const heard = (event) => {
    if (!host.isConnected) {
      document.removeEventListener("keydown", heard);
      return;
    }
    const { key, target } = event;
    if (!(event.ctrlKey || event.metaKey) || event.altKey || key.toLowerCase() !== "z") return;
    if (target instanceof Element && target.closest(TYPED)) return;
    if (document.querySelector("dialog[open], [role=dialog]")) return;
    event.preventDefault();
    does(event.shiftKey ? "redo" : "undo");
  };
  document.addEventListener("keydown", heard);
}

// app/js/hub.js
var lens;
var leader;
var hub = {
  // The lens on the page; none where there is none, or where it was taken off.
  get lens() {
    return lens?.host.isConnected ? lens : void 0;
  },
  set lens(mounted) {
    lens = mounted;
  },
  // The player whose cursor the lens follows: { id, step, over(model) }.
  get leader() {
    return leader;
  },
  set leader(player) {
    leader = player;
  }
};

// app/js/lens/lens.js
init_export();

// app/js/lens/hand.js
var isSpace = (panel) => Boolean(panel.rows);
var limited = (value, low, high) => Math.min(high, Math.max(low, value));
var KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
function listen(canvas, panel, scene, draw) {
  const space = isSpace(panel), solid = () => space && scene.state.look === "surface";
  function point(hover) {
    if (JSON.stringify(hover) === JSON.stringify(scene.hover)) return;
    scene.hover = hover;
    draw();
  }
  function turn(across, up) {
    const { camera } = scene;
    scene.camera = { turn: camera.turn + across, tilt: limited(camera.tilt + up, 0.1, 1.5) };
    draw();
  }
  function zoomed() {
    const { band } = scene;
    scene.band = void 0;
    if (band) show([band.from[0], band.to[0]], [band.from[1], band.to[1]]);
  }
  function show(across, up) {
    const { scale } = canvas, { seen, model } = scene, { thetas, H } = seen, least = 8;
    if (!scale || !panel.rows) return;
    const rows = panel.rows === "tau" ? model.K : seen.grid.G, sorted = (a, b) => [Math.min(a, b), Math.max(a, b)];
    const within = (ends, low, high) => sorted(...ends.map((end) => limited(end, low, high)));
    const theta = within(across.map(scale.toX), thetas[0], thetas[H]), row = within(up.map(scale.toY), -0.5, rows - 0.5);
    if (Math.abs(across[0] - across[1]) > least && theta[1] > theta[0]) scene.zoom.theta = theta;
    if (Math.abs(up[0] - up[1]) > least && row[1] > row[0]) scene.zoom[panel.rows] = row;
    draw();
  }
  function zoomBy(factor) {
    if (!canvas.scale || !panel.rows) return;
    const { X, Y, box } = canvas.scale, { hover } = scene, row = hover[panel.rows];
    const place2 = (at, from, length) => [at - factor * (at - from), at + factor * (from + length - at)];
    show(
      place2(hover.theta === void 0 ? box.x + box.w / 2 : X(hover.theta), box.x, box.w),
      place2(row === void 0 ? box.y + box.h / 2 : Y(row), box.y, box.h)
    );
  }
  function all() {
    scene.zoom = {};
    draw();
  }
  canvas.onpointermove = (event) => {
    const at = [event.offsetX, event.offsetY];
    if (scene.band) {
      scene.band.to = at;
      draw();
    }
    if (solid()) {
      if (event.buttons) turn(event.movementX * 0.01, event.movementY * 0.01);
      return;
    }
    const { scale } = canvas, [x, y] = at;
    if (!scale) return;
    const { box } = scale;
    const within = x >= box.x && x <= box.x + box.w && y >= box.y - 2 && y <= box.y + box.h + 2;
    point(within ? panel.point(scene, scale.toX(x), scale.toY(y)) : {});
  };
  canvas.onpointerleave = () => point({});
  canvas.onkeydown = (event) => {
    if (event.key === "Escape" && scene.band) {
      scene.band = void 0;
      draw();
    } else if (event.key === "Escape") {
      all();
      point({});
    }
    if (event.key === "+" && space && !solid()) zoomBy(0.5);
    if (event.key === "-" && space && !solid()) zoomBy(2);
    if (!KEYS[event.key]) return;
    event.preventDefault();
    const { hover, seen, model } = scene, [across, up] = KEYS[event.key], far = event.shiftKey ? 10 : 1;
    if (solid()) {
      turn(0.1 * across, 0.1 * up);
      return;
    }
    const stepped = (name, by, count2) => limited((hover[name] ?? -1) + by * far, 0, count2 - 1);
    if (!panel.rows) {
      point({ tau: stepped("tau", across || up, model.K) });
      return;
    }
    const from = hover.theta === void 0 ? seen.H / 2 : acrossOf(seen, hover.theta);
    const count = panel.rows === "tau" ? model.K : seen.grid.G;
    point({
      theta: thetaOf(seen, limited(from + across * far, 0, seen.H)),
      [panel.rows]: stepped(panel.rows, up, count)
    });
  };
  if (!space) return;
  canvas.title = "Drag to zoom or to turn, double-click for all of it; with the keyboard arrows, + and -";
  canvas.onpointerdown = (event) => {
    if (event.pointerType !== "mouse" && !solid()) return;
    canvas.setPointerCapture(event.pointerId);
    const at = [event.offsetX, event.offsetY];
    if (!solid()) scene.band = { panel, from: at, to: at };
  };
  canvas.onpointerup = zoomed;
  canvas.ondblclick = all;
}

// app/js/lens/lens.js
init_help();
init_maths();

// app/js/core/reading.js
init_algebra();
init_maths();
var REACH = 2;
var SHOWN = 0.02;
function windowsOf({ arrays, cache, truth }, state, { thetas, H, open: open2 }) {
  const { places } = arrays;
  if (!truth && !places) return null;
  return remember(cache, "windows", [state.slope, state.slope_share, thetas[0], H], () => {
    let x = thetas.map((theta) => theta * state.slope);
    if (places) {
      const last = places.length - 1, padded = open2 ? [2 * places[0] - places[1], ...places, 2 * places[last] - places[last - 1]] : [...places];
      x = Float64Array.from(padded, (place2) => place2 * state.slope_share);
    }
    const middle = Float64Array.from({ length: H }, (_, h) => (x[h] + x[h + 1]) / 2), from = new Int32Array(H), to = new Int32Array(H), whole = new Float64Array(H);
    for (let h = 0, low = 0, high = 0; h < H; h++) {
      while (middle[h] - middle[low] > REACH) low++;
      while (high < H && middle[high] - middle[h] <= REACH) high++;
      [from[h], to[h]] = [low, high];
      whole[h] = 2 * sigmoid(Math.max(middle[h] - x[low], x[high] - middle[h])) - 1;
    }
    return { from, to, whole };
  });
}
function onScale(rows, H, windows) {
  if (!windows) return rows;
  const { from, to, whole } = windows, out = new Float64Array(rows.length), sums = new Float64Array(H + 1);
  for (let start = 0; start < rows.length; start += H) {
    for (let h = 0; h < H; h++) sums[h + 1] = sums[h] + rows[start + h];
    for (let h = 0; h < H; h++) out[start + h] = (sums[to[h]] - sums[from[h]]) / whole[h];
  }
  return out;
}
function rewardRange({ A, cache }, { thetas, H, masses: masses2, grid, map }) {
  const kinds = Object.values(grid.columns).filter(Boolean);
  return remember(cache, "reward range", [thetas[0], H, thetas[H], masses2?.[0], map?.[0], grid.name], () => {
    const held = new Float64Array(H);
    for (const { values, width } of kinds) {
      const all = Float64Array.from({ length: width }, (_, v) => {
        let most = 0;
        for (let a = 0; a < A; a++)
          for (let i = v; i < values[a].length; i += width) most = Math.max(most, Math.abs(values[a][i]));
        return most;
      });
      const least2 = 1e-9 * Math.max(...all);
      all.forEach((most, v) => {
        if (!masses2) held[v] = Math.max(held[v], most);
        else if (most > least2) for (let h = 0; h < H; h++) held[h] = Math.max(held[h], masses2[v * H + h]);
      });
    }
    const least = SHOWN * Math.max(...held), first = held.findIndex((value) => value > least), last = held.findLastIndex((value) => value > least);
    if (first < 0) return [thetas[0], thetas[H]];
    const margin = Math.max(2, Math.ceil(0.08 * (last - first + 1)));
    return [thetas[Math.max(0, first - margin)], thetas[Math.min(H, last + 1 + margin)]];
  });
}
function bandsOf(model, state, seen) {
  if (!(state.noise > 0) || state.normalise !== "none" || state.shift) return null;
  if (seen.grid.reduced || model.arrays.decoded) return null;
  const { grid, midpoints, H, open: open2, inverse, n, columns, map, truth } = seen, { G, Ut, r, gammas } = grid;
  let gain = midpoints[0] ** 2;
  for (let h = 1; h < H; h++) gain += (midpoints[h] - midpoints[h - 1]) ** 2;
  if (!open2) gain += midpoints[H - 1] ** 2;
  const D = inverse.decode(
    Ut.map((value, i) => value * state.noise / (1 - gammas[i % G])),
    G
  );
  const noise = Float64Array.from(
    { length: n },
    (_, k) => Math.sqrt(gain) * Math.hypot(...D.subarray(k * G, (k + 1) * G))
  );
  if (!truth) return { noise, bias: null };
  const means = map ? product(map, midpoints, columns.width, H, 1) : midpoints, clean = inverse.decode(product(columns.projected[state.action], means, r, columns.width, 1), 1), true_ = truth.rewards[state.action];
  return { noise, bias: clean.map((value, k) => value - true_[k]) };
}
var COARSE = 10;
function* turnsOf(model, state, { count, at }) {
  const known = /* @__PURE__ */ new Map();
  function* chosen(place2) {
    if (!known.has(place2)) {
      known.set(place2, see(model, { ...state, alpha: at(place2) }, 0).chosen);
      yield;
    }
    return known.get(place2);
  }
  const found = [{ from: 0, action: yield* chosen(0) }];
  for (let low = 0; low < count; low += COARSE) {
    const high = Math.min(count, low + COARSE), last = yield* chosen(high);
    let before = low;
    while ((yield* chosen(before)) !== last) {
      let after = high;
      while (after - before > 1) {
        const middle = before + after >> 1;
        if ((yield* chosen(middle)) === (yield* chosen(before))) before = middle;
        else after = middle;
      }
      found.push({ from: after, action: yield* chosen(after) });
      before = after;
    }
  }
  return found;
}

// app/js/lens/panels.js
init_drawing();

// app/js/draw/frame.js
var HELP = 22;
var GHOST = { width: 1.2, dash: [7, 3] };
var inside = (w, h, { left = 46, right = 10, top: top2 = 31, bottom = 34 } = {}) => ({
  x: left,
  y: top2,
  w: w - left - right,
  h: h - top2 - bottom
});
function titled(pen, w, words, note, { colours }, under = true) {
  const end = w - HELP, full = pen.width(words, 14, 600), size = 14 * Math.min(1, (end - 4) / full);
  pen.text(words, 2, 15, { size, weight: 600, colour: colours.text });
  if (!note) return;
  const beside = full + pen.width(note, 11) + 14 < end;
  if (beside || under && pen.width(note, 10.5) < w - 50)
    pen.text(note, beside ? end - 4 : w - 4, beside ? 15 : 26, {
      size: beside ? 11 : 10.5,
      align: "right",
      colour: colours.soft
    });
}
function marked(pen, { box, X, Y }, { x, y }, colours) {
  const across = x === void 0 ? NaN : X(x), up = y === void 0 ? NaN : Y(y), lines = [];
  if (across >= box.x && across <= box.x + box.w)
    lines.push([
      [across, box.y],
      [across, box.y + box.h]
    ]);
  if (up >= box.y && up <= box.y + box.h)
    lines.push([
      [box.x, up],
      [box.x + box.w, up]
    ]);
  for (const each of lines) {
    pen.path(each, { stroke: colours.halo, width: 3 });
    pen.path(each, { stroke: colours.mark, width: 1.2 });
  }
}
var top = (values) => values.reduce((a, b) => Math.max(a, b), 0);
var leastSpan = ({ arrays }) => arrays.rewards ? 0.05 * Math.max(1e-9, ...arrays.rewards.map(Math.abs)) : 1e-3;
var SHAPES = [
  { corners: 12, turn: 0, size: 1 },
  { corners: 4, turn: Math.PI / 4, size: 1.2 },
  { corners: 3, turn: -Math.PI / 2, size: 1.4 },
  { corners: 4, turn: 0, size: 1.4 }
];
function markOf(a, x, y, r) {
  const { corners, turn, size } = SHAPES[a % SHAPES.length];
  return Array.from({ length: corners }, (_, i) => {
    const angle = turn + 2 * Math.PI * i / corners;
    return [x + size * r * Math.cos(angle), y + size * r * Math.sin(angle)];
  });
}
var disc = (x, y, r) => Array.from({ length: 13 }, (_, i) => [x + r * Math.cos(i * Math.PI / 6), y + r * Math.sin(i * Math.PI / 6)]);

// app/js/lens/panels.js
init_filters();
init_maths();
init_simulated();

// app/js/lens/spaces.js
init_drawing();
init_maths();
init_network();
init_simulated();
var TRUTH = { stroke: "#ffffff", width: 1.5 };
var HALO = { stroke: "#111111", width: 3.5 };
var thetaRange = ({ thetas }) => [thetas[0], thetas[thetas.length - 1]];
function drawnRange(scene) {
  const { model, seen, wide, reached } = scene;
  if (wide) return thetaRange(seen);
  const found = rewardRange(model, seen);
  if (model.truth) return found;
  const [low, high] = reached ?? found;
  return scene.reached = [Math.min(low, found[0]), Math.max(high, found[1])];
}
function trueRow({ model, seen }, a, k) {
  if (!seen.truth) return simulatedRow(model, a, k);
  const { masses: masses2, H } = seen, chances = seen.truth.chances[a], V = model.arrays.rewards.length;
  let row = null;
  for (let v = 0; v < V; v++) {
    const chance = chances[k * V + v];
    if (chance < 1e-12) continue;
    row ??= new Float64Array(H);
    for (let h = 0; h < H; h++) row[h] += chance * masses2[v * H + h];
  }
  return row;
}
function drawnTau({ model, state, seen, images }) {
  if (images.drawnFor !== seen) {
    const windows = windowsOf(model, state, seen), values = onScale(seen.tau, seen.H, windows);
    Object.assign(images, {
      windows,
      drawn: model.dt === 1 ? values : values.map((value) => value / model.dt),
      drawnFor: seen
    });
  }
  return images.drawn;
}
var limitOfTau = (scene) => {
  const { model, seen, images } = scene, values = drawnTau(scene);
  if (!seen.truth) return top(values.map(Math.abs)) || 1;
  if (images.limitFor !== seen.masses) {
    let limit = 0;
    for (let a = 0; a < model.A; a++)
      for (let k = 0; k < model.K; k++) {
        const row = trueRow(scene, a, k);
        if (row) limit = Math.max(limit, top(onScale(row, seen.H, images.windows)));
      }
    Object.assign(images, { limitFor: seen.masses, limit: limit > 0.9 ? 1 : limit || 1 });
  }
  return images.limit;
};
function drawSpace(pen, w, h, scene, { values, n, rows, limit, title, note, yTitle, labels, margin, image, version }) {
  const { seen, colours, images, zoom } = scene, box = inside(w, h, margin);
  if (images[`${image} of`] !== version) {
    heatmap(images[image] ??= document.createElement("canvas"), values, n, seen.H, limit);
    images[`${image} of`] = version;
  }
  titled(pen, w, title, note, scene);
  const x = zoom.theta ?? drawnRange(scene), y = zoom[image] ?? [-0.5, rows - 0.5];
  const scale = axes(pen, box, {
    x,
    y,
    across: [(theta) => acrossOf(seen, theta), (across) => thetaOf(seen, across)],
    xTicks: thetaTicks(seen, x, box.w),
    yTicks: rowTicks(labels, y),
    xTitle: "sensitivity θ (reward)",
    yTitle,
    colours,
    grid: false
  });
  pen.path(
    [
      [box.x, box.y],
      [box.x + box.w, box.y],
      [box.x + box.w, box.y + box.h],
      [box.x, box.y + box.h]
    ],
    { fill: colours.empty, close: true }
  );
  const [left, right] = thetaRange(seen).map(scale.X), upper = scale.Y(n - 0.5);
  pen.clip(
    box.x,
    box.y,
    box.w,
    box.h,
    () => pen.image(images[image], left, upper, right - left, scale.Y(-0.5) - upper)
  );
  return scale;
}
var isAdded = ({ model }, gamma) => Boolean(model.header.added && gamma % (model.header.added + 1));
function missed({ model, seen, state, images }) {
  if (!model.header.added) return null;
  const Z = seen.columns.values[state.action];
  if (images.missedFor !== Z) Object.assign(images, { missedFor: Z, missed: leftOut(model, Z) });
  return images.missed;
}
var gammaPanel = {
  name: "gamma-space",
  title: "Gamma-space",
  why: [
    "The learned values: for each discount γ, how much future reward of each size θ is expected; nearer steps count more.",
    "Z(γ, θ) = Σ_τ γ^τ P(r_τ ≈ θ)"
  ],
  rows: "gamma",
  draw(pen, w, h, scene) {
    const { seen, state, hover, colours, images } = scene;
    const version = JSON.stringify([
      state.slope,
      state.slope_share,
      state.action,
      state.noise && [state.noise, state.noise_seed],
      state.mixed,
      state.paper_grid,
      state.clip,
      scene.model.id
    ]);
    if (images.gammaFor !== version) Object.assign(images, { Z: gammaSpace(seen, state), gammaFor: version });
    const { Z } = images, { gammas, G } = seen.grid, limit = top(Z) || 1;
    const margin = { right: 36 }, found = missed(scene);
    const notes = [
      seen.soft && `soft ±${short(seen.soft.off, 2)}`,
      found && `dotted: interpolated ±${short(top(found), 2)}`
    ];
    const scale = drawSpace(pen, w, h, scene, {
      values: Z,
      n: G,
      rows: G,
      limit,
      labels: gammas,
      title: "Gamma-space",
      yTitle: "discount γ",
      margin,
      image: "gamma",
      version,
      note: hover.theta !== void 0 && hover.gamma !== void 0 ? `θ ${rewardWords(seen, hover.theta)} · γ ${short(gammas[hover.gamma])} · ` + short(Z[hover.gamma * seen.H + columnAt(seen, hover.theta)]) + (isAdded(scene, hover.gamma) ? " interpolated" : "") : notes.filter(Boolean).join(" · ") || "discounted steps"
    });
    pen.clip(
      scale.box.x - 5,
      scale.box.y,
      scale.box.w + 5,
      scale.box.h,
      () => gammas.forEach((_, g) => {
        if (!isAdded(scene, g)) return;
        const { box, Y } = scale, y = Y(g), wide = Y(0) - Y(1) >= 5 ? box.w : 0;
        pen.path(
          [
            [box.x - 5, y],
            [box.x + wide, y]
          ],
          { stroke: NEUTRAL, dash: [1, 3] }
        );
      })
    );
    colourBar(
      pen,
      images.bar ??= document.createElement("canvas"),
      { x: w - 32, y: scale.box.y, w: 7, h: scale.box.h },
      limit,
      colours
    );
    marked(pen, scale, { x: hover.theta, y: hover.gamma }, colours);
    return scale;
  },
  point: ({ seen }, x, y) => ({ theta: x, gamma: Math.min(seen.grid.G - 1, Math.max(0, Math.round(y))) }),
  words: (scene) => {
    const { model, state, seen, images } = scene, found = missed(scene), low = seen.thetas[seen.open ? 1 : 0], high = seen.thetas[seen.open ? seen.H - 1 : seen.H];
    return `Gamma-space of ${model.header.actions[state.action]}: ${seen.grid.G} discounts from ${short(seen.grid.gammas[0])} to ${short(seen.grid.gammas[seen.grid.G - 1])}, ${seen.open ? seen.H - 1 : seen.H} sensitivities from ${short(low)} to ${short(high)}${seen.open ? " and what lies beyond them" : ""}; the largest entry is ${short(top(images.Z ?? []))} discounted steps.` + (found ? ` The dotted discounts are interpolated: where a trained one is left out, a probability is off by up to ${short(top(found), 2)}.` : "") + (seen.soft ? ` At ${short(state.slope_share)} of the trained slope, a probability is off by up to ${short(seen.soft.off, 2)}.` : "");
  }
};
function outline(scene) {
  const { model, seen, state, images } = scene, { masses: masses2, H, thetas } = seen, few = model.K <= 16, half = few ? 0.46 : 0.5;
  if (images.outlineFor === masses2 && images.outlineOf === state.action) return images.outline;
  const rows = Array.from({ length: model.K }, (_, k) => trueRow(scene, state.action, k)), peaks = rows.map((row) => top(row ?? []));
  const least = 1e-3 * top(peaks), found = [];
  rows.forEach((row, k) => {
    const foot = Math.max(0.02 * peaks[k], least), low = k - half, high = k + half;
    for (let h = 0; row && h < H; h++) {
      if (!(row[h] > foot)) continue;
      const left = thetas[h];
      while (h < H && row[h] > foot) h++;
      const right = thetas[h];
      found.push(
        ...few ? [[left, low], [right, low], [right, high], [left, high], [left, low], null] : [[left, low], [left, high], null, [right, low], [right, high], null]
      );
    }
  });
  Object.assign(images, { outline: found, outlineFor: masses2, outlineOf: state.action });
  return found;
}
var tauPanel = {
  name: "tau-space",
  title: "Tau-space",
  why: [
    "The probability of each reward θ at each future step τ, decoded from gamma-space. A certain reward reads as 1; magenta is below 0.",
    "P = V diag(s / (s² + α²)) Uᵀ Z, with γ^τ = U diag(s) Vᵀ; summed over θ ± 2 / slope"
  ],
  rows: "tau",
  draw(pen, w, h, scene) {
    const { model, seen, hover, colours, images, resolution: resolution2 } = scene, limit = limitOfTau(scene), values = drawnTau(scene), { K, dt } = model;
    const labels = Float64Array.from({ length: K }, (_, k) => k * dt), { theta, tau } = hover, cell = theta !== void 0 && tau !== void 0 && tau < seen.n;
    const simulated = simulatedFor(scene), far = simulated && cell ? distancesOf(scene)[tau * dt] : NaN, aside = simulated ? 42 : 0;
    const scale = drawSpace(pen, w, h, scene, {
      values,
      n: seen.n,
      rows: K,
      limit,
      labels,
      title: "Tau-space",
      yTitle: "future step τ",
      margin: { right: 84 + aside },
      image: "tau",
      version: seen.tau,
      note: cell ? `θ ${rewardWords(seen, theta)} · τ ${short(tau * dt)} · P ` + short(values[tau * seen.H + columnAt(seen, theta)]) + (Number.isFinite(far) ? ` · W1 ${short(far)}` : "") : simulated ? `outlined: ${simulated.count} continuations` : scene.followed ? "white: observed" : seen.truth ? "probability; white boxes: the truth" : "probability"
    });
    const { box, X, Y } = scale;
    if (seen.truth ? seen.masses : simulated) {
      const points = outline(scene).map((point) => point && [X(point[0]), Y(point[1])]);
      pen.clip(box.x - 2, box.y - 2, box.w + 4, box.h + 4, () => {
        pen.path(points, HALO);
        pen.path(points, K <= 16 ? TRUTH : { ...TRUTH, width: 1 });
      });
    }
    if (scene.followed && !simulated) {
      const found = scene.followed.rewards.slice(0, Math.ceil(K * dt)), size = found.length > 60 ? 1.6 : 2.6;
      pen.clip(
        box.x,
        box.y,
        box.w,
        box.h,
        () => found.forEach((reward, k) => {
          const [x, y] = [X(placeOf(seen, reward)), Y(k / dt)];
          pen.path(
            [
              [x - size, y - size],
              [x + size, y - size],
              [x + size, y + size],
              [x - size, y + size]
            ],
            { fill: "#ffffff", stroke: "#111111", width: 0.8, close: true }
          );
        })
      );
    }
    const deadline = Y(seen.readRow + 0.5), ruler = { x: box.x + box.w + 6 + aside, w: 38 };
    if (simulated) drawDistances(pen, scene, { ...box, x: box.x + box.w + 6, w: 32 }, Y);
    pen.clip(box.x, box.y - 1, box.w, box.h + 2, () => {
      pen.path(
        [
          [box.x, deadline],
          [box.x + box.w, deadline]
        ],
        { stroke: "#111", width: 3 }
      );
      pen.path(
        [
          [box.x, deadline],
          [box.x + box.w, deadline]
        ],
        { stroke: "#ff9f1c", width: 1.6, dash: [6, 4] }
      );
      pen.text("T", box.x + box.w - 4, deadline + (deadline < box.y + 14 ? 12 : -4), {
        size: 11,
        weight: 700,
        align: "right",
        colour: "#ff9f1c"
      });
    });
    pen.clip(ruler.x - 2, box.y - 1, ruler.w + 4, box.h + 2, () => {
      const peak = top(resolution2.kernel.map(Math.abs)) || 1, foot = ruler.x + 6;
      const at = Array.from(resolution2.kernel, (value, k) => [foot + 28 * value / peak, Y(k)]);
      pen.path([[foot, Y(0)], ...at, [foot, Y(K - 1)]], { fill: colours.wash, stroke: colours.primary, width: 1.2 });
      const low = Y(resolution2.low / dt - 0.5), high = Y(resolution2.high / dt + 0.5);
      pen.path(
        [
          [ruler.x + 3, low],
          [ruler.x, low],
          [ruler.x, high],
          [ruler.x + 3, high]
        ],
        { stroke: colours.text, width: 1.4 }
      );
    });
    pen.text(`window ±${short(resolution2.half, 2)}`, ruler.x - 4, box.y + box.h + 27, {
      size: 10.5,
      colour: colours.text
    });
    colourBar(
      pen,
      images.bar ??= document.createElement("canvas"),
      { x: w - 32, y: box.y, w: 7, h: box.h },
      limit,
      colours
    );
    marked(pen, scale, { x: hover.theta, y: hover.tau }, colours);
    return scale;
  },
  point: ({ model }, x, y) => ({ theta: x, tau: Math.min(model.K - 1, Math.max(0, Math.round(y))) }),
  words: ({ model, state, seen, resolution: resolution2, at, images }) => {
    let mass = 0;
    for (let h = 0; h < seen.H; h++) mass += seen.tau[h] / model.dt;
    return `Tau-space of ${model.header.actions[state.action]}: ${seen.n} future steps. Row 0 holds probability ${short(mass)} with mean reward ${short(seen.rewards[state.action][0] / model.dt)}. Step ${short(at * model.dt)} is seen through a window of plus or minus ${short(resolution2.half, 2)} steps.` + (seen.truth ? " The truth is outlined in white." : simulatedWords({ model, state, seen, images }));
  }
};

// app/js/lens/values.js
init_algebra();
init_drawing();
var leader2 = (model, { chosenAt, values }, k) => Number.isFinite(values[0][k]) ? `T ${short(model.horizons[k])}: ${model.header.actions[chosenAt(k)]} ${short(values[chosenAt(k)][k])}` : "";
function legendOf(pen, { model, seen, state }, w) {
  const names = model.header.actions, left = inside(w, 0).x, right = w - (names.length > 2 ? 26 : 0);
  const laid = (order) => {
    const found = [];
    let [x, row] = [left, 0];
    for (const a of order) {
      const name = names[a], words = name.length > 16 ? `${name.slice(0, 15)}…` : name, wide = pen.width(words, 11) + 24;
      if (x + wide > right && x > left) [x, row] = [left, row + 1];
      if (row > 1) break;
      found.push({ a, words, x, row });
      x += wide;
    }
    return found;
  };
  const inOrder = laid(names.keys()), first = [seen.chosen, seen.best, state.action].filter((a) => a !== void 0);
  return inOrder.length === names.length ? inOrder : laid(/* @__PURE__ */ new Set([...first, ...names.keys()]));
}
var valuesPanel = {
  name: "values",
  title: "Values over T",
  why: [
    "The value of each action if the episode ended at T: expected rewards before T, added up. The strip compares the action that is chosen with the best one.",
    "V_T(a) = Σ_{τ<T} γ^τ Σ_θ θ P_a(τ, θ)"
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { horizons, K, dt } = model, names = model.header.actions;
    const legend = legendOf(pen, scene, w), rows = Math.max(...legend.map(({ row }) => row));
    const box = inside(w, h, { top: 44 + 15 * rows, bottom: 62 }), all = [...seen.values, ...seen.truth?.values ?? [], ...scene.pinned?.values ?? []];
    let low = 0, high = 0;
    for (const values of all)
      for (const value of values)
        if (value === value) {
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
    const x = [horizons[0] - dt / 2, horizons[K - 1] + dt / 2];
    titled(
      pen,
      w,
      "Values over T",
      hover.tau !== void 0 ? leader2(model, seen, hover.tau) : [seen.truth && "dotted: true", scene.pinned && "dashed: A"].filter(Boolean).join(", "),
      scene,
      false
    );
    legend.forEach(({ a, words, x: at, row }) => {
      const y = 30 + 15 * row;
      pen.path(
        [
          [at, y],
          [at + 14, y]
        ],
        { stroke: actionColour(a), width: a === state.action ? 4 : 2 }
      );
      pen.path(markOf(a, at + 7, y, 3.6), { fill: actionColour(a), close: true });
      pen.text(words, at + 18, y + 4, { size: 11, colour: colours.text });
    });
    const left_ = names.length - legend.length;
    if (left_) pen.text(`+${left_}`, w - 4, 34, { size: 11, align: "right", colour: colours.soft });
    const scale = axes(pen, box, {
      x,
      y: rounded(low, high, leastSpan(model)),
      xTicks: [],
      yTitle: "value (reward)",
      colours
    }), { X, Y } = scale;
    const xs = Array.from(horizons, X);
    pen.clip(box.x, box.y - 3, box.w, box.h + 6, () => {
      scene.pinned?.values.forEach((values, a) => line(pen, xs, values.map(Y), { ...GHOST, stroke: actionColour(a) }));
      seen.truth?.values.forEach(
        (values, a) => line(pen, xs, values.map(Y), { stroke: actionColour(a), width: 1.3, dash: [2, 3] })
      );
      seen.values.forEach((values, a) => {
        const known = [...values.keys()].filter((k) => Number.isFinite(values[k]));
        pen.path(
          known.map((k) => [xs[k], Y(values[k])]),
          { stroke: actionColour(a), width: a === state.action ? 2.4 : 1.8 }
        );
        const every = Math.ceil(K / 40) * (K > 40 ? 5 : 1), offset = Math.floor(a * every / names.length);
        for (const k of known)
          if (k % every === offset)
            pen.path(markOf(a, xs[k], Y(values[k]), 2.8), { fill: actionColour(a), close: true });
      });
      for (const [T, value] of crossings(model, seen))
        pen.path(disc(X(T), Y(value), 4), { stroke: colours.text, width: 1.5, fill: colours.paper, close: true });
    });
    const strip = (top2, chosenAt) => {
      let from = 0;
      for (let k = 1; k <= K; k++) {
        const now = chosenAt(from);
        if (k < K && chosenAt(k) === now) continue;
        const left = X(horizons[from] - dt / 2), right = X(horizons[k - 1] + dt / 2);
        if (now >= 0)
          pen.path(
            [
              [left, top2],
              [right, top2],
              [right, top2 + 10],
              [left, top2 + 10]
            ],
            { fill: actionColour(now), close: true }
          );
        from = k;
      }
    };
    const under = box.y + box.h + 5, used = seen.readRow - seen.leftRow;
    const chosen = Array.from({ length: K }, (_, k) => {
      const row = Math.min(K - 1, k + used);
      for (let back = row; back >= 0; back--) if (Number.isFinite(seen.values[0][back])) return seen.chosenAt(back);
      return -1;
    });
    strip(under, (k) => chosen[k]);
    pen.text("chosen", box.x - 5, under + 9, { size: 10.5, align: "right", colour: colours.soft });
    if (seen.truth) {
      const best = Array.from({ length: K }, (_, k) => {
        const optimum = seen.optimumAt(k), top_ = Math.max(...optimum), least = top_ - tieSize(top_, Math.max(...optimum.map(Math.abs)));
        return chosen[k] >= 0 && optimum[chosen[k]] >= least ? chosen[k] : seen.bestAt(k);
      });
      strip(under + 12, (k) => best[k]);
      pen.text("best", box.x - 5, under + 21, { size: 10.5, align: "right", colour: colours.soft });
    }
    const spots = K <= 8 ? [...horizons] : ticks(x[0], x[1]).filter((tick) => tick >= x[0]);
    for (const tick of spots)
      pen.text(short(tick), X(tick), under + 36, { size: 10.5, align: "center", colour: colours.soft });
    pen.text(used ? "time to go (steps)" : "horizon T (steps)", box.x + box.w / 2, under + 50, {
      size: 11,
      align: "center",
      colour: colours.soft
    });
    const rowsRead = [{ row: seen.leftRow, dash: [5, 4] }, ...used ? [{ row: seen.readRow, dash: [1, 4] }] : []];
    for (const { row, dash } of rowsRead) {
      pen.path(
        [
          [xs[row], box.y],
          [xs[row], under + 24]
        ],
        { stroke: "#ff9f1c", width: 1.8, dash }
      );
    }
    if (hover.tau !== void 0) marked(pen, scale, { x: horizons[hover.tau] }, colours);
    return scale;
  },
  point: ({ model }, x) => ({
    tau: Math.min(model.K - 1, Math.max(0, Math.round((x - model.horizons[0]) / model.dt)))
  }),
  words: ({ model, seen }) => `Value of each action over the horizon T. Read at T = ${short(model.horizons[seen.readRow])}: ${model.header.actions.map((name, a) => `${name} ${short(seen.values[a][seen.readRow], 4)}`).join(", ")}. Chosen: ${model.header.actions[seen.chosen]}.` + (seen.truth ? ` Best: ${model.header.actions[seen.best]}; ${short(seen.regret)} is lost.` : "") + ` The two leading lines cross ${crossings(model, seen).length} times.`
};
function crossings({ horizons, K }, { values, chosenAt }) {
  const found = [], rows = [...Array(K).keys()].filter((k) => Number.isFinite(values[0][k]));
  for (let i = 1; i < rows.length; i++) {
    const [k, next] = [rows[i - 1], rows[i]], a = chosenAt(k), b = chosenAt(next);
    if (a === b) continue;
    const before = values[a][k] - values[b][k], after = values[b][next] - values[a][next], share = before + after > 0 ? before / (before + after) : 0;
    found.push([
      horizons[k] + share * (horizons[next] - horizons[k]),
      values[a][k] + share * (values[a][next] - values[a][k])
    ]);
  }
  return found;
}

// app/js/lens/verdict.js
init_drawing();
init_algebra();
init_maths();
var VALUE_TOLERANCE = 0.1;
var SOUND = 0.1;
var RUINED = 1 / 3;
var WORDS = {
  bad: "Wrong",
  warn: "Right, for the wrong reason",
  ok: "Right",
  unknown: "No truth to compare with",
  pending: "Not computed yet",
  smeared: "Right choice, smeared timeline",
  ruined: "Right choice, ruined timeline"
};
var fixed = (value, digits) => (Math.round(value * 10 ** digits) / 10 ** digits + 0).toFixed(digits);
var significant = (value, digits) => String(+value.toPrecision(digits) + 0);
function inWords(values, scale, apart = false) {
  const largest = Math.max(...values.map(Math.abs));
  const word = ROUNDING * scale < largest && largest < 0.01 ? significant : fixed;
  const shown = (digits) => values.map((value) => word(value, digits));
  const enough = apart && [2, 3, 4, 6].find((digits) => new Set(shown(digits)).size === values.length);
  return shown(enough || 2);
}
function numbers(values, scale, chosen, names) {
  if (values.length < 2) return "";
  const rival = values.reduce((best, value, a) => a !== chosen && (best < 0 || value > values[best]) ? a : best, -1);
  if (values[rival] >= values[chosen] - tieSize(values[chosen], scale))
    return ` (a tie at ${inWords([values[chosen]], scale)[0]})`;
  const [first, second] = inWords([values[chosen], values[rival]], scale, true);
  return ` (${first} v ${second}${values.length > 2 ? ` for ${names[rival]}` : ""})`;
}
var ALLOWED = 0.05;
var isLinear = ({ arrays, grids }, state) => !arrays.decoded && !grids.own.reduced && !(state.fold && !grids.own.plain);
var gradeOf = (timeline) => timeline <= SOUND ? "sound" : timeline <= RUINED ? "smeared" : "ruined";
function timelineWords(timeline, name) {
  const grade = gradeOf(timeline), share = Math.round(100 * timeline);
  if (grade === "sound") return "";
  const off = share <= 100 ? `${share}% misplaced` : `off by ${short(timeline)} times all that truly comes`;
  return ` Timeline of ${name}: ${grade}, ${off}.`;
}
function judged(model, state, seen) {
  if (pending(model, state)) {
    const stays = model.arrays.decoded ? "the timeline of the old settings stays" : "this is the one of Tikhonov";
    return {
      tone: "pending",
      sentence: `This solver runs on the server after you release the control; until then ${stays}.`
    };
  }
  const names = model.header.actions, row = seen.readRow, values = seen.values.map((line2) => line2[row]);
  const T = short(model.horizons[row]), left = short(model.horizons[seen.leftRow]);
  const where = state.used > 0 ? `With ${left} of ${short(state.horizon)} steps to go, read at T = ${T},` : `At T = ${T}`;
  const choice = `${where} the decoded values choose ${names[seen.chosen]}` + numbers(values, seen.scale, seen.chosen, names);
  if (!seen.truth) {
    return {
      tone: "unknown",
      sentence: model.A > 1 ? `${choice}.` : `${where} the decoded value is ${inWords([values[0]], seen.scale)[0]}.`
    };
  }
  const optimum = seen.optimumAt(seen.leftRow), true_ = seen.truth.values.map((line2) => line2[seen.leftRow]);
  const timeline = timelineError(model, state, seen), error = Math.max(...values.map((value, a) => Math.abs(value - seen.truth.hard[a][seen.leftRow])));
  const rows = timelineWords(timeline, names[state.action]);
  if (seen.regret > tieSize(Math.max(...optimum), Math.max(...optimum.map(Math.abs)))) {
    return {
      tone: "bad",
      error,
      timeline,
      sentence: `${choice}; the best is ${names[seen.best]}, and ${short(seen.regret)} is lost.${rows}`
    };
  }
  const scale = Math.max(...true_.map(Math.abs), 0.01 * Math.max(...model.arrays.rewards.map(Math.abs)));
  const offs = true_.map(
    (value, a) => scale > 0 ? Math.abs(value - values[a]) / scale : Math.abs(value - values[a]) > tieSize(0, seen.scale) ? Infinity : 0
  ), worst = offs.indexOf(Math.max(...offs));
  const grade = gradeOf(timeline), tone = offs[worst] > VALUE_TOLERANCE ? "warn" : grade === "sound" ? "ok" : grade;
  if (model.A === 1) {
    const [decoded2, truly2] = inWords([values[0], true_[0]], seen.scale);
    return {
      tone,
      error,
      timeline,
      sentence: `${where} the decoded value is ${decoded2}; the true one is ${truly2}.${rows}`
    };
  }
  const [decoded, truly] = inWords([values[worst], true_[worst]], seen.scale, true);
  const but = tone === "warn" ? ` But ${names[worst]} is worth ${truly}, not ${decoded}.` : "";
  return { tone, error, timeline, sentence: `${choice}, and no action is better.${but}${rows}` };
}
function offers({ header: { solver }, dt }, { survival, tau, H, n }) {
  const found = [];
  if (solver !== "feasible" && impossible(survival, dt)) found.push(["Use the feasible timeline", "feasible"]);
  const negative = solver !== "nonnegative" && solver !== "feasible" && lowest(tau, n, H) < -ALLOWED * dt;
  if (negative) found.push(["Use the non-negative solver", "nonnegative"]);
  return found;
}
var impossible = (survival, dt) => survival.some((line2) => line2.some((alive) => alive / dt > 1 + ALLOWED));
function lowest(tau, n, H) {
  let least = 0;
  for (let k = 0; k < n; k++) {
    let sum = 0;
    for (let h = 0; h < H; h++) sum += Math.min(0, tau[k * H + h]);
    least = Math.min(least, sum);
  }
  return least;
}
var effects = (model, state) => Object.fromEntries(
  Object.keys(SWITCHES).filter((name) => isLinear(model, state) && available(model, name)).map((name) => [name, effect(model, state, name)])
);

// app/js/lens/panels.js
var spectrumPanel = {
  name: "spectrum",
  title: "Filter factors",
  why: [
    "The singular values of the transform. The bars are the share of each component that alpha keeps; the rest is removed as noise.",
    "f_i = s_i² / (s_i² + α²)"
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { s, r, free, U, V, G } = seen.grid, count = s.length, box = inside(w, h);
    const learned = (G - 1) / (model.header.added + 1) + 1;
    const factors = shares(seen.grid.filter, s, free, state.alpha).lost.subarray(free).map((lost) => 1 - lost), passing = factors.filter((f) => f > 0.5).length;
    titled(
      pen,
      w,
      "Filter factors",
      `${passing + free} of ${r} pass${learned < G ? `, ${learned} learned` : ""}`,
      scene
    );
    const low = Math.floor(Math.log10(s[count - 1])) - 0.3, high = Math.max(0.6, Math.log10(s[0]) + 0.4), scale = axes(pen, box, {
      x: [0.4, count + 0.6],
      y: [low, high],
      xTitle: "component; bars: share kept",
      yTitle: "singular value",
      colours,
      xTicks: count <= 8 ? Array.from({ length: count }, (_, i) => i + 1) : void 0,
      yTicks: ticks(low, high, 6).filter((tick) => Number.isInteger(tick)).map((tick) => [tick, tick ? `1e${tick}` : "1"])
    });
    const { X, Y } = scale, half = 0.36 * (X(2) - X(1)), floor = box.y + box.h;
    factors.forEach((factor, i) => {
      const x = X(i + 1), top2 = floor - factor * box.h;
      pen.path(
        [
          [x - half, floor],
          [x - half, top2],
          [x + half, top2],
          [x + half, floor]
        ],
        { fill: colours.wash, close: true }
      );
      pen.path(disc(x, Y(Math.log10(s[i])), 3.2), { fill: factor > 0.5 ? colours.primary : NEUTRAL, close: true });
    });
    const { gamma, tau } = hover;
    const weights = gamma !== void 0 ? factors.map((_, i) => Math.abs(U[gamma * r + free + i])) : tau !== void 0 ? factors.map((_, i) => Math.abs(V[tau * r + free + i])) : null;
    if (weights)
      line(
        pen,
        Array.from(weights, (_, i) => X(i + 1)),
        weights.map((value) => floor - value * box.h),
        { stroke: colours.mark, width: 1.4 }
      );
    const level = Math.log10(state.alpha);
    if (level > low && level < high) {
      pen.path(
        [
          [box.x, Y(level)],
          [box.x + box.w, Y(level)]
        ],
        { stroke: "#ff9f1c", width: 1.6, dash: [6, 4] }
      );
      pen.text("α", box.x + box.w - 3, Y(level) - 4, { size: 12, weight: 700, align: "right", colour: "#ff9f1c" });
    }
    return scale;
  },
  point: () => ({}),
  words: ({ state, seen }) => `Singular values of the transform: ${seen.grid.r} usable, the smallest ${short(seen.grid.s[seen.grid.s.length - 1] / seen.grid.s[0])} of the largest. Alpha ${short(state.alpha)} lets ${seen.grid.s.filter((value) => value > state.alpha).length} of them through by more than half.`
};
var kernelPanel = {
  name: "kernel",
  title: "Effective discounting",
  why: [
    "Grey: the weight that each future step should have in the value. Line: the weight that it has at this alpha.",
    "w(τ) = Σ_γ c_γ γ^τ against γ^τ [τ < T]"
  ],
  draw(pen, w, h, scene) {
    const { model, seen, hover, colours, kernel: kernel2 } = scene, { K, dt } = model, box = inside(w, h);
    const low = Math.min(0, ...kernel2.actual), high = Math.max(1, ...kernel2.actual);
    titled(
      pen,
      w,
      "Effective discounting",
      `noise gain ${short(kernel2.gain)}${scene.state.normalise === "none" ? "" : ", before rescaling"}`,
      scene
    );
    const scale = axes(pen, box, {
      x: [-0.5 * dt, (K - 0.5) * dt],
      y: rounded(low, high, 1e-3),
      xTitle: "future step τ",
      yTitle: "weight",
      colours,
      xTicks: K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : void 0
    });
    const { X, Y } = scale, xs = Array.from({ length: K }, (_, k) => X(k * dt)), steps = [];
    kernel2.wanted.forEach((value, k) => steps.push([X((k - 0.5) * dt), Y(value)], [X((k + 0.5) * dt), Y(value)]));
    pen.path([[steps[0][0], Y(0)], ...steps, [steps[steps.length - 1][0], Y(0)]], {
      fill: "rgba(138,143,152,0.22)",
      stroke: NEUTRAL,
      width: 1,
      close: true
    });
    const gamma = hover.gamma === void 0 ? void 0 : seen.grid.gammas[hover.gamma];
    if (gamma !== void 0)
      line(
        pen,
        xs,
        xs.map((_, k) => Y(gamma ** (k * dt))),
        { stroke: colours.mark, width: 1.2, dash: [3, 3] }
      );
    line(pen, xs, kernel2.actual.map(Y), { stroke: colours.primary, width: 2.2 });
    if (K <= 40)
      kernel2.actual.forEach((value, k) => pen.path(disc(xs[k], Y(value), 2.6), { fill: colours.primary, close: true }));
    if (hover.tau !== void 0) marked(pen, scale, { x: hover.tau * dt }, colours);
    return scale;
  },
  point: ({ model }, x) => ({ tau: Math.min(model.K - 1, Math.max(0, Math.round(x / model.dt))) }),
  words: ({ model, seen, kernel: kernel2 }) => {
    let off = 0, all = 0;
    kernel2.actual.forEach((value, k) => {
      off += Math.abs(value - kernel2.wanted[k]);
      all += Math.abs(kernel2.wanted[k]);
    });
    return `Discount kernel for T = ${short(model.horizons[seen.readRow])}: it misses the wanted weights by ${short(100 * off / (all || 1), 2)} percent of their sum; noise gain ${short(kernel2.gain)}.`;
  }
};
var CAME = "rgba(138,143,152,0.55)";
var cameNote = ({ model, state }, followed) => followed.action === state.action ? "grey: observed" : `grey: observed after ${model.header.actions[followed.action]}`;
var rewardsPanel = {
  name: "rewards",
  title: "Expected reward and survival",
  why: [
    "Above: the reward expected at each future step. Below: the probability that the episode still runs. With noise, the dark band is two standard deviations and the pale one adds the error of smoothing.",
    "E[r_τ] = Σ_θ θ P(τ, θ) ± (2 σ_τ + |bias_τ|)"
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { K, dt } = model, a = state.action, box = inside(w, h);
    const upper = { ...box, h: box.h * 0.62 }, lower = { ...box, y: box.y + box.h * 0.74, h: box.h * 0.26 };
    const rewards = Array.from(seen.rewards[a], (value) => value / dt), true_ = seen.truth?.steps.rewards[a];
    const ghost = scene.pinned && Array.from(scene.pinned.rewards[a], (value) => value / dt);
    const followed = simulatedFor(scene) ? null : scene.followed, came = followed ? followed.rewards.slice(0, Math.ceil(K * dt)) : [];
    const simulated = simulatedFor(scene), edges = (side) => simulated?.reward.map((value, k) => value + side * simulated.rewardError[k]) ?? [];
    const bands = bandsOf(model, state, seen), spread = (k) => bands ? (2 * bands.noise[k] + Math.abs(bands.bias?.[k] ?? 0)) / dt : 0, least = Math.max(...[...rewards, ...true_ ?? []].map(Math.abs)), banded = bands ? rewards.flatMap((value, k) => [-1, 1].map((side) => value + side * Math.min(spread(k), least))) : [];
    const all = [0, ...rewards, ...true_ ?? [], ...ghost ?? [], ...came, ...banded, ...edges(2), ...edges(-2)];
    const low = Math.min(...all), high = Math.max(...all), x = [-0.5 * dt, (K - 0.5) * dt];
    titled(
      pen,
      w,
      "Expected reward and survival",
      hover.tau !== void 0 && hover.tau < seen.n ? `τ ${short(hover.tau * dt)}: ${short(rewards[hover.tau])}, alive ${short(seen.survival[a][hover.tau] / dt)}` : impossible([seen.survival[a]], dt) ? "survival above 1: impossible" : seen.truth ? "grey: true" : simulated ? "red: simulated, ± 2 errors" : followed ? cameNote(scene, followed) : "",
      scene
    );
    const span = 1e-3 * (seen.thetas[seen.H] - seen.thetas[0]), scale = axes(pen, upper, { x, y: rounded(low, high, span), xTicks: [], yTitle: "E[r] (reward)", colours });
    const few = K <= 8 ? Array.from({ length: K }, (_, k) => k * dt) : void 0;
    const alive = axes(pen, lower, {
      x,
      y: [-0.25, 1.35],
      yTicks: [0, 1],
      xTicks: few,
      xTitle: "future step τ",
      yTitle: "alive",
      colours
    });
    const xs = Array.from({ length: K }, (_, k) => scale.X(k * dt)), { Y } = scale;
    pen.clip(upper.x, upper.y - 2, upper.w, upper.h + 4, () => {
      const bar = Math.max(0.8, 0.4 * (scale.X(dt) - scale.X(0)));
      true_?.forEach((value, n) => {
        const x2 = scale.X(n);
        if (value)
          pen.path(
            [
              [x2 - bar, Y(0)],
              [x2 - bar, Y(value)],
              [x2 + bar, Y(value)],
              [x2 + bar, Y(0)]
            ],
            { fill: "rgba(138,143,152,0.45)", close: true }
          );
      });
      came.forEach(
        (value, k) => pen.path(
          [
            [scale.X(k - 0.35), Y(0)],
            [scale.X(k - 0.35), Y(value)],
            [scale.X(k + 0.35), Y(value)],
            [scale.X(k + 0.35), Y(0)]
          ],
          { fill: CAME, close: true }
        )
      );
      const band = (width, fill) => {
        const edge = (side) => rewards.slice(0, bands?.noise.length).map((value, k) => [xs[k], Y(value + side * width(k))]);
        pen.path([...edge(1), ...edge(-1).reverse()], { fill, close: true });
      };
      if (bands) {
        band(spread, `${actionColour(a)}2e`);
        band((k) => 2 * bands.noise[k] / dt, `${actionColour(a)}52`);
      }
      if (ghost) line(pen, xs, ghost.map(Y), { ...GHOST, stroke: actionColour(a) });
      if (simulated) drawSimulated(pen, simulated.reward, simulated.rewardError, scale);
      line(pen, xs, rewards.map(Y), { stroke: actionColour(a), width: 2.2 });
      if (K <= 40)
        rewards.forEach(
          (value, k) => pen.path(markOf(a, xs[k], Y(value), 2.8), { fill: actionColour(a), close: true })
        );
    });
    pen.clip(lower.x, lower.y, lower.w, lower.h, () => {
      const known = seen.truth?.steps.survival[a];
      if (known)
        line(
          pen,
          Array.from(known, (_, n) => alive.X(n)),
          known.map((value) => alive.Y(value)),
          { stroke: NEUTRAL, width: 5 }
        );
      if (followed) {
        const end = followed.over ?? came.length;
        pen.path(
          [
            [alive.X(-0.5), alive.Y(1)],
            [alive.X(end - 0.5), alive.Y(1)],
            ...followed.over === null ? [] : [
              [alive.X(end - 0.5), alive.Y(0)],
              [alive.X(K * dt), alive.Y(0)]
            ]
          ],
          { stroke: NEUTRAL, width: 4 }
        );
      }
      if (simulated) drawSimulated(pen, simulated.survival, simulated.survivalError, alive);
      line(
        pen,
        xs,
        seen.survival[a].map((value) => alive.Y(value / dt)),
        { stroke: colours.text, width: 1.6 }
      );
    });
    for (const each of [scale, alive]) if (hover.tau !== void 0) marked(pen, each, { x: hover.tau * dt }, colours);
    return { ...scale, box };
  },
  point: kernelPanel.point,
  words: ({ model, state, seen }) => {
    const a = state.action, tell = (x, dt = model.dt) => Array.from(x.slice(0, 4), (value) => short(value / dt)).join(", ");
    const true_ = seen.truth?.steps, at = model.dt < 1 ? "at the first rows" : "at the first steps";
    return `Expected reward of ${model.header.actions[a]} ${at}: decoded ${tell(seen.rewards[a])}${true_ ? `, true at the first steps ${tell(true_.rewards[a], 1)}` : ""}. Survival: decoded ${tell(seen.survival[a])}${true_ ? `, true ${tell(true_.survival[a], 1)}` : ""}.`;
  }
};
var fitPanel = {
  name: "fit",
  title: "Fit to gamma-space",
  why: [
    "Circles: the value at each discount. Line: the value that the decoded timeline implies. Where they differ, alpha smooths too much.",
    "(1 − γ) Q(γ) against (1 − γ) Σ_τ γ^τ E[r_τ]"
  ],
  draw(pen, w, h, scene) {
    const { model, state, seen, hover, colours } = scene, { gammas, G } = seen.grid, { given, back } = fitOf(scene), box = inside(w, h);
    const times = gammas.map((gamma) => Math.log10(-1 / Math.log(gamma))), all = [0, ...given, ...back];
    titled(
      pen,
      w,
      "Fit to gamma-space",
      hover.gamma === void 0 ? "value a step at each discount" : `γ ${short(gammas[hover.gamma])}: ${short(given[hover.gamma])}, from tau-space ${short(back[hover.gamma])}`,
      scene
    );
    const margin = 0.04 * (times[G - 1] - times[0]) || 0.5, x = [times[0] - margin, times[G - 1] + margin];
    const scale = axes(pen, box, {
      x,
      y: rounded(Math.min(...all), Math.max(...all), 1e-6),
      xTitle: "time constant of γ (steps)",
      yTitle: "(1 − γ) value (reward)",
      colours,
      xTicks: ticks(x[0], x[1], 4).filter((tick) => Number.isInteger(tick)).map((tick) => [tick, short(10 ** tick)])
    });
    const xs = Array.from(times, scale.X);
    given.forEach(
      (value, g) => pen.path(disc(xs[g], scale.Y(value), G > 40 && isAdded(scene, g) ? 1.8 : 3.4), {
        stroke: colours.soft,
        width: 1.6,
        close: true,
        fill: model.header.added && !isAdded(scene, g) ? colours.soft : void 0
      })
    );
    line(pen, xs, back.map(scale.Y), { stroke: actionColour(state.action), width: 2.2 });
    if (hover.gamma !== void 0) marked(pen, scale, { x: times[hover.gamma] }, colours);
    return { ...scale, times };
  },
  point: ({ seen }, x) => ({
    gamma: seen.grid.gammas.reduce((best, gamma, g, all) => {
      const far = (other) => Math.abs(Math.log10(-1 / Math.log(all[other])) - x);
      return far(g) < far(best) ? g : best;
    }, 0)
  }),
  words: (scene) => {
    const { given, back } = fitOf(scene), off = Math.max(...given.map((value, g) => Math.abs(value - back[g])));
    return `Value of ${scene.model.header.actions[scene.state.action]} at ${given.length} discounts, as learned and as tau-space gives it back: they differ by at most ${short(off)} a step.`;
  }
};
function fitOf({ state, seen, images, model }) {
  if (images.fitFor === seen) return images.fit;
  const { gammas, G } = seen.grid, Z = gammaSpace(seen, state), given = new Float64Array(G), back = new Float64Array(G);
  for (let g = 0; g < G; g++) {
    for (let h = 0; h < seen.H; h++) given[g] += Z[g * seen.H + h] * seen.midpoints[h] * (1 - gammas[g]);
    seen.rewards[state.action].forEach((reward, k) => {
      back[g] += (1 - gammas[g]) * gammas[g] ** (k * model.dt) * reward;
    });
  }
  Object.assign(images, { fitFor: seen, fit: { given, back } });
  return images.fit;
}
var panelsOf = ({ world, still }) => [
  ...world || still ? [] : [fitPanel],
  gammaPanel,
  tauPanel,
  valuesPanel,
  rewardsPanel,
  kernelPanel,
  spectrumPanel
];
var EXPLAINING = [kernelPanel, spectrumPanel];

// app/js/lens/lens.js
init_simulated();

// app/js/lens/story.js
init_elements();
function aboutWords({ model, state, seen }) {
  const { header, simulated } = model, action = header.actions[state.action], place2 = header.state ? ` in ${header.state}` : " in this observation", outlined = seen.truth ? " White boxes are the truth." : simulated?.action === state.action ? ` White boxes are ${simulated.count} simulated continuations.` : "";
  return `Tau-space of ${action}${place2}: how likely each reward (across) is at each future step (up), decoded from values at ${seen.grid.G} discounts.${outlined}`;
}
function storyline(report) {
  const words = element("p", {}), steps = element("nav", { class: "steps", "aria-label": "guided story" }), box = element("div", { class: "about" }, steps, words);
  let shown;
  const linkTo = ({ href, name }, number, current) => element(
    "a",
    {
      href,
      target: "_self",
      "aria-current": current ? "step" : void 0,
      onclick: (event) => {
        if (event.ctrlKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        report({ story: number });
      }
    },
    name
  );
  return {
    box,
    show({ story }, about) {
      const key = story ? `${story.at} ${story.steps.map(({ href }) => href).join()}` : "";
      if (key !== shown) {
        shown = key;
        box.classList.toggle("told", Boolean(story?.at));
        const [first] = story?.steps ?? [];
        steps.replaceChildren(
          ...!story ? [] : story.at ? [
            ...story.steps.map((step, i) => linkTo(step, i + 1, i + 1 === story.at)),
            element(
              "button",
              { type: "button", class: "tool", onclick: () => report({ story: 0 }) },
              "end the story"
            )
          ] : [linkTo({ ...first, name: "Guided story" }, 1, false)]
        );
      }
      const text = story?.at ? story.steps[story.at - 1].words : about;
      if (words.textContent !== text) words.textContent = text;
    }
  };
}

// app/js/draw/surface.js
init_drawing();
var MOST = 46;
function thinned(values, n, width) {
  const rows = Math.min(n, MOST), columns = Math.min(width, MOST * 2), out = new Float64Array(rows * columns);
  for (let k = 0; k < n; k++) {
    for (let h = 0; h < width; h++) {
      const at = Math.floor(k * rows / n) * columns + Math.floor(h * columns / width), value = values[k * width + h];
      if (Math.abs(value) > Math.abs(out[at])) out[at] = value;
    }
  }
  return { out, rows, columns };
}
function drawSurface(pen, box, space, camera, colours) {
  const { out, rows, columns } = thinned(space.values, space.n, space.width), { turn, tilt } = camera;
  const [c, s, up, flat] = [Math.cos(turn), Math.sin(turn), Math.sin(tilt), Math.cos(tilt)], TALL = 0.55;
  const spread = Math.abs(c) + Math.abs(s), wide = box.w * 0.84 / spread, tall = Math.min(wide, box.h * 0.86 / (spread * up + TALL * flat));
  const place2 = (u, v, z) => {
    const x = (u - 0.5) * c - (v - 0.5) * s, y = (u - 0.5) * s + (v - 0.5) * c;
    return [
      box.x + box.w / 2 + x * wide,
      box.y + box.h - 12 - tall * (spread * up * 0.5 + y * up + Math.max(-0.3, Math.min(1.2, z)) * TALL * flat)
    ];
  };
  const point = (i, k) => place2(i / Math.max(1, columns - 1), rows > 1 ? k / (rows - 1) : 0.5, out[k * columns + i] / space.limit);
  const edge = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
    [0, 0]
  ].map(([u, v]) => place2(u, v, 0));
  pen.path(edge, { stroke: NEUTRAL, width: 1, fill: heatColour(0, 1), close: true });
  const across = [...Array(Math.max(1, columns - 1)).keys()], along = [...Array(Math.max(1, rows - 1)).keys()];
  if (s > 0) across.reverse();
  if (c > 0) along.reverse();
  for (const k of along) {
    for (const i of across) {
      const next = Math.min(rows - 1, k + 1), corners = [point(i, k), point(i + 1, k), point(i + 1, next), point(i, next)];
      const value = (out[k * columns + i] + out[next * columns + i + 1] + out[k * columns + i + 1] + out[next * columns + i]) / 4;
      const colour = heatColour(value, space.limit);
      pen.path(
        rows === 1 ? [place2(i / (columns - 1), 0.5, 0), corners[0], corners[1], place2((i + 1) / (columns - 1), 0.5, 0)] : corners,
        { fill: colour, stroke: colour, width: 0.6, close: true }
      );
    }
  }
  for (const [v, row] of space.truth ?? []) {
    pen.path(
      Array.from(row, (value, h) => place2(h / (row.length - 1), v, value / space.limit)).filter(
        (_, h) => row[h] > 1e-3 * space.limit
      ),
      { stroke: "#ff7f0e", width: 1.6 }
    );
  }
  const label = (words, u, v, bold2, aside = 0) => {
    const [x, y] = place2(u, v, 0);
    pen.text(words, x + aside, y + 14, {
      size: bold2 ? 11 : 10,
      align: "center",
      colour: bold2 ? colours.text : colours.soft
    });
  };
  for (const [u, words] of space.x) label(words, u, -0.06);
  label(space.titles[0], 0.5, -0.2, true);
  label(short(space.y[0]), 1.06, 0, false, 10);
  label(short(space.y[1]), 1.06, 1);
  label(space.titles[1], 1.07, 0.5, true);
}

// app/js/lens/world.js
init_elements();

// app/js/chart/plotly.js
var loading;
var plotly = () => loading ?? Promise.reject(new Error("plotly.js was not asked for"));

// app/js/chart/plot.js
var drawing;
function inTurn(box, work) {
  if (box.listening) return Promise.resolve().then(work);
  const frame = () => new Promise((next) => setTimeout(next, 0));
  drawing = (drawing ?? plotly()).catch(() => {
  }).then(frame).then(work);
  return drawing;
}
function themed(layout, host) {
  const style = getComputedStyle(host);
  const colour = style.getPropertyValue("--st-text-color").trim() || style.color;
  const grid = "rgba(138, 143, 152, 0.28)";
  const axis = { gridcolor: grid, linecolor: grid, zerolinecolor: "rgba(138, 143, 152, 0.6)", ticks: "" };
  const painted2 = {
    ...layout,
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { family: style.fontFamily, color: colour, size: 12 },
    autosize: true,
    height: host.clientHeight || layout.height,
    // the place that the page gives it, which may be lower
    modebar: { bgcolor: "rgba(0,0,0,0)", color: "rgba(138, 143, 152, 0.8)", activecolor: colour }
  };
  const page = style.getPropertyValue("--st-background-color").trim();
  if (layout.annotations)
    painted2.annotations = layout.annotations.map(
      (each) => each.bgcolor ? { ...each, bgcolor: page || "#fff" } : each
    );
  if (layout.legend?.bgcolor && /^#[0-9a-f]{6}$/i.test(page))
    painted2.legend = { ...layout.legend, bgcolor: `${page}d9` };
  for (const name of Object.keys(layout)) {
    if (/^[xy]axis\d*$/.test(name)) painted2[name] = { ...axis, ...layout[name] };
  }
  return painted2;
}
var TO_SVG = {
  name: "Download as SVG",
  icon: { width: 24, height: 24, path: "M5 20h14v-2H5v2zM19 9h-4V3H9v6H5l7 7 7-7z" },
  click: (plot2) => window.Plotly.downloadImage(plot2, { format: "svg", filename: plot2.dataset.name })
};
function plot(box) {
  inTurn(box, async () => {
    const Plotly = await plotly();
    const { figure, revision, name } = box.wanted;
    if (box.drawn === figure) return;
    box.drawn = figure;
    box.dataset.name = name;
    const { data, layout } = JSON.parse(figure);
    const config = {
      displaylogo: false,
      responsive: true,
      displayModeBar: window.innerWidth > 640 ? "hover" : false,
      modeBarButtons: [
        ["toImage", TO_SVG],
        layout.scene ? ["resetCameraDefault3d"] : ["zoom2d", "pan2d", "resetScale2d"]
      ],
      toImageButtonOptions: { filename: name, scale: 2 }
    };
    Plotly.react(box, data, themed({ ...layout, uirevision: revision }, box), config);
    if (box.listening) return;
    box.listening = true;
    box.on("plotly_click", (event) => {
      const picked = event.points[0]?.customdata;
      if (box.clickable && Array.isArray(picked)) box.report("clicked", picked[0]);
    });
    const resized = new ResizeObserver(() => {
      if (!box.isConnected) resized.disconnect();
      else if (box.offsetParent) Plotly.Plots.resize(box);
    });
    if (box.parentElement) resized.observe(box.parentElement);
    matchMedia("(prefers-color-scheme: dark)").addEventListener(
      "change",
      () => setTimeout(() => {
        box.drawn = null;
        plot(box);
      }, 400)
    );
  }).catch((error) => {
    box.textContent = `The picture could not be drawn: ${error.message}. Reload the page.`;
  });
}

// app/js/lens/world.js
function worldPanel(report) {
  const div = element("div", { class: "world laplace-chart", role: "group" });
  const box = (
    /** @type {ChartBox} */
    div
  );
  Object.assign(box, { clickable: true, report: (_, picked) => report(picked) });
  return {
    box,
    show({ figure, alt, revision }) {
      box.setAttribute("aria-label", alt);
      if (box.wanted?.figure === figure) return;
      box.wanted = { figure, revision, name: "world" };
      plot(box);
    },
    picture: (format) => window.Plotly.toImage(box, { format, width: 440, height: 260, scale: format === "png" ? 2 : 1 })
  };
}

// app/js/lens/lens.js
var REST = 140;
var PER_FRAME = 1e6;
var AT_REST = 2e7;
var SLICE = 8;
var WHY = "laplace why";
function remembered(value) {
  try {
    if (value !== void 0) localStorage.setItem(WHY, value);
    return localStorage.getItem(WHY);
  } catch {
    return null;
  }
}
var same = (a, b) => Object.keys(a).every((name) => name === "look" || name === "action" || a[name] === b?.[name]);
function mount(root, model, told, tell) {
  const host = element("div", { class: "laplace-lens" });
  const scene = (
    /** @type {Scene} */
    {
      model,
      state: told.state,
      hover: {},
      images: {},
      zoom: {},
      camera: { turn: -0.6, tilt: 0.75 },
      wide: false,
      ...told.kept?.scene
    }
  );
  const history = { states: [told.state], at: 0 };
  let { state } = told, seen, waiting, resting, later, playing, dragging = false, lastState, lastMost, turning = 0, turnedFor = "", turnedModel, sizedState, sizedModel, uncoloured = true;
  root.replaceChildren(host);
  const saved = {
    host,
    scene,
    drawOne,
    panels: [],
    get verdict() {
      return sentence.textContent ?? "";
    },
    get told() {
      return told;
    }
  };
  const files = [
    ["PNG", () => savePng(saved)],
    ["SVG", () => saveSvg(saved)],
    ["CSV", () => saveCsv(saved)]
  ];
  if (told.template) files.push(["HTML", () => saveHtml(saved)]);
  files.push(["for print", async () => (await Promise.resolve().then(() => (init_print(), print_exports))).openPrint(saved)]);
  const sentence = element("p", {}), remedies = element("span", { class: "remedies" });
  const verdict = element("div", { class: "verdict" }, sentence, remedies), said = element("div", { class: "said", role: "status" });
  const tools = toolbar(model, wish, told), handles = [sliders(model, told.base, wish, true), sliders(model, told.base, wish, false)], turns = model.A > 1 ? turnsStrip(model, wish) : void 0, board = switchboard(model, wish), story = storyline((wanted) => report({ state, ...wanted }));
  saved.world = scene.world = told.world ? worldPanel((picked) => report({ state, picked })) : void 0;
  const panels = panelsOf(told).map((panel) => {
    const canvas = element("canvas", {
      role: "img",
      tabindex: 0,
      class: `panel ${panel.name}`,
      "aria-label": panel.name
    });
    listen(canvas, panel, scene, draw);
    return { panel, canvas };
  });
  saved.panels.push(...panels);
  const still = told.still ? element("img", { class: "world", src: told.still, alt: "the world as a graph" }) : void 0, first = scene.world?.box ?? still;
  const frameOf = (each) => framed(each.panel, each.canvas, [
    ["SVG", () => savePanel(saved, each, "svg")],
    ["PNG", () => savePanel(saved, each, "png")]
  ]);
  const explains = ({ panel }) => EXPLAINING.includes(panel), leads = ({ panel }) => panel.rows === "tau", hero = element("div", { class: "hero" }, ...panels.filter(leads).map(frameOf), handles[0].box);
  if (turns) handles[0].box.firstElementChild?.append(turns.box);
  const pictures = element(
    "div",
    { class: "panels" },
    hero,
    ...first ? [framed(WORLD, first, [])] : [],
    ...panels.filter((each) => !explains(each) && !leads(each)).map(frameOf)
  );
  const why = element(
    "details",
    { class: "why", open: remembered() === "open" },
    element(
      "summary",
      {},
      element("b", {}, "Why?"),
      " What alpha keeps, what the value weighs, and each artefact as a switch"
    ),
    element("div", { class: "panels explaining" }, ...panels.filter(explains).map(frameOf)),
    board.box
  );
  why.ontoggle = () => {
    remembered(why.open ? "open" : "closed");
    draw();
  };
  host.append(
    story.box,
    verdict,
    tools.box,
    pictures,
    handles[1].box,
    why,
    footer(told.presets ?? [], files, wish),
    said
  );
  followTaken();
  function report(heard) {
    tell(told.follows ? { ...heard, state: { ...heard.state, action: told.state.action } } : heard);
  }
  function followTaken() {
    if (told.follows && told.followed && told.followed.action !== state.action)
      state = { ...state, action: told.followed.action };
  }
  function wish(change, released) {
    if (change === "play") {
      playing ? stop() : play();
      return;
    }
    if (playing && !(released && !Object.keys(change).length)) stop(false);
    if (change === "undo" || change === "redo") {
      history.at = Math.min(history.states.length - 1, Math.max(0, history.at + (change === "undo" ? -1 : 1)));
      state = history.states[history.at];
      report({ state });
    } else if (change.preset) {
      if (change.preset.here) set({ ...told.base, ...change.preset.state }, true);
      else {
        clearTimeout(later);
        report({ state, preset: change.preset.name });
      }
      return;
    } else if (change === "pin") {
      report({ state, pin: !told.pinned });
      return;
    } else if (change === "wide") {
      scene.wide = !scene.wide;
      delete scene.zoom.theta;
    } else if (change === "follow") {
      told = { ...told, follows: true };
      followTaken();
      report({ state, follow: true });
    } else if (change.action !== void 0 && told.followed) {
      told = { ...told, follows: false };
      state = { ...state, ...change };
      remember2(state);
      report({ state, follow: false });
    } else if (change === "seed") set({ ...state, noise_seed: (state.noise_seed + 1) % 2 ** 31 }, true);
    else if (change === "reset") set({ ...told.base, action: state.action, look: state.look }, true);
    else set({ ...state, ...change }, released);
    draw();
  }
  function set(next, released) {
    state = { ...next, horizon: Math.min(model.horizons[model.K - 1], next.horizon) };
    state.used = Math.max(0, Math.min(state.used, Math.ceil(state.horizon) - 1));
    dragging = !released;
    moveHandles();
    draw();
    if (!released) return;
    clearTimeout(later);
    later = setTimeout(() => {
      if (JSON.stringify(state) === JSON.stringify(history.states[history.at])) return;
      remember2(state);
      report({ state });
    }, 120);
  }
  function moveHandles() {
    for (const each of handles) each.sync(state, told.rule);
  }
  function unreported() {
    const reported = history.states[history.at], changed = Object.entries(state).filter(([name, value]) => value !== reported[name]);
    return changed.length ? Object.fromEntries(changed) : void 0;
  }
  function remember2(next) {
    history.states.splice(history.at + 1, Infinity, next);
    if (history.states.length > 200) history.states.shift();
    history.at = history.states.length - 1;
    tools.sync(state, history, told, scene.wide);
  }
  function sweepButton(sign) {
    const button = host.querySelector(".play");
    if (button) button.textContent = sign;
  }
  function play() {
    let began, from = Math.log10(Math.min(10, Math.max(1e-6, state.alpha))), way = -1;
    const step = (now) => {
      if (!playing) return;
      const past = began === void 0 ? 0 : (now - began) / 1e3;
      began = now;
      from += way * past;
      if (from < -6 || from > 1) way = -way;
      from = Math.min(1, Math.max(-6, from));
      state = { ...state, alpha: +(10 ** from).toPrecision(3), selector: "typed" };
      dragging = true;
      draw();
      playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
    sweepButton("❚❚");
  }
  function stop(release = true) {
    cancelAnimationFrame(playing);
    playing = void 0;
    sweepButton("▶");
    if (release) set(state, true);
  }
  function drawOne(pen, { panel }, w, h) {
    if (scene.state.look === "surface" && isSpace(panel)) {
      drawSolid(pen, panel, w, h);
      return null;
    }
    const scale = panel.draw(pen, w, h, scene);
    const { band } = scene;
    if (band && band.panel === panel) {
      const [[x, y], [x2, y2]] = [band.from, band.to];
      pen.path(
        [
          [x, y],
          [x2, y],
          [x2, y2],
          [x, y2]
        ],
        { stroke: "#ffffff", width: 1.4, dash: [4, 3], close: true }
      );
    }
    return scale;
  }
  function drawSolid(pen, panel, w, h) {
    const gamma = panel.rows === "gamma", { gammas, G } = seen.grid, n = gamma ? G : seen.n;
    const values = gamma ? gammaSpace(seen, state) : drawnTau(scene), top2 = (x) => x.reduce((a, b) => Math.max(a, b), 0) || 1;
    const every = Math.ceil(model.K / 46), floated = !gamma && (seen.truth ? seen.masses : simulatedFor(scene));
    const truth = Array.from({ length: floated ? Math.ceil(model.K / every) : 0 }, (_, i) => {
      const row = trueRow(scene, state.action, i * every);
      return [
        model.K > 1 ? i * every / (model.K - 1) : 0.5,
        row && onScale(row, seen.H, scene.images.windows ?? null)
      ];
    }).filter(([, row]) => row);
    pen.text(panel.title, 2, 15, { size: 14, weight: 600, colour: scene.colours.text });
    drawSurface(
      pen,
      { x: 8, y: 20, w: w - 16, h: h - 30 },
      {
        values,
        n,
        width: seen.H,
        limit: gamma ? top2(values) : limitOfTau(scene),
        titles: ["θ", gamma ? "γ" : "τ"],
        x: thetaTicks(seen, thetaRange(seen), 0.5 * w).map((theta) => [acrossOf(seen, theta) / seen.H, short(theta)]),
        y: gamma ? [gammas[0], gammas[n - 1]] : [0, (n - 1) * model.dt],
        truth
      },
      scene.camera,
      scene.colours
    );
  }
  function draw() {
    if (waiting) return;
    waiting = requestAnimationFrame(() => {
      waiting = void 0;
      const began = performance.now();
      paint();
      frames.push(performance.now() - began);
      if (frames.length > 500) frames.shift();
      clearTimeout(resting);
      resting = setTimeout(rest, REST);
    });
  }
  const frames = host.frames = /** @type {number[]} */
  [];
  function look(most) {
    if (lastState !== state || most > lastMost && !seen.whole) {
      seen = see(model, state, most);
      lastMost = most;
    }
    if (told.pin && scene.pinnedOf !== told.pin)
      Object.assign(scene, { pinnedOf: told.pin, pinned: see(model, told.pin, AT_REST) });
    lastState = state;
    Object.assign(scene, {
      model,
      state,
      seen,
      followed: told.followed,
      at: scene.hover.tau ?? seen.readRow,
      pinned: told.pin ? scene.pinned : void 0
    });
    scene.kernel = kernel(model, state, seen);
    scene.resolution = resolution(model, state, seen, scene.at);
  }
  function paint() {
    if (!host.isConnected) return;
    look(dragging ? PER_FRAME : AT_REST);
    if (uncoloured) scene.colours = coloursOf(host);
    uncoloured = false;
    for (const each of panels) {
      const { canvas } = each, found = sheet(canvas, scene.colours.font);
      if (found) canvas.scale = drawOne(found.pen, each, found.width, found.height) ?? canvas.scale;
    }
    moveHandles();
    board.sync(state);
    story.show(told, aboutWords(scene));
    for (const box of pictures.querySelectorAll(".picture"))
      box.classList.toggle(
        "lit",
        box.classList.contains(`of-${told.story?.at && told.story.steps[told.story.at - 1].panel}`)
      );
    tools.sync(state, history, told, scene.wide);
    judge();
  }
  function judge() {
    const heard = told.said && same(told.said.state, state) ? told.said : void 0, { tone, sentence: words } = heard ?? judged(model, state, seen);
    const buttons = [
      ...(heard?.remedies ?? []).map((label, remedy) => (
        /** @type {[string, {}]} */
        [label, { remedy }]
      )),
      ...told.live ? offers(model, seen).filter(([label, solver]) => solver !== told.coming && !heard?.remedies.includes(label)).map(([label, solver]) => (
        /** @type {[string, {}]} */
        [label, { solver }]
      )) : []
    ];
    const whole = `${WORDS[tone]}. ${words}`, labels = buttons.map(([label]) => label).join("");
    if (sentence.textContent === whole && remedies.textContent === labels) return;
    sentence.replaceChildren(element("b", {}, `${WORDS[tone]}.`), ` ${words}`);
    verdict.className = `verdict ${tone === "bad" || tone === "ok" ? tone : "warn"}${tone === "unknown" ? " brief" : ""}`;
    remedies.replaceChildren(
      ...buttons.map(
        ([label, asked]) => element("button", { type: "button", class: "remedy", onclick: () => report({ state, ...asked }) }, label)
      )
    );
  }
  function rest() {
    if (!host.isConnected || playing) return;
    dragging = false;
    if (!seen.whole && lastMost < AT_REST) paint();
    if (sizedState !== state || sizedModel !== model) board.sizes(effects(model, state));
    [sizedState, sizedModel] = [state, model];
    seekTurns();
    judge();
    for (const { panel, canvas } of panels) canvas.setAttribute("aria-label", panel.words(scene));
    if (said.textContent !== sentence.textContent) said.textContent = sentence.textContent;
  }
  function seekTurns() {
    if (!turns) return;
    turns.box.hidden = !model.header.follows;
    if (turns.box.hidden) return;
    const key = JSON.stringify({ ...state, alpha: 0, action: 0, look: "" });
    if (key === turnedFor && turnedModel === model) return;
    [turnedFor, turnedModel] = [key, model];
    turns.show();
    clearTimeout(turning);
    const search = turnsOf(model, { ...state, action: 0 }, ALPHAS);
    const on = () => {
      const until = performance.now() + SLICE;
      let step = search.next();
      while (!step.done && performance.now() < until) step = search.next();
      if (!host.isConnected) return;
      if (step.done) turns.show(step.value);
      else turning = window.setTimeout(on, 0);
    };
    on();
  }
  const recolour = () => {
    uncoloured = true;
    draw();
  };
  host.addEventListener("transitionend", (event) => {
    if (event.target === host) recolour();
  });
  new ResizeObserver(draw).observe(host);
  onUndo(host, (way) => wish(way, true));
  if (told.world) scene.world?.show(told.world);
  moveHandles();
  draw();
  const controls = () => [...host.querySelectorAll("button, input, select, canvas")];
  const nameOf2 = (control) => `${control.className} ${control.name ?? ""} ${control.textContent}`;
  controls().find((control) => nameOf2(control) === told.kept?.focus)?.focus({ preventScroll: true });
  if (told.kept?.pending) set({ ...state, ...told.kept.pending }, true);
  return hub.lens = host.lens = {
    host,
    // Python has news: another model of the same shape, another state, or words about the present one.
    show(next, news, moved) {
      if (next.grids.own.G !== model.grids.own.G) Object.assign(scene, { hover: {}, zoom: {} });
      if (next !== model) {
        [model, scene.images] = [next, {}];
        scene.pinnedOf = lastState = void 0;
      }
      told = { ...told, ...news };
      followTaken();
      if (moved && JSON.stringify(told.state) !== JSON.stringify(state)) {
        const changed = unreported();
        remember2(state = told.state);
        moveHandles();
        if (changed) set({ ...state, ...changed }, !dragging);
      }
      if (told.world) scene.world?.show(told.world);
      draw();
    },
    get lead() {
      return told.lead;
    },
    get model() {
      return model;
    },
    get state() {
      return state;
    },
    get seen() {
      return seen;
    },
    get hover() {
      return scene.hover;
    },
    // Another lens takes its place: what it is handed of the pictures, of the focus, and of a change not yet
    // reported.
    leave() {
      clearTimeout(later);
      clearTimeout(turning);
      cancelAnimationFrame(playing);
      const focus = controls().find((control) => control === document.activeElement);
      return {
        scene: { zoom: scene.zoom, camera: scene.camera },
        focus: focus && nameOf2(focus),
        pending: unreported()
      };
    }
  };
}

// app/js/lens/standalone.js
init_model();
function standalone(held) {
  const bytes = Uint8Array.from(atob(held.payload), (sign) => sign.charCodeAt(0));
  const box = document.body.appendChild(element("div", { class: "laplace-lens-box" }));
  return mount(box, { ...read(bytes), id: "file" }, { ...held, payload: void 0 }, () => {
  });
}
standalone(JSON.parse(document.querySelector("#held")?.textContent ?? ""));
