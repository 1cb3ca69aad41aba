// The 3D library as a build has it: each of its modules without what the page does not reach.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { THREE } from './modules.js';
import { LEFT_OUT } from './never.js';
import { reached } from './reach.js';
import { fewerShaders, fewerUniforms, onlyCalled, squeezed } from './shaders.js';
import { startOf } from './start.js';

const SHADERS = join(THREE, 'renderers/shaders');

/**
 * The library's shaders with what is needed of them: the parts that a material's shader includes, or one that `others` names.
 * @param {string} others all that is not a shader of the library and may name one, or a function in one
 */
function shaders(others) {
  const list = readFileSync(join(SHADERS, 'ShaderChunk.js'), 'utf8');
  const files = new Map([...list.matchAll(/^import (?:\* as )?(\w+) from '(.*)';$/gm)].map(([, name, from]) => [name, join(SHADERS, from)]));
  const ofMaterials = fewerShaders(readFileSync(join(SHADERS, 'ShaderLib.js'), 'utf8'));
  /** Each part's key in the list, with its file and which of the file's texts it is. */
  const parts = new Map([...list.matchAll(/^\t(\w+): (\w+)(?:\.(\w+))?,?$/gm)].map(([, part, name, which]) => [part, { file: files.get(name) ?? '', which }]));
  const texts = new Map();
  const take = (/** @type {string} */ part) => {
    if (texts.has(part)) return;
    const { file, which } = parts.get(part) ?? {};
    if (!file) throw new Error(`There is no part of a shader that is called ${part}.`);
    const all = [...readFileSync(file, 'utf8').matchAll(/export (?:const (\w+)|default)\s*=?\s*\/\* glsl \*\/\s*`([^`]*)`/g)];
    const text = squeezed(all.find(([, name]) => name === which)?.[2] ?? '');
    texts.set(part, text);
    for (const [, other] of text.matchAll(/#include <(\w+)>/g)) take(other);
  };
  for (const [, part] of ofMaterials.matchAll(/: ShaderChunk\.(\w+)/g)) take(part);
  for (const [, part] of others.matchAll(/#include <(\w+)>/g)) take(part);
  take('colorspace_pars_fragment');
  onlyCalled(texts, others);
  return {
    /** ShaderChunk.js itself, of which the texts are part. */
    list: `export const ShaderChunk = {\n${[...texts].filter(([, text]) => text).map(([part, text]) => `\t${part}: ${JSON.stringify(text)},\n`).join('')}};\n`,
    ofMaterials,
  };
}

/** @param {string} file @param {ReturnType<typeof shaders>} made @returns {string} a module of the library before it is known what is reached */
function textOf(file, made) {
  const code = readFileSync(file, 'utf8');
  if (file === join(SHADERS, 'ShaderChunk.js')) return made.list;
  if (file === join(SHADERS, 'ShaderLib.js')) return made.ofMaterials;
  if (file === join(SHADERS, 'UniformsLib.js')) return fewerUniforms(code);
  let less = code;
  for (const [name, from, to] of LEFT_OUT) {
    if (!file.endsWith(name)) continue;
    const [start, end] = [less.indexOf(from), less.indexOf(to)];
    if (start < 0 || end < start) throw new Error(`${name} has no “${from}” before “${to}”: see LEFT_OUT in tools/lean/never.js`);
    less = less.slice(0, start) + less.slice(end);
  }
  return less.replace(/(const _colorKeywords = \{)[^}]*\}/, '$1}');
}

/** @type {ReturnType<typeof reached> | undefined} */
let made;

/** What is reached from this project's page, found once a build. */
export function lean() {
  if (made) return made;
  const start = startOf(fileURLToPath(new URL('../../www', import.meta.url)));
  const renderer = ['WebGLProgram', 'WebGLPrograms'].map((name) => readFileSync(join(THREE, 'renderers/webgl', `${name}.js`), 'utf8').replace(/#include/g, ''));
  const parts = shaders([...renderer, ...start.shaders].join('\n'));
  return (made = reached(start, (file) => textOf(file, parts)));
}
