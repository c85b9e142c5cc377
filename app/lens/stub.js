// Loads the lens, a file of its own, and hands every message on to it, in order.
globalThis.laplaceLens ??= import(new URL('__ADDRESS__', document.baseURI).href);

export default function (component) {
  globalThis.laplaceLens.then((lens) => lens.default(component)).catch((error) => {
    component.parentElement.textContent = `The lens could not be loaded: ${error.message}. Reload the page.`;
  });
}
