/**
 * A tube along a column of poses, laid anew in place: the buffers are kept and only grow. Its points are counted from its
 * first one, where the mesh stands: the graphics card's numbers have 7 digits, too few far from the origin.
 */
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, Sphere, Vector3 } from 'three';
import { POSE } from '../../core/poses.js';
import { spreadOver } from '../../core/spread.js';

/** Corners of the tube's section. */
const SIDES = 7;

/** A curve with fewer frames is rounded between them, so many pieces to each. */
const SMOOTH_BELOW = 64;
const PIECES = 6;

/** Of a longer motion so many points are drawn, evenly spread: no screen shows more. */
const MOST = 20_000;

export class Tube {
  /** @type {Mesh<BufferGeometry>} */
  mesh;
  #capacity = 0;
  /** Points of the curve, 3 each. */
  #points = new Float64Array(0);

  /** @param {import('three').Material} material */
  constructor(material) {
    this.mesh = new Mesh(new BufferGeometry(), material);
  }

  /**
   * @param {Float64Array} column poses
   * @param {number} frames
   * @param {number} radius
   */
  lay(column, frames, radius) {
    const smooth = frames < SMOOTH_BELOW ? PIECES : 1;
    if (frames > MOST) [column, frames] = [thinned(column, frames), MOST];
    this.#reserve((frames - 1) * smooth + 1);
    this.mesh.position.fromArray(column);
    const count = spread(column, frames, smooth, radius * 0.1, this.#points);
    this.mesh.visible = count > 1;
    if (count > 1) this.#sweep(count, radius);
  }

  /** @param {number} count of points */
  #reserve(count) {
    if (count <= this.#capacity) return;
    this.#capacity = Math.ceil(count * 1.25);
    this.#points = new Float64Array(3 * this.#capacity);
    const { geometry } = this.mesh;
    geometry.dispose();
    for (const name of ['position', 'normal']) {
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * SIDES * this.#capacity), 3).setUsage(DynamicDrawUsage));
    }
    const corners = new Uint32Array(6 * SIDES * (this.#capacity - 1));
    for (let ring = 0, at = 0; ring + 1 < this.#capacity; ring++) {
      for (let side = 0; side < SIDES; side++) {
        const a = ring * SIDES + side;
        const b = ring * SIDES + ((side + 1) % SIDES);
        for (const corner of [a, b, a + SIDES, b, b + SIDES, a + SIDES]) corners[at++] = corner;
      }
    }
    geometry.setIndex(new BufferAttribute(corners, 1));
  }

  /** Rings around the points, turned as little as the curve allows from one to the next. @param {number} count @param {number} radius */
  #sweep(count, radius) {
    const { geometry } = this.mesh;
    const points = this.#points;
    const places = geometry.getAttribute('position');
    const normals = geometry.getAttribute('normal');
    const [place, normal] = [places.array, normals.array];
    const along = new Vector3();
    const side = new Vector3();
    const other = new Vector3();
    for (let ring = 0, at = 0; ring < count; ring++) {
      const from = 3 * Math.max(0, ring - 1);
      const to = 3 * Math.min(count - 1, ring + 1);
      along.set(points[to] - points[from], points[to + 1] - points[from + 1], points[to + 2] - points[from + 2]).normalize();
      side.addScaledVector(along, -side.dot(along));
      if (side.lengthSq() < 1e-12) side.copy(across(along)).cross(along);
      side.normalize();
      other.crossVectors(along, side);
      for (let corner = 0; corner < SIDES; corner++) {
        const angle = (2 * Math.PI * corner) / SIDES;
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        for (const axis of /** @type {const} */ (['x', 'y', 'z'])) {
          normal[at] = c * side[axis] + s * other[axis];
          place[at] = points[3 * ring + AXES[axis]] + radius * normal[at];
          at++;
        }
      }
    }
    places.needsUpdate = true;
    normals.needsUpdate = true;
    geometry.setDrawRange(0, 6 * SIDES * (count - 1));
    bound(geometry, points, count, radius);
  }
}

/** @param {Float64Array} column @param {number} frames */
function thinned(column, frames) {
  const some = new Float64Array(POSE * MOST);
  spreadOver(frames, MOST).forEach((frame, i) => some.set(column.subarray(POSE * frame, POSE * (frame + 1)), POSE * i));
  return some;
}

const AXES = { x: 0, y: 1, z: 2 };

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);

/** An axis that is far from a direction. @param {Vector3} along */
const across = ({ x }) => (Math.abs(x) < 0.6 ? X : Y);

/**
 * Writes the curve's points from its first one, without those that are almost the one before.
 * @param {Float64Array} column @param {number} frames @param {number} smooth pieces between two frames
 * @param {number} apart least distance @param {Float64Array} points
 * @returns {number} how many
 */
function spread(column, frames, smooth, apart, points) {
  let count = 0;
  const last = (frames - 1) * smooth;
  for (let i = 0; i <= last; i++) {
    const frame = Math.floor(i / smooth);
    const share = i / smooth - frame;
    let far = 0;
    for (let axis = 0; axis < 3; axis++) {
      const at = (/** @type {number} */ step) => column[POSE * Math.min(frames - 1, Math.max(0, frame + step)) + axis] - column[axis];
      const value = share === 0 ? at(0) : rounded(at(-1), at(0), at(1), at(2), share);
      points[3 * count + axis] = value;
      if (count > 0) far += (value - points[3 * count - 3 + axis]) ** 2;
    }
    if (count === 0 || far > apart * apart) count++;
  }
  return count;
}

/** A Catmull–Rom curve from b to c. @param {number} a @param {number} b @param {number} c @param {number} d @param {number} t */
const rounded = (a, b, c, d, t) => 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t * t * t);

/** @param {BufferGeometry} geometry @param {Float64Array} points @param {number} count @param {number} radius */
function bound(geometry, points, count, radius) {
  const sphere = (geometry.boundingSphere ??= new Sphere());
  const middle = (/** @type {number} */ axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < count; i++) {
      low = Math.min(low, points[3 * i + axis]);
      high = Math.max(high, points[3 * i + axis]);
    }
    return (low + high) / 2;
  };
  sphere.center.set(middle(0), middle(1), middle(2));
  let far = 0;
  for (let i = 0; i < count; i++) {
    far = Math.max(far, Math.hypot(points[3 * i] - sphere.center.x, points[3 * i + 1] - sphere.center.y, points[3 * i + 2] - sphere.center.z));
  }
  sphere.radius = far + radius;
}
