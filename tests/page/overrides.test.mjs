// Readable changes of a document in an address.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyOverrides, BadOverride, parseOverrides } from '../../www/core/overrides.js';

const doc = { name: 'x', chains: [{ joints: [{ type: 'R', rows: [{ a: 0 }, { a: 1 }] }] }], motion: { frames: 5 } };

test('places with dots and with brackets, values with their types', () => {
  assert.deepEqual(parseOverrides(['chains.0.joints[0].rows.1.a:1.2']), [{ path: 'chains[0].joints[0].rows[1].a', value: 1.2 }]);
  assert.deepEqual(
    parseOverrides(['motion.frames:9,name:a, b: c;about:true', 'chains[0].start:[1,2]', 'x1:−3']).map(({ path, value }) => [path, value]),
    [['motion.frames', 9], ['name', 'a'], ['b', 'c'], ['about', true], ['chains[0].start', [1, 2]], ['x1', -3]],
  );
  assert.deepEqual(parseOverrides(['name:one, two']), [{ path: 'name', value: 'one, two' }]);
  assert.deepEqual(parseOverrides(['', ' ', 'motion.frames:9;']), [{ path: 'motion.frames', value: 9 }]);
});

test('are applied in order, on a copy', () => {
  const changed = applyOverrides(doc, parseOverrides(['chains.0.joints.0.rows.1.a:1.2;motion.frames:7', 'motion.frames:9']));
  assert.equal(changed.chains[0].joints[0].rows[1].a, 1.2);
  assert.equal(changed.motion.frames, 9);
  assert.equal(doc.motion.frames, 5);
});

for (const bad of ['motion.frames', ':3', 'chains..a:1', 'chains[a]:1', 'a b:1']) {
  test(`“${bad}” is no override`, () => assert.throws(() => parseOverrides([bad]), BadOverride));
}

for (const [bad, told] of [
  ['chains.1.joints.0.type:P', /chains\[1\]\.joints\[0\]\.type/],
  ['chains.0.joints.4:1', /chains\[0\]\.joints\[0\] to chains\[0\]\.joints\[0\]/],
  ['chains.name:1', /chains\.name/],
  ['name.first:1', /name\.first/],
  ['motion.spline.degree:3', /motion\.spline\.degree/],
  ['__proto__.a:1', /__proto__/],
  ['motion.__proto__:1', /__proto__/],
]) {
  test(`${bad}: there is no such place`, () => assert.throws(() => applyOverrides(doc, parseOverrides([bad])), { message: told }));
}
