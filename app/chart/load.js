// One load of plotly.js for all charts, as an ordinary script: a browser keeps the compiled code of those.
window.laplacePlotly ??= new Promise((done, fail) => {
  const script = document.createElement('script');
  script.src = '__ADDRESS__';
  script.onload = () => done(window.Plotly);
  script.onerror = () => fail(new Error(`${script.src} is not served`));
  document.head.append(script);
});
