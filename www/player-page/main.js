/**
 * A page that plays one solved motion by itself: no planner, no network, one file (see export/html.js).
 */
import '../style/whole-page.css';
import '../style/colours.css';
import '../style/view.css';
import './player-page.css';
import { byId, element, setText } from '../ui/dom.js';
import { inWords, keyTip, onKeys } from '../ui/keys.js';
import { drivesJoints, told } from '../core/driven.js';
import * as words from '../core/driven-words.js';
import { angle, length } from '../core/format.js';
import { Player } from '../core/player.js';
import { createScene } from '../view3d/scene/scene.js';
import { shown } from '../core/shown.js';
import { createStore } from '../core/store.js';
import { countStatuses, describeScene, statusName, statusWords } from '../core/status-words.js';
import { unpack } from './pack.js';

const { motion, doc: mechanism, plain } = await unpack(byId('motion').textContent ?? '');
const store = createStore(mechanism);
// In one file nothing is loaded later.
told.words = words;

const canvas = element('canvas', {
  id: 'canvas',
  tabindex: 0,
  role: 'application',
  'aria-label': `3D view of the linkage. ${inWords('turnView', 'shiftView', 'zoomIn', 'zoomOut', 'fit')}`,
  'aria-describedby': 'canvas-text',
});
const labels = element('div', { id: 'labels', 'aria-hidden': 'true' });
const description = element('p', { id: 'canvas-text', class: 'sr' });
const note = element('p', { class: 'banner', hidden: true }, 'This browser shows no 3D graphics (WebGL 2).');
const fit = element('button', { id: 'fit' }, 'Fit view');
keyTip(fit, 'Show the whole linkage', 'fit');
const play = element('button', { id: 'play' }, 'Play');
const scrub = element('input', { id: 'scrub', type: 'range', min: 0, max: motion.frames - 1, step: 1, value: 0, 'aria-label': 'Frame' });
const number = element('output', { id: 'frame-number' });
const status = element('p', { id: 'status' });
const driven = drivesJoints(motion);
const lines = driven ? [['closest', 'path of the workpiece']] : [['goal', 'goal motion'], ['closest', 'closest motion'], ['gap', 'gap']];
const legend = lines.map(([name, words]) => element('li', { class: name }, words));

document.body.append(
  element('header', {}, element('h1', {}, mechanism.name || 'Linkage'), element('p', {}, mechanism.about ?? '')),
  element(
    'main',
    {},
    element('div', { class: 'view' }, canvas, labels, description, element('ul', { class: 'legend', 'aria-label': 'Legend' }, ...legend), fit, note),
    element('div', { class: 'controls', role: 'group', 'aria-label': 'Animation' }, play, scrub, number),
    status,
    element('p', { class: 'summary' }, `Of ${motion.frames} frames: ${countStatuses(motion)}. Made with Synthetica.`),
  ),
);

const player = new Player(store);
player.draw = () => {
  const what = shown(store);
  if (what) scene?.draw(what);
};
const scene = createScene({ canvas, labels }, () => player.invalidate());
note.hidden = scene !== null;

function tell() {
  const { frame, playing } = store.view;
  scrub.value = String(frame);
  setText(play, playing ? 'Pause' : 'Play');
  setText(number, `${frame + 1} / ${motion.frames}`);
  const { sign, word, meaning } = statusWords(statusName(motion, frame));
  const more = driven ? words.drivenWords(motion, mechanism, frame) : `${length(motion.translation_gap[frame], mechanism.length_unit)} and ${angle(motion.rotation_gap[frame])} from the goal`;
  setText(status, `${sign} ${word}: ${more}. ${(driven && words.statusMeaning(statusName(motion, frame))) || meaning}`);
  if (playing) return;
  scrub.setAttribute('aria-valuetext', `Frame ${frame + 1}: ${word}`);
  setText(description, describeScene(store));
}

const toggle = () => (player.paused ? player.play() : player.pause());
play.addEventListener('click', toggle);
fit.addEventListener('click', () => scene?.fit());
scrub.addEventListener('input', () => {
  player.pause();
  player.frame = Number(scrub.value);
});
onKeys(document, { play: ({ target }) => !(/** @type {Element | null} */ (target)?.closest('button')) && toggle() });

store.subscribe('view', tell);
store.setResult({ motion, doc: mechanism, plain });
scene?.show(store.result, true);
tell();
if (!matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
