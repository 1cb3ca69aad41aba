/**
 * The numbers of the documents that the worker keeps open, by asker and text: a document is sent once and asked about many
 * times.
 */

/** How many documents the worker keeps open: those of some elements, or those that undo and redo go through. */
const MAX_OPEN = 4;

export class OpenDocuments {
  #close;
  /** The one last asked about at the end. @type {Map<string, number>} */
  #numbers = new Map();
  #last = 0;
  /** @type {WeakMap<object, number>} */
  #askers = new WeakMap();
  #lastAsker = 0;

  /** @param {(doc: number) => void} close frees a document in the worker */
  constructor(close) {
    this.#close = close;
  }

  /**
   * What a question says of its document: the number, and the text where the worker does not have it.
   * @param {object} asker @param {string} text
   */
  about(asker, text) {
    const doc = this.#numbers.get(this.#keyOf(asker, text));
    return doc === undefined ? { doc: ++this.#last, text } : { doc };
  }

  /** It is open, and asked about last. @param {object} asker @param {string} text @param {number} doc */
  keep(asker, text, doc) {
    const key = this.#keyOf(asker, text);
    this.#numbers.delete(key);
    this.#numbers.set(key, doc);
    const [oldest] = this.#numbers.keys();
    if (this.#numbers.size > MAX_OPEN) this.#free(oldest);
  }

  /** @param {object} asker @param {string} text */
  close(asker, text) {
    this.#free(this.#keyOf(asker, text));
  }

  /** @param {object} asker */
  closeAllOf(asker) {
    const own = this.#keyOf(asker, '');
    for (const key of [...this.#numbers.keys()]) if (key.startsWith(own)) this.#free(key);
  }

  /** The worker that had them is no more. */
  forget() {
    this.#numbers.clear();
  }

  /** @param {string} key */
  #free(key) {
    const doc = this.#numbers.get(key);
    this.#numbers.delete(key);
    if (doc !== undefined) this.#close(doc);
  }

  /** @param {object} asker @param {string} text */
  #keyOf(asker, text) {
    const number = this.#askers.get(asker) ?? ++this.#lastAsker;
    this.#askers.set(asker, number);
    return `${number} ${text}`;
  }
}
