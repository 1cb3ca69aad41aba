/**
 * The 3D view in the page: opens it where there is WebGL, keeps it in step with the store, says it in words.
 */
import { setText } from '../ui/dom.js';
import { inWords } from '../ui/keys.js';
import { createScene } from '../view3d/scene/scene.js';
import { atRest } from '../core/at-rest.js';
import { shown } from '../core/shown.js';
import { describeScene } from '../core/status-words.js';

/** @param {Pick<import('./workbench.js').App, 'find' | 'store' | 'player' | 'signal'>} app */
export function createStage({ find, store, player, signal }) {
  /** What the view was last turned to: another document's motion is seen from the front. @type {unknown} */
  let origin = null;
  /** Whether the last motion came while a hand moved something. */
  let shownMoving = false;
  const note = find('view-note');
  const poster = find('poster');
  const tell = (/** @type {string} */ text) => {
    note.hidden = text === '';
    setText(note, text);
  };
  /** @type {HTMLCanvasElement} */
  const canvas = find('canvas');
  canvas.setAttribute('aria-label', `3D view of the linkage. ${inWords('turnView', 'shiftView', 'zoomIn', 'zoomOut', 'fit', 'side', 'thingBefore', 'thingAfter', 'choose')}`);
  canvas.addEventListener('webglcontextlost', () => {
    tell('The 3D view was interrupted by the browser. Tables and numbers go on.');
  });
  canvas.addEventListener('webglcontextrestored', () => {
    tell('');
    player.invalidate();
  });
  const scene = createScene({ canvas, labels: find('labels'), signal, turned: () => store.setView({ side: '' }) }, () => player.invalidate());
  if (!scene) tell('This browser shows no 3D graphics (WebGL 2). Tables and numbers work without them.');

  function show() {
    const { motion, doc } = store.result;
    if (!motion || !doc) return;
    const afresh = store.originOf(doc) !== origin;
    origin = store.originOf(doc);
    find('fallback').hidden = true;
    scene?.show({ ...store.result, doc: store.result.plain }, afresh, (shownMoving = store.view.moving !== ''));
    if (afresh && store.view.side) scene?.turnTo(store.view.side, false);
    if (!store.view.moving) setText(find('canvas-text'), describeScene(store));
  }
  store.select(({ result }) => result.motion, show);
  // Measured when the hand rests.
  store.select(({ view }) => view.moving, (moving) => !moving && shownMoving && show());
  store.select(({ view }) => view.side, (side) => side && scene?.turnTo(side));
  store.select(({ view }) => view.posture, () => player.invalidate());
  const describe = () => {
    if (!store.view.playing) setText(find('canvas-text'), describeScene(store));
    find('stage').setAttribute('aria-label', `${store.doc.name || 'Linkage'}, with its animation`);
  };
  atRest(store, ['result', 'view'], describe);

  show();
  player.draw = () => {
    const what = shown(store);
    if (!what || !scene) return;
    scene.draw(what);
    poster.hidden = true;
  };
  return { scene };
}
