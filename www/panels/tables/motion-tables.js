/**
 * The motion, by key frames or by driven joints, and the planner's settings as tables.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').Defaults} Defaults
 */
import { keyFramesOf } from '../../core/key-frames.js';
import * as edits from '../../core/edits.js';
import { addKeyFrame, duplicateKeyFrame, removeKeyFrame, setTime } from '../../core/key-frame-edits.js';
import { lengthUnit, plural } from '../../core/format.js';
import { keyFrameIn, PAGE, pageWith } from '../../core/row-window.js';
import { hasDrivers } from '../../core/driven.js';
import { parametersOf } from '../../core/parameter-names.js';
import { element } from '../../ui/dom.js';
import { whenSeen } from '../../ui/lazy.js';
import { html, live, nothing, renderRows, repeat } from '../../ui/render.js';
import { shownFrame } from '../../core/shown-frame.js';
import { coordinateCells, coordinateHeads, hasOtherTurn } from './frame-table.js';
import { plannerSettings } from './planner-settings.js';
import { createKeptRows } from './kept-rows.js';
import { createRowKeys } from './row-keys.js';
import { pointCells, setting } from './settings.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/motion.css?inline';

/**
 * @param {HTMLElement} panel
 * @param {Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {Defaults} defaults
 * @param {ReturnType<typeof import('./reorder.js').createArrange>} arrange
 * @param {{goTo: (key: number) => void, openModes: (key: number) => void, compareMetrics: Parameters<typeof import('./metric-comparison.js').createMetricComparison>[1]}} outside `goTo` takes
 *   the playhead to a key frame; `openModes` shows the ways to assemble there; `compareMetrics` asks the planner
 * @param {import('./forms.js').Forms} forms
 * @param {ReturnType<typeof import('./typed-parts.js').createTypedParts>} typed
 */
export function createMotionTables(panel, store, cells, defaults, arrange, { goTo, openModes, compareMetrics }, forms, typed) {
  wear(/** @type {ShadowRoot} */ (panel.getRootNode()), look);
  const unit = () => store.doc.length_unit;
  // Times stay where they are when poses change places.
  const rowKeys = createRowKeys((/** @type {import('../../core/types.js').KeyFrame} */ { time: _, ...pose }) => pose);

  const keptRows = createKeptRows(cells);

  /** The first key frame that is shown. */
  let first = 0;

  function keyTable() {
    const keys = keyFramesOf(store.doc);
    first = pageWith(keys.length, first);
    const page = keys.slice(first, first + PAGE);
    const places = rowKeys(page);
    const isShort = keys.length <= 2;
    // In them are the words of parameters, and rotations in other forms, which may come later.
    const all = [unit(), store.doc.angles, isShort, store.readonly, Object.keys(parametersOf(store.doc)).length > 0];
    const rows = keptRows(page.map((key, row) => ({
      key: places[row],
      of: [key, first + row, hasOtherTurn(key) && typed.get(), ...all],
      make: () => keyRow(first + row, isShort),
    })));
    return html`<div class="scroller" data-path="motion.key_frames"><table class="frames keys">
      <caption class="sr">Key frames</caption>
      <thead><tr>${coordinateHeads(store.doc)}</tr></thead>
      ${repeat(rows, ({ key }) => key, ({ body }) => body)}
    </table></div>${keys.length > PAGE ? pager(keys.length) : nothing}`;
  }

  /** @param {number} index @param {boolean} isShort whether none can be removed */
  function keyRow(index, isShort) {
    const path = `motion.key_frames[${index}]`;
    const label = `key frame ${index + 1}`;
    const name = cells.input({ path: `${path}.name`, column: 'name', label: `name of ${label}`, text: true });
    const time = cells.input({
      path: `${path}.time`,
      column: 'time',
      label: `${label}, time in seconds`,
      optional: true,
      write: (doc, value) => setTime(doc, index, value),
    });
    const menu = arrange.menu(path, label, () => [
      { label: 'Duplicate', act: () => store.edit((doc) => duplicateKeyFrame(doc, index)) },
      { label: 'Insert the shown pose after it', act: () => addShown('pose', index + 1) },
      { label: 'Take the shown pose', act: () => takeShown(index) },
      { label: 'Ways to assemble…', act: () => openModes(index) },
      { label: 'Turn as quaternion, matrix…', act: () => forms.turn(path, label) },
      { label: 'Remove', disabled: isShort ? 'A motion has at least two key frames' : '', act: () => store.edit((doc) => removeKeyFrame(doc, index)) },
    ]);
    return html`<tbody data-path=${path} class="key">
        <tr>
          <th scope="rowgroup" colspan="2">${name}</th>
          <td colspan="2" class="time"><span>time<small>s</small>${time}</span></td>
          <td colspan="2" class="act"><button class="quiet" aria-label="Go to ${label}" title="Go to its moment in the motion" @click=${() => goTo(index)}>go to</button>${menu}</td>
        </tr>
        <tr>${coordinateCells(cells, path, label, store.doc, typed)}</tr>
      </tbody>`;
  }

  /** The way to the other pages of key frames. @param {number} count */
  function pager(count) {
    const last = Math.min(count, first + PAGE);
    const turn = (/** @type {string} */ label, /** @type {string} */ name, /** @type {number} */ to) =>
      html`<button class="quiet" aria-label=${name} title=${name} ?disabled=${pageWith(count, to) === first} @click=${() => turnTo(to)}>${label}</button>`;
    const go = (/** @type {Event} */ { target }) => {
      const field = /** @type {HTMLInputElement} */ (target);
      const wanted = Number(field.value);
      if (Number.isInteger(wanted) && wanted >= 1 && wanted <= count) turnTo(wanted - 1);
      field.value = '';
    };
    return html`<div class="pager" role="group" aria-label="Pages of key frames">
      ${turn('«', 'First page', 0)}${turn('‹', 'Page before', first - PAGE)}
      <span>${first + 1} to ${last} of ${count}</span>
      ${turn('›', 'Next page', first + PAGE)}${turn('»', 'Last page', count - 1)}
      <label>to <input class="cell" inputmode="numeric" autocomplete="off" placeholder="number" aria-label=${`Show key frame, 1 to ${count}`} @change=${go} /></label>
    </div>`;
  }

  /** @param {number} key that is on the page then */
  function turnTo(key) {
    const next = pageWith(keyFramesOf(store.doc).length, key);
    if (next === first) return;
    first = next;
    draw();
  }

  /** Shows the page with a place of the document. @param {string} path */
  function reveal(path) {
    const key = keyFrameIn(path);
    if (key >= 0) turnTo(key);
  }
  store.select(({ view }) => view.selected, reveal);

  function goalSettings() {
    const lengths = lengthUnit(unit());
    return html`<div class="settings">
      ${setting({
        label: 'Interpolation',
        control: cells.select({
          path: 'motion.interpolation',
          label: 'interpolation',
          options: [
            ['bezier', 'double-quaternion Bézier'],
            ['sclerp', 'screw motion (ScLERP)'],
            ['straight', 'straight line and slerp'],
          ],
        }),
      })}
      ${setting({ label: 'Frames', control: cells.input({ path: 'motion.frames', label: 'number of frames' }) })}
      ${setting({
        label: 'Reference point',
        title: 'The point, x y z in the fixed frame, about which the double quaternions interpolate',
        note: `${lengths}; empty: the mean of the key frames`,
        group: true,
        control: pointCells(cells, { path: 'motion.reference', label: `point about which double quaternions interpolate, in ${lengths}`, fallback: () => meanPosition(store.result.plain ?? store.doc) }),
      })}
      ${setting({
        label: 'Radius R',
        title: 'Of the double quaternions: large against the workspace',
        note: `${lengths}; empty: chosen from the key frames`,
        control: cells.input({ path: 'motion.radius', label: `radius of the double quaternions in ${lengths}`, optional: true }),
      })}
    </div>`;
  }

  /** The tables of driven joints, once they are asked for. @type {(() => unknown) | null} */
  let driverTable = null;
  let asking = false;

  function driverTables() {
    if (driverTable) return driverTable();
    if (!asking) {
      asking = true;
      forms.driverTable(cells, (made) => {
        driverTable = made;
        if (hasDrivers(store.doc)) draw();
      }).finally(() => (asking = false));
    }
    return html`<p class="muted">Loading …</p>`;
  }

  /** By what the motion is given. */
  function kindChoice() {
    const driven = hasDrivers(store.doc);
    const choice = (/** @type {string} */ text, /** @type {boolean} */ on) =>
      html`<label><input type="radio" name="motion-kind" .checked=${live(on === driven)} ?disabled=${store.readonly} @change=${() => forms.drive(on)} />${text}</label>`;
    return html`<div class="motion-kind" role="radiogroup" aria-label="The motion is given by">${choice('Key frames', false)}${choice('Driven joints', true)}</div>`;
  }

  const comparison = element('div', { class: 'comparison-place' });
  whenSeen(comparison, 'The comparison of the metrics', async () =>
    comparison.replaceChildren((await import('./metric-comparison.js')).createMetricComparison(store, compareMetrics)),
  );

  function draw() {
    renderRows(
      html`${kindChoice()}${hasDrivers(store.doc) ? driverTables() : keyFrameTables()}
        <div class="title"><h2>Planner</h2></div>
        ${plannerSettings(store, cells, defaults)}${comparison}`,
      panel,
    );
  }

  /** The key frames, and how the goal goes from one to the next. */
  const keyFrameTables = () =>
      html`<div class="title"><h2>Key frames</h2><span>${plural(keyFramesOf(store.doc).length, 'pose')}</span></div>
        ${keyTable()}
        <div class="adders">
          <button class="wide" title="A key frame where the workpiece is now" @click=${() => addShown('pose')}>+ at the shown pose</button>
          <button class="wide" title="A key frame where the goal is now" @click=${() => addShown('goal')}>+ at the shown goal</button>
          <button class="wide" title="Key frames from a CSV file, or from cells of a spreadsheet" @click=${() => forms.poseTable()}>From a table…</button>
          <button class="wide" title="A copy of the last key frame, to be changed" @click=${() => store.edit((doc) => addKeyFrame(doc, lastKey()))}>+ like the last</button>
        </div>
        <div class="title"><h2>Goal motion</h2></div>
        ${goalSettings()}`;

  return { draw, reveal };

  /** @param {'pose' | 'goal'} which @param {number} [at] */
  function addShown(which, at) {
    const fresh = shownFrame(store, which);
    if (fresh) store.edit((doc) => addKeyFrame(doc, fresh, at));
  }

  /** @param {number} key */
  function takeShown(key) {
    const { time, name } = keyFramesOf(store.doc)[key];
    const frame = shownFrame(store, 'pose');
    if (frame) store.edit((doc) => edits.setValue(doc, `motion.key_frames[${key}]`, { name, ...frame, ...(time === undefined ? {} : { time }) }));
  }

  /** A new key frame begins where the last one is, so that it can be seen and moved from there. */
  function lastKey() {
    const { time: _, ...last } = keyFramesOf(store.doc).at(-1) ?? defaults.key_frame;
    return last;
  }
}

/** Means of the positions of lists of key frames: each of the three cells asks for it at every rendering. @type {WeakMap<object, number[]>} */
const means = new WeakMap();

/** The mean of the key frames' positions; what is no number counts as 0, and is at fault. @param {import('../../core/types.js').MechanismDocument} doc */
function meanPosition(doc) {
  const keys = keyFramesOf(doc);
  const mean = means.get(keys) ?? /** @type {const} */ (['x', 'y', 'z']).map((axis) => keys.reduce((sum, key) => sum + (Number(key[axis]) || 0), 0) / keys.length);
  means.set(keys, mean);
  return mean;
}
