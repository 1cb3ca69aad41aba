/**
 * The list of makers in their groups, with a search by name: a combobox whose list is always open. Arrow keys go through the
 * list, Enter goes on with the one that is chosen.
 *
 * @typedef {import('../../core/types.js').Maker} Maker
 */
import { inGroups } from '../../core/mechanism-groups.js';
import { element } from '../../ui/dom.js';
import { found } from './maker-words.js';

/**
 * @param {Maker[]} makers
 * @param {{choose: (maker: Maker | null) => void, go: () => void}} then `choose` is told what is chosen, also while arrow keys go through, null where nothing is found;
 *   `go`: it is to be filled in
 */
export function makerList(makers, { choose, go }) {
  const optionOf = new Map(
    makers.map((maker) => {
      const pick = () => {
        select(maker);
        go();
      };
      const option = element('div', { role: 'option', id: `maker-option-${maker.name}`, 'aria-selected': 'false', 'data-maker': maker.name, click: pick }, maker.title, ' ', element('small', {}, maker.name));
      return [maker, option];
    }),
  );
  const list = element('div', { role: 'listbox', id: 'maker-options', class: 'maker-options', 'aria-label': 'Mechanisms' });
  const nothing = element('p', { class: 'meaning', role: 'status', hidden: true });
  const search = element('input', {
    type: 'search',
    class: 'cell text',
    role: 'combobox',
    'aria-label': 'Find a mechanism',
    'aria-controls': list.id,
    'aria-expanded': 'true',
    'aria-autocomplete': 'list',
    placeholder: 'Name, such as delta',
    autocomplete: 'off',
    spellcheck: 'false',
    input: show,
    keydown: press,
  });
  /** In the order in which they stand. @type {Maker[]} */
  let shown = [];
  /** @type {Maker | null} */
  let chosen = null;

  /** @param {Maker | null} maker */
  function select(maker) {
    const former = chosen;
    chosen = maker;
    for (const [one, option] of optionOf) option.setAttribute('aria-selected', String(one === maker));
    const option = maker && optionOf.get(maker);
    if (option) search.setAttribute('aria-activedescendant', option.id);
    else search.removeAttribute('aria-activedescendant');
    option?.scrollIntoView({ block: 'nearest' });
    if (maker !== former) choose(maker);
  }

  function show() {
    const fitting = found(makers, search.value);
    const groups = inGroups(fitting);
    shown = groups.flatMap(({ members }) => members);
    list.replaceChildren(
      ...groups.map(({ heading, members }, index) => {
        const title = element('div', { id: `maker-group-${index}`, class: 'maker-group', role: 'presentation' }, heading);
        return element('div', { role: 'group', 'aria-labelledby': title.id }, title, ...members.map((maker) => /** @type {HTMLElement} */ (optionOf.get(maker))));
      }),
    );
    list.hidden = !fitting.length;
    nothing.hidden = fitting.length > 0;
    nothing.textContent = fitting.length ? '' : `No mechanism is called “${search.value.trim()}”. A linkage of any type can be made from its type and sizes.`;
    // The best fit, not the first of the first group.
    select(search.value.trim() ? (fitting[0] ?? null) : (shown[0] ?? null));
  }

  /** @param {KeyboardEvent} event */
  function press(event) {
    const at = chosen ? shown.indexOf(chosen) : -1;
    const next = { ArrowDown: at + 1, ArrowUp: at - 1, PageDown: at + 5, PageUp: at - 5 }[event.key];
    if (event.key === 'Enter' && chosen) go();
    else if (next !== undefined && shown.length) select(shown[Math.max(0, Math.min(next, shown.length - 1))]);
    else return;
    event.preventDefault();
  }

  return { root: element('div', { class: 'maker-list' }, search, nothing, list), search, show };
}
