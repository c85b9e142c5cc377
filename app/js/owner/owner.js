// The word by which the server knows this browser again, kept as a cookie of a year.
/** @import { Message } from '../types.js' */

/**
 * Shows a message of Streamlit.
 * @param {Message} message
 * @returns {void}
 */
export default function ({ data, setTriggerValue }) {
  const start = `${data.name}=`,
    kept = document.cookie
      .split('; ')
      .find((each) => each.startsWith(start))
      ?.slice(start.length);
  if (kept && kept !== data.word) {
    setTriggerValue('word', kept); // of a tab that was opened at the same time
    return;
  }
  const path = new URL('.', document.baseURI).pathname; // other programs of the same site need not see it
  const secure = location.protocol === 'https:' ? '; Secure' : '';
  document.cookie = `${start}${data.word}; Path=${path}; Max-Age=31536000; SameSite=Strict${secure}`;
}
