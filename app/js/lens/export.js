// Taking the lens along, without a server: pictures of all panels, a table, and the lens itself as one file.
import { canvasPen, escaped, short, svgPen } from '../draw/drawing.js';
import { distancesOf, simulatedFor } from './simulated.js';

const SIZE = { w: 440, h: 260, gap: 16, head: 66, columns: 3 };
const WIDE = SIZE.columns * (SIZE.w + SIZE.gap) + SIZE.gap;
const place = (i) => [
  SIZE.gap + (i % SIZE.columns) * (SIZE.w + SIZE.gap),
  SIZE.head + Math.floor(i / SIZE.columns) * (SIZE.h + SIZE.gap),
];
const heightOf = (count) => SIZE.head + Math.ceil(count / SIZE.columns) * (SIZE.h + SIZE.gap);

export function save(content, name, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

const nameOf = ({ scene: { model } }) => `lens_${model.header.world.replace(/[^A-Za-z0-9_-]+/g, '_').slice(0, 40)}`;

// The verdict, on as many lines as it needs, and under it what is seen.
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

export async function savePng(lens) {
  const dense = 2,
    { colours } = lens.scene,
    worlds = await worldOf(lens, 'png');
  const canvas = document.createElement('canvas'),
    high = heightOf(worlds.length + lens.panels.length);
  Object.assign(canvas, { width: WIDE * dense, height: high * dense });
  const context = canvas.getContext('2d'),
    pen = canvasPen(context, colours.font);
  context.scale(dense, dense);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, WIDE, high);
  heading(pen, lens);
  for (const address of worlds) {
    const image = Object.assign(new Image(), { src: address });
    await image.decode();
    context.drawImage(image, ...place(0), SIZE.w, SIZE.h);
  }
  lens.panels.forEach((each, i) => {
    context.save();
    context.translate(...place(i + worlds.length));
    lens.drawOne(pen, each, SIZE.w, SIZE.h);
    context.restore();
  });
  canvas.toBlob((blob) => save(blob, `${nameOf(lens)}.png`));
}

export async function svgOf(lens) {
  const { colours } = lens.scene,
    measure = canvasPen(document.createElement('canvas').getContext('2d'), colours.font).width;
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
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDE} ${high}" width="${WIDE}" height="${high}"><rect width="100%" height="100%" fill="${colours.paper}"/>${pen.parts.join('\n')}</svg>`;
}

export const saveSvg = async (lens) => save(await svgOf(lens), `${nameOf(lens)}.svg`, 'image/svg+xml');

// One row a future step: decoded and true reward and survival, the value of the horizon that ends there, tau-space.
export function csvOf({ scene }) {
  const { model, seen, state } = scene,
    simulated = simulatedFor(scene),
    far = simulated && distancesOf(scene);
  const came = (tau) => [
    ...['reward', 'rewardError', 'survival', 'survivalError'].map((name) => simulated[name][tau]),
    far[tau],
  ];
  const quoted = (words) => `"${String(words).replace(/"/g, '""')}"`,
    names = model.header.actions,
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
    ...(simulated ? came(k * model.dt) : []),
    ...(seen.truth ? [quoted(names[seen.bestAt(k)])] : []),
    ...(k < seen.n ? seen.tau.slice(k * seen.H, (k + 1) * seen.H) : Array(seen.H).fill('')),
  ]);
  return [
    `# ${JSON.stringify({ world: model.header.world, from_state: model.header.state, ...state, action: names[a], gammas: Array.from(seen.grid.gammas) })}`,
    head.map(quoted).join(','),
    ...rows.map((row) => row.map((x) => x ?? '').join(',')),
  ].join('\n');
}

export const saveCsv = (lens) => save(csvOf(lens), `${nameOf(lens)}.csv`, 'text/csv');

const HELD = '<script id="held" type="application/json">';

export function htmlOf({ told, scene: { model, state } }, still, template) {
  let text = '';
  for (let i = 0; i < model.bytes.length; i += 8192) text += String.fromCharCode(...model.bytes.subarray(i, i + 8192));
  const held = { state, base: told.base, still, payload: btoa(text) };
  return template.replace(HELD, (tag) => tag + JSON.stringify(held).replace(/</g, '\\u003c'));
}

export const saveHtml = async (lens) =>
  lens.scene.model.bytes && // none while a player runs through an episode
  save(htmlOf(lens, (await worldOf(lens, 'svg'))[0], await lens.told.template()), `${nameOf(lens)}.html`, 'text/html');
