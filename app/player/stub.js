// Loads the player, a file of its own, and hands every message on to it, in order.
globalThis.laplacePlayer ??= import(new URL('__ADDRESS__', document.baseURI).href);

export default function (component) {
  globalThis.laplacePlayer.then((player) => player.default(component)).catch((error) => {
    component.parentElement.textContent = `The player could not be loaded: ${error.message}. Reload the page.`;
  });
}
