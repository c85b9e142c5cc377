// The page of the inverse inside Streamlit: one alpha, dragged on any of its pictures. The server answers releases only;
// the rule of payloads, revisions and releases is written down in laplace_core/exchange/messages.py.
/** @import { InverseModel, InverseScene, InverseTold, Message } from '../types.js' */
import { coloursOf } from '../draw/colours.js';
import { sheet, short } from '../draw/drawing.js';
import { element } from '../draw/elements.js';
import { onUndo } from '../draw/keys.js';
import { made, nearest } from './maths.js';
import { read } from './model.js';
import { panelsOf } from './panels.js';

const HELD = 2, // payloads; Python counts on as many
  MOST = 200, // states that can be gone back to
  REST = 120; // ms after which keys that are held down are one release
/** @type {Map<string, InverseModel>} */
const models = new Map();
const mounted = new WeakMap();
// The state released last, by the name of the component: Streamlit may put it back with an old message.
const released = new Map();

function modelOf(id, bytes) {
  const model = bytes.length ? read(bytes) : models.get(id);
  if (!model) return undefined;
  models.delete(id);
  models.set(id, model);
  while (models.size > HELD) models.delete(models.keys().next().value ?? '');
  return model;
}

/**
 * Shows a message of Streamlit.
 * @param {Message} message
 * @returns {void}
 */
export default function ({ data, parentElement, setTriggerValue }) {
  const view = new DataView(data.buffer, data.byteOffset),
    length = view.getUint32(0, true);
  /** @type {InverseTold} */
  const told = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length))),
    model = modelOf(told.id, data.subarray(4 + length));
  if (!model) {
    // This answer takes the place of a release that Python has not read: so it repeats it.
    const last = released.get(told.name);
    const repeated = last?.revision === told.revision && { revision: told.revision, state: last.state };
    setTriggerValue('released', { missing: told.id, ...repeated });
    return;
  }
  const kept = mounted.get(parentElement),
    shape = JSON.stringify([told.name, model.header.rules, Object.keys(model.arrays)]);
  const report = (state) => {
    const { name, id, revision } = mounted.get(parentElement).told();
    released.set(name, { revision, state });
    setTriggerValue('released', { id, revision, state });
  };
  if (kept && kept.host.isConnected && kept.shape === shape) {
    kept.report = report;
    kept.show(model, told);
    return;
  }
  const there = parentElement.querySelector('.laplace-inverse'),
    host = /** @type {HTMLElement} */ (there ?? element('div', { class: 'laplace-inverse' }));
  if (!there) parentElement.append(host);
  const last = released.get(told.name);
  if (last?.revision === told.revision) told.state = last.state;
  const fresh = { host, shape, report };
  Object.assign(
    fresh,
    mount(host, model, told, (state) => fresh.report(state)),
  );
  mounted.set(parentElement, fresh);
}

function mount(host, firstModel, firstTold, report) {
  let model = firstModel,
    told = firstTold,
    waiting = 0,
    later = 0,
    describing = 0,
    reported = firstTold.state,
    uncoloured = true;
  const scene = /** @type {InverseScene} */ ({ model, told, state: told.state, images: {} });
  const frames = /** @type {number[]} */ ([]),
    history = { states: [firstTold.state], at: 0 };

  const sentence = element('p', {}),
    said = element('div', { class: 'verdict', role: 'status' }, sentence),
    readout = element('output', { class: 'readout' }),
    axis = element('button', { type: 'button', class: 'axis', onclick: turnAxis });
  const { above, curve, rules, below } = panelsOf(model, told.rules);
  const views = [...above, curve, ...rules, ...below].map(viewOf),
    boxes = views.map(({ box }) => box),
    small = above.length + 1,
    last = small + rules.length;
  host.replaceChildren(
    said,
    element('div', { class: 'line' }, readout, axis),
    element('div', { class: `panels above${small - 1}` }, ...boxes.slice(0, small - 1)),
    element(
      'div',
      { class: 'choice' },
      boxes[small - 1],
      element('div', { class: 'rules' }, ...boxes.slice(small, last)),
    ),
    element('div', { class: 'panels five' }, ...boxes.slice(last)),
  );

  function viewOf(panel) {
    const canvas = element('canvas', {
      class: panel.drag ? 'held' : '',
      tabindex: 0,
      role: panel.drag ? 'slider' : 'img',
      'aria-label': panel.drag ? `alpha, on ${panel.title}` : panel.title,
    });
    const note = element('span', { class: 'note' }),
      why = element(
        'details',
        { class: 'why' },
        element('summary', { 'aria-label': `what ${panel.title} shows` }, '?'),
        element('div', {}, element('span', {}, panel.why[0]), element('code', {}, panel.why[1])),
      );
    const head = element('div', { class: 'head' }, element('h2', {}, panel.title), note, why),
      box = element('div', { class: `panel ${panel.name}` }, head, canvas);
    const view = { panel, canvas, box, note, scale: /** @type {any} */ (null) };
    if (panel.drag) listen(view);
    return view;
  }

  // ---- a hand on a picture

  function listen(view) {
    const { canvas, panel } = view;
    let before = scene.state;
    const placeOf = ({ clientX, clientY }) => {
      const { left, top } = canvas.getBoundingClientRect();
      return [clientX - left, clientY - top];
    };
    const place = (event) => {
      if (view.scale) set(panel.drag(scene, view.scale, ...placeOf(event)));
    };
    // A finger scrolls the page up and down, unless it takes hold of a handle that moves up and down itself.
    canvas.addEventListener(
      'touchstart',
      (event) => {
        const [x, y] = placeOf(event.touches[0]);
        if (event.touches.length === 1 && view.scale && panel.handle?.(scene, view.scale, x, y)) event.preventDefault();
      },
      { passive: false },
    );
    canvas.addEventListener('pointerdown', (event) => {
      if (event.button || !event.isPrimary) return;
      before = scene.state;
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType !== 'touch') place(event); // a finger may be about to scroll
    });
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) place(event);
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      place(event);
      rest();
    });
    canvas.addEventListener('pointercancel', () => set(before)); // the browser scrolls instead
    canvas.addEventListener('keydown', (event) => {
      const way = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 }[event.key];
      if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const { alphas } = model.arrays,
        upward = panel.name === 'flips' && (event.key === 'ArrowUp' || event.key === 'ArrowDown');
      if (upward) {
        const row = Math.min(model.K - 1, Math.max(0, nearestRow(scene.state.horizon) + way));
        set({ horizon: model.horizons[row] });
      } else {
        const at = Math.min(alphas.length - 1, Math.max(0, nearest(alphas, scene.state.alpha) + way));
        set({ alpha: +alphas[at].toPrecision(4) });
      }
      rest();
    });
  }

  const nearestRow = (horizon) => Math.round((horizon - model.horizons[0]) / model.dt);

  function turnAxis() {
    set({ axis: scene.state.axis === 'time' ? 'gamma' : 'time' });
    rest();
  }

  function set(change) {
    scene.state = { ...scene.state, ...change };
    draw();
  }

  function rest() {
    clearTimeout(later);
    later = window.setTimeout(() => {
      if (JSON.stringify(scene.state) === JSON.stringify(reported)) return;
      remember(scene.state);
      reported = scene.state;
      report(scene.state);
    }, REST);
  }

  // ---- what the hand did, and the way back

  function remember(state) {
    if (JSON.stringify(state) === JSON.stringify(history.states[history.at])) return;
    history.states.splice(history.at + 1, Infinity, state);
    if (history.states.length > MOST) history.states.shift();
    history.at = history.states.length - 1;
  }

  onUndo(host, (way) => {
    const at = history.at + (way === 'undo' ? -1 : 1);
    if (!history.states[at]) return;
    history.at = at;
    scene.state = history.states[at];
    draw();
    rest();
  });

  // ---- drawing

  function draw() {
    if (waiting) return;
    waiting = requestAnimationFrame(() => {
      waiting = 0;
      const began = performance.now();
      paint();
      frames.push(performance.now() - began);
      if (frames.length > 500) frames.shift();
      clearTimeout(describing);
      describing = window.setTimeout(describe, REST);
    });
  }

  // Says in numbers what the pictures show, once they stand still.
  function describe() {
    if (!host.isConnected) return;
    const { alphas } = model.arrays,
      alpha = `alpha ${short(scene.state.alpha)}`;
    for (const { panel, canvas } of views) {
      const words = panel.words?.(scene) ?? panel.note?.(scene) ?? '';
      if (panel.drag) {
        canvas.setAttribute('aria-valuetext', words ? `${alpha}; ${words}` : alpha);
        canvas.setAttribute('aria-valuemin', String(alphas[model.header.first]));
        canvas.setAttribute('aria-valuemax', String(alphas[alphas.length - 1]));
      } else canvas.setAttribute('aria-label', `${panel.title}: ${words}`);
    }
  }

  function paint() {
    if (!host.isConnected) return;
    const { alpha } = scene.state;
    if (scene.made?.alpha !== alpha || scene.model !== model) scene.made = made(model, alpha);
    Object.assign(scene, { model, told });
    if (uncoloured) scene.colours = coloursOf(host);
    uncoloured = false;
    for (const view of views) {
      const { panel, canvas } = view,
        found = sheet(canvas, scene.colours.font);
      if (found) view.scale = panel.draw(found.pen, found.width, found.height, scene);
      const words = panel.note?.(scene) ?? '';
      if (view.note.textContent !== words) view.note.textContent = words;
      if (panel.drag) canvas.setAttribute('aria-valuetext', `alpha ${short(alpha)}`);
      if (panel.drag) canvas.setAttribute('aria-valuenow', String(alpha));
    }
    readout.textContent = `alpha ${short(alpha)} · ${short(scene.made.degrees)} degrees of freedom`;
    axis.textContent = scene.state.axis === 'time' ? 'axis: time constant' : 'axis: discount γ';
    const isSaid = JSON.stringify(told.said.state) === JSON.stringify(scene.state);
    said.className = `verdict ${isSaid ? told.said.tone : 'unknown'}`;
    const words = isSaid ? told.said.sentence : `Alpha ${short(alpha)}, set by hand. Release it to see how good it is.`;
    if (sentence.textContent !== words) sentence.textContent = words;
  }

  const recolour = () => {
    uncoloured = true;
    draw();
  };
  host.addEventListener('transitionend', (event) => {
    if (event.target === host) recolour();
  }); // its colour follows the theme
  new ResizeObserver(draw).observe(host);
  host.inverse = { scene, frames };
  draw();

  return {
    told: () => told,
    show(next, news) {
      const moved = news.revision !== told.revision;
      if (next !== model) scene.images = {};
      [model, told] = [next, news];
      if (moved) {
        const changed = Object.entries(scene.state).filter(([name, value]) => value !== reported[name]);
        remember((scene.state = reported = news.state));
        if (changed.length) {
          set(Object.fromEntries(changed));
          rest();
        }
      }
      draw();
    },
  };
}
