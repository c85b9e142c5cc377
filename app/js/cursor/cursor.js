// A cursor over steps, dragged, stepped or played, over data that the server sends once; Python receives where it comes to
// rest. The rule of payloads and revisions is written down in laplace_core/exchange/messages.py.
/** @import { Message, Mounted, Stepper } from '../types.js' */
import { element } from '../draw/elements.js';

const REST = 250; // ms without a move before the step is sent to the server
const HELD = 4; // payloads kept of each kind, across mounts; Python counts on as many
const shelves = {};

/**
 * A button with a label, and a title that says what it does.
 * @param {string} words
 * @param {string} title
 * @param {() => void} does
 * @param {string | false} [named] - what it is called, false: by the words on it
 * @returns {HTMLButtonElement}
 */
export const button = (words, title, does, named = title) =>
  element('button', { type: 'button', title, 'aria-label': named, onclick: does }, words);

/**
 * What Streamlit calls with every message, a small JSON and, if it is not held yet, a payload for `open`. While what
 * is `shown` stays the same, so does what `mount` made.
 * @param {object} options
 * @param {string} options.kind
 * @param {(bytes: Uint8Array, id: string) => any} options.open
 * @param {(host: HTMLElement, opened: any, told: any, report: (heard: object) => void) => Mounted} options.mount
 * @param {(told: any) => string} [options.shown]
 * @returns {(message: Message) => Promise<void>}
 */
export const component = ({ kind, open, mount, shown = (told) => told.id }) => {
  const shelf = (shelves[kind] ??= new Map()),
    mounted = new WeakMap();
  let latest;
  const found = async (id, bytes) => {
    const opened = bytes.length && !shelf.has(id) ? await open(bytes, id) : shelf.get(id);
    if (!opened) return undefined;
    shelf.delete(id);
    shelf.set(id, opened);
    while (shelf.size > HELD) shelf.delete(shelf.keys().next().value);
    return opened;
  };
  return async ({ data, parentElement, setTriggerValue }) => {
    const view = new DataView(data.buffer, data.byteOffset),
      length = view.getUint32(0, true);
    const told = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length)));
    const opened = await found(told.id, data.subarray(4 + length));
    let kept = mounted.get(parentElement);
    if (!opened) {
      const { unheard: step, id, revision } = kept ?? {};
      setTriggerValue('rested', { missing: told.id, ...(step !== undefined && { step, id, revision }) });
      return;
    }
    if (kept && kept.shown === shown(told) && kept.host.isConnected) {
      kept.report = setTriggerValue;
      if (kept.revision !== told.revision || kept.unheard === told.at) kept.unheard = undefined;
      if (kept.revision !== told.revision) kept.place(told.at);
      kept.revision = told.revision;
      kept.news?.(told);
      return;
    }
    kept?.stop();
    const host = element('div', { class: `laplace-${kind}` });
    parentElement.querySelectorAll(`.laplace-${kind}`).forEach((old) => old.remove());
    parentElement.append(host);
    const made = { host, unheard: undefined };
    // Streamlit keeps the last answer only, where the server has not read the one before: so every answer repeats the
    // step that Python has not confirmed yet.
    const report = (heard) => {
      made.unheard = heard.step ?? made.unheard;
      const { revision, unheard } = kept;
      kept.report('rested', { ...heard, revision, ...(unheard !== undefined && { step: unheard }) });
    };
    kept = Object.assign(made, mount(host, opened, told, report));
    Object.assign(kept, { shown: shown(told), revision: told.revision, report: setTriggerValue });
    mounted.set(parentElement, kept);
    // Streamlit may take it off the page and put it back with an old message: a step that Python has not heard of yet,
    // because the cursor had not come to rest, is kept.
    if (latest && !latest.host.isConnected && latest.id === told.id && latest.revision === told.revision)
      kept.cursor.to(latest.cursor.step);
    latest = Object.assign(kept, { id: told.id });
  };
};

/**
 * The cursor from 0 to `last`. `bar` and `moves` are to be put somewhere.
 * @param {object} options
 * @param {HTMLElement} options.host
 * @param {{ at: number, seconds: number, id: string }} options.told - the step that it begins at, and seconds a step
 * @param {number} options.last
 * @param {string} options.name
 * @param {string} options.label
 * @param {() => void} options.show - draws its step
 * @param {(heard: { step: number, id: string }) => void} options.report
 * @returns {Stepper}
 */
export function stepper({ host, told, last, name, label, show, report }) {
  let step = Math.min(told.at, last),
    reported = step,
    playing,
    resting,
    since;
  const bar = element('input', { type: 'range', min: 0, max: last, step: 1, 'aria-label': label, name });
  const play = button('▶', 'play', () => (playing ? stop() : begin()));
  const moves = [
    button('|‹', 'first step', () => to(0)),
    button('‹', 'one step back', () => to(step - 1)),
    play,
    button('›', 'one step on', () => to(step + 1)),
    button('›|', 'last step', () => to(last)),
  ];
  bar.oninput = () => to(+bar.value);

  function go(next) {
    next = Math.max(0, Math.min(last, next));
    if (next === step) return;
    step = next;
    show();
    clearTimeout(resting);
    if (!playing) resting = setTimeout(rest, REST);
  }

  const to = (next) => {
    stop();
    go(next);
  };

  function rest() {
    if (!host.isConnected || step === reported) return;
    reported = step;
    report({ step, id: told.id });
  }

  function begin() {
    if (step === last) go(0);
    clearTimeout(resting);
    since = undefined;
    const tick = (now) => {
      if (!playing || !host.isConnected) return;
      since ??= now;
      const steps = Math.floor((now - since) / (1000 * told.seconds));
      if (steps) {
        since += steps * 1000 * told.seconds;
        go(step + steps);
      }
      if (step >= last) {
        stop();
        return;
      }
      playing = requestAnimationFrame(tick);
    };
    playing = requestAnimationFrame(tick);
    words('❚❚', 'pause');
  }

  function stop() {
    if (!playing) return;
    cancelAnimationFrame(playing);
    playing = undefined;
    words('▶', 'play');
    resting = setTimeout(rest, REST);
  }

  function words(sign, title) {
    play.textContent = sign;
    play.title = title;
    play.setAttribute('aria-label', title);
  }

  return {
    bar,
    moves,
    to,
    stop,
    get step() {
      return step;
    },
    // Python has moved it and needs no report.
    place(next) {
      to(next);
      reported = step;
      clearTimeout(resting);
    },
    // Dragged over a picture, whose `toStep` knows where a step lies.
    over(canvas) {
      canvas.onpointerdown = (event) => {
        canvas.setPointerCapture(event.pointerId);
        to(canvas.toStep?.(event.offsetX) ?? step);
      };
      canvas.onpointermove = (event) => {
        if (event.buttons) to(canvas.toStep?.(event.offsetX) ?? step);
      };
    },
  };
}
