// The part of the view that nothing lies over, and the camera that shows points in it as large as can be.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { enclose, filled } from '../../www/view3d/scene/enclosing.js';
import { freeRectangle } from '../../www/view3d/scene/free-rectangle.js';

const box = (x, y, width, height) => ({ x, y, width, height });
const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

test('the free part lies clear of every box, and gives way where that costs least', () => {
  const room = box(0, 0, 700, 450);
  assert.deepEqual(freeRectangle(room, []), room);
  assert.deepEqual(freeRectangle(room, [box(400, 0, 300, 50)]), box(0, 50, 700, 400), 'under a bar');
  assert.deepEqual(freeRectangle(box(0, 0, 600, 100), [box(300, 0, 300, 50)]), box(0, 0, 300, 100), 'beside it in a low view');
  const boxes = [box(400, 0, 300, 50), box(0, 420, 500, 30), box(620, 60, 80, 80), box(0, 60, 200, 40)];
  const free = freeRectangle(room, boxes);
  for (const one of boxes) assert.ok(!overlap(free, one), JSON.stringify([free, one]));
  assert.ok(free.width * free.height > 0.5 * 700 * 450, JSON.stringify(free));
  // A handle at the edge of a high view: nearly all of its height is worth more than the handle's width.
  assert.deepEqual(freeRectangle(box(0, 0, 470, 1000), [box(0, 470, 30, 60)]), box(30, 0, 440, 1000));
});

/** Shares of the free part where a point is seen, from −1 to 1 across and up. */
function seen(point, { across, above, distance }, from, { right, up, back }, { left, high }, flat) {
  const at = point.clone().sub(from);
  const depth = flat ? distance : distance - at.dot(back);
  return [(at.dot(right) - across) / depth / left, (at.dot(up) - above) / depth / high];
}

test('all points are in view with their balls, two at its edges, from any side, in any unit and far from the origin', () => {
  for (const [unit, far] of [[1, 0], [1000, 0], [1, 1e4]]) {
    for (const flat of [false, true]) {
      for (const [around, down] of [[0.6, 1.1], [0, 1e-4], [-2, 2.4]]) {
        const centre = new Vector3(far, -far, 2 * unit);
        const points = Array.from({ length: 50 }, (_, i) => centre.clone().add(new Vector3(Math.sin(3 * i), Math.cos(5 * i) * 0.4, Math.sin(7 * i) * 0.7 + 0.3).multiplyScalar(unit)));
        const back = new Vector3(Math.sin(down) * Math.sin(around), -Math.sin(down) * Math.cos(around), Math.cos(down));
        const right = new Vector3(Math.cos(around), Math.sin(around), 0);
        const axes = { right, up: back.clone().cross(right), back };
        const edges = { left: 0.31, right: 0.31, low: 0.22, high: 0.22 };
        const each = (visit) => points.forEach(visit);
        const frame = enclose(each, centre, axes, edges, flat);
        const shares = points.flatMap((point) => seen(point, frame, centre, axes, edges, flat));
        assert.ok(Math.abs(Math.max(...shares) - 1) < 1e-9 && Math.abs(Math.min(...shares) + 1) < 1e-9, `${[unit, far, flat, around]}`);
        const middle = centre.clone().addScaledVector(axes.right, frame.across).addScaledVector(axes.up, frame.above);
        const uses = filled(each, middle, axes, edges, frame.distance, flat, 0);
        for (const side of [0, 1]) {
          const most = Math.max(...points.map((point) => Math.abs(seen(point, frame, centre, axes, edges, flat)[side])));
          assert.ok(Math.abs(uses[side] - most) < 1e-6, `fills ${uses[side]} and not ${most}`);
        }
        const radius = 0.2 * unit;
        const roomy = enclose(each, centre, axes, edges, flat, radius);
        for (const point of points) {
          for (let i = 0; i < 40; i++) {
            const on = new Vector3(Math.sin(i), Math.cos(2 * i), Math.sin(5 * i)).setLength(radius).add(point);
            for (const share of seen(on, roomy, centre, axes, edges, flat)) assert.ok(Math.abs(share) <= 1 + 1e-9, `${share}`);
          }
        }
      }
    }
  }
});
