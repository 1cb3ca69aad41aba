/**
 * The bar over the 3D view: standard views, projection, what is shown, and fitting; and the keys that do the same.
 *
 * @typedef {import('../core/standard-views.js').StandardView} StandardView
 */
import { drivesJoints } from '../core/driven.js';
import { element, setText } from '../ui/dom.js';
import { ghostFrames, ghostStep } from './scene/ghosts.js';
import { KEYS, keyTip, onKeys, spokenKey, withKey } from '../ui/keys.js';
import { menuButton } from '../ui/menu.js';
import { createViewCube } from './view-cube.js';

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

/** What can be left out. @type {[keyof import('../core/types.js').Shown, string][]} */
const PARTS = [
  ['goal', 'Goal motion'],
  ['closest', 'Closest motion'],
  ['gaps', 'Gap lines'],
  ['holds', 'What holds it back'],
  ['freedoms', 'Freedoms'],
  ['names', 'Names'],
  ['axes', 'Axes'],
  ['ground', 'Ground'],
];

/** @param {import('../element/workbench.js').App} app */
export function createViewBar(app) {
  const { find, store, scene, say } = app;
  if (!scene) return;
  const { canvas } = scene;
  const live = find('view-live');

  /** @param {StandardView} view @param {string} name */
  const turnTo = (view, name) => {
    store.setView({ side: '' });
    store.setView({ side: view });
    live.textContent = `${name} view.`;
  };
  const toggle = () => store.setView({ projection: store.view.projection === 'perspective' ? 'orthographic' : 'perspective' });
  const fitChosen = () => {
    const place = store.view.selected || store.view.hovered;
    if (!place || !scene.fitTo(place)) say('Select something in the view, the tree or a table first: then this brings it into the middle.');
  };

  const views = menuButton('Views', () => [
    ...VIEWS.map(([view, name], index) => ({ label: name, key: KEYS.side.keys[index], act: () => turnTo(view, name) })),
    'line',
    { label: 'Perspective', key: KEYS.projection.keys[0], checked: store.view.projection === 'perspective', act: toggle },
    { label: 'Fit view', key: KEYS.fit.keys[0], act: scene.fit },
    { label: 'Fit selection', key: KEYS.fitChosen.keys[0], act: fitChosen },
  ]);
  const parts = menuButton('Show', () => {
    const { show, ghosts, frame } = store.view;
    const { motion, plain: doc } = store.result;
    const frames = motion && doc ? ghostFrames(ghosts, motion, doc) : [];
    const driven = drivesJoints(motion);
    const here = frames.includes(frame);
    const others = here ? frames.filter((other) => other !== frame) : [...frames, frame].sort((a, b) => a - b);
    const choose = (/** @type {import('../core/types.js').View['ghosts']} */ next) => () => store.setView({ ghosts: next });
    return [
      ...PARTS.filter(([part]) => !(driven && ['goal', 'gaps', 'holds'].includes(part))).map(([part, label]) => ({ label: driven && part === 'closest' ? 'Path of the workpiece' : label, checked: show[part], act: () => store.setView({ show: { ...show, [part]: !show[part] } }) })),
      'line',
      { label: 'No ghosts', checked: frames.length === 0, act: choose('none') },
      ...(driven ? [] : [{ label: 'Ghosts at key frames', checked: ghosts === 'keys', act: choose('keys') }]),
      { label: `Ghosts every ${ghostStep(motion?.frames ?? 1)} frames`, checked: ghosts === 'spread', act: choose('spread') },
      { label: 'Ghost at this frame', checked: here, act: choose(others.length ? others : 'none') },
    ];
  });
  const projection = element('button', { id: 'projection', click: toggle, 'aria-keyshortcuts': spokenKey(KEYS.projection.keys[0]) });
  const fit = element('button', { id: 'fit', click: scene.fit }, 'Fit view');
  keyTip(fit, 'Show the whole linkage', 'fit');
  const bar = find('view-bar');
  bar.append(views, parts, projection, fit);

  const show = () => scene.choose(store.view);
  const project = () => {
    const flat = store.view.projection === 'orthographic';
    scene.setParallel(flat);
    setText(projection, flat ? 'Orthographic' : 'Perspective');
    projection.title = withKey(flat ? 'Parallel lines stay parallel: change to perspective' : 'Far things are smaller: change to orthographic', 'projection');
  };
  store.subscribe('view', show);
  store.select(({ view }) => view.projection, project);
  show();
  project();

  createViewCube(app, scene, turnTo);
  onKeys(canvas, {
    side: (_, at) => turnTo(...VIEWS[at]),
    projection: toggle,
    fitChosen,
    fit: scene.fit,
  });
  return { bar };
}
