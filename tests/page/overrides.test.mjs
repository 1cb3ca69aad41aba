// Readable changes of a document in an address.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyOverrides, BadOverride, parseOverrides, withOverrides } from '../../www/core/overrides.js';

const doc = { name: 'x', chains: [{ joints: [{ type: 'R', rows: [{ a: 0 }, { a: 1 }] }] }], motion: { frames: 5 } };

test('places with dots and with brackets, values with their types', () => {
  assert.deepEqual(parseOverrides([' chains.0.joints[0].rows.1.a:1.2']), [{ path: 'chains[0].joints[0].rows[1].a', value: 1.2, text: 'chains.0.joints[0].rows.1.a:1.2' }]);
  assert.deepEqual(
    parseOverrides(['motion.frames:9,name:a, b: c;about:true', 'chains[0].start:[1,2]', 'x1:−3']).map(({ path, value }) => [path, value]),
    [['motion.frames', 9], ['name', 'a'], ['b', 'c'], ['about', true], ['chains[0].start', [1, 2]], ['x1', -3]],
  );
  assert.deepEqual(parseOverrides(['name:one, two']).map(({ value }) => value), ['one, two']);
  assert.deepEqual(parseOverrides(['', ' ', 'motion.frames:9;']).map(({ text }) => text), ['motion.frames:9']);
});

test('= stands for the colon', () => {
  const changed = applyOverrides(doc, parseOverrides(['name=y,motion.frames=9', 'chains.0.joints[0].type=a:b']));
  assert.deepEqual([changed.name, changed.motion.frames, changed.chains[0].joints[0].type], ['y', 9, 'a:b']);
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

/** What Rust's reader does, for two rules: frames are a number; the key frames have times all or none. */
async function whole(text) {
  const read = JSON.parse(text);
  const fault = (where, message) => ({ is: 'fault', message, fault: { code: 'x', message, where, what: '', accepted: '', optional: false } });
  if (typeof read.motion.frames !== 'number') return fault('motion.frames', 'motion.frames: no number. Accepted: a number.');
  if (new Set(read.motion.key_frames.map(({ time }) => time === null)).size > 1) return fault('motion.key_frames[2]', 'Times of all key frames or of none.');
  return { is: 'answer', value: read };
}
const changed = async (sets) => (await withOverrides(timed, sets, whole)).value;
const timed = { ...doc, motion: { frames: 5, key_frames: [{ time: null }, { time: null }] } };

test('the good changes hold, and each bad one is told by itself', async () => {
  const { doc: made, problems } = await changed(['nonsense;name:y;motion.frames:many', 'chains.7.name:x, motion.key_frames[0].time:0, motion.key_frames[1].time:1']);
  assert.equal(made.name, 'y');
  assert.deepEqual(made.motion, { frames: 5, key_frames: [{ time: 0 }, { time: 1 }] });
  assert.equal(problems.length, 3);
  for (const [text, told] of [['nonsense', /Accepted: a place/], ['motion.frames:many', /Accepted: a number/], ['chains.7.name:x', /There is no chains\[7\]\.name.*Accepted/]]) {
    assert.match(problems.find((problem) => problem.includes(`“${text}”`)) ?? '', told);
  }
});

test('a change that is bad where it does not stand is found', async () => {
  const { doc: made, problems } = await changed(['name:y;motion.key_frames[0].time:0;motion.frames:9']);
  assert.deepEqual([made.name, made.motion.frames, made.motion.key_frames[0].time], ['y', 9, null]);
  assert.equal(problems.length, 1);
  assert.match(problems[0], /“motion\.key_frames\[0\]\.time:0”.*Times of all/);
});

test('of two for the same place the last one counts, if it is accepted', async () => {
  assert.equal((await changed(['motion.frames:7;motion.frames:9'])).doc.motion.frames, 9);
  const { doc: made, problems } = await changed(['motion.frames:7;motion.frames:many']);
  assert.equal(made.motion.frames, 7);
  assert.equal(problems.length, 1);
});

test('that the planner failed is no fault of the changes', async () => {
  const trouble = { is: 'trouble', notLoaded: false, message: 'no memory' };
  assert.equal(await withOverrides(timed, ['name:y'], async () => trouble), trouble);
  assert.equal(await withOverrides(timed, ['name:y;motion.frames:many'], async (text) => (text.includes('many') ? whole(text) : trouble)), trouble);
});
