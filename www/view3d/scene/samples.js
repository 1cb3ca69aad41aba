/**
 * One thing of each kind that is drawn: from them the graphics card's programs are made while the planner still plans, and
 * are there when there is something to draw.
 */
import { BufferAttribute, BufferGeometry, Group, InstancedMesh, Mesh, PlaneGeometry } from 'three';

/** @param {ReturnType<typeof import('./materials.js').createMaterials>} materials */
export function samplesOf({ chain, metal, axes, faintAxes, ghost, ghosts, closest }) {
  // Of a form only its attributes matter: bodies have normals, lines have none.
  const body = new PlaneGeometry();
  const line = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(3), 3));
  const bodies = [chain[0], metal, axes[0], faintAxes[0], ghost].map((material) => new Mesh(body, material));
  return new Group().add(...bodies, new InstancedMesh(body, ghosts, 1), new Mesh(line, closest));
}
