/**
 * The number at a place of the document: as typed, or what the expression there was when the document was planned last.
 */
import { expressionValue } from './expression-values.js';
import { valueAt } from './path.js';

/** @param {Pick<import('./store.js').Store, 'doc' | 'result'>} store @param {string} path @returns {number | null} null where none is known */
export function typedNumber(store, path) {
  const typed = valueAt(store.doc, path);
  if (typeof typed === 'number' && Number.isFinite(typed)) return typed;
  return typeof typed === 'string' ? (expressionValue(store, path) ?? null) : null;
}

/** A part of the document with numbers for its expressions; what is not known stays as typed. @param {Pick<import('./store.js').Store, 'doc' | 'result'>} store @param {string} path @returns {any} */
export function withNumbers(store, path) {
  const part = valueAt(store.doc, path);
  if (typeof part === 'string') return typedNumber(store, path) ?? part;
  if (Array.isArray(part)) return part.map((_, i) => withNumbers(store, `${path}[${i}]`));
  if (part && typeof part === 'object') return Object.fromEntries(Object.keys(part).map((name) => [name, withNumbers(store, `${path}.${name}`)]));
  return part;
}
