// The chart component: one div per key.
import { plot } from './plot.js';
import { loadPlotly } from './plotly.js';

export default function (component) {
  const { data, parentElement, setTriggerValue } = component;
  loadPlotly(data.plotly);
  let box = parentElement.querySelector('.laplace-chart');
  if (!box) {
    box = document.createElement('div');
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
