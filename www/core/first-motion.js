/**
 * The wait for the first motion of a document, from when the document is asked for: how far it is, and the promises that
 * `play()` gave meanwhile, which are kept or refused together.
 */
export class FirstMotion {
  #halt;
  /** Another document has been asked for, and is not read yet. */
  #asked = false;
  /** A document has been read. */
  #known = false;
  /** The document has no motion yet. */
  #fresh = true;
  /** Why what was asked for has none. */
  #failure = '';
  /** @type {{resolve: () => void, reject: (reason: DOMException) => void}[]} */
  #plays = [];

  /** @param {() => void} halt ends what is played */
  constructor(halt) {
    this.#halt = halt;
  }

  /** Whether a document is asked for that is not read yet. */
  get asked() {
    return this.#asked;
  }

  /** Whether the motion of a document that has been read is still to come. */
  get fresh() {
    return this.#fresh;
  }

  /** Whether the motion of what is asked for is still to come. */
  get waits() {
    return this.#asked || this.#fresh;
  }

  /** Why it will not come; empty while it may. */
  get failure() {
    return this.waits ? this.#failure : '';
  }

  /** Another document is asked for. */
  asks() {
    if (this.#asked || this.#known) this.#end('AbortError', 'Another document took the place of the one to be played.');
    this.#asked = true;
    this.#failure = '';
  }

  /** It has been read, and its motion is to come. */
  opened() {
    this.#asked = false;
    this.#known = this.#fresh = true;
    this.#failure = '';
  }

  /** It has been taken away. */
  emptied() {
    this.opened();
    this.#known = false;
  }

  /** There is no other: the one before stays. */
  stays() {
    this.#asked = false;
  }

  /** What was asked for, or its motion, cannot be had. @param {string} why */
  failed(why) {
    this.#asked = false;
    this.#failure = why;
    this.#end('NotSupportedError', why);
  }

  /** The first motion is there. */
  begins() {
    this.#known = true;
    this.#fresh = false;
    if (!this.#asked) this.keep();
  }

  /** @returns {Promise<void>} kept when it plays */
  play() {
    const given = new Promise((resolve, reject) => this.#plays.push({ resolve: () => resolve(undefined), reject }));
    // Avoids an unhandled rejection where nobody awaits it.
    given.catch(() => {});
    return given;
  }

  /** It plays. */
  keep() {
    for (const { resolve } of this.#plays.splice(0)) resolve();
  }

  /** @param {'AbortError' | 'NotSupportedError'} name as the media elements name it @param {string} why */
  refuse(name, why) {
    for (const { reject } of this.#plays.splice(0)) reject(new DOMException(why, name));
  }

  /** @param {'AbortError' | 'NotSupportedError'} name @param {string} why */
  #end(name, why) {
    this.refuse(name, why);
    this.#halt();
  }
}
