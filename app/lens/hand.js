// What a hand does to the pictures themselves: pointing, zooming, turning, and the same by keys. It keeps its marks in
// the scene (hover, band, zoom, camera) and asks for a new drawing.

import { acrossOf, thetaOf } from './columns.js';

export const isSpace = (panel) => Boolean(panel.rows); // of the two that can be zoomed, or drawn as surfaces

const limited = (value, low, high) => Math.min(high, Math.max(low, value));
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export function listen(canvas, panel, scene, draw) {
  const space = isSpace(panel), solid = () => space && scene.state.look === 'surface';

  function point(hover) { // one place in theta, tau and gamma, marked in every picture
    if (JSON.stringify(hover) === JSON.stringify(scene.hover)) return;
    scene.hover = hover;
    draw();
  }

  function turn(across, up) {
    const { camera } = scene;
    scene.camera = { turn: camera.turn + across, tilt: limited(camera.tilt + up, 0.1, 1.5) };
    draw();
  }

  // A rectangle drawn over a space is what both spaces then show of theta, and this one of its rows.
  function zoomed() {
    const { band } = scene, { scale } = canvas, sorted = (a, b) => [Math.min(a, b), Math.max(a, b)];
    scene.band = undefined;
    if (!band) return;
    const [[x, y], [x2, y2]] = [band.from, band.to];
    if (Math.abs(x - x2) > 8) scene.zoom.theta = sorted(scale.toX(x), scale.toX(x2));
    if (Math.abs(y - y2) > 8) scene.zoom[panel.rows] = sorted(scale.toY(y), scale.toY(y2));
    draw();
  }

  function zoomIn() { // to half the range, around the cursor
    const { X, Y, toX, toY, box } = canvas.scale, { hover } = scene, y = hover[panel.rows];
    const middle = [hover.theta === undefined ? box.x + box.w / 2 : X(hover.theta), y === undefined ? box.y + box.h / 2 : Y(y)];
    const half = (at, length, value) => [value(at - length / 4), value(at + length / 4)];
    Object.assign(scene.zoom, { theta: half(middle[0], box.w, toX), [panel.rows]: half(middle[1], -box.h, toY) });
    draw();
  }

  function all() {
    scene.zoom = {};
    draw();
  }

  canvas.onpointermove = (event) => {
    const at = [event.offsetX, event.offsetY];
    if (scene.band) { scene.band.to = at; draw(); }
    if (solid()) {
      if (event.buttons) turn(event.movementX * 0.01, event.movementY * 0.01);
      return;
    }
    const { scale } = canvas, { box } = scale, [x, y] = at;
    const within = x >= box.x && x <= box.x + box.w && y >= box.y - 2 && y <= box.y + box.h + 2;
    point(within ? panel.point(scene, scale.toX(x), scale.toY(y)) : {});
  };
  canvas.onpointerleave = () => point({});
  canvas.onkeydown = (event) => {
    if (event.key === 'Escape') { all(); point({}); }
    if (event.key === '+' && space) zoomIn();
    if (!KEYS[event.key]) return;
    event.preventDefault();
    const { hover, seen, model } = scene, [across, up] = KEYS[event.key], far = event.shiftKey ? 10 : 1;
    if (solid()) { turn(0.1 * across, 0.1 * up); return; }
    const stepped = (name, by, count) => limited((hover[name] ?? -1) + by * far, 0, count - 1);
    if (!space) { point({ tau: stepped('tau', across || up, model.K) }); return; }
    const from = hover.theta === undefined ? seen.H / 2 : acrossOf(seen, hover.theta);
    const count = panel.rows === 'tau' ? model.K : seen.grid.G;
    point({ theta: thetaOf(seen, limited(from + across * far, 0, seen.H)), [panel.rows]: stepped(panel.rows, up, count) });
  };
  if (!space) return;
  canvas.title = 'Drag to zoom or to turn, double-click for all of it';
  canvas.onpointerdown = (event) => {
    if (event.pointerType !== 'mouse' && !solid()) return;
    canvas.setPointerCapture(event.pointerId);
    const at = [event.offsetX, event.offsetY];
    if (!solid()) scene.band = { panel, from: at, to: at };
  };
  canvas.onpointerup = zoomed;
  canvas.ondblclick = all;
}
