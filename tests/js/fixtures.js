// What tests/test_js.py wrote for these tests: JSON files in the folder that LAPLACE_FIXTURES names.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * One fixture by its name.
 * @param {string} name
 * @returns {any}
 */
export function fixture(name) {
  const folder = process.env.LAPLACE_FIXTURES;
  if (!folder) throw new Error('no fixtures: run pytest tests/test_js.py, which writes them and starts these tests');
  return JSON.parse(readFileSync(join(folder, `${name}.json`), 'utf8'));
}
