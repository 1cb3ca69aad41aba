/**
 * A chain's base: a foot on the ground with a post up to the base frame, and the frame's axes.
 */
import { CylinderGeometry, Group } from 'three';
import { frameMatrix } from '../../core/poses.js';
import { barrel, part } from './joint-shapes.js';
import { shared, triad } from './solids.js';

/**
 * @param {import('../../core/types.js').Frame | undefined} frame
 * @param {{link: import('three').Material, metal: import('three').Material, axes: import('three').Material[]}} materials
 * @param {number} r radius of a link
 */
export function createBase(frame, { link, metal, axes }, r) {
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
