/**
 * One thing of each kind that is drawn first: from them the graphics card's programs are made while the planner still plans, and
 * are there when there is something to draw.
 */
import { Group, Mesh, PlaneGeometry } from 'three';
import { softRing } from './base.js';
import { Stroke } from './stroke.js';

/** @param {ReturnType<typeof import('./materials.js').createMaterials>} materials */
export function samplesOf({ metal, axes, faintAxes, ghost, contact, closest }) {
  const body = new PlaneGeometry();
  const line = new Stroke(closest);
  line.lay(Float64Array.of(0, 0, 0, 1, 0, 0), 2);
  const samples = new Group().add(...[metal, axes[0], faintAxes[0], ghost].map((material) => new Mesh(body, material)), new Mesh(softRing(), contact), line);
  // They are drawn wherever the camera looks.
  for (const one of samples.children) one.frustumCulled = false;
  return samples;
}
