/**
 * Moving by hand in the 3D view: a gizmo on the selected key frame. Loaded once the first motion is drawn.
 *
 * @typedef {import('./toolbar.js').How} How
 * @typedef {import('./key-frame.js').Target} Target
 * @typedef {import('./pointer-drags.js').Pointer} Pointer
 */
import { Quaternion, Vector3 } from 'three';
import { byId, element, setText } from '../dom.js';
import { lengthUnit, short } from '../format.js';
import { createLabels } from '../scene/labels.js';
import { nameOf } from '../scene/names.js';
import { readPalette } from '../scene/palette.js';
import { createGizmo } from './gizmo.js';
import { keyFrameTarget } from './key-frame.js';
import { createPointerDrags } from './pointer-drags.js';
import { ANGLE_STEP, lengthStep } from './steps.js';
import { createDragBar } from './toolbar.js';

/** Axis and direction of each nudging key. @type {Record<string, [0 | 1 | 2, 1 | -1]>} */
const NUDGES = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1], PageUp: [2, 1], PageDown: [2, -1] };

const KEY_FRAME = /^motion\.key_frames\[(\d+)\]/;

/** @param {import('../main.js').App} app */
export const createDrag = (app) => app.scene && connect(app, app.scene);

/** @param {import('../main.js').App} app @param {NonNullable<typeof app.scene>} scene */
function connect(app, scene) {
  const { store } = app;
  const { canvas } = scene;
  const size = () => scene.radius;
  const gizmo = createGizmo(scene);
  const layer = element('div', { class: 'hand-labels', 'aria-hidden': 'true' });
  byId('labels').after(layer);
  const labels = createLabels(layer);

  /** @type {How} */
  let how = { mode: 'move', space: 'world', snap: false };
  let selected = '';
  /** @type {Target | null} */
  let target = null;

  /** @param {string} place @returns {Target | null} */
  function targetOf(place) {
    const key = KEY_FRAME.exec(place);
    return key && Number(key[1]) < store.document.motion.key_frames.length ? keyFrameTarget(app, Number(key[1]), size) : null;
  }

  /** @param {Partial<How>} change */
  function choose(change) {
    how = { ...how, ...change };
    gizmo.set({ mode: how.mode === 'turn' ? 'rotate' : 'translate', space: how.space });
    show();
    scene.changed();
  }

  const bar = createDragBar(/** @type {HTMLElement} */ (canvas.parentElement?.querySelector('.banners')), choose, () => {});

  const steps = () => ({ length: lengthStep(size()), angle: ANGLE_STEP });

  /** Shows what is in hand where it is now. */
  function show() {
    if (!drags.busy) gizmo.show(target?.pose() ?? null);
    if (!target) return bar.show(null);
    const { length, angle } = steps();
    const unit = lengthUnit(store.document.length_unit);
    bar.show({
      name: target.name,
      how,
      steps: how.mode === 'turn' ? `${angle}°` : `${short(length)} ${unit}`,
      pullable: false,
      freedoms: null,
    });
    bar.tell(target.tell());
  }

  /** Another thing is selected. */
  function sync() {
    if (store.view.selected === selected) return;
    ({ selected } = store.view);
    target = targetOf(selected);
    show();
    scene.changed();
  }

  /** A drag of the gizmo. @param {Target} held @returns {import('./pointer-drags.js').Drag} */
  function gizmoDrag(held) {
    let begun = false;
    return {
      move(at, snap) {
        if (!begun) held.begin('drag');
        begun = true;
        gizmo.move(at, snap !== how.snap ? steps() : null);
        held.to(gizmo.pose(), how.mode === 'turn');
      },
      end() {
        gizmo.release();
        done(held);
      },
      cancel() {
        gizmo.release();
        if (begun) held.cancel();
        show();
      },
    };
  }

  /**
   * A drag of a thing itself, in the plane of the view.
   * @param {Target} held @param {string} place @param {Pointer} from @returns {import('./pointer-drags.js').Drag}
   */
  function planeDrag(held, place, from) {
    const pose = Array.from(held.pose() ?? []);
    const origin = new Vector3().fromArray(pose);
    const depth = origin.clone().project(scene.camera).z;
    const start = new Vector3(from.x, from.y, depth).unproject(scene.camera);
    let begun = false;
    return {
      move(at, snap) {
        if (!begun) {
          begun = true;
          store.setView({ selected: place });
          held.begin('drag');
        }
        const to = new Vector3(at.x, at.y, depth).unproject(scene.camera).sub(start).add(origin);
        if (snap !== how.snap) to.divideScalar(steps().length).round().multiplyScalar(steps().length);
        held.to([...to.toArray(), ...pose.slice(3)], false);
      },
      end: () => done(held),
      cancel() {
        if (begun) held.cancel();
        show();
      },
    };
  }

  /** Selects what can be moved. @param {string} place */
  function take(place) {
    if (!targetOf(place)) return;
    store.setView({ selected: place });
    setText(byId('view-live'), `Selected: ${nameOf(place, store)}.`);
    canvas.focus({ preventScroll: true });
  }

  /** A hand has let go. @param {Target} held */
  function done(held) {
    bar.say(`${held.name} at ${held.tell()}`);
    show();
  }

  const drags = createPointerDrags(canvas, {
    hover: (at) => gizmo.hover(at) || KEY_FRAME.test(store.view.hovered),
    grab(at, event) {
      if (target && gizmo.hover(at)) {
        gizmo.grab(at);
        return gizmoDrag(target);
      }
      const place = scene.pick(event);
      const held = place === selected ? target : targetOf(place);
      return held && planeDrag(held, place, at);
    },
    click: (event) => take(scene.pick(event)),
  });
  // A key frame inside the workpiece is reached by its name.
  byId('labels').addEventListener('click', ({ target: tag }) => {
    if (tag instanceof HTMLElement) take(tag.dataset.place ?? '');
  });
  scene.claimants.add((event) => drags.busy || gizmo.hover(drags.place(event)));

  /** One step along or about an axis. @param {Target} held @param {0 | 1 | 2} axis @param {1 | -1} sign */
  function nudge(held, axis, sign) {
    const pose = held.pose();
    if (!pose) return;
    const turn = new Quaternion(pose[3], pose[4], pose[5], pose[6]);
    const at = new Vector3(pose[0], pose[1], pose[2]);
    const along = new Vector3().setComponent(axis, 1);
    if (how.space === 'local') along.applyQuaternion(turn);
    const { length, angle } = steps();
    if (how.mode === 'turn') turn.premultiply(new Quaternion().setFromAxisAngle(along, (sign * angle * Math.PI) / 180));
    else at.addScaledVector(along, sign * length);
    held.begin('nudge');
    held.to([...at.toArray(), ...turn.toArray()], how.mode === 'turn');
    show();
    bar.say(`${held.name} at ${held.tell()}`);
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether the key was meant for what is in hand */
  function press({ key }) {
    if (key === 'Escape' && drags.cancel()) return true;
    if (!target) return false;
    if (key === 'Escape') store.setView({ selected: '' });
    else if (key in NUDGES) nudge(target, ...NUDGES[key]);
    else if ('gtGT'.includes(key)) choose({ mode: 'move' });
    else if ('rR'.includes(key)) choose({ mode: 'turn' });
    else if ('xwXW'.includes(key)) choose({ space: how.space === 'world' ? 'local' : 'world' });
    else return false;
    return true;
  }
  canvas.addEventListener(
    'keydown',
    (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || (event.shiftKey && event.key in NUDGES) || !press(event)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    { capture: true },
  );

  function paint() {
    gizmo.paint(readPalette(canvas));
  }
  paint();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
  addEventListener('themechange', paint);

  scene.drawn.add(() => {
    gizmo.look();
    const tips = target && !drags.busy ? gizmo.tips(how.space) : [];
    labels.set(tips.map((at, axis) => ({ at, text: 'xyz'[axis], place: 'hand' })), '', '');
    labels.place(scene.camera, canvas.clientWidth, canvas.clientHeight);
  });
  store.subscribe('view', sync);
  store.subscribe('document', () => {
    if (target && !target.pose()) store.setView({ selected: '' });
    if (target) show();
  });
  sync();
}
