// Things of the scene: what they are called and which belong together.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { belongs, nameOf, thingsOf } from '../../www/core/things.js';

const doc = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));
const motion = { frames: 2, translation_gap: [0, 0.12], rotation_gap: [0, Math.PI / 4] };
const shown = { result: { doc, motion }, view: { frame: 0, posture: null } };

test('every thing has a name, and no two the same', () => {
  const names = thingsOf(doc).map((place) => nameOf(place, shown));
  assert.ok(names.every(Boolean), names.join());
  assert.equal(new Set(names).size, names.length);
});

test('names say what and where', () => {
  const expected = {
    'chains[1]': 'chain 2: RPS',
    'chains[1].joints[2]': 'chain 2, joint 3: S, spherical',
    'chains[1].joints[1].rows[0]': 'link 1 of chain 2',
    'chains[0].base': 'base of chain 1',
    'chains[2].gripper': 'gripper of chain 3',
    'motion.key_frames[1]': 'key frame “between”',
    'gap[1]': 'gap at frame 2: 0.12 m, 45°',
  };
  for (const [place, name] of Object.entries(expected)) assert.equal(nameOf(place, shown), name);
  const named = { ...shown, result: { motion, doc: { ...doc, chains: [{ ...doc.chains[0], name: 'crank' }, { ...doc.chains[1], name: '' }] } } };
  assert.deepEqual(['chains[0]', 'chains[0].base', 'chains[1]'].map((place) => nameOf(place, named)), ['crank: RPS', 'base of crank', 'chain 2: RPS'], 'a chain by its own name, where it has one');
  for (const gone of ['', 'chains[7]', 'chains[0].joints[9]', 'motion.key_frames[5]']) assert.equal(nameOf(gone, shown), '');
});

test('a chain has its parts; a joint has its limits and later rows, but not the link before it', () => {
  const yes = [
    ['chains[1].joints[0]', 'chains[1]'],
    ['chains[1].joints[0].rows[0]', 'chains[1]'],
    ['chains[1].gripper', 'chains[1].gripper.x'],
    ['chains[1].joints[0]', 'chains[1].joints[0].limits[0].max'],
    ['chains[1].joints[0].rows[0]', 'chains[1].joints[0].rows[0].a'],
    ['motion.key_frames[2]', 'motion.key_frames[2].x'],
  ];
  const no = [
    ['workpiece', ''],
    ['chains[1].joints[0].rows[0]', 'chains[1].joints[0]'],
    ['chains[1].joints[0]', 'chains[1].joints[0].rows[0].a'],
    ['chains[11]', 'chains[1]'],
    ['goal', 'workpiece'],
  ];
  for (const [thing, chosen] of yes) assert.ok(belongs(thing, chosen), `${thing} with ${chosen}`);
  for (const [thing, chosen] of no) assert.ok(!belongs(thing, chosen), `${thing} not with ${chosen}`);
});
