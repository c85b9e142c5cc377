// A plotly figure drawn into a box and updated in place, so that zoom, camera and scroll survive. The box holds what is
// wanted: `wanted` { figure, revision, name }, `clickable`, and `report(name, value)` for what is clicked.
/** @import { ChartBox } from '../types.js' */
import { plotly } from './plotly.js';

// On opening, charts are drawn one at a time: the first is on screen before the last is computed. Updates do not wait.
let drawing;

function inTurn(box, work) {
  if (box.listening) return Promise.resolve().then(work);
  const frame = () => new Promise((next) => setTimeout(next, 0));
  drawing = (drawing ?? plotly())
    .catch(() => {})
    .then(frame)
    .then(work);
  return drawing;
}

function themed(layout, host) {
  const style = getComputedStyle(host);
  const colour = style.getPropertyValue('--st-text-color').trim() || style.color;
  const grid = 'rgba(138, 143, 152, 0.28)';
  const axis = { gridcolor: grid, linecolor: grid, zerolinecolor: 'rgba(138, 143, 152, 0.6)', ticks: '' };
  const painted = {
    ...layout,
    paper_bgcolor: 'rgba(0,0,0,0)',
    plot_bgcolor: 'rgba(0,0,0,0)',
    font: { family: style.fontFamily, color: colour, size: 12 },
    autosize: true,
    height: host.clientHeight || layout.height, // the place that the page gives it, which may be lower
    modebar: { bgcolor: 'rgba(0,0,0,0)', color: 'rgba(138, 143, 152, 0.8)', activecolor: colour },
  };
  const page = style.getPropertyValue('--st-background-color').trim();
  if (layout.annotations)
    painted.annotations = layout.annotations.map((each) =>
      each.bgcolor ? { ...each, bgcolor: page || '#fff' } : each,
    );
  // A legend within the picture hides the curves under it.
  if (layout.legend?.bgcolor && /^#[0-9a-f]{6}$/i.test(page))
    painted.legend = { ...layout.legend, bgcolor: `${page}d9` };
  for (const name of Object.keys(layout)) {
    if (/^[xy]axis\d*$/.test(name)) painted[name] = { ...axis, ...layout[name] };
  }
  return painted;
}

const TO_SVG = {
  name: 'Download as SVG',
  icon: { width: 24, height: 24, path: 'M5 20h14v-2H5v2zM19 9h-4V3H9v6H5l7 7 7-7z' },
  click: (plot) => window.Plotly.downloadImage(plot, { format: 'svg', filename: plot.dataset.name }),
};

/**
 * Draws the figures of a box, one after the other.
 * @param {ChartBox} box
 * @returns {void}
 */
export function plot(box) {
  inTurn(box, async () => {
    const Plotly = await plotly();
    const { figure, revision, name } = box.wanted;
    if (box.drawn === figure) return;
    box.drawn = figure;
    box.dataset.name = name;
    const { data, layout } = JSON.parse(figure);
    const config = {
      displaylogo: false,
      responsive: true,
      displayModeBar: window.innerWidth > 640 ? 'hover' : false,
      modeBarButtons: [
        ['toImage', TO_SVG],
        layout.scene ? ['resetCameraDefault3d'] : ['zoom2d', 'pan2d', 'resetScale2d'],
      ],
      toImageButtonOptions: { filename: name, scale: 2 },
    };
    Plotly.react(box, data, themed({ ...layout, uirevision: revision }, box), config);
    if (box.listening) return;
    box.listening = true;
    box.on('plotly_click', (event) => {
      const picked = event.points[0]?.customdata;
      if (box.clickable && Array.isArray(picked)) box.report('clicked', picked[0]);
    });
    const resized = new ResizeObserver(() => {
      if (!box.isConnected) resized.disconnect();
      else if (box.offsetParent) Plotly.Plots.resize(box);
    });
    if (box.parentElement) resized.observe(box.parentElement);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () =>
      setTimeout(() => {
        box.drawn = null;
        plot(box);
      }, 400),
    );
  }).catch((error) => {
    box.textContent = `The picture could not be drawn: ${error.message}. Reload the page.`;
  });
}
