// Colours as they are seen: by most people, without the green cones (deuteranopia), without the red ones (protanopia), and
// printed in grey. The formulas are those of the standards, and share nothing with what draws.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { actionColour, heatColour } from '../../app/js/draw/drawing.js';
import { markOf } from '../../app/js/draw/frame.js';

// sRGB (IEC 61966-2-1) as light: the gamma curve undone.
const light = (colour) => {
  const channels = colour.startsWith('#')
    ? [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16))
    : colour.match(/\d+/g).map(Number);
  return channels.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
};
const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, each, i) => sum + each * vector[i], 0));
const XYZ = [
  [0.4124564, 0.3575761, 0.1804375],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339, 0.119192, 0.9503041],
];

// CIELAB (CIE 1976) under the white of sRGB.
function lab(rgb) {
  const white = times(XYZ, [1, 1, 1]),
    [x, y, z] = times(XYZ, rgb).map((value, i) => {
      const t = value / white[i];
      return t > (6 / 29) ** 3 ? Math.cbrt(t) : t / (3 * (6 / 29) ** 2) + 4 / 29;
    });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const inverse = ([[a, b, c], [d, e, f], [g, h, i]]) => {
  const over = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return [
    [e * i - f * h, c * h - b * i, b * f - c * e],
    [f * g - d * i, a * i - c * g, c * d - a * f],
    [d * h - e * g, b * g - a * h, a * e - b * d],
  ].map((row) => row.map((each) => each / over));
};

// Vienot, Brettel and Mollon (1999): light is what the three cones take in (Smith and Pokorny 1975). The kind that lacks
// is replaced by the mixture of the other two that leaves white and the blue of the screen as they are:
// missing = p other + q short for both, two equations for p and q.
function without(missing) {
  const CONES = [
      [0.15514, 0.54312, -0.03286],
      [-0.15514, 0.45684, 0.03286],
      [0, 0, 0.01608],
    ],
    other = 1 - missing,
    toCones = (rgb) => times(CONES, times(XYZ, rgb)),
    [white, blue] = [toCones([1, 1, 1]), toCones([0, 0, 1])],
    over = white[other] * blue[2] - white[2] * blue[other],
    p = (white[missing] * blue[2] - white[2] * blue[missing]) / over,
    q = (white[other] * blue[missing] - white[missing] * blue[other]) / over;
  return (rgb) => {
    const cones = toCones(rgb);
    cones[missing] = p * cones[other] + q * cones[2];
    return times(inverse(XYZ), times(inverse(CONES), cones)).map((value) => Math.min(1, Math.max(0, value)));
  };
}

// Machado, Oliveira and Fernandes (2009), complete deuteranomaly: another model of the same eyes.
const machado = (rgb) =>
  times(
    [
      [0.367322, 0.860646, -0.227968],
      [0.280085, 0.672501, 0.047413],
      [-0.01182, 0.04294, 0.968881],
    ],
    rgb,
  ).map((value) => Math.min(1, Math.max(0, value)));

const EYES = { most: (rgb) => rgb, deuteranopia: without(1), 'deuteranopia, Machado': machado, protanopia: without(0) };
const grey = (rgb) => Array(3).fill(times(XYZ, rgb)[1]);
const seen = (colour, eye) => lab(eye(light(colour)));
const apart = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
const least = (list) => list.reduce((a, b) => Math.min(a, b));

const POSITIVE = Array.from({ length: 401 }, (_, i) => heatColour(i / 400, 1)),
  NEGATIVE = Array.from({ length: 100 }, (_, i) => heatColour((-0.25 * (i + 1)) / 100, 1));

test('the models of eyes leave white and grey alone, and take red for green', () => {
  for (const eye of Object.values(EYES))
    for (const colour of ['#ffffff', '#808080'])
      assert.ok(apart(seen(colour, eye), lab(light(colour))) < 1.5, `${colour} is seen as ${seen(colour, eye)}`);
  const [red, green] = ['#c00000', '#6b7000'];
  assert.ok(apart(seen(red, EYES.most), seen(green, EYES.most)) > 50);
  assert.ok(apart(seen(red, EYES.deuteranopia), seen(green, EYES.deuteranopia)) < 30);
});

test('from zero to the top the heat map only becomes lighter, to all eyes and in grey', () => {
  for (const [name, eye] of [...Object.entries(EYES), ['grey', grey]]) {
    const found = POSITIVE.map((colour) => seen(colour, eye)[0]);
    found.slice(1).forEach((value, i) => assert.ok(value >= found[i] - 0.3, `${name}: ${found[i]} to ${value}`));
    assert.ok(found.at(-1) - found[0] > 65, `${name}: from ${found[0]} to ${found.at(-1)}`);
  }
});

test('nothing below zero resembles the top, to all eyes and in grey', () => {
  const wanted = { most: 130, deuteranopia: 100, 'deuteranopia, Machado': 100, protanopia: 100, grey: 30 };
  for (const [name, eye] of [...Object.entries(EYES), ['grey', grey]]) {
    const top = seen(heatColour(1, 1), eye),
      found = least(NEGATIVE.map((colour) => apart(seen(colour, eye), top)));
    assert.ok(found >= wanted[name], `${name}: ${found.toFixed(1)}`);
  }
});

test('what is far below zero resembles nothing above it', () => {
  for (const [name, eye] of Object.entries(EYES)) {
    const above = POSITIVE.map((colour) => seen(colour, eye)),
      found = least(NEGATIVE.slice(60).map((colour) => least(above.map((other) => apart(seen(colour, eye), other)))));
    assert.ok(found >= 15, `${name}: ${found.toFixed(1)}`);
  }
});

test('two actions differ in the mark of their line, or in their colour to all eyes', () => {
  const markOfAction = (a) => JSON.stringify(markOf(a, 0, 0, 3));
  for (let a = 0; a < 8; a++)
    for (let b = 0; b < a; b++) {
      const found = least(
        Object.values(EYES).map((eye) => apart(seen(actionColour(a), eye), seen(actionColour(b), eye))),
      );
      assert.ok(found >= 20 || markOfAction(a) !== markOfAction(b), `actions ${a} and ${b}: ${found.toFixed(1)}`);
    }
});
