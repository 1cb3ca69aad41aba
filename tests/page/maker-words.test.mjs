// The makers as the page lists and asks them.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { inGroups } from '../../www/core/mechanism-groups.js';
import { defaultTexts, found, givenInputs, labelsOf, meaningOf } from '../../www/panels/types/maker-words.js';

const folder = new URL('../../src/makers/', import.meta.url);
/** As Rust lists them: an input without parts has none, its value is a list. */
const makers = readdirSync(folder)
  .filter((file) => file.endsWith('.json'))
  .map((file) => {
    const { document: _, also = [], inputs, ...rest } = JSON.parse(readFileSync(new URL(file, folder), 'utf8'));
    return { ...rest, also, inputs: inputs.map((input) => ({ parts: [], signed: false, range: null, ...input, value: [input.value].flat() })) };
  });
const maker = (wanted) => makers.find(({ name }) => name === wanted);
const input = (of, wanted) => maker(of).inputs.find(({ name }) => name === wanted);
const names = (typed) => found(makers, typed).map(({ name }) => name);

test('a maker is found by name, other name or title; capitals, blanks and dashes do not matter; what begins so is first', () => {
  assert.equal(names('').length, makers.length);
  assert.deepEqual(names('Rotary  Delta'), ['delta']);
  assert.equal(names('delta')[0], 'delta');
  assert.ok(names('delta').includes('linear-delta'));
  assert.equal(names('3 RPS')[0], '3-rps');
  assert.equal(names('gough')[0], 'hexapod');
  assert.deepEqual(names('steam engine'), []);
});

test('every maker is in a group that has a heading of its own', () => {
  const groups = inGroups(makers);
  assert.equal(groups.reduce((sum, { members }) => sum + members.length, 0), makers.length);
  for (const { heading } of groups) assert.match(heading, /^[A-Z]/, `“${heading}” is in the list of groups`);
  assert.deepEqual(inGroups([{ group: 'arms' }, { group: 'new' }, { group: 'one freedom' }]).map(({ heading }) => heading), ['One freedom', 'Arms and other single chains', 'new']);
});

test('default lengths are converted, other numbers are not', () => {
  const delta = maker('delta');
  const arms = input('delta', 'arms');
  assert.deepEqual(defaultTexts(delta, arms, 'mm'), arms.value.map(String));
  assert.deepEqual(defaultTexts(delta, arms, 'm'), arms.value.map((value) => String(value / 1000)));
  const hexapod = maker('hexapod');
  for (const unit of ['mm', 'in']) {
    assert.deepEqual(defaultTexts(hexapod, input('hexapod', 'angles'), unit), ['20', '20']);
    assert.deepEqual(defaultTexts(hexapod, input('hexapod', 'locked'), unit), ['1, 2, 3, 4, 5']);
  }
});

test('a field for each part, one for a list; what it measures is said with its unit', () => {
  assert.deepEqual(labelsOf(input('delta', 'arms')), ['upper', 'lower']);
  assert.deepEqual(labelsOf(input('delta', 'base')), ['base']);
  assert.deepEqual(labelsOf(input('hexapod', 'locked')), ['locked']);
  assert.match(meaningOf(input('delta', 'base'), 'in'), /^Radius .*, in in\.$/);
  assert.match(meaningOf(input('hexapod', 'angles'), 'mm'), /, in degrees\.$/);
  assert.match(meaningOf(input('hexapod', 'locked'), 'mm'), /commas between them\.$/);
});

test('only what differs from the defaults is asked for; a comma in a number is a decimal one, in a list it parts', () => {
  const delta = maker('delta');
  const typed = (base, arms) => new Map([['base', [base]], ['platform', ['44']], ['arms', arms]]);
  assert.deepEqual(givenInputs(delta, typed('164', ['524', ' 1244 ']), 'mm'), {});
  assert.deepEqual(givenInputs(delta, typed('0,4', ['524', '600']), 'mm'), { base: '0.4', arms: '524,600' });
  assert.deepEqual(givenInputs(delta, typed('', ['wide', '600']), 'mm'), { base: '', arms: 'wide,600' });
  assert.deepEqual(givenInputs(delta, new Map([['base', ['0.164']], ['platform', ['0.044']], ['arms', ['0.524', '1.244']]]), 'm'), {});
  const hexapod = maker('hexapod');
  const all = new Map(hexapod.inputs.map((one) => [one.name, defaultTexts(hexapod, one, 'mm')]));
  assert.deepEqual(givenInputs(hexapod, new Map([...all, ['locked', ['1, 3']]]), 'mm'), { locked: '1, 3' });
});
