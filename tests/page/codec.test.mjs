// The share link's payload: comes back whole, or is known to be damaged.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { DamagedLink, decode, encode } from '../../www/core/link-codec.js';

const sample = readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8');

test('a document comes back letter by letter, shorter than it was, in letters of a fragment', async () => {
  for (const text of ['', 'a', sample, '{"name": "Größe − 機構 🦾"}']) {
    const payload = await encode(text);
    assert.match(payload, /^1\.[\w-]+$/);
    assert.equal(await decode(payload), text);
  }
  assert.ok((await encode(sample)).length < sample.length / 2);
});

test('a payload of this version stays readable', async () => {
  // Checked with Python's zlib, 3.11: crc32 and decompress(…, -15).
  assert.equal(await decode('1.UnP1X6tWykvMTVWyUlByyy_KTSxRqgUA'), '{"name": "Format"}');
});

test('cut anywhere, or any letter changed, it is known to be damaged', async () => {
  const payload = await encode('{"name": "four-bar", "about": "a link that was cut"}');
  for (let end = 0; end < payload.length; end++) await assert.rejects(decode(payload.slice(0, end)), DamagedLink, String(end));
  for (let at = 2; at < payload.length - 1; at++) {
    const other = payload[at] === 'A' ? 'B' : 'A';
    await assert.rejects(decode(payload.slice(0, at) + other + payload.slice(at + 1)), DamagedLink, String(at));
  }
});

test('says which version it would take', async () => {
  await assert.rejects(decode('2.abc'), { message: /version 2.*version 1/ });
  await assert.rejects(decode('hello'), DamagedLink);
  await assert.rejects(decode('1.a b'), DamagedLink);
});

test('a small link does not unfold to a gigantic text', async () => {
  await assert.rejects(decode(await encode(' '.repeat(5_000_000))), DamagedLink);
});
