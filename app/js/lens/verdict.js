// The sentence over the pictures: what the values choose, whether that is right, and what is to blame. The library says
// the same on release, and why (laplace_core.study.verdict); this is what holds while a hand moves.
/** @import { Effect, Model, Seen, State, Verdict } from '../types.js' */
import { short } from '../draw/drawing.js';
import { ROUNDING, tieSize } from '../core/algebra.js';
import { SWITCHES, available, effect, pending, timelineError } from '../core/maths.js';

const VALUE_TOLERANCE = 0.1,
  SOUND = 0.1,
  RUINED = 1 / 3; // as in laplace_core.study.grades
export const WORDS = {
  bad: 'Wrong',
  warn: 'Right, for the wrong reason',
  ok: 'Right',
  unknown: 'No truth to compare with',
  pending: 'Not computed yet',
  smeared: 'Right choice, smeared timeline',
  ruined: 'Right choice, ruined timeline',
};

// Decimals, never a negative zero. Values that are all below .01, but larger than rounding, get significant digits;
// `apart` adds as many digits as make two values differ. As in laplace_core.study.verdict.in_words.
const fixed = (value, digits) => (Math.round(value * 10 ** digits) / 10 ** digits + 0).toFixed(digits);
const significant = (value, digits) => String(+value.toPrecision(digits) + 0);
function inWords(values, scale, apart = false) {
  const largest = Math.max(...values.map(Math.abs));
  const word = ROUNDING * scale < largest && largest < 0.01 ? significant : fixed;
  const shown = (digits) => values.map((value) => word(value, digits));
  const enough = apart && [2, 3, 4, 6].find((digits) => new Set(shown(digits)).size === values.length);
  return shown(enough || 2);
}

// The chosen value against the next best, with the digits that tell them apart.
function numbers(values, scale, chosen, names) {
  if (values.length < 2) return '';
  const rival = values.reduce((best, value, a) => (a !== chosen && (best < 0 || value > values[best]) ? a : best), -1);
  if (values[rival] >= values[chosen] - tieSize(values[chosen], scale))
    return ` (a tie at ${inWords([values[chosen]], scale)[0]})`;
  const [first, second] = inWords([values[chosen], values[rival]], scale, true);
  return ` (${first} v ${second}${values.length > 2 ? ` for ${names[rival]}` : ''})`;
}

const ALLOWED = 0.05; // survival above 1, and probability below 0 in a row: VISIBLE in laplace_core.study.artefacts
const isLinear = ({ arrays, grids }, state) =>
  !arrays.decoded && !grids.own.reduced && !(state.fold && !grids.own.plain);
const gradeOf = (timeline) => (timeline <= SOUND ? 'sound' : timeline <= RUINED ? 'smeared' : 'ruined');

/**
 * How far the timeline of an action is off, as laplace_core.study.verdict says it; nothing where it is sound.
 * @param {number} timeline - share that is misplaced; where all is, rounding may add to it
 * @param {string} name - of the action
 * @returns {string}
 */
export function timelineWords(timeline, name) {
  const grade = gradeOf(timeline),
    share = Math.round(100 * timeline);
  if (grade === 'sound') return '';
  const off = share <= 100 ? `${share}% misplaced` : `off by ${short(timeline)} times all that truly comes`;
  return ` Timeline of ${name}: ${grade}, ${off}.`;
}

/**
 * The verdict on what is seen; where there is a truth, with the largest error of a value and that of the timeline.
 * @param {Model} model
 * @param {State} state
 * @param {Seen} seen
 * @returns {Verdict}
 */
export function judged(model, state, seen) {
  if (pending(model, state)) {
    const stays = model.arrays.decoded ? 'the timeline of the old settings stays' : 'this is the one of Tikhonov';
    return {
      tone: 'pending',
      sentence: `This solver runs on the server after you release the control; until then ${stays}.`,
    };
  }
  const names = model.header.actions,
    row = seen.readRow,
    values = seen.values.map((line) => line[row]);
  const T = short(model.horizons[row]),
    left = short(model.horizons[seen.leftRow]);
  const where =
    state.used > 0 ? `With ${left} of ${short(state.horizon)} steps to go, read at T = ${T},` : `At T = ${T}`;
  const choice =
    `${where} the decoded values choose ${names[seen.chosen]}` + numbers(values, seen.scale, seen.chosen, names);
  if (!seen.truth) {
    return {
      tone: 'unknown',
      sentence: model.A > 1 ? `${choice}.` : `${where} the decoded value is ${inWords([values[0]], seen.scale)[0]}.`,
    };
  }
  const optimum = seen.optimumAt(seen.leftRow),
    true_ = seen.truth.values.map((line) => line[seen.leftRow]);
  const timeline = timelineError(model, state, seen),
    error = Math.max(...values.map((value, a) => Math.abs(value - seen.truth.hard[a][seen.leftRow])));
  const rows = timelineWords(timeline, names[state.action]);
  if (seen.regret > tieSize(Math.max(...optimum), Math.max(...optimum.map(Math.abs)))) {
    return {
      tone: 'bad',
      error,
      timeline,
      sentence: `${choice}; the best is ${names[seen.best]}, and ${short(seen.regret)} is lost.${rows}`,
    };
  }
  const scale = Math.max(...true_.map(Math.abs), 1e-2 * Math.max(...model.arrays.rewards.map(Math.abs)));
  const offs = true_.map((value, a) =>
      scale > 0
        ? Math.abs(value - values[a]) / scale
        : Math.abs(value - values[a]) > tieSize(0, seen.scale)
          ? Infinity
          : 0,
    ),
    worst = offs.indexOf(Math.max(...offs));
  const grade = gradeOf(timeline),
    tone = offs[worst] > VALUE_TOLERANCE ? 'warn' : grade === 'sound' ? 'ok' : grade;
  if (model.A === 1) {
    const [decoded, truly] = inWords([values[0], true_[0]], seen.scale);
    return {
      tone,
      error,
      timeline,
      sentence: `${where} the decoded value is ${decoded}; the true one is ${truly}.${rows}`,
    };
  }
  const [decoded, truly] = inWords([values[worst], true_[worst]], seen.scale, true);
  const but = tone === 'warn' ? ` But ${names[worst]} is worth ${truly}, not ${decoded}.` : '';
  return { tone, error, timeline, sentence: `${choice}, and no action is better.${but}${rows}` };
}

/**
 * Labels and names of solvers for a timeline that cannot be probabilities: its survival exceeds 1, or it has less than
 * nothing of a reward.
 * @param {Model} model
 * @param {Seen} seen
 * @returns {[string, string][]}
 */
export function offers({ header: { solver }, dt }, { survival, tau, H, n }) {
  /** @type {[string, string][]} */
  const found = [];
  if (solver !== 'feasible' && impossible(survival, dt)) found.push(['Use the feasible timeline', 'feasible']);
  const negative = solver !== 'nonnegative' && solver !== 'feasible' && lowest(tau, n, H) < -ALLOWED * dt;
  if (negative) found.push(['Use the non-negative solver', 'nonnegative']);
  return found;
}

/**
 * Whether a survival is above 1 by more than what is left out of a picture.
 * @param {Float64Array[]} survival - (n,) an action
 * @param {number} dt - length of a row
 * @returns {boolean}
 */
export const impossible = (survival, dt) => survival.some((line) => line.some((alive) => alive / dt > 1 + ALLOWED));

// The most that masses below 0 take away from a row.
function lowest(tau, n, H) {
  let least = 0;
  for (let k = 0; k < n; k++) {
    let sum = 0;
    for (let h = 0; h < H; h++) sum += Math.min(0, tau[k * H + h]);
    least = Math.min(least, sum);
  }
  return least;
}

/**
 * What every switch does here, by name; nothing of a solver that is not linear, whose picture is no sum of parts.
 * @param {Model} model
 * @param {State} state
 * @returns {Record<string, Effect>}
 */
export const effects = (model, state) =>
  Object.fromEntries(
    Object.keys(SWITCHES)
      .filter((name) => isLinear(model, state) && available(model, name))
      .map((name) => [name, effect(model, state, name)]),
  );
