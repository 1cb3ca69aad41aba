// Parameters and expressions: edits of the typed document leave the plain one, which the whole package reads, as it was.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { frameAsWritten } from '../../www/core/document-angles.js';
import { frameNumbers, withoutForms } from '../../www/core/frame-numbers.js';
import { expressionValue } from '../../www/core/expression-values.js';
import { measured, stepOf } from '../../www/core/number-steps.js';
import { applyOverrides, parseOverrides } from '../../www/core/overrides.js';
import * as parameters from '../../www/core/parameters.js';
import { createRanges, rangeAround } from '../../www/core/slider-range.js';
import { setChainType } from '../../www/core/edits.js';
import { addKeyFrame } from '../../www/core/key-frame-edits.js';
import { parseBlock } from '../../www/panels/tables/block-text.js';
import { turnedCopies } from '../../www/core/turned-copies.js';
import { convertLengths } from '../../www/core/units.js';
import { keyFrameTarget } from '../../www/view3d/hand/key-frame.js';

const at = (path) => new URL(`../../www/${path}`, import.meta.url);
const { initSync, Session } = await import(at('pkg/synthetica.js'));
initSync({ module: readFileSync(at('pkg/synthetica_bg.wasm')) });

/** The four-bar with its lengths named. */
function typed() {
  const doc = JSON.parse(readFileSync(at('mechanisms/four-bar.json'), 'utf8'));
  doc.parameters = { crank: 0.4, e3: 0.1, ground: '2*crank', one: 1 };
  const [a, b] = doc.chains;
  a.joints[1].rows[0].a = 'crank';
  b.base.x = ' ground ';
  b.joints[1].rows[0].a = 'one*crank/0.4 + 1e3*0*e3';
  a.joints[0].rows[0].d = 'e3';
  doc.motion.key_frames[1].x = 'ground';
  doc.motion.key_frames[0].longitude = 'acos(24/25)';
  return doc;
}
const plainOf = (doc) => {
  const session = Session.open(JSON.stringify(doc));
  const plain = JSON.parse(session.plain());
  session.free();
  return plain;
};

test('a parameter is found where it is used, as a whole word', () => {
  const doc = typed();
  assert.deepEqual(parameters.usesOf(doc, 'crank'), ['parameters.ground', 'chains[0].joints[1].rows[0].a', 'chains[1].joints[1].rows[0].a']);
  assert.deepEqual(parameters.usesOf(doc, 'e3'), ['chains[0].joints[0].rows[0].d', 'chains[1].joints[1].rows[0].a']);
  assert.deepEqual(parameters.usesOf(doc, 'cran'), []);
  // The mechanism's texts are no expressions.
  assert.deepEqual(parameters.usesOf({ ...doc, name: 'one', about: 'one' }, 'one'), ['chains[1].joints[1].rows[0].a']);
});

test('another name changes the document’s expressions and no number', () => {
  const doc = typed();
  const renamed = parameters.renameParameter(doc, 'e3', 'height_1');
  assert.deepEqual(Object.keys(renamed.parameters), ['crank', 'height_1', 'ground', 'one']);
  assert.equal(renamed.chains[1].joints[1].rows[0].a, 'one*crank/0.4 + 1e3*0*height_1');
  assert.deepEqual(plainOf(renamed), plainOf(doc));
  assert.deepEqual(plainOf(parameters.renameParameter(doc, 'crank', 'c')), plainOf(doc));
});

test('a parameter that is removed leaves its value', () => {
  const doc = typed();
  const removed = parameters.removeParameter(doc, 'crank', 0.4);
  assert.equal(removed.parameters.ground, '2*0.4');
  assert.equal(removed.chains[0].joints[1].rows[0].a, 0.4);
  assert.deepEqual(plainOf(removed), plainOf(doc));
  const negative = parameters.removeParameter({ ...doc, parameters: { ...doc.parameters, one: -2 }, motion: { ...doc.motion, radius: 'one^2' } }, 'one', -2);
  assert.equal(negative.motion.radius, '(-2)^2');
  assert.ok(!('parameters' in parameters.removeParameter({ ...doc, parameters: { lone: 1 } }, 'lone', 1)));
});

test('names that the page can refuse by itself', () => {
  const doc = typed();
  assert.equal(parameters.nameFault(doc, 'base_2'), '');
  for (const bad of ['', '2a', 'a b', 'ä']) assert.match(parameters.nameFault(doc, bad), /Accepted: a letter or _/);
  assert.match(parameters.nameFault(doc, 'crank'), /already a parameter/);
  assert.equal(parameters.freshParameterName({ ...doc, parameters: { p1: 1, p2: 2 } }), 'p3');
});

test('a parameter of a number, also in the cells with the same number of the same kind', () => {
  const doc = typed();
  const path = 'chains[0].base.y';
  assert.equal(doc.chains[0].base.y, 0.2);
  assert.deepEqual(parameters.sameNumbers(doc, path), ['chains[1].base.y']);
  // 90° of a start value is not 90 of a length.
  const turns = parameters.sameNumbers(doc, 'chains[0].start[0]');
  assert.ok(turns.includes('chains[1].start[0]') && turns.includes('chains[0].gripper.latitude'), turns.join());
  assert.deepEqual(parameters.sameNumbers({ ...doc, motion: { ...doc.motion, radius: 90 } }, 'motion.radius'), []);
  const named = parameters.nameNumber(doc, path, 'height', ['chains[1].base.y']);
  assert.deepEqual([named.chains[0].base.y, named.chains[1].base.y, named.parameters.height], ['height', 'height', 0.2]);
  assert.deepEqual(plainOf(named), plainOf(doc));
});

test('the values of expressions are told by their places, with their units', () => {
  const doc = typed();
  const session = Session.open(JSON.stringify(doc));
  while (session.advance_plan(1000));
  const motion = session.plan_so_far();
  session.free();
  const shown = { doc, result: { motion, doc, plain: motion.plain, fault: null } };
  assert.equal(expressionValue(shown, 'chains[1].base.x'), 0.8);
  assert.equal(expressionValue(shown, 'parameters.ground'), 0.8);
  assert.equal(expressionValue(shown, 'chains[0].base.x'), undefined);
  assert.equal(measured(doc, 'chains[1].base.x', 0.8), '0.8 m');
  assert.equal(measured(doc, 'motion.key_frames[0].longitude', 16.26), '16.26°');
  assert.equal(measured({ ...doc, angles: 'radians' }, 'motion.key_frames[0].longitude', 1.5), '1.5 rad');
  // What was typed since has no value yet; with a fault and other parameters nothing has.
  const changed = { ...doc, parameters: { ...doc.parameters, crank: '1/0' } };
  assert.equal(expressionValue({ doc: changed, result: { ...shown.result, fault: {} } }, 'chains[1].base.x'), undefined);
  assert.equal(expressionValue({ doc: { ...doc, parameters: { ...doc.parameters, ground: '3*crank' } }, result: shown.result }, 'parameters.ground'), undefined);
  // A parameter's step goes by its size, whatever it is called.
  assert.equal(stepOf({ ...doc, parameters: { a: 350 } }, 'parameters.a', 350), 10);
});

test('lengths given by expressions are converted, parameters stay', () => {
  const doc = typed();
  const mm = convertLengths(doc, 1000, 'mm');
  assert.deepEqual(mm.parameters, doc.parameters);
  assert.equal(mm.chains[0].joints[1].rows[0].a, '1000*(crank)');
  const [a, b] = [plainOf(mm), plainOf(convertLengths(plainOf(doc), 1000, 'mm'))];
  assert.deepEqual(a.chains, b.chains);
  assert.deepEqual(a.motion.key_frames, b.motion.key_frames);
  assert.deepEqual(convertLengths(mm, 0.001, 'm').chains[0].joints[1].rows[0].a, 'crank');
  const sum = convertLengths({ ...doc, motion: { ...doc.motion, radius: '2*(crank)+(one)' } }, 10, 'dm').motion.radius;
  assert.equal(sum, '10*(2*(crank)+(one))');
  const axes = { ...doc, home: { z: '-crank' }, chains: [{ joints: [{ type: 'R', point: ['crank', 1, 0], axis: [0, 0, 'one'] }] }] };
  const { home, chains: [{ joints: [joint] }] } = convertLengths(axes, 1000, 'mm');
  assert.deepEqual([home.z, joint.point, joint.axis], ['1000*(-crank)', ['1000*(crank)', 1000, 0], [0, 0, 'one']]);
});

test('copies of a chain with expressions are made of its numbers', () => {
  const doc = typed();
  const plain = plainOf(doc);
  const around = { count: 3, axis: 'z', point: [0, 0, 0] };
  const made = turnedCopies(doc, 0, around, plain.chains[0].start, plain.chains[0]);
  assert.equal(made.chains[0].joints[1].rows[0].a, 'crank');
  assert.equal(made.chains[1].joints[1].rows[0].a, 0.4);
  assert.deepEqual(plainOf(made).chains.slice(1, 3), plainOf({ ...plain, chains: turnedCopies(plain, 0, around, plain.chains[0].start).chains }).chains.slice(1, 3));
});

test('set= sets a parameter by its name, also where a field has it', () => {
  const doc = { ...typed(), parameters: { base: 350, name: 1 }, name: 'x' };
  const set = (text) => applyOverrides(doc, parseOverrides([text]));
  assert.deepEqual(set('base:400').parameters, { base: 400, name: 1 });
  assert.equal(set('base:2*name').parameters.base, '2*name');
  assert.deepEqual([set('name:7').parameters.name, set('name:7').name], [7, 'x']);
  assert.equal(set('about:new').about, 'new');
  assert.equal(set('parameters.name:2').parameters.name, 2);
});

test('a slider goes to twice its value, and further where more is typed', () => {
  assert.deepEqual([5, -5, 0].map(rangeAround), [{ low: 0, high: 10 }, { low: -10, high: 0 }, { low: -1, high: 1 }]);
  const ranges = createRanges();
  const from = {};
  assert.deepEqual(ranges.of(from, 'base', 350), { low: 0, high: 700, step: 1 });
  assert.equal(ranges.of(from, 'base', 500).high, 700);
  assert.equal(ranges.of(from, 'base', 800).high, 1600);
  assert.equal(ranges.of(from, 'base', -1).low, -2);
  assert.equal(ranges.of({}, 'base', 1).high, 2);
});

test('a key frame of expressions is moved from where it is, and what is touched becomes numbers', () => {
  let doc = typed();
  const plain = plainOf(doc);
  const told = [];
  const store = {
    get doc() {
      return doc;
    },
    result: { motion: null, doc, plain },
    edit: (change) => {
      doc = change(doc);
    },
  };
  const target = keyFrameTarget({ store, player: {}, say: (text) => told.push(text) }, 1, () => 1);
  assert.equal(target.pose()[0], 0.8);
  target.begin('drag');
  target.to([0.9, ...target.pose().slice(1)], false);
  assert.equal(doc.motion.key_frames[1].x, 0.9);
  target.to([1, ...target.pose().slice(1)], false);
  assert.equal(told.length, 1);
  assert.match(told[0], /^x of middle was an expression/);
  target.cancel();
  assert.equal(doc.motion.key_frames[1].x, 'ground');
});

test('frames in radians and in other forms have their numbers', () => {
  const doc = { angles: 'radians', motion: { key_frames: [{ x: 1, roll: Math.PI / 2 }, { z: 2, quaternion_wxyz: [1, 0, 0, 0] }] } };
  const plain = { motion: { key_frames: [{ x: 1, roll: 90 }, { z: 2, longitude: 0, latitude: 0, roll: 0 }] } };
  const store = { doc, result: { doc, plain } };
  assert.equal(frameNumbers(store, 'motion.key_frames[0]').roll, 90);
  assert.equal(frameNumbers(store, 'motion.key_frames[1]').z, 2);
  assert.equal(frameNumbers({ doc, result: { doc: null, plain: null } }, 'motion.key_frames[1]'), null);
  assert.equal(frameAsWritten(doc, { x: 1, roll: 180 }).roll, Math.PI);
  assert.deepEqual(withoutForms(doc.motion.key_frames[1]), { z: 2 });
});

test('a key frame between times that are expressions gets one between them', () => {
  const doc = { parameters: { t: 2 }, motion: { key_frames: [{ time: 0 }, { time: 't' }] } };
  const times = (next) => next.motion.key_frames.map(({ time }) => time);
  assert.deepEqual(times(addKeyFrame(doc, {}, 1)), [0, '((0)+(t))/2', 't']);
  assert.deepEqual(times(addKeyFrame(doc, {})), [0, 't', '(t)+1']);
});

test('commas of an expression part no cells when it is pasted', () => {
  assert.deepEqual(parseBlock('hypot(0.3, 0.4)'), [['hypot(0.3, 0.4)']]);
  assert.deepEqual(parseBlock('atan2(a, b)\t1'), [['atan2(a, b)', '1']]);
});

test('joints that are called U or by small letters stay where their type does', () => {
  const doc = { chains: [{ joints: [{ type: 'U', rows: [1] }, { type: 'p', rows: [2] }, { type: 'S' }] }] };
  const fresh = { R: { type: 'R' }, T: { type: 'T' }, P: { type: 'P' }, S: { type: 'S' } };
  assert.equal(setChainType(doc, 0, ['T', 'P', 'S'], fresh), doc);
  assert.deepEqual(setChainType(doc, 0, ['T', 'P', 'R'], fresh).chains[0].joints, [...doc.chains[0].joints.slice(0, 2), { type: 'R' }]);
});

test('the fields with texts that are no numbers are those of the schema', () => {
  const schema = JSON.parse(readFileSync(new URL('../../src/document/schema.json', import.meta.url), 'utf8'));
  const found = new Set();
  const isText = (/** @type {any} */ part) => part.enum || (part.$ref && schema.$defs[part.$ref.split('/').at(-1)].enum) || [part.type].flat().every((kind) => kind === 'string' || kind === 'null');
  for (const part of [schema, ...Object.values(schema.$defs)]) for (const [name, field] of Object.entries(part.properties ?? {})) if ((field.type || field.enum || field.$ref) && isText(field)) found.add(name);
  assert.deepEqual([...found].sort(), [...parameters.TEXTS].sort());
});
