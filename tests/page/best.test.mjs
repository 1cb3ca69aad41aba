// The best motion in words and pictures: estimates, lanes, the curve from closer to calmer, and the state of the search.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { boundSentence, branchName, branchesSentence, calmWords, distance, isCloser, jointMotion, jointStep, oneIn, searchWords, switchSentence, unseenSentence, verdict } from '../../www/panels/best/best-words.js';
import { labelsOf, lanesOf, outlineOf, runsOf } from '../../www/panels/best/lanes.js';
import { distanceAxis, getsCalmer, placesOf, pointsOf } from '../../www/panels/best/calm.js';
import { gapLine } from '../../www/panels/best/strip-overlay.js';
import { highestGap } from '../../www/bar/strip.js';
import { createSearchState } from '../../www/panels/best/search-state.js';
import { clearestDirection, framingOf } from '../../www/panels/best/mode-framing.js';
import { jointLines } from '../../www/panels/best/mode-joints.js';
import { bestMode, ordered } from '../../www/panels/best/mode-order.js';
import { bestMotions, closestName } from '../../www/core/best-motions.js';
import { shownName } from '../../www/export/shown-name.js';
import { createStore } from '../../www/core/store.js';
import { statusWords } from '../../www/core/status-words.js';
import { DocumentFault, Superseded } from '../../www/planner/errors.js';

const cost = (mean, largest_step = 0.1) => ({ mean, largest: 2 * mean, largest_step });
const best = {
  progress: 1, starts: 240, followed: cost(0.04), best: cost(0.026, 0.6), lower_bound: 0.025, unseen: 0.005, unseen_bound: 1 / 60,
  branches: [
    { first: 0, metric: Float64Array.of(0, 0.04, 0.09, 0.04, 0) },
    { first: 1, metric: Float64Array.of(0.01, 0.01) },
    { first: 2, metric: Float64Array.of(0.5, 0.5, 0.5) },
    { first: 0, metric: Float64Array.of(0.3) },
  ],
  lane: Int32Array.of(0, 1, 1, 0, -1),
  switches: [{ frame: 1, time: 0.25, from: 0, to: 1, length: Math.PI / 2, largest: 0.08, points: 9 }],
  curve: [{ price: 0.1, ...cost(0.03, 0.3) }, { price: 1, ...cost(0.05, 0.05) }],
  found_where_lost: [2],
};
const motionOf = (unit, metric = [0, 0.04, 0.09, 0.04, 0]) => ({
  frames: metric.length, goal_frames: metric.length, partial: false, metric: Float64Array.from(metric), status: Uint8Array.from(metric, () => 1),
  report: { statuses: ['reached', 'closest'], chains: [{ variables: [{ unit }] }] },
});

test('the estimate of what was not seen stands in words', () => {
  assert.deepEqual([0.005, 1 / 60, 0.0123, 0.25, 0.3, 0.45, 1, 3.2e-5].map(oneIn), ['1 in 200', '1 in 60', '1 in 81', '1 in 4', '1 in 3', '45 in 100', '100 in 100', '1 in 31000']);
  assert.equal(unseenSentence(best, 'branch'), 'About 1 in 200 further starts would find another branch (95 %: at most 1 in 60).');
  assert.equal(unseenSentence({ starts: 100, unseen: 0, unseen_bound: 0.019 }, 'way'), 'Every way was found more than once: at most 1 in 53 further starts would find another one (95 %).');
  assert.match(unseenSentence({ starts: 2, unseen: 1, unseen_bound: 1 }, 'way'), /Too few starts/);
  assert.equal(unseenSentence({ starts: 0, unseen: 1, unseen_bound: 1 }, 'way'), '');
});

test('branches and ways to assemble are counted by two searches: what is not the same is explained', () => {
  assert.equal(branchesSentence(best, 0, 8), 'The search for the best motion knows 4 branches, 2 of them at this key frame: it makes its own starts, over all frames.');
  assert.match(branchesSentence(best, 4, 4), /4 branches, 2 of them/);
  assert.equal(branchesSentence({ branches: [best.branches[0]] }, 4, 1), '');
  assert.match(branchesSentence({ branches: [best.branches[0]] }, 4, 2), /knows 1 branch, 1 of them/);
});

test('the bound, the verdict and a switch are told as they are', () => {
  assert.match(boundSentence(best), /closer on average than 0\.025; this one is 0\.001 above it, the price of switching\.$/);
  assert.match(boundSentence({ ...best, lower_bound: 0.026 }), /and this one is as close\.$/);
  assert.equal(verdict(best), 'A motion with 1 switch to another branch is closer on average by 35 %.');
  const stays = { ...best, best: best.followed, switches: [], lane: new Int32Array(5) };
  assert.match(verdict(stays), /is the best one over the 4 branches found/);
  assert.equal(verdict({ ...best, best: best.followed, progress: 0.5 }), '', 'nothing is claimed before the end');
  assert.equal(verdict({ ...best, best: best.followed, branches: [best.branches[0]], switches: [], starts: 0 }), 'Every frame reaches its goal: nothing can be closer.');
  assert.match(verdict({ ...stays, branches: [best.branches[0]] }), /^No other branch was found/);
  // Not the followed one, though its mean is as good.
  assert.equal(verdict({ ...best, best: best.followed }), 'The best motion is not the one that the planner follows: it has 1 switch to another branch, and on average it is as close.');
  assert.equal(verdict({ ...best, best: cost(best.followed.mean * (1 - 1e-5)), switches: [] }), 'The best motion is not the one that the planner follows: it is on another branch, and on average it is hardly closer.');
  assert.equal(switchSentence(best.switches[0], motionOf('rad')), 'Before frame 2: from the followed branch to branch 2, joint motion 90°, at most 0.08 from the goal on the way.');
  assert.match(switchSentence({ ...best.switches[0], frame: 0 }, motionOf('length')), /^At the start: .* joint motion 1\.571 rad or sizes,/);
  assert.deepEqual([branchName(0), branchName(3)], ['followed', 'branch 4']);
  assert.equal(jointMotion(0.5, motionOf('length')), '0.5');
  assert.deepEqual([0.00031234, Math.PI / 2, 0].map((value) => jointStep(value, motionOf('rad'))), ['0.0179°', '90°', '0°']);
  assert.equal(jointStep(0.00031234, motionOf('length')), '0.000312');
  assert.equal(calmWords(best.curve[0], motionOf('length')), 'mean distance 0.03, largest joint step 0.3 rad or sizes');
  assert.equal(calmWords(best.curve[0], motionOf('rad')), 'mean distance 0.03, largest joint step 17.2°');
  assert.deepEqual([0.0172, 0.036, 1.5e-7, 1.1e-12, 9e-13, -3e-31, 0].map(distance), ['0.0172', '0.036', '1.5e−7', '1.1e−12', '0', '0', '0']);
  assert.ok(isCloser(0.0172, 0.036) && !isCloser(0.036 - 1e-8, 0.036) && !isCloser(0, 5e-7));
  assert.equal(statusWords('passing').word, 'Passing');
});

test('how far a search came is said where it was stopped; switching has a price only where there is a switch', () => {
  const alone = { ...best, best: best.followed, branches: [best.branches[0]], switches: [], lane: new Int32Array(5), progress: 0.376 };
  assert.match(boundSentence(alone), /; this one is 0\.015 above it\.$/);
  assert.equal(searchWords({ best: alone, running: false }, null), 'Nothing closer has been found so far. The search was stopped at 37 %.');
  assert.equal(searchWords({ best: alone, running: true }, null), 'Nothing closer has been found so far.');
  assert.equal(searchWords({ best: { ...best, progress: 0.5 }, running: false }, null), 'A motion with 1 switch to another branch is closer on average by 35 %. The search was stopped at 50 %.');
  assert.equal(searchWords({ best, running: false }, null), verdict(best));
  assert.equal(searchWords({ best: null, running: true }, null), 'Searching …');
});

test('before a search it is said whether there is anything to gain', () => {
  const closest = motionOf('rad');
  assert.match(searchWords({ best: null, running: false }, closest), /Another branch may be closer/);
  assert.equal(searchWords({ best: null, running: false }, { ...closest, status: new Uint8Array(5) }), 'Every frame reaches its goal: nothing can be closer.');
});

test('lanes: the followed branch, those of the best motion, then the closest others; many are left out and counted', () => {
  assert.deepEqual(runsOf(best.lane), [{ branch: 0, from: 0, to: 0 }, { branch: 1, from: 1, to: 2 }, { branch: 0, from: 3, to: 3 }]);
  const { lanes, more, top } = lanesOf(best);
  assert.deepEqual(lanes.map(({ branch, first, last, used }) => [branch, first, last, used]), [[0, 0, 4, true], [1, 1, 2, true], [3, 0, 0, false], [2, 2, 4, false]]);
  assert.deepEqual([more, top], [0, 0.5]);
  const rounded = { branches: [{ first: 0, metric: Float64Array.of(0, 4e-28) }], lane: Int32Array.of(0, 0) };
  assert.equal(lanesOf(rounded).top, 0, 'what is rounding is not drawn');
  const many = { ...best, branches: [...best.branches, ...Array.from({ length: 30 }, () => best.branches[2])] };
  assert.deepEqual([lanesOf(many).lanes.length, lanesOf(many).more], [8, 26]);
});

test('labels of switches leave out what would cover a neighbour', () => {
  const at = (...places) => labelsOf(places.map((place) => ({ at: place, text: '0.405' })), 24).map(({ text }) => text);
  assert.deepEqual(at(10, 100, 200), ['0.405', '0.405', '0.405']);
  assert.deepEqual(at(10, 30, 200), ['·', '·', '0.405'], 'neither over its neighbour’s mark');
  assert.deepEqual(at(10, 48, 200), ['0.405', '·', '0.405']);
  assert.deepEqual(labelsOf([{ at: 0, text: '1.234 rad' }, { at: 48, text: '2' }], 24).map(({ text }) => text), ['·', '2'], 'a long one needs more room');
});

test('a lane’s outline: roots as heights, the largest of each piece, and what has run away is full', () => {
  const outline = (metric, pieces) => outlineOf({ first: 10, metric: Float64Array.from(metric) }, 0.16, pieces);
  assert.deepEqual(outline([0, 0.04, 0.16], 9), [{ frame: 10, height: 0 }, { frame: 11, height: 0.5 }, { frame: 12, height: 1 }]);
  assert.deepEqual(outline([0, 0.04, 0.16, 0], 2).map(({ frame }) => frame), [11, 12]);
  assert.equal(outline([NaN], 2)[0].height, 1);
  assert.deepEqual(outlineOf({ first: 0, metric: Float64Array.of(0) }, 0, 2), [{ frame: 0, height: 0 }]);
});

test('in the strip the followed and the best motion stand in one scale, that of the higher one', () => {
  const [followed, best] = [motionOf('rad', [0, 0.04, 0.01]), motionOf('rad', [0, 0.16, 0.09])];
  const heights = (motion) => [...gapLine(motion, Math.max(highestGap(followed), highestGap(best))).matchAll(/ ([\d.]+)/g)].map(([, y]) => (18 - Number(y)) / 17);
  assert.deepEqual(heights(best).map((share) => share.toFixed(2)), ['0.00', '1.00', '0.75'], 'what is higher than the other is not cut off');
  assert.deepEqual(heights(followed).map((share) => share.toFixed(2)), ['0.00', '0.50', '0.25']);
});

test('the slider goes over the best motion and the points of the curve; the picture holds them all', () => {
  const points = pointsOf(best, null).map(({ point }) => point);
  assert.deepEqual(points.map(({ mean }) => mean), [0.026, 0.03, 0.05]);
  const near = { ...best, curve: [{ ...cost(0.026001, 0.60001) }, ...best.curve, { ...cost(0.05, 0.050001) }] };
  assert.deepEqual(pointsOf(near, null).map(({ choice }) => choice), [0, 2, 3], 'what reads like the one before is left out');
  const places = placesOf(points, best.followed);
  assert.ok(places.points[0].x > places.points[1].x && places.points[1].x > places.points[2].x, 'calmer is to the left');
  assert.ok(places.points[0].y > places.points[1].y && places.points[1].y > places.points[2].y, 'closer is below');
  assert.ok([...places.points, places.followed].every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y) && x >= 0 && y >= 0));
  // Distances that are close together fill the picture too; what is far from them is at its edge.
  const heights = (means, followed) => {
    const { points: at, followed: other, beyond, low, high } = placesOf(means.map((mean) => cost(mean)), cost(followed));
    return { share: (at[0].y - at.at(-1).y) / 76, low: Number(low.toFixed(9)), high: Number(high.toFixed(9)), beyond, inside: other.y >= 8 && other.y <= 84 };
  };
  const { share, ...ends } = heights([0.025712, 0.02575, 0.025828], 0.0258);
  assert.ok(share > 0.6, `${share} of the height`);
  assert.deepEqual(ends, { low: 0.02571, high: 0.02583, beyond: false, inside: true });
  assert.deepEqual([heights([0.0257, 0.0258], 0.04), heights([0.0257, 0.0258], 0.001)].map(({ beyond, inside, low }) => [beyond, inside, low]), [[true, true, 0.0257], [true, true, 0.0257]]);
  assert.deepEqual([distanceAxis([0.01, 0.05], 0.03), distanceAxis([0.03, 0.03], 0.04), distanceAxis([0, 0], 0)], [[0, 0.05], [0, 0.04], [0, 1]]);
  assert.deepEqual([[0.004, 0.0224923], [0.0224923, 0.0224923]].map((means) => distanceAxis(means, 0.001).map((end) => Number(end.toFixed(9)))), [[0, 0.023], [0, 0.023]], 'its end is a round number');
  // Where the best motion is far closer than the followed one, that is at the edge.
  assert.deepEqual([distanceAxis([0.001, 0.002], 0.1), heights([0.001, 0.002], 0.1).beyond], [[0, 0.002], true]);
  const still = placesOf([{ mean: 0, largest_step: 0 }], { mean: 0, largest_step: 0 });
  assert.ok(Number.isFinite(still.points[0].x) && Number.isFinite(still.points[0].y));
});

test('the slider is there where a point of the curve is calmer by 10 % or more', () => {
  assert.ok(getsCalmer(best));
  const flat = (...steps) => ({ ...best, curve: steps.map((step) => ({ price: step, ...cost(0.03, step) })) });
  assert.ok(!getsCalmer(flat(0.6, 0.545, 0.7)));
  assert.ok(getsCalmer(flat(0.6, 0.539)));
  assert.ok(!getsCalmer({ ...flat(0), best: cost(0.01, 0) }), 'what stands still');
});

test('modes: by nearness or by their motions; the best one is known when all are planned', () => {
  const found = [{ index: 0, metric: 0, mean: 0.02, is_start: true }, { index: 1, metric: 0.1, mean: 0.01, is_start: false }, { index: 2, metric: 0.05, is_start: false }];
  assert.deepEqual(ordered(found, 'key').map(({ index }) => index), [0, 2, 1]);
  assert.deepEqual(ordered(found, 'motion').map(({ index }) => index), [1, 0, 2]);
  assert.equal(bestMode({ progress: 1, found })?.index, 1);
  assert.equal(bestMode({ progress: 0.9, found }), undefined);
  assert.equal(bestMode(null), undefined);
  // A certified frame counts more than a distance; where motions are alike, there is no reason for another start.
  const lost = [{ index: 0, metric: 0, mean: 0.01, certified: 20 }, { index: 1, metric: 0.1, mean: 0.02, certified: 33 }];
  assert.equal(bestMode({ progress: 1, found: lost })?.index, 1);
  const alike = [{ index: 0, metric: 0, mean: 1e-25, certified: 33, is_start: false }, { index: 1, metric: 1e-26, mean: 3e-25, certified: 33, is_start: true }];
  assert.equal(bestMode({ progress: 1, found: alike })?.index, 1);
});

test('ways to assemble: the whole linkage is framed in each, and what differs is told', () => {
  const at = (...xs) => xs.map((x) => new Vector3(x, 0, 0));
  const ways = [at(0, 1, 2), at(0, 1.2, 5)].map((points) => ({ points, joints: points }));
  const { points, from } = framingOf(ways, new Vector3(1, 0, 0), 0.5);
  assert.deepEqual(points.map(({ x }) => x), [0, 1, 2, 0, 1.2, 5], 'also what is alike in all, such as motors and feet');
  assert.ok(Math.abs(from.x) < 0.9, 'not along what differs');
  assert.deepEqual(framingOf([], new Vector3(1, 0, 0), 0.5), { points: [], from: undefined });
  const chains = [{ name: 'leg', variables: [{ unit: 'rad', label: 'θ1', joint: 0 }, { unit: 'rad', label: 'θ2', joint: 0 }] }, { variables: [{ unit: 'length', label: 'd1', joint: 0 }] }];
  const found = [{ joints: [0, Math.PI / 2, 3] }, { joints: [0, -Math.PI / 2, 3] }];
  assert.deepEqual(jointLines(found[1], found, chains), ['leg: θ2 −90°']);
  assert.deepEqual(jointLines(found[0], [found[0]], chains), [], 'one way has nothing to be told from');
  const many = [0, 1].map((joint) => ({ joints: Array(14).fill(joint) }));
  const legs = ['near', 'far'].map((name) => ({ name, variables: Array(7).fill({ unit: 'rad' }) }));
  assert.deepEqual(jointLines(many[0], many, legs), [], 'there is no start to tell it from');
  const flipped = [many[0], many[1], { joints: [...Array(7).fill(0), ...Array(7).fill(1)] }].map((way, i) => ({ ...way, is_start: i === 0 }));
  assert.deepEqual(flipped.map((way) => jointLines(way, flipped, legs)), [[], ['from the document’s start it differs in near, far'], ['from the document’s start it differs in far']]);
});

test('ways to assemble are seen from where they are told apart, from the present side if that is as good', () => {
  const spot = (...xyz) => new Vector3(...xyz);
  // Two ways that differ along y, one that differs from both along z.
  const ways = [[spot(0, 0, 0), spot(5, 0, 0)], [spot(0, 3, 0), spot(5, 0, 0)], [spot(0, 0, 4), spot(5, 0, 0)]];
  assert.equal(clearestDirection(ways, spot(1, 0, 0), 0.1), undefined);
  const along = clearestDirection(ways, spot(0, 1, 0), 0.1);
  assert.ok(Math.abs(along.length() - 1) < 1e-9 && Math.abs(along.y) < 0.5 && along.z > 0, 'not along y, and from above');
  assert.deepEqual([clearestDirection([], spot(1, 0, 0), 0.1), clearestDirection([ways[0], ways[0]], spot(1, 0, 0), 0.1)], [undefined, undefined]);
});

/** A store with a motion, and a search whose answers are given by hand. */
function made() {
  const doc = { version: 1, chains: [], motion: {} };
  const store = createStore(doc);
  const followed = motionOf('rad');
  store.setResult({ motion: followed, doc, plain: doc });
  const asked = [];
  const closer = motionOf('rad', [0, 0.01, 0.01, 0.04, 0]);
  const search = {
    left: false,
    best: (text, options) => new Promise((resolve, reject) => {
      options.signal.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
      asked.push({ resolve, reject, ...options });
    }),
    bestMotion: async () => closer,
    exportBest: async (...what) => JSON.stringify(what),
    calmMotion: async (_, price) => ({ motion: { ...closer, price }, ...cost(price) }),
    leave() {
      this.left = true;
    },
  };
  const life = new AbortController();
  return { store, doc, followed, closer, asked, search, life, state: createSearchState({ store, signal: life.signal }, search) };
}
const turn = () => new Promise((resolve) => setTimeout(resolve));

test('partial results are there at once; the best motion takes the followed one’s place when it is wanted', async () => {
  const { store, followed, closer, asked, state } = made();
  const over = state.begin();
  state.begin();
  assert.equal(asked.length, 1, 'one search at a time');
  asked[0].onProgress({ ...best, progress: 0.3, curve: [] });
  await turn();
  assert.deepEqual([state.now.running, state.now.best.progress, state.now.motion], [true, 0.3, closer]);
  assert.deepEqual(state.betterAt(1), { best: 0.01, now: 0.04 });
  assert.equal(state.betterAt(3), null);
  assert.ok(state.isFoundWhereLost(2) && !state.isFoundWhereLost(1));
  asked[0].resolve(best);
  await over;
  assert.equal(state.now.running, false);
  state.show('best');
  assert.equal(store.result.motion, state.now.motion);
  assert.deepEqual(state.betterAt(1), { best: 0.01, now: 0.04 }, 'still against the followed one');
  await state.choose(2);
  assert.deepEqual([store.result.motion.price, state.now.choice, state.now.which], [1, 2, 'best']);
  assert.deepEqual(JSON.parse(await bestMotions.get(store.result.motion).write('csv', {})).slice(1), ['csv', {}, 1], 'written as it is shown');
  assert.deepEqual([bestMotions.get(store.result.motion).switches, bestMotions.get(closer).switches, bestMotions.has(followed)], [0, 1, false]);
  assert.equal(bestMotions.get(store.result.motion).words, 'A calmer motion is shown: mean 1 (best 0.026), largest joint step 5.73° (best 34.4°)');
  assert.deepEqual([store.result.motion, closer, followed, null].map(closestName), ['calmer motion', 'best motion', 'closest motion', 'closest motion']);
  assert.equal(bestMotions.get(closer).words, 'The best motion is shown');
  assert.deepEqual([store.result.motion, closer, followed].map((motion) => shownName({ doc: { name: '3-PRS' }, motion }, 'csv')), ['3-prs-calmer.csv', '3-prs-best.csv', '3-prs.csv']);
  assert.equal(shownName({ doc: {}, motion: closer }, 'csv'), 'linkage-best.csv');
  state.show('followed');
  assert.equal(store.result.motion, followed);
  await state.choose(0);
  assert.deepEqual([state.now.choice, state.now.which, store.result.motion], [0, 'both', followed]);
  await state.begin();
  assert.equal(asked.length, 1, 'what is complete is not searched again');
});

test('an edit ends the search quietly, and what it found goes with the document', async () => {
  const { store, asked, state } = made();
  const over = state.begin();
  asked[0].onProgress(best);
  store.edit((doc) => ({ ...doc, name: 'other' }));
  await over;
  assert.ok(asked[0].signal.aborted);
  assert.deepEqual([state.now.best, state.now.running, state.now.message, state.now.which], [null, false, '', 'followed']);
  assert.match(state.obstacle(), /no motion/);
  await state.begin();
  assert.equal(asked.length, 1, 'nothing is searched before it is planned');
});

test('what goes wrong is told in its place; a person may stop and go on', async () => {
  const { asked, state, life, search } = made();
  let over = state.begin();
  asked[0].reject(new DocumentFault({ code: 'no_goals', message: 'there are no goals', where: '' }));
  await over;
  assert.deepEqual([state.now.running, state.now.message], [false, 'There are no goals.']);
  over = state.begin();
  assert.equal(state.now.message, '');
  const half = { ...best, progress: 0.5 };
  asked[1].onProgress(half);
  await turn();
  state.stop();
  await over;
  assert.deepEqual([state.now.running, state.now.best], [false, half]);
  over = state.begin();
  asked[2].reject(new Superseded());
  await over;
  life.abort();
  assert.ok(search.left);
});
