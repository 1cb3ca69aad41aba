/**
 * Lines with a width on the screen, in CSS pixels of the picture that is drawn, whatever its size and sharpness: each piece is
 * four corners that the graphics card moves sideways. Laid anew in place: the buffers are kept and only grow. Points are
 * counted from an own origin, where the line stands: the graphics card's numbers have 7 digits, too few far from the document's.
 */
import { Box3, BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Matrix4, Mesh, MeshBasicMaterial, Sphere, Vector2, Vector3 } from 'three';

/** The size of the picture that is drawn, in CSS pixels: who draws says it, and the shader of every line reads it. */
export const drawn = new Vector2(1, 1);

/** How far beside a line it is still under a pointer, in CSS pixels. */
const REACH = 1;

/** In place of a corner's projection: aside by half of the width, and beyond the end by as much, so that pieces overlap where the line turns. */
const SIDEWAYS = `
  vec4 own = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec4 far = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
  // What lies before the nearest plane has no place on the screen: the line ends there.
  float a = own.z + own.w, b = far.z + far.w;
  if (a < 0.0) own = mix(own, far, a / (a - b));
  else if (b < 0.0) far = mix(far, own, b / (b - a));
  vec2 half_ = 0.5 * drawn, here = own.xy / own.w * half_, way = far.xy / far.w * half_ - here;
  float size = length(way), end = float((gl_VertexID >> 1) & 1), side = float(gl_VertexID & 1) - 0.5;
  way = size > 1e-5 ? way / size : vec2(1.0, 0.0);
  here += width * ((1.0 - 2.0 * end) * side * vec2(-way.y, way.x) - 0.5 * way);
  along = end * (size + width) - 0.5 * width;
  gl_Position = max(a, b) < 0.0 ? vec4(2.0) : vec4(here / half_, own.z / own.w + behind, 1.0);`;

/** How far behind what is at the same place a line is drawn, once: so many of the smallest steps of a depth of 24 bits. */
const STEPS = 40;

const point = new Vector3();

export class StrokeMaterial extends MeshBasicMaterial {
  /**
   * @param {number} width in CSS pixels
   * @param {{dash?: [number, number], behind?: number}} [more] length of a dash and of the gap after it, in CSS pixels; how many
   *   times it is behind what is at the same place
   */
  constructor(width, { dash = [1, 0], behind = 0 } = {}) {
    super({ side: DoubleSide });
    this.width = width;
    this.dash = dash;
    this.behind = behind;
  }

  /** @param {{vertexShader: string, fragmentShader: string, uniforms: object}} shader */
  onBeforeCompile(shader) {
    Object.assign(shader.uniforms, { drawn: { value: drawn }, width: { value: this.width }, dash: { value: this.dash }, behind: { value: (2 * STEPS * this.behind) / 2 ** 24 } });
    shader.vertexShader = `attribute vec3 other; uniform vec2 drawn; uniform float width, behind; varying float along;\n${shader.vertexShader.replace('#include <project_vertex>', SIDEWAYS)}`;
    shader.fragmentShader = `uniform vec2 dash; varying float along;\n${shader.fragmentShader.replace('{', '{ if (mod(max(along, 0.0), dash.x + dash.y) > dash.x) discard;')}`;
  }
}

/** @extends {Mesh<BufferGeometry, StrokeMaterial>} */
export class Stroke extends Mesh {
  #capacity = 0;

  /** @param {StrokeMaterial} material */
  constructor(material) {
    super(new BufferGeometry(), material);
    this.geometry.boundingBox = new Box3();
    this.geometry.boundingSphere = new Sphere();
    this.visible = false;
  }

  /**
   * @param {Float64Array} points 3 numbers each, counted from the line's own origin
   * @param {number} count of points
   * @param {number} [step] 1 for a curve through them all, 2 for a line from each other one to the next
   */
  lay(points, count, step = 1) {
    const pieces = Math.max(0, Math.floor((count + step - 2) / step));
    this.visible = pieces > 0;
    if (!pieces) return;
    this.#reserve(pieces);
    const { geometry } = this;
    const own = geometry.getAttribute('position');
    const other = geometry.getAttribute('other');
    const [corners, others] = [own.array, other.array];
    const box = /** @type {Box3} */ (geometry.boundingBox).makeEmpty();
    for (let at = 0; at < count; at++) box.expandByPoint(point.set(points[3 * at], points[3 * at + 1], points[3 * at + 2]));
    for (let piece = 0, at = 0; piece < pieces; piece++) {
      const from = 3 * step * piece;
      for (let corner = 0; corner < 4; corner++) {
        const here = corner < 2 ? from : from + 3;
        const there = corner < 2 ? from + 3 : from;
        for (let axis = 0; axis < 3; axis++, at++) {
          corners[at] = points[here + axis];
          others[at] = points[there + axis];
        }
      }
    }
    own.needsUpdate = true;
    other.needsUpdate = true;
    geometry.setDrawRange(0, 6 * pieces);
    box.getBoundingSphere(/** @type {Sphere} */ (geometry.boundingSphere));
  }

  /** @param {number} pieces */
  #reserve(pieces) {
    if (pieces <= this.#capacity) return;
    this.#capacity = Math.ceil(pieces * 1.25);
    const { geometry } = this;
    geometry.dispose();
    for (const name of ['position', 'other']) geometry.setAttribute(name, new BufferAttribute(new Float32Array(12 * this.#capacity), 3).setUsage(DynamicDrawUsage));
    geometry.setIndex(new BufferAttribute(Uint32Array.from({ length: 6 * this.#capacity }, (_, at) => 4 * Math.floor(at / 6) + [0, 1, 2, 2, 1, 3][at % 6]), 1));
  }

  /**
   * Visits what is drawn of the line on a screen: both ends of each piece, x and y in CSS pixels from the middle, the depth as
   * the camera has it, and how far away it is along the view (1 without perspective).
   * @param {import('three').Camera} camera
   * @param {(a: Seen, b: Seen, piece: number) => void} visit
   * @typedef {{x: number, y: number, z: number, w: number}} Seen
   */
  eachPiece(camera, visit) {
    const { elements: m } = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).multiply(this.matrixWorld);
    const { array } = this.geometry.getAttribute('position');
    const row = (/** @type {number} */ at, /** @type {number} */ i) => m[i] * array[at] + m[i + 4] * array[at + 1] + m[i + 8] * array[at + 2] + m[i + 12];
    const place = (/** @type {number} */ at, /** @type {number} */ other) => {
      let clip = [0, 1, 2, 3].map((i) => row(at, i));
      const before = clip[2] + clip[3];
      if (before < 0) {
        const next = [0, 1, 2, 3].map((i) => row(other, i));
        clip = clip.map((value, i) => value + ((next[i] - value) * before) / (before - next[2] - next[3]));
      }
      const [x, y, z, w] = clip;
      return { x: (x / w) * (drawn.x / 2), y: (y / w) * (drawn.y / 2), z: z / w, w };
    };
    for (let piece = 0; 6 * piece < this.geometry.drawRange.count; piece++) {
      const at = 12 * piece;
      if (Math.max(...[at, at + 6].map((end) => row(end, 2) + row(end, 3))) >= 0) visit(place(at, at + 6), place(at + 6, at), piece);
    }
  }

  /** Found where it is drawn. @param {import('three').Raycaster} raycaster @param {import('three').Intersection[]} found */
  raycast({ ray, camera }, found) {
    if (!this.visible) return;
    const pointer = ray.at(1, new Vector3()).project(camera);
    const [x, y] = [(pointer.x * drawn.x) / 2, (pointer.y * drawn.y) / 2];
    const reach = this.material.width / 2 + REACH;
    this.eachPiece(camera, (a, b, piece) => {
      const [across, up] = [b.x - a.x, b.y - a.y];
      const share = Math.min(1, Math.max(0, ((x - a.x) * across + (y - a.y) * up) / (across * across + up * up || 1)));
      if (Math.hypot(a.x + share * across - x, a.y + share * up - y) > reach) return;
      const point = new Vector3((2 * x) / drawn.x, (2 * y) / drawn.y, a.z + share * (b.z - a.z)).unproject(camera);
      found.push({ distance: ray.origin.distanceTo(point), point, object: this, instanceId: piece });
    });
  }
}
