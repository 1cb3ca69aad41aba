// The package has the licences of other people's code that is in it, in a file and in the script that goes alone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { assertLicensed, crates, packages } from '../e2e/licensed.mjs';
import { dist } from './site.mjs';

const read = (file) => readFileSync(new URL(file, dist), 'utf8');
const all = () => [...crates(), ...packages(['lit-html', 'three', 'uplot'])];

test('LICENSE-OTHERS has every crate of the wasm and every npm package, and goes with the package', () => {
  assertLicensed(`\n${read('LICENSE-OTHERS')}`, all());
  assert.ok(JSON.parse(read('package.json')).files.includes('LICENSE-*'));
});

test('inline.js begins with them', () => {
  const script = read('inline.js');
  assertLicensed(script.slice(0, script.indexOf('*/')), all());
});
