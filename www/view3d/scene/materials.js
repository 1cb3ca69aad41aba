/**
 * What the bodies of the scene are made of, and their colours, which the style sheet has.
 */
import { MeshBasicMaterial, MeshStandardMaterial, NoBlending } from 'three';
import { isDark } from './ground.js';
import { Packed } from './packed.js';
import { StrokeMaterial } from './stroke.js';

/** Chains beyond this number begin again with the first colour; labels tell them apart. */
const CHAIN_COLOURS = 5;

/** Not to be looked through, and still drawn by the program of what is. */
const SOLID = { blending: NoBlending };

export function createMaterials() {
  const triad = (/** @type {object} */ more) => [0, 1, 2].map(() => new MeshBasicMaterial(more));
  const materials = {
    chain: Array.from({ length: CHAIN_COLOURS }, () => new MeshStandardMaterial({ roughness: 0.5, metalness: 0.05 })),
    metal: new MeshStandardMaterial({ roughness: 0.4, metalness: 0.15 }),
    dark: new MeshStandardMaterial({ roughness: 0.45, metalness: 0.1 }),
    /** Of a stop that is reached. */
    limit: new MeshStandardMaterial({ roughness: 0.5 }),
    workpiece: new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 }),
    // Lines as the legend shows them. Where the motions are one, the closest lies on the wider goal.
    goal: new StrokeMaterial(5, { behind: 1 }),
    closest: new StrokeMaterial(3),
    gap: new StrokeMaterial(5),
    gaps: [new StrokeMaterial(2, { dash: [2, 3] }), new StrokeMaterial(2, { dash: [6, 4] }), new StrokeMaterial(2)],
    ghost: new MeshStandardMaterial({ transparent: true, opacity: 0.26, depthWrite: false, roughness: 0.9 }),
    /** The workpiece at other frames. */
    ghosts: new MeshStandardMaterial({ transparent: true, opacity: 0.34, depthWrite: false, roughness: 0.9 }),
    /** The ground beside what stands on it, where little light comes. */
    contact: new MeshBasicMaterial({ color: 0, transparent: true, depthWrite: false, vertexColors: true }),
    key: new MeshStandardMaterial({ roughness: 0.6 }),
    keyAxes: triad({}),
    axes: triad({}),
    faintAxes: triad({ transparent: true, opacity: 0.35 }),
  };
  const { chain, metal, dark, limit, workpiece, ghost, key, keyAxes, axes, faintAxes } = materials;
  return {
    ...materials,
    /** What draws the bodies of some materials as one. @type {[Packed, import('three').Material[]][]} */
    packs: [
      [new Packed(new MeshStandardMaterial(SOLID), { shadows: true }), [...chain, metal, dark, limit, workpiece]],
      [new Packed(new MeshStandardMaterial(SOLID)), [key]],
      [new Packed(new MeshStandardMaterial({ transparent: true, depthWrite: false })), [ghost]],
      [new Packed(new MeshBasicMaterial({ transparent: true }), { first: true }), [...keyAxes, ...axes, ...faintAxes]],
    ],
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
      for (const arrows of [keyAxes, axes, faintAxes]) {
        arrows.forEach((material, axis) => material.color.copy(palette[/** @type {'axis-x'} */ (`axis-${'xyz'[axis]}`)]));
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
