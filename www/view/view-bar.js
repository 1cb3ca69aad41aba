/**
 * The bar over the 3D view: standard views, projection, what is shown, and fitting; and the keys that do the same.
 *
 * @typedef {import('../scene/standard-views.js').StandardView} StandardView
 */
import { byId, element, setText } from '../dom.js';
import { menuButton } from './menu.js';

/** Each view's key is its number in this list. @type {[StandardView, string][]} */
const VIEWS = [
  ['front', 'Front'],
  ['back', 'Back'],
  ['left', 'Left'],
  ['right', 'Right'],
  ['top', 'Top'],
  ['bottom', 'Bottom'],
  ['isometric', 'Isometric'],
];

/** @param {Pick<import('../main.js').App, 'store' | 'scene' | 'say'>} app */
export function createViewBar({ store, scene, say }) {
  if (!scene) return;
  const { canvas } = scene;
  const live = byId('view-live');

  /** @param {StandardView} view @param {string} name */
  const turnTo = (view, name) => {
    scene.turnTo(view);
    live.textContent = `${name} view.`;
  };
  const toggle = () => store.setView({ projection: store.view.projection === 'perspective' ? 'orthographic' : 'perspective' });
  const fitChosen = () => {
    const place = store.view.selected || store.view.hovered;
    if (!place || !scene.fitTo(place)) say('Select something in the view, the tree or a table first: then this brings it into the middle.');
  };

  const views = menuButton('Views', () => [
    ...VIEWS.map(([view, name], index) => ({ label: name, key: String(index + 1), act: () => turnTo(view, name) })),
    'line',
    { label: 'Fit selection', key: 'F', act: fitChosen },
  ]);
  const projection = element('button', { click: toggle, 'aria-keyshortcuts': 'P' });
  const fit = element('button', { id: 'fit', title: 'Show the whole linkage (Home)', 'aria-keyshortcuts': 'Home', click: () => scene.fit() }, 'Fit view');
  const bar = byId('view-bar');
  bar.append(views, projection, fit);

  const show = () => {
    const flat = store.view.projection === 'orthographic';
    scene.setParallel(flat);
    setText(projection, flat ? 'Orthographic' : 'Perspective');
    projection.title = flat ? 'Parallel lines stay parallel: change to perspective (P)' : 'Far things are smaller: change to orthographic (P)';
  };
  store.subscribe('view', show);
  show();

  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || event.defaultPrevented) return;
    const view = VIEWS[Number(event.key) - 1];
    if (view) turnTo(...view);
    else if (event.key === 'p') toggle();
    else if (event.key === 'f') fitChosen();
    else if (event.key === 'Home') scene.fit();
    else return;
    event.preventDefault();
  });
  return { bar };
}
