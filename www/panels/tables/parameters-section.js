/**
 * The place of the parameters among the tables of the mechanism: folded until the document has some, and loaded when it is
 * unfolded.
 */
import { parametersOf } from '../../core/parameter-names.js';
import { notLoaded } from '../../ui/lazy.js';
import { attach, html } from '../../ui/render.js';

/**
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./cells.js').createCells>} cells
 * @param {{check: (doc: import('../../core/types.js').MechanismDocument) => Promise<import('../../core/types.js').Fault | null>,
 *   say: import('../../ui/notice.js').Say, nameCell: (path: string) => void}} outside
 */
export function createParametersSection(store, cells, outside) {
  /** What the person has chosen; until then it is open where there are parameters. @type {boolean | null} */
  let chosen = null;
  let loading = false;
  /** @type {{draw: () => void} | null} */
  let panel = null;
  /** @type {HTMLElement | null} */
  let place = null;

  const behave = (/** @type {HTMLElement} */ element) => {
    place = element;
    return () => {};
  };

  async function load() {
    if (loading || !place) return;
    loading = true;
    const host = place;
    try {
      const { createParametersPanel } = await import('./parameters-panel.js');
      host.replaceChildren();
      panel = createParametersPanel(host, store, cells, outside);
      panel.draw();
    } catch (error) {
      loading = false;
      notLoaded(host, 'The parameters', `The parameters could not be loaded (${error instanceof Error ? error.message : error}).`, load);
    }
  }

  /** The section, in which the table is drawn by itself. */
  function section() {
    const count = Object.keys(parametersOf(store.doc)).length;
    const fold = (/** @type {Event} */ { target }) => {
      const { open } = /** @type {HTMLDetailsElement} */ (target);
      if (open !== (chosen ?? count > 0)) chosen = open;
      if (open) load();
    };
    return html`<details class="parameters" data-path="parameters" ?open=${chosen ?? count > 0} @toggle=${fold}>
      <summary>Parameters${count ? ` (${count})` : ''}</summary>
      <div ${attach(behave, count)}></div>
    </details>`;
  }

  return {
    section,
    /** Draws the table, after all others: it names their cells. */
    draw: () => panel?.draw(),
  };
}
