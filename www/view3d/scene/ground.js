/**
 * The ground: squares of a round size that fade out, and the shadow on them.
 */
import { BufferGeometry, Float32BufferAttribute, Group, LineSegments, Mesh, MeshBasicMaterial, PlaneGeometry, ShadowMaterial } from 'three';

/** Squares from the middle to the edge. */
const SQUARES = 14;

export function createGround() {
  const group = new Group();
  group.name = 'ground';
  // As the soft shadows have it, so that one program draws both.
  const material = new MeshBasicMaterial({ transparent: true, depthWrite: false, vertexColors: true });
  const lines = new LineSegments(squares(), material);
  const shade = new ShadowMaterial();
  const floor = new Mesh(new PlaneGeometry(4 * SQUARES, 4 * SQUARES), shade);
  floor.receiveShadow = true;
  floor.position.z = -1e-3;
  group.add(lines, floor);
  return {
    group,
    /** What every picture has of it. */
    lines,
    /** Called before every picture. @param {boolean} shadows whether it has them: without them the floor shows nothing */
    beforeDraw(shadows) {
      floor.visible = shadows;
    },
    /** @param {import('./palette.js').Palette} palette */
    paint({ grid, ground }) {
      material.color.copy(grid);
      shade.opacity = isDark(ground) ? 0.55 : 0.17;
    },
    /**
     * @param {import('three').Vector3} centre
     * @param {number} radius of the scene
     * @param {number} height of the ground
     */
    lay(centre, radius, height) {
      const side = roundSize(radius / 2.5);
      group.scale.setScalar(side);
      group.position.set(Math.round(centre.x / side) * side, Math.round(centre.y / side) * side, height);
    },
  };
}

/** Whether the scheme is dark: a shadow must be deeper there to be seen. @param {import('three').Color} ground */
export const isDark = ({ g }) => g < 0.2;

/** 1, 2 or 5 times a power of ten, at most `wish`. @param {number} wish */
export function roundSize(wish) {
  const power = 10 ** Math.floor(Math.log10(wish));
  return ([5, 2].find((step) => step * power <= wish) ?? 1) * power;
}

/** Unit squares whose lines grow fainter outwards. */
function squares() {
  /** @type {number[]} */
  const places = [];
  /** @type {number[]} */
  const colours = [];
  const add = (/** @type {number} */ x, /** @type {number} */ y) => {
    places.push(x, y, 0);
    colours.push(1, 1, 1, Math.max(0, 1 - Math.hypot(x, y) / SQUARES) ** 1.5 * 0.8);
  };
  for (let i = -SQUARES; i <= SQUARES; i++) {
    for (let j = -SQUARES; j < SQUARES; j++) {
      add(i, j);
      add(i, j + 1);
      add(j, i);
      add(j + 1, i);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
  geometry.setAttribute('color', new Float32BufferAttribute(colours, 4));
  return geometry;
}
