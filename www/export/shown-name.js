/**
 * A file's name for the motion that is shown: 3rps.csv, 3rps-best.csv where it is the best one, 3rps-calmer.csv.
 */
import { bestMotions } from '../core/best-motions.js';
import { fileName } from './file-name.js';

/** @param {Pick<import('../core/types.js').Result, 'doc' | 'motion'>} result @param {string} ending */
export function shownName({ doc, motion }, ending) {
  const best = motion && bestMotions.get(motion);
  return fileName(best ? { name: `${doc?.name || 'linkage'} ${best.name}` } : doc, ending);
}
