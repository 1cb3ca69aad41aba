// The build leaves out of the 3D library what the page never uses, and nothing else: parts of shaders whose conditions never
// hold, what writes and reads JSON, names of colours.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { withoutUnused, withoutWriting } from '../../tools/tight.js';

/** @param {string} text @param {string} expected */
const becomes = (text, expected) => assert.equal(withoutUnused(text), expected);

test('what is never defined goes, its other branch stays', () => {
  becomes('a\n#ifdef USE_FOG\nb\n#endif\nc', 'a\nc');
  becomes('#ifdef USE_FOG\nb\n#else\nc\n#endif', 'c');
  becomes('#if defined( USE_MAP ) || defined( USE_ALPHAMAP )\nb\n#endif\nc', 'c');
  becomes('#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )\nb\n#endif\nc', 'c');
  becomes('\t#ifdef USE_MAP // remark\n#ifdef X\nb\n#else\nc\n#endif\n#endif\nd', 'd');
});

test('all else stays as it is', () => {
  for (const text of [
    '#ifdef USE_COLOR\nb\n#endif',
    '#ifndef USE_FOG\nb\n#endif',
    '#if defined( USE_MAP ) || defined( USE_COLOR )\nb\n#endif',
    '#if ! defined( USE_FOG )\nb\n#endif',
    '#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( X ) )\nb\n#endif',
    '#if NUM_POINT_LIGHTS > 0\na\n#elif defined( X )\nb\n#else\nc\n#endif',
    '#if NUM_DIR_LIGHTS > 0\na\n#endif',
  ]) becomes(text, text);
});

test('of conditions within others only those that never hold go', () => {
  becomes('#ifdef USE_COLOR\n#ifdef USE_FOG\na\n#endif\nb\n#else\nc\n#endif', '#ifdef USE_COLOR\nb\n#else\nc\n#endif');
});

test('the page has none of the lights, textures, effects and cameras whose code and shaders are left out', () => {
  const www = new URL('../../www', import.meta.url).pathname;
  const files = readdirSync(www, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.js') && !/^(pkg|pkg-first|dist)\b/.test(name));
  assert.ok(files.length > 100, `${files.length} files`);
  const used = /\b(PointLight|SpotLight|RectAreaLight|LightProbe|Fog|FogExp2|\w*Texture|Sprite|Points|SkinnedMesh|BatchedMesh|clippingPlanes|morphTargets|logarithmicDepthBuffer|ArrayCamera|CubeCamera|morphAttributes|UniformsGroup|outputBufferType|environment:|\.environment\b|\.xr\b|\w*Map:)\b/;
  for (const name of files) {
    const imported = readFileSync(join(www, name), 'utf8').replace(/^ *(\/\/|\*|\/\*\*).*$/gm, '');
    assert.doesNotMatch(imported, used, name);
  }
});

test('what writes the 3D library’s things as JSON goes, and each of its modules is still one that can be loaded', async () => {
  const three = (path) => readFileSync(new URL(`../../tools/node_modules/three/src/${path}.js`, import.meta.url), 'utf8');
  for (const path of ['materials/Material', 'core/Object3D', 'core/BufferGeometry', 'core/BufferAttribute', 'textures/Texture', 'math/Sphere', 'materials/ShaderMaterial']) {
    const [before, after] = [three(path), withoutWriting(three(path))];
    assert.match(before, /^\t(toJSON|fromJSON)\(/m, path);
    assert.doesNotMatch(after, /^\t(static )?(toJSON|fromJSON)\(/m, path);
    // Only these methods went: all others are there, in their order.
    const methods = (code) => [...code.matchAll(/^\t(?:static |get |set )?(\w+)\(.*\) \{$/gm)].map(([, name]) => name).filter((name) => !/^(to|from)JSON$/.test(name));
    assert.deepEqual(methods(after), methods(before), path);
    assert.ok(methods(after).length > 1, path);
    // As a module it would load its neighbours; as a function's body its braces are held against each other.
    assert.doesNotThrow(() => new Function(after.replace(/^import [^;]*;/gm, '').replace(/^export [^;{]*(\{[^}]*\})?;/gm, '').replace(/^export /gm, '')), path);
  }
  assert.match(withoutWriting(three('math/Color')), /const _colorKeywords = \{\};/);
});
