// Names in the 3D view stay beside their points, however many there are.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { layOut, offsetOn } from '../../www/view3d/scene/label-layout.js';

const ROOM = { width: 600, height: 400 };
const name = (x, y, more = {}) => ({ x, y, width: 60, height: 17, left: 8, top: -22, rank: 0, kept: false, ...more });
const boxOf = (one, side) => {
  const [right, down] = offsetOn(one, side);
  return { x: one.x + right, y: one.y + down, width: one.width, height: one.height };
};
const cover = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

test('forty names of points that lie close: those that are shown cover none and stand at their points', () => {
  const names = Array.from({ length: 40 }, (_, i) => name(300 + 40 * Math.cos(i), 200 + 40 * Math.sin(i)));
  names[33] = name(names[0].x, names[0].y, { rank: 2, kept: true });
  const sides = layOut(names, [], ROOM);
  const shown = names.flatMap((one, index) => (sides[index] < 0 ? [] : [boxOf(one, sides[index])]));
  assert.ok(sides[33] >= 0, 'the chosen one is shown');
  assert.ok(shown.length >= 6 && shown.length < 40, `${shown.length} of 40`);
  shown.forEach((box, i) => shown.slice(i + 1).forEach((other) => assert.ok(!cover(box, other))));
  names.forEach((one, index) => {
    if (sides[index] < 0) return;
    const box = boxOf(one, sides[index]);
    const gap = Math.hypot(Math.max(box.x - one.x, one.x - box.x - box.width, 0), Math.max(box.y - one.y, one.y - box.y - box.height, 0));
    assert.ok(gap < 10, `name ${index} is ${gap} px from its point`);
  });
});

test('a name keeps clear of what stands over the view, and inside it', () => {
  const [side] = layOut([name(300, 200)], [{ x: 310, y: 180, width: 10, height: 10 }], ROOM);
  assert.equal(side, 1, 'below it');
  assert.equal(layOut([name(590, 200)], [], ROOM)[0], 2, 'left of its point at the right edge');
  assert.equal(layOut([name(300, 3)], [], ROOM)[0], 1, 'below its point at the top');
});

test('what is chosen is shown also where all its sides are taken, and nothing else is', () => {
  const wall = [{ x: 0, y: 0, ...ROOM }];
  assert.deepEqual(layOut([name(300, 200), name(300, 200, { rank: 2, kept: true })], wall, ROOM), [-1, 0]);
});
