// Payloads that were read, by name: a release is answered without sending one again, and a lens may come back.
/** @import { Model } from '../types.js' */
import { read } from '../core/model.js';

/** @type {Map<string, Model>} */
export const models = new Map();
const HELD = 2; // Python counts on as many

/**
 * The model of a payload; undefined where the bytes were not sent and are not held any more.
 * @param {string} id
 * @param {Uint8Array} bytes - none where they were sent before
 * @returns {Model | undefined}
 */
export function modelOf(id, bytes) {
  const model = bytes.length ? { ...read(bytes), id } : models.get(id);
  if (!model) return undefined;
  models.delete(id);
  models.set(id, model);
  while (models.size > HELD) models.delete(models.keys().next().value);
  return model;
}
