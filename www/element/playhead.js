/**
 * The playhead as the page around it sees it: where it is set before there is a motion, it goes once that is there.
 */
import { Refusal } from '../core/refusal.js';

/** @param {import('../core/linkage.js').Parts} parts */
export function createPlayhead({ store, player }) {
  /** @type {{frame?: number, time?: number} | null} */
  let wanted = null;

  /** @param {number} frame */
  function goTo(frame) {
    const last = (store.result.motion?.frames ?? 1) - 1;
    if (frame > last) throw new Refusal(`The attribute frame is “${frame}”. Accepted: a whole number from 0 to ${last}, the frames of this motion.`);
    // What is written back of a playhead between two frames leaves it there.
    if (frame !== player.frame) player.frame = frame;
  }

  return {
    get frame() {
      return player.first.isAwaited ? (wanted?.frame ?? 0) : player.frame;
    },
    set frame(frame) {
      if (player.first.isAwaited) wanted = { frame };
      else goTo(frame);
    },
    /** From the first frame. */
    get time() {
      return player.first.isAwaited ? (wanted?.time ?? 0) : player.currentTime;
    },
    set time(time) {
      if (player.first.isAwaited) wanted = { time };
      else player.currentTime = time;
    },
    get duration() {
      return player.first.isAwaited ? 0 : player.duration;
    },
    /** Whether it has been set, and has yet to go there. */
    get isWanted() {
      return wanted !== null;
    },
    /** What was wanted of another document is over. */
    forget() {
      wanted = null;
    },
    /** The motion is there: goes where it was set. */
    settle() {
      const { frame, time } = wanted ?? {};
      wanted = null;
      if (frame !== undefined) goTo(frame);
      if (time !== undefined) player.currentTime = time;
    },
  };
}
