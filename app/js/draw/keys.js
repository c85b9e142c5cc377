// Keys that hold for the whole page.

// What a person types in has an undo of its own.
const TYPED = 'input:not([type=range], [type=checkbox], [type=radio], [type=button]), textarea, [contenteditable]';

/**
 * Calls back on Ctrl+Z and Ctrl+Shift+Z (or with the command key) as long as an element is on the page, but not while a
 * person types or a dialog is open.
 * @param {HTMLElement} host
 * @param {(way: 'undo' | 'redo') => void} does
 * @returns {void}
 */
export function onUndo(host, does) {
  const heard = (event) => {
    if (!host.isConnected) {
      document.removeEventListener('keydown', heard);
      return;
    }
    const { key, target } = event;
    if (!(event.ctrlKey || event.metaKey) || event.altKey || key.toLowerCase() !== 'z') return;
    if (target instanceof Element && target.closest(TYPED)) return;
    if (document.querySelector('dialog[open], [role=dialog]')) return;
    event.preventDefault();
    does(event.shiftKey ? 'redo' : 'undo');
  };
  document.addEventListener('keydown', heard);
}
