/**
 * The type of a chain as a text that can be typed: Enter applies it, Escape takes it back.
 */
import { AXES_JOINTS } from '../../core/by-axes.js';
import { setChainType } from '../../core/edits.js';
import { chainType, isByAxes } from '../../core/joint-types.js';
import { readType } from '../../core/type-letters.js';
import { keyListener } from '../../ui/keys.js';
import { html, live, nothing } from '../../ui/render.js';

/** @typedef {{text: string, of: string, fault: string}} Entry what is typed in place of the type `of`, and what is wrong with it */

/**
 * @param {import('../../core/store.js').Store} store
 * @param {import('../../core/types.js').Defaults} defaults
 * @param {() => void} draw shows what is typed
 */
export function createTypeField(store, defaults, draw) {
  /** By the chain's key. @type {Map<number, Entry>} */
  const entries = new Map();

  /**
   * @param {number} chain @param {number} key the chain's among the rendered ones
   * @returns {{field: unknown, note: unknown}} `note` says what is wrong, or what Enter does; it stands below the field
   */
  return (chain, key) => {
    const type = chainType(store.doc.chains[chain]);
    // A type that was changed elsewhere, such as by undo, is shown.
    if (entries.get(key)?.of !== type) entries.delete(key);
    const typed = entries.get(key);
    const wanted = typed?.text.trim().toUpperCase() ?? type;
    const words = typed?.fault || (wanted === type ? '' : `Enter makes this chain ${wanted || '…'}; Escape keeps ${type}.`);
    const id = `type-note-${chain}`;

    /** @param {HTMLInputElement} field */
    function apply(field) {
      const answer = readType(field.value);
      if ('fault' in answer) entries.set(key, { text: field.value, of: type, fault: answer.fault });
      else {
        entries.delete(key);
        store.edit((doc) => setChainType(doc, chain, answer.letters, isByAxes(doc.chains[chain]) ? AXES_JOINTS : defaults.joints));
      }
      draw();
      if (!('fault' in answer)) field.select();
    }
    const target = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target);
    const write = (/** @type {Event} */ event) => {
      entries.set(key, { text: target(event).value, of: type, fault: '' });
      draw();
    };
    const press = keyListener({
      keepValue: (event) => apply(target(event)),
      oldValue(event) {
        entries.delete(key);
        draw();
        target(event).select();
        return false;
      },
    });
    return {
      field: html`<input type="text" class="cell text type" size="6" data-path="chains[${chain}].type"
        aria-label="type of chain ${chain + 1}, its joints from base to workpiece" aria-describedby=${id} aria-invalid=${typed?.fault ? 'true' : nothing}
        autocomplete="off" autocapitalize="characters" spellcheck="false" enterkeyhint="done" title="Joints from base to workpiece, such as RPS; Enter applies"
        ?readonly=${store.readonly} .value=${live(typed?.text ?? type)}
        @focus=${(/** @type {Event} */ event) => target(event).select()} @input=${write} @keydown=${press} />`,
      note: html`<p id=${id} class=${typed?.fault ? 'type-note fault' : 'type-note'} role="status" ?hidden=${!words}>${words}</p>`,
    };
  };
}
