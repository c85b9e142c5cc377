// The chart component: one div per key.
/** @import { ChartBox, Message } from '../types.js' */
import { plot } from './plot.js';
import { loadPlotly } from './plotly.js';

/**
 * Shows a message of Streamlit: one div per key.
 * @param {Message} component
 * @returns {void}
 */
export default function (component) {
  const { data, parentElement, setTriggerValue } = component;
  loadPlotly(data.plotly);
  const there = parentElement.querySelector('.laplace-chart');
  const box = /** @type {ChartBox} */ (there ?? document.createElement('div'));
  if (!there) {
    box.className = 'laplace-chart';
    box.style.height = `${data.height}px`;
    box.setAttribute('role', 'group');
    parentElement.append(box);
  }
  box.setAttribute('aria-label', data.alt);
  box.clickable = data.clickable;
  box.report = setTriggerValue;
  box.wanted = data;
  plot(box);
}
