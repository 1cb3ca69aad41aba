/**
 * Which thing of the scene is under a point of the canvas. Thin things are found from beside them too.
 */
import { Mesh, Raycaster, Vector2 } from 'three';
import { drawn } from './stroke.js';

/** Directions in which a near miss is looked for. */
const AROUND = Array.from({ length: 8 }, (_, i) => [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)]);

/**
 * @param {import('three').Object3D[]} roots
 * @param {HTMLCanvasElement} canvas
 * @param {() => import('three').Camera} camera
 */
export function createPicker(roots, canvas, camera) {
  const ray = new Raycaster();
  // What is drawn packed too.
  ray.layers.enableAll();
  const point = new Vector2();

  /** @param {number} x @param {number} y in CSS pixels of the canvas @returns {string} */
  function at(x, y) {
    // Lines are as wide as in this view.
    drawn.set(canvas.clientWidth, canvas.clientHeight);
    point.set((x / canvas.clientWidth) * 2 - 1, 1 - (y / canvas.clientHeight) * 2);
    ray.setFromCamera(point, camera());
    const found = ray
      .intersectObjects(roots)
      .map(({ object, instanceId }) => ({ object, place: placeOf(object, instanceId) }))
      .filter(({ object, place }) => place && isVisible(object));
    // What can be looked through hides nothing.
    return (found.find(({ object }) => !object.userData.faint) ?? found[0])?.place ?? '';
  }

  /**
   * @param {{clientX: number, clientY: number, pointerType: string}} event
   * @returns {string} a place; empty for nothing
   */
  return (event) => {
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const hit = at(x, y);
    if (hit) return hit;
    const reach = event.pointerType === 'touch' ? 12 : 4;
    for (const [right, up] of AROUND) {
      const near = at(x + reach * right, y + reach * up);
      if (near) return near;
    }
    return '';
  };
}

/** @param {import('three').Object3D | null} object @param {number} [instance] @returns {string} */
function placeOf(object, instance) {
  for (let part = object; part; part = part.parent) {
    const { place, places } = part.userData;
    if (places && instance !== undefined) return places[instance];
    if (place) return place;
  }
  return '';
}

/** @param {import('three').Object3D | null} object */
function isVisible(object) {
  if (object instanceof Mesh && !object.material.visible) return false;
  for (let part = object; part; part = part.parent) if (!part.visible) return false;
  return true;
}
