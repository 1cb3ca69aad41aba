/**
 * The view's bodies as triangles on the picture's plane: those that face the viewer, small enough to be ordered by
 * their distance, each with its colour under the scene's light.
 *
 * @typedef {import('./picture.js').Scene} Scene
 * @typedef {object} Triangle
 * @property {number[]} corners x y z of each in the fixed frame, 9
 * @property {number[]} points x y of each in the picture, 6
 * @property {number} depth mean distance, 0 to 1 as the camera has it
 * @property {string} colour
 *
 * @typedef {object} Veil a transparent body's outline
 * @property {number[][]} outline
 * @property {number} depth of its nearest point
 * @property {string} colour
 * @property {number} opacity
 */
import { BackSide, Color, DirectionalLight, DoubleSide, HemisphereLight, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { Packed } from '../view3d/scene/packed.js';
import { Stroke } from '../view3d/scene/stroke.js';
import { hull } from './hull.js';
import { strokeTriangles } from './strokes.js';

/** Longest edge in link radii: a rod whose far end lies behind a ball must not be in front of it as a whole. */
const LONGEST = 3;

/**
 * Bodies below some objects, with the place of each in the fixed frame.
 * @param {import('three').Object3D[]} roots
 * @param {(mesh: Mesh, place: Matrix4) => void} visit
 */
export function eachBody(roots, visit) {
  for (const root of roots) {
    root.updateWorldMatrix(true, true);
    root.traverseVisible((object) => {
      if (!(object instanceof Mesh) || object instanceof Packed || !object.geometry.getAttribute('position')) return;
      if (!(object instanceof InstancedMesh)) return visit(object, object.matrixWorld);
      for (let index = 0; index < object.count; index++) {
        const own = new Matrix4();
        object.getMatrixAt(index, own);
        visit(object, own.premultiply(object.matrixWorld));
      }
    });
  }
}

/** The corners of a body's triangles, as numbers of its vertices. @param {import('three').BufferGeometry} geometry */
export function cornersOf(geometry) {
  const index = geometry.getIndex();
  const { start, count } = geometry.drawRange;
  const all = index ? index.count : geometry.getAttribute('position').count;
  const end = Math.min(all, start + count);
  return Array.from({ length: Math.max(0, end - start) }, (_, at) => (index ? index.getX(start + at) : start + at));
}

/** Where the corners of all bodies that are seen stand, in the fixed frame. @param {import('three').Object3D[]} roots */
export function pointsOf(roots) {
  /** @type {Vector3[]} */
  const points = [];
  eachBody(roots, (mesh, place) => {
    const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    if (!material.visible || material.vertexColors) return;
    const position = mesh.geometry.getAttribute('position');
    for (const vertex of new Set(cornersOf(mesh.geometry))) points.push(new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(place));
  });
  return points;
}

/**
 * @param {Scene} scene
 * @param {import('three').Object3D[]} roots
 * @param {Scene['camera']} camera
 * @param {number} width
 * @param {number} height
 */
export function viewTriangles(scene, roots, camera, width, height) {
  /** @type {Triangle[]} */
  const triangles = [];
  /** What is drawn over all else. @type {Triangle[]} */
  const fronts = [];
  /** @type {Veil[]} */
  const veils = [];
  const shade = createShade(scene);
  const longest = LONGEST * scene.linkRadius;
  /** @param {Vector3} point */
  const project = (point) => {
    const seen = point.clone().project(camera);
    return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height, seen.z];
  };

  eachBody(roots, (mesh, place) => {
    const material = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
    // A soft shadow has no edge to be drawn by.
    if (!('color' in material) || material.side === BackSide || material.vertexColors) return;
    const base = /** @type {Color} */ (material.color);
    const list = material.depthTest ? triangles : fronts;
    if (mesh instanceof Stroke) {
      if (material.visible) list.push(...strokeTriangles(mesh, camera, width, height));
      return;
    }
    const positions = mesh.geometry.getAttribute('position');
    const normals = mesh.geometry.getAttribute('normal');
    const corners = cornersOf(mesh.geometry);
    const at = (/** @type {number} */ vertex) => new Vector3().fromBufferAttribute(positions, vertex).applyMatrix4(place);
    if (material.transparent && material.opacity < 1) {
      const seen = [...new Set(corners)].map((vertex) => project(at(vertex)));
      // In front of all but what is wholly nearer: better a veil over too much than one with torn edges.
      const depth = Math.min(...seen.map(([, , z]) => z));
      if (!seen.every(([, , z]) => z < 1 && z > -1)) return;
      veils.push({ outline: hull(seen), depth, colour: `#${base.getHexString()}`, opacity: material.opacity });
      return;
    }
    const turn = new Matrix4().extractRotation(place);
    const scale = new Vector3().setFromMatrixScale(place);
    const mirrored = place.determinant() < 0 ? -1 : 1;
    for (let first = 0; first + 2 < corners.length; first += 3) {
      const three = [corners[first], corners[first + 1], corners[first + 2]];
      const normal = new Vector3();
      if (normals) for (const vertex of three) normal.add(new Vector3().fromBufferAttribute(normals, vertex));
      normal.divide(scale).applyMatrix4(turn).normalize();
      add(three.map(at), normal);
    }

    /** @param {Vector3[]} points @param {Vector3} normal */
    function add(points, normal) {
      const [a, b, c] = points;
      const edges = [a.distanceTo(b), b.distanceTo(c), c.distanceTo(a)];
      const long = edges.indexOf(Math.max(...edges));
      if (edges[long] > longest) {
        const [p, q, r] = [points[long], points[(long + 1) % 3], points[(long + 2) % 3]];
        const middle = p.clone().add(q).multiplyScalar(0.5);
        add([p, middle, r], normal);
        add([middle, q, r], normal);
        return;
      }
      const seen = points.map(project);
      // Behind the camera, or outside of the picture.
      if (seen.some(([, , z]) => !(z < 1 && z > -1))) return;
      if (seen.every(([x]) => x < 0) || seen.every(([x]) => x > width) || seen.every(([, y]) => y < 0) || seen.every(([, y]) => y > height)) return;
      const [[ax, ay], [bx, by], [cx, cy]] = seen;
      const facing = -mirrored * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
      if (facing <= 0 && material.side !== DoubleSide) return;
      list.push({
        corners: points.flatMap((point) => point.toArray()),
        points: [ax, ay, bx, by, cx, cy],
        depth: (seen[0][2] + seen[1][2] + seen[2][2]) / 3,
        colour: material instanceof MeshBasicMaterial ? `#${base.getHexString()}` : shade(base, facing < 0 ? normal.clone().negate() : normal),
      });
    }
  });
  return { triangles, fronts, veils };
}

/** Colours under the scene's sky, sun and fill light, without shadows: Lambert's law in linear light. @param {Scene} scene */
function createShade(scene) {
  const suns = scene.pictured.filter((object) => object instanceof DirectionalLight);
  const sky = scene.pictured.find((object) => object instanceof HemisphereLight);
  const directions = suns.map(({ position, target }) => position.clone().sub(target.position).normalize());
  const light = new Color();
  return (/** @type {Color} */ base, /** @type {Vector3} */ normal) => {
    light.setScalar(0);
    if (sky) light.copy(sky.groundColor).lerp(sky.color, 0.5 * normal.z + 0.5).multiplyScalar(sky.intensity / Math.PI);
    suns.forEach(({ intensity }, i) => light.addScalar((intensity / Math.PI) * Math.max(0, normal.dot(directions[i]))));
    light.multiply(base);
    for (const channel of /** @type {const} */ (['r', 'g', 'b'])) light[channel] = Math.min(1, light[channel]);
    return `#${light.getHexString()}`;
  };
}
