// What is known of a condition in the 3D library before it runs: flags that nothing reached has, settings that nothing gives,
// and comparisons with constants that nothing has.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { CONSTANTS, THREE, isProperty } from './modules.js';
import { NEVER_SET } from './never.js';

/** @typedef {import('./modules.js').Node} Node */

/** Flags that classes of the library give themselves, reached or not: `isMesh`. */
function allFlags() {
  const files = readdirSync(THREE, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.js'));
  return new Set(files.flatMap((name) => [...readFileSync(join(THREE, name), 'utf8').matchAll(/\bthis\.(is[A-Z]\w*) = true/g)].map(([, flag]) => flag)));
}

/**
 * @param {object} reached what is reached by now
 * @param {Set<string>} reached.flags that are set
 * @param {Set<string>} reached.given constants of the library that stand somewhere else than in a comparison
 * @param {(file: string) => ReturnType<typeof import('./modules.js').read>} reached.module
 */
export function createTruth({ flags, given, module }) {
  const known = allFlags();

  /**
   * What a property is wherever it is read: undefined is a flag that nothing reached has; a setting that nothing gives is as
   * it is by default. Null where that is not known.
   * @param {Node} node @returns {{is: unknown} | null}
   */
  function fixed(node) {
    if (!isProperty(node)) return null;
    const { object, property } = node;
    const settings = object.type === 'Identifier' && Object.hasOwn(NEVER_SET, object.name) ? NEVER_SET[object.name] : {};
    if (Object.hasOwn(settings, property.name)) return { is: settings[property.name] };
    return known.has(property.name) && !flags.has(property.name) ? { is: undefined } : null;
  }

  /** @param {Node} node @param {string} file @returns {{is: unknown} | null} */
  function valueOf(node, file) {
    if (node.type === 'Literal') return { is: node.value };
    if (node.type !== 'Identifier') return null;
    if (node.name === 'undefined') return { is: undefined };
    const from = module(file).imports.get(node.name);
    return from?.from === CONSTANTS ? valueOf(module(CONSTANTS).own.get(from.name).init, CONSTANTS) : null;
  }

  /** A constant that nothing has: a comparison with it fails. @param {Node} node @param {string} file */
  function isNotGiven(node, file) {
    const from = node.type === 'Identifier' && module(file).imports.get(node.name);
    return from && from.from === CONSTANTS && !given.has(from.name);
  }

  /** @param {Node} node @param {string} file @returns {boolean | null} null where it is known only when it runs */
  function truth(node, file) {
    if (node.type === 'ParenthesizedExpression') return truth(node.expression, file);
    const value = fixed(node);
    if (value) return Boolean(value.is);
    if (node.type === 'Literal' && typeof node.value === 'boolean') return node.value;
    if (node.type === 'UnaryExpression' && node.operator === '!') {
      const inner = truth(node.argument, file);
      return inner === null ? null : !inner;
    }
    if (node.type === 'BinaryExpression') {
      const { operator, left, right } = node;
      if (/^[!=]==?$/.test(operator) && (isNotGiven(left, file) || isNotGiven(right, file))) return operator[0] === '!';
      const known = fixed(left);
      const against = valueOf(right, file);
      if (!known || !against) return null;
      if (operator === '===' || operator === '!==') return (known.is === against.is) === (operator === '===');
      return operator === '>' ? Number(known.is) > Number(against.is) : null;
    }
    if (node.type === 'LogicalExpression' && node.operator !== '??') {
      const [left, right] = [truth(node.left, file), truth(node.right, file)];
      const decides = node.operator === '||';
      if (left === decides || right === decides) return left === decides ? decides : null;
      return left === null || right === null ? null : !decides;
    }
    return null;
  }

  return { fixed, isNotGiven, truth };
}
