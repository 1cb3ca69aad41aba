/**
 * What the bodies of the scene are made of, and their colours, which the style sheet has.
 */
import { DoubleSide, MeshBasicMaterial, MeshStandardMaterial } from 'three';
import { isDark } from './ground.js';
import { StrokeMaterial } from './stroke.js';

/** Chains beyond this number begin again with the first colour; labels tell them apart. */
const CHAIN_COLOURS = 5;

/** Drawn behind what is at the same place. @template {import('three').Material} T @param {T} material */
export const behind = (material) => Object.assign(material, { polygonOffset: true, polygonOffsetUnits: 40 });

export function createMaterials() {
  const axes = (/** @type {object} */ more) => [0, 1, 2].map(() => new MeshBasicMaterial(more));
  const materials = {
    chain: Array.from({ length: CHAIN_COLOURS }, () => new MeshStandardMaterial({ roughness: 0.5, metalness: 0.05, side: DoubleSide })),
    metal: new MeshStandardMaterial({ roughness: 0.4, metalness: 0.15 }),
    dark: new MeshStandardMaterial({ roughness: 0.45, metalness: 0.1 }),
    /** Of a stop that is reached. */
    limit: new MeshStandardMaterial({ roughness: 0.5 }),
    workpiece: new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 }),
    // Lines as the legend shows them. Where the motions are one, the closest lies on the wider goal.
    goal: behind(new StrokeMaterial(5)),
    closest: new StrokeMaterial(3),
    gap: new StrokeMaterial(5),
    gaps: [new StrokeMaterial(2, [2, 3]), new StrokeMaterial(2, [6, 4]), new StrokeMaterial(2)],
    ghost: new MeshStandardMaterial({ transparent: true, opacity: 0.26, depthWrite: false, roughness: 0.9 }),
    /** The workpiece at other frames. */
    ghosts: new MeshStandardMaterial({ transparent: true, opacity: 0.34, depthWrite: false, roughness: 0.9 }),
    /** The ground beside what stands on it, where little light comes. */
    contact: new MeshBasicMaterial({ color: 0, transparent: true, depthWrite: false, vertexColors: true }),
    key: new MeshStandardMaterial({ roughness: 0.6 }),
    keyAxes: axes({}),
    axes: axes({}),
    faintAxes: axes({ transparent: true, opacity: 0.35 }),
  };
  return {
    ...materials,
    /** @param {import('./palette.js').Palette} palette */
    paint(palette) {
      materials.chain.forEach((material, index) => material.color.copy(palette[/** @type {'chain-0'} */ (`chain-${index}`)]));
      materials.metal.color.copy(palette.metal);
      materials.dark.color.copy(palette['dark-metal']);
      materials.workpiece.color.copy(palette.workpiece);
      materials.contact.opacity = isDark(palette.ground) ? 1 : 0.38;
      materials.limit.color.copy(palette.gap);
      materials.key.color.copy(palette.goal);
      materials.goal.color.copy(palette.goal);
      materials.closest.color.copy(palette.closest);
      materials.gap.color.copy(palette.gap);
      materials.gaps.forEach((material, size) => material.color.copy(palette[/** @type {'gap-0'} */ (`gap-${size}`)]));
      materials.ghost.color.copy(palette.goal);
      materials.ghosts.color.copy(palette.closest);
      for (const triad of [materials.keyAxes, materials.axes, materials.faintAxes]) {
        triad.forEach((material, axis) => material.color.copy(palette[/** @type {'axis-x'} */ (`axis-${'xyz'[axis]}`)]));
      }
    },
    /** Which of the things that can be left out are drawn. @param {import('../../core/types.js').Shown} show */
    show({ goal, closest, gaps, axes }) {
      for (const material of [materials.goal, materials.ghost]) material.visible = goal;
      materials.closest.visible = closest;
      for (const material of [materials.gap, ...materials.gaps]) material.visible = gaps;
      for (const material of [...materials.axes, ...materials.faintAxes]) material.visible = axes;
    },
  };
}
