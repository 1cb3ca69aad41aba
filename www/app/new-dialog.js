/**
 * The dialog for a new linkage: a mechanism by its name and its paper's numbers, a type and sizes, or next to nothing.
 */
import '../style/new-dialog.css';
import { ask } from '../core/ask.js';
import { element } from '../ui/dom.js';
import { openDialog } from '../ui/dialog.js';
import { notLoaded } from '../ui/lazy.js';
import { createTabs } from '../ui/tabs.js';
import { makerForm } from '../panels/types/maker-form.js';
import { makerList } from '../panels/types/maker-list.js';
import { newLinkageForm } from '../panels/types/new-linkage.js';

/** Two hinges at right angles, as their points and axes; the workpiece at the end. */
const BY_AXES = {
  version: 1,
  name: 'Linkage by its axes',
  length_unit: 'mm',
  home: { x: 200 },
  chains: [
    {
      name: 'chain 1',
      joints: [
        { type: 'R', point: [0, 0, 0], axis: [0, 0, 1] },
        { type: 'R', point: [100, 0, 0], axis: [0, 1, 0] },
      ],
    },
  ],
  motion: { key_frames: [{ name: 'home', x: 200 }, { name: 'raised', x: 150, y: 50, z: 50 }] },
};

/** @param {import('../element/workbench.js').App} app */
export function openNew(app) {
  const done = () => dialog.close();
  const makers = element('div', { class: 'makers' });
  const type = element('div', {});
  const empty = emptyPanel(app, done);
  const parts = /** @type {const} */ ([['maker', 'A mechanism by name', makers], ['type', 'A type and sizes', type], ['empty', 'Empty', empty]]);

  const list = element(
    'div',
    { class: 'new-tabs', role: 'tablist', 'aria-label': 'What it is made from' },
    ...parts.map(([name, label], index) => element('button', { type: 'button', role: 'tab', id: `new-tab-${name}`, 'aria-controls': `new-${name}`, 'aria-selected': String(index === 0), tabindex: index ? -1 : 0 }, label)),
  );
  for (const [name, , panel] of parts) {
    panel.id = `new-${name}`;
    panel.classList.add('new-panel');
    panel.setAttribute('role', 'tabpanel');
    panel.setAttribute('aria-labelledby', `new-tab-${name}`);
  }
  type.append(newLinkageForm(app, { done }));
  const dialog = openDialog('New linkage', list, ...parts.map(([, , panel]) => panel));
  dialog.classList.add('new-dialog');
  createTabs(list).settle();
  list.querySelector('button')?.focus();
  fillMakers(app, makers, done);
}

/** @param {import('../element/workbench.js').App} app @param {HTMLElement} panel @param {() => void} done @returns {Promise<void>} */
async function fillMakers(app, panel, done) {
  panel.replaceChildren(element('p', { class: 'meaning', role: 'status' }, 'The mechanisms: loading …'));
  const listed = await ask(() => app.planner.makers(), 'list the mechanisms');
  if (listed.is !== 'answer') return notLoaded(panel, 'The mechanisms', listed.message, () => fillMakers(app, panel, done));
  const place = element('div', { class: 'maker-place' });
  const { root, search, show } = makerList(listed.value, {
    choose: (maker) => place.replaceChildren(...(maker ? [makerForm(app, maker, done)] : [])),
    go: () => place.querySelector('input')?.select(),
  });
  panel.replaceChildren(root, place);
  show();
  // Where no other part was chosen meanwhile.
  if (panel.classList.contains('shown')) search.focus();
}

/** @param {import('../element/workbench.js').App} app @param {() => void} done */
function emptyPanel({ planner, open }, done) {
  const said = element('p', { class: 'said', role: 'status' });
  /** @param {string} label @param {string} hint @param {() => Promise<string>} text */
  function choice(label, hint, text) {
    async function act() {
      const made = await ask(text, 'begin a linkage');
      said.textContent = made.is === 'trouble' ? `The linkage was not made. ${made.message}` : '';
      if (made.is === 'answer' && (await open(made.value))) done();
    }
    return element('p', {}, element('button', { type: 'button', click: act }, label), ' ', element('small', {}, hint));
  }
  return element(
    'div',
    { class: 'new-linkage' },
    choice('By its tables', 'One chain of rows of Denavit and Hartenberg, to go on from.', () => planner.small()),
    choice('By its axes', 'One chain of two hinges, given by points and directions in the fixed frame.', async () => JSON.stringify(BY_AXES)),
    said,
  );
}
