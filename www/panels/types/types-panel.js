/**
 * The types panel: the paper's Tables 2 and 3. A chain type is added or put in another's place by a click; the present
 * mechanism's own types are marked.
 *
 * @typedef {import('../../core/types.js').JointType} JointType
 */
import { ask } from '../../core/ask.js';
import { element, setText } from '../../ui/dom.js';
import { capital, chainName } from '../../core/chain-name.js';
import { addChain, setJoints } from '../../core/edits.js';
import { plural } from '../../core/format.js';
import { DEFAULTS } from '../../core/defaults.js';
import { JOINT_TYPES } from '../../core/joint-types.js';
import { sayUndo } from '../../core/undo.js';
import { assemblyName, grouped, linkageOfAssembly, typeSentence } from './type-words.js';
import { notLoaded } from '../../ui/lazy.js';
import { menuButton } from '../../ui/menu.js';
import { newLinkageForm } from './new-linkage.js';
import { wear } from '../../ui/style-sheets.js';
import look from '../../style/types.css?inline';

/** Constraints that a linkage may have, of six. */
const MOST = 5;

/** @param {import('../../element/workbench.js').App} app @param {HTMLElement} panel @returns {Promise<void>} */
export async function createTypes(app, panel) {
  const { store, planner } = app;
  wear(app.root, look);
  const listed = await ask(() => planner.enumeration(), 'list the types');
  if (listed.is !== 'answer') return notLoaded(panel, 'The types', listed.message, () => createTypes(app, panel));
  const tables = listed.value;

  /** @param {string} type such as RPS */
  const jointsOf = (type) => Array.from(type, (letter) => DEFAULTS.joints[/** @type {JointType} */ (letter)]);

  /** @param {string} what @param {(doc: import('../../core/types.js').MechanismDocument) => import('../../core/types.js').MechanismDocument} change */
  function make(what, change) {
    const { doc } = store;
    store.edit(change);
    sayUndo(app, doc, what);
  }

  /** Where the form for a new linkage stands while it is filled in. */
  const place = element('section', { class: 'new-linkage-place', 'aria-label': 'New linkage', hidden: true });

  /** As many legs of a type as leave a freedom. @param {string} type */
  function legsOf(type) {
    const constraints = tables.classes.find(({ chains }) => chains.includes(type))?.constraints ?? 1;
    return { type, legs: Math.floor(MOST / constraints) };
  }

  /** Asks for the sizes of a new linkage. @param {string} title @param {Pick<Parameters<typeof newLinkageForm>[1], 'chain' | 'type'>} what @param {HTMLElement} from has the focus afterwards */
  function fresh(title, what, from) {
    const close = () => {
      place.hidden = true;
      place.replaceChildren();
      from.focus();
    };
    const form = newLinkageForm(app, { ...what, done: close });
    form.querySelector('button')?.after(' ', element('button', { type: 'button', click: close }, 'Cancel'));
    form.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') close();
    });
    place.replaceChildren(element('h2', {}, title), form);
    place.hidden = false;
    form.querySelector('input')?.select();
    place.scrollIntoView({ block: 'nearest' });
  }

  /** @param {string} type */
  function chip(type) {
    const words = Array.from(type, (letter) => JOINT_TYPES[/** @type {JointType} */ (letter)].name).join(', ');
    const button = menuButton(type, () => [
      { label: `New linkage of ${type} legs…`, hint: 'Their number and sizes are asked for', act: () => fresh(`New linkage of ${type} legs`, { chain: legsOf(type) }, button) },
      'line',
      { label: 'Add as a new chain', act: () => make(`A chain ${type} is added.`, (doc) => addChain(doc, { ...DEFAULTS.chain, joints: jointsOf(type) })) },
      ...store.doc.chains.map((chain, index) => ({
        label: `Replace ${chainName(chain, index)}`,
        act: () => make(`${capital(chainName(chain, index))} is ${type} now.`, (doc) => setJoints(doc, index, jointsOf(type))),
      })),
    ]);
    button.classList.add('chip');
    button.dataset.type = type;
    button.title = words;
    button.disabled = store.readonly;
    return button;
  }

  const sentence = element('p', { class: 'type-sentence', role: 'status' });
  const nothing = element('p', { class: 'meaning', hidden: true }, 'There is no such chain. Types are joints from base to workpiece, with two to five freedoms: R and P have one, C and T two, S and E three.');
  const search = element('input', { type: 'search', class: 'cell text', placeholder: 'RPS', 'aria-label': 'Find a chain type', autocomplete: 'off', spellcheck: 'false' });

  const categories = [...new Set(tables.classes.map(({ category }) => category))].map((category) => {
    const classes = tables.classes.filter((candidate) => candidate.category === category);
    const count = classes.reduce((sum, { chains }) => sum + chains.length, 0);
    return element(
      'details',
      { 'data-category': category, open: true },
      element('summary', {}, element('h3', {}, `Category ${category}`), element('small', {}, `${plural(count, 'chain')}, U = ${classes[0].constraints}`)),
      ...classes.map(({ name, chains }) =>
        element('div', { class: 'type-class' }, element('span', { class: 'muted' }, name), element('div', { class: 'chips' }, ...chains.map(chip))),
      ),
    );
  });

  /** What can be made of an assembly of Table 3. @param {string} name */
  function assemblyMenu(name) {
    const button = menuButton(name, () => {
      const linkage = linkageOfAssembly(name, tables.classes, store.result.motion?.report.chains.map(({ type }) => type) ?? []);
      const own = categories.filter(({ dataset }) => new RegExp(`\\d${dataset.category}\\b`).test(name));
      return [
        { label: `New linkage ${linkage}…`, hint: 'Its sizes are asked for', disabled: store.readonly ? 'This linkage is read only' : '', act: () => fresh(`New linkage of type ${name}`, { type: linkage }, button) },
        'line',
        ...own.map((part) => ({ label: `Show the chains of category ${part.dataset.category}`, act: () => showCategory(part) })),
      ];
    });
    return button;
  }
  const showCategory = (/** @type {HTMLDetailsElement} */ part) => {
    part.open = true;
    part.querySelector('summary')?.focus();
  };
  /** The whole row is as good as its button. @param {PointerEvent} event */
  function openRow({ target, currentTarget }) {
    if (!(/** @type {Element} */ (target).closest('button, .menu'))) /** @type {Element} */ (currentTarget).querySelector('button')?.click();
  }

  const assemblies = element(
    'table',
    { class: 'plain assemblies' },
    element('caption', { class: 'sr' }, 'Table 3: assemblies by the constraints that they impose'),
    element('thead', {}, element('tr', {}, ...['constraints', 'assembly', 'how many'].map((head) => element('th', { scope: 'col' }, head)))),
    ...tables.assemblies.map(({ constraints, total, categories: parts }) =>
      element(
        'tbody',
        { 'data-constraints': constraints },
        ...parts.map(({ name, count }, index) =>
          element(
            'tr',
            { 'data-assembly': name, click: openRow },
            index === 0 ? element('th', { scope: 'rowgroup', rowspan: parts.length + 1 }, String(constraints)) : '',
            element('td', {}, assemblyMenu(name)),
            element('td', {}, grouped(count)),
          ),
        ),
        element('tr', { class: 'total' }, element('td', {}, 'total'), element('td', {}, grouped(total))),
      ),
    ),
  );

  panel.replaceChildren(
    element('h2', {}, 'Types'),
    sentence,
    place,
    element('label', { class: 'field' }, element('span', {}, 'Find'), search),
    nothing,
    element('div', { class: 'title' }, element('h2', {}, 'Chains'), element('span', {}, 'Table 2: choose one to add it')),
    ...categories,
    element('div', { class: 'title' }, element('h2', {}, 'Assemblies'), element('span', {}, 'Table 3: choose a row for a linkage of it')),
    assemblies,
  );

  const chips = /** @type {HTMLElement[]} */ ([...panel.querySelectorAll('.chip')]);
  search.addEventListener('input', () => {
    const wanted = search.value.trim().toUpperCase();
    for (const button of chips) button.hidden = !button.dataset.type?.includes(wanted);
    for (const row of /** @type {NodeListOf<HTMLElement>} */ (panel.querySelectorAll('.type-class'))) row.hidden = !row.querySelector('.chip:not([hidden])');
    for (const part of categories) part.hidden = !part.querySelector('.chip:not([hidden])');
    nothing.hidden = chips.some((button) => !button.hidden);
  });

  function show() {
    const chains = store.result.motion?.report.chains;
    if (!chains) return;
    setText(sentence, typeSentence(chains, tables));
    const types = new Set(chains.map(({ type }) => type));
    for (const button of chips) {
      const used = types.has(button.dataset.type ?? '');
      button.classList.toggle('used', used);
      if (used) button.setAttribute('aria-description', 'in this linkage');
      else button.removeAttribute('aria-description');
    }
    const name = assemblyName(chains);
    for (const row of /** @type {NodeListOf<HTMLElement>} */ (assemblies.querySelectorAll('[data-assembly]'))) {
      const own = row.dataset.assembly === name;
      row.classList.toggle('used', own);
      if (own) row.setAttribute('aria-current', 'true');
      else row.removeAttribute('aria-current');
    }
  }
  store.subscribe('result', show);
  show();
}
