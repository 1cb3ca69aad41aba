// Files that are exported: a film's duration, a packed motion, names.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pack, unpack } from '../../www/player-page/pack.js';
import { withDuration } from '../../www/export/webm.js';
import { fileName } from '../../www/export/save.js';

const HEAD = [0x1a, 0x45, 0xdf, 0xa3, 0x80, 0x18, 0x53, 0x80, 0x67, 0x01, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff];
const INFO = [0x15, 0x49, 0xa9, 0x66];
const SCALE = [0x2a, 0xd7, 0xb1, 0x83, 0x0f, 0x42, 0x40];
const REST = [0x16, 0x54, 0xae, 0x6b, 0x80];

test('a film is told its duration once, whatever the form of the size', () => {
  for (const size of [[0x87], [0x40, 0x07], [0x01, 0, 0, 0, 0, 0, 0, 7]]) {
    const film = Uint8Array.from([...HEAD, ...INFO, ...size, ...SCALE, ...REST]);
    const told = withDuration(film, 5000);
    const duration = new Uint8Array(new Float64Array([5000]).buffer).reverse();
    const whole = [...HEAD, ...INFO, 1, 0, 0, 0, 0, 0, 0, 18, ...SCALE, 0x44, 0x89, 0x88, ...duration, ...REST];
    assert.deepEqual([...told], whole);
    assert.equal(withDuration(told, 1), told);
  }
});

test('what is no film of that form stays as it is', () => {
  for (const bytes of [[], HEAD, [...HEAD, ...INFO], [...HEAD, ...INFO, 0xff], [...HEAD, ...INFO, 0]]) {
    const film = Uint8Array.from(bytes);
    assert.equal(withDuration(film, 1), film);
  }
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
