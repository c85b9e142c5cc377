// The first stop of the Tab key: a link past the sidebar and all controls to the picture of the page.

// What a page is about, the most important first. A page without a picture has its heading.
const PICTURES = [
  '.laplace-lens .hero canvas',
  '.laplace-inverse canvas',
  '.laplace-track canvas',
  '.laplace-chart',
  'h1',
  '[data-testid="stMainBlockContainer"]',
];

function skip(event) {
  event.preventDefault(); // the address is a link to the view, and stays as it is
  const main = document.querySelector('[data-testid="stMain"]') ?? document;
  const found = PICTURES.map((each) => main.querySelector(each)).find(Boolean);
  if (!(found instanceof HTMLElement)) return;
  if (found.tabIndex < 0) found.tabIndex = -1; // it can have the focus, and is no stop of its own
  found.focus({ preventScroll: true });
  found.scrollIntoView({ block: 'nearest' });
}

/**
 * Puts the link before everything else on the page, or gives it other words.
 * @param {string} words
 * @returns {void}
 */
export function skipLink(words) {
  const there = document.querySelector('.laplace-skip'),
    link = /** @type {HTMLAnchorElement} */ (there ?? document.createElement('a'));
  link.textContent = words;
  if (there) return;
  Object.assign(link, { className: 'laplace-skip', href: '#picture', onclick: skip });
  document.body.prepend(link);
}
