// Where the search for what is reached of the 3D library begins: with what www/ imports of it, and with each name that www/ reads of anything.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseAst } from 'rolldown/parseAst';
import { fileOf } from './modules.js';

/** What has no thing of the library's: `Math.min` is no vector's. @param {any} node */
export const isOfBrowser = (node) => node.type === 'Identifier' && /^(Math|Number|Object|Array|String|JSON|Date|Promise|Reflect|Symbol|Intl|document|window|console|performance|navigator|gl|_gl)$/.test(node.name);

/** All names in www/ by which something of the library could be meant, what is imported from it, and the flags that are set. @param {string} www */
export function startOf(www) {
  const imports = [];
  const names = new Set();
  const shaders = [];
  const flags = new Set();
  const collect = (/** @type {any} */ node) => {
    if (!node || typeof node !== 'object') return;
    if (Array.isArray(node)) return node.forEach(collect);
    if (node.type === 'ImportDeclaration' && /^three($|\/)/.test(node.source.value)) {
      for (const one of node.specifiers) imports.push({ from: fileOf(node.source.value, ''), name: one.imported.name });
    }
    if (node.type === 'MemberExpression' && !node.computed && !isOfBrowser(node.object)) names.add(node.property.name);
    if (node.type === 'AssignmentExpression' && /^is[A-Z]/.test(node.left.property?.name)) flags.add(node.left.property.name);
    if (node.type === 'ObjectPattern') for (const one of node.properties) if (one.key?.name) names.add(one.key.name);
    if (node.type === 'Literal' && /^[\w$]+$/.test(node.value)) names.add(node.value);
    for (const key of Object.keys(node)) collect(node[key]);
  };
  for (const file of readdirSync(www, { recursive: true, encoding: 'utf8' })) {
    if (!file.endsWith('.js') || /^(pkg|pkg-first|dist|public)\b/.test(file)) continue;
    const code = readFileSync(join(www, file), 'utf8');
    collect(parseAst(code).body);
    if (code.includes('gl_')) shaders.push(code);
  }
  return { imports, names, shaders, flags };
}
