// The lens: one state, the pictures that it makes, and what the hand does to both. Python hears releases only.
import { element, footer, sliders, switchboard, toolbar } from './controls.js';
import { canvasPen, short } from './drawing.js';
import { SWITCHES, available, effect, gammaSpace, kernel, resolution, see } from './maths.js';
import { PANELS, limitOfTau, trueRow } from './panels.js';
import { saveCsv, saveHtml, savePng, saveSvg } from './export.js';
import { drawSurface } from './surface.js';

const REST = 140; // ms without a change before what is slow is done
const PER_FRAME = 1e6, AT_REST = 2e7; // products to be spent on horizons with an inverse each

const isSpace = (panel) => Boolean(panel.rows); // of the two that can be zoomed, or drawn as surfaces

function coloursOf(host) {
  const style = getComputedStyle(host), named = (name, other) => style.getPropertyValue(name).trim() || other;
  const text = style.color, primary = named('--st-primary-color', '#0b7285'), paper = named('--st-background-color', '#ffffff');
  const light = (text.match(/\d+/g) ?? [0]).slice(0, 3).reduce((a, b) => a + +b, 0) > 382;
  return { text, primary, paper, soft: light ? '#a9b1ba' : '#5b636d',
    wash: light ? 'rgba(59,201,219,0.22)' : 'rgba(11,114,133,0.16)', font: style.fontFamily,
    mark: light ? '#ffffff' : '#000000', halo: light ? 'rgba(0,0,0,0.65)' : 'rgba(255,255,255,0.75)',
      empty: light ? '#1b2026' : '#eceff2' };
}

export function mount(root, { model, state, base, presets = [], template }, report) {
  const host = element('div', { class: 'laplace-lens' });
  const scene = { model, state, hover: {}, images: {}, zoom: {}, camera: { turn: -0.6, tilt: 0.75 } };
  const history = { states: [state], at: 0 };
  let seen, waiting, resting, later, playing, dragging = false, lastState, lastMost;
  root.replaceChildren(host);

  const saved = { scene, drawOne, get verdict() { return verdict.textContent; }, template, model, get state() { return state; },
    base };
  const files = [['PNG', () => savePng(saved)], ['SVG', () => saveSvg(saved)], ['CSV', () => saveCsv(saved)],
    ...(template ? [['HTML', () => saveHtml(saved)]] : [])];
  const verdict = element('div', { class: 'verdict' }), said = element('div', { class: 'said', role: 'status' });
  const tools = toolbar(model, wish), handles = sliders(model, base, wish), board = switchboard(model, wish);
  const panels = PANELS.map((panel) => {
    const canvas = element('canvas', { role: 'img', tabindex: 0, class: `panel ${panel.name}`, 'aria-label': panel.name });
    canvas.onpointermove = (event) => pointed(panel, canvas, event);
    canvas.onpointerleave = () => point({});
    if (isSpace(panel)) {
      canvas.title = 'Drag to zoom or to turn, double-click for all of it';
      canvas.onpointerdown = (event) => {
        if (event.pointerType !== 'mouse' && state.look === 'heatmap') return;
        canvas.setPointerCapture(event.pointerId);
        if (state.look === 'heatmap') scene.band = { panel, from: [event.offsetX, event.offsetY], to: [event.offsetX, event.offsetY] };
      };
      canvas.onpointerup = () => zoomed(panel, canvas.scale);
      canvas.ondblclick = () => { scene.zoom = {}; draw(); };
    }
    canvas.onkeydown = (event) => stepped(panel, event);
    return { panel, canvas };
  });
  host.append(verdict, tools.box, element('div', { class: 'panels' }, ...panels.map(({ canvas }) => canvas)), handles.box,
    board.box, footer(presets, files, wish), said);

  // ---- from a wish to a state, and from states to releases

  function wish(change, released) {
    if (change === 'play') { playing ? stop() : play(); return; }
    if (playing && !(released && !Object.keys(change).length)) stop(false);
    if (change === 'undo' || change === 'redo') {
      history.at = Math.min(history.states.length - 1, Math.max(0, history.at + (change === 'undo' ? -1 : 1)));
      state = history.states[history.at];
      tell();
    } else if (change.preset) {
      if (change.preset.here) set({ ...base, ...change.preset.state }, true);
      else { clearTimeout(later); report({ state, preset: change.preset.name }); }
      return;
    } else if (change === 'seed') set({ ...state, noise_seed: (state.noise_seed + 1) % 2 ** 31 }, true);
    else if (change === 'reset') set(base, true);
    else set({ ...state, ...change }, released);
    draw();
  }

  function set(next, released) {
    const last = model.horizons[model.K - 1];
    state = { ...next, horizon: Math.min(last, next.horizon) };
    state.used = Math.max(0, Math.min(state.used, Math.ceil(state.horizon) - 1));
    dragging = !released;
    draw();
    if (!released) return;
    clearTimeout(later); // keys held down are one release
    later = setTimeout(() => {
      if (JSON.stringify(state) === JSON.stringify(history.states[history.at])) return;
      history.states.splice(history.at + 1, Infinity, state);
      if (history.states.length > 200) history.states.shift();
      history.at = history.states.length - 1;
      tools.sync(state, history);
      tell();
    }, 120);
  }

  const tell = () => report({ state });

  function play() {
    let began, from = Math.log10(Math.min(10, Math.max(1e-6, state.alpha))), way = -1;
    const step = (now) => {
      if (!playing) return;
      const past = began === undefined ? 0 : (now - began) / 1000;
      began = now;
      from += way * past; // a decade a second
      if (from < -6 || from > 1) way = -way;
      from = Math.min(1, Math.max(-6, from));
      state = { ...state, alpha: +(10 ** from).toPrecision(3) };
      dragging = true;
      draw();
      playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
    host.querySelector('.play').textContent = '❚❚';
  }

  function stop(release = true) {
    cancelAnimationFrame(playing);
    playing = undefined;
    host.querySelector('.play').textContent = '▶';
    if (release) set(state, true);
  }

  // ---- linking: one place in theta, tau and gamma, marked in every picture

  function point(hover) {
    if (JSON.stringify(hover) === JSON.stringify(scene.hover)) return;
    scene.hover = hover;
    draw();
  }

  // A rectangle drawn over a space is what both spaces then show of theta, and this one of its rows.
  function zoomed(panel, scale) {
    const { band } = scene;
    scene.band = undefined;
    if (!band) return;
    const [[x, y], [x2, y2]] = [band.from, band.to], sorted = (a, b) => [Math.min(a, b), Math.max(a, b)];
    if (Math.abs(x - x2) > 8) scene.zoom.theta = sorted(scale.toX(x), scale.toX(x2));
    if (Math.abs(y - y2) > 8) scene.zoom[panel.rows] = sorted(scale.toY(y), scale.toY(y2));
    draw();
  }

  function pointed(panel, canvas, event) {
    const { scale } = canvas;
    if (scene.band) {
      scene.band.to = [event.offsetX, event.offsetY];
      draw();
    }
    if (state.look === 'surface' && isSpace(panel)) {
      if (!event.buttons) return;
      scene.camera = { turn: scene.camera.turn + event.movementX * 0.01,
        tilt: Math.min(1.5, Math.max(0.1, scene.camera.tilt + event.movementY * 0.01)) };
      draw();
      return;
    }
    const x = event.offsetX, y = event.offsetY, { box } = scale;
    const within = x >= box.x && x <= box.x + box.w && y >= box.y - 2 && y <= box.y + box.h + 2;
    point(within ? panel.point(scene, scale.toX(x), scale.toY(y)) : {});
  }

  const canvasOf = (panel) => panels.find((each) => each.panel === panel).canvas;

  function zoomIn(panel, { x, y }) { // to half the range, around the cursor
    const half = ([low, high], at = (low + high) / 2) => [at - (high - low) / 4, at + (high - low) / 4];
    Object.assign(scene.zoom, { theta: half(x, scene.hover.theta), [panel.rows]: half(y, scene.hover[panel.rows]) });
    draw();
  }

  function stepped(panel, event) {
    const [across, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [];
    if (event.key === 'Escape') { scene.zoom = {}; point({}); draw(); }
    if (event.key === '+' && isSpace(panel)) zoomIn(panel, canvasOf(panel).scale);
    if (across === undefined) return;
    event.preventDefault();
    const { hover } = scene, limited = (value, low, high) => Math.min(high, Math.max(low, value)), K = model.K,
      big = event.shiftKey ? 10 : 1;
    if (isSpace(panel)) {
      if (state.look === 'surface') { scene.camera = { turn: scene.camera.turn + 0.1 * across,
        tilt: limited(scene.camera.tilt + 0.1 * up, 0.1, 1.5) }; draw(); return; }
      const { thetas, H } = seen,
        theta = limited((hover.theta ?? (thetas[0] + thetas[H]) / 2) + (across * big * (thetas[H] - thetas[0])) / H, thetas[0],
        thetas[H]);
      const row = panel.name === 'tau-space' ? { tau: limited((hover.tau ?? -1) + up * big, 0, K - 1) }
        : { gamma: limited((hover.gamma ?? -1) + up * big, 0, seen.grid.G - 1) };
      point({ theta, ...row });
    } else point({ tau: limited((hover.tau ?? -1) + (across || up) * big, 0, K - 1) });
  }

  // ---- drawing

  function drawOne(pen, { panel }, w, h) {
    const { look } = state;
    if (look === 'surface' && isSpace(panel)) {
      const gamma = panel.name === 'gamma-space', values = gamma ? gammaSpace(seen, state) : seen.tau,
        n = gamma ? seen.grid.G : seen.n;
      const limit = gamma ? values.reduce((a, b) => Math.max(a, b), 0) || 1 : limitOfTau(scene) * model.dt, { gammas } = seen.grid;
      const every = Math.ceil(model.K / 46), truth = gamma || !seen.truth || !seen.masses ? []
        : Array.from({ length: Math.ceil(model.K / every) },
        (_, i) => [model.K > 1 ? (i * every) / (model.K - 1) : 0.5, trueRow(scene, state.action, i * every)]);
      pen.text(panel.name, 2, 15, { size: 14, weight: 600, colour: scene.colours.text });
      drawSurface(pen, { x: 8, y: 20, w: w - 16, h: h - 30 },
        { values, n, width: seen.H, limit, x: [seen.thetas[0], seen.thetas[seen.H]],
        y: gamma ? [gammas[0], gammas[n - 1]] : [0, (n - 1) * model.dt], titles: ['θ', gamma ? 'γ' : 'τ'],
        truth: truth.filter(([, row]) => row) }, scene.camera, scene.colours);
      return null;
    }
    const scale = panel.draw(pen, w, h, scene);
    if (scene.band?.panel === panel) {
      const [[x, y], [x2, y2]] = [scene.band.from, scene.band.to];
      pen.path([[x, y], [x2, y], [x2, y2], [x, y2]], { stroke: '#ffffff', width: 1.4, dash: [4, 3], close: true });
    }
    return scale;
  }

  function draw() {
    if (waiting) return;
    waiting = requestAnimationFrame(() => {
      waiting = undefined;
      const began = performance.now();
      paint();
      host.frames.push(performance.now() - began);
      if (host.frames.length > 500) host.frames.shift();
      clearTimeout(resting);
      resting = setTimeout(rest, REST);
    });
  }
  host.frames = [];

  function look(most) {
    if (lastState !== state || (most > lastMost && !seen.whole)) {
      seen = see(model, state, most);
      lastMost = most;
    }
    lastState = state;
    Object.assign(scene, { state, seen, at: scene.hover.tau ?? seen.readRow });
    scene.kernel = kernel(model, state, seen);
    scene.resolution = resolution(model, state, seen, scene.at);
  }

  function paint() {
    if (!host.isConnected) return;
    look(dragging ? PER_FRAME : AT_REST);
    scene.colours ??= coloursOf(host);
    for (const each of panels) {
      const { canvas } = each, w = canvas.clientWidth, h = canvas.clientHeight, dense = Math.min(2, devicePixelRatio);
      if (!w) continue;
      if (canvas.width !== Math.round(w * dense) || canvas.height !== Math.round(h * dense)) Object.assign(canvas,
        { width: Math.round(w * dense), height: Math.round(h * dense) });
      const context = canvas.getContext('2d');
      context.setTransform(dense, 0, 0, dense, 0, 0);
      context.clearRect(0, 0, w, h);
      canvas.scale = drawOne(canvasPen(context, scene.colours.font), each, w, h) ?? canvas.scale;
    }
    handles.sync(state);
    board.sync(state);
    tools.sync(state, history);
    judge();
  }

  const two = (value) => (Math.round(value * 100) / 100 + 0).toFixed(2); // never a negative zero

  function judge() {
    const names = model.header.actions, T = model.horizons[seen.readRow], left = model.horizons[seen.leftRow], row = seen.readRow;
    const order = names.map((_, a) => a).sort((a, b) => seen.values[b][row] - seen.values[a][row]).slice(0, 3);
    const told = order.map((a) => `${names[a]} ${two(seen.values[a][row])}`).join(', ');
    const where = state.used ? `With ${short(left)} of ${short(state.horizon)} steps to go, read at T = ${short(T)}`
      : `At T = ${short(T)}`;
    let tone = 'warn', words = `${where}: ${told}. It chooses ${names[seen.chosen]}.`;
    if (seen.truth) {
      const wrong = seen.regret > 1e-9 * Math.max(1, Math.abs(Math.max(...seen.optimumAt(seen.leftRow))));
      const true_ = seen.truth.values.map((line) => line[seen.leftRow]),
        top = Math.max(...true_.map(Math.abs), 1e-2 * Math.max(...model.arrays.rewards.map(Math.abs)), 1e-9);
      const offs = true_.map((value, a) => Math.abs(value - seen.values[a][row]) / top), worst = offs.indexOf(Math.max(...offs));
      tone = wrong ? 'bad' : offs[worst] > 0.1 ? 'warn' : 'ok';
      if (model.A === 1) words = `${where} the decoded value is ${two(seen.values[0][row])}; the true one is ${two(true_[0])}.`;
      else words = wrong ? `Wrong. ${where}: ${told}; the best is ${names[seen.best]}, and ${short(seen.regret)} is lost.`
        : `${tone === 'ok' ? 'Right.' : 'Right, for the wrong reason.'} ${where}: ${told}; no action is better${tone === 'ok' ? '' : `, but ${names[worst]} is worth ${two(true_[worst])}`}.`;
    }
    if (verdict.textContent === words) return;
    verdict.textContent = words;
    verdict.className = `verdict ${tone}`;
  }

  function rest() {
    if (!host.isConnected || playing) return;
    dragging = false;
    if (!seen.whole && lastMost < AT_REST) paint();
    const wanted = state;
    if (rest.of !== wanted) board.sizes(Object.fromEntries(Object.keys(SWITCHES).filter((name) =>
      available(model, name)).map((name) => [name, effect(model, wanted, name)])));
    rest.of = wanted;
    for (const { panel, canvas } of panels) canvas.setAttribute('aria-label', panel.words(scene));
    if (said.textContent !== verdict.textContent) said.textContent = verdict.textContent;
  }

  const recolour = () => { scene.colours = undefined; draw(); };
  host.addEventListener('transitionend', (event) => { if (event.target === host) recolour(); }); // its colour follows the theme
  new ResizeObserver(draw).observe(host);
  draw();

  return { host, show(next, opening) { // Python shows another state
    base = opening;
    if (JSON.stringify(next) === JSON.stringify(state)) return;
    history.states.splice(history.at + 1, Infinity, next);
    history.at = history.states.length - 1;
    state = next;
    draw();
  }, get state() { return state; }, get seen() { return seen; }, get hover() { return scene.hover; } };
}
