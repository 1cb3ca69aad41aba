/**
 * A key frame as something to be moved by hand: every move is an edit of the document, all of one drag one step of undo.
 *
 * @typedef {object} Target what a hand moves
 * @property {string} name
 * @property {() => ArrayLike<number> | null} pose where it is now: x y z, quaternion x y z w; null while that is not known
 * @property {(kind: 'drag' | 'nudge') => void} begin
 * @property {(pose: ArrayLike<number>, turned: boolean) => void} to turned, or else shifted
 * @property {() => void} cancel back to where it was
 * @property {() => string} tell where it is, in words
 */
import { Quaternion, Vector3 } from 'three';
import { setValue } from '../../core/edits.js';
import { setKeyFramePose } from '../../core/key-frame-edits.js';
import { angle, short } from '../../core/format.js';
import { frameMatrix, frameOf } from '../../core/poses.js';
import { ANGLE_DIGITS, lengthDigits, rounded } from './steps.js';

const LENGTHS = /** @type {const} */ (['x', 'y', 'z']);
const ANGLES = /** @type {const} */ (['longitude', 'latitude', 'roll']);

/** Whether all coordinates are numbers: text that is none would count as 0, and be lost with the next move. @param {import('../../core/types.js').Frame} frame */
const isPose = (frame) => [...LENGTHS, ...ANGLES].every((name) => typeof (frame[name] ?? 0) === 'number');

let drags = 0;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'player'>} app
 * @param {number} index
 * @param {() => number} size the scene's radius
 * @returns {Target}
 */
export function keyFrameTarget({ store, player }, index, size) {
  const key = () => store.doc.motion.key_frames[index];
  /** Edits with one mark are one step of undo. */
  let mark = '';
  let before = key();

  /** Shows the moment of this key frame: the linkage answers under the hand. */
  function goThere() {
    const { motion, doc } = store.result;
    if (!motion || !doc) return;
    const keys = doc.motion.key_frames;
    const { time } = keys[index] ?? {};
    const first = motion.time[0];
    const last = motion.time[motion.frames - 1];
    const share = typeof time === 'number' && last > first ? (time - first) / (last - first) : index / Math.max(1, keys.length - 1);
    player.pause();
    player.frame = share * (motion.frames - 1);
  }

  return {
    get name() {
      return key()?.name || `key ${index + 1}`;
    },
    pose() {
      if (!key() || !isPose(key())) return null;
      const [at, turn] = [new Vector3(), new Quaternion()];
      frameMatrix(key()).decompose(at, turn, new Vector3());
      return [...at.toArray(), ...turn.toArray()];
    },
    begin(kind) {
      mark = kind === 'drag' ? `drag ${++drags}` : `nudge ${index}`;
      before = key();
      goThere();
    },
    to(pose, turned) {
      const old = key();
      const found = frameOf(pose, old);
      /** What the hand did not touch stays as it was written. @param {keyof typeof found} name @param {number} digits */
      const value = (name, digits) => (Math.abs(found[name] - Number(old[name] ?? 0)) < 0.6 * 10 ** -digits ? old[name] : rounded(found[name], digits));
      const coordinates = turned ? ANGLES : LENGTHS;
      const digits = turned ? ANGLE_DIGITS : lengthDigits(size());
      const change = Object.fromEntries(coordinates.map((name) => [name, value(name, digits)]));
      store.edit((doc) => setKeyFramePose(doc, index, change), mark);
    },
    cancel() {
      store.edit((doc) => setValue(doc, `motion.key_frames[${index}]`, before), mark);
    },
    tell() {
      const unit = store.doc.length_unit ?? '';
      const at = (/** @type {unknown} */ value) => (typeof value === 'number' ? value : 0);
      const { x, y, z, longitude, latitude, roll } = key() ?? {};
      const turn = [longitude, latitude, roll].map((value) => angle((at(value) * Math.PI) / 180));
      return `x ${short(at(x))}, y ${short(at(y))}, z ${short(at(z))}${unit && ` ${unit}`}; lon ${turn[0]}, lat ${turn[1]}, roll ${turn[2]}`;
    },
  };
}
