/**
 * The element <synthetica-linkage>: a linkage with its motion, in the words of the media elements. What is seen of it is in
 * seen.js.
 *
 * @typedef {import('../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('./workbench.js').AppWithPanels} AppWithPanels
 * @typedef {{message: string, where: string, code: string}} LinkageError `where` is the place in the document, such as
 *   `chains[1].joints[0]`; empty where the document is not at fault
 */
import { textOf } from '../core/document-text.js';
import { isEmpty } from '../core/nothing.js';
import { reason } from '../core/open.js';
import { Refusal } from '../core/refusal.js';
import { announce } from './events.js';
import { ATTRIBUTES, modeOf } from './attributes.js';
import { createOpening } from './opening.js';
import { createSeen } from './seen.js';
import { LinkageWords } from './media-properties.js';

/** What a page may have set before the element was defined. */
const PROPERTIES = ['document', ...Object.keys(ATTRIBUTES), 'currentTime'];

export class SyntheticaLinkage extends LinkageWords {
  static observedAttributes = Object.keys(ATTRIBUTES);

  #seen = createSeen(this, {
    root: this.attachShadow({ mode: 'open' }),
    wishes: () => ({ keys: this.#meant('keys'), panels: this.#meant('panels') }),
    complain: (error) => this.#complain(error),
  });
  #opening = createOpening(this, (error) => this.#complain(error));
  /** @type {LinkageError | null} */
  #error = null;
  /** Attributes that cannot be used, each with the reason. @type {Map<string, LinkageError>} */
  #refused = new Map();

  constructor() {
    super();
    announce(this, {
      isEdit: () => !this.#opening.opens,
      isFirst: () => this.#opening.isFresh,
      begin: () => this.#begin(),
      fail: (error) => {
        this.#error = error;
      },
    });
  }

  /** What is seen of it, once it is. @returns {Promise<AppWithPanels>} */
  get workbench() {
    return this.#seen.workbench;
  }

  connectedCallback() {
    for (const name of PROPERTIES) this.#takeOver(name);
    // Taken out and put in again at once, as by a move: it goes on as it is.
    if (!this.#seen.isThere) {
      this.#seen.build();
      this.parts.comeBack();
      this.#opening.comeBack();
    }
    this.#opening.loadFirst();
  }

  disconnectedCallback() {
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.pause();
      this.#seen.dismantle();
      this.parts.leave();
    });
  }

  /** @param {import('./attributes.js').Name} name @param {string | null} old @param {string | null} text */
  attributeChangedCallback(name, old, text) {
    if (old === text) return;
    const { player, store } = this.parts;
    try {
      const value = ATTRIBUTES[name].read(text);
      if (name === 'loop' || name === 'bounce') player.loop = modeOf(this);
      if (name === 'speed') player.playbackRate = /** @type {number} */ (value);
      if (name === 'frame') player.frame = this.#frameOf(/** @type {number} */ (value));
      if (name === 'view') store.setView({ side: ATTRIBUTES.view.read(text) });
      if (name === 'theme' && text !== null) dispatchEvent(new Event('synthetica-theme'));
      if (name === 'readonly') store.readonly = this.readonly;
      this.#refused.delete(name);
    } catch (error) {
      return this.#refuse(name, error);
    }
    if ((name === 'src' || name === 'type') && text !== null && this.isConnected) this.#opening.load();
    if (['panels', 'readonly', 'keys'].includes(name)) this.#seen.rebuild();
  }

  // --- what it shows ---

  /**
   * The document as it is now, with every default; null before there is one. Give it an object or its text, or null: it waits
   * for one, whatever the attributes ask for.
   * @returns {MechanismDocument | null}
   */
  get document() {
    const { store } = this.parts;
    return isEmpty(store) ? null : structuredClone(store.doc);
  }

  /** @param {MechanismDocument | string | null} next */
  set document(next) {
    this.#opening.give(next);
  }

  /** The planned motion, as columns; null before there is one. @returns {Motion | null} */
  get trajectory() {
    return this.parts.store.result.motion;
  }

  /** What is wrong with the document, or what went wrong with it. @returns {LinkageError | null} */
  get error() {
    return this.#error ?? [...this.#refused.values()][0] ?? null;
  }

  /** The planned motion as a table, degrees and the document's length unit. @returns {Promise<string>} */
  async toCSV() {
    return this.parts.planner.exportMotion(textOf(this.#planned()), 'csv');
  }

  /**
   * A picture of the view as it is now.
   * @param {{type?: 'png' | 'svg', width?: number, height?: number, scale?: number}} [wish] in CSS pixels, as large as the
   *   view unless told; `scale` pixels to one of those
   * @returns {Promise<Blob>}
   */
  async toImage(wish = {}) {
    this.#planned();
    this.#seen.show();
    const { imageOf } = await import('../export/image.js');
    return imageOf(await this.workbench, wish);
  }

  /** The document that the motion belongs to. */
  #planned() {
    const { doc } = this.parts.store.result;
    if (!doc) throw new Refusal('There is no motion yet: wait for the event “ready”.');
    return doc;
  }

  // --- telling ---

  /** What an attribute means; one that is refused means as much as none. @template {import('./attributes.js').Name} N @param {N} name @returns {ReturnType<typeof ATTRIBUTES[N]['read']>} */
  #meant(name) {
    return /** @type {any} */ (ATTRIBUTES[name].read(this.#refused.has(name) ? null : this.getAttribute(name)));
  }

  /** @param {number} frame */
  #frameOf(frame) {
    const last = (this.trajectory?.frames ?? Infinity) - 1;
    if (frame > last) throw new Refusal(`The attribute frame is “${frame}”. Accepted: a whole number from 0 to ${last}, the frames of this motion.`);
    return frame;
  }

  /** An attribute that cannot be used changes nothing, and says so. @param {string} name @param {unknown} error */
  #refuse(name, error) {
    const refused = { message: reason(error), where: '', code: 'attribute' };
    this.#refused.set(name, refused);
    this.dispatchEvent(new CustomEvent('error', { detail: refused }));
    this.workbench.then(({ say }) => say(refused.message, { stays: true }), () => {});
  }

  /** @param {unknown} error */
  #complain(error) {
    this.parts.store.setResult({ trouble: reason(error) });
  }

  /** The first motion of a document. */
  #begin() {
    this.#opening.isFresh = false;
    this.attributeChangedCallback('frame', null, this.getAttribute('frame'));
    if (this.autoplay && !matchMedia('(prefers-reduced-motion: reduce)').matches) this.play();
  }

  /** A property that was set before the element was defined hides the class's own. @param {string} name */
  #takeOver(name) {
    if (!Object.hasOwn(this, name)) return;
    const self = /** @type {Record<string, any>} */ (this);
    const value = self[name];
    delete self[name];
    self[name] = value;
  }
}
