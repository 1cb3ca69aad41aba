/**
 * The charts of the motion, in step with the playhead. Loaded when they are first seen.
 *
 * @typedef {import('./chart-card.js').Along} Along
 * @typedef {import('./chart-list.js').Chart} Chart
 * @typedef {{card: ReturnType<typeof import('./chart-card.js').createCard>, chart: Chart, seen: boolean, stale: boolean}} Entry
 */
import { atRest } from '../../core/at-rest.js';
import { element, setText } from '../../ui/dom.js';
import { short } from '../../core/format.js';
import { allTimes, isTimed } from '../../core/playhead.js';
import { wear } from '../../ui/style-sheets.js';
import { createCard } from './chart-card.js';
import { chartsOf, GROUPS, isOffered } from './chart-list.js';
import { plotLook } from './plot.js';

/** Least heights of a plot in pixels: where there is room for two rows, and where there is hardly any. */
const ROOMY = 110;
const LEAST = 88;
/** Height of the gap between rows and of the closed tables, in pixels. */
const BETWEEN = 32;

/** Panels of charts on this page, each with a cursor of its own. */
let made = 0;

/** @param {Pick<import('../../element/workbench.js').App, 'root' | 'store' | 'player' | 'signal'>} app @param {HTMLElement} panel */
export function createCharts({ root, store, player, signal }, panel) {
  wear(root, plotLook);
  /** @type {Map<string, Entry>} */
  const entries = new Map();
  /** Series that are hidden, as chart/name; kept while charts come and go. @type {Set<string>} */
  const hidden = new Set();
  /** @type {number | null} */
  let hovered = null;
  /** @type {Along} */
  let along = { x: [], extent: null, heads: [] };
  let request = 0;
  /** The charts that the plots' height is fitted to. */
  let fitted = '';

  const reading = element('p', { class: 'reading' });
  const scale = element('select', { change: refresh }, element('option', { value: 'frame' }, 'frame'), element('option', { value: 'time' }, 'time'));
  const grid = element('div', { class: 'charts' });
  const none = element('p', { class: 'none', hidden: true }, 'No chart is chosen.');
  const choices = element('div', { class: 'choices' }, chooser(store), element('label', {}, 'over ', scale), reading);
  panel.replaceChildren(choices, none, grid);

  const sight = new IntersectionObserver((changes) => {
    for (const { target, isIntersecting } of changes) {
      const entry = [...entries.values()].find(({ card }) => card.root === target);
      if (entry) entry.seen = isIntersecting;
    }
    draw();
  });

  const shared = {
    hidden,
    sync: `charts ${++made}`,
    signal,
    /** @param {number | null} frame */
    onHover(frame) {
      if (frame === hovered) return;
      hovered = frame;
      read();
    },
    /** @param {number} frame */
    onScrub(frame) {
      player.pause();
      player.frame = frame;
    },
  };

  /** The charts that are chosen, made where they are new or have other series. */
  function refresh() {
    const { motion, doc } = store.result;
    if (!motion) return;
    const timed = isTimed(doc);
    const time = timed ? 'time, s' : 't, 0 to 1';
    scale.options[1].text = time;
    const over = scale.value === 'time';
    const times = allTimes(motion);
    along = {
      x: over ? motion.time : Float64Array.from({ length: motion.frames }, (_, frame) => frame + 1),
      // As far as the strip of the animation bar goes: over all frames of the goal motion.
      extent: motion.partial ? (over ? [times[0], times[times.length - 1]] : [1, motion.goal_frames]) : null,
      heads: [[time, motion.time, timed ? 2 : 4]],
    };
    const wanted = chartsOf(motion, doc?.length_unit).filter(({ group }) => store.view.charts.includes(group));
    for (const [id, { card, chart }] of entries) {
      const still = wanted.find((one) => one.id === id);
      if (still && shape(still) === shape(chart)) continue;
      sight.unobserve(card.root);
      card.destroy();
      entries.delete(id);
    }
    wanted.forEach((chart, at) => {
      const entry = entries.get(chart.id);
      if (entry) {
        entry.chart = chart;
        entry.stale = true;
        return;
      }
      const card = createCard(chart, shared);
      entries.set(chart.id, { card, chart, seen: true, stale: true });
      grid.insertBefore(card.root, grid.children[at] ?? null);
      sight.observe(card.root);
    });
    none.hidden = wanted.length > 0;
    const now = wanted.map(shape).join();
    if (now !== fitted) fit();
    fitted = now;
    // While a number is dragged, motions come faster than pictures.
    request ||= requestAnimationFrame(() => {
      request = 0;
      draw();
    });
  }

  /** Only what can be seen. */
  function draw() {
    for (const entry of entries.values()) {
      if (!entry.stale || !entry.seen) continue;
      entry.stale = false;
      entry.card.update(entry.chart, along);
    }
    read();
  }

  function read() {
    const { motion } = store.result;
    if (!motion) return;
    const frame = Math.min(store.view.frame, motion.frames - 1);
    const at = hovered === null ? frame : Math.min(hovered, motion.frames - 1);
    for (const { card, seen, stale } of entries.values()) if (seen && !stale) card.showAt(frame, at);
    setText(reading, `${hovered === null ? 'at' : 'under the pointer:'} frame ${at + 1}, t = ${short(motion.time[at], 3)}`);
    grid.classList.toggle('away', store.view.posture !== null);
  }

  /** In the dock, rows of charts fill its height; elsewhere the page is as long as they are. */
  function fit() {
    if (!panel.closest('.dock')) return grid.style.removeProperty('--plot-height');
    const heads = Math.max(0, ...[...grid.querySelectorAll('header')].map((head) => head.offsetHeight));
    const room = panel.clientHeight - choices.offsetHeight - 2 * parseFloat(getComputedStyle(panel).paddingTop);
    const around = heads + BETWEEN;
    const rows = Math.max(1, Math.floor(room / (ROOMY + around)));
    grid.style.setProperty('--plot-height', `${Math.max(LEAST, Math.floor(room / rows) - around)}px`);
  }
  new ResizeObserver(fit).observe(panel);

  store.select(({ view }) => view.charts, refresh);
  atRest(store, ['view'], read);
  atRest(store, ['result'], refresh);
  refresh();
}

/** What a card is made for; other values go into the same card. @param {Chart} chart */
const shape = ({ title, unit, series }) => [title, unit, ...series.map(({ name }) => name)].join('\n');

/** Which charts are shown: boxes in a popover. @param {import('../../core/store.js').Store} store */
function chooser(store) {
  const rows = Object.entries(GROUPS).map(([group, title]) => {
    const box = element('input', { type: 'checkbox', checked: store.view.charts.includes(group) });
    box.addEventListener('change', () => {
      const others = store.view.charts.filter((one) => one !== group);
      store.setView({ charts: box.checked ? [...others, group] : others });
    });
    return { group, label: element('label', {}, box, title) };
  });
  const boxes = rows.map(({ label }) => label);
  const offer = () => rows.forEach(({ group, label }) => (label.hidden = !isOffered(group, store.result.motion)));
  atRest(store, ['result'], offer);
  offer();
  const list = element('div', { class: 'menu choose', popover: 'auto', id: 'chart-choice', role: 'group', 'aria-label': 'Charts shown' }, ...boxes);
  const button = element('button', { popovertarget: list.id, 'aria-expanded': 'false' }, 'Choose charts');
  list.addEventListener('toggle', (event) => {
    const open = /** @type {ToggleEvent} */ (event).newState === 'open';
    button.setAttribute('aria-expanded', String(open));
    if (!open) return;
    const at = button.getBoundingClientRect();
    list.style.left = `${Math.max(4, Math.min(at.left, innerWidth - list.offsetWidth - 4))}px`;
    list.style.top = `${Math.max(4, Math.min(at.bottom + 4, innerHeight - list.offsetHeight - 4))}px`;
    boxes.find((box) => !box.hidden)?.querySelector('input')?.focus();
  });
  return element('div', {}, button, list);
}
