// The world of the lens as a graph, drawn by plotly from a figure of the library; a click looks from another state.
/** @import { ChartBox, WorldPanel } from '../types.js' */
import { element } from '../draw/elements.js';
import { plot } from '../chart/plot.js';

/**
 * The graph of the world.
 * @param {(picked: number) => void} report - called with the state that is clicked
 * @returns {WorldPanel}
 */
export function worldPanel(report) {
  /** @type {HTMLElement} */
  const div = element('div', { class: 'world laplace-chart', role: 'group' });
  const box = /** @type {ChartBox} */ (div);
  Object.assign(box, { clickable: true, report: (_, picked) => report(picked) });
  return {
    box,
    show({ figure, alt, revision }) {
      box.setAttribute('aria-label', alt);
      if (box.wanted?.figure === figure) return;
      box.wanted = { figure, revision, name: 'world' };
      plot(box);
    },
    picture: (format) =>
      window.Plotly.toImage(box, { format, width: 440, height: 260, scale: format === 'png' ? 2 : 1 }),
  };
}
