// Files that are exported: what is amiss with the motion, a packed motion, names.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pack, unpack } from '../../www/player-page/pack.js';
import { notWhole } from '../../www/export/not-whole.js';
import { fileName } from '../../www/export/file-name.js';

test('a file is only written of the whole motion of the document, and what is amiss is said', () => {
  const doc = {};
  const result = { motion: { partial: false }, doc, fault: null, trouble: '' };
  assert.equal(notWhole({ doc, result }), '');
  for (const [change, words] of [
    [{ fault: { message: '' }, doc: {} }, /a fault, and the motion that is shown is of an earlier one/],
    [{ trouble: 'down', doc: {} }, /planner failed.*earlier one/],
    [{ doc: {} }, /still being planned.*earlier one/],
    [{ doc: null, motion: null }, /still being planned$/],
    [{ motion: { partial: true } }, /only in part/],
  ]) assert.match(notWhole({ doc, result: { ...result, ...change } }), words);
});

test('a packed motion comes back: numbers to the bit, what is only drawn to 7 digits', async () => {
  const column = (length) => Float64Array.from({ length }, (_, index) => Math.sin(index) / 3);
  const names = ['time', 'metric', 'translation_gap', 'rotation_gap', 'closure', 'misfit', 'sigma_min', 'projected_gradient'];
  const motion = {
    frames: 3,
    partial: true,
    goal_frames: 5,
    milliseconds: 1,
    report: { statuses: ['reached'] },
    ...Object.fromEntries(names.map((name) => [name, column(3)])),
    goal: column(21),
    pose: column(21),
    joints: column(15),
    rows: column(3000),
    iterations: Uint32Array.of(1, 2, 3),
    status: Uint8Array.of(0, 1, 4),
  };
  const doc = { version: 1, name: 'Bennett’s – ∞', chains: [] };
  const back = await unpack(`\n${await pack(motion, doc)}\n`);
  assert.deepEqual(back.doc, doc);
  assert.deepEqual({ ...back.motion, rows: null }, { ...motion, rows: null });
  assert.ok(back.motion.rows.every((value, index) => Math.abs(value - motion.rows[index]) < 1e-7));
});

test('files are named after the document', () => {
  assert.equal(fileName({ name: '3RPS' }, 'csv'), '3rps.csv');
  assert.equal(fileName({ name: 'Bennett’s linkage (½)/ü' }, 'svg'), 'bennetts-linkage-1-2-u.svg');
  assert.equal(fileName({ name: ' ../ ' }, 'png'), 'linkage.png');
  assert.equal(fileName(null, 'png'), 'linkage.png');
});
