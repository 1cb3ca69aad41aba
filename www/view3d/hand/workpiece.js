/**
 * The workpiece as something to be pulled: the linkage follows to the closest pose that it can reach, live.
 */
import { ask } from '../../core/ask.js';
import { textOf } from '../../core/document-text.js';
import { short } from '../../core/format.js';
import { groupAt, isDriven, shown } from '../../core/shown.js';
import { endWords, statusWords } from '../../core/status-words.js';

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'planner' | 'say'>} app
 * @returns {import('./key-frame.js').Target & {busy: () => boolean}}
 */
export function workpieceTarget({ store, planner, say }) {
  /** What was shown before the hand came. @type {import('../../core/types.js').View['posture']} */
  let before = null;
  /** Counts the pulls: an answer to a pull that was taken back is not shown. */
  let stay = 0;
  let asked = 0;

  /** @param {Float64Array} goal */
  async function pull(goal) {
    const now = shown(store);
    if (!now) return;
    const { doc } = now;
    const mine = stay;
    asked++;
    const pulled = await ask(() => planner.pull(textOf(doc), groupAt(now.joints, now), goal), 'pull the workpiece');
    asked--;
    if (pulled.is === 'trouble') say(`The workpiece was not moved. ${pulled.message}`, { stays: true });
    if (pulled.is === 'answer' && mine === stay && store.result.doc === doc) store.setView({ posture: pulled.value, playing: false });
  }

  return {
    name: 'workpiece',
    busy: () => asked > 0,
    pose() {
      const now = shown(store);
      return now && groupAt(now.pose, now);
    },
    begin() {
      before = store.view.posture;
      stay++;
      store.setView({ playing: false });
    },
    to(pose) {
      pull(Float64Array.from(pose));
    },
    cancel() {
      stay++;
      store.setView({ posture: before });
    },
    tell() {
      const now = shown(store);
      if (!now) return '';
      const unit = now.doc.length_unit;
      const at = Array.from(groupAt(now.pose, now).subarray(0, 3), (value) => short(value, 3));
      const place = `x ${at[0]}, y ${at[1]}, z ${at[2]}${unit ? ` ${unit}` : ''}`;
      const { posture } = store.view;
      if (!posture) return place;
      // Neither a joint that is driven nor an iterate follows the hand on the workpiece.
      const name = isDriven(store.view.posture) ? 'driven' : posture.note && posture.status === 'stalled' ? 'iterate' : posture.status;
      const { sign, word } = statusWords(name);
      if (posture.note || ['reached', 'driven'].includes(name)) return `${place}; ${sign} ${word.toLowerCase()}`;
      return `${place}; ${sign} ${endWords(name, posture.translation_gap, posture.rotation_gap, 'the hand', unit)}`;
    },
  };
}
