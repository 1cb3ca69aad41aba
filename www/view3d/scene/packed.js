/**
 * Bodies of many small parts that are drawn as one: their corners lie in one geometry, and where each part is, and its colour, in a
 * texture that is written for every picture. To draw a hundred bodies one by one takes the page's own thread longer than all else
 * of a picture, and a machine without a graphics card has fewer programs to make.
 *
 * The parts stay in the scene, where they are placed, pointed at and outlined; they are only not drawn by themselves.
 */
import { BufferAttribute, BufferGeometry, DataTexture, FloatType, Mesh, MeshDepthMaterial, RGBAFormat } from 'three';

/** To a part: the columns of its matrix, which end in its roughness, its metalness and its opacity, and its colour. */
const TEXELS = 5;

/** Parts one below the other in the texture, then in the next columns: no graphics card takes less than 2,048 either way. */
const ROWS = 1024;

/** A layer of the scene that no camera looks at. */
const UNSEEN = 1;

const VERTEX = `
  uniform highp sampler2D parts;
  attribute float part;
  varying vec3 partColor;
  varying vec3 partLook;
  vec4 texel(int which) {
    int own = int(part);
    return texelFetch(parts, ivec2(which + ${TEXELS} * (own / ${ROWS}), own % ${ROWS}), 0);
  }
`;
/** The parts' own places, before that of the whole. A normal goes with the inverse transpose of a matrix. */
const PLACED = `
  vec3 transformed = texel(0).xyz * position.x + texel(1).xyz * position.y + texel(2).xyz * position.z + texel(3).xyz;
  partColor = texel(4).rgb;
  partLook = vec3(texel(0).w, texel(1).w, texel(2).w);`;
const NORMAL = `
  vec3 a = texel(0).xyz, b = texel(1).xyz, c = texel(2).xyz;
  vec3 objectNormal = a * (normal.x / max(dot(a, a), 1e-30)) + b * (normal.y / max(dot(b, b), 1e-30)) + c * (normal.z / max(dot(c, c), 1e-30));`;

/** @typedef {(packed: Packed, materials: import('three').Material[]) => void} DrawAsOne bodies of these materials are drawn by it */

export class Packed extends Mesh {
  /** In the order in which they lie in the geometry. @type {Mesh[]} */
  #parts = [];
  /** Their geometries then. @type {BufferGeometry[]} */
  #shapes = [];
  /** What is found for the next picture. @type {Mesh[]} */
  #found = [];
  /** Those of them that are drawn. @type {Set<Mesh>} */
  #seen = new Set();
  #texture = { value: /** @type {DataTexture | null} */ (null) };

  /**
   * @param {import('three').Material} material of the whole; colour, opacity, roughness and metalness are the parts' own
   * @param {{shadows?: boolean, first?: boolean}} [more] whether parts cast shadows, and have them on themselves; whether they are
   *   drawn before all else that can be looked through
   */
  constructor(material, { shadows = false, first = false } = {}) {
    super(geometryOf(new Float32Array(), new Float32Array(), new Float32Array(), new Uint32Array()), material);
    this.visible = false;
    this.frustumCulled = false;
    this.castShadow = this.receiveShadow = shadows;
    if (first) this.renderOrder = -1;
    this.raycast = () => {};
    const placed = (/** @type {import('three').WebGLProgramParametersWithUniforms} */ shader) => {
      shader.uniforms.parts = this.#texture;
      shader.vertexShader = VERTEX + shader.vertexShader.replace('#include <beginnormal_vertex>', NORMAL).replace('#include <begin_vertex>', PLACED);
    };
    material.onBeforeCompile = (shader) => {
      placed(shader);
      shader.fragmentShader = `varying vec3 partColor; varying vec3 partLook;\n${shader.fragmentShader
        .replace('#include <color_fragment>', 'diffuseColor = vec4(partColor, partLook.z);')
        .replace('#include <roughnessmap_fragment>', 'float roughnessFactor = partLook.x;')
        .replace('#include <metalnessmap_fragment>', 'float metalnessFactor = partLook.y;')}`;
    };
    if (!shadows) return;
    this.customDepthMaterial = new MeshDepthMaterial();
    this.customDepthMaterial.onBeforeCompile = placed;
  }

  /** @param {Mesh} part @param {boolean} seen whether it is drawn; one that is not keeps its place */
  take(part, seen) {
    this.#found.push(part);
    if (seen) this.#seen.add(part);
  }

  /** Puts what was taken since the last time to where it is. */
  lay() {
    const [found, parts] = [this.#found, this.#parts];
    // What can be looked through comes last: in front of what is solid it would hide it, and where both are one neither would win.
    found.sort((one, other) => opacityOf(other) - opacityOf(one));
    if (found.length !== parts.length || found.some((part, at) => part !== parts[at] || part.geometry !== this.#shapes[at])) this.#build();
    this.visible = this.#seen.size > 0;
    if (this.visible) this.#place();
    found.length = 0;
    this.#seen.clear();
  }

  #place() {
    const texture = /** @type {DataTexture} */ (this.#texture.value);
    const data = /** @type {Float32Array} */ (texture.image.data);
    const { width } = texture.image;
    // Counted from the first that is drawn: the graphics card's numbers have 7 digits, too few far from the document's origin.
    const first = /** @type {Mesh} */ (this.#parts.find((part) => this.#seen.has(part)));
    this.position.setFromMatrixPosition(first.matrixWorld);
    this.updateMatrixWorld(true);
    const [x, y, z] = this.position.toArray();
    this.#parts.forEach((part, index) => {
      const { matrixWorld: { elements: m }, material } = part;
      const at = 4 * ((index % ROWS) * width + TEXELS * Math.floor(index / ROWS));
      if (!this.#seen.has(part)) return data.fill(0, at, at + 16);
      const { color, opacity, roughness = 0, metalness = 0 } = /** @type {import('three').MeshStandardMaterial} */ (material);
      for (let i = 0; i < 12; i++) data[at + i] = m[i];
      data[at + 3] = roughness;
      data[at + 7] = metalness;
      data[at + 11] = opacity;
      data[at + 12] = m[12] - x;
      data[at + 13] = m[13] - y;
      data[at + 14] = m[14] - z;
      color?.toArray(data, at + 16);
    });
    texture.needsUpdate = true;
  }

  #build() {
    const parts = (this.#parts = [...this.#found]);
    this.#shapes = parts.map(({ geometry }) => geometry);
    const corners = this.#shapes.map((shape) => shape.getAttribute('position').count);
    const all = corners.reduce((sum, count) => sum + count, 0);
    const position = new Float32Array(3 * all);
    const normal = new Float32Array(3 * all);
    const part = new Float32Array(all);
    const index = new Uint32Array(this.#shapes.reduce((sum, shape, at) => sum + (shape.getIndex()?.count ?? corners[at]), 0));
    let [first, next] = [0, 0];
    this.#shapes.forEach((shape, own) => {
      position.set(shape.getAttribute('position').array, 3 * first);
      normal.set(shape.getAttribute('normal').array, 3 * first);
      part.fill(own, first, first + corners[own]);
      const order = shape.getIndex();
      for (let i = 0; i < (order?.count ?? corners[own]); i++) index[next++] = first + (order ? order.array[i] : i);
      first += corners[own];
    });
    /** @type {Mesh} */ (this).geometry.dispose();
    this.geometry = geometryOf(position, normal, part, index);
    const { value: texture } = this.#texture;
    const [across, down] = [TEXELS * Math.ceil(parts.length / ROWS), Math.min(ROWS, parts.length)];
    if (texture && texture.image.width >= across && texture.image.height >= down) return;
    texture?.dispose();
    this.#texture.value = new DataTexture(new Float32Array(4 * across * down), across, down, RGBAFormat, FloatType);
  }

  /** Frees what it has in the graphics card. */
  dispose() {
    this.#texture.value?.dispose();
    this.customDepthMaterial?.dispose();
  }
}

/** @param {Mesh} part */
const opacityOf = ({ material }) => /** @type {import('three').Material} */ (material).opacity;

/** @param {Float32Array} position @param {Float32Array} normal @param {Float32Array} part the number of each corner's @param {Uint32Array} index */
function geometryOf(position, normal, part, index) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('part', new BufferAttribute(part, 1));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

/**
 * Called before every picture: what lies in the scene and is of such a material is drawn packed.
 * @param {import('three').Object3D} root
 * @param {Map<import('three').Material, Packed>} packs by the materials of the parts
 */
export function pack(root, packs) {
  const look = (/** @type {import('three').Object3D} */ object, /** @type {boolean} */ within) => {
    const seen = within && object.visible;
    const own = object instanceof Mesh && !(object instanceof Packed) && packs.get(object.material);
    if (own) {
      object.layers.set(UNSEEN);
      // One that has no form yet has no corners.
      if (object.geometry.getAttribute('position')) own.take(object, seen && object.material.visible);
    }
    const { children } = object;
    // At every picture, for every body: without an iterator for each.
    for (let at = 0; at < children.length; at++) look(children[at], seen);
  };
  look(root, true);
  for (const one of new Set(packs.values())) one.lay();
}
