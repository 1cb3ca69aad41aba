// The view cube: which face, edge or corner is under a pointer, from any side.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Matrix4, Vector3 } from 'three';
import { sideAt } from '../../www/view3d/cube-hand.js';

/** A camera's matrix, looking at the origin from somewhere. */
const from = (x, y, z) => new Matrix4().lookAt(new Vector3(x, y, z), new Vector3(), new Vector3(0, 0, 1));

test('from the front: the face in its middle, edges and corners at its rim, nothing beside it', () => {
  const { elements } = from(0, -1, 0);
  assert.deepEqual(sideAt(0, 0, elements), [0, -1, 0]);
  assert.deepEqual(sideAt(0.9, 0, elements), [1, -1, 0]);
  assert.deepEqual(sideAt(0, -0.9, elements), [0, -1, -1]);
  assert.deepEqual(sideAt(-0.9, 0.9, elements), [-1, -1, 1]);
  assert.equal(sideAt(1.1, 0, elements), null);
  assert.equal(sideAt(0.5, -1.3, elements), null);
});

test('from anywhere: the middle of what is seen of a face, an edge or a corner is that', () => {
  for (const eye of [[1, -1.4, 0.8], [-2, 0.3, -1], [0.2, 1, 3], [-1, -1, -1]]) {
    const { elements } = from(...eye);
    const [right, up, back] = [0, 4, 8].map((at) => new Vector3().fromArray(elements, at));
    let seen = 0;
    for (const x of [-1, 0, 1]) {
      for (const y of [-1, 0, 1]) {
        for (const z of [-1, 0, 1]) {
          const side = new Vector3(x, y, z);
          // Of its faces at least one looks here, and no other of the cube lies before its middle.
          const faces = [x * back.x, y * back.y, z * back.z].filter((share) => share !== 0);
          if (!faces.length || Math.min(...faces) < 0.02) continue;
          seen++;
          const inside = side.clone().multiplyScalar(0.98);
          assert.deepEqual(sideAt(inside.dot(right), inside.dot(up), elements), [x, y, z], `${[x, y, z]} from ${eye}`);
        }
      }
    }
    assert.equal(seen, 7, 'three faces, three edges between them and their corner');
  }
});
