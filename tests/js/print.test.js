import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import opentype from 'opentype.js';
import { see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { inkOf } from '../../app/js/draw/colours.js';
import { captionOf } from '../../app/js/print/caption.js';
import { pdfOf } from '../../app/js/print/document.js';
import * as glyphs from '../../app/js/print/glyphs.js';
import { captionLines, layoutOf, shifted, typeset, wrapped } from '../../app/js/print/layout.js';
import { missingFrom, outlineOf, widthOf } from '../../app/js/print/letters.js';
import { crcOf, densityOf, drawSheet, outlinedPen, sheetOf, svgOf, withDensity } from '../../app/js/print/sheet.js';
import * as libraries from '../../app/offline/pdf.js';
import { bytesOf } from './agreement.js';
import { fixture } from './fixtures.js';

const near = (got, wanted, off = 1e-3) => assert.ok(Math.abs(got - wanted) <= off, `${got}, not ${wanted}`);

test('one panel fills a column of 85 mm', () => {
  // 85 mm = 85 / 25.4 inch = 321.260 px; less 4 px at each edge 313.260; height 0.66 of that.
  const { width, height, cells, caption } = layoutOf(1, 85, 2);
  near(width, 321.26);
  near(cells[0].x, 4);
  near(cells[0].w, 313.26);
  near(cells[0].h, 206.752);
  // The first line of the caption: 4 + 206.752, 10 px of room and 10 px of letters; another line 13.5 px below; then
  // 3 px for letters that reach below the line, and the edge.
  near(caption, 230.752);
  near(height, 230.752 + 13.5 + 3 + 4);
});

test('an odd panel stands in the middle of the last row of 180 mm', () => {
  // 680.315 px less 8 px are 672.315; two columns with 14 px between them have 329.157 px each, 0.66 of which is
  // 217.244 px; the third panel begins 4 + (672.315 - 329.157) / 2 = 175.579 px from the left, one row down.
  const { cells } = layoutOf(3, 180, 1);
  near(cells[1].x, 4 + 329.157 + 14);
  near(cells[2].x, 175.579);
  near(cells[2].y, 4 + 217.244 + 14);
});

test('no two panels overlap, none leaves the sheet, and every row is filled or centred', () => {
  for (const mm of [85, 180])
    for (let count = 1; count <= 9; count++) {
      const { width, height, cells, caption } = layoutOf(count, mm, 3),
        rows = Map.groupBy(cells, ({ y }) => y);
      assert.equal(cells.length, count);
      for (const [i, a] of cells.entries()) {
        assert.ok(a.x >= 0 && a.x + a.w <= width + 1e-9 && a.y + a.h < caption && caption < height, `${mm}, ${count}`);
        for (const b of cells.slice(i + 1))
          assert.ok(a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y, `${mm}, ${count}`);
      }
      for (const row of rows.values())
        near(Math.min(...row.map(({ x }) => x)), width - Math.max(...row.map(({ x, w }) => x + w)));
    }
});

test('a caption is wrapped into lines that fit, and loses nothing', () => {
  const words = 'one two three seventeen-and-a-very-long-name four',
    lines = wrapped(words, 10, (line) => line.length);
  assert.ok(lines.every((line) => line.length <= 10 && line));
  assert.equal(lines.join('').replaceAll(' ', ''), words.replaceAll(' ', ''));
  for (const line of captionLines('World two_branch, α = 0.1, T = 3 steps. '.repeat(9), 85, widthOf))
    assert.ok(widthOf(line, 10) <= 321.26 - 8);
});

// The edges of an outline, each with both of its ends, in no order: readers of fonts begin a contour where they like.
function edgesOf(commands) {
  const edges = [];
  let at = [0, 0],
    start = at;
  const edge = (...numbers) => {
    const end = numbers.slice(-2);
    if (numbers.length > 2 || end.some((value, i) => value !== at[i])) edges.push([...at, ...numbers].join(' '));
    at = end;
  };
  for (const [command, ...numbers] of [...commands, ['m', 0, 0]]) {
    if (command === 'm') {
      edge(...start);
      start = at = numbers;
    } else if (command !== 'z') edge(...numbers);
  }
  return edges.sort();
}

// A relative path of one letter in absolute places.
function absolute(path) {
  let at = [0, 0],
    start = at;
  return [...path.matchAll(/([mlqz])([^mlqz]*)/g)].map(([, command, text]) => {
    const numbers = (text.match(/-?[\d.]+/g) ?? []).map((value, i) => Number(value) + at[i % 2]);
    at = command === 'z' ? start : numbers.slice(-2);
    if (command === 'm') start = at;
    return [command, ...numbers];
  });
}

test('the letters that an SVG draws are those that a PDF embeds', () => {
  for (const weight of ['regular', 'bold']) {
    const font = opentype.parse(new Uint8Array(readFileSync(`app/js/print/fonts/${weight}.ttf`)).buffer),
      signs = Object.keys(glyphs[weight]).filter(Boolean);
    assert.ok(signs.length > 500);
    for (const sign of signs) {
      const [advance, path] = glyphs[weight][sign],
        glyph = font.charToGlyph(sign);
      const read = glyph
        .getPath(0, 0, 1000)
        .commands.map(({ type, x1, y1, x, y }) => [
          type.toLowerCase(),
          ...[x1, y1, x, y].filter((value) => value !== undefined),
        ]);
      assert.equal(advance, glyph.advanceWidth, sign);
      assert.deepEqual(edgesOf(absolute(path)), edgesOf(read), sign);
    }
  }
});

test('every sign of the code has a letter, and what has none is named and printed as a box', () => {
  assert.deepEqual(missingFrom('αγθτ ΔΣ ± − – × · ² ½ ≤ ≥ ≈ → ∞ √ … “é” Łódź Жук'), []);
  assert.deepEqual(missingFrom('世界 世'), ['世', '界']);
  assert.equal(outlineOf('世'), `M0 0${glyphs.regular[''][1]}`);
});

test('words are outlines that begin where their alignment says', () => {
  // 'T' and 'T' again: the second begins at the advance of the first.
  const [advance, path] = glyphs.regular.T;
  assert.equal(outlineOf('TT'), `M0 0${path}M${advance} 0${path}`);
  near(widthOf('TT', 10), (2 * advance) / 100);
  const pen = outlinedPen(),
    lead = advance / 100;
  pen.text('T', 100, 20, { size: 10, align: 'right', colour: '#000000' });
  pen.text('T', 100, 20, { size: 10, align: 'center', turn: true, colour: '#000000' });
  const places = pen.parts.map((part) => part.match(/transform="([^"]*)"/)[1]);
  assert.equal(places[0], `translate(${+(100 - lead).toFixed(2)} 20) scale(0.01)`);
  assert.equal(places[1], `translate(100 ${+(20 + lead / 2).toFixed(2)}) rotate(-90) scale(0.01)`); // upwards
  assert.match(pen.parts[0], /aria-label="T"/);
});

test('a minus before a number is a minus, and a hyphen in a name stays', () => {
  assert.equal(typeset('two-branch -2 to -0.5 (-1)'), 'two-branch −2 to −0.5 (−1)');
});

test('a pen whose 0 lies elsewhere shifts all that it draws', () => {
  const drawn = [],
    note =
      (name) =>
      (...given) =>
        drawn.push([name, ...given]);
  const pen = shifted(
    { path: note('path'), text: note('text'), image: note('image'), clip: note('clip'), width: () => 0 },
    { x: 10, y: 20 },
  );
  pen.path([[1, 2], null, [3, 4]], {});
  pen.text('a', 1, 2, {});
  pen.image(null, 1, 2, 3, 4);
  pen.clip(1, 2, 3, 4, null);
  assert.deepEqual(drawn, [
    ['path', [[11, 22], null, [13, 24]], {}],
    ['text', 'a', 11, 22, {}],
    ['image', null, 11, 22, 3, 4],
    ['clip', 11, 22, 3, 4, null],
  ]);
});

test('an SVG says its width in mm, knows no rgba() and no <text>', () => {
  const { sheet, lines } = sheetOf(1, 180, 'α = 1 & more'),
    panel = (pen) => {
      pen.path(
        [
          [0, 0],
          [1, 1],
        ],
        { stroke: 'rgba(1,2,3,0.5)' },
      );
      pen.text('<τ>', 1, 1, { colour: '#000000' });
    };
  const svg = svgOf(sheet, (pen) => drawSheet(pen, sheet, [panel], lines), { title: 'a', caption: 'b & c' });
  assert.match(svg, /^<svg [^>]*width="180mm"/);
  assert.match(svg, /stroke="#010203" stroke-opacity="0.5"/);
  assert.match(svg, /aria-label="&lt;τ&gt;"/);
  assert.doesNotMatch(svg, /rgba\(|<text/);
});

test('a PDF is as wide as asked, its lines lie where they should and its letters are embedded', () => {
  const sheet = { width: (85 * 96) / 25.4, height: 192 };
  const draw = (pen) => {
    pen.path([[0, 0], [96, 48], null, [96, 96], [0, 96]], { stroke: '#ff0000', width: 4 });
    pen.text('α', 48, 96, { align: 'left', colour: '#000000' });
    pen.text('τ', 48, 96, { weight: 600, colour: '#000000' });
  };
  const bytes = Buffer.from(pdfOf(libraries, sheet, draw, { title: 'a', caption: 'b' })),
    text = bytes.toString('latin1');
  const [, wide, high] = text.match(/\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/);
  near(+wide, 240.945, 0.01); // 85 / 25.4 * 72 pt
  near(+high, 144, 0.01); // 192 px are 2 inch
  const streams = [...text.matchAll(/stream\r?\n([\s\S]*?)\r?\nendstream/g)].map(([, body]) => {
    try {
      return inflateSync(Buffer.from(body, 'latin1')).toString('latin1');
    } catch {
      return '';
    }
  });
  // A pixel is 0.75 pt, and y is counted from the bottom of 144 pt.
  const page = streams.find((each) => / m\n/.test(each)).replace(/(\d)\.0*(?= )/g, '$1');
  assert.match(page, /\b3 w\n/);
  assert.match(page, /\n0 144 m\n72 108 l\n72 72 m\n0 72 l\nS\n/);
  assert.equal([...text.matchAll(/\/FontFile2 /g)].length, 2);
  assert.doesNotMatch(text, /Helvetica/);
  for (const code of ['03b1', '03c4'])
    // alpha and tau can be copied from it
    assert.ok(
      streams.some((each) => each.includes('beginbfchar') && each.toLowerCase().includes(`<${code}>`)),
      code,
    );
});

test('a caption names every setting', () => {
  const given = fixture('table'),
    model = read(bytesOf(given.payload)),
    { state } = given;
  const caption = (change, names = ['tau-space', 'values'], header = model.header) => {
    const changed = { ...state, ...change };
    return captionOf({ model: { ...model, header }, state: changed, seen: see(model, changed) }, names);
  };
  const words = caption({ alpha: 0.2, horizon: 3, slope: 25, normalise: 'paper', action: 0 });
  const wanted = ['World two_branch', 'state start', 'action short', 'α = 0.2', 'Tikhonov', 'T = 3 steps'];
  for (const each of [...wanted, 'slope 25 / reward', 'discounts γ from', 'sensitivities θ from', 'Rows rescaled'])
    assert.ok(words.includes(each), `${each} is not in: ${words}`);
  assert.ok(caption({ normalise: 'none' }).includes('Rows as decoded'));
  assert.ok(caption({ fold: true }).includes('Switched on: only T rows'));
  assert.ok(!caption({ fold: false }).includes('Switched on'));
  assert.ok(words.includes('White outline: true timeline'));
  assert.ok(caption({ look: 'surface' }).includes('Orange line: true timeline'));
  assert.ok(!caption({}, ['kernel']).includes('White outline'));
  const feasible = caption({}, ['tau-space'], { ...model.header, solver: 'feasible' });
  assert.ok(feasible.includes('solver feasible') && !feasible.includes('Tikhonov'), feasible);
});

test('colours are taken apart for writers that know no CSS', () => {
  assert.deepEqual(inkOf('rgba(11,114,133,0.16)'), { hex: '#0b7285', alpha: 0.16 });
  assert.deepEqual(inkOf('rgb(0,255,9)'), { hex: '#00ff09', alpha: 1 });
  assert.deepEqual(inkOf('#111'), { hex: '#111111', alpha: 1 });
  assert.throws(() => inkOf('hsl(1 2% 3%)'), /no colour that can be printed/);
});

test('a PNG knows its size on paper', () => {
  assert.equal(crcOf(new TextEncoder().encode('123456789')), 0xcbf43926); // the check value of CRC-32
  const png = Uint8Array.from({ length: 40 }, (_, i) => i),
    out = withDensity(png, 300),
    view = new DataView(out.buffer);
  assert.deepEqual([...out.subarray(0, 33), ...out.subarray(54)], [...png]);
  assert.equal(view.getUint32(33), 9);
  assert.equal(String.fromCharCode(...out.subarray(37, 41)), 'pHYs');
  assert.equal(view.getUint32(41), 11811); // 300 / 0.0254 to the metre
  assert.equal(out[49], 1);
  assert.equal(view.getUint32(50), crcOf(out.subarray(37, 50)));
  // 600 dots to the inch where a sheet has no more than 16 million: 85 mm are 2008, which leaves room for 7968.
  assert.equal(densityOf({ width: 321.26, height: 1274 }), 600);
  assert.equal(densityOf({ width: 321.26, height: 1276 }), 300);
});
