// A camera is put where points fill a part of its picture: seen by projecting the points themselves.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { frameWhole } from '../../www/view3d/scene/framing.js';

/** Corners of a box about a middle. */
const box = (middle, half) => [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => new Vector3(x * half[0], y * half[1], z * half[2]).add(middle))));

const parts = [
  { left: -1, right: 1, bottom: -1, top: 1 },
  { left: -0.9, right: 0.9, bottom: -0.6, top: 0.95 },
  { left: -0.2, right: 0.9, bottom: -0.9, top: 0.9 },
];
const scenes = [
  ['metres at the origin', box(new Vector3(), [1, 2, 0.3])],
  ['millimetres', box(new Vector3(300, -20, 1100), [800, 150, 400])],
  ['far from the origin', box(new Vector3(1e4, -3e4, 2e4), [0.5, 0.2, 0.9])],
  ['one plane', box(new Vector3(1, 1, 0), [3, 1, 0])],
];

for (const [kind, make] of [
  ['perspective', (aspect) => new PerspectiveCamera(30, aspect, 0.01, 1e6)],
  ['parallel', (aspect) => new OrthographicCamera(-aspect, aspect, 1, -1, -1e6, 1e6)],
]) {
  test(`with ${kind} the points lie within the part and touch two opposite edges of it`, () => {
    for (const aspect of [0.5, 1, 1.9]) {
      for (const part of parts) {
        for (const [name, points] of scenes) {
          const camera = make(aspect);
          camera.up.set(0, 0, 1);
          camera.position.set(3, -5, 4);
          camera.lookAt(0.2, 0.1, -0.3);
          camera.updateProjectionMatrix();
          camera.updateMatrixWorld();
          const turned = camera.quaternion.clone();
          frameWhole(camera, points, part);
          assert.ok(camera.quaternion.angleTo(turned) < 1e-12, 'it looks in the same direction');
          const seen = points.map((point) => point.clone().project(camera));
          const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
          const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
          const said = `${name}, aspect ${aspect}: ${[left, right, bottom, top]} in ${Object.values(part)}`;
          const E = 1e-4; // of half a picture: the far scene has single places only in the matrices' sums
          assert.ok(left > part.left - E && right < part.right + E && bottom > part.bottom - E && top < part.top + E, said);
          const across = left < part.left + E && right > part.right - E;
          const up = bottom < part.bottom + E && top > part.top - E;
          assert.ok(across || up, said);
          assert.ok(seen.every(({ z }) => z > -1 && z < 1), 'in depth');
        }
      }
    }
  });
}

test('without points the camera stays', () => {
  const camera = new PerspectiveCamera(30, 1, 0.01, 100);
  camera.position.set(1, 2, 3);
  frameWhole(camera, [], parts[0]);
  assert.deepEqual(camera.position.toArray(), [1, 2, 3]);
});
