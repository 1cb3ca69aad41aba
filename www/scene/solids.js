/**
 * Rounded solids: rods between points, bodies around points, tubes along curves, triads.
 */
import {
  BufferGeometry, CatmullRomCurve3, ConeGeometry, CylinderGeometry, Group, IcosahedronGeometry, Mesh, SphereGeometry, TubeGeometry, Vector3,
} from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';
import { mergeVertices, toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';

const Y = new Vector3(0, 1, 0);

/** Pieces of a curve: enough to look smooth across a screen. */
const CURVE_PIECES = 200;

/**
 * A round rod with round ends between two points.
 * @param {Vector3} from
 * @param {Vector3} to
 * @param {number} radius
 * @param {import('three').Material} material
 */
export function rod(from, to, radius, material) {
  const group = new Group();
  const shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 20, 1, true), material);
  const ends = [0, 1].map(() => new Mesh(new SphereGeometry(radius, 18, 10), material));
  group.add(shaft, ...ends);
  for (const mesh of [shaft, ...ends]) {
    mesh.castShadow = true;
    mesh.receiveShadow = true;
  }
  layRod(group, from, to);
  return group;
}

/** Lays a rod anew. @param {Group} group made by `rod` @param {Vector3} from @param {Vector3} to */
export function layRod(group, from, to) {
  const [shaft, start, end] = group.children;
  const along = new Vector3().subVectors(to, from);
  const length = along.length();
  shaft.visible = length > 0;
  start.position.copy(from);
  end.position.copy(to);
  if (!shaft.visible) return;
  shaft.position.addVectors(from, to).multiplyScalar(0.5);
  shaft.quaternion.setFromUnitVectors(Y, along.divideScalar(length));
  shaft.scale.y = length;
}

/**
 * A rounded body around points: the hull of balls set at them.
 * @param {Vector3[]} points
 * @param {number} radius
 * @returns {BufferGeometry}
 */
export function roundedHull(points, radius) {
  const distinct = points.filter((p, i) => points.findIndex((q) => q.distanceTo(p) < radius * 1e-3) === i);
  if (distinct.length < 2) return new SphereGeometry(radius, 32, 20).translate(...(distinct[0]?.toArray() ?? [0, 0, 0]));
  const round = new IcosahedronGeometry(radius, 2);
  round.deleteAttribute('normal');
  round.deleteAttribute('uv');
  const ball = mergeVertices(round).getAttribute('position');
  const cloud = distinct.flatMap((point) =>
    Array.from({ length: ball.count }, (_, i) => new Vector3(ball.getX(i), ball.getY(i), ball.getZ(i)).add(point)),
  );
  return toCreasedNormals(new ConvexGeometry(cloud), 0.6);
}

/**
 * A tube through points; empty if they are all one point.
 * @param {Vector3[]} points
 * @param {number} radius
 * @returns {BufferGeometry}
 */
export function tube(points, radius) {
  /** @type {Vector3[]} */
  const spread = [];
  for (const point of points) if (!spread.length || point.distanceTo(spread[spread.length - 1]) > radius * 0.1) spread.push(point);
  if (spread.length < 2) return new BufferGeometry();
  return new TubeGeometry(new CatmullRomCurve3(spread), Math.min(CURVE_PIECES, spread.length * 2), radius, 7);
}

/**
 * Three arrows along x, y and z.
 * @param {number} size
 * @param {import('three').Material[]} materials
 */
export function triad(size, materials) {
  const group = new Group();
  materials.forEach((material, axis) => {
    const arrow = new Group();
    const shaft = new Mesh(new CylinderGeometry(size * 0.03, size * 0.03, size * 0.8, 10), material);
    shaft.position.y = size * 0.4;
    const head = new Mesh(new ConeGeometry(size * 0.085, size * 0.24, 14), material);
    head.position.y = size * 0.88;
    arrow.add(shaft, head);
    arrow.quaternion.setFromUnitVectors(Y, new Vector3().setComponent(axis, 1));
    group.add(arrow);
  });
  return group;
}

/** Frees what a group's meshes hold on the graphics card. @param {import('three').Object3D} root */
export function dispose(root) {
  root.traverse((object) => {
    if (object instanceof Mesh) object.geometry.dispose();
  });
}
