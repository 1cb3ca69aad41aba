// The 3D library's shaders without what the page never uses: texts, which no minifier shortens.
import { NO_UNIFORMS, SHADERS } from './never.js';

/**
 * What no material and no light of www/view3d has, as the 3D library's shaders ask for it: textures of any kind, fog, skins,
 * morphs, batches, coats and the like. tests/e2e/shaders.test.mjs sees that no shader is compiled with any of them.
 */
export const NEVER_DEFINED = [
  'USE_ALPHAHASH USE_ALPHAMAP USE_ALPHATEST USE_ANISOTROPY USE_ANISOTROPYMAP USE_AOMAP USE_BATCHING USE_BATCHING_COLOR',
  'USE_BUMPMAP USE_CLEARCOAT USE_CLEARCOATMAP USE_CLEARCOAT_NORMALMAP USE_CLEARCOAT_ROUGHNESSMAP USE_DIFFUSE_ROUGHNESS',
  'USE_DIFFUSE_ROUGHNESSMAP USE_DISPERSION USE_DISPLACEMENTMAP USE_EMISSIVEMAP USE_ENVMAP USE_FOG USE_GRADIENTMAP',
  'USE_INSTANCING_MORPH USE_IRIDESCENCE USE_IRIDESCENCEMAP USE_IRIDESCENCE_THICKNESSMAP USE_LIGHTMAP USE_LIGHT_PROBES',
  'USE_LOGARITHMIC_DEPTH_BUFFER USE_MAP USE_METALNESSMAP USE_MORPHCOLORS USE_MORPHNORMALS USE_MORPHTARGETS USE_NORMALMAP',
  'USE_NORMALMAP_OBJECTSPACE USE_NORMALMAP_TANGENTSPACE USE_POINTS_UV USE_RETROREFLECTION USE_ROUGHNESSMAP USE_SHEEN',
  'USE_SHEEN_COLORMAP USE_SHEEN_ROUGHNESSMAP USE_SKINNING USE_SPECULARMAP USE_SPECULAR_COLORMAP USE_SPECULAR_INTENSITYMAP',
  'USE_TANGENT USE_THICKNESSMAP USE_TRANSMISSION USE_TRANSMISSIONMAP DITHERING TONE_MAPPING PREMULTIPLIED_ALPHA PHYSICAL IOR USE_SPECULAR',
  'DECODE_VIDEO_TEXTURE DECODE_VIDEO_TEXTURE_EMISSIVE USE_REVERSED_DEPTH_BUFFER USE_LIGHT_PROBES_GRID USE_SIZEATTENUATION',
  'SHADOWMAP_TYPE_VSM SHADOWMAP_TYPE_BASIC ENVMAP_TYPE_CUBE_UV',
].join(' ').split(' ');

/** Counts that are always 0, in the same sense: tests/page/shaders.test.mjs sees that the page names no such light. */
const ALWAYS_ZERO = [
  'NUM_CLIPPING_PLANES NUM_LIGHT_PROBE_GRIDS NUM_POINT_LIGHTS NUM_RECT_AREA_LIGHTS NUM_SPOT_LIGHTS NUM_SPOT_LIGHT_COORDS NUM_SPOT_LIGHT_MAPS',
  'NUM_SUN_LIGHTS NUM_SUN_LIGHT_SHADOWS NUM_POINT_LIGHT_SHADOWS NUM_SPOT_LIGHT_SHADOWS NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS',
].join(' ').split(' ');

/** What is always defined where it is asked for: shadows have one kind, and one way of packing depths. */
const ALWAYS_DEFINED = ['SHADOWMAP_TYPE_PCF'];
const VALUES = { DEPTH_PACKING: 3200 };

/** Whether a condition of a shader holds; null where it is known only when it is compiled. @param {string} condition @returns {boolean | null} */
export function holds(condition) {
  const signs = condition.match(/defined|\w+|&&|\|\||[<>=!]=|[<>!()]|\S/g) ?? [];
  let at = 0;
  const number = (/** @type {string} */ word) => (ALWAYS_ZERO.includes(word) || NEVER_DEFINED.includes(word) ? 0 : (VALUES[word] ?? (/^\d+$/.test(word) ? Number(word) : null)));
  const defined = (/** @type {string} */ word) => (NEVER_DEFINED.includes(word) ? false : ALWAYS_DEFINED.includes(word) || word in VALUES ? true : null);
  function one() {
    const sign = signs[at++];
    if (sign === '!') {
      const inner = one();
      return inner === null ? null : !inner;
    }
    if (sign === '(') {
      const inner = any();
      at++;
      return inner;
    }
    if (sign === 'defined') {
      const bracket = signs[at] === '(';
      if (bracket) at++;
      const word = signs[at++];
      if (bracket) at++;
      return defined(word);
    }
    const left = number(sign);
    if (!/^[<>=!]=?$/.test(signs[at] ?? '') || signs[at] === '!') return left === null ? null : left !== 0;
    const [compare, right] = [signs[at], number(signs[at + 1])];
    at += 2;
    if (left === null || right === null) return null;
    return { '>': left > right, '<': left < right, '>=': left >= right, '<=': left <= right, '==': left === right, '!=': left !== right }[compare] ?? null;
  }
  /** Of several, where one decides. @param {string} sign @param {boolean} decides @param {() => boolean | null} part @returns {boolean | null} */
  function several(sign, decides, part) {
    let all = part();
    while (signs[at] === sign) {
      at++;
      const next = part();
      all = all === decides || next === decides ? decides : all === null || next === null ? null : !decides;
    }
    return all;
  }
  const all = () => several('&&', false, one);
  const any = () => several('||', true, all);
  const result = any();
  // What is written in a way that is not known here is left to the shader's compiler.
  return at === signs.length ? result : null;
}

/** A shader without the parts that are compiled under conditions that never hold. @param {string} text */
export function withoutUnused(text) {
  const lines = text.split('\n');
  let at = 0;
  const directive = (/** @type {string} */ line) => line.match(/^\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b\s*(.*?)\s*(?:\/\/.*)?$/);
  /** Up to the end of the block that is open. @returns {string[]} */
  function block() {
    const kept = [];
    while (at < lines.length) {
      const [, word = '', condition = ''] = directive(lines[at]) ?? [];
      if (word === 'elif' || word === 'else' || word === 'endif') return kept;
      if (word) kept.push(...choice(word, condition));
      else kept.push(lines[at++]);
    }
    return kept;
  }
  /** An #if with its other branches. @param {string} word @param {string} condition @returns {string[]} */
  function choice(word, condition) {
    const kept = [];
    /** No branch behind this one is compiled. */
    let decided = false;
    let opened = false;
    let [first, line] = [true, ''];
    do {
      line = lines[at++];
      const test = word === 'ifdef' ? `defined(${condition})` : word === 'ifndef' ? `!defined(${condition})` : condition;
      const is = word === 'else' ? true : holds(test);
      const inner = block();
      if (!decided && is !== false) {
        if (is === null) kept.push(opened && !first ? line : line.replace(/#\s*elif/, '#if'));
        else if (opened) kept.push('#else');
        kept.push(...inner);
        opened ||= is === null;
        decided = is === true;
      }
      first = false;
      [, word = '', condition = ''] = directive(lines[at]) ?? [];
    } while (word !== 'endif');
    const end = lines[at++];
    return opened ? [...kept, end] : kept;
  }
  return block().join('\n');
}

/** A shader without remarks and blanks. @param {string} text */
export const squeezed = (text) =>
  withoutUnused(text.replace(/\/\*[^]*?\*\//g, '').replace(/[ \t]*\/\/.*$/gm, ''))
    .split('\n')
    .map((line) => line.trim())
    .filter(Boolean)
    // What begins with # ends with its line; between two signs that could become one a blank stays.
    .map((line) => (line.startsWith('#') ? `\n${line}\n` : `${line} `.replace(/ *([(){}\[\],;=*/?:<>&|]) */g, '$1').replace(/ *(?<![+-] ?)([+-])(?! ?[+-]) */g, '$1')))
    .join('')
    .replace(/\n{2,}/g, '\n')
    .replace(/^\n/, '');

const FUNCTION = /(?<=^|[;}\n])(?:highp )?(?:void|bool|int|float|[iu]?vec\d|mat\d)(?:\[\d\])? (\w+)\([^){}#]*\)\{/g;

/** Functions that a squeezed text defines, each with where it begins and ends. @param {string} text */
function functionsIn(text) {
  return [...text.matchAll(FUNCTION)].map((match) => {
    let end = match.index + match[0].length;
    for (let depth = 1; depth > 0; end++) depth += text[end] === '{' ? 1 : text[end] === '}' ? -1 : 0;
    return { name: match[1], from: match.index, to: end };
  });
}

/**
 * Texts without functions that nobody calls, and without what is included and is empty.
 * @param {Map<string, string>} texts squeezed, by the names by which they are included @param {string} others what else may name a function of theirs
 * @returns {Map<string, string>}
 */
export function onlyCalled(texts, others) {
  const count = (/** @type {string} */ all) => {
    const words = new Map();
    for (const [word] of all.matchAll(/\w+/g)) words.set(word, (words.get(word) ?? 0) + 1);
    return words;
  };
  const named = count(others);
  for (let before = ''; before !== [...texts.values()].join(); ) {
    before = [...texts.values()].join();
    const words = count(before);
    const defined = new Map();
    for (const text of texts.values()) for (const { name } of functionsIn(text)) defined.set(name, (defined.get(name) ?? 0) + 1);
    const dead = (/** @type {string} */ name) => name !== 'main' && !named.has(name) && words.get(name) === defined.get(name);
    for (const [key, text] of texts) {
      let less = text;
      for (const { name, from, to } of functionsIn(text).reverse()) if (dead(name)) less = less.slice(0, from) + less.slice(to);
      less = less.replace(/^#include <(\w+)>\n?/gm, (all, part) => (texts.get(part)?.trim() === '' ? '' : all));
      texts.set(key, less);
    }
  }
  return texts;
}

/** The list of materials' shaders with those that are used, and the uniforms that those may have. @param {string} code of ShaderLib.js */
export const fewerShaders = (code) =>
  code
    .replace(/^\t(\w+): \{\n[^]*?\n\t\},?\n/gm, (all, name) => (SHADERS.includes(name) ? all : all.replace(/[^\n]/g, '')))
    .replace(/^\t+UniformsLib\.(\w+),?$/gm, (all, name) => (NO_UNIFORMS.includes(name) ? '' : all));

/** The groups of uniforms that are left in that list. @param {string} code of UniformsLib.js */
export const fewerUniforms = (code) => code.replace(/^\t(\w+): \{\n[^]*?\n\t\},?\n/gm, (all, name) => (NO_UNIFORMS.includes(name) ? all.replace(/[^\n]/g, '') : all));
