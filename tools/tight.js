// What every build of www/ has in common: its target browsers, and markup and shaders without the parts that a page never uses.
import { readFileSync, readdirSync, realpathSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

const THREE = realpathSync(at('node_modules/three/src'));
/** By its own path, also where node_modules is a link: it would be in the page twice, here and where its parts import it. */
const RENDERER = realpathSync(at('node_modules/lit-html/node'));

/** The modules that stand in for the 3D library's own of the same name. */
const STAND_INS = readdirSync(at('three')).map((file) => basename(file, '.js'));

/** The first with light-dark(), which otherwise is replaced by something that knows of no scheme but its own sheet's. */
const CSS_TARGET = ['chrome123', 'firefox120', 'safari17.5'];

/** Vite's options. */
export const TARGETS = { target: 'es2022', cssTarget: CSS_TARGET };

/** `file.html?raw`: the blanks between its lines are for its writer. */
const tightMarkup = () => ({
  name: 'tight-markup',
  enforce: 'pre',
  load(id) {
    const [file, query] = id.split('?');
    if (query !== 'raw' || !file.endsWith('.html')) return null;
    this.addWatchFile(file);
    return `export default ${JSON.stringify(readFileSync(file, 'utf8').replace(/\s*\n\s*/g, ' '))};`;
  },
});

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
  'USE_TANGENT USE_THICKNESSMAP USE_TRANSMISSION USE_TRANSMISSIONMAP DITHERING',
].join(' ').split(' ');

/** Counts that are always 0, in the same sense: tests/page/shaders.test.mjs sees that the page names no such light. */
const ALWAYS_ZERO = 'NUM_CLIPPING_PLANES NUM_LIGHT_PROBE_GRIDS NUM_POINT_LIGHTS NUM_RECT_AREA_LIGHTS NUM_SPOT_LIGHTS NUM_SPOT_LIGHT_COORDS NUM_SPOT_LIGHT_MAPS NUM_SUN_LIGHTS'.split(' ');

/** Whether a condition of a shader never holds: one that is known never to, all of several, or one of those that must. */
function neverHolds(condition) {
  const plain = condition.replace(/defined\s*\(\s*(\w+)\s*\)/g, '$1').replace(/\(\s*(\w+ > 0)\s*\)/g, '$1').replaceAll(' > 0', '');
  // Anything deeper is left to the shader's compiler.
  if (/[!()=<>]/.test(plain)) return false;
  const never = (name) => NEVER_DEFINED.includes(name) || ALWAYS_ZERO.includes(name);
  return plain.split('||').every((all) => all.split('&&').some((name) => never(name.trim())));
}

/** A shader without the parts that are compiled under conditions that never hold. @param {string} text */
export function withoutUnused(text) {
  const kept = [];
  /** Open conditions: `never` drops the first branch and all directives; with an #elif the directives must stay. */
  const open = [];
  const lines = text.split('\n');
  lines.forEach((line, at) => {
    const [, word, condition = ''] = line.match(/^\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b\s*(.*?)\s*(?:\/\/.*)?$/) ?? [];
    const top = open.at(-1);
    const dropped = open.some((block) => block.dropping);
    if (word === 'ifdef' || word === 'ifndef' || word === 'if') {
      const never = word !== 'ifndef' && neverHolds(condition) && !branches(lines, at);
      open.push({ never, dropping: never });
      if (!never && !dropped) kept.push(line);
    } else if (word === 'endif') {
      open.pop();
      if (!top.never && !dropped) kept.push(line);
    } else if (word === 'else' && top.never) top.dropping = false;
    else if (!dropped) kept.push(line);
  });
  return kept.join('\n');
}

/** Whether the condition that opens at this line has an #elif of its own. @param {string[]} lines @param {number} at */
function branches(lines, at) {
  let depth = 0;
  for (const line of lines.slice(at)) {
    const [, word] = line.match(/^\s*#\s*(if|elif|endif)/) ?? [];
    if (word === 'if') depth += 1;
    else if (word === 'endif') depth -= 1;
    else if (word === 'elif' && depth === 1) return true;
    if (depth === 0) return false;
  }
  return false;
}

/**
 * A module of the 3D library without what writes its things as JSON and reads them, and without the names of colours: the page
 * does neither, and gives its colours by numbers. No bundler leaves out methods.
 * @param {string} code
 */
export const withoutWriting = (code) =>
  code.replace(/\n\t(?:static )?(?:toJSON|fromJSON)\([^)]*\) \{\n(?:(?!\n\t\}\n)[^])*\n\t\}\n/g, '\n').replace(/(const _colorKeywords = \{)[^}]*\}/, '$1}');

/**
 * The 3D library from its single modules, of which a bundler leaves out what nobody imports (of its one big file it keeps
 * much), with the modules of tools/three in place of what the page never uses.
 */
const leanThree = () => ({
  name: 'lean-three',
  apply: 'build',
  enforce: 'pre',
  resolveId(id, importer) {
    if (id === 'three') return join(THREE, 'Three.js');
    const name = /^\.{1,2}\/(?:\w+\/)*(\w+)\.js$/.exec(id)?.[1] ?? '';
    return importer?.startsWith(THREE) && STAND_INS.includes(name) ? at(`three/${name}.js`) : null;
  },
  transform(code, id) {
    if (!id.startsWith(THREE)) return null;
    if (!id.startsWith(join(THREE, 'renderers/shaders/Shader'))) return withoutWriting(code);
    // A shader is a text, which no minifier shortens.
    return code.replace(/(\/\* glsl \*\/\s*`)([^`]*)`/g, (_, start, text) => `${start}${withoutUnused(text.replace(/^[ \t]+/gm, '').replace(/^\/\/.*$/gm, '')).replace(/\n{2,}/g, '\n')}\``);
  },
});

/** The renderer as servers load it, which is as long: a page that is rendered there may name the element, and there is no document. */
const rendererForServers = () => ({
  name: 'renderer-for-servers',
  apply: 'build',
  enforce: 'pre',
  resolveId(id) {
    const [, part = 'lit-html.js'] = /^lit-html(?:\/(.+))?$/.exec(id) ?? [, null];
    return part && join(RENDERER, part);
  },
});

/**
 * The plots without their own writer of numbers, which every chart here replaces: it is made as the file is loaded, and
 * fails where the browser's language is no language tag, as "C" in WebKit on Linux.
 */
const plotsWithoutLanguage = () => ({
  name: 'plots-without-language',
  enforce: 'pre',
  transform(code, id) {
    if (!/\/uplot\/dist\/uPlot\.esm\.js$/.test(id.split('?')[0])) return null;
    const [before, after, ...more] = code.split("new Intl.NumberFormat(domEnv ? nav.language : 'en-US')");
    if (after === undefined || more.length > 0) throw new Error('uPlot makes its writer of numbers in another way: see plotsWithoutLanguage in tools/tight.js');
    return `${before}{ format: String }${after}`;
  },
});

/** Vite's plugins. */
export const tight = () => [tightMarkup(), leanThree(), rendererForServers(), plotsWithoutLanguage()];
