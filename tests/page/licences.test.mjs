// The licences of other people's code, as the build finds them.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { licenceTexts, licences, packagesIn } from '../../tools/licences.js';

/** @param {Record<string, string>} files @param {string} licence */
function textsOf(files, licence) {
  const folder = mkdtempSync(join(tmpdir(), 'licences-'));
  try {
    for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
    return licenceTexts(folder, { name: 'cog', version: '1.2.3', licence });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a package without a licence file ends the build, with its name and what would be accepted', () => {
  assert.throws(() => textsOf({ 'README.md': 'MIT' }, 'MIT'), /^Error: cog 1\.2\.3 has no licence file in .*LICENSE/);
});

test('of a choice MIT is taken; what is not a choice is kept, and notices are', () => {
  const both = { 'LICENSE-MIT': 'mit', 'LICENSE-APACHE': 'apache', 'LICENSE-UNICODE': 'unicode', NOTICE: 'notice' };
  assert.deepEqual(textsOf(both, '(MIT OR Apache-2.0) AND Unicode-3.0'), ['mit', 'unicode', 'notice']);
  assert.deepEqual(textsOf(both, 'MIT AND Apache-2.0').sort(), ['apache', 'mit', 'notice', 'unicode']);
  assert.deepEqual(textsOf({ 'LICENSE-APACHE': 'apache' }, 'MIT/Apache-2.0'), ['apache'], 'the only text there is');
  assert.deepEqual(textsOf({ LICENSE: 'all', UNLICENSE: 'none' }, 'Unlicense OR MIT').sort(), ['all', 'none'], 'no file says that it is the one of MIT');
});

test('a text that several have stands once, below the names of all', () => {
  const part = (name, text) => ({ name, version: '1.0.0', licence: 'MIT', from: 'https://example.org', texts: [text] });
  const text = licences([part('a', 'free as\nit is'), part('b', 'other'), part('c', 'free as it is')]);
  assert.match(text, /^a 1\.0\.0, MIT, https:\/\/example\.org\nb /);
  assert.match(text, /-\na 1\.0\.0, c 1\.0\.0\n\nfree as\nit is\n/);
  assert.equal(text.match(/free/g).length, 1);
});

test('npm packages are known by the modules that are in a build', () => {
  const output = [{ moduleIds: ['/x/node_modules/three/src/a.js', '/x/node_modules/@a/b/c.js', '/x/www/own.js'] }, {}, { moduleIds: ['/x/node_modules/three/src/b.js'] }];
  assert.deepEqual(packagesIn(output), ['@a/b', 'three']);
});
