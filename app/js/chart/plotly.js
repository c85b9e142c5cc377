// One load of plotly.js for all charts of a page, as an ordinary script: a browser keeps the compiled code of those.
/** @type {Promise<any> | undefined} */
let loading;

/**
 * Loads plotly.js once.
 * @param {string} address
 * @returns {Promise<any>}
 */
export function loadPlotly(address) {
  loading ??= new Promise((done, fail) => {
    const script = document.createElement('script');
    script.src = new URL(address, document.baseURI).href;
    script.onload = () => done(globalThis.Plotly);
    script.onerror = () => fail(new Error(`${script.src} is not served`));
    document.head.append(script);
  });
  return loading;
}

/**
 * The promise of plotly.js, once something has asked for it.
 * @returns {Promise<any>}
 */
export const plotly = () => loading ?? Promise.reject(new Error('plotly.js was not asked for'));
