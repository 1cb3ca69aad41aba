// Frames are drawn where the convention of the tables puts them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { frameOf } from '../../www/core/frame-of.js';
import { frameMatrix } from '../../www/core/poses.js';

const read = (path) => JSON.parse(readFileSync(new URL(path, import.meta.url), 'utf8'));
const golden = read('../golden/closest-motion.json');

for (const name of ['2TPR', '3RPS']) {
  test(`${name}: bases, grippers and key frames are those of the golden motions`, () => {
    const sample = read(`../../www/mechanisms/${name.toLowerCase()}.json`);
    const { chains, keys } = golden.find((motion) => motion.name === name);
    const pairs = [
      ...sample.chains.flatMap((chain, i) => [[chain.base, chains[i].G], [chain.gripper, chains[i].H]]),
      ...sample.motion.key_frames.map((key, i) => [key, keys[i]]),
    ];
    for (const [frame, rows] of pairs) {
      const drawn = frameMatrix(frame).transpose().toArray();
      rows.flat().forEach((value, i) => assert.ok(Math.abs(drawn[i] - value) < 1e-8, `${name} ${i}: ${drawn[i]} is not ${value}`));
    }
  });
}

const poseOf = (frame) => {
  const [at, turn, size] = [new Vector3(), new Quaternion(), new Vector3()];
  frameMatrix(frame).decompose(at, turn, size);
  return [...at.toArray(), ...turn.toArray()];
};
const close = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) < tolerance, `${what}: ${a} is not ${b}`);

test('the coordinates of a pose are those that it was made of, also beyond the poles and over several turns', () => {
  for (const longitude of [-400, -170, 0, 33]) {
    for (const latitude of [-135, -90, -89.9999, 0, 40, 90, 120]) {
      for (const roll of [-200, 0, 75]) {
        const frame = { x: 1, y: -2, z: 0.5, longitude, latitude, roll };
        const found = frameOf(poseOf(frame), { ...frame, longitude: longitude + 3, latitude: latitude - 2, roll: roll + 1 });
        const same = poseOf(found);
        poseOf(frame).forEach((value, i) => close(Math.abs(same[i]), Math.abs(value), 1e-7, `${JSON.stringify(frame)} ${i}`));
        if (Math.abs(Math.abs(latitude) - 90) > 1) {
          for (const key of ['longitude', 'latitude', 'roll']) close(found[key], frame[key], 1e-6, `${JSON.stringify(frame)} ${key}`);
        }
      }
    }
  }
});

test('a turn through the pole keeps longitude and roll from jumping', () => {
  let near = { longitude: 20, latitude: 88, roll: 10 };
  for (let latitude = 88; latitude <= 92; latitude += 0.25) {
    const found = frameOf(poseOf({ longitude: 20, latitude, roll: 10 }), near);
    close(found.longitude, 20, 1e-4, `longitude at ${latitude}`);
    close(found.latitude, latitude, 1e-4, 'latitude');
    near = found;
  }
});
