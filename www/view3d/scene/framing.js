/**
 * Where a camera must stand, and how much it must take in, so that points fill a given part of its picture: exact, for the
 * direction in which it looks.
 *
 * @typedef {{left: number, right: number, bottom: number, top: number}} Part of a picture, from −1 to 1 across and up
 */
import { OrthographicCamera, Vector3 } from 'three';
import { enclose } from './enclosing.js';

/**
 * Moves a camera along its own axes, and widens or narrows one without perspective, until the points are inside the part and
 * touch two opposite edges of it. The camera's shape (its aspect) is kept; without points nothing is done.
 * @param {import('three').PerspectiveCamera | OrthographicCamera} camera
 * @param {Iterable<Vector3>} points in the fixed frame
 * @param {Part} part
 */
export function frameWhole(camera, points, { left, right, bottom, top }) {
  const flat = camera instanceof OrthographicCamera;
  const aspect = camera.projectionMatrix.elements[5] / camera.projectionMatrix.elements[0];
  const up = flat ? 1 : 1 / camera.projectionMatrix.elements[5];
  const [x, y, z] = [0, 1, 2].map((axis) => new Vector3().setComponent(axis, 1).applyQuaternion(camera.quaternion));
  const edges = { left: -left * up * aspect, right: right * up * aspect, low: -bottom * up, high: top * up };
  const each = (/** @type {(point: Vector3) => void} */ visit) => {
    for (const point of points) visit(point);
  };
  const { across, above, distance, nearest } = enclose(each, camera.position, { right: x, up: y, back: z }, edges, flat);
  if (!(nearest > -Infinity)) return;
  camera.position.addScaledVector(x, across).addScaledVector(y, above);
  if (flat) {
    const half = distance || camera.top;
    Object.assign(camera, { zoom: 1, top: half, bottom: -half, right: half * aspect, left: -half * aspect });
  } else {
    camera.position.addScaledVector(z, distance);
    // What is nearest must not be cut off.
    camera.near = Math.min(camera.near, Math.max((distance - nearest) / 2, camera.far * 1e-6));
  }
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}
