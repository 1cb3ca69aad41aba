/**
 * The parameters of a document by their names and places. What is done with them is in parameters.js.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */

/** @param {MechanismDocument} doc */
export const parametersOf = (doc) => doc.parameters ?? {};

/** The place of a parameter's value. @param {string} name */
export const parameterPath = (name) => `parameters.${name}`;

/** The parameter that a path is of. @param {string} path */
export const parameterAt = (path) => /^parameters\.(\w+)$/.exec(path)?.[1];

/** The parameter that a value of the document is and nothing else, such as `base`. @param {MechanismDocument} doc @param {unknown} value */
export const parameterAlone = (doc, value) => (typeof value === 'string' && Object.hasOwn(parametersOf(doc), value.trim()) ? value.trim() : undefined);
