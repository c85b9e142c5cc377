// The colours of the page, light or dark.
/** @import { Colours } from '../types.js' */

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
    soft: light ? '#a9b1ba' : '#5b636d',
    wash: light ? 'rgba(59,201,219,0.22)' : 'rgba(11,114,133,0.16)',
    mark: light ? '#ffffff' : '#000000',
    halo: light ? 'rgba(0,0,0,0.65)' : 'rgba(255,255,255,0.75)',
    empty: light ? '#1b2026' : '#eceff2',
  };
}
