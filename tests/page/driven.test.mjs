// Motions with driven joints: no word, number or line of a goal, and the edits of drivers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  addValue, drivable, driveJoint, freshDriver, freshRange, fullTurn, goToDrivers, goToKeyFrames, removeValue,
} from '../../www/core/driver-edits.js';
import * as edits from '../../www/core/edits.js';
import { drivesJoints, loadWords } from '../../www/core/driven.js';
import { driverName, drivenWords, driveReasons } from '../../www/core/driven-words.js';
import { createKeeper } from '../../www/app/files/browser-storage.js';
import { kindOf } from '../../www/core/number-steps.js';
import { isTimed, keyFrameFrames } from '../../www/core/playhead.js';
import { hasNoGoal, shown } from '../../www/core/shown.js';
import { describeScene, frameSentence } from '../../www/core/status-words.js';
import { createStore } from '../../www/core/store.js';
import { nameOf, thingsOf } from '../../www/core/things.js';
import { chartsOf, isOffered, summary } from '../../www/panels/charts/chart-list.js';
import { gapFrames } from '../../www/view3d/scene/gap-lines.js';
import { createMeasure } from '../../www/view3d/scene/measure.js';

const STATUSES = ['reached', 'closest', 'at_limit', 'stalled', 'closure_lost'];
const NONE = [NaN, NaN, NaN, NaN, NaN, NaN, NaN];

/** A crank and a slider far from the origin, in millimetres; the crank is driven, and stops short in the last frame. */
function made() {
  const doc = {
    version: 1, name: 'a', length_unit: 'mm',
    chains: [{ name: 'arm', joints: [{ type: 'R', rows: [{}] }, { type: 'C', rows: [{}], limits: [null, { min: -20, max: 60 }] }] }],
    motion: { drivers: [{ chain: 1, joint: 1, values: [{ time: 2, value: 10 }, { time: 4, value: 370 }] }] },
  };
  const pose = Float64Array.of(5000, 1, 2, 0, 0, 0, 1, 5010, 1, 2, 0, 0, 0, 1, 5020, 1, 2, 0, 0, 0, 1);
  const row = [5000, 0, 0, 0, 0, 0, 1, 5300, 400, 0, 0, 0, 0, 1];
  const column = () => Float64Array.of(NaN, NaN, NaN);
  const motion = {
    frames: 3, goal_frames: 3, partial: false, time: Float64Array.of(2, 3, 4), status: Uint8Array.of(0, 0, 3), pose,
    goal: Float64Array.of(...NONE, ...NONE, ...NONE), joints: Float64Array.of(0, 0, 5, Math.PI, 0, 5, 3.5, 0, 5),
    metric: column(), translation_gap: column(), rotation_gap: column(), projected_gradient: column(),
    closure: Float64Array.of(0, 0, 0), misfit: Float64Array.of(0, 0, 0), sigma_min: Float64Array.of(1, 1, 1), iterations: Uint32Array.of(1, 1, 1),
    rows: Float64Array.of(...row, ...row, ...row),
    report: {
      statuses: STATUSES, drivers: [0], bounds: { reached: 5e-17 }, metric: { length: 1 },
      chains: [{ name: 'arm', type: 'RC', rows: [{ kind: 'R', joint: 0 }, { kind: 'C', joint: 1 }], variables: [{ label: 'θ1', unit: 'rad', row: 0 }, { label: 'θ2', unit: 'rad', row: 1 }, { label: 'd2', unit: 'length', row: 1 }] }],
      warnings: [
        { code: 'undriven-freedoms', message: '2 freedoms' },
        { code: 'branch-chosen', message: 'a way', first: 1, last: 1 },
        { code: 'drive-ends', message: 'a dead point', first: 2, last: 2 },
      ],
    },
  };
  const store = createStore(doc);
  store.setResult({ motion, doc, plain: doc });
  return { store, motion, doc };
}

// As the page does before it shows such a motion.
await loadWords(made().motion);

/** Numbers and words of a thing, with nothing in them that is no number. @param {unknown} thing */
const clean = (thing) => assert.doesNotMatch(JSON.stringify(thing, (_, value) => (typeof value === 'number' && !Number.isFinite(value) ? 'NaN' : value)), /NaN|null|undefined/);

test('what is shown has no goal, unless a hand pulls', () => {
  const { store, motion } = made();
  assert.ok(drivesJoints(motion) && hasNoGoal(store));
  assert.equal(shown(store).goal, motion.pose, 'the reached pose stands in its place, as where a hand drives a joint');
  const posture = { joints: motion.joints, pose: motion.pose, goal: motion.pose, rows: motion.rows };
  store.setView({ posture });
  assert.equal(hasNoGoal(store), false);
  store.setView({ posture: { ...posture, value: 1 } });
  assert.equal(hasNoGoal(store), true);
});

test('a frame is told by the values of the driven joints', () => {
  const { store, motion, doc } = made();
  store.setView({ frame: 1 });
  assert.equal(frameSentence(store), 'Frame 2 of 3: reached, θ₁ of arm at 180°.');
  assert.equal(drivenWords({ ...motion, report: { ...motion.report, drivers: [2, 0] } }, doc, 1), 'd₂ of arm at 5 mm, θ₁ of arm at 180°');
  const scene = describeScene(store);
  assert.match(scene, /Workpiece at \(5010, 1, 2\) mm\.$/);
  assert.doesNotMatch(scene, /goal|gap|NaN/);
  assert.equal(nameOf('closest', store), 'path of the workpiece');
});

test('what stops the drivers is told at its frames, and what was chosen', () => {
  const { motion } = made();
  assert.deepEqual([0, 1, 2].map((frame) => driveReasons(motion, frame)), [[], ['a way'], ['a dead point']]);
  const dependent = { ...motion, report: { ...motion.report, warnings: [{ code: 'driver-dependent', message: 'no freedom' }] } };
  assert.deepEqual([0, 2].map((frame) => driveReasons(dependent, frame)), [[], ['no freedom']]);
});

test('the charts are those of the driven joints and of the path', () => {
  const { motion } = made();
  const charts = chartsOf(motion, 'mm');
  clean(charts.map(({ series }) => series.map(({ values }) => [...values])));
  assert.deepEqual([...new Set(charts.map(({ group }) => group))], ['driven', 'path', 'joints', 'sigma', 'closure', 'misfit', 'iterations']);
  assert.ok(charts.every(({ group }) => isOffered(group, motion)) && !isOffered('metric', motion));
  assert.equal(summary(charts[0]), 'Driven joint, arm θ₁: 0 to 200.54°, largest at frame 3.');
  assert.deepEqual([...charts[1].series[0].values], [5000, 5010, 5020]);
});

test('the scene is measured without a goal, and has no gap lines', () => {
  const { motion, doc } = made();
  const { size, take } = createMeasure();
  take(motion, doc, true);
  clean(size);
  assert.ok(size.radius > 100 && size.radius < 600);
  assert.deepEqual(gapFrames(motion, 1), []);
});

test('a document without key frames has times, things, and is kept for the next visit', () => {
  const { store, doc, motion } = made();
  assert.ok(isTimed(doc));
  assert.deepEqual(keyFrameFrames(doc, motion.time), []);
  assert.ok(!thingsOf(doc).some((thing) => thing.includes('key_frames')));
  assert.equal(kindOf(doc, 'motion.drivers[0].values[1].value'), 'angle');
  assert.equal(nameOf('motion.drivers[0]', store), 'driver 1');
  const kept = new Map();
  const storage = () => ({ getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) });
  createKeeper(storage, 'one').save({ doc, past: [], future: [], good: null, title: '', unsaved: true });
  assert.deepEqual(createKeeper(storage, 'two').load().work.doc, doc);
});

test('a new driver goes a turn on from the present value, or between its limits, or to either side', () => {
  const { store, doc } = made();
  store.setView({ frame: 1 });
  const [crank, turn, slider] = drivable(doc);
  assert.deepEqual(freshRange(store, crank), [180, 540]);
  assert.deepEqual(freshRange(store, turn), [0, 360]);
  assert.deepEqual(freshRange(store, slider), [-20, 60]);
  // Without limits by a tenth of the linkage's size, which is 500 mm, wherever it stands.
  const free = { ...doc, chains: [{ ...doc.chains[0], joints: doc.chains[0].joints.map(({ limits: _, ...joint }) => joint) }] };
  assert.deepEqual(freshRange({ ...store, doc: free, result: { ...store.result, plain: free }, view: store.view }, slider), [-45, 55]);
  assert.deepEqual(freshDriver(store, turn), { chain: 1, joint: 2, freedom: 1, values: [{ time: 2, value: 0 }, { time: 4, value: 360 }], ramp: 'linear' });
  const radians = { ...doc, angles: 'radians' };
  assert.equal(freshDriver({ ...store, doc: radians, result: store.result, view: store.view }, turn).values[1].value, 6.283185307);
});

test('values are added as a dwell, removed, and made a full turn', () => {
  const { doc } = made();
  const values = (next) => next.motion.drivers[0].values.map(({ time, value }) => [time, value]);
  assert.deepEqual(values(addValue(doc, 0)), [[2, 10], [4, 370], [6, 370]]);
  assert.deepEqual(values(removeValue(addValue(doc, 0), 0, 1)), [[2, 10], [6, 370]]);
  assert.deepEqual(values(fullTurn(addValue(doc, 0), 0)), [[2, 10], [6, 370]]);
});

test('key frames and drivers take each other’s place, and neither is lost', () => {
  const { store, doc } = made();
  const said = [];
  const parts = { store, say: (text) => said.push(text) };
  goToKeyFrames(parts);
  const { motion } = store.doc;
  assert.equal(motion.drivers, undefined);
  assert.deepEqual(motion.key_frames.map(({ name, x }) => [name, x]), [['start', 5000], ['middle', 5010], ['end', 5020]], 'poses of the motion');
  assert.match(said.at(-1), /1 driven joint is kept/);
  store.edit((old) => ({ ...old, motion: { ...old.motion, key_frames: [...old.motion.key_frames, { x: 1 }] } }));
  goToDrivers(parts);
  assert.deepEqual(store.doc.motion, doc.motion, 'the same drivers again');
  goToKeyFrames(parts);
  assert.equal(store.doc.motion.key_frames.length, 4, 'the key frames as they were left');
  store.undo();
  assert.deepEqual(store.doc.motion, doc.motion);
  // Another document has another past.
  store.open({ ...doc, name: 'b' }, { title: '', handle: null, saved: null });
  goToKeyFrames(parts);
  assert.equal(store.doc.motion.key_frames.length, 3);
});

test('one joint more is driven, each of them once', () => {
  const { store, doc } = made();
  const said = [];
  const parts = { store, say: (text) => said.push(text) };
  driveJoint(parts, { chain: 0, joint: 0, freedom: 0 });
  assert.equal(store.doc, doc);
  driveJoint(parts, { chain: 0, joint: 1, freedom: 1 });
  assert.equal(store.doc.motion.drivers.length, 2);
  assert.equal(driverName(store.doc, store.doc.motion.drivers[1]), 'd₂ of arm');
  assert.match(said.at(-1), /^d₂ of arm is driven from −20 mm to 60 mm/);
  assert.equal(driverName(store.doc, { chain: 9, joint: 1, values: [] }), 'joint 1 of chain 9', 'what there is not is at fault, and has a name');
});

test('drivers keep their joints where chains and joints change places, and go with them', () => {
  const R = { type: 'R', rows: [{}] };
  const [P, C] = [{ type: 'P', rows: [{}] }, { type: 'C', rows: [{}] }];
  const driver = (chain, joint) => ({ chain, joint, values: [{ time: 0, value: 0 }, { time: 1, value: 1 }] });
  // The same new joint twice, as the page inserts it.
  const doc = { version: 1, chains: [{ joints: [R, R, P] }, { joints: [C, P] }], motion: { drivers: [driver(1, 2), driver(2, 1)] } };
  const drives = (next) => next.motion.drivers.map(({ chain, joint }) => `${chain}.${joint}`);
  assert.deepEqual(drives(edits.moveChain(doc, 0, 1)), ['2.2', '1.1']);
  assert.deepEqual(drives(edits.duplicateChain(doc, 0)), ['1.2', '3.1']);
  assert.deepEqual(drives(edits.removeChain(doc, 0)), ['1.1']);
  assert.deepEqual(drives(edits.insertJoint(doc, 0, 0, C)), ['1.3', '2.1']);
  assert.deepEqual(drives(edits.moveJoint(doc, 1, 0, 1)), ['1.2', '2.2']);
  assert.deepEqual(drives(edits.removeJoint(doc, 1, 0)), ['1.2']);
  assert.deepEqual(drives(edits.setJoint(doc, 1, 0, R)), ['1.2', '2.1'], 'another type in the same place');
  const last = { ...doc, motion: { drivers: [driver(1, 2)] } };
  assert.deepEqual(drives(edits.removeChain(last, 0)), ['1.2'], 'the last driver stays, to be given another joint');
  assert.equal(edits.moveChain({ ...doc, motion: { key_frames: [] } }, 0, 1).motion.drivers, undefined);
});
