/**
 * How what is in hand is moved: by a drag of the gizmo, by a drag of the thing itself, or by one step of a key.
 *
 * @typedef {import('./key-frame.js').Target} Target
 * @typedef {import('./pointer-drags.js').Drag} Drag
 */
import { Quaternion, Vector3 } from 'three';

/**
 * @param {import('../../element/workbench.js').App['scene'] & {}} scene
 * @param {ReturnType<typeof import('./gizmo.js').createGizmo>} gizmo
 * @param {object} hand
 * @param {() => import('./toolbar.js').How} hand.how
 * @param {() => {length: number, angle: number}} hand.steps the sizes of round steps
 * @param {() => void} hand.show shows what is in hand where it is now
 * @param {(held: Target) => void} hand.done it has been let go
 * @param {(place: string) => void} hand.select
 */
export function createMoves(scene, gizmo, { how, steps, show, done, select }) {
  /** A drag of the gizmo. @param {Target} held @returns {Drag} */
  function gizmoDrag(held) {
    let begun = false;
    return {
      move(at, snap) {
        if (!begun) held.begin('drag');
        begun = true;
        gizmo.move(at, snap !== how().snap ? steps() : null);
        held.to(gizmo.pose(), how().mode === 'turn');
      },
      end() {
        gizmo.release();
        done(held);
      },
      cancel() {
        gizmo.release();
        if (begun) held.cancel();
        show();
      },
    };
  }

  /**
   * A drag of a thing itself, in the plane of the view.
   * @param {Target} held @param {string} place @param {import('./pointer-drags.js').Pointer} from @returns {Drag}
   */
  function planeDrag(held, place, from) {
    const pose = Array.from(held.pose() ?? []);
    const origin = new Vector3().fromArray(pose);
    const depth = origin.clone().project(scene.camera).z;
    const start = new Vector3(from.x, from.y, depth).unproject(scene.camera);
    let begun = false;
    return {
      move(at, snap) {
        if (!begun) {
          begun = true;
          held.begin('drag');
        }
        const to = new Vector3(at.x, at.y, depth).unproject(scene.camera).sub(start).add(origin);
        if (snap !== how().snap) to.divideScalar(steps().length).round().multiplyScalar(steps().length);
        held.to([...to.toArray(), ...pose.slice(3)], false);
      },
      end() {
        select(place);
        done(held);
      },
      cancel() {
        if (begun) held.cancel();
        show();
      },
    };
  }

  /** One step along or about an axis. @param {Target} held @param {0 | 1 | 2} axis @param {1 | -1} sign */
  function nudge(held, axis, sign) {
    const pose = held.pose();
    if (!pose) return;
    const turn = new Quaternion(pose[3], pose[4], pose[5], pose[6]);
    const at = new Vector3(pose[0], pose[1], pose[2]);
    const along = new Vector3().setComponent(axis, 1);
    if (how().space === 'local') along.applyQuaternion(turn);
    const { length, angle } = steps();
    if (how().mode === 'turn') turn.premultiply(new Quaternion().setFromAxisAngle(along, (sign * angle * Math.PI) / 180));
    else at.addScaledVector(along, sign * length);
    held.begin('nudge');
    held.to([...at.toArray(), ...turn.toArray()], how().mode === 'turn');
    done(held);
  }

  return { gizmoDrag, planeDrag, nudge };
}
