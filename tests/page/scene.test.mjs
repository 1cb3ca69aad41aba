// The scene's bodies are kept while they still fit: a goal that is dragged builds nothing anew.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Mesh, MeshBasicMaterial } from 'three';
import { createMaterials } from '../../www/view3d/scene/materials.js';
import { gapClass, gapFrames, gapSteps } from '../../www/view3d/scene/gap-lines.js';
import { ghostFrames } from '../../www/view3d/scene/ghosts.js';
import { Linkage } from '../../www/view3d/scene/linkage.js';
import { Tube } from '../../www/view3d/scene/tube.js';

const sample = JSON.parse(readFileSync(new URL('../../www/mechanisms/3rps.json', import.meta.url), 'utf8'));

/** Poses without a turn, along x. */
const poses = (count, step) => Float64Array.from({ length: 7 * count }, (_, i) => (i % 7 === 0 ? step * Math.floor(i / 7) : i % 7 === 6 ? 1 : 0));

/** A motion whose chains are those of the document; where its rows stand is of no importance. */
function motionOf(doc, frames, step) {
  const chains = doc.chains.map(({ joints }) => ({ rows: joints.flatMap(({ type, rows }, joint) => rows.map(() => ({ kind: type, joint }))) }));
  const rows = chains.reduce((sum, chain) => sum + chain.rows.length, 0);
  return { frames, report: { chains }, rows: poses(2 * rows * frames, step), pose: poses(frames, 0), goal: poses(frames, step) };
}

test('a new motion of the same linkage builds no body; another dimension builds that chain only', () => {
  const linkage = new Linkage(createMaterials());
  const motion = motionOf(sample, 3, 0.1);
  assert.ok(linkage.update(motion, sample, 0.03, -0.1));
  const chains = () => linkage.group.children.filter(({ userData }) => !userData.place);
  const first = chains();
  assert.equal(first.length, 3);
  assert.equal(linkage.update({ ...motion, goal: poses(3, 0.2) }, { ...sample, motion: { key_frames: [] } }, 0.03, -0.1), false);
  assert.deepEqual(chains().map((group) => first.indexOf(group)), [0, 1, 2]);
  const longer = structuredClone(sample);
  longer.chains[1].joints[1].rows[0].a = 0.3;
  assert.ok(linkage.update(motion, longer, 0.03, -0.1));
  assert.equal(chains().filter((group) => first.includes(group)).length, 2);
  linkage.update(motionOf({ chains: sample.chains.slice(0, 2) }, 3, 0.1), { ...sample, chains: sample.chains.slice(0, 2) }, 0.03, -0.1);
  assert.equal(chains().length, 2);
});

test('a tube is laid anew in the same buffers, around the points and no others', () => {
  const tube = new Tube(new MeshBasicMaterial());
  tube.lay(poses(100, 0.1), 100, 0.02);
  const { geometry } = tube.mesh;
  const places = geometry.getAttribute('position');
  assert.ok(tube.mesh instanceof Mesh && tube.mesh.visible);
  const whole = geometry.drawRange.count;
  tube.lay(poses(90, 0.1), 90, 0.02);
  assert.equal(geometry.getAttribute('position'), places);
  assert.ok(geometry.drawRange.count < whole);
  const { center, radius } = geometry.boundingSphere;
  assert.ok(Math.abs(center.x - 4.45) < 1e-9 && Math.abs(radius - 4.47) < 1e-9);
  for (const corner of geometry.index.array.slice(0, geometry.drawRange.count)) {
    const off = Math.hypot(places.getY(corner), places.getZ(corner));
    assert.ok(Math.abs(off - 0.02) < 1e-6, `corner ${corner} is ${off} off the curve`);
  }
  tube.lay(poses(90, 0), 90, 0.02);
  assert.equal(tube.mesh.visible, false, 'a motion on the spot has no curve');
});

test('gaps have a class by round sizes, and no line where they are hidden', () => {
  const steps = gapSteps(1.2);
  assert.deepEqual(steps, [0, 0.02, 0.1]);
  assert.deepEqual([0, 0.019, 0.02, 0.3].map((gap) => gapClass(gap, steps)), [0, 0, 1, 2]);
  const gaps = Float64Array.from({ length: 129 }, (_, frame) => (frame < 64 ? 0 : 0.1));
  const frames = gapFrames({ frames: 129, translation_gap: gaps }, 0.03);
  assert.ok(frames.length > 5 && frames.length <= 24 && frames.every((frame) => frame >= 64));
});

test('ghosts stand at the key frames, evenly, or where they were put', () => {
  const motion = motionOf(sample, 11, 0.1);
  const doc = { motion: { key_frames: [{ x: 0 }, { x: 0.52 }, { x: 1 }] } };
  assert.deepEqual(ghostFrames('none', motion, doc), []);
  assert.deepEqual(ghostFrames('keys', motion, doc), [0, 5, 10]);
  assert.deepEqual(ghostFrames('spread', motion, doc).at(-1), 10);
  assert.deepEqual(ghostFrames([3, 40], motion, doc), [3]);
});
