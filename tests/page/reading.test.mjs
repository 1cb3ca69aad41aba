// Files that a person hands in.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readText } from '../../www/app/files/reading.js';

test('text is read, without its mark of order', async () => {
  assert.equal(await readText(new Blob(['\uFEFF{"name": "Größe"}'])), '{"name": "Größe"}');
});

test('pictures, other encodings and huge files are refused in words', async () => {
  await assert.rejects(readText(new Blob([new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0])])), { message: /not a text.*JSON/ });
  await assert.rejects(readText(new Blob([new Uint8Array([0x7b, 0, 0x7d, 0])])), { message: /not a text/ });
  await assert.rejects(readText(new Blob([new Uint8Array(33_000_000)])), { message: /33\.0 MB.*at most 32 MB/ });
});
