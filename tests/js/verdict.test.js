import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pending, see } from '../../app/js/core/maths.js';
import { read } from '../../app/js/core/model.js';
import { judged, offers, timelineWords } from '../../app/js/lens/verdict.js';
import { bytesOf } from './agreement.js';
import { fixture } from './fixtures.js';

test('the verdict of the lens is the one of the library: the same action, grades and numbers', () => {
  const views = fixture('verdicts');
  assert.ok(views.length > 0);
  views.forEach((view, number) => {
    const model = read(bytesOf(view.payload)),
      seen = see(model, view.state),
      { tone, error, timeline } = judged(model, view.state, seen);
    assert.equal(tone, view.tone, `tone of view ${number}`);
    assert.equal(seen.chosen, view.chosen, `choice of view ${number}`);
    const values = seen.values.map((line) => line[seen.readRow]);
    assert.equal(values.length, view.values.length);
    [...values, error].forEach((value, i) => {
      const far = Math.abs(value - [...view.values, view.error][i]);
      assert.ok(far <= view.allowed, `value ${i} of view ${number} is off by ${far}`);
    });
    assert.ok(Math.abs(timeline - view.timeline) <= 1e-6 * Math.max(1, view.timeline), `timeline of view ${number}`);
  });
});

test('a timeline is said to be off by more than all only where its number is', () => {
  const words = (size) => timelineWords(size, 'go').replace(' Timeline of go: ', '');
  assert.equal(words(0.04), '');
  assert.equal(words(0.493), 'ruined, 49% misplaced.');
  for (const size of [1, 1 + 2.3e-16, 1.004]) assert.equal(words(size), 'ruined, 100% misplaced.');
  assert.equal(words(1.01), 'ruined, off by 1.01 times all that truly comes.');
});

const given = fixture('solvers'),
  cases = given.cases.map((each) => ({ ...each, model: read(bytesOf(given.payloads[each.payload])) }));

test('a solver of the server has not answered for another alpha, and its timeline stays', () => {
  const { model, state } = cases.find(({ payload }) => payload === 'served 0 feasible'),
    moved = { ...state, alpha: 2 * state.alpha },
    read_otherwise = { ...state, horizon: 1, normalise: 'paper' };
  assert.equal(pending(model, state), false);
  assert.equal(pending(model, read_otherwise), false);
  assert.equal(pending(model, moved), true);
  assert.equal(judged(model, moved, see(model, moved)).tone, 'pending');
  assert.deepEqual(see(model, moved).tau, see(model, state).tau);
  const follows = cases.find(({ payload }) => payload.endsWith('tsvd'));
  assert.equal(pending(follows.model, { ...follows.state, alpha: 0.5 }), false);
  assert.equal(pending(follows.model, { ...follows.state, fold: true }), true); // every horizon has its own components
});

test('a timeline that no probabilities can be offers a solver that keeps to them', () => {
  const { model } = cases[0],
    timeline = (alive, mass) => ({ survival: [Float64Array.of(alive)], tau: Float64Array.of(mass, 0.5), H: 2, n: 1 }),
    names = (solver, alive, mass) =>
      offers({ ...model, dt: 1, header: { ...model.header, solver } }, timeline(alive, mass)).map(([, name]) => name);
  assert.deepEqual(names('tikhonov', 1.02, -0.02), []);
  assert.deepEqual(names('tikhonov', 1.2, -0.2), ['feasible', 'nonnegative']);
  assert.deepEqual(names('nonnegative', 1.2, 0), ['feasible']);
  assert.deepEqual(names('feasible', 1.2, -0.2), []);
});
