// Flags in the 3D view stand beside what they name and cover neither it nor each other, however many there are, and stay.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxOn, layOut, leaderOf } from '../../www/view3d/scene/label-layout.js';

const ROOM = { x: 0, y: 0, width: 600, height: 400 };
const MIDDLE = { x: 300, y: 200 };
const name = (x, y, more = {}) => ({ x, y, width: 60, height: 17, clear: 12, rank: 0, kept: false, spot: -1, ...more });
const cover = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
const away = (one, box) => Math.hypot(Math.max(box.x - one.x, one.x - box.x - box.width, 0), Math.max(box.y - one.y, one.y - box.y - box.height, 0));

test('forty names of points that lie close: those that are shown cover no other and nothing that they name, at the ends of their leaders', () => {
  const names = Array.from({ length: 40 }, (_, i) => name(300 + 40 * Math.cos(i), 200 + 40 * Math.sin(i)));
  names[33] = name(names[0].x, names[0].y, { rank: 2, kept: true });
  const spots = layOut(names, [], ROOM, MIDDLE);
  const shown = names.flatMap((one, index) => (spots[index] < 0 ? [] : [boxOn(one, spots[index])]));
  assert.ok(spots[33] >= 0, 'the chosen one is shown');
  assert.ok(shown.length >= 6 && shown.length < 40, `${shown.length} of 40`);
  shown.forEach((box, i) => shown.slice(i + 1).forEach((other) => assert.ok(!cover(box, other))));
  names.forEach((one, index) => {
    if (spots[index] < 0) return;
    const gap = away(one, boxOn(one, spots[index]));
    assert.ok(gap > 12, `flag ${index} covers what it names: ${gap} px from its point`);
    assert.ok(Math.abs(gap - leaderOf(one, spots[index])) < 1, `its leader is ${leaderOf(one, spots[index])} px long, and the flag ${gap} px away`);
  });
});

test('a flag stands away from the middle of the scene, and clear of what stands over the view, of its neighbour’s thing, and inside', () => {
  const one = (x, y, others = []) => layOut([name(x, y)], others, ROOM, MIDDLE)[0];
  assert.equal(one(400, 200), 0, 'to the right');
  assert.equal(one(300, 300), 6, 'below');
  assert.notEqual(one(400, 200, [{ x: 410, y: 190, width: 100, height: 20 }]), 0, 'not over a handle');
  for (const [x, y] of [[595, 200], [3, 200], [300, 3], [300, 397], [597, 3]]) {
    const box = boxOn(name(x, y), one(x, y));
    assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= 600 && box.y + box.height <= 400, JSON.stringify(box));
  }
  const two = [name(400, 200), name(440, 200)];
  const spots = layOut(two, [], ROOM, MIDDLE);
  assert.ok(away(two[1], boxOn(two[0], spots[0])) > 5 && away(two[0], boxOn(two[1], spots[1])) > 5, 'no flag lies on the other thing');
  assert.equal(one(500, 200, [{ ...ROOM, x: 540 }]) === 0, false, 'not under what lies over the right of the view');
});

test('what is chosen is shown also where all is taken, and nothing else is', () => {
  const wall = [ROOM];
  assert.deepEqual(layOut([name(300, 300), name(300, 300, { rank: 2, kept: true })], wall, ROOM, MIDDLE), [-1, 6]);
});

test('flags that move do not jump: a side is kept until it is taken, and not taken back at the edge of it', () => {
  const moving = name(400, 200, { rank: 2, kept: true });
  const still = [name(460, 260), name(380, 300), name(200, 150)];
  let changes = 0;
  let shifts = 0;
  for (let i = 0; i < 2000; i++) {
    // Along a path and back, trembling by half a pixel, past the flags of what rests.
    const share = Math.abs(1 - i / 1000);
    Object.assign(moving, { x: 330 + 150 * share + 0.5 * Math.sin(i * 9), y: 140 + 150 * share + 0.5 * Math.cos(i * 7) });
    const all = [moving, ...still];
    layOut(all, [], ROOM, MIDDLE).forEach((spot, index) => {
      const one = all[index];
      if (i && spot !== one.spot) index ? shifts++ : changes++;
      one.spot = spot;
    });
    const boxes = all.filter(({ spot }) => spot >= 0).map((one) => boxOn(one, one.spot));
    boxes.forEach((box, at) => boxes.slice(at + 1).forEach((other) => assert.ok(!cover(box, other), `step ${i}`)));
  }
  assert.ok(changes + shifts <= 12, `${changes} and ${shifts} changes of a side in 2000 steps`);
});

test('names without leaders stand on their points, and are left out where one is', () => {
  const bare = [name(100, 100, { clear: -1, width: 20 }), name(105, 100, { clear: -1, width: 20 })];
  assert.deepEqual(layOut(bare, [], ROOM, MIDDLE), [0, -1]);
  assert.deepEqual(boxOn(bare[0], 0), { x: 90, y: 91.5, width: 20, height: 17 });
});
