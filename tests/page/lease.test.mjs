/**
 * The graphics context is given back and asked for again only when the browser allows it, in whatever order a view
 * goes out of sight and comes back.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as after } from 'node:timers/promises';
import { createLease } from '../../www/view3d/scene/lease.js';

/** A canvas and its context by the specification of WEBGL_lose_context; what it refuses is a fault. */
function browser() {
  const canvas = new EventTarget();
  const faults = [];
  let lost = false;
  let mayRestore = false;
  const tell = (type, then) =>
    setTimeout(() => {
      canvas.dispatchEvent(new Event(type));
      then?.();
    });
  const extension = {
    loseContext() {
      if (lost) return faults.push('context already lost');
      lost = true;
      mayRestore = false;
      tell('webglcontextlost', () => (mayRestore = true));
    },
    restoreContext() {
      if (!lost || !mayRestore) return faults.push('context restoration not allowed');
      mayRestore = false;
      setTimeout(() => {
        lost = false;
        canvas.dispatchEvent(new Event('webglcontextrestored'));
      });
    },
  };
  return { canvas, faults, context: { getExtension: () => extension, isContextLost: () => lost }, extension };
}

for (const order of ['', '0', '01', '010', '0101', '01010']) {
  test(`out of sight (0) and in sight (1) within one task: ${order || 'neither'}`, async () => {
    const { canvas, context, faults } = browser();
    const lease = createLease(canvas, context);
    for (const seen of order) lease.setSeen(seen === '1');
    await after(50);
    const seen = !order.endsWith('0');
    assert.deepEqual({ faults, lost: context.isContextLost(), ready: lease.ready, givenBack: lease.givenBack }, { faults: [], lost: !seen, ready: seen, givenBack: !seen });
    for (const next of [!seen, seen, !seen]) {
      lease.setSeen(next);
      await after(1);
    }
    await after(50);
    assert.deepEqual({ faults, lost: context.isContextLost() }, { faults: [], lost: seen });
  });
}

test('what the browser takes is for the browser to restore', async () => {
  const { canvas, context, faults, extension } = browser();
  const lease = createLease(canvas, context);
  extension.loseContext();
  assert.equal(lease.ready, false);
  await after(10);
  lease.setSeen(false);
  lease.setSeen(true);
  await after(10);
  assert.deepEqual({ faults, lost: context.isContextLost(), givenBack: lease.givenBack }, { faults: [], lost: true, givenBack: false });
  extension.restoreContext();
  await after(10);
  assert.equal(lease.ready, true);
});
