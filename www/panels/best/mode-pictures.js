/**
 * Small pictures of the linkage in each of its ways to assemble, as the view would show it from where it is looked from now. One
 * after the other, so that the page answers in between.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 * @typedef {typeof import('../../export/picture.js').drawPicture} DrawPicture
 */
import { groupAt } from '../../core/shown.js';

/** In CSS pixels. */
export const PICTURE = { width: 210, height: 150 };

/**
 * @param {Pick<import('../../element/workbench.js').App, 'store' | 'player'>} app
 * @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene
 * @param {DrawPicture} drawPicture
 */
export function createModePictures({ store, player }, scene, drawPicture) {
  /** @type {{canvas: HTMLCanvasElement, mode: Mode, frame: number}[]} */
  let waiting = [];
  let working = false;

  async function work() {
    if (working) return;
    working = true;
    // What was rendered just now stands in the page then.
    await null;
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      draw(next);
      await new Promise((resolve) => setTimeout(resolve));
    }
    working = false;
  }

  /** @param {{canvas: HTMLCanvasElement, mode: Mode, frame: number}} one */
  function draw({ canvas, mode: { joints, rows, pose }, frame }) {
    const { motion, plain } = store.result;
    if (!motion || !plain || !canvas.isConnected) return;
    // The linkage alone: what belongs to the shown frame is not of this mode.
    const others = scene.pictured.filter(({ name, type, visible }) => type === 'Group' && name !== 'linkage' && name !== 'ground' && visible);
    for (const other of others) other.visible = false;
    try {
      scene.pose({ doc: plain, index: 0, frames: 1, joints, pose, rows, goal: groupAt(motion.goal, { index: Math.min(frame, motion.frames - 1), frames: motion.frames }) });
      drawPicture(scene, { ...PICTURE, ratio: Math.min(2, devicePixelRatio), names: false, whole: true, shadows: true }, canvas);
      canvas.dataset.drawn = '';
    } finally {
      for (const other of others) other.visible = true;
      player.invalidate();
    }
  }

  return {
    /** @param {HTMLCanvasElement} canvas @param {Mode} mode @param {number} frame of the key frame */
    show(canvas, mode, frame) {
      waiting = [...waiting.filter((one) => one.canvas !== canvas), { canvas, mode, frame }];
      work();
    },
  };
}
