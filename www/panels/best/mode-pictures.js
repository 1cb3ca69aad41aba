/**
 * Small pictures of the linkage in each of its ways to assemble, all with one camera: it takes in all of each way, and looks
 * from where the view does, or from where the ways are told apart better. One after the other, so that the page answers in between.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 * @typedef {typeof import('../../export/picture.js')} Pictures
 * @typedef {{canvas: HTMLCanvasElement, mode: Mode, frame: number}} Wanted `frame` of the key frame
 */
import { Vector3 } from 'three';
import { groupAt } from '../../core/shown.js';
import { framingOf } from './mode-framing.js';

/** In CSS pixels. */
export const PICTURE = { width: 210, height: 150 };

/** How many radii of a link a point must be apart from one way to another: one of a rod that only turns is less. */
const APART = 2.5;

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'player'>} app
 * @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene
 * @param {Pick<Pictures, 'drawPicture' | 'pointsOf'>} pictures
 */
export function createModePictures({ store, player }, scene, { drawPicture, pointsOf }) {
  /** @type {Wanted[]} */
  let wanted = [];
  /** What is still to be drawn. @type {Wanted[]} */
  let waiting = [];
  let working = false;
  /** What the camera takes in and where it looks from, and the ways that this was found for. @type {{points?: Vector3[], from?: Vector3, of: string}} */
  let fit = { of: '' };

  const pause = () => new Promise((resolve) => setTimeout(resolve));

  async function work() {
    if (working) return;
    working = true;
    // What was rendered just now stands in the page then.
    await null;
    for (;;) {
      wanted = wanted.filter(({ canvas }) => canvas.isConnected);
      if (!waiting.length) break;
      const of = wanted.map(({ mode, frame }) => `${frame} ${mode.joints.join()}`).join('\n');
      if (fit.of !== of) {
        fit = { ...framed(), of };
        waiting = [...wanted];
        await pause();
        continue;
      }
      const next = waiting.shift();
      if (next?.canvas.isConnected) draw(next);
      await pause();
    }
    working = false;
  }

  /**
   * Calls something while the scene has the linkage alone in a way: what belongs to the shown frame is not of this mode.
   * @template T @param {Wanted} one @param {() => T} act @returns {T | undefined}
   */
  function posed({ mode: { joints, rows, pose }, frame }, act) {
    const { motion, plain } = store.result;
    if (!motion || !plain) return undefined;
    const others = scene.pictured.filter(({ name, type, visible }) => type === 'Group' && name !== 'linkage' && name !== 'ground' && visible);
    for (const other of others) other.visible = false;
    try {
      scene.pose({ doc: plain, index: 0, frames: 1, joints, pose, rows, goal: groupAt(motion.goal, { index: Math.min(frame, motion.frames - 1), frames: motion.frames }) });
      return act();
    } finally {
      for (const other of others) other.visible = true;
      player.invalidate();
    }
  }

  /** The joints' places. @param {import('three').Object3D} linkage */
  function jointsOf(linkage) {
    /** @type {Vector3[]} */
    const places = [];
    linkage.updateWorldMatrix(false, true);
    linkage.traverse((object) => /\.joints\[\d+\]$/.test(object.userData.place ?? '') && places.push(object.getWorldPosition(new Vector3())));
    return places;
  }

  function framed() {
    const linkage = scene.pictured.filter(({ name }) => name === 'linkage');
    const all = wanted.flatMap((one) => posed(one, () => [{ points: pointsOf(linkage), joints: jointsOf(linkage[0]) }]) ?? []);
    return framingOf(all, scene.camera.getWorldDirection(new Vector3()).negate(), APART * scene.linkRadius);
  }

  /** @param {Wanted} one */
  function draw(one) {
    posed(one, () => drawPicture(scene, { ...PICTURE, ratio: Math.min(2, devicePixelRatio), names: false, whole: true, fit: fit.points, from: fit.from, shadows: true }, one.canvas));
    one.canvas.dataset.drawn = '';
  }

  return {
    /** @param {HTMLCanvasElement} canvas @param {Mode} mode @param {number} frame of the key frame */
    show(canvas, mode, frame) {
      const others = (/** @type {Wanted} */ one) => one.canvas !== canvas;
      wanted = [...wanted.filter(others), { canvas, mode, frame }];
      waiting = [...waiting.filter(others), { canvas, mode, frame }];
      work();
    },
  };
}
