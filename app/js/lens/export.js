// Taking the lens along, without a server: pictures of all panels, a table, and the lens itself as one file.
/** @import { Panel, Saved, Scene } from '../types.js' */
import { canvasPen, contextOf, escaped, short, svgPen } from '../draw/drawing.js';
import { distancesOf, simulatedFor } from './simulated.js';

const SIZE = { w: 440, h: 260, gap: 16, head: 66, columns: 3 };
const WIDE = SIZE.columns * (SIZE.w + SIZE.gap) + SIZE.gap;
const place = (i) => [
  SIZE.gap + (i % SIZE.columns) * (SIZE.w + SIZE.gap),
  SIZE.head + Math.floor(i / SIZE.columns) * (SIZE.h + SIZE.gap),
];
const heightOf = (count) => SIZE.head + Math.ceil(count / SIZE.columns) * (SIZE.h + SIZE.gap);

/**
 * Hands a file to the browser to be saved.
 * @param {Blob | string} content
 * @param {string} name
 * @param {string} [type]
 * @returns {void}
 */
export function save(content, name, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

// JSON on one line of a table: a comma within a word would begin a new cell, and that could be a formula.
const commented = (value) =>
  JSON.stringify(value, (_, each) => (typeof each === 'string' ? each.replaceAll(',', '\0') : each)).replaceAll(
    '\\u0000',
    '\\u002c',
  );

// Words as a cell that no spreadsheet takes for a formula; `csv_cell` in Python is the same rule.
const quoted = (words) => `"${`${/^[=+@\t\r\n-]/.test(words) ? "'" : ''}${words}`.replace(/"/g, '""')}"`;

/**
 * The beginning of the names of files.
 * @param {Pick<Saved, 'scene'>} lens
 * @returns {string}
 */
export const nameOf = ({ scene: { model } }) =>
  `lens_${model.header.world.replace(/[^A-Za-z0-9_-]+/g, '_').slice(0, 40)}`;

// The verdict, on as many lines as it needs, and the pictures under it.
function heading(pen, { verdict, scene: { model, state, colours } }) {
  const lines = [''];
  for (const word of verdict.split(' ')) {
    const longer = `${lines[lines.length - 1]} ${word}`.trim();
    if (pen.width(longer, 14) > WIDE - 2 * SIZE.gap) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  lines.slice(0, 2).forEach((line, i) => pen.text(line, SIZE.gap, 20 + 17 * i, { size: 14, colour: colours.text }));
  const { header } = model,
    rows = { none: 'as decoded', survival: 'given survival', paper: 'rescaled to 1' }[state.normalise];
  pen.text(
    [
      header.world,
      header.state,
      header.actions[state.action],
      `α ${short(state.alpha)}`,
      `T ${short(state.horizon)}`,
      `rows ${rows}`,
    ]
      .filter(Boolean)
      .join(' · '),
    SIZE.gap,
    56,
    { size: 12, colour: colours.soft },
  );
}

// The world's graph as a picture, if there is one: it stands first.
const worldOf = async (lens, format) => (lens.world ? [await lens.world.picture(format)] : []);

/**
 * Saves all pictures as one PNG.
 * @param {Saved} lens
 * @returns {Promise<void>}
 */
export async function savePng(lens) {
  const dense = 2,
    { colours } = lens.scene,
    worlds = await worldOf(lens, 'png');
  const canvas = document.createElement('canvas'),
    high = heightOf(worlds.length + lens.panels.length);
  Object.assign(canvas, { width: WIDE * dense, height: high * dense });
  const context = contextOf(canvas),
    pen = canvasPen(context, colours.font);
  context.scale(dense, dense);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, WIDE, high);
  heading(pen, lens);
  for (const address of worlds) {
    const image = Object.assign(new Image(), { src: address });
    await image.decode();
    const [x, y] = place(0);
    context.drawImage(image, x, y, SIZE.w, SIZE.h);
  }
  lens.panels.forEach((each, i) => {
    context.save();
    const [x, y] = place(i + worlds.length);
    context.translate(x, y);
    lens.drawOne(pen, each, SIZE.w, SIZE.h);
    context.restore();
  });
  canvas.toBlob((blob) => blob && save(blob, `${nameOf(lens)}.png`));
}

/**
 * All pictures as one SVG.
 * @param {Saved} lens
 * @returns {Promise<string>}
 */
async function svgOf(lens) {
  const { colours } = lens.scene,
    measure = canvasPen(contextOf(document.createElement('canvas')), colours.font).width;
  const worlds = await worldOf(lens, 'svg'),
    pen = svgPen(colours.font, measure),
    high = heightOf(worlds.length + lens.panels.length);
  heading(pen, lens);
  for (const address of worlds) {
    const [x, y] = place(0);
    pen.parts.push(`<image href="${escaped(address)}" x="${x}" y="${y}" width="${SIZE.w}" height="${SIZE.h}"/>`);
  }
  lens.panels.forEach((each, i) => {
    pen.parts.push(`<g transform="translate(${place(i + worlds.length).join(' ')})">`);
    lens.drawOne(pen, each, SIZE.w, SIZE.h);
    pen.parts.push('</g>');
  });
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDE} ${high}" width="${WIDE}" height="${high}">` +
    `<rect width="100%" height="100%" fill="${colours.paper}"/>${pen.parts.join('\n')}</svg>`
  );
}

/**
 * Saves all pictures as one SVG.
 * @param {Saved} lens
 * @returns {Promise<void>}
 */
export const saveSvg = async (lens) => save(await svgOf(lens), `${nameOf(lens)}.svg`, 'image/svg+xml');

/**
 * Saves one picture.
 * @param {Saved} lens
 * @param {{ panel: Panel }} each
 * @param {'svg' | 'png'} format
 * @returns {void}
 */
export function savePanel(lens, each, format) {
  const { colours } = lens.scene,
    canvas = document.createElement('canvas'),
    name = `${nameOf(lens)}_${each.panel.name}`,
    { w, h } = SIZE;
  if (format === 'svg') {
    const pen = svgPen(colours.font, canvasPen(contextOf(canvas), colours.font).width);
    lens.drawOne(pen, each, w, h);
    const content =
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${w} ${h}" width="${w}" height="${h}">` +
      `<rect width="100%" height="100%" fill="${colours.paper}"/>${pen.parts.join('\n')}</svg>`;
    save(content, `${name}.svg`, 'image/svg+xml');
    return;
  }
  Object.assign(canvas, { width: 2 * w, height: 2 * h });
  const context = contextOf(canvas);
  context.scale(2, 2);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, w, h);
  lens.drawOne(canvasPen(context, colours.font), each, w, h);
  canvas.toBlob((blob) => blob && save(blob, `${name}.png`));
}

/**
 * A table, one row a future step: decoded and true reward and survival, the value of the horizon that ends there,
 * tau-space.
 * @param {{ scene: Pick<Scene, 'model' | 'state' | 'seen' | 'images'> }} lens
 * @returns {string} as CSV
 */
export function csvOf({ scene }) {
  const { model, seen, state } = scene,
    simulated = simulatedFor(scene),
    far = simulated && distancesOf(scene);
  const came = (tau) =>
    simulated && far
      ? [...['reward', 'rewardError', 'survival', 'survivalError'].map((name) => simulated[name][tau]), far[tau]]
      : [];
  const names = model.header.actions,
    a = state.action;
  const head = [
    'tau',
    'reward',
    'survival',
    ...(seen.truth ? ['true reward', 'true survival'] : []),
    'horizon',
    ...names.map((name) => `value of ${name}`),
    ...(simulated ? ['simulated reward', 'its error', 'simulated survival', 'its error', 'W1'] : []),
    ...(seen.truth ? ['best action'] : []),
    ...Array.from(
      seen.midpoints,
      (theta, h) => `P ${!seen.open || (h && h < seen.H - 1) ? 'at' : h ? 'above' : 'below'} ${+theta.toPrecision(8)}`,
    ),
  ];
  const rows = Array.from({ length: model.K }, (_, k) => [
    k * model.dt,
    seen.rewards[a][k],
    seen.survival[a][k],
    ...(seen.truth ? [seen.truth.rewards[a][k], seen.truth.survival[a][k]] : []),
    model.horizons[k],
    ...seen.values.map((line) => line[k]),
    ...came(k * model.dt),
    ...(seen.truth ? [quoted(names[seen.bestAt(k)])] : []),
    ...(k < seen.n ? seen.tau.slice(k * seen.H, (k + 1) * seen.H) : Array(seen.H).fill('')),
  ]);
  const { world, state: from_state } = model.header,
    gammas = Array.from(seen.grid.gammas);
  return [
    `# ${commented({ world, from_state, ...state, action: names[a], gammas })}`,
    head.map(quoted).join(','),
    ...rows.map((row) => row.map((x) => x ?? '').join(',')),
  ].join('\n');
}

/**
 * Saves the table.
 * @param {Saved} lens
 * @returns {void}
 */
export const saveCsv = (lens) => save(csvOf(lens), `${nameOf(lens)}.csv`, 'text/csv');

const HELD = '<script id="held" type="application/json">';

/**
 * The lens as a separate file.
 * @param {Pick<Saved, 'told' | 'scene'>} lens
 * @param {string | undefined} still - the address of a picture of the world
 * @param {string} template - the page, as app/offline/page.html
 * @returns {string} as HTML
 */
export function htmlOf({ told, scene: { model, state } }, still, template) {
  const bytes = model.bytes ?? new Uint8Array();
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  const held = { state, base: told.base, still, payload: btoa(text) };
  return template.replace(HELD, (tag) => tag + JSON.stringify(held).replace(/</g, '\\u003c'));
}

/**
 * Saves the lens as a separate file; not while a player runs through an episode.
 * @param {Saved} lens
 * @returns {Promise<void>}
 */
export const saveHtml = async (lens) => {
  const { template } = lens.told;
  if (!lens.scene.model.bytes || !template) return;
  const [still] = await worldOf(lens, 'svg');
  save(htmlOf(lens, still, await template()), `${nameOf(lens)}.html`, 'text/html');
};
