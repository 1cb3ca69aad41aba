/**
 * A chain's base: a foot on the ground with a post up to the base frame, and the frame's axes.
 */
import { BufferGeometry, CylinderGeometry, Float32BufferAttribute, Group, Mesh } from 'three';
import { frameMatrix } from '../../core/poses.js';
import { barrel, part } from './joint-shapes.js';
import { shared, triad } from './solids.js';

/** The soft shadow around a foot: how dark it is at which radius, in link radii; the foot's own is 4. */
const SOFT = [[3.6, 1], [4.2, 0.8], [5, 0.45], [6, 0.2], [7.2, 0.06], [8.6, 0]];
const SIDES = 32;

/** A flat ring whose corners grow fainter outwards. */
export const softRing = () => shared('soft ring', ring);

function ring() {
  const corners = SOFT.flatMap(([radius, dark]) => Array.from({ length: SIDES }, (_, i) => [radius, dark, (2 * Math.PI * i) / SIDES]));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(corners.flatMap(([radius, , angle]) => [radius * Math.cos(angle), radius * Math.sin(angle), 0.02]), 3));
  geometry.setAttribute('color', new Float32BufferAttribute(corners.flatMap(([, dark]) => [1, 1, 1, dark]), 4));
  geometry.setIndex(corners.slice(SIDES).flatMap((_, i) => {
    const next = i - (i % SIDES) + ((i + 1) % SIDES);
    return [i, i + SIDES, next, next, i + SIDES, next + SIDES];
  }));
  return geometry;
}

/**
 * @param {import('../../core/types.js').Frame | undefined} frame
 * @param {{link: import('three').Material, metal: import('three').Material, contact: import('three').Material, axes: import('three').Material[]}} materials
 * @param {number} r radius of a link
 */
export function createBase(frame, { link, metal, contact, axes }, r) {
  /** The base frame, to which the first link is fixed. */
  const seat = new Group();
  frameMatrix(frame).decompose(seat.position, seat.quaternion, seat.scale);
  const mark = triad(5 * r, axes);
  mark.position.copy(seat.position);
  mark.quaternion.copy(seat.quaternion);
  const foot = new Group();
  const post = part(shared('post', () => new CylinderGeometry(1.1, 1.7, 1, 28).rotateX(Math.PI / 2)), metal);
  foot.add(part(shared('foot', () => new CylinderGeometry(3.6, 4.0, 0.8, 40).rotateX(Math.PI / 2)), link, 0.4), post);
  foot.add(part(barrel(2.0, 0.5, 28), link, 1.0));
  const soft = new Mesh(softRing(), contact);
  soft.userData.faint = true;
  soft.raycast = () => {};
  foot.add(soft);
  foot.scale.setScalar(r);
  const group = new Group();
  group.add(foot, mark);
  return {
    group,
    seat,
    /** Stands it on the ground. @param {number} ground height */
    stand(ground) {
      const height = Math.max(seat.position.z - ground, r) / r;
      foot.position.set(seat.position.x, seat.position.y, ground);
      post.scale.z = height;
      post.position.z = height / 2;
    },
  };
}
