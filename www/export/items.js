/**
 * What the Export menu offers, loaded when it is opened; what makes the files is loaded when it is first asked for.
 */
import { bestMotions, withoutGhost } from '../core/best-motions.js';
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
  /** @param {import('../core/types.js').ExportFormat} format @param {import('../core/types.js').ExportOptions} [options] */
  const motion = (format, options = {}) => attempt(() => import('./motion.js'), ({ exportMotion }) => exportMotion(app, format, options));

  const dialog = () => import('./picture-dialog.js');
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
  // Text is of the motion that is shown too.
  const best = store.result.motion && bestMotions.get(store.result.motion);
  const said = best ? best.words : withoutGhost(store.result.motion);
  const of = (/** @type {string} */ hint) => (said ? `${said}. ${hint}` : hint);
  const jumps = best?.switches ? 'The best motion switches while a frame stands: choose a calmer one, or show the followed one' : '';
  return [
    item('Picture (PNG) …', seen('The linkage whole, or the view; with its legend, on white or clear'), unseen || nothing, attempt(dialog, ({ openPicture }) => openPicture(app, 'png'))),
    item('Drawing (SVG) …', seen('The same as shapes, for print and to edit'), unseen || nothing, attempt(dialog, ({ openPicture }) => openPicture(app, 'svg'))),
    item('Film (WebM)', 'One pass at the speed that is set', unseen || film || why, attempt(() => import('./film.js'), ({ exportFilm }) => exportFilm(app))),
    item('Playing page (HTML)', of('One file that plays this motion, without a network'), why, attempt(() => import('./html.js'), ({ exportHtml }) => exportHtml(app))),
    'line',
    item('Table (CSV)', of(best?.switches ? 'Joints, poses, gaps at every point of its path; degrees; headings such as x[m]' : 'Joints, poses, gaps at every frame; degrees; headings such as x[m]'), why, motion('csv')),
    item('Table, units in a second row (CSV)', 'The same, with the units below the headings', why, motion('csv', { headings: 'two-rows' })),
    item('Table, plain headings (CSV)', 'The same without units, for programs', why, motion('csv', { headings: 'plain' })),
    item('Data (JSON)', of('The same with the document; frames count from 0'), why, motion('json')),
    item('MuJoCo model (MJCF)', of('Drives that follow the motion, sensors, loops closed by welds, a key frame a frame'), why || jumps, motion('mjcf')),
    item('MuJoCo model with gravity (MJCF)', 'The same, and −z is down', why || (jumps && 'Nor with gravity, for the same reason'), motion('mjcf', { gravity: true })),
  ];
}
