// Tool paths of up to 100,000 poses: shown in part, kept or told, and taken over from a table.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createKeeper, LARGEST } from '../../www/app/files/browser-storage.js';
import { takeKeyFrames } from '../../www/core/key-frames-from-table.js';
import { sizeOf } from '../../www/core/number-steps.js';
import { keyFrameIn, PAGE, pageWith } from '../../www/core/row-window.js';
import { same, spreadOver } from '../../www/core/spread.js';
import { createStore } from '../../www/core/store.js';
import { textOf } from '../../www/core/document-text.js';
import { createRowKeys } from '../../www/panels/tables/row-keys.js';
import { ghostFrames } from '../../www/view3d/scene/ghosts.js';
import { createMaterials } from '../../www/view3d/scene/materials.js';
import { MotionPaths } from '../../www/view3d/scene/motion-paths.js';

const sample = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));
const COUNT = 100_000;
const path = (count) => Array.from({ length: count }, (_, i) => ({ x: i, y: 0, z: 0, longitude: 0, latitude: 0, roll: 0 }));
const long = { ...sample, motion: { ...sample.motion, key_frames: path(COUNT) } };
const poses = (count) => Float64Array.from({ length: 7 * count }, (_, i) => (i % 7 === 0 ? Math.floor(i / 7) : i % 7 === 6 ? 1 : 0));
const motion = { frames: 200, goal: poses(200), pose: poses(200), translation_gap: new Float64Array(200) };

/** Milliseconds of the quickest of three calls: the machine may be busy. */
function quickest(act) {
  return Math.min(...[1, 2, 3].map(() => {
    const began = performance.now();
    act();
    return performance.now() - began;
  }));
}

test('indices are spread evenly, with both ends and the one that is wanted', () => {
  assert.deepEqual(spreadOver(3, 5), [0, 1, 2]);
  assert.deepEqual(spreadOver(101, 5), [0, 25, 50, 75, 100]);
  assert.deepEqual(spreadOver(101, 3, 7), [0, 7, 50, 100]);
  assert.deepEqual(spreadOver(101, 3, 50), [0, 50, 100]);
  assert.equal(new Set(spreadOver(COUNT, 60)).size, 60);
});

test('values are the same as their JSON is', () => {
  const values = [null, 0, 1, '1', '', [], [1], {}, { a: 1 }, { a: undefined, b: 2 }, { b: 2 }, { a: [1, { c: null }] }, true, NaN];
  for (const a of values) for (const b of values) {
    const expected = JSON.stringify(a) === JSON.stringify(b) && !(a === null) === !(b === null);
    assert.equal(same(a, structuredClone(b)), expected, `${JSON.stringify(a)} and ${JSON.stringify(b)}`);
  }
});

test('an edit of a long path compares only what it changed', () => {
  const store = createStore(long);
  const time = quickest(() => store.edit((doc) => ({ ...doc, name: `${doc.name}.` })));
  const written = quickest(() => JSON.stringify(long));
  assert.ok(time < written / 2, `${time} ms, and ${written} ms to write the document`);
  store.edit((doc) => ({ ...doc, motion: { ...doc.motion } }));
  assert.equal(store.history.past.length, 3, 'what says the same is no step');
});

test('the size of a long path is known', () => assert.equal(sizeOf(long), COUNT - 1));

test('rows that are all new have keys in no time', () => {
  const keys = createRowKeys();
  keys(path(20_000));
  assert.equal(new Set(keys(path(20_000).reverse())).size, 20_000);
});

test('a page has the row that is wanted', () => {
  assert.equal(pageWith(PAGE, PAGE - 1), 0, 'a short table is whole');
  assert.deepEqual([0, PAGE - 1, PAGE, 2.5 * PAGE, 1e9, -5].map((row) => pageWith(2.5 * PAGE + 1, row) / PAGE), [0, 0, 1, 2, 2, 0]);
  assert.deepEqual([keyFrameIn('motion.key_frames[12].x'), keyFrameIn('motion.frames'), keyFrameIn('')], [12, -1, -1]);
});

test('the scene marks and names some of many key frames, and the chosen one', () => {
  const paths = new MotionPaths(createMaterials());
  const marks = () => paths.group.children.map(({ userData }) => userData.place ?? '').filter((place) => place.startsWith('motion.'));
  const size = { link: 0.01, radius: 1 };
  paths.update(motion, { ...sample, motion: { ...sample.motion, key_frames: path(20) } }, size, null, []);
  assert.deepEqual([marks().length, paths.labels.length], [20, 20]);
  paths.update(motion, long, size, null, []);
  assert.ok(marks().length <= 61 && paths.labels.length <= 12, `${marks().length} marks, ${paths.labels.length} names`);
  assert.ok(marks().includes('motion.key_frames[99999]'));
  assert.ok(paths.keep('motion.key_frames[777]', long));
  assert.ok(marks().includes('motion.key_frames[777]') && paths.labels.some(({ place }) => place === 'motion.key_frames[777]'));
  assert.ok(!paths.keep('motion.key_frames[777].x', long), 'it is there already');
});

test('ghosts at key frames are a few of many', () => {
  const frames = ghostFrames('keys', motion, long);
  assert.ok(frames.length > 0 && frames.length <= 64);
});

test('a document that no browser keeps is not even written, and that is told', () => {
  let written = 0;
  const storage = { getItem: () => null, removeItem() {}, setItem: () => void written++ };
  const keeper = createKeeper(() => storage, 'a');
  const huge = { ...sample, about: 'x'.repeat(LARGEST) };
  const work = { doc: huge, past: [], future: [], good: null, title: '', unsaved: true };
  assert.equal(keeper.save(work), false);
  assert.equal(written, 0);
  const half = { ...sample, about: 'x'.repeat(LARGEST / 2) };
  assert.ok(keeper.save({ ...work, doc: half, past: Array(60).fill(half) }));
  assert.equal(written, 1);
});

const taken = (count, timed) => Array.from({ length: count }, (_, i) => ({ name: '', x: i, y: 0, z: 0, longitude: 0, latitude: 0, roll: 0, ...(timed && { time: i }) }));
const timesOf = (doc) => doc.motion.key_frames.map(({ time }) => time);
const plain = { ...sample, motion: { frames: 5, key_frames: [{ x: 1 }, { x: 2 }] } };
const timed = { ...sample, motion: { frames: 5, key_frames: [{ x: 1, time: 0 }, { x: 2, time: 4 }] } };

test('key frames of a table take the place of the others; the motion has a frame for each', () => {
  const next = takeKeyFrames(timed, taken(9, false), false);
  assert.deepEqual(timesOf(next), Array(9).fill(undefined));
  assert.equal(next.motion.frames, 9);
  assert.equal(takeKeyFrames(plain, taken(3, true), false).motion.frames, 5, 'never fewer');
  assert.equal('name' in next.motion.key_frames[0], false);
  assert.equal(takeKeyFrames({ ...plain, motion: { key_frames: [] } }, taken(40, false), false).motion.frames, 40);
});

test('behind others they have times where those have, and later ones', () => {
  assert.deepEqual(timesOf(takeKeyFrames(plain, taken(2, true), true)), Array(4).fill(undefined));
  assert.deepEqual(timesOf(takeKeyFrames(timed, taken(2, false), true)), [0, 4, 5, 6]);
  assert.deepEqual(timesOf(takeKeyFrames(timed, taken(2, true), true)), [0, 4, 5, 6]);
  const later = taken(2, true).map((key) => ({ ...key, time: key.time + 10 }));
  assert.deepEqual(timesOf(takeKeyFrames(timed, later, true)), [0, 4, 10, 11]);
});

test('of the long texts only the last few are kept, though undo keeps their documents', () => {
  let written = 0;
  const large = () => ({ about: 'x'.repeat(300_000), toJSON() { written++; return { about: this.about }; } });
  const docs = [large(), large(), large(), large()];
  for (const doc of docs) textOf(doc);
  assert.equal(written, 4);
  textOf(docs[3]);
  textOf(docs[1]);
  assert.equal(written, 4, 'the last ones are not written again');
  textOf(docs[0]);
  assert.equal(written, 5, 'the first one is');
});

test('a table is written in the unit of angles of the document, and takes the place of drivers', () => {
  const driver = { chain: 1, joint: 1, values: [{ time: 0, value: 0 }, { time: 1, value: 1 }] };
  const driven = { ...plain, angles: 'radians', motion: { drivers: [driver], frames: 5, key_frames: [] } };
  const [fresh] = taken(1, false);
  const { motion } = takeKeyFrames(driven, [{ ...fresh, longitude: 90, latitude: 0, roll: 180 }], false);
  assert.equal('drivers' in motion, false);
  assert.deepEqual([motion.key_frames[0].longitude, motion.key_frames[0].roll], [Math.PI / 2, Math.PI]);
});
