// A frame's turn as quaternion, matrix and roll-pitch-yaw, and back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { anglesOf, quaternion, readTurn, rollPitchYaw, turnOf, writeTurn } from '../../www/core/orientation.js';

const FORMS = ['quaternion', 'matrix', 'rpy'];
const near = (a, b, within) => assert.ok(a.length === b.length && a.every((value, i) => Math.abs(value - b[i]) <= within), `${a} is not ${b}`);

/** Ordinary turns, and those where two of the three angles turn about one axis. */
const FRAMES = [
  {},
  { longitude: 10.445878326, latitude: 4.47675548, roll: -19.321078674 },
  { longitude: -170, latitude: -60, roll: 135 },
  { longitude: 0, latitude: 90, roll: 0 },
  { longitude: 37, latitude: 90, roll: 15 },
  { longitude: 37, latitude: -90, roll: 15 },
  { longitude: 90, latitude: 0, roll: 0 },
  { longitude: -90, latitude: 0, roll: 25 },
  { longitude: 180, latitude: 0, roll: 180 },
  { longitude: 0, latitude: 89.99999, roll: 40 },
  { longitude: 89.99999, latitude: 0.00001, roll: 40 },
];

test('every form of a turn, read again, is that turn, also where angles are not unique', () => {
  for (const frame of FRAMES) {
    const turn = turnOf(frame);
    for (const form of FORMS) {
      const read = readTurn(form, writeTurn(form, turn));
      assert.ok('turn' in read, `${form} of ${JSON.stringify(frame)}: ${read.fault}`);
      near(read.turn, turn, 1e-8);
      near(turnOf(anglesOf(read.turn)), turn, 1e-8);
    }
    const again = anglesOf(turn, frame);
    near(Object.values(again), ['longitude', 'latitude', 'roll'].map((name) => frame[name] ?? 0), 1e-5);
  }
});

test('the convention is R = Y(longitude) · X(−latitude) · Z(roll)', () => {
  const z = ({ longitude, latitude }) => [2, 5, 8].map((at) => turnOf({ longitude, latitude, roll: 77 })[at]);
  const [s, c] = [Math.sin(Math.PI / 6), Math.cos(Math.PI / 6)];
  near(z({ longitude: 0, latitude: 30 }), [0, s, c], 1e-15);
  near(z({ longitude: 30, latitude: 0 }), [s, 0, c], 1e-15);
  near(turnOf({ roll: 90 }), [0, -1, 0, 1, 0, 0, 0, 0, 1], 1e-15);
});

test('known turns have the numbers that other programs give them', () => {
  const half = Math.SQRT1_2;
  const about = { z: { roll: 90 }, y: { longitude: 90 }, x: { latitude: -90 } };
  near(quaternion(turnOf(about.z)), [0, 0, half, half], 1e-12);
  near(quaternion(turnOf(about.y)), [0, half, 0, half], 1e-12);
  near(quaternion(turnOf(about.x)), [half, 0, 0, half], 1e-12);
  near(rollPitchYaw(turnOf(about.z)), [0, 0, 90], 1e-12);
  near(rollPitchYaw(turnOf(about.x)), [90, 0, 0], 1e-12);
  // About the fixed x, y, z in this order: x to −z by the pitch, −z stays with the yaw.
  const { turn } = readTurn('rpy', '0 90 30');
  near([turn[0], turn[3], turn[6]], [0, 0, -1], 1e-12);
  near(rollPitchYaw(turn), [0, 90, 30], 1e-6);
});

test('what is rounded to three decimals is taken, and made a turn', () => {
  const { turn } = readTurn('quaternion', '[0.0, 0, 0.707, 0.707]');
  near(turn, turnOf({ roll: 90 }), 1e-12);
  const rounded = readTurn('matrix', '0.866, -0.5, 0; 0.5, 0.866, 0; 0, 0, 1').turn;
  near(rounded, turnOf({ roll: 30 }), 1e-4);
  for (const [i, j] of [[0, 1], [0, 2], [1, 2]]) assert.ok(Math.abs(rounded[i] * rounded[j] + rounded[3 + i] * rounded[3 + j] + rounded[6 + i] * rounded[6 + j]) < 1e-12);
});

test('what is no turn is refused with what is wrong, by how much, and what is accepted', () => {
  const refused = [
    ['quaternion', '0 0 1 1', /length is 1\.414213562.*0 0 0\.707106781 0\.707106781.*Accepted: four/],
    ['quaternion', '0 0 0 0', /no turn.*Accepted/],
    ['quaternion', '0 0 0.7', /There are 3 numbers.*Accepted: four/],
    ['quaternion', '0 0 a 1', /“a” is no number/],
    ['quaternion', '', /There are 0 numbers/],
    ['matrix', '1 0.1 0 0 1 0 0 0 1', /off by 0\.1, more than 0\.001.*Accepted: nine/],
    ['matrix', '1 0 0 0 1 0 0 0 -1', /mirrors.*right-handed/],
    ['matrix', '1 0 0 0 1 0 0 0', /There are 8 numbers/],
    ['rpy', '1 2', /There are 2 numbers.*degrees/],
  ];
  for (const [form, text, expected] of refused) {
    const answer = readTurn(form, text);
    assert.ok('fault' in answer, `${form} ${text} is refused`);
    assert.match(answer.fault, expected);
  }
});
