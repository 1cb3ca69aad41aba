/**
 * The motion as text: a table, data, a MuJoCo model; the planner writes them.
 */
import { textOf } from '../core/document-text.js';
import { fileName, saveFile } from './save.js';

const FILES = {
  csv: { ending: 'csv', type: 'text/csv' },
  json: { ending: 'motion.json', type: 'application/json' },
  mjcf: { ending: 'mjcf.xml', type: 'application/xml' },
};

/** @param {import('../element/workbench.js').App} app @param {keyof typeof FILES} format */
export async function exportMotion({ store, planner, say }, format) {
  const { doc } = store.result;
  if (!doc) return;
  const text = await planner.exportMotion(textOf(doc), format);
  const { ending, type } = FILES[format];
  const name = fileName(doc, ending);
  saveFile(name, new Blob([text], { type }));
  say(`Saved ${name}.`);
}
