// The '?' of a picture: what it shows, its formula, and the picture as a file.
/** @import { Panel } from '../types.js' */
import { element } from '../draw/elements.js';

/** What the graph of the world shows. */
export const WORLD = {
  name: 'world',
  title: 'World',
  why: [
    'The states and actions of the world; numbers are rewards. The state and the action of this view are highlighted. ' +
      'Click a state to see its timeline.',
    'P(s′, r | s, a)',
  ],
};

/**
 * A picture with a heading for screen readers and the button of its help.
 * @param {Pick<Panel, 'name' | 'title'> & { why: string[] }} panel
 * @param {HTMLElement} picture
 * @param {[string, () => void][]} files - a format each, and what saves the picture in it
 * @returns {HTMLElement}
 */
export function framed({ name, title, why: [words, formula] }, picture, files) {
  const help = element(
    'details',
    { class: 'help' },
    element('summary', { 'aria-label': `what ${title} shows`, title: `what ${title} shows` }, '?'),
    element(
      'div',
      { tabindex: -1 }, // a click on its words leaves it open
      element('p', {}, words),
      element('code', {}, formula),
      element(
        'span',
        { class: 'group' },
        'Save this picture',
        ...files.map(([format, save]) =>
          element(
            'button',
            { type: 'button', class: 'tool', 'aria-label': `save ${title} as ${format}`, onclick: save },
            format,
          ),
        ),
      ),
    ),
  );
  help.onkeydown = (event) => {
    if (event.key !== 'Escape' || !help.open) return;
    help.open = false;
    help.querySelector('summary')?.focus();
  };
  help.addEventListener('focusout', ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && help.contains(relatedTarget))) help.open = false;
  });
  return element('div', { class: `picture of-${name}` }, element('h2', { class: 'unseen' }, title), picture, help);
}
