// Chains by their axes as text and in another unit; conventions of tables; forms of rotations; angles in radians.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { convertAngles, reread } from '../../www/core/angle-unit.js';
import { acrossOf, asType, intoRows, readJoints, withJoints } from '../../www/core/axes-edits.js';
import { asPrinted, converted } from '../../www/core/convention.js';
import { entry } from '../../www/core/edits.js';
import { ORDERS, frameWith, fromAngles, rotationForm, toAngles, turnOfFrame } from '../../www/core/rotation-forms.js';
import { beginsElsewhere } from '../../www/core/standard-hint.js';
import { stepOf } from '../../www/core/number-steps.js';
import { createStore } from '../../www/core/store.js';
import { turnedCopies } from '../../www/core/turned-copies.js';
import { convertLengths } from '../../www/core/units.js';
import { keyFrameTarget } from '../../www/view3d/hand/key-frame.js';

const at = (path) => new URL(`../../www/${path}`, import.meta.url);
const { initSync, Session } = await import(at('pkg/synthetica.js'));
initSync({ module: readFileSync(at('pkg/synthetica_bg.wasm')) });
const sample = (name) => JSON.parse(readFileSync(at(`mechanisms/${name}`), 'utf8'));

/** A document's motion. */
function plan(doc) {
  const session = Session.open(JSON.stringify(doc));
  const motion = session.plan();
  session.free();
  return motion;
}
const farthest = (a, b) => {
  assert.equal(a.length, b.length);
  return Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));
};

test('joints are read from lines of letters and numbers', () => {
  const { joints } = readJoints('R 0 0 0 0 0 1\nu\t1\t2\t3\t0\t0\t1\t1\t0\t0\ns 4 5 a/2\nP 0, 0, 1', entry);
  assert.deepEqual(joints, [
    { type: 'R', point: [0, 0, 0], axis: [0, 0, 1] },
    { type: 'T', point: [1, 2, 3], axis: [0, 0, 1], second: [1, 0, 0] },
    { type: 'S', point: [4, 5, 'a/2'] },
    { type: 'P', axis: [0, 0, 1] },
  ]);
  assert.deepEqual(readJoints('joint;x;y;z\nS;4;5;6', entry), { joints: [{ type: 'S', point: [4, 5, 6] }] });
  assert.match(readJoints('R 0 0 0 0 0 1\nQ 1 2 3', entry).fault, /^Line 2, “Q 1 2 3”, does not begin with the letter of a joint/);
  for (const text of ['1\t2\t3', '', 'joint\tx']) assert.equal(readJoints(text, entry), null);
  for (const text of ['R 0 0 0', 'R 0 0 0 0 0', 'T 0 0 0 0 0 1', 'R 0 0 0 0 0 1 1 0 0', 'R']) assert.match(readJoints(text, entry).fault, /^Line 1/, text);
  const doc = { chains: [{ joints: [{ type: 'S', point: [0, 0, 0] }], start: [1, 2, 3] }] };
  const [chain] = withJoints(doc, 0, 0, joints).chains;
  assert.equal(chain.joints.length, 4);
  assert.equal(chain.start, undefined);
});

test('a joint of another type keeps what that has a use for', () => {
  const joint = { type: 'R', point: [1, 2, 3], axis: [0, 0, 2], limits: [{ min: 0 }] };
  assert.deepEqual(asType(joint, 'S'), { type: 'S', point: [1, 2, 3], axis: [0, 0, 2] });
  const { second } = asType(joint, 'T');
  assert.equal(second[2], 0);
  assert.ok(Math.hypot(...second) > 0);
  for (const axis of [[1, 2, 3], [0, 1, 0], [-1, 0, 0]]) {
    const across = acrossOf(axis);
    assert.equal(axis.reduce((sum, value, i) => sum + value * across[i], 0), 0);
    assert.ok(Math.hypot(...across) > 0);
  }
});

test('a chain by axes becomes the rows that it stands for, also in radians; copies around an axis close at home', () => {
  const leg = { name: 'leg', joints: [{ type: 'R', point: [200, 0, 0], axis: [0, 1, 0], limits: [{ min: -1 }] }, { type: 'P', axis: [-100, 0, 500] }, { type: 'S', point: [100, 0, 500] }] };
  const doc = { version: 1, name: 'legs', angles: 'radians', length_unit: 'mm', home: { z: 500 }, chains: [leg], motion: { key_frames: [{ z: 500 }, { x: 30, z: 500 }], frames: 9 } };
  const three = turnedCopies(doc, 0, { count: 3, axis: 'z', point: [0, 0, 0] }, []);
  const motion = plan(three);
  assert.ok(motion.closure[0] < 1e-12 && Math.abs(motion.pose[2] - 500) < 1e-9);
  let rows = three;
  for (const chain of [0, 1, 2]) rows = intoRows(rows, chain, motion.plain.chains[chain]);
  assert.ok(rows.chains.every(({ joints, base }) => base && joints.every(({ rows: own, point }) => own && !point)));
  assert.deepEqual(rows.chains[0].joints[0].limits, [{ min: -1 }]);
  assert.ok(farthest(plan(rows).pose, motion.pose) < 1e-6);
  // In another unit of length.
  const metres = plan(convertLengths(three, 0.001, 'm'));
  assert.ok(farthest(Array.from(metres.pose, (value, i) => (i % 7 < 3 ? value * 1000 : value)), motion.pose) < 1e-5);
});

for (const name of ['scara.json', '3rps.json', '2tpr.json', 'bennett.json']) {
  test(`${name}: the table converted to the standard convention and back moves the same`, () => {
    const doc = sample(name);
    const before = plan(doc);
    const length = before.report.metric.length;
    const keep = (one) => ({ ...one, planner: { ...one.planner, metric_length: length } });
    const standard = keep({ ...doc, chains: doc.chains.map((chain) => converted(chain, chain, doc)) });
    assert.ok(standard.chains.every(({ convention }) => convention === 'standard'));
    const there = plan(standard);
    assert.ok(farthest(there.pose, before.pose) < 1e-6);
    const back = { ...standard, chains: standard.chains.map((chain, i) => converted(chain, there.plain.chains[i], doc)) };
    assert.ok(back.chains.every(({ convention }) => convention === undefined));
    assert.ok(farthest(plan(back).pose, before.pose) < 1e-6);
  });
}

test('expressions move with their links, and stay as typed', () => {
  const chain = { joints: [{ type: 'R', rows: [{ theta: 5 }] }, { type: 'R', rows: [{ alpha: 'tilt', a: 'l/2', d: 1 }] }], gripper: { x: 'tool' } };
  const standard = converted(chain, chain, {});
  assert.deepEqual(standard.joints.map(({ rows }) => rows[0]), [{ alpha: 'tilt', a: 'l/2', theta: 5 }, { d: 1 }]);
  assert.deepEqual(standard.gripper, { x: 'tool' });
  assert.deepEqual(converted(standard, chain, {}), chain);
});

test('a table as printed keeps its numbers; the copied Cobra 600 is right then', () => {
  const doc = JSON.parse(readFileSync(new URL('../field/cobra600-copied.json', import.meta.url), 'utf8'));
  const motion = plan(doc);
  assert.ok(beginsElsewhere(doc, motion));
  const session = Session.open(JSON.stringify(doc));
  assert.ok(session.looks_standard());
  session.free();
  const named = asPrinted(doc, [0], 'standard');
  const right = plan(named);
  assert.ok(!beginsElsewhere(named, right));
  for (const frame of [0, 16, 32]) assert.equal(right.report.statuses[right.status[frame]], 'reached');
  assert.deepEqual(asPrinted(named, [0], 'modified'), doc);
  for (const name of ['3rps.json', '2tpr.json', 'scara.json', 'four-bar.json', 'bennett.json']) assert.ok(!beginsElsewhere(sample(name), plan(sample(name))), name);
});

test('a rotation is the same in every form', () => {
  const turns = [[10, 20, 30], [-170, 85, 5], [90, 0, 90], [0, 90, 0], [180, 0, 0], [0, 0, 0], [33, -90, 12]].map((angles) => fromAngles(angles, 'xyz'));
  for (const turn of turns) {
    for (const doc of [{}, { angles: 'radians' }]) {
      for (const form of ['angles', 'quaternion_wxyz', 'quaternion_xyzw', 'matrix']) {
        const frame = frameWith({ x: 1, longitude: 3, name: 'a' }, turn, doc, { form });
        assert.equal(rotationForm(frame), form);
        assert.equal(frame.x, 1);
        assert.ok(farthest(turnOfFrame(frame, doc), turn) < 1e-9, `${form}: ${JSON.stringify(frame)}`);
      }
      for (const order of ORDERS) {
        const frame = frameWith({}, turn, doc, { form: 'roll_pitch_yaw', order });
        assert.ok(farthest(turnOfFrame(frame, doc), turn) < 1e-9, `${order}: ${JSON.stringify(frame)}`);
      }
    }
  }
  assert.equal(turnOfFrame({ quaternion_wxyz: [1, 0, 'a', 0] }, {}), null);
  // As scipy: about the fixed x by 90°, then about the fixed z by 90°, which is moving z, then moving x.
  assert.ok(farthest(fromAngles([90, 0, 90], 'xyz'), [0, 0, 1, 1, 0, 0, 0, 1, 0]) < 1e-12);
  assert.ok(farthest(fromAngles([90, 90, 0], 'ZXY'), fromAngles([90, 0, 90], 'xyz')) < 1e-12);
  assert.ok(farthest(toAngles([0.5, 0.5, 0.5, 0.5], 'xyz'), [90, 0, 90]) < 1e-9);
});

test('the forms mean to the planner what they mean to the page', () => {
  const turn = fromAngles([10, 20, 30], 'xyz');
  const document = (key) => ({ version: 1, chains: [{ joints: [{ type: 'S', rows: [{}, { alpha: 90 }, { alpha: -90 }] }] }], motion: { key_frames: [key, { roll: 5 }], frames: 2 } });
  const goal = plan(document(frameWith({}, turn, {}))).goal.slice(0, 7);
  const forms = [...['quaternion_wxyz', 'quaternion_xyzw', 'matrix'].map((form) => ({ form })), ...ORDERS.map((order) => ({ form: 'roll_pitch_yaw', order }))];
  for (const as of forms) assert.ok(farthest(plan(document(frameWith({}, turn, {}, as))).goal.slice(0, 7), goal) < 1e-9, JSON.stringify(as));
});

test('a number slides by steps of its kind', () => {
  const doc = { angles: 'radians', chains: [{ joints: [{ type: 'R', point: [350, 0, 0], axis: [0, 0, 1] }] }], motion: { key_frames: [{ roll_pitch_yaw: [0, 0, 1] }] } };
  assert.equal(stepOf(doc, 'chains[0].joints[0].axis[2]', 1), 0.1);
  assert.equal(stepOf(doc, 'motion.key_frames[0].roll_pitch_yaw[2]', 1), 0.01);
  assert.equal(stepOf({ ...doc, angles: 'degrees' }, 'motion.key_frames[0].roll_pitch_yaw[2]', 1), 1);
});

test('angles are converted to radians and back, or only read anew', () => {
  const doc = sample('3rps.json');
  const { doc: radians } = convertAngles(doc, 'radians');
  assert.equal(radians.angles, 'radians');
  assert.ok(farthest(plan(radians).pose, plan(doc).pose) < 1e-6);
  const { doc: back } = convertAngles(radians, 'degrees');
  assert.ok(farthest(back.chains.flatMap(({ start }) => start), doc.chains.flatMap(({ start }) => start)) < 1e-9);
  assert.deepEqual(reread(reread(doc, 'radians'), 'degrees'), doc);
  const slider = { chains: [{ joints: [{ type: 'C', rows: [{}], limits: [{ max: 180 }, { max: 90 }] }], start: [180, 3] }], motion: { key_frames: [{ roll_pitch_yaw: [180, 0, 90] }] } };
  const { doc: turned } = convertAngles(slider, 'radians');
  assert.ok(Math.abs(turned.chains[0].joints[0].limits[0].max - Math.PI) < 1e-14);
  assert.equal(turned.chains[0].joints[0].limits[1].max, 90);
  assert.equal(turned.chains[0].start[1], 3);
  assert.ok(Math.abs(turned.motion.key_frames[0].roll_pitch_yaw[2] - Math.PI / 2) < 1e-14);
  for (const part of [{ base: { longitude: 'tilt' } }, { base: { x: 'r*cos(30)' } }]) {
    assert.match(convertAngles({ ...doc, chains: [{ ...doc.chains[0], ...part }] }, 'radians').fault, /tilt|cos/);
  }
});

test('a key frame that is turned by hand keeps its form', async () => {
  const key = { x: 1, y: 0, z: 0, quaternion_wxyz: [1, 0, 0, 0] };
  const doc = { version: 1, chains: [], motion: { key_frames: [key, { x: 2 }] } };
  const plain = { ...doc, motion: { key_frames: [{ x: 1, y: 0, z: 0, longitude: 0, latitude: 0, roll: 0 }, { x: 2 }] } };
  const store = createStore(doc);
  store.setResult({ doc, plain });
  const target = keyFrameTarget({ store, player: {}, say: () => {} }, 0, () => 1);
  await new Promise((resolve) => setTimeout(resolve, 50));
  target.begin('nudge');
  for (const angle of [Math.PI / 6, Math.PI / 3]) {
    target.to([1, 0, 0, 0, 0, Math.sin(angle), Math.cos(angle)], true);
    const now = store.doc.motion.key_frames[0];
    assert.deepEqual(Object.keys(now).sort(), ['quaternion_wxyz', 'x', 'y', 'z']);
    assert.ok(farthest(now.quaternion_wxyz, [Math.cos(angle), 0, 0, Math.sin(angle)]) < 1e-4, JSON.stringify(now));
  }
  target.cancel();
  assert.deepEqual(store.doc.motion.key_frames[0], key);
  // One that is no more.
  assert.equal(keyFrameTarget({ store, player: {}, say: () => {} }, 7, () => 1).pose(), null);
});
