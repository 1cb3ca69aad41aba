// Findings in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { degrees, length, scientific, sentence, short } from '../../www/core/format.js';
import { faultParts, faultText } from '../../www/core/fault-text.js';
import {
  describeScene, endWords, frameSentence, largestGaps, mobilitySentence, partSentence, singularSentence, statusWords, worstFrame,
} from '../../www/core/status-words.js';

test('numbers are short, with a true minus, and never say −0', () => {
  assert.deepEqual([short(1.5), short(-2), short(-0.00001), short(1 / 3), short(NaN)], ['1.5', '−2', '0', '0.3333', '–']);
  assert.deepEqual([scientific(0), scientific(2.345e-16), scientific(0.5)], ['0', '2.3e−16', '0.5']);
  assert.deepEqual([length(0.25, 'm'), length(0.25, '')], ['0.25 m', '0.25']);
  assert.equal(degrees(Math.PI), 180);
});

test('a sentence begins with a capital, a symbol stays as it is', () => {
  assert.deepEqual([sentence('the crank turns'), sentence('θ₂ of crank is not driven.')], ['The crank turns.', 'θ₂ of crank is not driven.']);
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

test('the largest gaps are the true ones, each with its own frame', () => {
  const motion = { metric: [0, 3, 1], translation_gap: [0, 0.1, 0.2], rotation_gap: [0.3, 2, 1] };
  assert.deepEqual(largestGaps(motion), { shift: { frame: 2, value: 0.2 }, turn: { frame: 1, value: 2 } });
});

/** A store with one frame, or a posture in its place. */
function storeOf(status, posture = null) {
  const column = Float64Array.of(0);
  const pose = Float64Array.of(1, 2, 3, 0, 0, 0, 1);
  const report = { statuses: ['reached', 'closest', 'at_limit', 'stalled', 'closure_lost'], chains: [{ type: 'RPS' }] };
  const motion = {
    frames: 1, goal_frames: 10000, report, status: [report.statuses.indexOf(status)], translation_gap: column, rotation_gap: column, pose, goal: pose,
    joints: column, rows: pose,
  };
  return { result: { motion, doc: { length_unit: 'm' } }, view: { frame: 0, posture: posture && { pose, goal: pose, joints: column, rows: pose, translation_gap: 0, rotation_gap: 0, ...posture } } };
}

test('closure lost is not told as a success, and out of reach is not said of what was only not found', () => {
  for (const sentence of [frameSentence(storeOf('closure_lost')), frameSentence(storeOf('closest', { status: 'closure_lost' }))]) {
    assert.match(sentence, /closure lost: .*last closed position/);
    assert.doesNotMatch(sentence, /0 m|0°/);
  }
  assert.match(statusWords('closest').meaning, /closest pose found on this branch/);
  assert.doesNotMatch(statusWords('closest').meaning, /out of reach/);
});

test('a frame counts among all frames of the goal motion, also where only a part is planned', () => {
  assert.equal(frameSentence(storeOf('reached')), 'Frame 1 of 10000: reached, 0 m and 0° from the goal.');
});

test('where a joint is driven nothing is said of a goal', () => {
  const driven = storeOf('reached', { status: 'reached', value: 1 });
  assert.doesNotMatch(`${frameSentence(driven)} ${describeScene(driven)} ${statusWords('driven').meaning}`, /goal/i);
  assert.match(describeScene(storeOf('reached')), /Workpiece at \(1, 2, 3\) m; goal at \(1, 2, 3\) m\./);
});

test('how a pose ended, and how far it is from what was asked for', () => {
  assert.equal(endWords('closest', 0.25, 0, 'the hand', 'm'), 'closest, 0.25 m and 0° from the hand');
});
