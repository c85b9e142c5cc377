// Words as outlines: they look the same everywhere, whatever fonts there are.
import { bold, regular } from './glyphs.js';

const lettersOf = (weight) => (weight >= 600 ? bold : regular);

/**
 * Width of words as they are printed.
 * @param {string} words
 * @param {number} size
 * @param {number} [weight]
 * @returns {number} in the unit of the size
 */
export function widthOf(words, size, weight = 400) {
  const letters = lettersOf(weight);
  let advance = 0;
  for (const sign of String(words)) advance += (letters[sign] ?? letters[''])[0];
  return (advance * size) / 1000;
}

/**
 * The outline of words that begin at 0, as a path of SVG.
 * @param {string} words
 * @param {number} [weight]
 * @returns {string} in 1/1000 of the size
 */
export function outlineOf(words, weight = 400) {
  const letters = lettersOf(weight);
  let advance = 0,
    path = '';
  for (const sign of String(words)) {
    const [width, outline] = letters[sign] ?? letters[''];
    if (outline) path += `M${advance} 0${outline}`;
    advance += width;
  }
  return path;
}

/**
 * Signs that are printed as a box, because the font has no letter for them.
 * @param {string} words
 * @returns {string[]} each once
 */
export const missingFrom = (words) => [...new Set(words)].filter((sign) => !(sign in regular));

/**
 * Where words begin that are aligned at a place.
 * @param {number} width - of the words
 * @param {'left' | 'center' | 'right'} [align]
 * @returns {number} to be subtracted along the line
 */
export const leadOf = (width, align = 'left') => ({ left: 0, center: width / 2, right: width })[align];
