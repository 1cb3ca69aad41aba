/**
 * The instantaneous freedoms of the workpiece as something to move it by: a handle and a pair of buttons each.
 *
 * @typedef {import('./key-frame.js').Target} Target
 * @typedef {import('./pointer-drags.js').Pointer} Pointer
 */
import { Vector3 } from 'three';
import { groupAt, shown } from '../../core/shown.js';
import { createFreedomHandles } from './freedom-handles.js';
import { freedomInWords } from '../../core/freedom-words.js';
import { movePoint, movePose } from './screws.js';
import { ANGLE_STEP, lengthStep } from './steps.js';

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store'>} app
 * @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene
 */
export function createFreedoms({ store }, scene) {
  const handles = createFreedomHandles(scene);
  /** What the handles were built for. @type {unknown} */
  let built = null;

  const here = () => {
    const now = shown(store);
    return now && groupAt(now.pose, now);
  };

  return {
    handles,
    /** Shows the handles of the present posture. @param {boolean} on */
    show(on) {
      const { why, view } = store;
      const pose = here();
      const wanted = on && why && pose && !view.playing ? why : null;
      if (wanted === built || (on && !why && !view.playing)) return;
      built = wanted;
      if (wanted && pose) handles.show(wanted.freedoms, pose);
      else handles.clear();
    },
    /** In words; null while they are not known. */
    words: () => store.why?.freedoms.map((screw) => freedomInWords(screw, store.doc.length_unit)) ?? null,
    /**
     * @param {number} index @param {Pointer} at @param {Target} held the workpiece
     * @param {() => void} done
     * @returns {import('./pointer-drags.js').Drag | null}
     */
    grab(index, at, held, done) {
      const screw = store.why?.freedoms[index];
      const pose = here()?.slice();
      if (!screw || !pose) return null;
      const along = handles.follow(index, at);
      let begun = false;
      return {
        move(to) {
          if (!begun) held.begin('drag');
          begun = true;
          held.to(movePose(pose, screw.twist, along(to)), false);
        },
        end: done,
        cancel() {
          if (begun) held.cancel();
        },
      };
    },
    /** One step: a round length of the workpiece's way, or the step of a turn if that is less. @param {number} index @param {number} sign @param {Target} held */
    nudge(index, sign, held) {
      const screw = store.why?.freedoms[index];
      const pose = here();
      if (!screw || !pose) return;
      const at = new Vector3(pose[0], pose[1], pose[2]);
      const speed = movePoint({ twist: screw.twist, origin: pose }, 1e-4, at.clone()).distanceTo(at) / 1e-4;
      const most = screw.pitch === null ? Infinity : (ANGLE_STEP / 3) * (Math.PI / 180);
      held.begin('nudge');
      held.to(movePose(pose, screw.twist, sign * Math.min(lengthStep(scene.radius) / speed, most)), false);
    },
  };
}
