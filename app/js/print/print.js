// The dialog that saves panels of the lens for print: which, how wide, as what; with a preview of the very file.
/** @import { Saved } from '../types.js' */
import { PAPER } from '../draw/colours.js';
import { element } from '../draw/elements.js';
import { resolution } from '../core/maths.js';
import { nameOf, save } from '../lens/export.js';
import { WORLD } from '../lens/help.js';
import { captionOf } from './caption.js';
import { PER_MM, WIDTHS } from './layout.js';
import { pdfOf } from './document.js';
import { missingFrom } from './letters.js';
import { densityOf, drawSheet, pngOf, sheetOf, svgOf } from './sheet.js';

const FORMATS = ['PDF', 'SVG', 'PNG'];

// The graph of the world in light colours, as dots: plotly draws it.
async function worldOf(box, w, h) {
  const { data, layout } = /** @type {any} */ (box);
  const annotations = layout.annotations?.map((each) => (each.bgcolor ? { ...each, bgcolor: PAPER.paper } : each));
  const light = { ...layout, annotations, paper_bgcolor: PAPER.paper, plot_bgcolor: PAPER.paper, width: w, height: h };
  const address = await globalThis.Plotly.toImage(
    { data, layout: { ...light, font: { ...layout.font, color: PAPER.text, size: 11 } } },
    { format: 'png', width: w, height: h, scale: 600 / 96 },
  );
  const image = Object.assign(new Image(), { src: address });
  await image.decode();
  const canvas = element('canvas', { width: image.naturalWidth, height: image.naturalHeight });
  canvas.getContext('2d')?.drawImage(image, 0, 0);
  return canvas;
}

// Draws in the colours of paper and without the cursor, whatever the page shows.
function onPaper(scene, draw) {
  const { model, state, seen } = scene,
    { colours, hover, band, at, resolution: window } = scene,
    row = seen.readRow;
  Object.assign(scene, { colours: PAPER, hover: {}, band: undefined, at: row });
  scene.resolution = resolution(model, state, seen, row);
  try {
    draw();
  } finally {
    Object.assign(scene, { colours, hover, band, at, resolution: window });
  }
}

/**
 * What can be printed of a lens.
 * @param {Saved} lens
 * @returns {string[]} names
 */
export const printable = ({ world, panels }) => [...(world ? ['world'] : []), ...panels.map(({ panel }) => panel.name)];

// What a panel is called on the page.
const titleOf = ({ panels }, name) => panels.find(({ panel }) => panel.name === name)?.panel.title ?? WORLD.title;

/**
 * A sheet of panels with its caption, and what draws it.
 * @param {Saved} lens
 * @param {string[]} names - in any order; they are printed in that of the lens
 * @param {number} mm - width
 */
export async function sheetFor(lens, names, mm) {
  const { scene } = lens,
    chosen = printable(lens).filter((name) => names.includes(name)),
    caption = captionOf(scene, chosen),
    { sheet, lines } = sheetOf(chosen.length, mm, caption);
  const graph =
    chosen[0] === 'world' && lens.world ? await worldOf(lens.world.box, sheet.cells[0].w, sheet.cells[0].h) : null;
  const panels = chosen.map((name) => {
    const each = lens.panels.find(({ panel }) => panel.name === name);
    return (pen, w, h) => (each ? lens.drawOne(pen, each, w, h) : pen.image(graph, 0, 0, w, h));
  });
  return {
    sheet,
    about: {
      title: `${scene.model.header.world}: ${chosen.map((name) => titleOf(lens, name)).join(', ')}`,
      caption,
    },
    draw: (pen) => onPaper(scene, () => drawSheet(pen, sheet, panels, lines)),
  };
}

async function fileOf({ sheet, draw, about }, format) {
  if (format === 'PDF')
    return new Blob([pdfOf(await import('./pdf.js'), sheet, draw, about)], { type: 'application/pdf' });
  const svg = svgOf(sheet, draw, about);
  return format === 'PNG' ? pngOf(svg, sheet) : new Blob([svg], { type: 'image/svg+xml' });
}

/**
 * Opens the dialog.
 * @param {Saved} lens
 * @returns {void}
 */
export function openPrint(lens) {
  const { host } = lens,
    names = printable(lens),
    live = Boolean(lens.told.live);
  const field = (type, name, value, words, checked, disabled = false) =>
    element('label', {}, element('input', { type, name, value, checked, disabled }), ` ${words}`);
  const boxes = names.map((name) => field('checkbox', 'panel', name, titleOf(lens, name), name === 'tau-space'));
  const group = (legend, ...parts) => element('fieldset', {}, element('legend', {}, legend), ...parts);
  const preview = element('img', { alt: '' }),
    status = element('p', { role: 'status' }),
    saver = element('button', { type: 'submit', class: 'remedy' }, 'Save');
  const form = element(
    'form',
    { method: 'dialog' },
    group('Panels', ...boxes, element('button', { type: 'button', class: 'tool', onclick: all }, 'All panels')),
    group('Width', ...WIDTHS.map((mm, i) => field('radio', 'mm', mm, `${mm} mm`, !i))),
    group(
      'File',
      ...FORMATS.map((name) =>
        field('radio', 'format', name, name, name === (live ? 'PDF' : 'SVG'), !live && name === 'PDF'),
      ),
    ),
    ...(live ? [] : [element('p', {}, 'A PDF is saved in the workbench: its writer is too large for this file.')]),
    element(
      'span',
      { class: 'group' },
      saver,
      element('button', { type: 'button', class: 'tool', onclick: () => dialog.close() }, 'Close'),
    ),
    status,
  );
  const dialog = element(
    'dialog',
    { class: 'print', 'aria-label': 'Save for print' },
    form,
    element('figure', {}, preview),
  );
  const chosen = () => {
    const data = new FormData(form);
    return { panels: data.getAll('panel').map(String), mm: Number(data.get('mm')), format: String(data.get('format')) };
  };
  let asked = 0; // the newest preview is shown, whichever is ready last

  function all() {
    form.querySelectorAll('input[name=panel]').forEach((box) => Object.assign(box, { checked: true }));
    show();
  }

  const say = (words) => {
    status.textContent = words;
  };

  async function show() {
    const { panels, mm, format } = chosen(),
      mine = ++asked;
    saver.disabled = !panels.length;
    if (!panels.length) {
      say('Tick at least one panel.');
      return;
    }
    const made = await sheetFor(lens, panels, mm),
      file = await fileOf(made, 'SVG');
    if (mine !== asked || !dialog.isConnected) return;
    URL.revokeObjectURL(preview.src);
    preview.src = URL.createObjectURL(file);
    preview.alt = made.about.caption;
    const { sheet } = made,
      boxed = missingFrom(made.about.title + made.about.caption);
    say(
      `${mm} × ${Math.round(sheet.height / PER_MM)} mm${format === 'PNG' ? `, ${densityOf(sheet)} dots per inch` : ''}` +
        (boxed.length ? `. The font has no ${boxed.join(' ')}: a box is printed instead.` : ''),
    );
  }

  form.onchange = show;
  form.onsubmit = async (event) => {
    event.preventDefault();
    const { panels, mm, format } = chosen();
    try {
      const file = await fileOf(await sheetFor(lens, panels, mm), format);
      const what = panels.length === 1 ? panels[0] : `${panels.length}_panels`;
      save(file, `${nameOf(lens)}_${what}_${mm}mm.${format.toLowerCase()}`);
      say(`Saved as ${format}.`);
    } catch (error) {
      say(`The picture could not be saved: ${error.message}`);
    }
  };
  dialog.onclose = () => {
    URL.revokeObjectURL(preview.src);
    dialog.remove();
  };
  host.append(dialog);
  dialog.showModal();
  show();
}
