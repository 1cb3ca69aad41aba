/**
 * Menu buttons, by the ARIA pattern: arrow keys and letters go through the items, Escape and a click outside close.
 *
 * @typedef {{label: string, hint?: string, key?: string, checked?: boolean, disabled?: string, act: () => void} | 'line'} MenuItem
 *   `key` does the same without the menu; an item that is `checked` or not is a switch; `disabled` says why it cannot be
 *   chosen now: it stays among the others, or nobody without a pointer would learn that
 */
import { element, focusBeside } from './dom.js';
import { spokenKey } from './keys.js';

let made = 0;

/**
 * @param {string} label
 * @param {() => MenuItem[] | Promise<MenuItem[]>} items asked for each time the menu opens
 * @returns {HTMLButtonElement} the button that opens the menu
 */
export function menuButton(label, items) {
  const button = element('button', { class: 'menu-button' }, label);
  attachMenu(button, items);
  return button;
}

/**
 * Gives a button a menu, named as the button is.
 * @param {HTMLButtonElement} button
 * @param {() => MenuItem[] | Promise<MenuItem[]>} items asked for each time the menu opens, which waits for them
 */
export function attachMenu(button, items) {
  const menu = element('div', { class: 'menu', role: 'menu', popover: 'auto', id: `menu-${++made}` });
  for (const [name, value] of [['haspopup', 'menu'], ['expanded', 'false'], ['controls', menu.id]]) button.setAttribute(`aria-${name}`, value);

  const entries = () => /** @type {HTMLButtonElement[]} */ ([...menu.querySelectorAll('button')]);
  const close = () => menu.hidePopover();

  /** @param {number} focused index of the item that is entered; -1 for the last */
  async function open(focused = 0) {
    const asked = items();
    const all = asked instanceof Promise ? await asked : asked;
    // It may have been asked for once more in the meantime.
    if (menu.matches(':popover-open')) return;
    menu.replaceChildren(
      ...all.map((item) => {
        if (item === 'line') return element('hr', { role: 'separator' });
        const act = () => {
          if (item.disabled) return;
          close();
          item.act();
        };
        const role = item.checked === undefined ? 'menuitem' : 'menuitemcheckbox';
        const entry = element('button', { role, tabindex: -1, 'aria-disabled': item.disabled && 'true', click: act, 'aria-keyshortcuts': item.key && spokenKey(item.key) }, item.label);
        if (item.checked !== undefined) entry.setAttribute('aria-checked', String(item.checked));
        if (item.key) entry.append(element('kbd', { 'aria-hidden': 'true' }, item.key));
        const line = item.disabled || item.hint;
        if (line) entry.append(element('small', {}, line));
        return entry;
      }),
    );
    menu.setAttribute('aria-label', button.getAttribute('aria-label') ?? button.textContent ?? '');
    if (!menu.isConnected) button.after(menu);
    menu.showPopover();
    const at = button.getBoundingClientRect();
    // Below the button, or as far up as the whole menu needs.
    menu.style.top = `${Math.max(4, Math.min(at.bottom + 4, innerHeight - menu.offsetHeight - 4))}px`;
    menu.style.left = `${Math.max(4, Math.min(at.left, innerWidth - menu.offsetWidth - 4))}px`;
    entries().at(focused)?.focus();
  }

  menu.addEventListener('toggle', (event) => {
    const shown = /** @type {ToggleEvent} */ (event).newState === 'open';
    button.setAttribute('aria-expanded', String(shown));
    if (!shown && menu.contains(focusBeside(menu))) button.focus();
  });
  // The light dismissal of the popover comes first: what was open when the pointer went down is to be closed.
  let wasOpen = false;
  button.addEventListener('pointerdown', () => {
    wasOpen = menu.matches(':popover-open');
  });
  button.addEventListener('click', () => {
    if (!wasOpen) open();
    wasOpen = false;
  });
  button.addEventListener('keydown', (event) => {
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
    event.preventDefault();
    open(event.key === 'ArrowUp' ? -1 : 0);
  });
  menu.addEventListener('keydown', (event) => {
    const all = entries();
    const at = all.indexOf(/** @type {HTMLButtonElement} */ (focusBeside(menu)));
    const letter = event.key.length === 1 ? event.key.toLowerCase() : '';
    const steps = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 };
    let next = steps[/** @type {keyof typeof steps} */ (event.key)];
    if (event.key === 'Tab') close();
    if (letter && letter !== ' ') {
      const from = [...all.slice(at + 1), ...all.slice(0, at + 1)];
      const found = from.find((entry) => entry.textContent?.toLowerCase().startsWith(letter));
      if (found) next = all.indexOf(found);
    }
    event.stopPropagation();
    if (next === undefined) return;
    event.preventDefault();
    all.at(next % all.length)?.focus();
  });
}
