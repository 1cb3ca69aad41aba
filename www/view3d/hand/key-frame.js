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
import { keyFramesOf } from '../../core/key-frames.js';
import { Quaternion, Vector3 } from 'three';
import { frameAsWritten } from '../../core/document-angles.js';
import { frameNumbers, withoutForms } from '../../core/frame-numbers.js';
import { setValue } from '../../core/edits.js';
import { setKeyFramePose } from '../../core/key-frame-edits.js';
import { angle, short } from '../../core/format.js';
import { frameOf } from '../../core/frame-of.js';
import { frameMatrix } from '../../core/poses.js';
import { ANGLE_DIGITS, lengthDigits, rounded } from './steps.js';

const LENGTHS = /** @type {const} */ (['x', 'y', 'z']);
const ANGLES = /** @type {const} */ (['longitude', 'latitude', 'roll']);

/** Turns are written in another form when a key frame has one. @type {typeof import('../../core/rotation-forms.js') | null} */
let forms = null;

let drags = 0;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'player' | 'say'>} app
 * @param {number} index
 * @param {() => number} size the scene's radius
 * @returns {Target}
 */
export function keyFrameTarget({ store, player, say }, index, size) {
  const path = `motion.key_frames[${index}]`;
  const key = () => keyFramesOf(store.doc)[index];
  /** Text that has no value would count as 0, and be lost with the next move: then there are none. */
  const numbers = () => (held && held.key === key() ? held.numbers : frameNumbers(store, path));
  /** What the hand made of a key frame in another form, whose numbers are known only when it is planned. @type {{key: object, numbers: NonNullable<ReturnType<typeof frameNumbers>>} | null} */
  let held = null;
  if (!forms && key() && withoutForms(key()) !== key()) {
    // Until it is there, and where it cannot be loaded, the turn is written as angles.
    import('../../core/rotation-forms.js').then((part) => (forms = part), () => {});
  }
  /** Edits with one mark are one step of undo. */
  let mark = '';
  let before = key();
  let origin = store.origin;

  /** Shows the moment of this key frame: the linkage answers under the hand. */
  function goThere() {
    const { motion, plain } = store.result;
    if (!motion || !plain) return;
    const keys = keyFramesOf(plain);
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
      const frame = numbers();
      if (!frame) return null;
      const [at, turn] = [new Vector3(), new Quaternion()];
      frameMatrix(frame).decompose(at, turn, new Vector3());
      return [...at.toArray(), ...turn.toArray()];
    },
    begin(kind) {
      mark = kind === 'drag' ? `drag ${++drags}` : `nudge ${index}`;
      before = key();
      origin = store.origin;
      goThere();
    },
    to(pose, turned) {
      const old = numbers();
      if (!old) return;
      const found = frameOf(pose, old);
      const written = key();
      /** What the hand did not touch stays as it was written. @param {keyof typeof found} name @param {number} digits */
      const value = (name, digits) => (Math.abs(found[name] - old[name]) < 0.6 * 10 ** -digits ? null : rounded(found[name], digits));
      const coordinates = turned ? ANGLES : LENGTHS;
      const digits = turned ? ANGLE_DIGITS : lengthDigits(size());
      const moved = Object.fromEntries(coordinates.flatMap((name) => (value(name, digits) === null ? [] : [[name, value(name, digits)]])));
      const isForm = turned && withoutForms(written) !== written;
      if (isForm && forms) {
        const { frameWith, turnOfFrame } = forms;
        const fresh = { ...found, ...moved, x: old.x, y: old.y, z: old.z };
        const turn = /** @type {number[]} */ (turnOfFrame(fresh, {}));
        store.edit((doc) => setValue(doc, path, frameWith(written, turn, doc)), mark);
        held = { key: key(), numbers: fresh };
        return;
      }
      // In another form all of the turn is written anew.
      const change = frameAsWritten(store.doc, isForm ? { ...found, ...moved, x: written.x, y: written.y, z: written.z } : moved);
      const gone = Object.keys(change).filter((name) => typeof written[/** @type {'x'} */ (name)] === 'string' && change[/** @type {'x'} */ (name)] !== written[/** @type {'x'} */ (name)]);
      store.edit((doc) => setKeyFramePose(isForm ? setValue(doc, path, withoutForms(written)) : doc, index, change), mark);
      if (gone.length) say(`${gone.join(', ')} of ${this.name} ${gone.length === 1 ? 'was an expression and is a number' : 'were expressions and are numbers'} now. Undo takes that back.`);
    },
    cancel() {
      // Another document has a key frame of its own there.
      if (store.origin === origin) store.edit((doc) => setValue(doc, path, before), mark);
    },
    tell() {
      const unit = store.doc.length_unit ?? '';
      const { x, y, z, longitude, latitude, roll } = numbers() ?? { x: 0, y: 0, z: 0, longitude: 0, latitude: 0, roll: 0 };
      const turn = [longitude, latitude, roll].map((value) => angle((value * Math.PI) / 180));
      return `x ${short(x)}, y ${short(y)}, z ${short(z)}${unit && ` ${unit}`}; lon ${turn[0]}, lat ${turn[1]}, roll ${turn[2]}`;
    },
  };
}
