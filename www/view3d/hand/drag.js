/**
 * Moving by hand in the 3D view: a gizmo on the selected key frame or the workpiece, handles of the freedoms
 * that the workpiece has, and things dragged themselves. Loaded when a hand may come.
 *
 * @typedef {import('./toolbar.js').How} How
 * @typedef {import('./key-frame.js').Target} Target
 */
import { element, setText } from '../../ui/dom.js';
import { onKeys } from '../../ui/keys.js';
import { lengthUnit, short } from '../../core/format.js';
import { createLabels } from '../scene/labels.js';
import { nameOf } from '../../core/things.js';
import { readPalette } from '../scene/palette.js';
import { postureActions } from './posture-actions.js';
import { clearOfNames, onCanvas } from './clear-of-names.js';
import { createFreedoms } from './freedoms.js';
import { createGizmo } from './gizmo.js';
import { keyFrameTarget } from './key-frame.js';
import { createLookAt } from './look-at.js';
import { createMoves } from './moves.js';
import { createMoving } from './moving.js';
import { createPointerDrags } from './pointer-drags.js';
import { ANGLE_STEP, lengthStep } from './steps.js';
import { howWords } from './how-words.js';
import { createDragBar } from './toolbar.js';
import { workpieceTarget } from './workpiece.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/drag.css?inline';

/** Axis and direction of each nudging key. @type {[0 | 1 | 2, 1 | -1][]} */
const NUDGES = [[0, 1], [0, -1], [1, 1], [1, -1], [2, 1], [2, -1]];

const KEY_FRAME = /^motion\.key_frames\[(\d+)\]/;

/** @param {import('../../element/workbench.js').App} app */
export const createDrag = (app) => app.scene && connect(app, app.scene);

/** @param {import('../../element/workbench.js').App} app @param {NonNullable<typeof app.scene>} scene */
function connect(app, scene) {
  const { store, signal } = app;
  app.explain();
  wear(app.root, look);
  const { canvas } = scene;
  const size = () => scene.radius;
  createLookAt(scene);
  const gizmo = createGizmo(scene, () => app.player.invalidateSoon());
  const layer = element('div', { class: 'hand-labels', 'aria-hidden': 'true' });
  app.find('labels').after(layer);
  const labels = createLabels(layer, true);

  const workpiece = workpieceTarget(app);
  const freedoms = createFreedoms(app, scene);

  /** @type {How} */
  let how = { mode: 'move', space: 'world', snap: false };
  /** @type {Target | null} */
  let target = null;
  /** What was taken hold of. */
  let taken = '';
  const moving = createMoving(app, () => show());

  /** The posture that the hand waits for is to be told. */
  let saying = false;

  /** @param {string} place @returns {Target | null} */
  function targetOf(place) {
    if (place === 'workpiece') return workpiece;
    const key = store.readonly ? null : KEY_FRAME.exec(place);
    const target = key && keyFrameTarget(app, Number(key[1]), size);
    return target?.pose() ? target : null;
  }

  /** @param {Partial<How>} change */
  function choose(change) {
    how = { ...how, ...change };
    gizmo.set({ mode: how.mode === 'turn' ? 'rotate' : 'translate', space: how.space });
    show();
    bar.say(howWords(how, target === workpiece ? freedoms.words() : null));
    scene.changed();
  }

  const bar = createDragBar(app.find('view-foot'), choose, step);
  app.find('back-to-motion').before(...postureActions(app).flatMap((button) => [button, ' ']));

  /** The workpiece goes by its freedoms. */
  const free = () => target === workpiece && how.mode === 'freedoms';

  const steps = () => ({ length: lengthStep(size()), angle: ANGLE_STEP });

  /** Shows what is in hand where it is now. */
  function show() {
    if (!drags.busy) {
      gizmo.show(free() ? null : (target?.pose() ?? null));
      freedoms.show(free());
      canvas.classList.toggle('free', free());
    }
    if (!target) return bar.show(null);
    const { length, angle } = steps();
    const unit = lengthUnit(store.doc.length_unit);
    bar.show({
      name: target.name,
      how: target === workpiece || how.mode !== 'freedoms' ? how : { ...how, mode: 'move' },
      steps: how.mode === 'turn' ? `${angle}°` : `${short(length)} ${unit}`,
      pullable: target === workpiece,
      freedoms: freedoms.words(),
      place: target.tell(),
    });
  }

  /** The same after a move: of a hand that goes on only the place is told, which then tells the rest. */
  function showMoved() {
    if (target && store.view.moving) bar.tell(target.tell());
    else show();
  }

  /** Where the thing in hand is on the canvas, which names leave free. @type {import('../scene/label-layout.js').Box[]} */
  let kept = [];

  /** The place of what is in hand on the canvas, in pixels, for scripts that take hold of it: `data-hand`. @param {number} width @param {number} height */
  function tellPlace(width, height) {
    const at = target?.pose();
    if (!at) return;
    const place = onCanvas(at, scene.camera, width, height);
    canvas.dataset.hand = place.map((pixels) => pixels.toFixed(1)).join(' ');
    kept = clearOfNames(place, free() ? [] : labels.boxes());
  }

  /** @param {string} selected */
  function hold(selected) {
    target = targetOf(selected);
    if (!target) delete canvas.dataset.hand;
    scene.changed();
    show();
  }

  /** The workpiece is elsewhere. */
  function follow() {
    if (target !== workpiece) return;
    showMoved();
    if (saying && !workpiece.busy()) {
      saying = false;
      bar.say(`workpiece at ${workpiece.tell()}`);
    }
  }

  /** One step along a freedom. @param {number} index @param {number} sign */
  function step(index, sign) {
    freedoms.nudge(index, sign, workpiece);
    saying = true;
  }

  /** Selects what can be moved. @param {string} place */
  function take(place) {
    if (!targetOf(place)) return;
    store.setView({ selected: place });
    setText(app.find('view-live'), `Selected: ${nameOf(place, store)}.`);
    canvas.focus({ preventScroll: true });
  }

  /** A hand has let go. @param {Target} held */
  function done(held) {
    // Where the workpiece comes to is known when the planner has answered.
    saying = held === workpiece;
    show();
    if (!saying) bar.say(`${held.name} at ${held.tell()}`);
  }

  const moves = createMoves(scene, gizmo, { how: () => how, steps, show, done, select: (place) => store.setView({ selected: place }) });
  const drags = createPointerDrags(canvas, {
    hover(at) {
      const freedom = free() ? freedoms.handles.pick(at) : -1;
      if (free()) freedoms.handles.light(freedom);
      return freedom >= 0 || gizmo.hover(at) || targetOf(store.view.hovered) !== null;
    },
    grab(at, event) {
      taken = store.view.selected;
      const freedom = free() ? freedoms.handles.pick(at) : -1;
      if (freedom >= 0) {
        freedoms.handles.light(freedom);
        return freedoms.grab(freedom, at, workpiece, () => done(workpiece));
      }
      if (target && gizmo.hover(at)) {
        gizmo.grab(at);
        return moves.gizmoDrag(target);
      }
      const place = scene.pick(event);
      // A finger that scrolls past takes hold of nothing: a tap selects it first.
      const passes = event.pointerType === 'touch' && app.interaction !== 'full';
      const held = place === store.view.selected ? target : passes ? null : targetOf(place);
      taken = place;
      return held && moves.planeDrag(held, place, at);
    },
    click: (event) => take(scene.pick(event)),
    stir: () => moving.stir(taken),
    calm: moving.calm,
  });
  // A key frame inside the workpiece is reached by its name.
  app.find('labels').addEventListener('click', ({ target: tag }) => {
    if (tag instanceof HTMLElement) take(tag.dataset.place ?? '');
  });
  scene.claimants.add((event) => drags.busy || gizmo.hover(drags.place(event)) || (free() && freedoms.handles.pick(drags.place(event)) >= 0));

  /** Only while something is in hand, and then for nobody else. @param {(held: Target, at: number) => void} act @returns {import('../../ui/keys.js').Handler} */
  const inHand = (act) => (event, at) => {
    if (!target) return false;
    event.stopImmediatePropagation();
    act(target, at);
  };
  onKeys(
    canvas,
    {
      letGo(event, at) {
        if (!drags.cancel()) return inHand(() => store.setView({ selected: '' }))(event, at);
        event.stopImmediatePropagation();
      },
      nudge: inHand((held, at) => moves.nudge(held, ...NUDGES[at])),
      move: inHand(() => choose({ mode: 'move' })),
      turn: inHand(() => choose({ mode: 'turn' })),
      freedoms: inHand((held) => (held === workpiece ? choose({ mode: 'freedoms' }) : bar.say('Only the workpiece has freedoms to move along: a key frame moves freely.'))),
      axes: inHand(() => choose({ space: how.space === 'world' ? 'local' : 'world' })),
    },
    { capture: true },
  );

  function paint() {
    const palette = readPalette(canvas);
    gizmo.paint(palette);
    freedoms.handles.paint(palette);
    scene.changed();
  }
  paint();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint, { signal });
  addEventListener('synthetica-theme', paint, { signal });

  /** Names of the handles: axes, or the numbers of freedoms. */
  function names() {
    const tips = free() ? freedoms.handles.tips().map((at, index) => ({ at, text: String(index + 1) })) : gizmo.tips(how.space);
    return tips.map((tip) => ({ ...tip, place: 'hand' }));
  }

  scene.covering.add(() => [...kept, ...labels.boxes()]);
  scene.drawn.add((width, height) => {
    kept = [];
    if (!target) return labels.set([], '', '');
    gizmo.look(height);
    labels.set(drags.busy ? [] : names(), '', '');
    labels.place(scene.camera, width, height, scene.size);
    tellPlace(width, height);
  });
  store.select(({ view }) => view.selected, hold);
  // What was held is not in another document.
  store.select(() => store.origin, drags.cancel);
  store.select(({ view }) => view.posture, follow);
  store.select(({ view }) => view.frame, follow);
  store.subscribe('why', () => {
    if (free()) show();
  });
  store.subscribe('document', () => {
    if (target && !target.pose()) store.setView({ selected: '' });
    if (target) showMoved();
  });
  hold(store.view.selected);
}
