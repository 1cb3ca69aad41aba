// The modules of the 3D library: where each stands, and the parts of one by their names.
import { readdirSync, realpathSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseAst } from 'rolldown/parseAst';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
export const THREE = realpathSync(at('../node_modules/three/src'));
const ADDONS = join(dirname(THREE), 'examples/jsm');
export const CONSTANTS = join(THREE, 'constants.js');
const STAND_INS = new Map(readdirSync(at('../three')).map((file) => [file, at(`../three/${file}`)]));

/** @typedef {any} Node as the parser makes it @typedef {[number, number, string]} Edit from, to, what comes there */

/** The file that an import of the library or of a module in it means. @param {string} name @param {string} importer */
export function fileOf(name, importer) {
  if (name === 'three') return join(THREE, 'Three.js');
  if (name.startsWith('three/addons/')) return join(ADDONS, name.slice('three/addons/'.length));
  if (name.startsWith('three/src/')) return join(THREE, name.slice('three/src/'.length));
  if (!/^\.{1,2}\//.test(name)) return null;
  return (importer.startsWith(THREE) && standInFor(name)) || join(dirname(importer), name);
}

/** The module of tools/three that takes the place of one of the library's own. @param {string} name as it is imported */
export const standInFor = (name) => (/^\.{1,2}\//.test(name) ? (STAND_INS.get(name.slice(name.lastIndexOf('/') + 1)) ?? null) : null);

/** Whether a file is the library's or one that stands in for it. @param {string} file */
export const isOfThree = (file) => file.startsWith(dirname(THREE)) || [...STAND_INS.values()].includes(file);

/** Whether it is `object.name`. @param {Node} node */
export const isProperty = (node) => node?.type === 'MemberExpression' && !node.computed;

/** A module's parts by the names that they have in it. @param {string} file @param {string} code */
export function read(file, code) {
  const { body } = parseAst(code);
  const module = { file, code, body, imports: new Map(), exports: new Map(), all: /** @type {string[]} */ ([]), own: new Map(), loose: /** @type {Node[]} */ ([]) };
  const declare = (/** @type {Node} */ node) => {
    if (node.type === 'VariableDeclaration') for (const one of node.declarations) if (one.id.type === 'Identifier') module.own.set(one.id.name, one);
      else module.loose.push(node);
    else module.own.set(node.id.name, node);
  };
  for (const node of body) {
    const from = node.source && fileOf(node.source.value, file);
    if (node.type === 'ImportDeclaration') {
      for (const one of node.specifiers) module.imports.set(one.local.name, { from, name: one.type === 'ImportDefaultSpecifier' ? 'default' : (one.imported?.name ?? '*') });
    } else if (node.type === 'ExportAllDeclaration') module.all.push(from);
    else if (node.type === 'ExportDefaultDeclaration') {
      module.own.set('default', node.declaration);
      module.exports.set('default', { own: 'default' });
    } else if (node.type === 'ExportNamedDeclaration') {
      if (node.declaration) {
        declare(node.declaration);
        for (const one of node.declaration.declarations ?? [node.declaration]) module.exports.set(one.id.name, { own: one.id.name });
      }
      for (const one of node.specifiers) module.exports.set(one.exported.name, from ? { from, name: one.local.name } : { own: one.local.name });
    } else if (/Declaration$/.test(node.type)) declare(node);
    else module.loose.push(node);
  }
  return module;
}

/** Lines stay where they are. @param {string} code @param {Edit[]} edits */
export function edited(code, edits) {
  let made = '';
  let done = 0;
  for (const [from, to, by] of edits.sort(([a], [b]) => a - b)) {
    if (from < done) continue;
    made += `${code.slice(done, from)}${by}${code.slice(from, to).replace(/[^\n]+/g, '')}`;
    done = to;
  }
  return made + code.slice(done);
}
