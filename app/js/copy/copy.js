// A button that copies a text and says so.
/** @import { Message } from '../types.js' */

/**
 * Shows a message of Streamlit.
 * @param {Message} message
 * @returns {void}
 */
export default function ({ data, parentElement }) {
  let button = parentElement.querySelector('button');
  if (!button) {
    button = document.createElement('button');
    button.className = 'laplace-copy';
    parentElement.append(button);
  }
  button.textContent = data.label;
  button.title = data.text;
  button.onclick = () =>
    navigator.clipboard
      .writeText(data.text)
      .then(
        () => {
          button.textContent = 'Copied';
        },
        () => {
          window.prompt('Copy this:', data.text);
        },
      )
      .finally(() =>
        setTimeout(() => {
          button.textContent = data.label;
        }, 1500),
      );
}
