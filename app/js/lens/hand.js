// What a hand does to the pictures themselves: pointing, zooming, turning, and the same by keys. It keeps its marks in
// the scene (hover, band, zoom, camera) and asks for a new drawing.
/** @import { Panel, Scene } from '../types.js' */

import { acrossOf, thetaOf } from '../draw/columns.js';

/**
 * Whether a picture is one of the two that can be zoomed, or drawn as surfaces.
 * @param {Panel} panel
 * @returns {boolean}
 */
export const isSpace = (panel) => Boolean(panel.rows); // of the two that can be zoomed, or drawn as surfaces

const limited = (value, low, high) => Math.min(high, Math.max(low, value));
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * Handles pointer and keyboard input on a picture.
 * @param {HTMLCanvasElement} canvas
 * @param {Panel} panel
 * @param {Scene} scene
 * @param {() => void} draw - asks for a new drawing
 * @returns {void}
 */
export function listen(canvas, panel, scene, draw) {
  const space = isSpace(panel),
    solid = () => space && scene.state.look === 'surface';

  function point(hover) {
    // one place in theta, tau and gamma, marked in every picture
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
    const { band } = scene;
    scene.band = undefined;
    if (band) show([band.from[0], band.to[0]], [band.from[1], band.to[1]]);
  }

  // What lies between two places of the picture, in pixels, as far as there is something; nothing if they are too
  // close.
  function show(across, up) {
    const { scale } = canvas,
      { seen, model } = scene,
      { thetas, H } = seen,
      least = 8;
    if (!scale || !panel.rows) return; // not drawn yet
    const rows = panel.rows === 'tau' ? model.K : seen.grid.G,
      sorted = (a, b) => [Math.min(a, b), Math.max(a, b)];
    const within = (ends, low, high) => sorted(...ends.map((end) => limited(end, low, high)));
    const theta = within(across.map(scale.toX), thetas[0], thetas[H]),
      row = within(up.map(scale.toY), -0.5, rows - 0.5);
    if (Math.abs(across[0] - across[1]) > least && theta[1] > theta[0]) scene.zoom.theta = theta;
    if (Math.abs(up[0] - up[1]) > least && row[1] > row[0]) scene.zoom[panel.rows] = row;
    draw();
  }

  function zoomBy(factor) {
    // around the cursor
    if (!canvas.scale || !panel.rows) return; // not drawn yet
    const { X, Y, box } = canvas.scale,
      { hover } = scene,
      row = hover[panel.rows];
    const place = (at, from, length) => [at - factor * (at - from), at + factor * (from + length - at)];
    show(
      place(hover.theta === undefined ? box.x + box.w / 2 : X(hover.theta), box.x, box.w),
      place(row === undefined ? box.y + box.h / 2 : Y(row), box.y, box.h),
    );
  }

  function all() {
    scene.zoom = {};
    draw();
  }

  canvas.onpointermove = (event) => {
    const at = [event.offsetX, event.offsetY];
    if (scene.band) {
      scene.band.to = at;
      draw();
    }
    if (solid()) {
      if (event.buttons) turn(event.movementX * 0.01, event.movementY * 0.01);
      return;
    }
    const { scale } = canvas,
      [x, y] = at;
    if (!scale) return; // not drawn yet
    const { box } = scale;
    const within = x >= box.x && x <= box.x + box.w && y >= box.y - 2 && y <= box.y + box.h + 2;
    point(within ? panel.point(scene, scale.toX(x), scale.toY(y)) : {});
  };
  canvas.onpointerleave = () => point({});
  canvas.onkeydown = (event) => {
    if (event.key === 'Escape' && scene.band) {
      scene.band = undefined;
      draw();
    } // a drag that was not meant
    else if (event.key === 'Escape') {
      all();
      point({});
    }
    if (event.key === '+' && space && !solid()) zoomBy(0.5);
    if (event.key === '-' && space && !solid()) zoomBy(2);
    if (!KEYS[event.key]) return;
    event.preventDefault();
    const { hover, seen, model } = scene,
      [across, up] = KEYS[event.key],
      far = event.shiftKey ? 10 : 1;
    if (solid()) {
      turn(0.1 * across, 0.1 * up);
      return;
    }
    const stepped = (name, by, count) => limited((hover[name] ?? -1) + by * far, 0, count - 1);
    if (!panel.rows) {
      point({ tau: stepped('tau', across || up, model.K) });
      return;
    }
    const from = hover.theta === undefined ? seen.H / 2 : acrossOf(seen, hover.theta);
    const count = panel.rows === 'tau' ? model.K : seen.grid.G;
    point({
      theta: thetaOf(seen, limited(from + across * far, 0, seen.H)),
      [panel.rows]: stepped(panel.rows, up, count),
    });
  };
  if (!space) return;
  canvas.title = 'Drag to zoom or to turn, double-click for all of it; with the keyboard arrows, + and -';
  canvas.onpointerdown = (event) => {
    if (event.pointerType !== 'mouse' && !solid()) return;
    canvas.setPointerCapture(event.pointerId);
    const at = [event.offsetX, event.offsetY];
    if (!solid()) scene.band = { panel, from: at, to: at };
  };
  canvas.onpointerup = zoomed;
  canvas.ondblclick = all;
}
