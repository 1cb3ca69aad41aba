/**
 * How the six joints look. R: barrel and pin. P: square sleeve and rod. C: round sleeve and rod.
 * T: cross in a ring. S: ball in a socket. E: plate and puck.
 *
 * Each has a part fixed to the link before it, at the seat of the joint's first row, and a part fixed to the link
 * after it, at the moved frame of its last row; z is the joint's axis in both.
 */
import { BoxGeometry, CylinderGeometry, Group, Mesh, SphereGeometry, TorusGeometry } from 'three';

/**
 * @typedef {import('three').Material} Material
 * @typedef {{link: Material, metal: Material, dark: Material}} Materials
 * @typedef {{low: number, high: number}} Travel how far a row slides along its axis over the motion
 * @typedef {object} JointShape
 * @property {Group} fixed
 * @property {Group} moved
 * @property {Group} [cross] T: at the seat of the second row, which carries both axes (z and y)
 * @property {Mesh} [plate] E: turned as the seat of the second row, whose x is the plane's normal
 * @property {{mesh: Mesh, before: number, after: number}} [slide] P and C: a rod of unit length along z that reaches
 *   from the seat to the moved frame, and so far beyond them
 */

/** A cylinder along z. @param {number} radius @param {number} length @param {number} [segments] */
export const barrel = (radius, length, segments = 24) => new CylinderGeometry(radius, radius, length, segments).rotateX(Math.PI / 2);

/** @param {import('three').BufferGeometry} geometry @param {Material} material @param {number} [z] */
export function part(geometry, material, z = 0) {
  const mesh = new Mesh(geometry, material);
  mesh.position.z = z;
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

/** @param {number} width @param {number} length along z */
const square = (width, length) => new BoxGeometry(width, width, length);

/**
 * @param {import('../types.js').JointType} type
 * @param {number} r the radius of a link; everything else is in proportion
 * @param {Materials} materials
 * @param {Travel[]} travel row by row; for an E joint it includes 0, where the link before it ends
 * @returns {JointShape}
 */
export function jointShape(type, r, { link, metal, dark }, travel) {
  const fixed = new Group();
  const moved = new Group();
  switch (type) {
    case 'R':
      fixed.add(part(barrel(1.9 * r, 3.4 * r), link));
      moved.add(
        part(barrel(1.0 * r, 4.6 * r), dark),
        part(barrel(1.4 * r, 0.5 * r), metal, 2.1 * r),
        part(barrel(1.4 * r, 0.5 * r), metal, -2.1 * r),
      );
      return { fixed, moved };
    case 'P': {
      const [from, to] = sleeve(travel[0], 1.7 * r, 4.5 * r);
      fixed.add(part(square(2.9 * r, to - from), link, (from + to) / 2));
      for (const end of [from, to]) fixed.add(part(square(3.4 * r, 0.6 * r), metal, end));
      moved.add(part(square(2.3 * r, 2.3 * r), metal));
      return { fixed, moved, slide: { mesh: part(square(1.7 * r, 1), dark), before: 0, after: 0 } };
    }
    case 'C': {
      fixed.add(part(barrel(1.8 * r, 5.2 * r), link));
      for (const side of [-1, 1]) fixed.add(part(barrel(2.15 * r, 0.6 * r), metal, side * 2.5 * r));
      moved.add(part(barrel(1.5 * r, 1.2 * r), metal));
      return { fixed, moved, slide: { mesh: part(barrel(0.95 * r, 1), dark), before: 5 * r, after: 1.6 * r } };
    }
    case 'T': {
      const cross = new Group();
      for (const arm of [fixed, cross]) {
        arm.add(part(barrel(0.75 * r, 5.4 * r), dark));
        for (const side of [-1, 1]) arm.add(part(barrel(1.2 * r, 0.8 * r), metal, side * 2.75 * r));
      }
      const ring = part(new TorusGeometry(2.75 * r, 0.45 * r, 10, 44), link);
      ring.rotation.y = Math.PI / 2;
      cross.add(ring);
      moved.add(part(new SphereGeometry(1.3 * r, 24, 16), link));
      return { fixed, moved, cross };
    }
    case 'S': {
      const socket = part(new SphereGeometry(2.3 * r, 28, 12, 0, 2 * Math.PI, 0, 0.55 * Math.PI), link);
      socket.rotation.x = -Math.PI / 2;
      fixed.add(socket, part(new TorusGeometry(2.24 * r, 0.2 * r, 8, 36), metal, 0.36 * r));
      moved.add(part(new SphereGeometry(1.95 * r, 26, 16), dark));
      return { fixed, moved };
    }
    case 'E': {
      const [along, across] = travel.map(({ low, high }) => high - low + 8 * r);
      const plate = part(new BoxGeometry(0.6 * r, along, across), link);
      moved.add(part(barrel(2.4 * r, 1.6 * r), metal), part(barrel(1.0 * r, 3.6 * r), dark));
      return { fixed, moved, plate };
    }
  }
}

/**
 * Where a slider's sleeve lies along the axis: around the seat, and on towards the rod's end as far as that never
 * comes, so that a leg looks like a telescope.
 * @param {Travel} travel
 * @param {number} half
 * @param {number} clear
 * @returns {[number, number]}
 */
function sleeve({ low, high }, half, clear) {
  if (low > 0) return [-half, Math.max(half, low - clear)];
  if (high < 0) return [Math.min(-half, high + clear), half];
  return [-half, half];
}
