// The mechanisms of tests/golden as documents, for tests that need one with a better branch: 3PRS, whose README says so.
import { readFileSync } from 'node:fs';

const all = JSON.parse(readFileSync(new URL('../golden/closest-motion.json', import.meta.url), 'utf8'));

/** The joints of each, by their numbers of rows. */
const TYPES = { '3PRS': ['P', 'R', 'S'], '3RPS': ['R', 'P', 'S'] };
const ROWS = { R: 1, P: 1, S: 3 };

const frame = (m) => ({ x: m[0][3], y: m[1][3], z: m[2][3], matrix: m.slice(0, 3).map((row) => row.slice(0, 3)) });

/** @param {'3PRS' | '3RPS'} name @param {number} [frames] */
export function goldenDocument(name, frames = 33) {
  const { chains, keys, start } = all.find((one) => one.name === name);
  let next = 0;
  return {
    version: 1,
    name,
    chains: chains.map(({ G, H, rows }) => {
      let row = 0;
      const joints = TYPES[name].map((type) => ({
        type,
        rows: rows.slice(row, (row += ROWS[type])).map(([alpha, a, theta, d]) => ({ alpha, a, theta: theta ?? 0, d: d ?? 0 })),
      }));
      // Angles are degrees in a document, radians in the file.
      const values = joints.flatMap(({ type, rows: own }) => own.map(() => (type === 'P' ? start[next++] : (start[next++] * 180) / Math.PI)));
      return { base: frame(G), joints, gripper: frame(H), start: values };
    }),
    motion: { key_frames: keys.map(frame), interpolation: 'bezier', frames, reference: [0, 0, 0], radius: 20 },
    planner: { metric: 'dual-quaternion', metric_length: 1, metric_origin: [0, 0, 0] },
  };
}
