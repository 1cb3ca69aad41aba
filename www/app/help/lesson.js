/**
 * A lesson beside the linkage: its text, its buttons that act on the page, numbers that follow the motion, and its print.
 *
 * @typedef {import('../../element/workbench.js').AppWithPanels} App
 * @typedef {{id: string, title: string, text: string, doc: string}} Lesson
 */
import { copyText } from '../../ui/copy.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/lesson.css?inline';
import { withPart } from '../../ui/lazy.js';
import { element, setText } from '../../ui/dom.js';
import { setValue } from '../../core/edits.js';
import { drivesJoints } from '../../core/driven.js';
import { angle, length } from '../../core/format.js';
import { parsePath, valueAt } from '../../core/path.js';
import { sampleOf, sampleText } from '../../core/samples.js';
import { convertLengths } from '../../core/units.js';
import { largestGaps, statusName, statusWords } from '../../core/status-words.js';
import { preparePrint } from './lesson-print.js';

/** What stands for a number while the motion of the shown document is not planned. */
const UNKNOWN = '…';

/** @param {App} app @param {Lesson} lesson */
export function showLesson(app, lesson) {
  const { store, player, tabs, say, find, unfold } = app;
  wear(app.root, look);
  const panel = find('lesson');
  const body = element('article', { class: 'lesson' });
  // Our own text, from a file beside this one.
  body.innerHTML = lesson.text;
  panel.replaceChildren(
    element('h2', {}, lesson.title),
    element(
      'p',
      { class: 'lesson-tools' },
      element('button', { click: () => print() }, 'Print'),
      element('button', { click: copyLink }, 'Copy link'),
      element('button', { click: close }, 'Close the lesson'),
    ),
    body,
  );
  find('tab-lesson').hidden = false;
  unfold(panel);
  tabs.choosePanel(panel);

  const address = new URL(`?lesson=${lesson.id}`, location.href);
  address.hash = '';

  async function copyLink() {
    const copied = await copyText(address.href);
    say(copied ? 'A link to this lesson is copied.' : address.href);
  }

  function close() {
    leave.forEach((end) => end());
    find('tab-lesson').hidden = true;
    panel.replaceChildren();
    tabs.choosePanel(find('mechanism'));
    find('tab-mechanism').focus();
  }

  /** What a button does, by its attributes. @type {Record<string, (data: DOMStringMap) => void | Promise<unknown>>} */
  const acts = {
    restart: () => app.open(lesson.doc),
    sample: ({ sample }) => void withPart(app, 'The example', async () => sampleText(await sampleOf(sample ?? '')), app.open),
    play: () => player.play(),
    worst: () => {
      player.pause();
      if (store.result.motion && !drivesJoints(store.result.motion)) player.frame = largestGaps(store.result.motion).shift.frame;
    },
    panel: ({ panel: id }) => {
      const target = find(id ?? '');
      if (!target.offsetParent) unfold(target);
      // The lesson gives way only where the other panel cannot stand beside it.
      if (!target.offsetParent) find(`tab-${id}`).click();
      target.scrollIntoView({ block: 'nearest' });
      target.classList.add('look-here');
      setTimeout(() => target.classList.remove('look-here'), 1500);
    },
    set: ({ set, to }) => change(set ?? '', (doc) => setValue(doc, set ?? '', JSON.parse(to ?? 'null'))),
    remove: ({ remove }) => {
      const [list, index] = parsePath(remove ?? '');
      change(String(list), (doc) => {
        const kept = /** @type {unknown[]} */ (valueAt(doc, String(list))).filter((_, i) => i !== index);
        return setValue(doc, String(list), kept);
      }, remove);
    },
    unit: ({ unit, times }) => {
      // The lesson is about a metric length that does not follow.
      const metric = store.doc.planner?.metric_length;
      if (store.doc.length_unit !== unit) store.edit((doc) => setValue(convertLengths(doc, Number(times), unit ?? ''), 'planner.metric_length', metric));
    },
  };

  /**
   * Edits the lesson's linkage; where another one is open it says so.
   * @param {string} parent
   * @param {(doc: import('../../core/types.js').MechanismDocument) => import('../../core/types.js').MechanismDocument} edit
   * @param {string} [needed] place that must exist
   */
  function change(parent, edit, needed = parent) {
    if (valueAt(store.doc, needed) === undefined) say('The lesson’s linkage is not open.', { label: 'Open it', act: () => app.open(lesson.doc) });
    else store.edit(edit);
  }

  body.addEventListener('click', (event) => {
    const button = /** @type {Element} */ (event.target).closest('button');
    if (!button) return;
    for (const [name, act] of Object.entries(acts)) if (name in button.dataset) act(button.dataset);
  });

  function show() {
    const { motion, doc, fault } = store.result;
    // Numbers of the motion before, beside a text about this one, would contradict it.
    // Its numbers are distances from a goal.
    const values = motion && doc && doc === store.doc && !drivesJoints(motion) ? valuesOf(motion, doc) : {};
    for (const output of body.querySelectorAll('output')) {
      const name = output.dataset.value ?? '';
      setText(output, name === 'warnings' && fault ? fault.message : (values[name] ?? (name === 'warnings' ? '' : UNKNOWN)));
    }
  }

  /**
   * What the lesson's outputs show.
   * @param {import('../../core/types.js').Motion} motion @param {import('../../core/types.js').MechanismDocument} doc
   * @returns {Record<string, string>}
   */
  function valuesOf(motion, doc) {
    const { frame } = store.view;
    const { shift, turn } = largestGaps(motion);
    return {
      name: doc.name ?? 'This linkage',
      count: String(motion.report.mobility_count).replace('-', '−'),
      rank: String(motion.report.mobility_rank),
      warnings: motion.report.warnings.find(({ code }) => code === 'start-open')?.message ?? '',
      frame: String(frame + 1),
      shift: length(motion.translation_gap[frame], doc.length_unit),
      turn: angle(motion.rotation_gap[frame]),
      status: statusWords(statusName(motion, frame)).word.toLowerCase(),
      worst: `${length(shift.value, doc.length_unit)} and ${angle(turn.value)}`,
    };
  }
  const leave = [store.subscribe('document', show), store.subscribe('result', show), store.subscribe('view', show), preparePrint(app, body, address.href)];
  show();
  return { close };
}
