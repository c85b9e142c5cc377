import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SLIDERS } from '../../app/js/lens/controls.js';

test('every key press on a slider moves it: a place leads back to itself', () => {
  const model = { sloped: true, arrays: { places: true }, horizons: [1, 2, 3, 4], dt: 1, K: 4, truth: true };
  for (const [name, , , , made] of SLIDERS) {
    for (const slope of [1, 0.02, 25, 3.3]) {
      const scale = typeof made === 'function' ? made(model, { slope }) : made;
      for (let i = 0; i <= scale.count; i++)
        assert.ok(scale.of(scale.at(i)) === i, `${name}, slope ${slope}, place ${i}`);
    }
  }
});
