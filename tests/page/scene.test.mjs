// The scene's bodies are kept while they still fit: a goal that is dragged builds nothing anew.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Box3, Color, DirectionalLight, Mesh, OrthographicCamera, PerspectiveCamera, Quaternion, Raycaster, Vector2, Vector3 } from 'three';
import { strokeTriangles } from '../../www/export/strokes.js';
import { createBestGhost } from '../../www/view3d/best-ghost.js';
import { createMaterials } from '../../www/view3d/scene/materials.js';
import { createMeasure } from '../../www/view3d/scene/measure.js';
import { gapClass, gapFrames, gapSteps } from '../../www/view3d/scene/gap-lines.js';
import { ghostFrames } from '../../www/view3d/scene/ghosts.js';
import { createLight } from '../../www/view3d/scene/light.js';
import { Linkage } from '../../www/view3d/scene/linkage.js';
import { hasLeft, showsWell } from '../../www/view3d/scene/refit.js';
import { curveThrough } from '../../www/view3d/scene/curve.js';
import { ballOf, onBall } from '../../www/view3d/scene/spherical.js';
import { createStops, travelLimits } from '../../www/view3d/scene/stops.js';
import { Stroke, StrokeMaterial, drawn } from '../../www/view3d/scene/stroke.js';

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

/** What a motion's line draws: its points from its own origin. */
function curve(column, frames, apart = 0.002) {
  const stroke = new Stroke(new StrokeMaterial(4));
  const lay = (poses_, count) => {
    const { points, count: kept } = curveThrough(poses_, count, apart);
    stroke.lay(points, kept);
  };
  lay(column, frames);
  return { stroke, lay };
}

test('a line is laid anew in the same buffers, through the points and no others', () => {
  const { stroke, lay } = curve(poses(100, 0.1), 100);
  const { geometry } = stroke;
  const places = geometry.getAttribute('position');
  assert.ok(stroke instanceof Mesh && stroke.visible);
  assert.equal(geometry.drawRange.count, 6 * 99);
  lay(poses(90, 0.1), 90);
  assert.equal(geometry.getAttribute('position'), places);
  assert.equal(geometry.drawRange.count, 6 * 89);
  const { center, radius } = geometry.boundingSphere;
  assert.ok(Math.abs(center.x - 4.45) < 1e-9 && Math.abs(radius - 4.45) < 1e-9, 'not the points of the longer one before');
  assert.ok(Math.abs(geometry.boundingBox.max.x - 8.9) < 1e-9);
  const other = geometry.getAttribute('other');
  for (const corner of geometry.index.array.slice(0, geometry.drawRange.count)) {
    assert.ok(Math.abs(Math.abs(places.getX(corner) - other.getX(corner)) - 0.1) < 1e-6 && places.getY(corner) === 0, `corner ${corner}`);
  }
  lay(poses(90, 0), 90);
  assert.equal(stroke.visible, false, 'a motion on the spot has no curve');
});

test('a line is as wide under the pointer as it is drawn, however near or far it is', () => {
  drawn.set(800, 600);
  const stroke = new Stroke(new StrokeMaterial(6));
  // From far away to behind the camera, a little below it.
  stroke.lay(Float64Array.of(0, 0, 100, 0, 0, -100), 2);
  for (const camera of [new PerspectiveCamera(50, 800 / 600, 0.1, 1000), new OrthographicCamera(-4, 4, 3, -3, 0.1, 1000)]) {
    camera.position.set(0, 1, 5);
    camera.updateMatrixWorld();
    const ray = new Raycaster();
    const hits = (x, y) => {
      ray.setFromCamera(new Vector2(x / 400, y / 300), camera);
      return ray.intersectObject(stroke).length;
    };
    // Both cameras see it on the vertical through the middle, below it.
    const rows = camera instanceof PerspectiveCamera ? [-20, -200, -299] : [-100];
    for (const row of rows) assert.deepEqual([0, 3.5, -3.5, 4.5, -4.5, 40].map((x) => hits(x, row)), [1, 1, 1, 0, 0, 0], `${camera.type} at ${row}`);
    assert.equal(hits(0, 40), 0, 'nothing of what is behind the camera');
  }
});

test('a drawing has the line in its width and in its dashes, in pixels of the drawing', () => {
  drawn.set(800, 600);
  const camera = new OrthographicCamera(-4, 4, 3, -3, 0.1, 100);
  camera.position.z = 5;
  camera.updateMatrixWorld();
  // 200 pixels long, up to the middle.
  const lay = (material) => {
    const stroke = new Stroke(material);
    stroke.lay(Float64Array.of(-2, 0, 0, 0, 0, 0), 2);
    return strokeTriangles(stroke, camera, 800, 600).flatMap(({ points }) => [points]);
  };
  const area = (all) => all.reduce((sum, [ax, ay, bx, by, cx, cy]) => sum + Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2, 0);
  const whole = lay(new StrokeMaterial(4));
  assert.ok(Math.abs(area(whole) - 204 * 4) < 1e-6, 'with half of its width beyond its ends');
  const [xs, ys] = [0, 1].map((axis) => whole.flatMap((three) => three.filter((_, at) => at % 2 === axis)));
  assert.deepEqual([Math.min(...ys), Math.max(...ys)], [298, 302]);
  assert.deepEqual([Math.min(...xs), Math.max(...xs)].map(Math.round), [198, 402]);
  const dashes = lay(new StrokeMaterial(4, { dash: [6, 4] }));
  assert.equal(dashes.length, 2 * 21);
  assert.ok(Math.abs(area(dashes) - 4 * (2 + 20 * 6 + 2)) < 1e-6);
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

/** The same poses, larger by a factor and then moved along x. */
const placed = (column, factor, along = 0) => column.map((value, i) => (i % 7 > 2 ? value : value * factor + (i % 7 === 0 ? along : 0)));
const placedMotion = (motion, factor, along = 0) => ({
  ...motion,
  rows: placed(motion.rows, factor, along),
  pose: placed(motion.pose, factor, along),
  goal: placed(motion.goal, factor, along),
});
const placedDoc = (factor, along = 0) => ({
  chains: sample.chains.map((chain) => ({ ...chain, base: { ...chain.base, z: (chain.base?.z ?? 0) * factor } })),
  motion: { key_frames: sample.motion.key_frames.map((key) => ({ ...key, x: (key.x ?? 0) * factor + along, y: (key.y ?? 0) * factor, z: (key.z ?? 0) * factor })) },
});

function measured(motion, doc) {
  const { size, take } = createMeasure();
  take(motion, doc, true);
  return size;
}

test('all sizes follow the unit of length, and all places the linkage', () => {
  const motion = motionOf(sample, 5, 0.1);
  const one = measured(motion, placedDoc(1));
  const thousand = measured(placedMotion(motion, 1000), placedDoc(1000));
  const moved = measured(placedMotion(motion, 1, 1e4), placedDoc(1, 1e4));
  for (const of of [(size) => size.radius, (size) => size.link, (size) => size.ground, (size) => size.home.radius, (size) => size.home.centre.x]) {
    assert.ok(Math.abs(of(thousand) / of(one) - 1000) < 1e-6, `${of}: ${of(thousand)} is not 1000 · ${of(one)}`);
  }
  assert.ok(Math.abs(moved.radius / one.radius - 1) < 1e-6);
  assert.ok(Math.abs(moved.home.centre.x - one.home.centre.x - 1e4) < 1e-6);
});

test('Fit view has all frames, the goal and the key frames in it, after any edit; small edits keep the proportions', () => {
  const motion = motionOf(sample, 5, 0.1);
  const doc = placedDoc(1);
  const { size, take } = createMeasure();
  take(motion, doc, true);
  const { link } = size;
  doc.motion.key_frames[1].y = 2;
  assert.equal(take(motion, doc, false), false, 'no new proportions');
  assert.equal(size.link, link);
  for (const { x, y, z } of doc.motion.key_frames) assert.ok(size.home.centre.distanceTo(new Vector3(x, y, z)) + 7 * link <= size.home.radius + 1e-9);
  assert.ok(take(placedMotion(motion, 1, 10), placedDoc(1, 10), false), 'of the same size at another place');
  assert.ok(Math.abs(size.centre.x - size.home.centre.x) < 1e-9);
});

test('a frame that runs away does not make the linkage a dot; a far key frame is shown, with a linkage of its own width', () => {
  const motion = motionOf(sample, 5, 0.1);
  const one = measured(motion, placedDoc(1));
  const rows = motion.rows.slice();
  // In the middle of the motion, whose ends are the extremes.
  rows[7 * Math.floor(rows.length / 14)] = 1000 * one.radius;
  assert.ok(Math.abs(measured({ ...motion, rows }, placedDoc(1)).radius / one.radius - 1) < 1e-9);
  const doc = placedDoc(1);
  doc.motion.key_frames[2].x = 100 * one.radius;
  const far = measured(motion, doc);
  assert.ok(far.home.radius > 49 * one.radius);
  assert.ok(far.link < 10 * one.link, 'no ball of joints as large as the way');
});

test('the view is fitted anew where the scene has left it by a factor', () => {
  const ball = (radius, x = 0) => ({ radius, centre: new Vector3(x, 0, 0) });
  assert.ok(!hasLeft(ball(1), ball(1.9)) && !hasLeft(ball(1), ball(1, 0.9)), 'not on a small edit');
  assert.ok(hasLeft(ball(1), ball(1000)) && hasLeft(ball(1000), ball(1)) && hasLeft(ball(1), ball(1, 10)));
  const view = { target: new Vector3(), reach: 2 };
  assert.ok(showsWell(view, ball(2)) && showsWell(view, ball(0.6)), 'a person has made room for it');
  assert.ok(!showsWell(view, ball(2000)) && !showsWell(view, ball(0.002)) && !showsWell(view, ball(1, 5)));
});

test('a motion far from the origin is as fine as one that is near', () => {
  const { stroke } = curve(placed(poses(100, 1e-3), 1, 1e6), 100, 1e-5);
  const places = stroke.geometry.getAttribute('position');
  assert.ok(Math.abs(places.getX(4 * 98 + 2) - 0.099) < 1e-8);
});

test('a foot has a soft shadow around it, darkest where it stands on the ground; in a dark scheme shadows are deeper', () => {
  const materials = createMaterials();
  const linkage = new Linkage(materials);
  linkage.update(motionOf(sample, 3, 0.1), sample, 0.03, -0.1);
  const soft = [];
  linkage.group.traverse((object) => object.material === materials.contact && soft.push(object));
  assert.equal(soft.length, 3);
  linkage.group.updateMatrixWorld(true);
  for (const { geometry, matrixWorld, castShadow } of soft) {
    const { count } = geometry.getAttribute('position');
    const corners = Array.from({ length: count }, (_, i) => [new Vector3().fromBufferAttribute(geometry.getAttribute('position'), i), geometry.getAttribute('color').getW(i)]);
    const dark = corners.toSorted(([a], [b]) => a.length() - b.length()).map(([, alpha]) => alpha);
    assert.deepEqual([dark[0], dark.at(-1)], [1, 0]);
    assert.ok(dark.every((alpha, i) => i === 0 || alpha <= dark[i - 1]), 'it fades outwards');
    const height = corners[0][0].applyMatrix4(matrixWorld).z;
    assert.ok(height > -0.1 && height < -0.099 && !castShadow, `it lies on the ground, at ${height}`);
  }
  const [light, night] = [0xb9b4ac, 0x3b4247].map((colour) => {
    materials.paint(new Proxy({}, { get: () => new Color(colour) }));
    return materials.contact.opacity;
  });
  assert.ok(night > light);
});

test('what the sun does not reach is lit from beside the camera, by a light without a shadow', () => {
  const { objects, aim, beforeDraw } = createLight(true);
  const [sun, fill] = objects.filter((object) => object instanceof DirectionalLight);
  aim(new Vector3(1e3, 0, 0), 2);
  const camera = new PerspectiveCamera();
  camera.position.set(1e3, -10, 0);
  camera.lookAt(1e3, 0, 0);
  camera.updateMatrixWorld();
  beforeDraw(camera, true);
  const from = fill.position.clone().sub(fill.target.position).normalize();
  assert.ok(sun.castShadow && !fill.castShadow && fill.intensity < sun.intensity);
  assert.ok(from.y < -0.5 && from.x < -0.5, `from the left of the camera, ${from.toArray()}`);
});

test('a slider has a collar at each limit that is given, which is coloured when it is reached; where none is given there is none', () => {
  const materials = createMaterials();
  for (const [type, unit, offset] of [['P', 1, 0], ['P', 1000, 0.2], ['C', 1, 0]]) {
    const r = 0.03 * unit;
    const limit = { min: (0.5 - offset) * unit, max: (1.5 - offset) * unit };
    const joint = { type, rows: [{ alpha: 0, a: 0, theta: 0, d: offset * unit }], limits: type === 'C' ? [null, limit] : [limit] };
    const stops = createStops(type, materials, r);
    const [least, largest, rail] = stops.group.children;
    stops.fit(travelLimits(joint), { low: 0.8 * unit, high: unit });
    stops.group.updateMatrixWorld(true);
    const at = (object) => object.getWorldPosition(new Vector3()).z / unit;
    // Beyond the limit by half of what slides and half of the collar: less than two radii of a link.
    assert.ok(at(least) < 0.5 && at(least) > 0.44 && at(largest) > 1.5 && at(largest) < 1.56, `${type}: ${at(least)}, ${at(largest)}`);
    assert.ok(rail.visible && Math.abs(rail.getWorldScale(new Vector3()).z / unit - (at(largest) - at(least))) < 1e-9);
    const marked = (travel) => {
      stops.mark(travel * unit);
      return [least, largest].map(({ material }) => material === materials.limit);
    };
    assert.deepEqual([marked(1), marked(1.5), marked(0.5), marked(0.5001)], [[false, false], [false, true], [true, false], [false, false]]);
    stops.fit(travelLimits({ ...joint, limits: type === 'C' ? [{ min: 0, max: 1 }, { max: 1.5 - offset }] : [{ min: null, max: (1.5 - offset) * unit }] }), { low: 0.8 * unit, high: unit });
    assert.equal(least.visible, false, 'only one limit is given');
    stops.fit(travelLimits({ ...joint, limits: undefined }), { low: 0.8 * unit, high: unit });
    assert.ok(![least, largest, rail].some(({ visible }) => visible));
    assert.deepEqual(marked(0), [false, false]);
  }
});

/** A chain along z, by how far each pose is along it: seat and moved frame of each row. */
function upright(kinds, ...frames) {
  const doc = { chains: [{ joints: kinds.map(([type]) => ({ type, rows: [] })) }], motion: { key_frames: [] } };
  const rows = kinds.flatMap(([kind, count], joint) => Array.from({ length: count }, () => ({ kind, joint })));
  const motion = { frames: frames.length, report: { chains: [{ rows }] }, rows: Float64Array.from(frames.flat().flatMap((z) => [0, 0, z, 0, 0, 0, 1])), pose: poses(frames.length, 0), goal: poses(frames.length, 0) };
  const linkage = new Linkage(createMaterials());
  linkage.update(motion, doc, 0.03, -0.1);
  const boxOf = (place, frame) => {
    linkage.show({ ...motion, index: frame });
    linkage.group.updateMatrixWorld(true);
    const box = new Box3();
    linkage.group.traverse((object) => object.userData.place === place && box.expandByObject(object));
    return box;
  };
  return boxOf;
}

test('a ball or universal joint stands where its axes meet, and the leg up to it is seen although its slider is at 0', () => {
  for (const [type, count] of [['S', 3], ['T', 2]]) {
    const end = Array(2 * count - 1).fill(1);
    // As a leg by axes: the whole length is an offset along the joint's first axis.
    const boxOf = upright([['R', 1], ['P', 1], [type, count]], [0, 0, 0, 0, 0, ...end], [0, 0, 0, 0.5, 0.5, ...end.map((z) => z + 0.5)]);
    for (const [frame, length] of [[0, 0], [1, 0.5]]) {
      const joint = boxOf('chains[0].joints[2]', frame);
      assert.ok(joint.min.z > length + 0.8 && joint.max.z < length + 1.2, `${type}: from ${joint.min.z} to ${joint.max.z}`);
      const link = boxOf('chains[0].joints[2].rows[0]', frame);
      assert.ok(Math.abs(link.min.z - length) < 0.05 && Math.abs(link.max.z - length - 1) < 0.05, `${type}: a link from ${link.min.z} to ${link.max.z}`);
    }
    // An offset along the last axis is a link of its own.
    const after = upright([['R', 1], [type, count]], [0, 0, ...Array(2 * count - 1).fill(0), 1])('chains[0].joints[1]', 0);
    assert.ok(after.max.z > 1 && after.min.z < 0);
  }
});

/** A motion of one frame whose joints R have these axes through a point; each chain's base is so far out on its first axis. */
function aboutPoint(centre, chains) {
  const pose = (axis, out) => [...centre.clone().addScaledVector(axis, out).toArray(), ...new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis).toArray()];
  const rows = chains.flatMap(({ axes, base }) => axes.flatMap((axis, joint) => [...pose(axis, joint ? 0 : base), ...pose(axis, 0)]));
  const report = { chains: chains.map(({ axes }) => ({ rows: axes.map((_, joint) => ({ kind: 'R', joint })) })) };
  return { frames: 1, report, rows: Float64Array.from(rows), pose: Float64Array.of(...centre.toArray(), 0, 0, 0, 1), goal: Float64Array.of(...centre.toArray(), 0, 0, 0, 1) };
}

test('where all axes meet in one point, as in the agile eye, the joints stand on a ball around it, and all of it is in view', () => {
  const centre = new Vector3(1, 2, 3);
  const [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => new Vector3(...axis));
  // The second chain's base is on the other side of its first axis.
  const motion = aboutPoint(centre, [{ axes: [x, y, z], base: 2 }, { axes: [y, z], base: -2 }]);
  const ball = ballOf(motion);
  assert.deepEqual([ball.centre.toArray(), ball.reaches.map((reach) => Number(reach.toFixed(9)))], [[1, 2, 3], [2, 2, 2, -2, 2]]);
  const places = onBall(ball, motion.rows);
  const at = (pose) => [0, 1, 2].map((i) => Number(places[7 * pose + i].toFixed(9)));
  assert.deepEqual([0, 1, 2, 4, 6, 8].map(at), [[3, 2, 3], [3, 2, 3], [1, 4, 3], [1, 2, 5], [1, 0, 3], [1, 2, 5]]);
  const doc = { chains: motion.report.chains.map(({ rows }) => ({ base: { x: 1, y: 2, z: 3 }, joints: rows.map(() => ({ type: 'R', rows: [] })) })), motion: { key_frames: [] } };
  const linkage = new Linkage(createMaterials());
  linkage.update(motion, doc, 0.05, 0);
  linkage.show({ ...motion, index: 0 });
  linkage.group.updateMatrixWorld(true);
  const middle = (place) => {
    const box = new Box3();
    linkage.group.traverse((object) => object.userData.place === place && box.expandByObject(object));
    return box.getCenter(new Vector3());
  };
  assert.ok(middle('chains[0].joints[2]').distanceTo(new Vector3(1, 2, 5)) < 0.05);
  // Links go from joint to joint.
  assert.ok(middle('chains[0].joints[1].rows[0]').distanceTo(new Vector3(2, 3, 3)) < 0.05);
  assert.ok(middle('chains[1].joints[1].rows[0]').distanceTo(new Vector3(1, 1, 4)) < 0.05);
  assert.ok(measured(motion, doc).home.radius > 2, 'it is in view');
  for (const other of [motionOf(sample, 1, 0.1), aboutPoint(centre, [{ axes: [x, y, z], base: 2 }])]) {
    // One axis that passes the point.
    if (other.report.chains.length === 1) other.rows[28] += 0.01;
    assert.equal(ballOf(other), null);
  }
});

test('the ghost of the best motion stands at the frame that is drawn, in a film too, which the playhead does not follow', () => {
  const motion = motionOf(sample, 3, 0.1);
  const best = { ...motion, pose: poses(3, 0.5) };
  const doc = { chains: sample.chains, motion: { key_frames: [] } };
  let part;
  const scene = { drawAsOne() {}, added: { add: (one) => ((part = one), () => {}) }, linkRadius: 0.03, size: { ground: -0.1 }, canvas: { dataset: {} }, changed() {} };
  const store = { view: { frame: 0, posture: null }, result: { motion, doc, plain: doc }, subscribe() {} };
  const search = { now: { motion: best, which: 'both', doc }, isFoundWhereLost: () => false, subscribe() {} };
  createBestGhost({ store }, scene, search);
  for (const [index, x] of [[0, 0], [2, 1], [5, 1]]) {
    part.pose({ index });
    assert.equal(part.group.children[0].children[0].position.x, x, `frame ${index}`);
  }
  assert.ok(part.group.visible);
});
