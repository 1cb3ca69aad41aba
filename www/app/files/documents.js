/**
 * What a person does with documents. How it is done is loaded when it is first asked for.
 */
import { byId } from '../../ui/dom.js';

/** @param {import('../../element/workbench.js').App} app */
export function createDocuments(app) {
  /** @type {HTMLInputElement} */
  const chooser = byId('file');
  const acts = async () => (await import('./actions.js')).createActs(app, chooser);
  /** @type {ReturnType<typeof acts> | null} */
  let made = null;

  /** @param {(acts: ReturnType<typeof import('./actions.js').createActs>) => unknown} act */
  async function run(act) {
    try {
      made ??= acts();
      await made;
    } catch (error) {
      // Off line before the first load was whole: the next click tries again.
      made = null;
      return app.say(`This part of the page could not be loaded (${/** @type {Error} */ (error).message}). Reload the page to try again.`);
    }
    await act(await made);
  }

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
