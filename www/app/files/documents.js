/**
 * What a person does with documents. How it is done is loaded when it is first asked for.
 */
import { byId } from '../../ui/dom.js';
import { withPart } from '../../ui/lazy.js';

/** @param {import('../../element/workbench.js').App} app */
export function createDocuments(app) {
  /** @type {HTMLInputElement} */
  const chooser = byId('file');
  /** @typedef {ReturnType<typeof import('./actions.js').createActions>} Actions */
  /** @type {Actions | null} */
  let made = null;
  /** @param {(actions: Actions) => unknown} act */
  const run = (act) => withPart(app, 'What opens and saves documents', () => import('./actions.js'), ({ createActions }) => act((made ??= createActions(app, chooser))));

  /** Opens a file that was handed in. @param {File} file */
  const take = (file) => run((actions) => actions.take(file));
  chooser.addEventListener('change', () => {
    const [file] = chooser.files ?? [];
    if (file) take(file);
    chooser.value = '';
  });
  return {
    take,
    fresh: () => run((actions) => actions.fresh()),
    pick: () => run((actions) => actions.pick()),
    share: () => run((actions) => actions.share()),
    /** @param {boolean} [another] to a file of another name */
    save: (another = false) => run((actions) => actions.save(another)),
  };
}
