/**
 * The Export menu. What makes the files is loaded when it is first asked for.
 *
 * @typedef {import('../element/workbench.js').App} App
 */
import { byId } from '../ui/dom.js';
import { withPart } from '../ui/lazy.js';
import { menuButton } from '../ui/menu.js';
import { filmType } from './film-type.js';

/** @param {App} app */
export function createExport(app) {
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

  byId('menus').append(
    menuButton('Export', () => {
      const nothing = !store.result.motion;
      const unseen = nothing || !scene;
      // The planner writes these three from the whole motion.
      const part = store.result.motion?.partial;
      const whole = (/** @type {string} */ hint) => (part ? 'The motion is planned only in part: plan the rest first' : hint);
      return [
        { label: 'Picture (PNG) …', hint: 'The view, in any size', disabled: unseen, act: attempt(() => import('./png.js'), ({ exportPng }) => exportPng(app)) },
        { label: 'Drawing (SVG)', hint: 'The view as shapes, for print and to edit', disabled: unseen, act: attempt(() => import('./svg.js'), ({ exportSvg }) => exportSvg(app)) },
        {
          label: 'Film (WebM)',
          hint: filmType() ? 'One pass at the speed that is set' : 'This browser cannot record a canvas; Chromium and Firefox can',
          disabled: unseen || !filmType(),
          act: attempt(() => import('./film.js'), ({ exportFilm }) => exportFilm(app)),
        },
        { label: 'Playing page (HTML)', hint: 'One file that plays this motion, without a network', disabled: nothing, act: attempt(() => import('./html.js'), ({ exportHtml }) => exportHtml(app)) },
        'line',
        { label: 'Table (CSV)', hint: whole('Joints, poses, gaps at every frame; degrees'), disabled: nothing || part, act: motion('csv') },
        { label: 'Data (JSON)', hint: whole('The same with the document'), disabled: nothing || part, act: motion('json') },
        { label: 'MuJoCo model (MJCF)', hint: whole('Every joint, loops closed by welds, a key frame a frame'), disabled: nothing || part, act: motion('mjcf') },
      ];
    }),
  );
}
