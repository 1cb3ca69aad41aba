// Findings in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { degrees, length, scientific, short } from '../../www/core/format.js';
import { faultParts, faultText } from '../../www/core/fault-text.js';
import { describeScene, endWords, mobilitySentence, partSentence, singularSentence, worstFrame } from '../../www/core/status-words.js';

test('numbers are short, with a true minus, and never say −0', () => {
  assert.deepEqual([short(1.5), short(-2), short(-0.00001), short(1 / 3), short(NaN)], ['1.5', '−2', '0', '0.3333', '–']);
  assert.deepEqual([scientific(0), scientific(2.345e-16), scientific(0.5)], ['0', '2.3e−16', '0.5']);
  assert.deepEqual([length(0.25, 'm'), length(0.25, '')], ['0.25 m', '0.25']);
  assert.equal(degrees(Math.PI), 180);
});

test('a motion that was stopped says how far it goes', () => {
  assert.equal(partSentence({ partial: true, frames: 12, goal_frames: 129 }), 'Planned to frame 12 of 129: the rest is not planned.');
  assert.equal(partSentence({ partial: false, frames: 129, goal_frames: 129 }), '');
  assert.equal(partSentence(null), '');
});

test('a singular position is told where the rank differs from that at the start', () => {
  assert.equal(singularSentence(3, 3), '');
  assert.match(singularSentence(4, 3), /gives 4, not 3: at a singular position the linkage gains/);
});

test('mobility is told plainly where count and rank differ', () => {
  assert.match(mobilitySentence(3, 3), /3 freedoms, as the count says/);
  assert.match(mobilitySentence(1, 1), /1 freedom,/);
  assert.match(mobilitySentence(-2, 1), /1 freedom, though counting gives −2: .*repeat/);
  assert.match(mobilitySentence(-2, 0), /cannot move: counting gives −2/);
  assert.match(mobilitySentence(2, 1), /do not move it/);
});

test('a fault says what is wrong and what would be accepted, from its own parts and with the word that the page has for null', () => {
  // A sentence that is worded otherwise changes nothing: no part is cut out of it.
  const fault = { code: 'wrong-type', what: 'Chain 1: this is the text "abc"', accepted: 'a number', where: 'chains[0]', message: 'Something else', line: 1, column: 9 };
  assert.deepEqual(faultParts(fault), { what: 'Chain 1: this is the text "abc".', remedy: 'Accepted: a number.' });
  assert.equal(faultParts({ ...fault, optional: true }).remedy, 'Accepted: a number, or an empty cell.');
  assert.equal(faultText({ ...fault, where: '' }), 'Line 1, column 9. Chain 1: this is the text "abc". Accepted: a number.');
});

test('the worst frame is the one with the largest value', () => {
  assert.equal(worstFrame([0, 3, 1, 3]), 1);
});

/** A store that shows one frame of a motion, or a posture. */
function storeOf(status, posture = null) {
  const pose = Float64Array.of(1, 2, 3, 0, 0, 0, 1);
  const goal = Float64Array.of(4, 5, 6, 0, 0, 0, 1);
  const report = { statuses: ['reached', 'closest', 'closure_lost'], chains: [{ type: 'RPS' }] };
  const column = Float64Array.of(0);
  const motion = { frames: 1, report, status: Uint8Array.of(report.statuses.indexOf(status)), pose, goal, rows: pose, joints: column, translation_gap: column, rotation_gap: column };
  return { result: { motion, doc: { name: 'Leg', length_unit: 'mm' } }, view: { frame: 0, posture: posture && { pose, goal, rows: pose, joints: column, translation_gap: 0, rotation_gap: 0, ...posture } } };
}

test('the view is described with units; a joint that is driven has no goal', () => {
  assert.match(describeScene(storeOf('closest')), /Workpiece at \(1, 2, 3\) mm; goal at \(4, 5, 6\) mm\./);
  const driven = describeScene(storeOf('closest', { status: 'closest', value: 0.5 }));
  assert.match(driven, /Workpiece at \(1, 2, 3\) mm\./);
  assert.doesNotMatch(driven, /goal/i);
});

test('where the loops are open, no distance makes it a success', () => {
  assert.equal(endWords('closest', 0.25, 0, 'the hand', 'm'), 'closest, 0.25 m and 0° from the hand');
  for (const text of [describeScene(storeOf('closure_lost')), describeScene(storeOf('reached', { status: 'closure_lost' }))]) {
    assert.match(text, /closure lost: the loops could not be closed here/);
    assert.doesNotMatch(text, /0 mm and 0°/);
  }
});
