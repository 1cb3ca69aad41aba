/**
 * The element <synthetica-linkage>: a linkage with its motion, in the words of the media elements. What stands in its
 * shadow root is in shadow-tree.js.
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
import { createShadowTree } from './shadow-tree.js';
import { LinkageWords } from './media-properties.js';

/** What a page may have set before the element was defined. */
const PROPERTIES = [...Object.keys(ATTRIBUTES), 'document', 'linkage', 'currentTime', 'playbackRate'];

export class SyntheticaLinkage extends LinkageWords {
  static observedAttributes = Object.keys(ATTRIBUTES);

  #tree = createShadowTree(this, {
    root: this.attachShadow({ mode: 'open' }),
    wishes: () => ({ keys: this.#meant('keys'), interaction: this.#meant('interaction'), panels: this.#meant('panels'), loading: this.#meant('loading') }),
    complain: (error) => this.#complain(error),
    start: () => this.#start(),
  });
  /** Lets the document be loaded. */
  #start = () => {};
  #opening = createOpening(this, {
    started: new Promise((resolve) => (this.#start = () => resolve(null))),
    complain: (error) => this.#complain(error),
    emptied: () => this.#tree.rebuild(),
    settle: () => this.#settle(),
  });
  /** @type {LinkageError | null} */
  #error = null;
  /** Attributes that cannot be used, each with the reason. @type {Map<string, LinkageError>} */
  #refused = new Map();

  constructor() {
    super();
    announce(this, {
      isEdit: () => !this.#opening.isOpening,
      isFirst: () => this.#opening.isFresh,
      begin: () => this.#begin(),
      fail: (error) => {
        this.#error = error;
      },
    });
  }

  /** What is seen of it, once it is. @returns {Promise<AppWithPanels>} */
  get workbench() {
    return this.#tree.workbench;
  }

  connectedCallback() {
    // In the order in which they were set.
    for (const name of Object.keys(this)) if (PROPERTIES.includes(name)) this.#takeOver(name);
    // Taken out and put in again at once, as by a move: it goes on as it is.
    if (!this.#tree.isInPage) {
      this.#tree.build();
      this.parts.resume();
      this.#opening.resume();
    }
    this.#opening.loadWhatIsAsked();
  }

  /** Another document has other style sheets, and another window draws. */
  adoptedCallback() {
    this.#tree.rebuild();
  }

  disconnectedCallback() {
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.pause();
      this.#tree.dismantle();
      this.parts.leave();
    });
  }

  /** @param {import('./attributes.js').Name} name @param {string | null} old @param {string | null} text */
  attributeChangedCallback(name, old, text) {
    if (old === text) {
      // The same address once more is the newest wish, where a document was given since.
      if (name === 'src' || name === 'type') this.#opening.attributeChanged(false);
      return;
    }
    const { player, store } = this.parts;
    try {
      const value = ATTRIBUTES[name].read(text);
      if (name === 'loop' || name === 'bounce') player.loop = modeOf(this);
      if (name === 'speed') player.playbackRate = /** @type {number} */ (value);
      if (name === 'frame') this.parts.playhead.frame = /** @type {number} */ (value);
      if (name === 'view') store.setView({ side: ATTRIBUTES.view.read(text) });
      if (name === 'theme') dispatchEvent(new Event('synthetica-theme'));
      if (name === 'loading' && value === 'eager') this.#tree.show();
      if (name === 'poster') this.#tree.setPoster();
      if (name === 'readonly') store.readonly = this.readonly;
      this.#refused.delete(name);
      this.#refused.delete(`property ${name}`);
    } catch (error) {
      return this.#refuse(name, error);
    }
    if (name === 'src' || name === 'type') this.#opening.attributeChanged(text === null);
    if (['panels', 'readonly', 'keys', 'interaction'].includes(name)) this.#tree.rebuild();
  }

  // --- what it shows ---

  /**
   * The document as it is now, with every default; null before there is one. Give it an object or its text; null empties the
   * element, whatever its attributes ask for.
   * @returns {MechanismDocument | null}
   */
  get document() {
    const { store } = this.parts;
    return isEmpty(store) ? null : structuredClone(store.doc);
  }

  /** @param {MechanismDocument | string | null} next */
  set document(next) {
    this.#opening.setDocument(next);
  }

  /** The same as `document`, which in the text of an inline handler is the page's own. */
  get linkage() {
    return this.document;
  }

  set linkage(next) {
    this.document = next;
  }

  /** The planned motion, as columns; null until that of its document is there. @returns {Motion | null} */
  get trajectory() {
    const { store } = this.parts;
    return this.#opening.isFresh && store.result.doc !== store.doc ? null : store.result.motion;
  }

  /** What is wrong with the document, or what went wrong with it. @returns {LinkageError | null} */
  get error() {
    return this.#error ?? [...this.#refused.values()][0] ?? null;
  }

  /**
   * Loads what the motion needs, wherever the element is, and waits for it.
   * @returns {Promise<Motion>} fails with what is wrong where there will be none
   */
  async whenReady() {
    this.#start();
    this.#opening.loadWhatIsAsked();
    const { store } = this.parts;
    return new Promise((resolve, reject) => {
      /** @type {(() => void) | undefined} */
      let leave;
      const look = () => {
        const { motion, fault, trouble, doc } = store.result;
        if (motion && (doc === store.doc || fault || trouble)) resolve(motion);
        else if (fault ?? trouble) reject(new Refusal(fault?.message ?? trouble));
        else return false;
        leave?.();
        return true;
      };
      if (!look()) leave = store.subscribe('result', look);
    });
  }

  play() {
    this.#start();
    this.#opening.loadWhatIsAsked();
    return super.play();
  }

  /**
   * The planned motion as a table, degrees and the document's length unit.
   * @param {Pick<import('../core/types.js').ExportOptions, 'headings'>} [options]
   * @returns {Promise<string>}
   */
  async toCSV(options) {
    await this.whenReady();
    return this.parts.planner.exportMotion(textOf(this.#planned()), 'csv', options);
  }

  /**
   * A picture of the view as it is now.
   * @param {{type?: 'png' | 'svg', width?: number, height?: number, scale?: number}} [wish] in CSS pixels, as large as the
   *   view unless told; `scale` pixels to one of those
   * @returns {Promise<Blob>}
   */
  async toImage(wish = {}) {
    await this.whenReady();
    const { imageOf, imageApart } = await import('../export/image.js');
    if (!this.#tree.isInPage) return imageApart(this, wish);
    this.#tree.show();
    return imageOf(await this.workbench, wish);
  }

  /** The document that the motion belongs to. */
  #planned() {
    const { doc } = this.parts.store.result;
    if (!doc || !this.trajectory) throw new Refusal('There is no motion yet: wait for the event “ready”.');
    return doc;
  }

  /** The view takes the focus, made or not. @param {FocusOptions} [options] */
  focus(options) {
    this.#tree.show();
    const take = () => this.shadowRoot?.querySelector('canvas')?.focus(options);
    take();
    const { activeElement: former } = this.ownerDocument;
    // One that is being loaded takes it then, unless the reader has gone elsewhere.
    if (former !== this) this.workbench.then(() => this.ownerDocument.activeElement === former && take(), () => {});
  }

  // --- telling ---

  /** What an attribute means; one that is refused means as much as none. @template {import('./attributes.js').Name} N @param {N} name @returns {ReturnType<typeof ATTRIBUTES[N]['read']>} */
  #meant(name) {
    return /** @type {any} */ (ATTRIBUTES[name].read(this.#refused.has(name) ? null : this.getAttribute(name)));
  }

  /** An attribute or property that cannot be used changes nothing, and says so. @param {string} name @param {unknown} error */
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
    // Of another document that has been asked for meanwhile it is wanted.
    if (!this.parts.player.first.isAwaited) this.#settle();
    if (this.autoplay && !matchMedia('(prefers-reduced-motion: reduce)').matches) this.play();
  }

  #settle() {
    try {
      this.parts.playhead.settle();
    } catch (error) {
      this.#refuse('frame', error);
    }
  }

  /** A property that was set before the element was defined hides the class's own. @param {string} name */
  #takeOver(name) {
    const self = /** @type {Record<string, any>} */ (this);
    const value = self[name];
    delete self[name];
    try {
      self[name] = value;
    } catch (error) {
      this.#refuse(`property ${name}`, error);
    }
  }
}
