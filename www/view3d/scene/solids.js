/**
 * Rounded solids: rods between points, bodies around points, triads. Bodies of one form share one geometry, scaled to
 * size, so that a changed dimension costs no new buffers.
 */
import { BufferGeometry, ConeGeometry, CylinderGeometry, Group, IcosahedronGeometry, Mesh, SphereGeometry, Vector3 } from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';
import { mergeGeometries, mergeVertices, toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';

const Y = new Vector3(0, 1, 0);

/** @type {Map<string, BufferGeometry>} */
const forms = new Map();

/**
 * The one geometry of a form; it lives as long as the page.
 * @param {string} form @param {() => BufferGeometry} make
 */
export function shared(form, make) {
  const known = forms.get(form);
  if (known) return known;
  const made = make();
  forms.set(form, made);
  return made;
}

/** @param {Mesh} mesh */
export function solid(mesh) {
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

/**
 * A round rod with round ends between two points.
 * @param {Vector3} from
 * @param {Vector3} to
 * @param {number} radius
 * @param {import('three').Material} material
 */
export function rod(from, to, radius, material) {
  const group = new Group();
  const shaft = solid(new Mesh(shared('shaft', () => new CylinderGeometry(1, 1, 1, 20, 1, true)), material));
  const ends = [0, 1].map(() => solid(new Mesh(shared('rod end', () => new SphereGeometry(1, 18, 10)), material)));
  group.add(shaft, ...ends);
  shaft.scale.set(radius, 1, radius);
  for (const end of ends) end.scale.setScalar(radius);
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
 * Three arrows along x, y and z.
 * @param {number} size
 * @param {import('three').Material[]} materials
 */
export function triad(size, materials) {
  const group = new Group();
  materials.forEach((material, axis) => {
    const arrow = new Mesh(shared('arrow', () => mergeGeometries([new CylinderGeometry(0.03, 0.03, 0.8, 10).translate(0, 0.4, 0), new ConeGeometry(0.085, 0.24, 14).translate(0, 0.88, 0)])), material);
    arrow.quaternion.setFromUnitVectors(Y, new Vector3().setComponent(axis, 1));
    group.add(arrow);
  });
  group.scale.setScalar(size);
  return group;
}
