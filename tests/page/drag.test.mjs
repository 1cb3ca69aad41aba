// Moving by hand: round steps, and poses moved along screws.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { keyFrameTarget } from '../../www/view3d/hand/key-frame.js';
import { movePoint, movePose } from '../../www/view3d/hand/screws.js';
import { lengthDigits, lengthStep, rounded } from '../../www/view3d/hand/steps.js';

const near = (a, b, tolerance = 1e-12) => Array.from(a).forEach((value, i) => assert.ok(Math.abs(value - b[i]) < tolerance, `${i}: ${value} is not ${b[i]}`));

test('steps are 1, 2 or 5 times a power of ten, near a twentieth of the scene', () => {
  assert.deepEqual([0.2, 1, 2, 3, 10, 41, 1500].map(lengthStep), [0.01, 0.05, 0.1, 0.2, 0.5, 2, 100]);
});

test('numbers that a hand leaves are short and never −0', () => {
  assert.equal(rounded(0.1 + 0.2, lengthDigits(2)), 0.3);
  assert.ok(Object.is(rounded(-1e-9, 4), 0));
});

test('a pure shift, a turn about a far axis, and a screw', () => {
  near(movePose([1, 2, 3, 0, 0, 0, 1], [0, 0, 1, 0, 0, 0], 0.5), [1, 2, 3.5, 0, 0, 0, 1]);
  // About the z axis through (0, 0): at (1, 0) that is v = (0, 1, 0).
  const half = Math.SQRT1_2;
  near(movePose([1, 0, 0, 0, 0, 0, 1], [0, 1, 0, 0, 0, 1], Math.PI / 2), [0, 1, 0, 0, 0, half, half]);
  // The same with a pitch of 2 a radian.
  near(movePose([1, 0, 0, 0, 0, 0, 1], [0, 1, 2, 0, 0, 1], Math.PI / 2), [0, 1, Math.PI, 0, 0, half, half]);
});

test('a small step follows the twist', () => {
  const pose = [0.3, -0.2, 0.9, 0, 0, 0, 1];
  const twist = [0.4, -0.1, 0.2, 0.6, 0, 0.8];
  const s = 1e-6;
  const moved = movePose(pose, twist, s);
  near([0, 1, 2].map((i) => (moved[i] - pose[i]) / s), twist.slice(0, 3), 1e-5);
  const point = new Vector3(1, 1, 1);
  const [v, w, arm] = [new Vector3(...twist.slice(0, 3)), new Vector3(...twist.slice(3)), new Vector3(0.7, 1.2, 0.1)];
  const velocity = w.cross(arm).add(v).toArray();
  const after = movePoint({ twist, origin: pose }, s, point.clone()).sub(point).divideScalar(s);
  near(after.toArray(), velocity, 1e-5);
});

test('a key frame with a text that is no number cannot be moved: a move would write 0 in its place', () => {
  const key_frames = [{ x: 1, z: 'abc' }, { x: 1, z: 2 }];
  const app = { store: { doc: { motion: { key_frames } }, result: { doc: null, plain: null } }, player: {} };
  const [faulty, whole, none] = [0, 1, 2].map((index) => keyFrameTarget(app, index, () => 1));
  assert.equal(faulty.pose(), null);
  near(whole.pose(), [1, 0, 2, 0, 0, 0, 1]);
  assert.equal(none.pose(), null);
});
