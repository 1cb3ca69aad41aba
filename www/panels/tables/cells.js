/**
 * Editable cells: inputs bound to places of the document. A cell shows a short number and gives the whole one
 * when entered; it plans while one types a number; an expression is shown as typed, and text that is neither is kept;
 * Escape restores.
 *
 * @typedef {import('../../core/store.js').Store} Store
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {object} CellSpec
 * @property {string} path place in the document, as a fault names it
 * @property {string} label name for screen readers: "chain 2, row 3, α in degrees"
 * @property {string} [column] name of its column, along which Enter goes
 * @property {boolean} [optional] empty means absent
 * @property {boolean} [text] any text, not a number
 * @property {number} [decimals] of the short number; 4 unless told
 * @property {() => void} [show] shows the document's value, once the cell is there
 * @property {() => number | undefined} [fallback] what holds where the document gives nothing; shown as a hint
 * @property {(doc: MechanismDocument, value: import('../../core/types.js').Entry | undefined) => MechanismDocument} [write]
 */
import { entry, setValue } from '../../core/edits.js';
import { short } from '../../core/format.js';
import { parameterAlone, parameterPath, parametersOf } from '../../core/parameter-names.js';
import { valueAt } from '../../core/path.js';
import { focusBeside } from '../../ui/dom.js';
import { onKeys } from '../../ui/keys.js';
import { attach, html, live, nothing } from '../../ui/render.js';

/** What a text in a cell means. @param {CellSpec} spec @param {string} text */
function read({ text: words, optional }, text) {
  if (words) return text;
  return text.trim() === '' && optional ? undefined : entry(text);
}

/** @param {CellSpec} spec @param {MechanismDocument} doc @param {import('../../core/types.js').Entry | undefined} value */
const written = ({ path, write }, doc, value) => (write ? write(doc, value) : setValue(doc, path, value));

/** Characters of an expression for which a cell makes room: a long one is seen whole where it is entered. */
const LONGEST = 14;

/** @param {Store} store */
export function createCells(store) {
  /** The cells that are shown, by their paths. @type {Map<string, CellSpec>} */
  const specs = new Map();
  /** Those that are made with the part of a table that is being made. @type {CellSpec[] | null} */
  let fresh = null;
  /** Those whose values are shown, though their part of the table is not rendered anew. @type {WeakSet<CellSpec>} */
  const followed = new WeakSet();
  let visits = 0;
  /** The cell with a number that was entered last. */
  let lastNumber = '';

  /** Makes an input a cell. @param {HTMLInputElement} field @returns {(spec: CellSpec) => void} shows the document's present value */
  function behave(field) {
    /** @type {CellSpec} */
    let spec;
    /** Names the stay in the cell: what is typed in one stay is undone in one step. */
    let visit = '';
    /** Typed since the cell last showed the document. */
    let touched = false;
    /** Values of the document: when the cell was entered, and when it was last typed in. @type {any} */
    let before;
    /** @type {any} */
    let seen;
    let writing = false;

    const value = () => valueAt(store.doc, spec.path);
    const editing = () => focusBeside(field) === field;
    const typed = () => read(spec, field.value);

    /** @param {'value' | 'title' | 'placeholder'} name @param {string} text */
    const put = (name, text) => {
      if (field[name] !== text) field[name] = text;
    };

    const isExpression = (/** @type {unknown} */ now) => typeof now === 'string' && !spec.text;

    const show = () => {
      const now = value();
      const whole = now == null ? '' : String(now);
      // Also while one is still in it: what it is worth is told by expression-value.js.
      field.classList.toggle('expression', isExpression(now));
      // One's own typing stays as typed; another's change (undo, a sample) shows even in the cell being edited.
      if (touched && editing() && (writing || now === seen)) return;
      touched = false;
      field.classList.remove('typing');
      // The keys of a phone for numbers have no letters.
      if (!spec.text) field.inputMode = isExpression(now) || Object.keys(parametersOf(store.doc)).length ? 'text' : 'decimal';
      const text = editing() || typeof now !== 'number' ? whole : short(now, spec.decimals).replace('−', '-');
      const hint = spec.fallback?.();
      // Written only where it changed: a drag shows every cell anew at every move.
      put('value', text);
      put('title', typeof now === 'number' && text !== whole ? whole : '');
      put('placeholder', hint !== undefined ? short(hint, spec.decimals) : spec.optional ? '–' : '');
      fit();
    };

    /** No digit of a number is cut: the style sheet gives the cell room for so many. */
    const fit = () => {
      const needed = Math.max(field.value.length, field.placeholder.length);
      const characters = String(typeof typed() === 'string' ? Math.min(needed, LONGEST) : needed);
      if (!spec.text && field.style.getPropertyValue('--characters') !== characters) field.style.setProperty('--characters', characters);
    };

    /** @param {boolean} final whether the person has finished: while "-" or "1e" is typed, nothing is wrong yet */
    const commit = (final) => {
      if (!touched) return;
      const next = typed();
      if (!final && !spec.text && typeof next !== 'number') return;
      writing = true;
      store.edit((doc) => written(spec, doc, next), visit);
      writing = false;
      seen = value();
    };

    field.addEventListener('focus', () => {
      visit = `visit ${++visits}`;
      before = seen = value();
      if (typeof before === 'number') lastNumber = spec.path;
      show();
      field.select();
    });
    field.addEventListener('input', () => {
      touched = true;
      field.classList.add('typing');
      fit();
      commit(false);
    });
    field.addEventListener('blur', () => {
      commit(true);
      touched = false;
      show();
    });
    onKeys(field, {
      keepValue(event) {
        commit(true);
        field.classList.remove('typing');
        // Text may be at fault, which is to be mended first: stay. An expression of a document that is planned is none.
        const isGood = store.result.doc === store.doc && !store.result.fault;
        if (!spec.text && typeof typed() === 'string' && !isGood) event.stopPropagation();
        return false;
      },
      oldValue() {
        // A cell that was already at fault when it was entered goes back to its last good value.
        const faulty = field.getAttribute('aria-invalid') === 'true' && value() === before;
        const good = faulty ? valueAt(store.result.doc, spec.path) : before;
        touched = false;
        store.edit((doc) => written(spec, doc, good ?? undefined), visit);
        show();
        field.select();
        return false;
      },
    });
    return (next) => {
      spec = next;
      spec.show = show;
      show();
    };
  }

  return {
    /** @param {CellSpec} spec */
    input(spec) {
      specs.set(spec.path, spec);
      fresh?.push(spec);
      return html`<input type="text" inputmode=${spec.text ? 'text' : 'decimal'} autocomplete="off" spellcheck="false"
        data-path=${spec.path} data-column=${spec.column ?? nothing} aria-label=${spec.label} class=${spec.text ? 'cell text' : 'cell'} ?readonly=${store.readonly}
        ${attach(behave, spec)} />`;
    },

    /**
     * @param {{path: string, label: string, options: [string, string][], write?: (doc: MechanismDocument, value: string) => MechanismDocument}} spec
     */
    select({ path, label, options, write = (doc, value) => setValue(doc, path, value) }) {
      const now = String(valueAt(store.doc, path) ?? '');
      const choose = (/** @type {Event} */ { target }) => store.edit((doc) => write(doc, /** @type {HTMLSelectElement} */ (target).value));
      // What is none of the options is shown as it is.
      const other = options.some(([value]) => value === now) ? nothing : html`<option hidden value=${now} .selected=${live(true)}>${now}</option>`;
      return html`<select data-path=${path} aria-label=${label} class="cell" ?disabled=${store.readonly} @change=${choose}>
        ${options.map(([value, text]) => html`<option value=${value} .selected=${live(value === now)}>${text}</option>`)}${other}
      </select>`;
    },

    /** Forgets the cells: those that are still there are rendered next. */
    clear: () => specs.clear(),
    /** Shows the values of the cells within a place anew. @param {string} place */
    follow(place) {
      const within = `${place}.`;
      specs.forEach((spec, path) => {
        if (!path.startsWith(within)) return;
        followed.add(spec);
        spec.show?.();
      });
    },
    /**
     * What `make` makes, with the cells in it.
     * @template T @param {() => T} make
     */
    noting(make) {
      /** @type {CellSpec[]} */
      const own = (fresh = []);
      try {
        return { made: make(), specs: own };
      } finally {
        fresh = null;
      }
    },
    /** They are still there, though they are not rendered anew. @param {CellSpec[]} all */
    know(all) {
      for (const spec of all) {
        specs.set(spec.path, spec);
        // It may be back at the value that its part was rendered with.
        if (followed.delete(spec)) spec.show?.();
      }
    },
    /**
     * The document with a text written into a cell as if it were typed there; the cell may be one that is not made yet.
     * @param {MechanismDocument} doc @param {string} path @param {string} text
     */
    written(doc, path, text) {
      const spec = specs.get(path) ?? { path, label: '', text: /\]\.name$/.test(path) };
      return written(spec, doc, read(spec, text));
    },
    /** What a cell is called, in words; its place for one that is not shown. @param {string} path */
    label: (path) => specs.get(path)?.label ?? path,
    /** The path of the cell with a number that was entered last; '' for none. */
    lastNumber: () => lastNumber,
    /** Where the number of a cell stands: in the cell, or in the parameter that is named there and nothing else. @param {string} path */
    source(path) {
      const name = parameterAlone(store.doc, valueAt(store.doc, path));
      return name === undefined ? path : parameterPath(name);
    },
    /** The number of a cell: the document's, else what holds in its place. @param {string} path @returns {number | null} null for none */
    number(path) {
      const value = valueAt(store.doc, path) ?? specs.get(path)?.fallback?.();
      return typeof value === 'number' && Number.isFinite(value) ? value : null;
    },
  };
}
