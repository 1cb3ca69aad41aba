// The README's JavaScript runs as printed.
import assert from 'node:assert/strict';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../../', import.meta.url);

test('the JavaScript of the README plans a document', async (t) => {
  const code = readFileSync(new URL('README.md', root), 'utf8').match(/```js\n([\s\S]*?)```/)?.[1];
  assert.ok(code, 'a js block');
  // Node does not fetch files.
  t.mock.method(globalThis, 'fetch', async (url) =>
    new Response(readFileSync(url), { headers: { 'content-type': 'application/wasm' } }));
  const printed = [];
  t.mock.method(console, 'log', (...values) => printed.push(values));
  const file = new URL('www/readme-example.tmp.mjs', root);
  t.after(() => rmSync(file));
  const run = async (text) => {
    writeFileSync(file, `const text = ${JSON.stringify(text)};\n${code}`);
    await import(`${file}?${printed.length}`);
    return printed.at(-1);
  };
  const [mobility, frames, closure] = await run(readFileSync(new URL('www/mechanisms/3rps.json', root), 'utf8'));
  assert.equal(mobility, 3);
  assert.ok(frames > 1 && closure <= 1e-10);
  const [place, message] = await run('{"version": 2}');
  assert.equal(place, 'version');
  assert.match(message, /Accepted: 1/);
});
