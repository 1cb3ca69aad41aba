/**
 * What the expressions of the shown document are worth, as the planner has told it with the motion.
 *
 * @typedef {Pick<import('./store.js').Store, 'doc' | 'result'>} Shown
 */
import { parameterAt } from './parameter-names.js';
import { valueAt } from './path.js';

/** @type {WeakMap<object, Map<string, number>>} */
const known = new WeakMap();

/** All values by their places. @param {import('./types.js').Motion} motion */
function valuesOf(motion) {
  const values = known.get(motion) ?? new Map((motion.expressions ?? []).map(({ path, value }) => [path, value]));
  known.set(motion, values);
  return values;
}

/**
 * The value of the expression at a place, in the document's units; undefined where it is not known, as that of one at fault.
 * @param {Shown} shown @param {string} path
 */
export function expressionValue({ doc, result }, path) {
  const { motion, doc: planned, fault } = result;
  if (!motion || !planned || valueAt(planned, path) !== valueAt(doc, path)) return undefined;
  // While a newer document is at fault, its parameters may be others.
  if (fault && planned.parameters !== doc.parameters) return undefined;
  const name = parameterAt(path);
  if (name !== undefined) return motion.parameters?.find((parameter) => parameter.name === name)?.value;
  return valuesOf(motion).get(path);
}
