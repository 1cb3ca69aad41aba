// The build leaves out of the 3D library what the page never uses, and nothing else: parts of shaders whose conditions never
// hold, methods that nothing names, code for things that there are none of.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { parseAst } from 'rolldown/parseAst';
import { THREE } from '../../tools/lean/modules.js';
import { holds, onlyCalled, squeezed, withoutUnused } from '../../tools/lean/shaders.js';
import { NEVER_SET } from '../../tools/lean/never.js';
import { lean } from '../../tools/lean/three.js';

const www = new URL('../../www', import.meta.url).pathname;

/** @param {string} text @param {string} expected */
const becomes = (text, expected) => assert.equal(withoutUnused(text), expected);

test('what is never defined goes, its other branch stays', () => {
  becomes('a\n#ifdef USE_FOG\nb\n#endif\nc', 'a\nc');
  becomes('#ifdef USE_FOG\nb\n#else\nc\n#endif', 'c');
  becomes('#if defined( USE_MAP ) || defined( USE_ALPHAMAP )\nb\n#endif\nc', 'c');
  becomes('#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )\nb\n#endif\nc', 'c');
  becomes('\t#ifdef USE_MAP // remark\n#ifdef X\nb\n#else\nc\n#endif\n#endif\nd', 'd');
});

test('what always holds stays without its condition', () => {
  becomes('#ifndef USE_FOG\nb\n#endif', 'b');
  becomes('#if ! defined( USE_FOG )\nb\n#else\nc\n#endif', 'b');
  becomes('#if NUM_POINT_LIGHTS > 0\na\n#elif defined( X )\nb\n#else\nc\n#endif', '#if defined( X )\nb\n#else\nc\n#endif');
  becomes('#ifdef X\na\n#elif defined( USE_FOG )\nb\n#else\nc\n#endif', '#ifdef X\na\n#else\nc\n#endif');
  becomes('#ifdef X\na\n#elif ! defined( USE_FOG )\nb\n#else\nc\n#endif', '#ifdef X\na\n#else\nb\n#endif');
});

test('all else stays as it is', () => {
  for (const text of [
    '#ifdef USE_COLOR\nb\n#endif',
    '#if defined( USE_MAP ) || defined( USE_COLOR )\nb\n#endif',
    '#if ! defined ( X ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( Y ) )\nb\n#endif',
    '#if NUM_DIR_LIGHTS > 0\na\n#elif defined( X )\nb\n#endif',
    '#if UNROLLED_LOOP_INDEX + 1 < NUM_DIR_LIGHTS\na\n#endif',
  ]) becomes(text, text);
});

test('a condition holds, does not, or is known only when it is compiled', () => {
  for (const [condition, is] of Object.entries({ 'defined( USE_FOG )': false, '! defined USE_FOG': true, 'X && defined( USE_FOG )': false, 'X || ! defined( USE_FOG )': true, X: null, 'NUM_SUN_LIGHTS > 0': false, 'DEPTH_PACKING == 3200': true, 'DEPTH_PACKING == 3201': false, '( X ) > 3': null })) {
    assert.equal(holds(condition), is, condition);
  }
});

test('a shader is written without remarks and blanks, and says the same', () => {
  assert.equal(squeezed('\t// remark\n\tfloat a = - - b; /* more */\n\t#define X( a ) ( a )\n\tif ( a > - 1.0 ) {\n\t\ti ++;\n\t}\n'), 'float a=- - b;\n#define X( a ) ( a )\nif(a>-1.0){i ++;}');
});

test('functions that nobody calls go, with those that only they call', () => {
  const texts = new Map([
    ['parts', 'float one(float x){return x;}vec3 two(vec3 x){return x*one(x.x);}float kept(float x){return x;}'],
    ['nothing', 'void three(){}'],
    ['main', '#include <parts>\n#include <nothing>\nvoid main(){kept(named());}'],
  ]);
  assert.deepEqual([...onlyCalled(texts, 'one of ours').values()], ['float one(float x){return x;}float kept(float x){return x;}', '', '#include <parts>\nvoid main(){kept(named());}']);
});

test('of conditions within others only those that never hold go', () => {
  becomes('#ifdef USE_COLOR\n#ifdef USE_FOG\na\n#endif\nb\n#else\nc\n#endif', '#ifdef USE_COLOR\nb\n#else\nc\n#endif');
});

test('the page has none of the lights, textures, effects and cameras whose code and shaders are left out', () => {
  const files = readdirSync(www, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.js') && !/^(pkg|pkg-first|dist)\b/.test(name));
  assert.ok(files.length > 100, `${files.length} files`);
  const used = /\b(PointLight|SpotLight|RectAreaLight|LightProbe|Fog|FogExp2|(?!Data)\w*Texture|Sprite|Points|SkinnedMesh|BatchedMesh|clippingPlanes|morphTargets|logarithmicDepthBuffer|ArrayCamera|CubeCamera|morphAttributes|UniformsGroup|outputBufferType|environment:|\.environment\b|\.xr\b|\w*Map:)\b/;
  for (const name of files) {
    const imported = readFileSync(join(www, name), 'utf8').replace(/^ *(\/\/|\*|\/\*\*).*$/gm, '');
    assert.doesNotMatch(imported, used, name);
  }
});

test('no material of the page is given what the build takes for never given', () => {
  const never = Object.keys(NEVER_SET.material);
  assert.ok(never.length > 30);
  let found = 0;
  // What else is called a map or a strength of something is nothing of a material's.
  const own = never.filter((key) => !['map', 'transmission'].includes(key)).join('|');
  for (const name of readdirSync(www, { recursive: true, encoding: 'utf8' }).filter((file) => /^(view3d|export)\b.*\.js$/.test(file))) {
    const text = readFileSync(join(www, name), 'utf8').replace(/^ *(\/\/|\*|\/\*\*).*$/gm, '');
    for (const [, given] of text.matchAll(/new \w*Material\(\{([^}]*)\}/g)) {
      found += 1;
      const keys = [...given.matchAll(/(\w+)\s*(?=[:,]|$)/g)].map(([, key]) => key);
      assert.deepEqual(keys.filter((key) => never.includes(key)), [], name);
    }
    assert.doesNotMatch(text, new RegExp(`\\b(${own})(: |\\s*=[^=])|\\.map = `), name);
  }
  assert.ok(found > 10, `${found} materials`);
});

/** A module's methods, of classes and of what it makes. @param {string} code */
const methods = (code) => [...code.matchAll(/^\t(?:static )?(\w+)\(.*\) \{$|\bthis\.(\w+) = function/gm)].map(([, one, other]) => one ?? other).filter((name) => name !== 'constructor');

/** What a code may call, by name. @param {string} code */
const called = (code) =>
  code
    .replace(/\/\*[^]*?\*\/|\/\/.*/g, '')
    .replace(/\b(Math|Number|Object|Array|JSON|Date|document|window|console|performance|gl|_gl)\.\w+/g, '')
    .matchAll(/\.\s*(\w+)\s*\(/g);

test('no code that is left calls a method of the 3D library that was left out, and each module can be read', () => {
  const left = lean();
  const files = left.files.filter((file) => left.isReached(file));
  assert.ok(files.length > 80, `${files.length} modules`);
  const dropped = new Map();
  const kept = new Set();
  for (const file of files) {
    const [before, after] = [readFileSync(file, 'utf8'), left.kept(file)];
    assert.doesNotThrow(() => parseAst(after), file);
    const there = methods(after);
    for (const name of there) kept.add(name);
    for (const name of methods(before)) if (!there.includes(name)) dropped.set(name, file);
  }
  // Of the same name there may be another that is called.
  for (const name of kept) dropped.delete(name);
  assert.ok(dropped.size > 150, `${dropped.size} methods`);
  for (const file of files) for (const [, name] of called(left.kept(file))) assert.ok(!dropped.has(name), `${file} calls ${name} of ${dropped.get(name)}`);
  for (const name of readdirSync(www, { recursive: true, encoding: 'utf8' }).filter((file) => /^(view3d|export|core)\b.*\.js$/.test(file))) {
    for (const [, method] of called(readFileSync(join(www, name), 'utf8'))) assert.ok(!dropped.has(method) || dropped.get(method).includes('/renderers/'), `${name} calls ${method} of ${dropped.get(method)}`);
  }
});

test('what is asked for with a flag that nothing has is left out, and all that the page imports is there', () => {
  const left = lean();
  for (const name of ['MeshStandardMaterial', 'InstancedMesh', 'WebGLRenderer', 'ShadowMaterial']) assert.ok(left.files.some((file) => file.startsWith(THREE) && file.endsWith(`/${name}.js`) && left.isReached(file)), name);
  for (const flag of ['isPointLight', 'isSkinnedMesh', 'isVideoTexture', 'isMeshPhongMaterial']) {
    assert.ok(!left.flags.has(flag), flag);
    for (const file of left.files) if (left.isReached(file)) assert.ok(!left.kept(file).includes(`.${flag} `), `${file}: ${flag}`);
  }
  assert.ok(left.flags.has('isInstancedMesh'));
});
