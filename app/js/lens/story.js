// The line over the pictures: a description of the view, or, in the guided story, the words of its step.
/** @import { Released, Scene, State, Told } from '../types.js' */
import { element } from '../draw/elements.js';

/**
 * What the pictures show, in one sentence.
 * @param {Pick<Scene, 'model' | 'state' | 'seen'>} scene
 * @returns {string}
 */
export function aboutWords({ model, state, seen }) {
  const { header, simulated } = model,
    action = header.actions[state.action],
    place = header.state ? ` in ${header.state}` : ' in this observation',
    outlined = seen.truth
      ? ' White boxes are the truth.'
      : simulated?.action === state.action
        ? ` White boxes are ${simulated.count} simulated continuations.`
        : '';
  return (
    `Tau-space of ${action}${place}: how likely each reward (across) is at each future step (up), ` +
    `decoded from values at ${seen.grid.G} discounts.${outlined}`
  );
}

/**
 * The line.
 * @param {(heard: { story: number }) => void} report - called with the step that is wanted; 0 ends the story
 * @returns {{ box: HTMLElement, show: (told: Pick<Told, 'story'>, about: string) => void }}
 */
export function storyline(report) {
  const words = element('p', {}),
    steps = element('nav', { class: 'steps', 'aria-label': 'guided story' }),
    box = element('div', { class: 'about' }, steps, words);
  let shown;
  // A link that a click follows without reloading the page; with Ctrl it opens a new page.
  const linkTo = ({ href, name }, number, current) =>
    element(
      'a',
      {
        href,
        target: '_self',
        'aria-current': current ? 'step' : undefined,
        onclick: (event) => {
          if (event.ctrlKey || event.metaKey || event.shiftKey) return;
          event.preventDefault();
          report({ story: number });
        },
      },
      name,
    );
  return {
    box,
    show({ story }, about) {
      const key = story ? `${story.at} ${story.steps.map(({ href }) => href).join()}` : '';
      if (key !== shown) {
        shown = key;
        box.classList.toggle('told', Boolean(story?.at));
        const [first] = story?.steps ?? [];
        steps.replaceChildren(
          ...(!story
            ? []
            : story.at
              ? [
                  ...story.steps.map((step, i) => linkTo(step, i + 1, i + 1 === story.at)),
                  element(
                    'button',
                    { type: 'button', class: 'tool', onclick: () => report({ story: 0 }) },
                    'end the story',
                  ),
                ]
              : [linkTo({ ...first, name: 'Guided story' }, 1, false)]),
        );
      }
      const text = story?.at ? story.steps[story.at - 1].words : about;
      if (words.textContent !== text) words.textContent = text;
    },
  };
}
