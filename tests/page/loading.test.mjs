// How much of the planner has come is counted after decompression.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { counted, loading } from '../../www/planner/loading.js';

test('a response is counted while it comes, and is the same response', async () => {
  const sent = [];
  const bytes = [new Uint8Array(3).fill(1), new Uint8Array(5).fill(2)];
  const body = new ReadableStream({
    start(out) {
      for (const part of bytes) out.enqueue(part);
      out.close();
    },
  });
  const response = counted(new Response(body, { headers: { 'content-type': 'application/wasm', 'content-length': '2' } }), 8, (message) => sent.push(message.loaded));
  assert.deepEqual([...new Uint8Array(await response.arrayBuffer())], [1, 1, 1, 2, 2, 2, 2, 2]);
  assert.deepEqual([sent, response.headers.get('content-type')], [[0, 3, 8], 'application/wasm']);
  const missing = new Response('', { status: 503 });
  assert.equal(counted(missing, 8, assert.fail), missing);
});

test('what was told is there for who comes later, and is told until that ends', () => {
  const heard = [];
  const end = new AbortController();
  loading.tell({ kind: 'loading', loaded: 1, total: 4 });
  loading.subscribe(() => heard.push(loading.latest.loaded), end.signal);
  assert.equal(loading.latest.loaded, 1);
  loading.tell({ kind: 'loading', loaded: 2, total: 4 });
  end.abort();
  loading.tell({ kind: 'loading', loaded: 4, total: 4 });
  assert.deepEqual(heard, [2]);
});
