/**
 * The element <synthetica-linkage>: a linkage with its motion, in the words of the media elements. What is seen of it is
 * made by workbench.js when it first comes into view.
 *
 * @typedef {import('../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('./workbench.js').AppWithPanels} AppWithPanels
 * @typedef {{message: string, where: string, code: string}} LinkageError `where` is the place in the document, such as
 *   `chains[1].joints[0]`; empty where the document is not at fault
 */
import { ask, LATE, untilAnswered } from '../core/ask.js';
import { textOf } from '../core/document-text.js';
import { isEmpty } from '../core/linkage.js';
import { wear } from '../ui/style-sheets.js';
import { reason } from '../core/open.js';
import { Refusal } from '../core/refusal.js';
import { findSample, sampleText } from '../core/samples.js';
import markup from './canvas-area.html?raw';
import look from '../style/linkage.css?inline';
import { whileSeen } from '../ui/lazy.js';
import { createWorkbench } from './workbench.js';
import { announce } from './events.js';
import { MEANINGS } from './attributes.js';
import { LinkageWords } from './media-properties.js';

/** How long an element may be without a document before it says so, in milliseconds: a script may be about to give it one. */
const PATIENCE = 1000;

const NOTHING_GIVEN = 'No linkage is given. Accepted: a document by src, by a script of type application/json inside, or by the property document; or a sample by type.';

/** What a page may have set before the element was defined. */
const PROPERTIES = ['document', 'src', 'type', 'controls', 'autoplay', 'loop', 'frame', 'speed', 'view', 'theme', 'readonly', 'panels', 'currentTime'];

export class SyntheticaLinkage extends LinkageWords {
  static observedAttributes = ['src', 'type', 'loop', 'frame', 'speed', 'view', 'theme', 'readonly', 'panels', 'keys'];

  #root = this.attachShadow({ mode: 'open' });
  /** Ends what is seen. @type {AbortController | null} */
  #life = null;
  /** What is seen. @type {ReturnType<typeof withResolvers>} */
  #bench = withResolvers();
  #benchBegun = false;
  /** Counts loads: an answer to an older one is late. */
  #loads = 0;
  /** Goes on with a load that was interrupted because the element was taken out. @type {((back: null) => void) | null} */
  #goOn = null;
  /** A document is being opened that is no edit. */
  #opening = false;
  /** The next motion is the first of its document. */
  #fresh = true;
  /** @type {LinkageError | null} */
  #error = null;
  /** Attributes that cannot be used, each with the reason. @type {Map<string, LinkageError>} */
  #refused = new Map();

  constructor() {
    super();
    this.linkage.player.seen = false;
    announce(this, {
      isEdit: () => !this.#opening,
      isFirst: () => this.#fresh,
      begin: () => this.#begin(),
      fail: (error) => {
        this.#error = error;
      },
    });
  }

  /** What is seen of it, once it is. @returns {Promise<AppWithPanels>} */
  get workbench() {
    return this.#bench.promise;
  }

  connectedCallback() {
    for (const name of PROPERTIES) this.#takeOver(name);
    // Taken out and put in again at once, as by a move: it goes on as it is.
    if (!this.#life) {
      this.#build();
      this.linkage.comeBack();
      this.#goOn?.(null);
    }
    if (isEmpty(this.linkage.store) && !this.#loads) this.#load();
  }

  disconnectedCallback() {
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.pause();
      this.#dismantle();
      this.linkage.leave();
    });
  }

  /** @param {string} name @param {string | null} old @param {string | null} text */
  attributeChangedCallback(name, old, text) {
    if (old === text) return;
    const { player, store } = this.linkage;
    try {
      if (name === 'loop') player.loop = MEANINGS.loop(text);
      if (name === 'speed') player.playbackRate = MEANINGS.speed(text);
      if (name === 'frame') player.frame = this.#frameOf(MEANINGS.frame(text));
      if (name === 'view') store.setView({ side: MEANINGS.view(text) });
      if (name === 'theme' && MEANINGS.theme(text) !== null) dispatchEvent(new Event('synthetica-theme'));
      if (name === 'panels') MEANINGS.panels(text);
      if (name === 'readonly') store.readonly = text !== null;
      this.#refused.delete(name);
    } catch (error) {
      return this.#refuse(name, error);
    }
    if ((name === 'src' || name === 'type') && text !== null && this.isConnected) this.#load();
    if (['panels', 'readonly', 'keys'].includes(name) && this.#life) this.#rebuild();
  }

  // --- what it shows ---

  /**
   * The document as it is now, with every default; null before there is one. Give it an object or its text, or null: it waits
   * for one, whatever the attributes ask for.
   * @returns {MechanismDocument | null}
   */
  get document() {
    const { store } = this.linkage;
    return isEmpty(store) ? null : structuredClone(store.doc);
  }

  /** @param {MechanismDocument | string | null} next */
  set document(next) {
    const load = ++this.#loads;
    if (next === null) return;
    if (typeof next !== 'string' && (typeof next !== 'object' || Array.isArray(next))) {
      this.#complain(new Refusal(`The property document is ${Array.isArray(next) ? 'a list' : typeof next}. Accepted: a document as an object or its text.`));
      return;
    }
    this.#open(typeof next === 'string' ? next : JSON.stringify(next), '', load);
  }

  /** The planned motion, as columns; null before there is one. @returns {Motion | null} */
  get trajectory() {
    return this.linkage.store.result.motion;
  }

  /** What is wrong with the document, or what went wrong with it. @returns {LinkageError | null} */
  get error() {
    return this.#error ?? [...this.#refused.values()][0] ?? null;
  }

  /** The planned motion as a table, degrees and the document's length unit. @returns {Promise<string>} */
  async toCSV() {
    return this.linkage.planner.exportMotion(textOf(this.#planned()), 'csv');
  }

  /**
   * A picture of the view as it is now.
   * @param {{type?: 'png' | 'svg', width?: number, height?: number, scale?: number}} [wish] in CSS pixels, as large as the
   *   view unless told; `scale` pixels to one of those
   * @returns {Promise<Blob>}
   */
  async toImage(wish = {}) {
    this.#planned();
    this.#show();
    const { imageOf } = await import('../export/image.js');
    return imageOf(await this.workbench, wish);
  }

  // --- opening ---

  /** What the attributes or the content ask for. */
  async #load() {
    const load = ++this.#loads;
    try {
      const found = await this.#find(load);
      if (found) await this.#open(found.text, found.title, load);
      else if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', () => load === this.#loads && this.#load(), { once: true });
      else setTimeout(() => load === this.#loads && isEmpty(this.linkage.store) && this.#complain(new Refusal(NOTHING_GIVEN)), PATIENCE);
    } catch (error) {
      if (load === this.#loads) this.#complain(error);
    }
  }

  /** @param {number} load @returns {Promise<{text: string, title: string} | null>} */
  async #find(load) {
    const { src, type } = this;
    if (src) return { text: await fetched(src, this.baseURI), title: src.replace(/^.*\//, '') };
    const inside = this.querySelector(':scope > script[type="application/json"]');
    if (inside) return { text: inside.textContent ?? '', title: '' };
    if (!type) return null;
    const sample = findSample(type);
    if (sample) return { text: await sampleText(sample), title: sample.file };
    const made = await this.#answer(load, () => ask(() => this.linkage.planner.assemble(type), 'make a linkage of this type'));
    if (made.is === 'fault') throw new Refusal(made.message);
    return made.is === 'answer' ? { text: made.value, title: '' } : null;
  }

  /**
   * Asked again after trouble, and when the element is put back that was taken out meanwhile, while nothing else is to be shown.
   * @template {{is: string}} O @param {number} load @param {() => Promise<O>} question
   */
  async #answer(load, question) {
    for (;;) {
      const outcome = await untilAnswered(this.linkage.store, async () => (load === this.#loads ? question() : LATE));
      if (outcome.is !== 'late' || load !== this.#loads) return outcome;
      if (!this.isConnected) await new Promise((resolve) => (this.#goOn = resolve));
    }
  }

  /** @param {string} text @param {string} title @param {number} load */
  async #open(text, title, load) {
    const { store, whole } = this.linkage;
    const read = await this.#answer(load, () => whole(text));
    if (load !== this.#loads) return;
    if (read.is === 'fault') store.setResult({ fault: read.fault, trouble: '' });
    if (read.is !== 'answer') return;
    const doc = read.value;
    this.#fresh = this.#opening = true;
    store.restore({ doc, past: [], future: [] }, { title, handle: null, saved: doc });
    this.#opening = false;
  }

  /** The document that the motion belongs to. */
  #planned() {
    const { doc } = this.linkage.store.result;
    if (!doc) throw new Refusal('There is no motion yet: wait for the event “ready”.');
    return doc;
  }

  // --- telling ---

  /** What an attribute means; one that is refused means as much as none. @template {keyof typeof MEANINGS} N @param {N} name @returns {ReturnType<typeof MEANINGS[N]>} */
  #meant(name) {
    return /** @type {any} */ (MEANINGS[name](this.#refused.has(name) ? null : this.getAttribute(name)));
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
    this.workbench.then(({ say }) => say(refused.message, { stays: true }));
  }

  /** @param {unknown} error */
  #complain(error) {
    this.linkage.store.setResult({ trouble: reason(error) });
  }

  /** The first motion of a document. */
  #begin() {
    this.#fresh = false;
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

  // --- what is seen ---

  #build() {
    this.#life = new AbortController();
    const { signal } = this.#life;
    wear(this.#root, look);
    this.#root.innerHTML = markup;
    // A field's own event would leave the tree; the element tells of edits in its place.
    this.#root.firstElementChild?.addEventListener('input', (event) => event.stopPropagation());
    whileSeen(this, signal, async (seen) => {
      this.linkage.player.seen = seen;
      if (seen) this.#show();
      if (!this.#benchBegun) return;
      const { scene } = await this.workbench;
      if (scene && !signal.aborted) scene.setSeen(seen);
    });
  }

  #show() {
    if (this.#benchBegun || !this.#life) return;
    this.#benchBegun = true;
    const { resolve, reject } = this.#bench;
    createWorkbench(this.linkage, {
      root: this.#root,
      keys: this.#meant('keys') === 'page' ? document : this,
      panels: this.#meant('panels'),
      signal: this.#life.signal,
    }).then(resolve, reject);
  }

  #dismantle() {
    // With a reason of its own: the default one is an error, whose stack would hold on to the element.
    this.#life?.abort('taken out');
    this.#life = null;
    this.linkage.player.seen = false;
    this.linkage.player.draw = () => {};
    this.#root.replaceChildren();
    if (this.#benchBegun) this.#bench = withResolvers();
    this.#benchBegun = false;
  }

  #rebuild() {
    this.#dismantle();
    this.#build();
  }
}

function withResolvers() {
  /** @type {{promise: Promise<AppWithPanels>, resolve: (app: AppWithPanels) => void, reject: (error: unknown) => void}} */
  const all = /** @type {any} */ ({});
  all.promise = new Promise((resolve, reject) => Object.assign(all, { resolve, reject }));
  // Who does not ask for it need not hear that it failed.
  all.promise.catch(() => {});
  return all;
}

/** @param {string} src @param {string} base @returns {Promise<string>} */
async function fetched(src, base) {
  const accepted = 'Accepted: the address of a document, which is JSON text.';
  const refuse = (/** @type {Error} */ { message }) => {
    throw new Refusal(`“${src}” could not be loaded (${message}). ${accepted}`);
  };
  if (!URL.canParse(src, base)) throw new Refusal(`“${src}” is no address. ${accepted}`);
  const answer = await fetch(new URL(src, base)).catch(refuse);
  if (!answer.ok) throw new Refusal(`“${src}” could not be loaded (${answer.status} ${answer.statusText}). ${accepted}`);
  return answer.text().catch(refuse);
}
