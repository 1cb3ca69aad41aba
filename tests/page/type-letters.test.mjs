// A chain's type as it is typed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readType } from '../../www/core/type-letters.js';

test('letters are read in either case, with blanks or without', () => {
  for (const text of ['RPS', 'r p s', ' Rps ', 'R-P-S', 'r, p, s']) assert.deepEqual(readType(text), { letters: ['R', 'P', 'S'] }, text);
});

test('U is another name of T', () => assert.deepEqual(readType('Ups'), { letters: ['T', 'P', 'S'] }));

test('what is no joint is named, with the letters that are', () => {
  for (const [text, bad] of [['RXS', 'X'], ['3RPS', '3'], ['R+S', '+']]) {
    const { fault } = readType(text);
    assert.ok(fault.startsWith(`“${bad}” is no joint. Accepted: `), fault);
    assert.match(fault, /R revolute, P prismatic, C cylindric, T universal, S spherical, E planar; U is T/);
  }
  assert.match(readType('  ').fault, /needs a joint\. Accepted/);
});
