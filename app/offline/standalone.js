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

// app/js/draw/drawing.js
var ACTIONS = ["#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#8C6D31", "#7A7A7A"];
var actionColour = (a) => ACTIONS[a % ACTIONS.length];
var NEUTRAL = "#8a8f98";
var GRID = "rgba(138,143,152,0.28)";
var UNDER = 0.25;
var VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
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
var contextOf = (canvas) => (
  /** @type {CanvasRenderingContext2D} */
  canvas.getContext("2d")
);
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
var escaped = (words) => String(words).replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);
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
        `<path d="${d}${close ? "Z" : ""}" fill="${fill}" stroke="${stroke}" stroke-width="${width}" stroke-dasharray="${dash}" stroke-linejoin="round"/>`
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
        `<image href="${source.toDataURL()}" x="${short2(x)}" y="${short2(y)}" width="${short2(w)}" height="${short2(h)}" preserveAspectRatio="none" style="image-rendering:pixelated"/>`
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
var short = (value, digits = 3) => {
  if (!Number.isFinite(value)) return "–";
  const found = +value.toPrecision(digits) || 0;
  return found && Math.abs(found) < 1e-4 ? found.toExponential().replace("e-0", "e-") : String(found);
};
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
var line = (pen, xs, ys, style) => pen.path(
  Array.from(ys, (y, i) => Number.isFinite(y) ? [xs[i], y] : null),
  style
);
var channelsOf = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
var SCALE = (() => {
  const zero = UNDER / (1 + UNDER), stops = [
    [0, "#ff3b3b"],
    [0.75 * zero, "#a11a4a"],
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
var heatIndex = (value, limit) => Math.min(511, Math.max(0, Math.round((value / limit + UNDER) / (1 + UNDER) * 511)));
var heatColour = (value, limit) => {
  const word = SCALE[heatIndex(value, limit)];
  return `rgb(${word & 255},${word >> 8 & 255},${word >> 16 & 255})`;
};
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

// app/js/draw/columns.js
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

// app/js/draw/colours.js
function coloursOf(host) {
  const style = getComputedStyle(host), named = (name, other) => style.getPropertyValue(name).trim() || other;
  const text = style.color, primary = named("--st-primary-color", "#0b7285"), paper = named("--st-background-color", "#ffffff");
  const light = (text.match(/\d+/g) ?? ["0"]).slice(0, 3).reduce((a, b) => a + +b, 0) > 382;
  return {
    text,
    primary,
    paper,
    font: style.fontFamily,
    soft: light ? "#a9b1ba" : "#5b636d",
    wash: light ? "rgba(59,201,219,0.22)" : "rgba(11,114,133,0.16)",
    mark: light ? "#ffffff" : "#000000",
    halo: light ? "rgba(0,0,0,0.65)" : "rgba(255,255,255,0.75)",
    empty: light ? "#1b2026" : "#eceff2"
  };
}

// app/js/core/filters.js
function rounded2(value) {
  const low = Math.floor(value), off = value - low;
  return off < 0.5 || off === 0.5 && low % 2 === 0 ? low : low + 1;
}
var logLeft = (s, alpha, largest) => Math.max(1, rounded2((largest / alpha) ** 2)) * Math.log1p(-((s / largest) ** 2));
var FILTERS = {
  tikhonov: (s, a) => [s / (s * s + a * a), a * a / (s * s + a * a)],
  truncated: (s, a) => [s >= a ? 1 / s : 0, s < a ? 1 : 0],
  damped: (s, a) => [1 / (s + a), a / (s + a)],
  iterative: (s, a, largest) => {
    const left = logLeft(s, a, largest);
    return [-Math.expm1(left) / s, Math.exp(left)];
  }
};
function shares(kind, s, free, alpha) {
  const r = s.length + free, kept = new Float64Array(r).fill(1), lost = new Float64Array(r);
  for (let i = free; i < r; i++) [kept[i], lost[i]] = FILTERS[kind](s[i - free], alpha, s[0]);
  return { kept, lost };
}

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
var sigmoid = (x) => {
  const small = Math.exp(-Math.abs(x));
  return (x >= 0 ? 1 : small) / (1 + small);
};
var ROUNDING = 1e-12;
var tieSize = (best, scale) => Math.max(1e-9 * Math.abs(best), ROUNDING * scale);
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
var regular = ({ V, s, r, K, free, filter }, alpha) => {
  const f = shares(filter, s, free, alpha).kept, scaled = (x, width) => x.map((value, i) => value * f[i / width | 0]);
  return {
    n: K,
    decode: (right, width) => product(V, scaled(right, width), K, r, width),
    weights: (target) => scaled(product(target, V, 1, K, r), 1)
  };
};
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

// app/js/core/network.js
var logTime = (gamma) => Math.log(-1 / Math.log(gamma));
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

// app/js/core/nonnegative.js
var MOST_STEPS = 200;
var FALL = 3;
var ON_THE_WAY = 2;
var SEARCHES = 12;
var IDLE = 8;
var dot = (a, b) => {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
};
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
  const c = new Float64Array(B * q), x = new Float64Array(K), along = new Float64Array(K);
  let last = 0;
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
      for (let i = 0; i < q; i++) {
        const factor = A[i * K + k];
        for (let j = 0; j <= i; j++) hessian[i * q + j] += factor * A[j * K + k];
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
  return {
    size,
    at(alpha) {
      const falling = [alpha], from = last || size;
      while (falling[falling.length - 1] * FALL < from) falling.push(falling[falling.length - 1] * FALL);
      if (!last) {
        const first = falling[falling.length - 1];
        for (let b = 0; b < B; b++)
          for (let i = 0; i < q; i++) c[b * q + i] = targets[b * q + i] / (lengths[i] + first * first);
      }
      const out = new Float64Array(K * B);
      for (let b = 0; b < B; b++) {
        const at = c.subarray(b * q, (b + 1) * q), z = targets.subarray(b * q, (b + 1) * q);
        for (let n = falling.length - 1; n >= 0; n--) {
          const most = n ? ON_THE_WAY : MOST_STEPS;
          let best = Infinity, idle = 0;
          for (let i = 0; i < most && idle < IDLE; i++) {
            const off = moved(at, z, falling[n]);
            if (!off) break;
            idle = off < best / 2 ? 0 : idle + 1;
            best = Math.min(best, off);
          }
        }
        rowsOf(at, x);
        for (let k = 0; k < K; k++) out[k * B + b] = Math.max(0, x[k]);
      }
      last = alpha;
      return out;
    }
  };
}

// app/js/core/maths.js
var LEAST_SHOWN = 0.05;
var FLOOR = 0.05;
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
        const whole = state.normalise !== "survival" ? 1 : alive[k] > FLOOR ? 1 / alive[k] : 0;
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
      return solver.at(Math.max(state.alpha, header.least * solver.size));
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
      for (let h = 0; h < width; h++) row[h] = alive > FLOOR ? row[h] / alive : 0;
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
var gammaSpace = ({ grid, columns, map, hum, H }, state) => differencesOf(columns, grid, map, H, state.action, hum, state.noise);
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
var flag = (name, words) => ({
  ...words,
  on: { [name]: true },
  off: { [name]: false },
  isOn: (state) => Boolean(state[name])
});
var SWITCHES = {
  rescale: {
    label: "row rescaling",
    on: { normalise: "paper" },
    off: { normalise: "none" },
    isOn: (s) => s.normalise === "paper",
    help: "Every row is rescaled to probability 1, also where the episode is over."
  },
  fold: flag("fold", {
    label: "only T rows, K = T",
    help: "As many rows are decoded as the horizon has: what comes later is folded into them."
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
    help: "The sensitivities begin at a reward that occurs: half of its probability is lost."
  }),
  constant: flag("constant", {
    label: "constant T",
    help: "Acting with T at every step, instead of with the time to go."
  }),
  shift: flag("shift", {
    label: "index shifted by one",
    help: "Each discount is decoded by the row of the next one, as in the paper’s published notebook."
  })
};
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

// app/js/lens/controls.js
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
    "Regularisation of the inverse. What of the singular values comes back: s²/(s²+α²).",
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
    "Softer than the trained activation, by a linear map over θ; gamma-space says how far it is off. What is softened over an edge of θ lies in the outermost column, and means move with it.",
    ({ arrays }) => arrays.places && linear(0.1, 0.05, 18)
  ],
  [
    "horizon",
    "horizon T",
    "",
    "Deadline of the episode, in steps of the world.",
    ({ horizons, dt, K }) => linear(horizons[0], dt, K - 1)
  ],
  [
    "used",
    "steps used",
    "",
    "Steps of the episode that are over: the time to go is T less these.",
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
    const there = names.includes(name), size = element("span", { class: "size" }, there ? " " : "not in this space");
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
        const moves = name === "constant" ? "" : found.size < 5e-4 ? "moves nothing here" : `moves ${short(found.size, 2)} probability`;
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
      title: "Discounts that were never trained, each a mean of its two neighbours. They add no information, and at the same α let more noise through.",
      onchange: () => wish({ added: +added.value }, true)
    },
    ...["trained discounts", "+ 1 in each gap", "+ 2 in each gap", "+ 3 in each gap"].map(
      (words, value) => element("option", { value }, words)
    )
  );
  const does = (words, name, title = name) => button("tool", words, () => wish(name, true), { "aria-label": name, title });
  const undo = does("↶", "undo"), redo = does("↷", "redo"), reset = does("reset", "reset", "back to the world’s own settings");
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

// app/js/lens/simulated.js
var CAME_TRUE = "#d6336c";
var BAND = "rgba(214,51,108,0.2)";
var TAIL = 65535;
var simulatedFor = ({ model, state }) => model.simulated?.action === state.action ? model.simulated : void 0;
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
var simulatedWords = (scene) => {
  const found = simulatedFor(scene), far = found && distancesOf(scene).filter(Number.isFinite);
  return found && far?.length ? ` ${found.count} simulated continuations are outlined; the distance to them is ${short(far.reduce((a, b) => a + b) / far.length)} reward on average.` : "";
};

// app/js/lens/export.js
var SIZE = { w: 440, h: 260, gap: 16, head: 66, columns: 3 };
var WIDE = SIZE.columns * (SIZE.w + SIZE.gap) + SIZE.gap;
var place = (i) => [
  SIZE.gap + i % SIZE.columns * (SIZE.w + SIZE.gap),
  SIZE.head + Math.floor(i / SIZE.columns) * (SIZE.h + SIZE.gap)
];
var heightOf = (count) => SIZE.head + Math.ceil(count / SIZE.columns) * (SIZE.h + SIZE.gap);
function save(content, name, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
}
var commented = (value) => JSON.stringify(value, (_, each) => typeof each === "string" ? each.replaceAll(",", "\0") : each).replaceAll(
  "\\u0000",
  "\\u002c"
);
var quoted = (words) => `"${`${/^[=+@\t\r\n-]/.test(words) ? "'" : ""}${words}`.replace(/"/g, '""')}"`;
var nameOf = ({ scene: { model } }) => `lens_${model.header.world.replace(/[^A-Za-z0-9_-]+/g, "_").slice(0, 40)}`;
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
var worldOf = async (lens2, format) => lens2.world ? [await lens2.world.picture(format)] : [];
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
var saveSvg = async (lens2) => save(await svgOf(lens2), `${nameOf(lens2)}.svg`, "image/svg+xml");
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
var saveCsv = (lens2) => save(csvOf(lens2), `${nameOf(lens2)}.csv`, "text/csv");
var HELD = '<script id="held" type="application/json">';
function htmlOf({ told, scene: { model, state } }, still, template) {
  const bytes = model.bytes ?? new Uint8Array();
  let text = "";
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  const held = { state, base: told.base, still, payload: btoa(text) };
  return template.replace(HELD, (tag) => tag + JSON.stringify(held).replace(/</g, "\\u003c"));
}
var saveHtml = async (lens2) => {
  const { template } = lens2.told;
  if (!lens2.scene.model.bytes || !template) return;
  const [still] = await worldOf(lens2, "svg");
  save(htmlOf(lens2, still, await template()), `${nameOf(lens2)}.html`, "text/html");
};

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

// app/js/lens/help.js
var WORLD = {
  name: "world",
  title: "World",
  why: [
    "The states and actions of the world; numbers are rewards. The state and the action that are looked at are lit up. Click a state to look from there.",
    "P(s′, r | s, a)"
  ]
};
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
  return element("div", { class: `picture of-${name}` }, element("h3", { class: "unseen" }, title), picture, help);
}

// app/js/core/reading.js
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

// app/js/draw/frame.js
var HELP = 22;
var GHOST = { width: 1.2, dash: [7, 3] };
var inside = (w, h, { left = 46, right = 10, top: top2 = 28, bottom = 34 } = {}) => ({
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
var disc = (x, y, r) => Array.from({ length: 13 }, (_, i) => [x + r * Math.cos(i * Math.PI / 6), y + r * Math.sin(i * Math.PI / 6)]);

// app/js/lens/spaces.js
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
    "What is learned: for each discount γ, how much future reward of each size θ there is, nearer steps counting more.",
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
    "How likely each reward θ is at each future step τ, decoded from gamma-space. A certain reward reads as 1; red is below 0.",
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
      pen.text(words, at + 18, y + 4, { size: 11, colour: colours.text });
    });
    const left_ = names.length - legend.length;
    if (left_) pen.text(`+${left_}`, w - 4, 34, { size: 11, align: "right", colour: colours.soft });
    const scale = axes(pen, box, { x, y: rounded(low, high, leastSpan(model)), xTicks: [], yTitle: "value", colours }), { X, Y } = scale;
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
        if (K <= 40)
          for (const k of known) pen.path(disc(xs[k], Y(values[k]), 2.6), { fill: actionColour(a), close: true });
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
      sentence: `This solver runs on the server, once the control is released: until then ${stays}.`
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
    "The singular values of the transform. The bars are the share of each component that alpha keeps; the rest is dropped as noise.",
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
      xTitle: "component; bars: share let through",
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
    "Grey: the weight that each future step should have in the value. Line: the weight that the inverse at this alpha really gives it.",
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
    "Above: the reward expected at each future step. Below: the chance that the episode goes on until then. With noise, the dark band is two standard deviations and the pale one adds the error of smoothing.",
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
      hover.tau !== void 0 && hover.tau < seen.n ? `τ ${short(hover.tau * dt)}: ${short(rewards[hover.tau])}, alive ${short(seen.survival[a][hover.tau] / dt)}` : impossible([seen.survival[a]], dt) ? "alive above 1: impossible" : seen.truth ? "grey: true" : simulated ? "red: simulated, ± 2 errors" : followed ? cameNote(scene, followed) : "",
      scene
    );
    const span = 1e-3 * (seen.thetas[seen.H] - seen.thetas[0]), scale = axes(pen, upper, { x, y: rounded(low, high, span), xTicks: [], yTitle: "E[r]", colours });
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
        rewards.forEach((value, k) => pen.path(disc(xs[k], Y(value), 2.8), { fill: actionColour(a), close: true }));
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
    "Circles: the value that was learned at each discount. Line: the value that the decoded timeline gives back. Where they differ, alpha smooths too much.",
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
      yTitle: "(1 − γ) value",
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

// app/js/lens/story.js
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
  const label = (words, u, v, bold, aside = 0) => {
    const [x, y] = place2(u, v, 0);
    pen.text(words, x + aside, y + 14, {
      size: bold ? 11 : 10,
      align: "center",
      colour: bold ? colours.text : colours.soft
    });
  };
  for (const [u, words] of space.x) label(words, u, -0.06);
  label(space.titles[0], 0.5, -0.2, true);
  label(short(space.y[0]), 1.06, 0, false, 10);
  label(short(space.y[1]), 1.06, 1);
  label(space.titles[1], 1.07, 0.5, true);
}

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
  const painted = {
    ...layout,
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { family: style.fontFamily, color: colour, size: 12 },
    autosize: true,
    modebar: { bgcolor: "rgba(0,0,0,0)", color: "rgba(138, 143, 152, 0.8)", activecolor: colour }
  };
  const page = style.getPropertyValue("--st-background-color").trim();
  if (layout.legend?.bgcolor && /^#[0-9a-f]{6}$/i.test(page))
    painted.legend = { ...layout.legend, bgcolor: `${page}d9` };
  for (const name of Object.keys(layout)) {
    if (/^[xy]axis\d*$/.test(name)) painted[name] = { ...axis, ...layout[name] };
  }
  return painted;
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
    draw();
    if (!released) return;
    clearTimeout(later);
    later = setTimeout(() => {
      if (JSON.stringify(state) === JSON.stringify(history.states[history.at])) return;
      remember2(state);
      report({ state });
    }, 120);
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
    for (const each of handles) each.sync(state, told.rule);
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
      ...told.live ? offers(model, seen).map(([label, solver]) => (
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
  if (told.world) scene.world?.show(told.world);
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
      if (moved && JSON.stringify(told.state) !== JSON.stringify(state)) remember2(state = told.state);
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
      const reported = history.states[history.at], changed = Object.entries(state).filter(([name, value]) => value !== reported[name]);
      const focus = controls().find((control) => control === document.activeElement);
      return {
        scene: { zoom: scene.zoom, camera: scene.camera },
        focus: focus && nameOf2(focus),
        pending: changed.length ? Object.fromEntries(changed) : void 0
      };
    }
  };
}

// app/js/lens/standalone.js
function standalone(held) {
  const bytes = Uint8Array.from(atob(held.payload), (sign) => sign.charCodeAt(0));
  const box = document.body.appendChild(element("div", { class: "laplace-lens-box" }));
  return mount(box, { ...read(bytes), id: "file" }, { ...held, payload: void 0 }, () => {
  });
}
standalone(JSON.parse(document.querySelector("#held")?.textContent ?? ""));
