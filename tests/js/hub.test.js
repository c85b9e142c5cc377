import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hub } from '../../app/js/hub.js';

test('the hub knows the lens that is on the page, and none that was taken off', () => {
  assert.equal(hub.lens, undefined);
  const lens = { host: { isConnected: true } };
  hub.lens = lens;
  assert.equal(hub.lens, lens);
  lens.host.isConnected = false;
  assert.equal(hub.lens, undefined);
});

test('the hub knows the player that came last', () => {
  assert.equal(hub.leader, undefined);
  hub.leader = { id: 'first' };
  hub.leader = { id: 'second' };
  assert.equal(hub.leader.id, 'second');
});
