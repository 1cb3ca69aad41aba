/**
 * Where a camera must stand, and how much it must take in, so that points fill a given part of its picture: exact, for the
 * direction in which it looks.
 *
 * @typedef {{left: number, right: number, bottom: number, top: number}} Part of a picture, from −1 to 1 across and up
 */
import { OrthographicCamera, Vector3 } from 'three';

/**
 * Moves a camera along its own axes, and widens or narrows one without perspective, until the points are inside the part and
 * touch two opposite edges of it. The camera's shape (its aspect) is kept; without points nothing is done.
 *
 * With perspective an edge of the part is a plane through the camera c, in its own axes, whose depth grows along −z:
 * x ≤ c_x + right·t·(c_z − z) for every point, where t is the slope of the picture's edge; the same on the other side. The
 * least c_z for which both can hold is (max(x + right·t·z) + max(−x − left·t·z)) ∕ ((right − left)·t).
 * @param {import('three').PerspectiveCamera | OrthographicCamera} camera
 * @param {Iterable<Vector3>} points in the fixed frame
 * @param {Part} part
 */
export function frameWhole(camera, points, { left, right, bottom, top }) {
  const back = camera.quaternion.clone().invert();
  const flat = camera instanceof OrthographicCamera;
  const [across, up] = flat ? [1, 1] : [1 / camera.projectionMatrix.elements[0], 1 / camera.projectionMatrix.elements[5]];
  /** Slopes of the four edges: how much farther a point may be from the axis for each unit of depth; none without perspective. */
  const [l, r, b, t] = flat ? [0, 0, 0, 0] : [-left * across, right * across, -bottom * up, top * up];
  const most = { l: -Infinity, r: -Infinity, b: -Infinity, t: -Infinity, near: -Infinity };
  const p = new Vector3();
  for (const point of points) {
    p.copy(point).applyQuaternion(back);
    most.l = Math.max(most.l, -p.x + l * p.z);
    most.r = Math.max(most.r, p.x + r * p.z);
    most.b = Math.max(most.b, -p.y + b * p.z);
    most.t = Math.max(most.t, p.y + t * p.z);
    most.near = Math.max(most.near, p.z);
  }
  if (!(most.near > -Infinity)) return;
  const place = camera.position.clone().applyQuaternion(back);
  if (flat) {
    // Half of what is seen across is the larger of what the points need across, and up times the aspect.
    const aspect = (camera.right - camera.left) / (camera.top - camera.bottom);
    const half = Math.max((most.l + most.r) / (right - left) / aspect, (most.b + most.t) / (top - bottom)) || camera.top;
    Object.assign(camera, { zoom: 1, top: half, bottom: -half, right: half * aspect, left: -half * aspect });
    place.x = (most.r - most.l) / 2 - ((right + left) / 2) * half * aspect;
    place.y = (most.t - most.b) / 2 - ((top + bottom) / 2) * half;
  } else {
    place.z = Math.max((most.l + most.r) / (l + r), (most.b + most.t) / (b + t));
    // In the middle between the nearest and the farthest that the two edges allow.
    place.x = (most.r - r * place.z + (l * place.z - most.l)) / 2;
    place.y = (most.t - t * place.z + (b * place.z - most.b)) / 2;
    // What is nearest must not be cut off.
    camera.near = Math.min(camera.near, Math.max((place.z - most.near) / 2, camera.far * 1e-6));
  }
  camera.position.copy(place.applyQuaternion(camera.quaternion));
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}
