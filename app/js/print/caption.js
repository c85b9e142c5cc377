// What is written under a printed picture: all settings that it shows.
/** @import { Scene } from '../types.js' */
import { SWITCHES, available } from '../core/maths.js';
import { short } from '../draw/drawing.js';
import { typeset } from './layout.js';
import { simulatedFor } from '../lens/simulated.js';

const ROWS = { none: 'as decoded', survival: 'given survival', paper: 'rescaled to probability 1' };
const range = (values, first, last) => `${short(values[first])} to ${short(values[last])}`;
const some = (number, words) => `${number} ${words}${number === 1 ? '' : 's'}`;

/**
 * The settings in words.
 * @param {Pick<Scene, 'model' | 'state' | 'seen' | 'pinned' | 'followed'>} scene
 * @param {string[]} names - of the panels that are printed
 * @returns {string}
 */
export function captionOf(scene, names) {
  const { model, state, seen } = scene,
    { header, sloped, arrays } = model,
    { gammas, G } = seen.grid,
    { thetas, H, open } = seen;
  const slope = arrays.places
    ? `${short(state.slope_share)} of the trained slope`
    : `slope ${short(state.slope)} / reward`;
  const parts = [
    `World ${header.world}`,
    header.state && `state ${header.state}`,
    `action ${header.actions[state.action]}`,
    `α = ${short(state.alpha)}`,
    header.solver === 'tikhonov' ? 'solver Tikhonov, filter factors s²/(s² + α²)' : `solver ${header.solver}`,
    `T = ${some(+short(state.horizon), 'step')}`,
    state.used && `${some(state.used, 'step')} used`,
    state.softness && `deadline softness ${short(state.softness)} T`,
    state.value_gamma < 1 && `γ in the value ${short(state.value_gamma, 4)}`,
    (sloped || arrays.places) && slope,
    state.noise && `noise ${short(state.noise)}, seed ${state.noise_seed}`,
  ];
  const grid = [
    `${some(G, 'discount')} γ from ${range(gammas, 0, G - 1)}${header.added ? `, ${header.added} added in each gap` : ''}`,
    `${some(open ? H - 1 : H + 1, 'sensitivit')
      .replace(/t$/, 'ty')
      .replace(/ts$/, 'ties')} θ from ` + `${open ? range(thetas, 1, H - 1) : range(thetas, 0, H)} reward`,
    `${some(model.K, 'row')} τ of ${some(+short(model.dt), 'step')}`,
  ];
  const switched = Object.entries(SWITCHES)
    .filter(([name, each]) => name !== 'rescale' && available(model, name) && each.isOn(state))
    .map(([, each]) => each.label);
  const mark = state.look === 'surface' ? 'Orange line' : 'White outline',
    drawn = [];
  if (names.includes('tau-space') && seen.truth) drawn.push(`${mark}: true timeline.`);
  if (names.includes('tau-space') && !seen.truth && simulatedFor(scene))
    drawn.push(`${mark}: simulated continuations.`);
  if (names.includes('values') && seen.truth) drawn.push('Dotted: true values.');
  if (scene.pinned && names.some((name) => name === 'values' || name === 'rewards')) drawn.push('Dashed: view A.');
  return typeset(
    [
      `${parts.filter(Boolean).join(', ')}.`,
      `Grid: ${grid.join('; ')}.`,
      `Rows ${ROWS[state.normalise]}.`,
      switched.length ? `Switched on: ${switched.join(', ')}.` : '',
      ...drawn,
    ]
      .filter(Boolean)
      .join(' '),
  );
}
