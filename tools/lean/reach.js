// Which parts of the 3D library nothing in www/ can reach. A bundler leaves out what nobody imports, and no methods; here the
// world is closed: all code that touches the library's things is in www/ or in the library, so a method that none of it
// names is never called.
import { basename, join } from 'node:path';
import { CONSTANTS, THREE, edited, isProperty, read } from './modules.js';
import { METHODS } from './never.js';
import { isOfBrowser } from './start.js';
import { createTruth } from './truth.js';

/** @typedef {import('./modules.js').Node} Node @typedef {import('./modules.js').Edit} Edit */

const isFunction = (/** @type {Node} */ node) => node?.type === 'FunctionExpression' || node?.type === 'ArrowFunctionExpression';
/** `this.name = function …;`, which is a method too. @param {Node} node */
const methodSet = (node) => node.type === 'ExpressionStatement' && node.expression.type === 'AssignmentExpression' && isProperty(node.expression.left) && isFunction(node.expression.right) && node.expression.left.property.name;

/**
 * What is reached from www/.
 * @param {{imports: {from: string, name: string}[], names: Iterable<string>, flags: Iterable<string>}} start
 * @param {(file: string) => string} text of a module
 */
export function reached(start, text) {
  /** @type {Map<string, ReturnType<typeof read>>} */
  const modules = new Map();
  const module = (/** @type {string} */ file) => {
    const known = modules.get(file);
    if (known) return known;
    const made = read(file, text(file));
    modules.set(file, made);
    return made;
  };
  /** Names of properties that are read, names of flags that are set, and names that modules have for what is reached. */
  const names = new Set(start.names);
  const flags = new Set(start.flags);
  /** @type {Map<string, Set<string>>} */
  const used = new Map();
  const usedIn = (/** @type {string} */ file) => used.get(file) ?? used.set(file, new Set()).get(file);
  /** Constants of the library that stand somewhere else than in a comparison. */
  const given = new Set(start.imports.filter(({ from }) => from === CONSTANTS || from === join(THREE, 'Three.js')).map(({ name }) => name));
  const { fixed, isNotGiven, truth } = createTruth({ flags, given, module });
  let grown = true;
  const add = (/** @type {Set<string> | undefined} */ set, /** @type {string} */ name) => {
    if (set?.has(name)) return;
    set?.add(name);
    grown = true;
  };

  /** @param {string} file @returns {[string, string][]} all that a module exports */
  const namesOf = (file) => [...[...module(file).exports.keys()].map((name) => /** @type {[string, string]} */ ([file, name])), ...module(file).all.flatMap(namesOf)];

  /** Finds where an exported name is declared. @param {string} file @param {string} name @returns {boolean} */
  function reach(file, name) {
    const { exports, all } = module(file);
    const one = exports.get(name);
    if (one?.own) use(file, one.own);
    else if (one) reach(one.from, one.name);
    else return all.some((other) => reach(other, name));
    return true;
  }

  /** @param {string} file @param {string} name */
  function use(file, name) {
    const from = module(file).imports.get(name);
    add(usedIn(file), name);
    if (from?.from === CONSTANTS) add(given, from.name);
    if (from && from.from) {
      if (from.name === '*') for (const [, one] of namesOf(from.from)) reach(from.from, one);
      else if (!reach(from.from, from.name)) throw new Error(`${from.from} has no ${from.name}`);
    }
  }

  /**
   * Visits what can run.
   * @param {Node} node @param {string} file
   * @param {{edit?: (edit: Edit) => void, owner?: boolean}} on
   */
  function visit(node, file, on) {
    if (!node || typeof node.type !== 'string') return;
    const go = (/** @type {Node} */ part) => visit(part, file, on);
    const cut = (/** @type {Node} */ part, by = '') => on.edit?.([part.start, part.end, by]);
    /** The blanks and brackets around it go with the rest. @param {Node} part */
    const only = (part) => {
      cut({ start: node.start, end: part.start }, '( ');
      go(part);
      cut({ start: part.end, end: node.end }, ' )');
    };
    switch (node.type) {
      case 'Identifier':
        return use(file, node.name);
      case 'Literal':
        if (typeof node.value === 'string' && /^[\w$]+$/.test(node.value)) add(names, node.value);
        return;
      case 'MemberExpression':
        if (fixed(node)) return cut(node, `( ${fixed(node)?.is === undefined ? 'void 0' : String(fixed(node)?.is)} )`);
        go(node.object);
        return node.computed ? go(node.property) : isOfBrowser(node.object) ? undefined : add(names, node.property.name);
      case 'AssignmentExpression':
        if (isProperty(node.left) && node.operator === '=') {
          if (/^is[A-Z]/.test(node.left.property.name)) add(flags, node.left.property.name);
          go(node.left.object);
        } else go(node.left);
        return go(node.right);
      case 'ExpressionStatement': {
        const name = methodSet(node);
        return name && !names.has(name) ? cut(node, ';') : go(node.expression);
      }
      case 'IfStatement': {
        const always = truth(node.test, file);
        if (always === null) [node.test, node.consequent, node.alternate].forEach(go);
        else if (always) {
          cut({ start: node.start, end: node.consequent.start });
          go(node.consequent);
          if (node.alternate) cut({ start: node.consequent.end, end: node.end });
        } else if (node.alternate) {
          cut({ start: node.start, end: node.alternate.start });
          go(node.alternate);
        } else cut(node, ';');
        return;
      }
      case 'ConditionalExpression': {
        const always = truth(node.test, file);
        if (always === null) return [node.test, node.consequent, node.alternate].forEach(go);
        return only(always ? node.consequent : node.alternate);
      }
      case 'LogicalExpression': {
        const left = node.operator === '??' ? null : truth(node.left, file);
        if (left === null) return [node.left, node.right].forEach(go);
        return only((node.operator === '||') === left ? node.left : node.right);
      }
      case 'BinaryExpression': {
        const always = truth(node, file);
        if (always === null) return [node.left, node.right].forEach(go);
        return cut(node, String(always));
      }
      case 'SwitchStatement': {
        go(node.discriminant);
        const ends = (/** @type {Node | undefined} */ one) => !one || /^(Break|Return)Statement$/.test(one.consequent.at(-1)?.type);
        node.cases.forEach((/** @type {Node} */ one, /** @type {number} */ index) => {
          if (one.test && isNotGiven(one.test, file) && ends(node.cases[index - 1]) && ends(one)) cut(one);
          else each(one, go);
        });
        return;
      }
      case 'FunctionDeclaration':
        // Inside another it is reached where it is named; at the top of a module it is visited as one of its parts.
        if (!on.owner && !usedIn(file)?.has(node.id.name)) return cut(node);
        on = { ...on, owner: false };
        return [...node.params, node.body].forEach((part) => visit(part, file, on));
      case 'MethodDefinition': {
        if (node.computed) go(node.key);
        const name = node.key.name;
        const only = METHODS[basename(file, '.js')];
        if (node.kind === 'method' && !node.computed && node.key.type !== 'PrivateIdentifier' && (!names.has(name) || (only && !only.includes(name)))) return cut(node);
        return go(node.value);
      }
      case 'ReturnStatement':
        // What a part of the renderer hands out, by names.
        if (node.argument?.type === 'ObjectExpression' && file.includes('/renderers/')) {
          for (const one of node.argument.properties) {
            if (one.type === 'Property' && !one.computed && one.value.type === 'Identifier' && !names.has(one.key.name)) on.edit?.([one.start, endOf(one, file), '']);
            else go(one);
          }
          return;
        }
        return go(node.argument);
      case 'Property':
      case 'PropertyDefinition':
        if (node.computed) go(node.key);
        else if (/^is[A-Z]/.test(node.key.name ?? '')) add(flags, node.key.name);
        return go(node.value);
      case 'ObjectPattern':
        for (const one of node.properties) {
          if (one.type === 'Property' && !one.computed) add(names, one.key.name ?? one.key.value);
          go(one);
        }
        return;
      case 'VariableDeclarator':
      case 'ClassDeclaration':
      case 'ClassExpression':
      case 'FunctionExpression':
        for (const key of Object.keys(node)) if (key !== 'id' || node.type === 'VariableDeclarator') if (node.id !== node[key] || node.id.type !== 'Identifier') each(node[key], go);
        return;
      case 'LabeledStatement':
        return go(node.body);
      case 'BreakStatement':
      case 'ContinueStatement':
        return;
      default:
        for (const key of Object.keys(node)) if (key !== 'type' && key !== 'start' && key !== 'end') each(node[key], go);
    }
  }
  const each = (/** @type {any} */ value, /** @type {(node: Node) => void} */ go) => (Array.isArray(value) ? value.forEach(go) : go(value));
  /** With the comma behind it. @param {Node} node @param {string} file */
  const endOf = (node, file) => node.end + (/^\s*,/.exec(module(file).code.slice(node.end))?.[0].length ?? 0);

  /** A part of a module with its methods. @param {Node} node @param {string} file @param {(edit: Edit) => void} [edit] */
  const whole = (node, file, edit) => visit(node, file, { edit, owner: node.type === 'FunctionDeclaration' });

  while (grown) {
    grown = false;
    for (const { from, name } of start.imports) if (!reach(from, name)) throw new Error(`${from} has no ${name}`);
    for (const { file, own, loose } of modules.values()) {
      const mine = usedIn(file);
      for (const [name, node] of own) if (mine?.has(name)) whole(node, file);
      if (mine?.size) for (const node of loose) whole(node, file);
    }
  }
  return {
    flags,
    files: [...modules.keys()],
    /** @param {string} file */
    isReached: (file) => Boolean(used.get(file)?.size),
    /** The parts of a module that can run. @param {string} file @returns {string} */
    kept(file) {
      if (!used.get(file)?.size) return module(file).code;
      /** @type {Edit[]} */
      const edits = [];
      const { own, loose, code } = module(file);
      for (const [name, node] of own) {
        if (used.get(file)?.has(name)) whole(node, file, (edit) => edits.push(edit));
        // A bundler leaves out the rest of it, which others may still export.
        else if (/^(Function|Class)Declaration$/.test(node.type)) edits.push([node.body.start, node.body.end, '{}']);
      }
      for (const node of loose) whole(node, file, (edit) => edits.push(edit));
      return edited(code, edits);
    },
  };
}
