// Frames are drawn where the convention of the tables puts them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { frameMatrix } from '../../www/scene/frame.js';

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
