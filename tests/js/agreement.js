// The lens compared with arrays of the library (tests/support/lens_agreement.py writes them). Knows neither page nor runner, so
// that node and a browser compare in the same way.
import { gammaSpace, kernel, resolution, see } from '../../app/js/core/maths.js';
import { bandsOf } from '../../app/js/core/reading.js';
import { read } from '../../app/js/core/model.js';
import { distances, simulatedFor } from '../../app/js/lens/simulated.js';

/**
 * Bytes of a text in base64.
 * @param {string} text
 * @returns {Uint8Array}
 */
export const bytesOf = (text) => Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));

/**
 * Doubles of a text in base64.
 * @param {string} text
 * @returns {Float64Array}
 */
export const doublesOf = (text) => new Float64Array(bytesOf(text).buffer);

// Everything that the lens shows of a state, by the library's names; of arrays of arrays one after the other.
function shownBy(model, state, tau) {
  const seen = see(model, state),
    bands = bandsOf(model, state, seen),
    flat = (lines) => lines.flatMap((line) => Array.from(line));
  return {
    seen,
    arrays: {
      tau_space: seen.tau,
      survival: flat(seen.survival),
      expected_reward: flat(seen.rewards),
      horizon_values: flat(seen.values),
      discount_kernel: kernel(model, state, seen).actual,
      averaging_kernel: resolution(model, state, seen, tau).kernel,
      differences: gammaSpace(seen, state),
      ...(bands ? { reward_noise: bands.noise } : {}),
      ...(simulatedFor({ model, state }) ? { distance: distances(model, seen) } : {}),
    },
  };
}

/**
 * How far the lens is off from the library.
 * @param {{ payloads: Record<string, string>, cases: object[] }} fixture - as `fixture` of tests/support/lens_agreement.py
 *   makes it
 * @returns {{ off: Record<string, number>, problems: string[], leftOut: number, entries: number }} `off`: the largest
 *   difference of every array as a share of its range; `problems`: what is of another kind, row, length or choice;
 *   `leftOut` of `entries` numbers are rounding in the library itself.
 */
export function compared({ payloads, cases }) {
  const models = Object.fromEntries(Object.entries(payloads).map(([name, text]) => [name, read(bytesOf(text))]));
  const off = {},
    problems = [];
  let leftOut = 0,
    entries = 0;
  cases.forEach(({ payload, state, tau, expected }, number) => {
    const wrong = (words) => problems.push(`case ${number} (${payload}): ${words}`),
      { seen, arrays } = shownBy(models[payload], state, tau);
    if (seen.readRow !== expected.read_row) wrong(`row ${seen.readRow}, not ${expected.read_row}`);
    if (expected.chosen !== null && seen.chosen !== expected.chosen) wrong(`${seen.chosen}, not ${expected.chosen}`);
    if (expected.regret !== null && !(Math.abs(seen.regret - expected.regret) <= 1e-9 * Math.abs(expected.regret)))
      wrong(`regret ${seen.regret}, not ${expected.regret}`);
    const names = [Object.keys(arrays), Object.keys(expected.arrays)].map((each) => each.sort().join());
    if (names[0] !== names[1]) wrong(`${names[0]}, not ${names[1]}`);
    for (const [name, { values, holds, width }] of Object.entries(expected.arrays)) {
      const wanted = doublesOf(values),
        counts = doublesOf(holds),
        got = arrays[name] ?? [];
      if (got.length !== wanted.length) {
        wrong(`${name} has ${got.length} numbers, not ${wanted.length}`);
        continue;
      }
      wanted.forEach((value, i) => {
        if (!Number.isFinite(value)) return; // the library shows nothing there
        entries++;
        if (!counts[i]) {
          leftOut++;
          return;
        }
        const share = Math.abs(got[i] - value) / width;
        off[name] = Math.max(off[name] ?? 0, Number.isNaN(share) ? Infinity : share);
      });
    }
  });
  return { off, problems, leftOut, entries };
}
