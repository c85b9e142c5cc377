// The lens as a separate file.
import { element } from '../draw/elements.js';
import { mount } from './lens.js';
import { read } from '../core/model.js';

function standalone(held) {
  const bytes = Uint8Array.from(atob(held.payload), (sign) => sign.charCodeAt(0));
  const box = document.body.appendChild(element('div', { class: 'laplace-lens-box' }));
  return mount(box, { ...read(bytes), id: 'file' }, { ...held, payload: undefined }, () => {});
}

standalone(JSON.parse(document.querySelector('#held')?.textContent ?? ''));
