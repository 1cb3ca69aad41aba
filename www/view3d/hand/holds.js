/**
 * What holds the workpiece back, drawn where it acts: the wrench of each chain that has a share in it, a force as an arrow along
 * its axis, a moment as a curved one about it; and the freedoms of the workpiece. Only while nothing moves, and only what is known
 * of what is shown.
 */
import { Group, Vector3 } from 'three';
import { chainName } from '../../core/chain-name.js';
import { originOf } from '../../core/poses.js';
import { percentages } from '../../core/percentages.js';
import { groupAt, hasNoGoal, shown, shownEnd } from '../../core/shown.js';
import { POINTS, REACH, across, arrow, footOn, free, line, screwPath, tint } from './screw-shapes.js';
import { drawnRows } from '../scene/spherical.js';
import { wrenchAt } from './screws.js';

/** Lengths as shares of the scene's radius: the arrow of the largest share and of the least, a moment's arrow, heads. */
const LONG = 0.5;
const SHORT = 0.2;
const ROUND = 0.11;
const HEAD = 0.035;

/** Widths in CSS pixels, and the dashes of an axis. */
const FORCE = 5;
const MOMENT = 3.5;
const FREEDOM = 2;
/** @type {[number, number]} */
const AXIS = [7, 5];

/** How much of a turn a moment's arrow goes. */
const TURN = 1.6 * Math.PI;

/** The rest in milliseconds after which it is drawn: answers may follow each other. */
const REST = 150;

/** How faint the others are while one chain is pointed at or chosen. */
const FAINT = 0.3;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'signal'>} app
 * @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene
 */
export function createHolds({ store, signal }, scene) {
  const group = new Group();
  /** @type {{chain: number, drawn: Group}[]} */
  let wrenches = [];
  /** @type {Group[]} */
  let freedoms = [];
  /** @type {import('../scene/labels.js').Label[]} */
  let names = [];
  /** @type {import('../scene/palette.js').Palette | null} */
  let palette = null;
  /** What was coloured last. */
  let coloured = '';
  const told = scene.added.add({
    group,
    names: () => names,
    paint(next) {
      palette = next;
      colour();
    },
  });

  function colour(anew = true) {
    const { selected, hovered } = store.view;
    const lit = [hovered, selected].map((place) => Number(/^chains\[(\d+)]/.exec(place)?.[1] ?? -1)).find((chain) => wrenches.some((one) => one.chain === chain));
    if (!palette || (!anew && coloured === String(lit))) return;
    coloured = String(lit);
    for (const { chain, drawn } of wrenches) tint(drawn, palette[/** @type {'chain-0'} */ (`chain-${chain % 5}`)], lit === undefined || lit === chain ? 1 : FAINT);
    for (const drawn of freedoms) tint(drawn, palette.closest);
    scene.canvas.dataset.lit = String(lit ?? '');
    scene.changed();
  }

  /** A chain's wrench. @param {number} chain @param {number} share of the largest @param {Vector3} origin @param {Vector3} end @param {number} metricLength */
  function wrench(chain, share, origin, end, metricLength) {
    const r = scene.radius;
    const drawn = new Group();
    const { at, force, moment, onAxis } = wrenchAt(/** @type {import('../../core/types.js').Why} */ (store.why).chains[chain].wrench, origin, end, r, metricLength);
    const long = (SHORT + (LONG - SHORT) * share) * r;
    const tip = at.clone();
    if (force) {
      const along = force.clone().normalize();
      tip.addScaledVector(along, long);
      drawn.add(arrow([at, tip.clone().addScaledVector(along, -2.6 * HEAD * r)], false, HEAD * r, FORCE));
      if (onAxis) drawn.add(line([at.clone().addScaledVector(along, -long), at.clone().addScaledVector(along, 1.6 * long)], 1, AXIS));
    }
    if (moment) {
      const about = moment.clone().normalize();
      const middle = force ? at.clone().addScaledVector(about, 0.45 * long * Math.sign(moment.dot(force) || 1)) : at;
      const arm = across(about).setLength(ROUND * r * (force ? 1 : 0.7 + 0.6 * share));
      const points = Array.from({ length: POINTS + 1 }, (_, i) => arm.clone().applyAxisAngle(about, (TURN * i) / POINTS).add(middle));
      drawn.add(arrow(points, false, HEAD * r, MOMENT));
      if (!force) {
        drawn.add(line([middle.clone().addScaledVector(about, -1.6 * ROUND * r), middle.clone().addScaledVector(about, 1.6 * ROUND * r)], 1, AXIS));
        tip.addScaledVector(about, 1.6 * ROUND * r);
      }
    }
    drawn.userData.place = `chains[${chain}].wrench`;
    return { chain, drawn, tip, kinds: [force && 'force', moment && 'moment'] };
  }

  /** @param {import('../../core/types.js').Insight['freedoms'][number]} screw @param {Vector3} origin */
  function freedom(screw, origin) {
    const r = scene.radius;
    const { from, points } = screwPath(screw, origin.toArray(), r);
    const drawn = arrow(points, true, 0.7 * HEAD * r, FREEDOM);
    if (screw.pitch !== null) {
      const foot = footOn(screw, from);
      const axis = new Vector3(...screw.direction).setLength(REACH * r);
      drawn.add(line([foot.clone().sub(axis), foot.clone().add(axis)], 1, AXIS));
    }
    return drawn;
  }

  /** The insight into what is shown, if it is known and nothing moves. */
  function known() {
    const { why, view } = store;
    const what = shown(store);
    const fits = why && what && why.of.joints === what.joints && why.of.goal === what.goal && why.of.index === what.index;
    return fits && !view.playing && !view.moving && shownEnd(store)?.status !== 'closure_lost' ? { why, what } : null;
  }

  /** @type {unknown[]} */
  let built = [];
  function clear() {
    free(group);
    group.clear();
    [wrenches, freedoms, names, built] = [[], [], [], []];
  }

  function build() {
    const now = known();
    const { show } = store.view;
    const holds = show.holds && !hasNoGoal(store) && !['reached', 'passing'].includes(shownEnd(store)?.status ?? '');
    const wanted = now ? [now.why, holds, show.freedoms, scene.radius] : [];
    if (wanted.length === built.length && wanted.every((part, i) => part === built[i])) return;
    clear();
    built = wanted;
    /** @type {Set<string | null>} */
    const kinds = new Set();
    const { motion } = store.result;
    if (now && motion) {
      const { why, what } = now;
      const origin = originOf(what.pose, what.index);
      const shares = percentages(why.chains.map(({ share }) => share));
      const most = Math.max(...shares);
      const rows = drawnRows(groupAt(what.rows, what), motion.report);
      let last = -1;
      why.chains.forEach((_, chain) => {
        last += 2 * motion.report.chains[chain].rows.length;
        if (!holds || !(shares[chain] > 0)) return;
        const { drawn, tip, kinds: own } = wrench(chain, shares[chain] / most, origin, originOf(rows, last), motion.report.metric.length);
        wrenches.push({ chain, drawn });
        names.push({ at: tip, text: `${chainName(why.of.doc.chains[chain], chain)} ${shares[chain]} %`, place: `chains[${chain}].wrench` });
        for (const kind of own) kinds.add(kind);
      });
      if (show.freedoms) freedoms = why.freedoms.map((screw) => freedom(screw, origin));
      if (freedoms.length) kinds.add('freedom');
      for (const one of [...wrenches.map(({ drawn }) => drawn), ...freedoms]) group.add(one);
    }
    scene.canvas.dataset.wrenches = wrenches.map(({ chain }) => chain).join();
    scene.canvas.dataset.freedoms = String(freedoms.length);
    colour();
    told([kinds.has('force') && '→ force that holds it back', kinds.has('moment') && '↻ moment that holds it back', kinds.has('freedom') && '↔ freedom of the workpiece'].filter((text) => text !== false));
  }

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  function follow() {
    clearTimeout(waiting);
    // What does not belong to what is shown goes at once.
    if (built.length && known()?.why !== built[0]) build();
    else colour(false);
    // The end of a move is heard of too.
    if (!store.view.moving) waiting = setTimeout(build, REST);
  }
  for (const part of /** @type {const} */ (['why', 'view', 'result'])) store.subscribe(part, follow);
  signal.addEventListener('abort', () => clearTimeout(waiting));
  build();
}
