/**
 * The wait for the first motion of a document, from when the document is asked for: how far it is, and the promises that
 * `play()` gave meanwhile, which are resolved or rejected together.
 */
export class FirstMotion {
  #stop;
  /** Another document has been asked for, and is not read yet. */
  #isRequested = false;
  /** A document has been read. */
  #isRead = false;
  /** The document has no motion yet. */
  #isUnplanned = true;
  /** Why what was asked for has none. */
  #failure = '';
  /** @type {{resolve: () => void, reject: (reason: DOMException) => void}[]} */
  #plays = [];

  /** @param {() => void} stop ends what is played */
  constructor(stop) {
    this.#stop = stop;
  }

  /** Whether a document is asked for that is not read yet. */
  get isRequested() {
    return this.#isRequested;
  }

  /** Whether the motion of a document that has been read is still to come. */
  get isUnplanned() {
    return this.#isUnplanned;
  }

  /** Whether the motion of what is asked for is still to come. */
  get isAwaited() {
    return this.#isRequested || this.#isUnplanned;
  }

  /** Why it will not come; empty while it may. */
  get failure() {
    return this.isAwaited ? this.#failure : '';
  }

  /** Another document is asked for. */
  requested() {
    if (this.#isRequested || this.#isRead) this.#end('AbortError', 'Another document took the place of the one to be played.');
    this.#isRequested = true;
    this.#failure = '';
  }

  /** It has been read, and its motion is to come. */
  opened() {
    this.#isRequested = false;
    this.#isRead = this.#isUnplanned = true;
    this.#failure = '';
  }

  /** It has been taken away. */
  emptied() {
    this.opened();
    this.#isRead = false;
  }

  /** There is nothing to be opened in its place: the one before stays. */
  requestedNothing() {
    this.#isRequested = false;
  }

  /** What was asked for, or its motion, cannot be had. @param {string} why */
  failed(why) {
    this.#isRequested = false;
    this.#failure = why;
    this.#end('NotSupportedError', why);
  }

  /** The first motion is there. */
  planned() {
    this.#isRead = true;
    this.#isUnplanned = false;
    if (!this.#isRequested) this.resolve();
  }

  /** @returns {Promise<void>} resolves when it plays */
  play() {
    const given = new Promise((resolve, reject) => this.#plays.push({ resolve: () => resolve(undefined), reject }));
    // Avoids an unhandled rejection where nobody awaits it.
    given.catch(() => {});
    return given;
  }

  /** It plays. */
  resolve() {
    for (const { resolve } of this.#plays.splice(0)) resolve();
  }

  /** @param {'AbortError' | 'NotSupportedError'} name as the media elements name it @param {string} why */
  reject(name, why) {
    for (const { reject } of this.#plays.splice(0)) reject(new DOMException(why, name));
  }

  /** @param {'AbortError' | 'NotSupportedError'} name @param {string} why */
  #end(name, why) {
    this.reject(name, why);
    this.#stop();
  }
}
