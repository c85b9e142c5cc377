// The colours of the page, light or dark.
/** @import { Colours } from '../types.js' */

// What follows from a text that is light, on a dark page, or dark.
const shadesFor = (light) => ({
  soft: light ? '#a9b1ba' : '#5b636d',
  wash: light ? 'rgba(59,201,219,0.22)' : 'rgba(11,114,133,0.16)',
  mark: light ? '#ffffff' : '#000000',
  halo: light ? 'rgba(0,0,0,0.65)' : 'rgba(255,255,255,0.75)',
  empty: light ? '#1b2026' : '#eceff2',
});

/**
 * The colours for paper, in either theme of the page.
 * @type {Colours}
 */
export const PAPER = { text: '#1d2127', primary: '#0b7285', paper: '#ffffff', font: 'sans-serif', ...shadesFor(false) };

/**
 * A colour in its parts, for writers that know no CSS.
 * @param {string} colour - as #rrggbb, rgb(r,g,b) or rgba(r,g,b,a)
 * @returns {{ hex: string, alpha: number }}
 */
export function inkOf(colour) {
  if (/^#[0-9a-f]{6}$/i.test(colour)) return { hex: colour, alpha: 1 };
  if (/^#[0-9a-f]{3}$/i.test(colour)) return { hex: colour.replace(/[0-9a-f]/gi, '$&$&'), alpha: 1 };
  const [red, green, blue, alpha = 1] = (colour.match(/[\d.]+/g) ?? []).map(Number);
  if (!/^rgba?\(/.test(colour) || blue === undefined) throw new Error(`${colour} is no colour that can be printed`);
  return { hex: `#${[red, green, blue].map((each) => each.toString(16).padStart(2, '0')).join('')}`, alpha };
}

/**
 * The colours that an element of the page has to be drawn in.
 * @param {HTMLElement} host
 * @returns {Colours}
 */
export function coloursOf(host) {
  const style = getComputedStyle(host),
    named = (name, other) => style.getPropertyValue(name).trim() || other;
  const text = style.color,
    primary = named('--st-primary-color', '#0b7285'),
    paper = named('--st-background-color', '#ffffff');
  const light = (text.match(/\d+/g) ?? ['0']).slice(0, 3).reduce((a, b) => a + +b, 0) > 382;
  return {
    text,
    primary,
    paper,
    font: style.fontFamily,
    ...shadesFor(light),
  };
}
