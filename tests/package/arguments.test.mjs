// What a program may pass to the package's functions: what cannot be used is named, with what is accepted, and costs no worker.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { dist } from './site.mjs';

let threads = 0;
process.on('worker', () => (threads += 1));
const api = await import(new URL('index.node.js', dist));
const { at, plan, DocumentFault } = api;

const text = readFileSync(new URL('samples/3rps.json', dist), 'utf8');
const motion = await plan(text);
const joints = at(motion, 'joints', 64);
const goal = at(motion, 'goal', 64);

/** Of the kind, with where, what and what is accepted in the message. */
const WRONG = [
  ['plan', [undefined], TypeError, /^The document is undefined\. Accepted: .*object or its text/],
  ['plan', [() => 1], TypeError, /^The document is a function\. Accepted: /],
  ['plan', [{ version: 1n }], TypeError, /^The document cannot be written as JSON .*Accepted: /],
  ['plan', [42], DocumentFault, /^The document: this is the number 42\. Accepted: /],
  ['plan', [null], DocumentFault, /^The document: this is null\. Accepted: /],
  ['plan', [''], DocumentFault, /^The document: there is no text\. Accepted: /],
  ['plan', [text, { signal: 5 }], TypeError, /^The option signal is the number 5\. Accepted: an AbortSignal/],
  ['plan', [text, { stop: new AbortController() }], TypeError, /^The option stop is an object \(AbortController\)\. Accepted: an AbortSignal/],
  ['plan', [text, { onProgress: 'x' }], TypeError, /^The option onProgress is the text "x"\. Accepted: a function/],
  ['plan', [text, { singal: null, sginal: new AbortController().signal }], TypeError, /^The option sginal is unknown\. Accepted: signal, stop, onProgress/],
  ['plan', [text, 5], TypeError, /^The argument options is the number 5\. Accepted: an object with signal/],
  ['compareMetrics', [text, { stop: new AbortController().signal }], TypeError, /^The option stop is unknown\. Accepted: signal\./],
  ['explain', [text, undefined, goal], TypeError, /^joints is undefined\. Accepted: an array of numbers/],
  ['explain', [text, joints, ['1']], TypeError, /^goal\[0\] is the text "1"\. Accepted: a number/],
  ['explain', [text, [1], goal], DocumentFault, /^Joints: .*Accepted: 15/],
  ['pull', [text, joints, 5], TypeError, /^goal is the number 5\. Accepted: an array of 7 numbers/],
  ['drive', [text, joints, '0', 1], TypeError, /^variable is the text "0"\. Accepted: a whole number, counted from 0/],
  ['drive', [text, joints, 0, NaN], DocumentFault, /^Value: NaN .*Accepted: /],
  ['trace', [text, '3'], TypeError, /^frame is the text "3"\. Accepted: a whole number, counted from 0/],
  ['trace', [text, 129], DocumentFault, /Accepted: a whole number from 0 to 128/],
  ['matrix', [text], TypeError, /^joints is undefined/],
  ['exportMotion', [text, 5], TypeError, /^format is the number 5\. Accepted: csv, json, mjcf/],
  ['exportMotion', [text, 'nope'], DocumentFault, /Accepted: csv, json, mjcf/],
  ['assemble', [42], TypeError, /^type is the number 42\. Accepted: .*3RRS/],
  ['make', [undefined], TypeError, /^request is undefined\. Accepted: /],
  ['makeNamed', [5], TypeError, /^name is the number 5\. Accepted: .*delta/],
  ['makeNamed', ['delta', {}, 5], TypeError, /^unit is the number 5\. Accepted: m, cm, mm, µm, in/],
  ['readPoses', [undefined], TypeError, /^table is undefined\. Accepted: /],
  ['chainByIndex', ['1', 0], TypeError, /^constraints is the text "1"\. Accepted: a number/],
  ['assemblyByIndex', [1, {}], TypeError, /^k is an object \(Object\)\. Accepted: a number/],
];

for (const [name, args, kind, message] of WRONG) {
  test(`${name}: ${message}`, async () => {
    await assert.rejects(api[name](...args), (error) => error instanceof kind && message.test(error.message) && (kind !== DocumentFault || typeof error.where === 'string'));
  });
}

test('at names what it cannot read; frames are counted from 0', () => {
  assert.throws(() => at(motion, 'nope', 1), { name: 'TypeError', message: 'name is the text "nope". Accepted: joints, pose, goal, rows.' });
  for (const frame of [1e9, -1, 129, 1.5, NaN]) assert.throws(() => at(motion, 'joints', frame), { name: 'RangeError', message: `frame is the number ${frame}. Accepted: a whole number from 0 to 128.` });
  assert.throws(() => at(motion, 'joints', '1'), TypeError);
  assert.throws(() => at(undefined, 'joints', 1), { name: 'TypeError', message: /^motion is undefined\. Accepted: / });
  assert.throws(() => at({}, 'joints', 1), { name: 'TypeError', message: /^motion has no frames and joints/ });
  assert.deepEqual(at(motion, 'joints', 0), motion.joints.slice(0, 15));
  assert.deepEqual(at(motion, 'pose', 128), motion.pose.slice(-7));
});

test('none of them has cost a thread, and options may be undefined or null', async () => {
  assert.equal((await plan(text, { signal: undefined, stop: null })).frames, 129);
  assert.equal(threads, 1);
});
