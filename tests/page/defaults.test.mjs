// What new parts are made of in the page is what the planner's format has.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { DEFAULTS } from '../../www/core/defaults.js';

const at = (path) => new URL(`../../www/${path}`, import.meta.url);

test('the page’s defaults are the planner’s', async () => {
  const { initSync, defaults } = await import(at('pkg/synthetica.js'));
  initSync({ module: readFileSync(at('pkg/synthetica_bg.wasm')) });
  const { document, ...parts } = defaults();
  assert.deepEqual(DEFAULTS, parts);
  assert.equal(JSON.parse(document).version, 1);
});
