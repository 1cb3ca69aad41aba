/**
 * Tables of what only some documents have, loaded when one has it: chains by their axes, rotations in other forms.
 *
 * @typedef {Pick<import('../../element/workbench.js').App, 'scene' | 'store' | 'say' | 'signal'>} View where points are picked and
 *   axes drawn
 */
import { wear } from '../../ui/style-sheets.js';

/** @param {HTMLElement} root holds the tables @param {() => void} draw when they are loaded @param {import('../../ui/notice.js').Say} say */
export function createTypedParts(root, draw, say) {
  /** @type {typeof import('./typed-tables.js') | null} */
  let parts = null;
  let loading = false;
  async function load() {
    loading = true;
    try {
      parts = await import('./typed-tables.js');
      wear(/** @type {ShadowRoot} */ (root.getRootNode()), parts.look);
      draw();
    } catch (error) {
      const again = { label: 'Try again', act: load, stays: true };
      say(`The tables of axes and of other forms could not be loaded (${error instanceof Error ? error.message : error}).`, again);
    }
  }
  return {
    /** The tables; null until they are there. */
    get() {
      if (!parts && !loading) load();
      return parts;
    },
  };
}
