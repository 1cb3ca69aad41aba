/**
 * The numbers of the documents that the worker keeps open, by asker and text: a document is sent once and asked about many
 * times.
 */

/** How many documents the worker keeps open: those of some elements, or those that undo and redo go through. */
const MAX_OPEN = 4;

/** @typedef {{asker: object, text: string, doc: number}} Open */

export class OpenDocuments {
  #close;
  /** The one last asked about at the end. A list, since a key made of a long text would copy it. @type {Open[]} */
  #open = [];
  #last = 0;

  /** @param {(doc: number) => void} close frees a document in the worker */
  constructor(close) {
    this.#close = close;
  }

  /**
   * What a question says of its document: the number, and the text where the worker does not have it.
   * @param {object} asker @param {string} text
   */
  about(asker, text) {
    const known = this.#find(asker, text);
    return known ? { doc: known.doc } : { doc: ++this.#last, text };
  }

  /** @param {object} asker @param {string} text */
  has(asker, text) {
    return this.#find(asker, text) !== undefined;
  }

  /** @param {object} asker @param {string} text */
  #find(asker, text) {
    return this.#open.find((one) => one.asker === asker && one.text === text);
  }

  /** It is open, and asked about last. @param {object} asker @param {string} text @param {number} doc */
  keep(asker, text, doc) {
    this.#open = [...this.#open.filter((one) => one.doc !== doc), { asker, text, doc }];
    if (this.#open.length > MAX_OPEN) this.#free(([oldest]) => oldest);
  }

  /** @param {object} asker @param {string} text */
  close(asker, text) {
    this.#free(() => this.#find(asker, text));
  }

  /** @param {object} asker */
  closeAllOf(asker) {
    const own = this.#open.filter((one) => one.asker === asker);
    for (const one of own) this.#free(() => one);
  }

  /** The worker that had them is no more. */
  forget() {
    this.#open = [];
  }

  /** @param {(open: Open[]) => Open | undefined} choose */
  #free(choose) {
    const gone = choose(this.#open);
    this.#open = this.#open.filter((one) => one !== gone);
    if (gone) this.#close(gone.doc);
  }
}
