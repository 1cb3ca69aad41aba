/**
 * The 3D view in the page: opens it where there is WebGL, keeps it in step with the store, says it in words.
 */
import { byId, setText } from './dom.js';
import { createScene } from './scene/scene.js';
import { shown } from './shown.js';
import { describeScene } from './view/words.js';

/** @param {import('./store.js').Store} store @param {import('./player.js').Player} player */
export function createStage(store, player) {
  /** What the view was last turned to: another document's motion is seen from the front. @type {unknown} */
  let origin = null;
  /** The motion in the view. @type {unknown} */
  let drawn = null;

  const note = byId('view-note');
  const tell = (/** @type {string} */ text) => {
    note.hidden = text === '';
    setText(note, text);
  };
  /** @type {HTMLCanvasElement} */
  const canvas = byId('canvas');
  canvas.addEventListener('webglcontextlost', () => tell('The 3D view was interrupted by the browser. Tables and numbers go on.'));
  canvas.addEventListener('webglcontextrestored', () => {
    tell('');
    player.invalidate();
  });
  const scene = createScene({ canvas, labels: byId('labels') }, () => player.invalidate());
  if (!scene) tell('This browser shows no 3D graphics (WebGL 2). Tables and numbers work without them.');

  store.subscribe('result', () => {
    const { motion, document } = store.result;
    if (!motion || !document || motion === drawn) return;
    drawn = motion;
    const afresh = store.originOf(document) !== origin;
    origin = store.originOf(document);
    scene?.show(store.result, afresh);
  });
  let posture = store.view.posture;
  store.subscribe('view', () => {
    if (store.view.posture !== posture) player.invalidate();
    ({ posture } = store.view);
  });
  const describe = () => {
    if (!store.view.playing) setText(byId('canvas-text'), describeScene(store));
  };
  store.subscribe('result', describe);
  store.subscribe('view', describe);

  return {
    scene,
    draw() {
      const what = shown(store);
      if (what) scene?.draw(what);
    },
  };
}
