/**
 * Outlines around what is chosen and what is pointed at: shells of the same shape behind it, wider by some pixels.
 */
import { BackSide, Box3, Color, InstancedMesh, Mesh, ShaderMaterial, Vector2 } from 'three';
import { belongs } from '../../core/things.js';
import { Packed } from './packed.js';
import { Stroke, StrokeMaterial } from './stroke.js';

/** Widths in CSS pixels: what is chosen and what is pointed at are told apart by them. */
const CHOSEN = 3.5;
const POINTED = 2;

const VERTEX = `
  uniform float width;
  uniform vec2 window;
  void main() {
    #include <beginnormal_vertex>
    #include <begin_vertex>
    vec4 place = projectionMatrix * modelViewMatrix * vec4(transformed, 1.0);
    vec2 outwards = (projectionMatrix * vec4(normalMatrix * objectNormal, 0.0)).xy * window;
    float size = length(outwards);
    if (size > 1e-9) place.xy += (outwards / size) * width * 2.0 / window * place.w;
    gl_Position = place;
  }`;
const FRAGMENT = `
  uniform vec3 color;
  void main() {
    gl_FragColor = vec4(color, 1.0);
    #include <colorspace_fragment>
  }`;

/** @param {import('three').Object3D[]} roots @param {import('./packed.js').DrawAsOne} drawAsOne */
export function createHighlight(roots, drawAsOne) {
  const window = { value: new Vector2(1, 1) };
  const outline = (/** @type {number} */ width) =>
    new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, side: BackSide, uniforms: { width: { value: width }, window, color: { value: new Color() } } });
  const materials = { chosen: outline(CHOSEN), pointed: outline(POINTED) };
  for (const material of Object.values(materials)) drawAsOne(new Packed(material), [material]);
  /** @type {Mesh[]} */
  let shells = [];
  /** The bodies of a thing that were found last: a name follows its thing at every picture. @type {{place: string, bodies: import('three').Object3D[]}} */
  let known = { place: '', bodies: [] };

  /** @param {(object: import('three').Object3D, place: string) => void} visit */
  const eachThing = (visit) => {
    for (const root of roots) {
      root.traverse((object) => {
        if (object.userData.place) visit(object, object.userData.place);
      });
    }
  };

  /** @param {import('three').Object3D} thing @param {ShaderMaterial} material */
  function wrap(thing, material) {
    const owner = thing.userData.place;
    const go = (/** @type {import('three').Object3D} */ object) => {
      if (object.userData.place && object.userData.place !== owner) return;
      for (const child of [...object.children]) go(child);
      if (!(object instanceof Mesh) || object instanceof InstancedMesh || object.userData.faint) return;
      const shell = new Mesh(object.geometry, object instanceof Stroke ? wider(object, material) : material);
      shell.userData.tool = true;
      shell.raycast = () => {};
      object.add(shell);
      shells.push(shell);
    };
    go(thing);
  }

  /** @param {Stroke} line @param {ShaderMaterial} outline */
  function wider({ material: { width } }, { uniforms }) {
    const made = new StrokeMaterial(width + 2 * uniforms.width.value, { behind: 2 });
    made.color.copy(uniforms.color.value);
    return made;
  }

  return {
    /** @param {string} chosen @param {string} pointed places */
    set(chosen, pointed) {
      known = { place: '', bodies: [] };
      for (const shell of shells) {
        shell.removeFromParent();
        if (shell.material instanceof StrokeMaterial) shell.material.dispose();
      }
      shells = [];
      if (!chosen && !pointed) return;
      /** @type {[import('three').Object3D, ShaderMaterial][]} */
      const found = [];
      eachThing((object, place) => {
        if (belongs(place, chosen)) found.push([object, materials.chosen]);
        else if (belongs(place, pointed)) found.push([object, materials.pointed]);
      });
      for (const [object, material] of found) wrap(object, material);
    },
    /** @param {import('three').Color} color */
    paint(color) {
      for (const { uniforms } of [materials.chosen, materials.pointed]) uniforms.color.value.copy(color);
    },
    /** @param {number} width @param {number} height of the canvas in CSS pixels */
    resize(width, height) {
      window.value.set(width, height);
    },
    /** The space that a thing takes. @param {string} place @returns {Box3} empty if there is none */
    boxOf(place) {
      const box = new Box3();
      eachThing((object, thing) => {
        if (belongs(thing, place) && !object.userData.faint) box.union(new Box3().setFromObject(object));
      });
      return box;
    },
    /** Where a thing's name stands: in the middle of its first part. @param {string} place @param {import('three').Vector3} at @returns {boolean} */
    anchorOf(place, at) {
      if (known.place !== place) {
        known = { place, bodies: [] };
        eachThing((object, thing) => {
          if (belongs(thing, place)) known.bodies.push(object);
        });
      }
      const box = new Box3();
      for (const object of known.bodies) {
        object.updateWorldMatrix(true, true);
        if (object.userData.anchor) box.expandByPoint(object.userData.anchor.getWorldPosition(at));
        else box.setFromObject(object);
        if (!box.isEmpty()) break;
      }
      if (!box.isEmpty()) box.getCenter(at);
      return !box.isEmpty();
    },
  };
}
