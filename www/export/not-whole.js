/**
 * Why the motion that is shown is not the whole motion of the document, so that no file of it is written.
 */

/**
 * @param {Pick<import('../core/store.js').Store, 'doc' | 'result'>} store
 * @returns {string} a sentence without its full stop; empty where the motion is the document's, and whole
 */
export function notWhole({ doc, result: { motion, doc: planned, fault, trouble } }) {
  const old = motion ? ', and the motion that is shown is of an earlier one' : '';
  if (fault) return `The document has a fault${old}: mend it first`;
  if (trouble) return `The planner failed on this document or could not be loaded${old}`;
  if (!motion || planned !== doc) return `The document is still being planned${old}`;
  return motion.partial ? 'The motion is planned only in part: plan the rest first' : '';
}
