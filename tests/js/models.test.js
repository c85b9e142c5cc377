import assert from 'node:assert/strict';
import { test } from 'node:test';
import { modelOf, models } from '../../app/js/lens/models.js';
import { bytesOf } from './agreement.js';
import { fixture } from './fixtures.js';

test('two models are kept, those that were asked for last', () => {
  const bytes = bytesOf(fixture('table').payload),
    none = new Uint8Array();
  const first = modelOf('a', bytes);
  modelOf('b', bytes);
  assert.equal(modelOf('a', none), first); // and now b is the older one
  modelOf('c', bytes);
  assert.deepEqual([...models.keys()], ['a', 'c']);
  assert.equal(modelOf('b', none), undefined);
  assert.equal(modelOf('a', none).id, 'a');
});
