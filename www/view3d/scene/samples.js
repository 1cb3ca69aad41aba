/**
 * One thing of each kind that is drawn first: with them the graphics card's programs are made while the planner still plans, and
 * are there when there is something to draw.
 */
import { Group, Mesh, PlaneGeometry } from 'three';
import { softRing } from './base.js';
import { Stroke } from './stroke.js';

/**
 * @param {ReturnType<typeof import('./materials.js').createMaterials>} materials
 * @returns {{own: Group, all: Group}} those that have a program of their own, which are among all; the others are drawn packed
 */
export function samplesOf({ metal, axes, ghost, contact, closest }) {
  const body = new PlaneGeometry();
  const line = new Stroke(closest);
  line.lay(Float64Array.of(0, 0, 0, 1, 0, 0), 2);
  const own = new Group().add(new Mesh(softRing(), contact), line);
  // They are drawn wherever the camera looks.
  for (const one of own.children) one.frustumCulled = false;
  return { own, all: new Group().add(own, ...[metal, axes[0], ghost].map((material) => new Mesh(body, material))) };
}
