import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { component } from '../../app/js/cursor/cursor.js';

// As much of a document as a component needs that draws nothing.
const elementOf = () => ({
  isConnected: true,
  children: [],
  setAttribute() {},
  append(...more) {
    this.children.push(...more);
  },
  querySelectorAll: () => [],
});
const message = (about, payload = [1]) => {
  const text = new TextEncoder().encode(JSON.stringify(about)),
    data = new Uint8Array(4 + text.length + payload.length);
  new DataView(data.buffer).setUint32(0, text.length, true);
  data.set(text, 4);
  data.set(payload, 4 + text.length);
  return data;
};

let made, draw, answers;
beforeEach(() => {
  globalThis.document = { createElement: elementOf };
  made = [];
  answers = [];
  draw = component({
    kind: `test ${Math.random()}`,
    open: () => ({}),
    mount(host, opened, { at }, report) {
      const cursor = { step: at, to: (step) => (cursor.step = step) };
      made.push({ host, cursor, report });
      return { stop() {}, place: (step) => (cursor.step = step), cursor };
    },
  });
});
const sent = (parentElement, about) =>
  draw({ data: message(about), parentElement, setTriggerValue: (name, answer) => answers.push(answer) });

test('a step that Python has not heard of outlives the component being put on the page again', async () => {
  await sent(elementOf(), { id: 'a', revision: 1, at: 0 });
  made[0].cursor.to(5);
  made[0].host.isConnected = false;
  await sent(elementOf(), { id: 'a', revision: 1, at: 0 });
  assert.equal(made.length, 2);
  assert.equal(made[1].cursor.step, 5);
});

test('where Python has moved the cursor since, or shows something else, that counts', async () => {
  for (const later of [
    { id: 'a', revision: 2, at: 3 },
    { id: 'b', revision: 1, at: 3 },
  ]) {
    await sent(elementOf(), { id: 'a', revision: 1, at: 0 });
    made.at(-1).cursor.to(5);
    made.at(-1).host.isConnected = false;
    await sent(elementOf(), later);
    assert.equal(made.at(-1).cursor.step, 3);
  }
});

test('the component that stays on the page is moved by a new revision only', async () => {
  const parent = elementOf();
  await sent(parent, { id: 'a', revision: 1, at: 0 });
  made[0].cursor.to(5);
  await sent(parent, { id: 'a', revision: 1, at: 0 });
  assert.equal(made[0].cursor.step, 5);
  await sent(parent, { id: 'a', revision: 2, at: 7 });
  assert.equal(made[0].cursor.step, 7);
  assert.equal(made.length, 1);
});

test('an answer that takes the place of one that was not read repeats its step, until Python confirms it', async () => {
  const parent = elementOf();
  await sent(parent, { id: 'a', revision: 1, at: 0 });
  const { report } = made[0];
  report({ flags: 1, id: 'a' });
  report({ step: 5, id: 'a' });
  report({ flags: 2, id: 'a' });
  await sent(parent, { id: 'a', revision: 1, at: 0 }); // Python has not read them yet
  report({ flags: 3, id: 'a' });
  await sent(parent, { id: 'a', revision: 1, at: 5 });
  report({ flags: 4, id: 'a' });
  report({ step: 6, id: 'a' });
  await sent(parent, { id: 'a', revision: 2, at: 1 }); // Python has moved it
  report({ flags: 5, id: 'a' });
  assert.deepEqual(
    answers.map(({ step }) => step),
    [undefined, 5, 5, 5, undefined, 6, undefined],
  );
});
