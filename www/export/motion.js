/**
 * The motion that is shown as text: a table, data, a MuJoCo model; the planner writes them.
 */
import { ask } from '../core/ask.js';
import { bestMotions, withoutGhost } from '../core/best-motions.js';
import { textOf } from '../core/document-text.js';
import { saveFile } from './save.js';
import { shownName } from './shown-name.js';

/** @type {Record<import('../core/types.js').ExportFormat, {ending: string, type: string}>} */
const FILES = {
  csv: { ending: 'csv', type: 'text/csv' },
  json: { ending: 'motion.json', type: 'application/json' },
  mjcf: { ending: 'mjcf.xml', type: 'application/xml' },
};

/**
 * @param {import('../element/workbench.js').App} app @param {import('../core/types.js').ExportFormat} format
 * @param {import('../core/types.js').ExportOptions} options
 */
export async function exportMotion({ store, planner, say }, format, options) {
  const { doc, motion } = store.result;
  if (!doc) return;
  const best = motion && bestMotions.get(motion);
  const text = await ask(() => (best ? best.write(format, options) : planner.exportMotion(textOf(doc), format, options)), 'write the motion');
  if (text.is === 'late') return;
  if (text.is !== 'answer') return say(`The file could not be made. ${text.message}`, { stays: true });
  const { ending, type } = FILES[format];
  const name = shownName({ doc, motion }, ending);
  saveFile(name, new Blob([text.value], { type }));
  const what = best ? `${best.words}${best.switches ? ': the file has all points of its path at a switch' : ''}` : withoutGhost(motion);
  say(`Saved ${name}.${what && ` ${what}.`}`);
}
