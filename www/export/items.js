/**
 * What the Export menu offers, loaded when it is opened; what makes the files is loaded when it is first asked for.
 */
import { withPart } from '../ui/lazy.js';
import { notWhole } from './not-whole.js';
import { canFilm } from './film-type.js';

/** @param {import('../element/workbench.js').App} app @returns {import('../ui/menu.js').MenuItem[]} */
export function exportItems(app) {
  const { store, scene, say } = app;

  /**
   * @template T
   * @param {() => Promise<T>} load @param {(part: T) => unknown} make
   */
  const attempt = (load, make) => () =>
    withPart(app, 'What makes this file', load, async (part) => {
      try {
        await make(part);
      } catch (error) {
        console.warn(error);
        say(`The file could not be made (${/** @type {Error} */ (error).message}).`);
      }
    });
  /** @param {'csv' | 'json' | 'mjcf'} format */
  const motion = (format) => attempt(() => import('./motion.js'), ({ exportMotion }) => exportMotion(app, format));

  const why = notWhole(store);
  const unseen = scene ? '' : 'This browser shows no 3D graphics (WebGL 2)';
  const nothing = store.result.motion ? '' : why;
  const film = canFilm() ? '' : 'This browser can neither encode nor record films';
  /**
   * An item that is there to be chosen unless there is a reason against it, which then stands in its hint's place.
   * @param {string} label @param {string} hint @param {string} reason @param {() => void} act
   */
  const item = (label, hint, reason, act) => ({ label, hint, disabled: reason, act });
  // A picture is of what is seen, also where that is not of the document.
  const seen = (/** @type {string} */ hint) => (why ? `${hint}. ${why}` : hint);
  return [
    item('Picture (PNG) …', seen('The view, in any size'), unseen || nothing, attempt(() => import('./png.js'), ({ exportPng }) => exportPng(app))),
    item('Drawing (SVG)', seen('The view as shapes, for print and to edit'), unseen || nothing, attempt(() => import('./svg.js'), ({ exportSvg }) => exportSvg(app))),
    item('Film (WebM)', 'One pass at the speed that is set', unseen || film || why, attempt(() => import('./film.js'), ({ exportFilm }) => exportFilm(app))),
    item('Playing page (HTML)', 'One file that plays this motion, without a network', why, attempt(() => import('./html.js'), ({ exportHtml }) => exportHtml(app))),
    'line',
    item('Table (CSV)', 'Joints, poses, gaps at every frame; degrees', why, motion('csv')),
    item('Data (JSON)', 'The same with the document', why, motion('json')),
    item('MuJoCo model (MJCF)', 'Every joint, loops closed by welds, a key frame a frame', why, motion('mjcf')),
  ];
}
