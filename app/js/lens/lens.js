// The lens: one state, its pictures, and the actions on both. Python receives releases only.
/** @import { Lens, Model, Panel, Released, Saved, Scene, Told } from '../types.js' */
import { acrossOf, thetaTicks } from '../draw/columns.js';
import { coloursOf } from '../draw/colours.js';
import { element } from '../draw/elements.js';
import { ALPHAS, footer, sliders, switchboard, toolbar, turnsStrip } from './controls.js';
import { sheet, short } from '../draw/drawing.js';
import { onUndo } from '../draw/keys.js';
import { hub } from '../hub.js';
import { saveCsv, saveHtml, savePanel, savePng, saveSvg } from './export.js';
import { isSpace, listen } from './hand.js';
import { WORLD, framed } from './help.js';
import { gammaSpace, kernel, resolution, see } from '../core/maths.js';
import { onScale, turnsOf } from '../core/reading.js';
import { EXPLAINING, panelsOf } from './panels.js';
import { simulatedFor } from './simulated.js';
import { drawnTau, limitOfTau, thetaRange, trueRow } from './spaces.js';
import { aboutWords, storyline } from './story.js';
import { drawSurface } from '../draw/surface.js';
import { WORDS, effects, judged, offers } from './verdict.js';
import { worldPanel } from './world.js';

const REST = 140; // ms without a change before what is slow is done
const PER_FRAME = 1e6,
  AT_REST = 2e7; // products to be spent on horizons with an inverse each

const SLICE = 8; // ms in a row that the search for turns takes from the page
const WHY = 'laplace why'; // whether the explaining pictures are open, kept by the browser

function remembered(value) {
  try {
    if (value !== undefined) localStorage.setItem(WHY, value);
    return localStorage.getItem(WHY);
  } catch {
    return null; // a file of its own, or a browser that keeps nothing
  }
}

// Two states are equal if they make the same pictures.
const same = (a, b) => Object.keys(a).every((name) => name === 'look' || name === 'action' || a[name] === b?.[name]);

/**
 * What controls are made from; models that share it may take each other's place under the hand.
 * @param {Model} model
 * @returns {string}
 */
export const shapeOf = ({ header, grids, arrays, sloped }) =>
  JSON.stringify([
    header.world,
    header.actions,
    header.steps,
    header.time_step,
    header.learned,
    sloped,
    Object.keys(grids),
    Object.keys(arrays).filter((name) => !name.startsWith('simulated')),
    arrays.thetas.length,
  ]);

/**
 * Puts a lens on the page.
 * @param {HTMLElement} root
 * @param {Model} model
 * @param {Told} told
 * @param {(released: Released) => void} tell - called with the state that is released
 * @returns {Lens}
 */
export function mount(root, model, told, tell) {
  const host = element('div', { class: 'laplace-lens' });
  const scene = /** @type {Scene} */ ({
    model,
    state: told.state,
    hover: {},
    images: {},
    zoom: {},
    camera: { turn: -0.6, tilt: 0.75 },
    wide: false,
    ...told.kept?.scene,
  });
  const history = { states: [told.state], at: 0 };
  let { state } = told,
    seen,
    waiting,
    resting,
    later,
    playing,
    dragging = false,
    lastState,
    lastMost,
    turning = 0, // the search for alphas where the choice turns,
    turnedFor = '', // and what was found last
    turnedModel,
    sizedState, // what the sizes of the artefacts are of
    sizedModel,
    uncoloured = true; // the page may have other colours now
  root.replaceChildren(host);

  /** @type {Saved} */
  const saved = {
    host,
    scene,
    drawOne,
    panels: [],
    get verdict() {
      return sentence.textContent ?? '';
    },
    get told() {
      return told;
    },
  };
  /** @type {[string, () => void][]} */
  const files = [
    ['PNG', () => savePng(saved)],
    ['SVG', () => saveSvg(saved)],
    ['CSV', () => saveCsv(saved)],
  ];
  if (told.template) files.push(['HTML', () => saveHtml(saved)]);
  files.push(['for print', async () => (await import('../print/print.js')).openPrint(saved)]);
  const sentence = element('p', {}),
    remedies = element('span', { class: 'remedies' });
  const verdict = element('div', { class: 'verdict' }, sentence, remedies),
    said = element('div', { class: 'said', role: 'status' });
  const tools = toolbar(model, wish, told),
    handles = [sliders(model, told.base, wish, true), sliders(model, told.base, wish, false)],
    turns = model.A > 1 ? turnsStrip(model, wish) : undefined,
    board = switchboard(model, wish),
    story = storyline((wanted) => report({ state, ...wanted }));
  saved.world = scene.world = told.world ? worldPanel((picked) => report({ state, picked })) : undefined;
  const panels = panelsOf(told).map((panel) => {
    const canvas = element('canvas', {
      role: 'img',
      tabindex: 0,
      class: `panel ${panel.name}`,
      'aria-label': panel.name,
    });
    listen(canvas, panel, scene, draw);
    return { panel, canvas };
  });
  saved.panels.push(...panels);
  const still = told.still
      ? element('img', { class: 'world', src: told.still, alt: 'the world as a graph' })
      : undefined,
    first = scene.world?.box ?? still;
  /** @type {(each: { panel: Panel, canvas: HTMLCanvasElement }) => HTMLElement} */
  const frameOf = (each) =>
    framed(each.panel, each.canvas, [
      ['SVG', () => savePanel(saved, each, 'svg')],
      ['PNG', () => savePanel(saved, each, 'png')],
    ]);
  const explains = ({ panel }) => EXPLAINING.includes(panel),
    leads = ({ panel }) => panel.rows === 'tau',
    hero = element('div', { class: 'hero' }, ...panels.filter(leads).map(frameOf), handles[0].box);
  if (turns) handles[0].box.firstElementChild?.append(turns.box);
  const pictures = element(
    'div',
    { class: 'panels' },
    hero,
    ...(first ? [framed(WORLD, first, [])] : []),
    ...panels.filter((each) => !explains(each) && !leads(each)).map(frameOf),
  );
  const why = element(
    'details',
    { class: 'why', open: remembered() === 'open' },
    element(
      'summary',
      {},
      element('b', {}, 'Why?'),
      ' What alpha keeps, what the value weighs, and each artefact as a switch',
    ),
    element('div', { class: 'panels explaining' }, ...panels.filter(explains).map(frameOf)),
    board.box,
  );
  why.ontoggle = () => {
    remembered(why.open ? 'open' : 'closed');
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
    said,
  );
  followTaken();

  // As long as the action follows the episode, it is no choice of the person's, and is not reported as one.
  function report(heard) {
    tell(told.follows ? { ...heard, state: { ...heard.state, action: told.state.action } } : heard);
  }

  function followTaken() {
    if (told.follows && told.followed && told.followed.action !== state.action)
      state = { ...state, action: told.followed.action };
  }

  // ---- from a wish to a state, and from states to releases

  function wish(change, released) {
    if (change === 'play') {
      playing ? stop() : play();
      return;
    }
    if (playing && !(released && !Object.keys(change).length)) stop(false);
    if (change === 'undo' || change === 'redo') {
      history.at = Math.min(history.states.length - 1, Math.max(0, history.at + (change === 'undo' ? -1 : 1)));
      state = history.states[history.at];
      report({ state });
    } else if (change.preset) {
      if (change.preset.here) set({ ...told.base, ...change.preset.state }, true);
      else {
        clearTimeout(later);
        report({ state, preset: change.preset.name });
      }
      return;
    } else if (change === 'pin') {
      report({ state, pin: !told.pinned });
      return;
    } else if (change === 'wide') {
      scene.wide = !scene.wide;
      delete scene.zoom.theta;
    } else if (change === 'follow') {
      told = { ...told, follows: true };
      followTaken();
      report({ state, follow: true });
    } else if (change.action !== undefined && told.followed) {
      told = { ...told, follows: false };
      state = { ...state, ...change };
      remember(state);
      report({ state, follow: false });
    } else if (change === 'seed') set({ ...state, noise_seed: (state.noise_seed + 1) % 2 ** 31 }, true);
    else if (change === 'reset') set({ ...told.base, action: state.action, look: state.look }, true);
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
    clearTimeout(later); // keys held down are one release
    later = setTimeout(() => {
      if (JSON.stringify(state) === JSON.stringify(history.states[history.at])) return;
      remember(state);
      report({ state });
    }, 120);
  }

  // At once, and not with the next frame: a key moves a slider from where it stands.
  function moveHandles() {
    for (const each of handles) each.sync(state, told.rule);
  }

  // What a hand has changed since its last release; undefined where that is nothing.
  function unreported() {
    const reported = history.states[history.at],
      changed = Object.entries(state).filter(([name, value]) => value !== reported[name]);
    return changed.length ? Object.fromEntries(changed) : undefined;
  }

  function remember(next) {
    history.states.splice(history.at + 1, Infinity, next);
    if (history.states.length > 200) history.states.shift();
    history.at = history.states.length - 1;
    tools.sync(state, history, told, scene.wide);
  }

  function sweepButton(sign) {
    const button = host.querySelector('.play');
    if (button) button.textContent = sign;
  }

  function play() {
    let began,
      from = Math.log10(Math.min(10, Math.max(1e-6, state.alpha))),
      way = -1;
    const step = (now) => {
      if (!playing) return;
      const past = began === undefined ? 0 : (now - began) / 1000;
      began = now;
      from += way * past; // a decade a second
      if (from < -6 || from > 1) way = -way;
      from = Math.min(1, Math.max(-6, from));
      state = { ...state, alpha: +(10 ** from).toPrecision(3), selector: 'typed' };
      dragging = true;
      draw();
      playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
    sweepButton('❚❚');
  }

  function stop(release = true) {
    cancelAnimationFrame(playing);
    playing = undefined;
    sweepButton('▶');
    if (release) set(state, true);
  }

  // ---- drawing

  function drawOne(pen, { panel }, w, h) {
    if (scene.state.look === 'surface' && isSpace(panel)) {
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
          [x, y2],
        ],
        { stroke: '#ffffff', width: 1.4, dash: [4, 3], close: true },
      );
    }
    return scale;
  }

  function drawSolid(pen, panel, w, h) {
    const gamma = panel.rows === 'gamma',
      { gammas, G } = seen.grid,
      n = gamma ? G : seen.n;
    const values = gamma ? gammaSpace(seen, state) : drawnTau(scene),
      top = (x) => x.reduce((a, b) => Math.max(a, b), 0) || 1;
    const every = Math.ceil(model.K / 46),
      floated = !gamma && (seen.truth ? seen.masses : simulatedFor(scene));
    const truth = Array.from({ length: floated ? Math.ceil(model.K / every) : 0 }, (_, i) => {
      const row = trueRow(scene, state.action, i * every);
      return [
        model.K > 1 ? (i * every) / (model.K - 1) : 0.5,
        row && onScale(row, seen.H, scene.images.windows ?? null),
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
        limit: gamma ? top(values) : limitOfTau(scene),
        titles: ['θ', gamma ? 'γ' : 'τ'],
        x: thetaTicks(seen, thetaRange(seen), 0.5 * w).map((theta) => [acrossOf(seen, theta) / seen.H, short(theta)]),
        y: gamma ? [gammas[0], gammas[n - 1]] : [0, (n - 1) * model.dt],
        truth,
      },
      scene.camera,
      scene.colours,
    );
  }

  function draw() {
    if (waiting) return;
    waiting = requestAnimationFrame(() => {
      waiting = undefined;
      const began = performance.now();
      paint();
      frames.push(performance.now() - began);
      if (frames.length > 500) frames.shift();
      clearTimeout(resting);
      resting = setTimeout(rest, REST);
    });
  }
  const frames = (host.frames = /** @type {number[]} */ ([]));

  function look(most) {
    if (lastState !== state || (most > lastMost && !seen.whole)) {
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
      pinned: told.pin ? scene.pinned : undefined,
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
      const { canvas } = each,
        found = sheet(canvas, scene.colours.font);
      if (found) canvas.scale = drawOne(found.pen, each, found.width, found.height) ?? canvas.scale;
    }
    moveHandles();
    board.sync(state);
    story.show(told, aboutWords(scene));
    for (const box of pictures.querySelectorAll('.picture'))
      box.classList.toggle(
        'lit',
        box.classList.contains(`of-${told.story?.at && told.story.steps[told.story.at - 1].panel}`),
      );
    tools.sync(state, history, told, scene.wide);
    judge();
  }

  // The library's verdict where it speaks of this very state; else what the lens sees itself.
  function judge() {
    const heard = told.said && same(told.said.state, state) ? told.said : undefined,
      { tone, sentence: words } = heard ?? judged(model, state, seen);
    /** @type {[string, Partial<Released>][]} */
    const buttons = [
      ...(heard?.remedies ?? []).map((label, remedy) => /** @type {[string, {}]} */ ([label, { remedy }])),
      ...(told.live
        ? offers(model, seen)
            .filter(([label, solver]) => solver !== told.coming && !heard?.remedies.includes(label))
            .map(([label, solver]) => /** @type {[string, {}]} */ ([label, { solver }]))
        : []),
    ];
    const whole = `${WORDS[tone]}. ${words}`,
      labels = buttons.map(([label]) => label).join('');
    if (sentence.textContent === whole && remedies.textContent === labels) return;
    sentence.replaceChildren(element('b', {}, `${WORDS[tone]}.`), ` ${words}`);
    verdict.className = `verdict ${tone === 'bad' || tone === 'ok' ? tone : 'warn'}${tone === 'unknown' ? ' brief' : ''}`;
    remedies.replaceChildren(
      ...buttons.map(([label, asked]) =>
        element('button', { type: 'button', class: 'remedy', onclick: () => report({ state, ...asked }) }, label),
      ),
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
    for (const { panel, canvas } of panels) canvas.setAttribute('aria-label', panel.words(scene));
    if (said.textContent !== sentence.textContent) said.textContent = sentence.textContent;
  }

  // The alphas where the choice turns, found in slices so that the page stays at hand.
  function seekTurns() {
    if (!turns) return;
    turns.box.hidden = !model.header.follows; // the server alone solves at another alpha
    if (turns.box.hidden) return;
    const key = JSON.stringify({ ...state, alpha: 0, action: 0, look: '' });
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
  host.addEventListener('transitionend', (event) => {
    if (event.target === host) recolour();
  }); // its colour follows the theme
  new ResizeObserver(draw).observe(host);
  onUndo(host, (way) => wish(way, true));
  if (told.world) scene.world?.show(told.world);
  moveHandles();
  draw();
  /** @returns {any[]} controls of all kinds */
  const controls = () => [...host.querySelectorAll('button, input, select, canvas')];
  const nameOf = (control) => `${control.className} ${control.name ?? ''} ${control.textContent}`;
  controls()
    .find((control) => nameOf(control) === told.kept?.focus)
    ?.focus({ preventScroll: true });
  if (told.kept?.pending) set({ ...state, ...told.kept.pending }, true);

  return (hub.lens = host.lens =
    {
      host,
      // Python has news: another model of the same shape, another state, or words about the present one.
      show(next, news, moved) {
        if (next.grids.own.G !== model.grids.own.G) Object.assign(scene, { hover: {}, zoom: {} }); // other rows
        if (next !== model) {
          [model, scene.images] = [next, {}];
          scene.pinnedOf = lastState = undefined;
        }
        told = { ...told, ...news };
        followTaken();
        if (moved && JSON.stringify(told.state) !== JSON.stringify(state)) {
          const changed = unreported();
          remember((state = told.state));
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
          focus: focus && nameOf(focus),
          pending: unreported(),
        };
      },
    });
}
