// Every user action as a function from document to document.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as edits from '../../www/core/edits.js';
import * as keyFrames from '../../www/core/key-frame-edits.js';

const revolute = () => ({ type: 'R', rows: [{ alpha: 0, a: 1, theta: 0, d: 0 }] });
const mechanism = () => ({
  version: 1,
  chains: [
    { name: 'chain 1', joints: [revolute(), { type: 'C', rows: [{}] }], start: [1, 2, 3] },
    { name: 'chain 2', joints: [revolute()] },
  ],
  motion: { key_frames: [{ name: 'a', x: 1 }, { name: 'b' }] },
});

/** The action leaves the old document as it was. */
function unharmed(act) {
  const doc = mechanism();
  const before = JSON.stringify(doc);
  const next = act(doc);
  assert.equal(JSON.stringify(doc), before);
  return next;
}

test('an entry is a number if it reads as one, else the text itself', () => {
  for (const [text, value] of [['1', 1], [' -2.5e3 ', -2500], ['.5', 0.5], ['−90', -90], ['+4.', 4]]) assert.equal(edits.entry(text), value);
  for (const text of ['abc', '', '1e999', '1,5', '0x10', '--1', 'Infinity', 'NaN', '-']) assert.equal(edits.entry(text), text);
});

test('a number is set in its place', () => {
  const next = unharmed((d) => edits.setValue(d, 'chains[0].joints[0].rows[0].a', 2));
  assert.equal(next.chains[0].joints[0].rows[0].a, 2);
});

test('joints are replaced, added and removed, and the start values that belonged to the old ones go', () => {
  const prismatic = { type: 'P', rows: [{}] };
  assert.deepEqual(unharmed((d) => edits.setJoint(d, 0, 1, prismatic)).chains[0], { name: 'chain 1', joints: [revolute(), prismatic] });
  assert.deepEqual(unharmed((d) => edits.insertJoint(d, 1, 1, prismatic)).chains[1].joints, [revolute(), prismatic]);
  assert.deepEqual(unharmed((d) => edits.removeJoint(d, 0, 0)).chains[0], { name: 'chain 1', joints: [{ type: 'C', rows: [{}] }] });
});

test('a chain gets other joints between its own base and gripper', () => {
  const { joints, start, name } = unharmed((d) => edits.setJoints(d, 0, [revolute(), revolute()])).chains[0];
  assert.deepEqual([joints.map((joint) => joint.type), start, name], [['R', 'R'], undefined, 'chain 1']);
});

test('a chain gets another type: joints that keep their place keep their rows, the others are new', () => {
  const joint = (type, mark) => ({ type, rows: [{ a: mark }] });
  const fresh = Object.fromEntries(Array.from('RPCTSE', (letter) => [letter, joint(letter, 'new')]));
  const doc = { version: 1, chains: [{ name: 'leg', base: { x: 1 }, joints: [joint('R', 1), joint('P', 2), joint('S', 3)], start: [1, 2, 3, 4, 5] }], motion: { key_frames: [] } };
  const typed = (text) => edits.setChainType(doc, 0, Array.from(text), fresh).chains[0];
  const told = (text) => typed(text).joints.map(({ type, rows }) => type + rows[0].a).join(' ');
  assert.equal(told('RRPS'), 'R1 Rnew P2 S3');
  assert.equal(told('PS'), 'P2 S3');
  assert.equal(told('RRS'), 'R1 Rnew S3');
  assert.equal(told('SPR'), 'Snew P2 Rnew');
  assert.equal(told('TS'), 'Tnew S3');
  assert.equal(told('RPSR'), 'R1 P2 S3 Rnew');
  assert.equal(told('RPR'), 'R1 P2 Rnew');
  assert.deepEqual([typed('PS').base, typed('PS').name, typed('PS').start], [{ x: 1 }, 'leg', undefined]);
  assert.equal(edits.setChainType(doc, 0, ['R', 'P', 'S'], fresh), doc, 'the same type is no edit');
});

test('chains are added, duplicated and removed under names of their own', () => {
  const names = (d) => d.chains.map((chain) => chain.name);
  assert.deepEqual(names(unharmed((d) => edits.addChain(d, { joints: [revolute()] }))), ['chain 1', 'chain 2', 'chain 3']);
  assert.deepEqual(names(unharmed((d) => edits.duplicateChain(d, 0))), ['chain 1', 'chain 3', 'chain 2']);
  assert.deepEqual(names(unharmed((d) => edits.removeChain(d, 0))), ['chain 2']);
  assert.deepEqual(names(edits.addChain(edits.removeChain(mechanism(), 0), {})), ['chain 2', 'chain 3']);
});

test('joints, chains and key frames are put in another order', () => {
  const prismatic = { type: 'P', rows: [{}] };
  const types = (d) => d.chains[0].joints.map((joint) => joint.type).join('');
  const first = unharmed((d) => edits.insertJoint(d, 0, 0, prismatic));
  assert.equal(types(first), 'PRC');
  assert.equal(types(edits.moveJoint(first, 0, 0, 2)), 'RCP');
  assert.equal('start' in edits.moveJoint(mechanism(), 0, 0, 1).chains[0], false, 'start values belonged to the old order');
  assert.deepEqual(unharmed((d) => edits.moveChain(d, 0, 1)).chains.map((chain) => chain.name), ['chain 2', 'chain 1']);
  const keys = (d) => d.motion.key_frames.map(({ name, time }) => [name, time]);
  assert.deepEqual(keys(unharmed((d) => keyFrames.moveKeyFrame(d, 1, 0))), [['b', undefined], ['a', undefined]]);
  const timed = keyFrames.setTime(mechanism(), 1, 4);
  assert.deepEqual(keys(keyFrames.moveKeyFrame(timed, 1, 0)), [['b', 0], ['a', 4]], 'the times stay where they are');
  assert.deepEqual(keys(keyFrames.addKeyFrame(timed, {}, 1)), [['a', 0], ['key 3', 2], ['b', 4]]);
});

test('one start value brings the others in use with it', () => {
  assert.deepEqual(unharmed((d) => edits.setStart(d, 1, 0, 5, [4])).chains[1].start, [5]);
  assert.deepEqual(unharmed((d) => edits.setStart(d, 0, 1, 'abc', [7, 8, 9])).chains[0].start, [1, 'abc', 3]);
  assert.deepEqual(unharmed((d) => edits.takeStarts(d, [{ start: [9, 9, 9] }, { start: [8] }])).chains.map((c) => c.start), [[9, 9, 9], [8]]);
  assert.equal('start' in unharmed((d) => edits.clearStart(d, 0)).chains[0], false);
});

test('a limit is set and opened again', () => {
  const at = { chain: 0, joint: 1, freedom: 1, freedoms: 2 };
  const closed = unharmed((d) => edits.setLimit(d, at, 'min', -1));
  assert.deepEqual(closed.chains[0].joints[1].limits, [null, { min: -1 }]);
  const both = edits.setLimit(closed, at, 'max', 2);
  assert.deepEqual(both.chains[0].joints[1].limits, [null, { min: -1, max: 2 }]);
  const open = edits.setLimit(edits.setLimit(both, at, 'min', undefined), at, 'max', undefined);
  assert.equal('limits' in open.chains[0].joints[1], false);
});

test('key frames are added, duplicated and removed', () => {
  const names = (d) => d.motion.key_frames.map((key) => key.name);
  assert.deepEqual(names(unharmed((d) => keyFrames.addKeyFrame(d, { x: 2 }))), ['a', 'b', 'key 3']);
  assert.deepEqual(names(unharmed((d) => keyFrames.duplicateKeyFrame(d, 0))), ['a', 'key 3', 'b']);
  assert.deepEqual(names(unharmed((d) => keyFrames.removeKeyFrame(d, 0))), ['b']);
});

test('all key frames have a time or none', () => {
  const times = (d) => d.motion.key_frames.map((key) => key.time);
  const timed = unharmed((d) => keyFrames.setTime(d, 1, 4));
  assert.deepEqual(times(timed), [0, 4]);
  assert.deepEqual(times(keyFrames.setTime(mechanism(), 0, 4)), [4, 5]);
  assert.deepEqual(times(keyFrames.setTime(mechanism(), 0, 'abc')), ['abc', 1]);
  assert.deepEqual(times(keyFrames.duplicateKeyFrame(timed, 0)), [0, 2, 4]);
  assert.deepEqual(times(keyFrames.addKeyFrame(timed, {})), [0, 4, 5]);
  assert.deepEqual(times(keyFrames.setTime(timed, 0, undefined)), [undefined, undefined]);
  assert.deepEqual(times(keyFrames.addKeyFrame(mechanism(), {})), [undefined, undefined, undefined]);
});

test('a point is given whole or not at all', () => {
  const before = mechanism();
  const one = edits.setCoordinate(before, 'motion.reference', 1, 5, [1, 2, 3]);
  assert.deepEqual(one.motion.reference, [1, 5, 3]);
  const two = edits.setCoordinate(one, 'motion.reference', 0, '-', [7, 7, 7]);
  assert.deepEqual(two.motion.reference, ['-', 5, 3]);
  assert.ok(!('reference' in edits.setCoordinate(two, 'motion.reference', 2, undefined, [1, 2, 3]).motion));
  const none = { ...before, motion: { ...before.motion, reference: null } };
  assert.deepEqual(edits.setCoordinate(none, 'motion.reference', 2, 0, [1, 2, 3]).motion.reference, [1, 2, 0]);
  assert.equal(before.motion.reference, undefined);
});
