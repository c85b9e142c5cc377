import assert from 'node:assert/strict';
import { test } from 'node:test';
import { acrossOf, columnAt, placeOf, rewardWords, thetaOf, thetaTicks } from '../../app/js/draw/columns.js';
import { escaped, heatIndex, rounded, rowTicks, short, svgPen, ticks } from '../../app/js/draw/drawing.js';

const near = (got, wanted) => {
  assert.equal(got.length, wanted.length, `${got}, not ${wanted}`);
  got.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-9, `${got}, not ${wanted}`));
};

test('ticks are round numbers inside the range', () => {
  near(ticks(0, 10), [0, 2, 4, 6, 8, 10]);
  near(ticks(-0.3, 1.1), [0, 0.5, 1]);
  near(ticks(14, 33, 4), [15, 20, 25, 30]);
  near(ticks(0, 0.001, 4), [0, 0.0005, 0.001]);
});

test('a rounded range holds the values and ends at round numbers', () => {
  near(rounded(0.3, 9.2), [0, 10]);
  near(rounded(-1.2, 4.9), [-2, 6]);
  const [low, high] = rounded(5, 5);
  assert.ok(low < 5 && high > 5);
});

test('a short number has three digits, no negative zero, and says where there is none', () => {
  assert.equal(short(3.14159), '3.14');
  assert.equal(short(1234), '1230');
  assert.equal(short(1234, 4), '1234');
  assert.equal(short(-0), '0');
  assert.equal(short(0.0000123), '1.23e-5');
  assert.equal(short(NaN), '–');
  assert.equal(short(-Infinity), '–');
});

test('labels of rows are evenly spaced and inside the range', () => {
  const labels = Float64Array.from({ length: 40 }, (_, k) => k / 2);
  assert.deepEqual(rowTicks(labels, [-0.5, 39.5]).slice(0, 3), [
    [0, '0'],
    [5, '2.5'],
    [10, '5'],
  ]);
  assert.ok(rowTicks(labels, [10, 20]).every(([row]) => row >= 10 && row <= 20));
});

const uneven = { thetas: Float64Array.of(-100, -1, 0, 1, 100), H: 4, open: false };

test('columns are equally wide, whatever they stand for, and the way back is the way', () => {
  assert.deepEqual(
    [-100, -1, -0.5, 0, 99].map((theta) => columnAt(uneven, theta)),
    [0, 1, 1, 2, 3],
  );
  near([acrossOf(uneven, -100), acrossOf(uneven, -0.5), acrossOf(uneven, 100)], [0, 1.5, 4]);
  const thetas = [-60, -0.2, 0, 0.7, 55];
  near(
    thetas.map((theta) => thetaOf(uneven, acrossOf(uneven, theta))),
    thetas,
  );
});

test('labels of columns stand apart and have their place', () => {
  const found = thetaTicks(uneven, [-100, 100], 400);
  assert.ok(found.includes(0));
  const places = found.map((theta) => 100 * acrossOf(uneven, theta)).sort((a, b) => a - b);
  places.slice(1).forEach((place, i) => assert.ok(place - places[i] >= 34));
  near(thetaTicks({ thetas: Float64Array.of(0, 1, 2, 3, 4), H: 4, open: false }, [0, 4], 300), [0, 1, 2, 3, 4]);
});

test('an open end has one edge only', () => {
  const open = { thetas: Float64Array.of(-2, -1, 0, 1, 2), H: 4, open: true };
  assert.equal(rewardWords(open, -1.5), 'below -1');
  assert.equal(rewardWords(open, 1.5), 'above 1');
  assert.equal(rewardWords(open, 0.5), '0.5');
  assert.deepEqual(
    [-70, 70, 0.5].map((reward) => placeOf(open, reward)),
    [-1.5, 1.5, 0.5],
  );
});

test('colours stay on their scale', () => {
  assert.equal(heatIndex(-9, 1), 0);
  assert.equal(heatIndex(9, 1), 511);
  assert.equal(heatIndex(0, 1), Math.round((0.25 / 1.25) * 511));
});

test('a pen for SVG breaks a path where there is no point, and escapes words', () => {
  const pen = svgPen('serif', () => 0);
  pen.path([[0, 0], [1, 2.345], null, [3, 4]], { stroke: '#000' });
  assert.match(pen.parts[0], /d="M0 0L1 2.35M3 4"|d="M0 0L1 2.34M3 4"/);
  pen.text('<b> & "c"', 1, 2, { colour: '#000' });
  assert.match(pen.parts[1], /&lt;b&gt; &amp; &quot;c&quot;/);
  assert.equal(escaped('a<b'), 'a&lt;b');
});
