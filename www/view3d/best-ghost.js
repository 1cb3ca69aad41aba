/**
 * The best motion in the view beside the followed one: its linkage as a ghost at the frame of the playhead, and its path, dashed.
 */
import { Group, MeshStandardMaterial } from 'three';
import { nameOf } from '../core/best-motions.js';
import { curveThrough } from './scene/curve.js';
import { Linkage } from './scene/linkage.js';
import { Packed } from './scene/packed.js';
import { Stroke, StrokeMaterial } from './scene/stroke.js';

/** How much of it is seen. */
const OPACITY = 0.34;

/** The path's width in CSS pixels, its dashes, and the least turn of it that is drawn, in link radii. */
const PATH = 3;
/** @type {[number, number]} */
const DASH = [9, 6];
const APART = 0.04;

/**
 * @param {Pick<import('../element/workbench.js').App, 'store'>} app
 * @param {NonNullable<import('../element/workbench.js').App['scene']>} scene
 * @param {import('../panels/best/search-state.js').SearchState} search
 */
export function createBestGhost({ store }, scene, search) {
  const material = new MeshStandardMaterial({ transparent: true, opacity: OPACITY, depthWrite: false, roughness: 0.9 });
  /** Of what is not drawn of a ghost. */
  const none = new MeshStandardMaterial({ visible: false });
  const linkage = new Linkage({ chain: [material], metal: material, dark: material, contact: none, limit: material, workpiece: material, axes: [none, none, none] });
  const path = new Stroke(new StrokeMaterial(PATH, { dash: DASH }));
  const group = new Group();
  group.add(linkage.group, path);
  group.name = 'best motion';
  group.visible = false;
  const packed = new Packed(new MeshStandardMaterial({ transparent: true, depthWrite: false }));
  scene.drawAsOne(packed, [material]);
  const told = scene.added.add({
    group,
    names: () => [],
    paint(palette) {
      material.color.copy(palette.closest);
      path.material.color.copy(palette.closest);
    },
    pose({ index }) {
      const { motion } = search.now;
      if (motion && group.visible) linkage.show({ rows: motion.rows, pose: motion.pose, frames: motion.frames, index: Math.min(index, motion.frames - 1) });
    },
  });
  /** What the bodies were built of. @type {unknown[]} */
  let built = [];
  let noted = '';

  function follow() {
    const { motion, which, doc } = search.now;
    const { frame, posture } = store.view;
    const isWanted = which === 'both' || (which === 'followed' && search.isFoundWhereLost(frame));
    const what = isWanted && motion && !posture && doc === store.result.doc ? motion : null;
    group.visible = what !== null;
    if (what && store.result.plain) {
      const now = [what, store.result.plain, scene.linkRadius];
      if (now.some((part, i) => part !== built[i])) build(what);
      built = now;
    }
    scene.canvas.dataset.best = what ? String(Math.min(frame, what.frames - 1)) : '';
    const note = what ? `▨ ${nameOf(what)} motion` : '';
    // It draws too.
    if (note !== noted) told(note ? [note] : []);
    else if (what) scene.changed();
    noted = note;
  }

  /** @param {import('../core/types.js').Motion} motion */
  function build(motion) {
    const { plain } = store.result;
    if (!plain) return;
    linkage.update(motion, plain, scene.linkRadius, scene.size.ground);
    // Both stand on the same bases.
    linkage.group.traverse((object) => {
      object.userData.faint = true;
      if (/\.base$/.test(object.userData.place ?? '')) object.visible = false;
      // It is looked at and not chosen: what is chosen is the linkage itself.
      delete object.userData.place;
    });
    path.position.fromArray(motion.pose);
    const { points, count } = curveThrough(motion.pose, motion.frames, APART * scene.linkRadius);
    path.lay(points, count);
  }

  search.subscribe(follow);
  for (const part of /** @type {const} */ (['view', 'result'])) store.subscribe(part, follow);
  follow();
}
