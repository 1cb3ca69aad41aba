/**
 * Two things to look up: the keys, and what each number of the page means with its equation.
 */
import { element } from '../../ui/dom.js';
import { KEYS, PLACES } from '../../ui/keys.js';
import { openDialog } from '../../ui/dialog.js';
import numbers from './numbers.html?raw';
import '../../style/reference.css';

export function showKeys() {
  openDialog(
    'Keys',
    ...Object.entries(PLACES).map(([place, title]) =>
      element(
        'table',
        { class: 'keys-table' },
        element('caption', {}, title),
        element(
          'tbody',
          {},
          ...Object.values(KEYS).filter(({ where }) => where === place).map(({ keys, does }) =>
            element('tr', {}, element('th', { scope: 'row' }, ...keys.flatMap((key, i) => [...(i ? [' '] : []), element('kbd', {}, key)])), element('td', {}, does)),
          ),
        ),
      ),
    ),
  );
}

export function showNumbers() {
  const body = element('div', { class: 'glossary' });
  // Our own text, from the file beside this one.
  body.innerHTML = numbers;
  openDialog('What the numbers mean', body);
}
