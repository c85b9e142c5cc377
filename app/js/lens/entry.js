// The lens inside Streamlit: a message is a small JSON and, if the browser does not hold it yet, a payload. The rule
// of payloads, revisions and releases is written down in laplace_core/exchange/messages.py.
/** @import { Message } from '../types.js' */
import { element } from '../draw/elements.js';
import { mount, shapeOf } from './lens.js';
import { modelOf } from './models.js';
import { hub } from '../hub.js';
import { loadPlotly } from '../chart/plotly.js';

const mounted = new WeakMap();
// The state released last, by the name of the lens: Streamlit may take a component off the page and put it back with an
// old message.
const released = new Map();

// The page that a lens is saved as.
const template = () => fetch(new URL('./offline.html', import.meta.url)).then((answer) => answer.text());

// The player of an episode may have moved on since the server was told of a step: then its step is shown.
function led(model, told) {
  const lead = hub.leader;
  if (!lead || !told.lead || lead.id !== told.lead.id || lead.step === told.lead.step) return [model, told];
  const [shown, news] = lead.over(model);
  return [shown, { ...told, ...news }];
}

/**
 * Shows a message of Streamlit.
 * @param {Message} message
 * @returns {void}
 */
export default function ({ data, parentElement, setTriggerValue }) {
  const view = new DataView(data.buffer, data.byteOffset),
    length = view.getUint32(0, true);
  const message = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length))),
    { name, id, revision } = message;
  loadPlotly(message.plotly);
  const kept = mounted.get(parentElement),
    given = modelOf(id, data.subarray(4 + length));
  if (!given) {
    // This answer takes the place of a release that Python has not read: so it repeats it.
    const last = released.get(name);
    const repeated = last?.revision === revision && { revision, state: last.state };
    setTriggerValue('released', { missing: id, ...repeated });
    return;
  }
  const [model, told] = led(given, { ...message, live: true, template }),
    shape = shapeOf(model) + !message.world;
  if (kept && kept.lens.host.isConnected && kept.shape === shape) {
    kept.report = setTriggerValue;
    const moved = kept.revision !== revision;
    Object.assign(kept, { id, revision });
    kept.lens.show(model, told, moved);
    return;
  }
  const there = /** @type {HTMLElement | null} */ (parentElement.querySelector('.laplace-lens-box')),
    box = there ?? element('div', { class: 'laplace-lens-box' });
  if (!there) parentElement.append(box);
  const last = released.get(name),
    state = last?.revision === revision ? last.state : message.state;
  const fresh = { id, revision, shape, world: model.header.world, report: setTriggerValue };
  mounted.set(parentElement, fresh);
  // The same world in another shape, learned after exact, keeps what the hand did and is about to do.
  const before = kept?.world === model.header.world ? kept.lens.leave() : undefined;
  fresh.lens = mount(box, model, { ...told, state, kept: before }, (heard) => {
    released.set(name, { revision: fresh.revision, state: heard.state });
    fresh.report('released', { ...heard, id: fresh.id, revision: fresh.revision });
  });
}
