/**
 * How the six joints look, after Table 1. R: barrel and pin. P: square sleeve and rod. C: round sleeve and rod.
 * T: cross in a ring. S: ball in a socket. E: puck on a plate.
 *
 * Each has a part fixed to the link before it, at the seat of the joint's first row, and a part fixed to the link
 * after it, at the moved frame of its last row; z is the joint's axis in both. Parts are made in link radii.
 */
import { BoxGeometry, CylinderGeometry, Group, Mesh, SphereGeometry, TorusGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { shared, solid } from './solids.js';

/**
 * @typedef {import('three').Material} Material
 * @typedef {{link: Material, metal: Material, dark: Material}} Materials
 * @typedef {{low: number, high: number}} Travel how far a row slides along its axis over the motion
 * @typedef {object} JointShape
 * @property {Group} fixed
 * @property {Group} moved
 * @property {Group} [cross] T: at the seat of the second row, which carries both axes (z and y)
 * @property {Mesh} [plate] E: turned as the seat of the second row, whose x is the plane's normal
 * @property {Group} [puck] E: lies on the plate, at the seat of the last row
 * @property {{mesh: Mesh, before: number, after: number}} [slide] P and C: a rod of unit length along z that reaches
 *   from the seat to the moved frame, and so far beyond them
 * @property {(travel: Travel[]) => void} [fit] P and E: takes the size that the motion asks for
 */

/** A cylinder along z. @param {number} radius @param {number} length @param {number} [segments] */
export const barrel = (radius, length, segments = 24) =>
  shared(`barrel ${radius} ${length} ${segments}`, () => new CylinderGeometry(radius, radius, length, segments).rotateX(Math.PI / 2));

/** Of edge 1. */
export const cube = () => shared('cube', () => new BoxGeometry(1, 1, 1));
/** @param {number} radius */
const ball = (radius) => shared(`ball ${radius}`, () => new SphereGeometry(radius, 28, 18));
/** @param {number} radius @param {number} tube */
const ring = (radius, tube) => shared(`ring ${radius} ${tube}`, () => new TorusGeometry(radius, tube, 10, 44));
/** Open, so that it has an inside too. */
const cup = () =>
  shared('cup', () => {
    const outside = new SphereGeometry(2.3, 28, 12, 0, 2 * Math.PI, 0, 0.55 * Math.PI).rotateX(-Math.PI / 2);
    const inside = outside.clone();
    inside.getIndex()?.array.reverse();
    const normals = inside.getAttribute('normal').array;
    for (let i = 0; i < normals.length; i++) normals[i] *= -1;
    return mergeGeometries([outside, inside]);
  });

/** @param {import('three').BufferGeometry} geometry @param {Material} material @param {number} [z] */
export function part(geometry, material, z = 0) {
  const mesh = solid(new Mesh(geometry, material));
  mesh.position.z = z;
  return mesh;
}

/** @param {Material} material @param {number} width @param {number} length @param {number} [z] */
function bar(material, width, length, z = 0) {
  const mesh = part(cube(), material, z);
  mesh.scale.set(width, width, length);
  return mesh;
}

/** A part along z laid along x instead. @param {Mesh} mesh @param {number} x */
function across(mesh, x) {
  mesh.rotation.y = Math.PI / 2;
  mesh.position.x = x;
  return mesh;
}

/** Parts drawn in link radii, in a group drawn in lengths. @param {number} r @param {...Mesh} parts */
function scaled(r, ...parts) {
  const inner = new Group();
  inner.scale.setScalar(r);
  if (parts.length) inner.add(...parts);
  return new Group().add(inner);
}

/**
 * @param {import('../../core/types.js').JointType} type
 * @param {number} r the radius of a link; everything else is in proportion
 * @param {Materials} materials
 * @returns {JointShape}
 */
export function jointShape(type, r, { link, metal, dark }) {
  switch (type) {
    case 'R':
      return {
        fixed: scaled(r, part(barrel(1.9, 3.4), link)),
        moved: scaled(r, part(barrel(1.0, 4.6), dark), part(barrel(1.4, 0.5), metal, 2.1), part(barrel(1.4, 0.5), metal, -2.1)),
      };
    case 'P': {
      const sleeve = bar(link, 2.9, 1);
      const collars = [bar(metal, 3.4, 0.6), bar(metal, 3.4, 0.6)];
      return {
        fixed: scaled(r, sleeve, ...collars),
        moved: scaled(r, bar(metal, 2.3, 2.3)),
        slide: { mesh: bar(dark, 1.7 * r, 1), before: 0, after: 0 },
        fit([travel]) {
          const [from, to] = reach(travel, 1.7 * r, 4.5 * r).map((end) => end / r);
          sleeve.scale.z = to - from;
          sleeve.position.z = (from + to) / 2;
          collars[0].position.z = from;
          collars[1].position.z = to;
        },
      };
    }
    case 'C': {
      const rod = part(barrel(0.95, 1), dark);
      rod.scale.set(r, r, 1);
      return {
        fixed: scaled(r, part(barrel(1.8, 5.2), link), ...[-1, 1].map((side) => part(barrel(2.15, 0.6), metal, side * 2.5))),
        // The pin shows how the rod turns.
        moved: scaled(r, part(barrel(1.5, 1.2), metal), across(part(barrel(0.4, 1.6), dark), 1.9)),
        slide: { mesh: rod, before: 5 * r, after: 1.6 * r },
      };
    }
    case 'T': {
      const arm = () => [part(barrel(0.75, 5.4), dark), ...[-1, 1].map((side) => part(barrel(1.2, 1.1), metal, side * 2.75))];
      const hoop = part(ring(2.75, 0.45), link);
      hoop.rotation.y = Math.PI / 2;
      return { fixed: scaled(r, ...arm()), cross: scaled(r, ...arm(), hoop), moved: scaled(r, part(ball(1.3), link)) };
    }
    case 'S':
      return {
        fixed: scaled(r, part(cup(), link), part(ring(2.24, 0.2), metal, 0.36)),
        moved: scaled(r, part(ball(1.95), dark)),
      };
    case 'E': {
      const plate = part(cube(), link);
      const puck = scaled(r, part(barrel(2.4, 1.4), metal, 0.7), part(barrel(1.0, 1.2), dark, 1.8));
      return {
        fixed: new Group(),
        moved: new Group(),
        plate,
        puck,
        fit(travel) {
          // The link before the joint ends at the seat: the plate reaches from there.
          const [along, athwart] = travel.map(({ low, high }) => ({ low: Math.min(low, 0), high: Math.max(high, 0) }));
          plate.scale.set(PLATE * r, along.high - along.low + 8 * r, athwart.high - athwart.low + 8 * r);
          plate.position.set(0, 0, (athwart.low + athwart.high) / 2).applyQuaternion(plate.quaternion);
          plate.position.z += (along.low + along.high) / 2;
          plate.position.add(plate.userData.offset);
        },
      };
    }
  }
}

/** Thickness of an E joint's plate in link radii. */
export const PLATE = 0.6;

/**
 * Where a slider's sleeve lies along the axis: around the seat, and on towards the rod's end as far as that never
 * comes, so that a leg looks like a telescope.
 * @param {Travel} travel
 * @param {number} half
 * @param {number} clear
 * @returns {[number, number]}
 */
function reach({ low, high }, half, clear) {
  if (low > 0) return [-half, Math.max(half, low - clear)];
  if (high < 0) return [Math.min(-half, high + clear), half];
  return [-half, half];
}
