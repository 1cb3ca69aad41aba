/**
 * What a person does with documents. How it is done is loaded when it is first asked for.
 */
import { byId } from '../../ui/dom.js';
import { withPart } from '../../ui/lazy.js';

/** @param {import('../../element/workbench.js').App} app */
export function createDocuments(app) {
  /** @type {HTMLInputElement} */
  const chooser = byId('file');
  /** @typedef {ReturnType<typeof import('./actions.js').createActs>} Acts */
  /** @type {Acts | null} */
  let made = null;
  /** @param {(acts: Acts) => unknown} act */
  const run = (act) => withPart(app, 'What opens and saves documents', () => import('./actions.js'), ({ createActs }) => act((made ??= createActs(app, chooser))));

  /** Opens a file that was handed in. @param {File} file */
  const take = (file) => run((then) => then.take(file));
  chooser.addEventListener('change', () => {
    const [file] = chooser.files ?? [];
    if (file) take(file);
    chooser.value = '';
  });
  return {
    take,
    fresh: () => run((then) => then.fresh()),
    pick: () => run((then) => then.pick()),
    share: () => run((then) => then.share()),
    /** @param {boolean} [another] to a file of another name */
    save: (another = false) => run((then) => then.save(another)),
  };
}
