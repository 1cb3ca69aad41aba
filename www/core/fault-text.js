/**
 * A fault of the document as the page says it: the planner's own parts, with the page's word for null, which is an empty
 * cell.
 */
import { sentence } from './format.js';

/**
 * What is wrong, and what would be accepted. The line of a text that the person may never have seen is told only where no
 * place of the document is known.
 * @param {import('./types.js').Fault} fault
 */
export function faultParts({ what, accepted, optional, where, line, column }) {
  const at = where || line === undefined ? '' : `Line ${line}, column ${column}. `;
  return { what: sentence(at + what), remedy: `Accepted: ${accepted}${optional ? ', or an empty cell' : ''}.` };
}

/** Both in one. @param {import('./types.js').Fault} fault */
export function faultText(fault) {
  const { what, remedy } = faultParts(fault);
  return `${what} ${remedy}`;
}
