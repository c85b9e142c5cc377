// Loads the race track, a file of its own, and hands every message on to it, in order.
globalThis.laplaceTrack ??= import(new URL('__ADDRESS__', document.baseURI).href);

export default function (component) {
  globalThis.laplaceTrack.then((track) => track.default(component)).catch((error) => {
    component.parentElement.textContent = `The race could not be loaded: ${error.message}. Reload the page.`;
  });
}
