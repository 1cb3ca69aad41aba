/**
 * Lines with a width on the screen as triangles of a picture, dash by dash, short enough to be ordered by their distance.
 */
import { Vector3 } from 'three';

/** Longest part of an unbroken line, in CSS pixels. */
const LONGEST = 12;

/**
 * @param {import('../view3d/scene/stroke.js').Stroke} stroke
 * @param {import('./picture.js').Scene['camera']} camera
 * @param {number} width @param {number} height of the picture
 */
export function strokeTriangles(stroke, camera, width, height) {
  const { material } = stroke;
  const half = material.width / 2;
  const [dash, gap] = material.dash;
  const colour = `#${material.color.getHexString()}`;
  /** @type {import('./triangles.js').Triangle[]} */
  const triangles = [];
  stroke.eachPiece(camera, (a, b) => {
    const size = Math.hypot(b.x - a.x, b.y - a.y);
    const [across, up] = size > 1e-9 ? [(b.x - a.x) / size, (b.y - a.y) / size] : [1, 0];
    const depth = (/** @type {number} */ along) => a.z + (size > 1e-9 ? Math.min(1, Math.max(0, along / size)) : 0) * (b.z - a.z);
    const corner = (/** @type {number} */ along, /** @type {number} */ side) => new Vector3(a.x + along * across - side * up, a.y + along * up + side * across, depth(along));
    // As the view draws it: from before its beginning to beyond its end, the dashes counted from its beginning.
    const parts = gap ? Math.ceil((size + half) / (dash + gap)) : Math.ceil((size + 2 * half) / LONGEST);
    for (let part = 0; part < parts; part++) {
      const [from, to] = gap ? [part * (dash + gap) - (part ? 0 : half), Math.min(size + half, part * (dash + gap) + dash)] : [part, part + 1].map((at) => (at / parts) * (size + 2 * half) - half);
      const four = [corner(from, -half), corner(to, -half), corner(to, half), corner(from, half)];
      if (four.every(({ x, y }) => Math.abs(x) > width / 2 || Math.abs(y) > height / 2)) continue;
      for (const three of [[0, 1, 2], [0, 2, 3]].map((set) => set.map((i) => four[i]))) {
        triangles.push({
          corners: three.flatMap(({ x, y, z }) => new Vector3((2 * x) / width, (2 * y) / height, z).unproject(camera).toArray()),
          points: three.flatMap(({ x, y }) => [width / 2 + x, height / 2 - y]),
          depth: depth((from + to) / 2),
          colour,
        });
      }
    }
  });
  return triangles;
}
