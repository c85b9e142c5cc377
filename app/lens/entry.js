// The lens inside Streamlit: one message is a small JSON (state, opening state, presets) and a payload.
import { element } from './controls.js';
import { mount } from './lens.js';
import { read } from './maths.js';

const mounted = new WeakMap();

export default function ({ data, parentElement, setTriggerValue }) {
  const view = new DataView(data.buffer, data.byteOffset), length = view.getUint32(0, true);
  const message = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length)));
  let kept = mounted.get(parentElement);
  if (!kept || kept.id !== message.id || !kept.lens.host.isConnected) {
    let box = parentElement.querySelector('.laplace-lens-box');
    if (!box) parentElement.append(box = element('div', { class: 'laplace-lens-box' }));
    const model = { ...read(data.subarray(4 + length)), id: message.id };
    kept = { id: message.id, revision: message.revision };
    kept.lens = mount(box, { model, ...message, template: globalThis.laplaceLensTemplate }, (heard) => kept.report('released', heard));
    mounted.set(parentElement, kept);
  } else if (kept.revision !== message.revision) {
    kept.revision = message.revision;
    kept.lens.show(message.state, message.base);
  }
  kept.report = setTriggerValue;
}
