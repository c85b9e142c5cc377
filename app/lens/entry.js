// The lens inside Streamlit: one message is a small JSON (state, opening state, presets) and a payload.
import { element } from './controls.js';
import { mount } from './lens.js';
import { read } from './maths.js';

const mounted = new WeakMap();
// What was let go of last, by name: Streamlit may take a component off the page and put it back with an old message.
const released = globalThis.laplaceLenses ??= new Map();

export default function ({ data, parentElement, setTriggerValue }) {
  const view = new DataView(data.buffer, data.byteOffset), length = view.getUint32(0, true);
  const message = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length))), { name, id, revision } = message;
  let kept = mounted.get(parentElement);
  if (!kept || kept.id !== id || !kept.lens.host.isConnected) {
    let box = parentElement.querySelector('.laplace-lens-box');
    if (!box) parentElement.append(box = element('div', { class: 'laplace-lens-box' }));
    const last = released.get(name), state = last?.id === id && last.revision === revision ? last.state : message.state;
    kept = { id, revision };
    kept.lens = mount(box, {
      model: { ...read(data.subarray(4 + length)), id }, state, base: message.base, presets: message.presets,
      template: globalThis.laplaceLensTemplate,
    }, (heard) => {
      released.set(name, { id, revision: kept.revision, state: heard.state });
      kept.report('released', heard);
    });
    mounted.set(parentElement, kept);
  } else if (kept.revision !== revision) {
    kept.revision = revision;
    kept.lens.show(message.state, message.base);
  }
  kept.report = setTriggerValue;
}
