/**
 * Screws as they are drawn, in front of all bodies: arrows along a path, with one head or two, and axes. The way of a freedom, a
 * force, a moment.
 *
 * @typedef {import('../../core/types.js').Insight['freedoms'][number]} Screw
 */
import { Color, ConeGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { shared } from '../scene/solids.js';
import { Stroke, StrokeMaterial } from '../scene/stroke.js';
import { movePoint } from './screws.js';

/** Lengths as shares of the scene's radius: half a path, the least distance of a turn's path from its axis. */
export const REACH = 0.3;
const LEAST_RADIUS = 0.16;

/** Points of a path. */
export const POINTS = 32;

/** Longest path of a turn, to either side. */
const LONGEST_TURN = (2 / 3) * Math.PI;

const Y = new Vector3(0, 1, 0);

/** Something at right angles to a direction. @param {Vector3} along */
export const across = (along) => along.clone().cross(Math.abs(along.z) < 0.9 * along.length() ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0));

/** The foot of a point on a screw's axis. @param {Screw} screw @param {Vector3} point */
export function footOn({ direction, point }, { x, y, z }) {
  const axis = new Vector3(...direction);
  const foot = new Vector3(...point);
  return foot.addScaledVector(axis, new Vector3(x, y, z).sub(foot).dot(axis) / axis.lengthSq());
}

/** A point whose path shows the screw: the workpiece's origin, or one beside the axis if that runs through it. @param {Screw} screw @param {Vector3} origin @param {number} radius of the scene */
function pathStart(screw, origin, radius) {
  if (screw.pitch === null) return origin.clone();
  const axis = new Vector3(...screw.direction);
  const foot = footOn(screw, origin);
  const arm = origin.clone().sub(foot);
  if (arm.length() >= LEAST_RADIUS * radius) return origin.clone();
  if (arm.length() < 1e-6 * radius) arm.copy(across(axis));
  return foot.addScaledVector(arm.normalize(), LEAST_RADIUS * radius * 1.6);
}

/**
 * The path along a screw: straight for a shift, an arc for a turn, else a helix.
 * @param {Screw} screw @param {number[]} origin of the workpiece @param {number} radius of the scene
 * @returns {{from: Vector3, points: Vector3[]}} `from` is in its middle
 */
export function screwPath(screw, origin, radius) {
  const from = pathStart(screw, new Vector3(...origin), radius);
  const along = { twist: screw.twist, origin };
  const speed = movePoint(along, 1e-4, from.clone()).distanceTo(from) / 1e-4;
  const reach = Math.min((REACH * radius) / Math.max(speed, 1e-9), screw.pitch === null ? Infinity : LONGEST_TURN);
  return { from, points: Array.from({ length: POINTS + 1 }, (_, i) => movePoint(along, (2 * (i / POINTS) - 1) * reach, from.clone())) };
}

/** A line in front of all bodies. @param {Vector3[]} points @param {number} width in CSS pixels @param {[number, number]} [dash] */
export function line(points, width, dash) {
  const stroke = new Stroke(Object.assign(new StrokeMaterial(width, { dash }), { depthTest: false, transparent: true }));
  stroke.position.copy(points[0]);
  stroke.lay(Float64Array.from(points.flatMap((point) => point.clone().sub(points[0]).toArray())), points.length);
  return inFront(stroke);
}

/** @template {Mesh} T @param {T} mesh */
function inFront(mesh) {
  mesh.renderOrder = 10;
  mesh.userData.faint = true;
  return mesh;
}

/**
 * An arrow along a path.
 * @param {Vector3[]} points @param {boolean} both whether it has a head at its beginning too
 * @param {number} head its length and its width are in proportion @param {number} width of the line in CSS pixels
 */
export function arrow(points, both, head, width) {
  const material = new MeshBasicMaterial({ depthTest: false, transparent: true });
  const group = new Group().add(line(points, width));
  for (const [at, before] of both ? [[-1, -2], [0, 1]] : [[-1, -2]]) {
    const cone = inFront(new Mesh(shared('screw head', () => new ConeGeometry(1, 2.6, 16)), material));
    const tip = /** @type {Vector3} */ (points.at(at));
    cone.position.copy(tip);
    cone.quaternion.setFromUnitVectors(Y, tip.clone().sub(/** @type {Vector3} */ (points.at(before))).normalize());
    cone.scale.setScalar(head);
    group.add(cone);
  }
  return group;
}

/** Colours a drawing. @param {import('three').Object3D} drawn @param {import('three').ColorRepresentation} color @param {number} [opacity] */
export function tint(drawn, color, opacity = 1) {
  drawn.traverse((part) => {
    if (part instanceof Mesh) Object.assign(part.material, { color: new Color(color), opacity });
  });
}

/** Frees what a drawing has in the graphics card; a head's form is shared. @param {import('three').Object3D} drawn */
export function free(drawn) {
  drawn.traverse((part) => {
    if (part instanceof Mesh) part.material.dispose();
    if (part instanceof Stroke) part.geometry.dispose();
  });
}
