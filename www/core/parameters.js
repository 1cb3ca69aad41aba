/**
 * Parameters of a document and the expressions that name them: pure functions. What an expression is worth is Rust's to say.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./types.js').Entry} Entry
 * @typedef {{path: string, text: string}} Expression a number of the document that is given as a text
 */
import { kindOf } from './number-steps.js';
import { parameterPath, parametersOf } from './parameter-names.js';
import { valueAt, withValueAt } from './path.js';

/** Fields with texts that are no numbers. Names of parameters are not among them: they are looked at by themselves. */
export const TEXTS = new Set(['$schema', 'name', 'about', 'length_unit', 'angles', 'type', 'convention', 'order', 'interpolation', 'method', 'metric', 'ramp']);

/** Fields with numbers that are not measured: a document's version, and what a driver counts. */
const COUNTS = new Set(['version', 'chain', 'joint', 'freedom']);

const NAME = /^[A-Za-z_][A-Za-z0-9_]*$/;

/** A name in an expression as a whole word; the `e3` of 1e3 is none. @param {string} name */
const word = (name) => new RegExp(`(?<![\\w.])${name}(?!\\w)`, 'g');

/**
 * Visits every number of a document that is measured, also one given as a text.
 * @param {MechanismDocument} doc @param {(path: string, value: Entry) => void} visit
 */
function walk(doc, visit) {
  /** @param {unknown} node @param {string} path */
  const into = (node, path) => {
    if (typeof node === 'number' || typeof node === 'string') visit(path, node);
    else if (Array.isArray(node)) node.forEach((item, index) => into(item, `${path}[${index}]`));
    else if (typeof node === 'object' && node !== null) {
      for (const [name, value] of Object.entries(node)) {
        if (path === 'parameters' || !(TEXTS.has(name) || COUNTS.has(name))) into(value, path ? `${path}.${name}` : name);
      }
    }
  };
  into(doc, '');
}

/** All expressions of a document, those of its parameters first. @param {MechanismDocument} doc */
function expressionsOf(doc) {
  /** @type {Expression[]} */
  const found = [];
  walk({ ...doc, parameters: undefined }, (path, text) => typeof text === 'string' && found.push({ path, text }));
  const own = Object.entries(parametersOf(doc)).flatMap(([name, text]) => (typeof text === 'string' ? [{ path: parameterPath(name), text }] : []));
  return [...own, ...found];
}

/** Where a parameter is used. @param {MechanismDocument} doc @param {string} name */
export const usesOf = (doc, name) => expressionsOf(doc).filter(({ text }) => word(name).test(text)).map(({ path }) => path);

/** The document with a text in the place of a name, wherever it is used. @param {MechanismDocument} doc @param {string} name @param {(text: string) => Entry} change */
function withUses(doc, name, change) {
  return usesOf(doc, name).reduce((next, path) => withValueAt(next, path, change(valueAt(next, path))), doc);
}

/** Another name of a parameter, also where it is used. @param {MechanismDocument} doc @param {string} old @param {string} fresh @returns {MechanismDocument} */
export function renameParameter(doc, old, fresh) {
  const changed = withUses(doc, old, (text) => text.replace(word(old), fresh));
  // In its old place among the others.
  return { ...changed, parameters: Object.fromEntries(Object.entries(parametersOf(changed)).map(([name, value]) => [name === old ? fresh : name, value])) };
}

/** @param {MechanismDocument} doc @param {string} name @returns {MechanismDocument} */
function withoutParameter(doc, name) {
  const { [name]: _, ...others } = parametersOf(doc);
  const { parameters: __, ...rest } = doc;
  return Object.keys(others).length ? { ...doc, parameters: others } : rest;
}

/**
 * Without a parameter: its value is in its place where it is used.
 * @param {MechanismDocument} doc @param {string} name
 * @param {number} value
 */
export function removeParameter(doc, name, value) {
  const text = value < 0 ? `(${value})` : String(value);
  return withoutParameter(withUses(doc, name, (used) => (used.trim() === name ? value : used.replace(word(name), text))), name);
}

/** @param {MechanismDocument} doc @param {string} name @param {Entry} value @returns {MechanismDocument} */
export const addParameter = (doc, name, value) => ({ ...doc, parameters: { ...parametersOf(doc), [name]: value } });

/** A name that no parameter has. @param {MechanismDocument} doc @param {string} [like] */
export function freshParameterName(doc, like = 'p') {
  const taken = parametersOf(doc);
  for (let number = 1; ; number++) if (!Object.hasOwn(taken, `${like}${number}`)) return `${like}${number}`;
}

/**
 * What is wrong with a new name, as far as it can be told without the planner, which knows the names of functions and units.
 * @param {MechanismDocument} doc @param {string} name @returns {string} '' if nothing is
 */
export function nameFault(doc, name) {
  if (!NAME.test(name)) return `“${name}” is no name of a parameter. Accepted: a letter or _, then letters, digits and _, such as base_2.`;
  return Object.hasOwn(parametersOf(doc), name) ? `There is already a parameter “${name}”. Accepted: each name once.` : '';
}

/**
 * The other cells with exactly the same number, measured in the same unit.
 * @param {MechanismDocument} doc @param {string} path of a number
 */
export function sameNumbers(doc, path) {
  const wanted = valueAt(doc, path);
  const kind = kindOf(doc, path);
  /** @type {string[]} */
  const found = [];
  walk({ ...doc, parameters: undefined }, (at, value) => value === wanted && at !== path && kindOf(doc, at) === kind && found.push(at));
  return found;
}

/**
 * A parameter with the number of a cell, which is in its place there and in others.
 * @param {MechanismDocument} doc @param {string} path @param {string} name @param {string[]} others paths of cells with the same number
 */
export function nameNumber(doc, path, name, others) {
  const value = valueAt(doc, path);
  return [path, ...others].reduce((next, at) => withValueAt(next, at, name), addParameter(doc, name, value));
}
