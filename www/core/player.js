/**
 * The playhead, in the media element's language, and its animation loop, which draws only when something changed and
 * somebody sees it.
 *
 * @typedef {import('./playhead.js').Loop} Loop
 * @typedef {import('./store.js').Store} Store
 * @typedef {'timeupdate' | 'seeking' | 'seeked' | 'ended'} Told
 */
import { FirstMotion } from './first-motion.js';
import { advance, frameAt, isTimed } from './playhead.js';

/** Seconds that a motion without times takes from its first to its last key frame. */
const UNTIMED_SECONDS = 5;

/** How long what a hand has moved waits for the planner's answer to be drawn with it, in milliseconds. */
const ANSWER = 50;

/** Longest step of the playhead in milliseconds; after a pause of the page it goes on where it was. */
const MAX_STEP = 100;

export class Player {
  #store;
  /** What a picture is made by. */
  draw = () => {};
  /** Before the first motion of a document `play()` waits for that. */
  first = new FirstMotion(() => this.#store.setView({ playing: false }));
  /** Who hears what the store's state does not say. */
  tell = (/** @type {Told} */ _name) => {};
  #request = 0;
  #dirty = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #soon;
  #last = 0;
  #forwards = true;
  /** Playhead in the motion's own time. */
  #time = 0;
  /** First and last time of the motion that the playhead was set in. @type {[number, number]} */
  #span = [0, 0];

  /** Out of sight nothing is drawn, and the playhead waits. */
  #seen = true;

  #seeking = false;

  /** @param {Store} store */
  constructor(store) {
    this.#store = store;
    store.subscribe('result', () => {
      const { motion, doc, fault } = store.result;
      if (this.first.isUnplanned && doc === store.doc && motion) this.#begin();
      else if (this.first.isUnplanned && !this.first.isRequested && fault) this.first.failed(fault.message);
      this.#keepPlace();
    });
  }

  /** The window in which it is seen. */
  #window = globalThis;

  /** @param {typeof globalThis} window whose pictures are drawn: of one that is hidden or closed none come */
  set window(window) {
    if (window === this.#window) return;
    if (this.#request) this.#window.cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#window = window;
    this.#schedule();
  }

  /** @param {boolean} seen whether there is anybody to draw for */
  set seen(seen) {
    this.#seen = seen;
    this.#schedule();
  }

  get paused() {
    return !this.#store.view.playing;
  }

  /** Whether it is at its end, where it stays. */
  get ended() {
    return !this.first.isAwaited && this.loop === 'once' && this.#time >= this.#range()[1];
  }

  get seeking() {
    return this.#seeking;
  }

  get duration() {
    const [from, to] = this.#range();
    return to - from;
  }

  get currentTime() {
    return this.#time - this.#range()[0];
  }

  set currentTime(time) {
    const [from, to] = this.#range();
    this.#seek(Math.min(to, Math.max(from, from + time)));
  }

  /** A factor: 2 is twice as fast. */
  get playbackRate() {
    return this.#store.view.speed;
  }

  set playbackRate(speed) {
    this.#store.setView({ speed });
  }

  /** What happens at the end. */
  get loop() {
    return this.#store.view.loop;
  }

  set loop(loop) {
    this.#forwards = true;
    this.#store.setView({ loop });
  }

  get frame() {
    return this.#store.view.frame;
  }

  /** The nearest that there is: ±Infinity for the last and the first. */
  set frame(frame) {
    const motion = this.#store.result.motion;
    if (!motion) return;
    this.#seek(motion.time[Math.min(motion.frames - 1, Math.max(0, Math.round(frame)))]);
  }

  /** @returns {Promise<void>} resolves when it plays, after the first motion if need be; else rejects with what prevents it */
  play() {
    const { first } = this;
    const given = first.play();
    if (first.failure) first.reject('NotSupportedError', first.failure);
    else {
      // Played to its end it begins anew.
      if (this.ended) this.#time = this.#range()[0];
      this.#store.setView({ playing: true, posture: null });
      if (!first.isAwaited) first.resolve();
      this.#schedule();
    }
    return given;
  }

  pause() {
    this.first.reject('AbortError', 'It was paused before it played.');
    this.#store.setView({ playing: false });
  }

  /** Something that is drawn has changed. */
  invalidate() {
    this.#dirty = true;
    this.#schedule();
  }

  /** The same, but what changes next is awaited for a moment: one picture shows both. */
  invalidateSoon() {
    this.#soon ??= setTimeout(() => this.invalidate(), ANSWER);
  }

  /** Seconds that one pass takes at the present speed. */
  get passSeconds() {
    return (isTimed(this.#store.result.doc) ? this.duration : UNTIMED_SECONDS) / this.playbackRate;
  }

  get #plays() {
    return !this.paused && !this.first.isAwaited;
  }

  #schedule() {
    const busy = this.#dirty || this.#plays;
    if (busy && !this.#request && this.#seen) this.#request = this.#window.requestAnimationFrame((now) => this.#step(now));
    if (!busy) this.#last = 0;
  }

  /** @param {number} now */
  #step(now) {
    this.#request = 0;
    if (this.#plays) this.#advance(Math.min(MAX_STEP, this.#last ? now - this.#last : 0) / 1000);
    this.#last = this.paused ? 0 : now;
    if (this.#dirty) {
      this.#dirty = false;
      clearTimeout(this.#soon);
      this.#soon = undefined;
      this.draw();
    }
    this.#schedule();
  }

  /** @param {number} seconds */
  #advance(seconds) {
    const [from, to] = this.#range();
    const rate = isTimed(this.#store.result.doc) ? 1 : (to - from) / UNTIMED_SECONDS;
    const at = { time: this.#time, forwards: this.#forwards };
    const { time, forwards, ended } = advance(at, seconds * this.playbackRate * rate, { from, to, loop: this.loop });
    this.#time = time;
    this.#forwards = forwards;
    const frame = this.#frameAt(time);
    if (frame !== this.frame) {
      this.#dirty = true;
      this.#store.setView({ frame });
      this.tell('timeupdate');
    }
    // Who was told may have set it elsewhere.
    if (!ended || this.paused || !this.ended) return;
    this.#store.setView({ playing: false });
    this.tell('ended');
  }

  /** @param {number} time of the motion */
  #seek(time) {
    this.#time = time;
    this.#store.setView({ frame: this.#frameAt(time), posture: null });
    this.invalidate();
    if (!this.#store.result.motion) return;
    this.tell('seeking');
    if (this.#seeking) return;
    this.#seeking = true;
    // Several in one go are one.
    queueMicrotask(() => {
      this.#seeking = false;
      this.tell('timeupdate');
      this.tell('seeked');
    });
  }

  /** The first motion of a document: from its start. */
  #begin() {
    this.#span = this.#range();
    this.#time = this.#span[0];
    this.#forwards = true;
    this.first.planned();
  }

  /** A new motion: the same moment of it. */
  #keepPlace() {
    const motion = this.#store.result.motion;
    if (!motion) return;
    const [from, to] = this.#range();
    const [oldFrom, oldTo] = this.#span;
    const share = oldTo > oldFrom ? (this.#time - oldFrom) / (oldTo - oldFrom) : 0;
    this.#span = [from, to];
    this.#time = from + share * (to - from);
    this.#store.setView({ frame: this.#frameAt(this.#time) });
    this.invalidate();
  }

  /** @returns {[number, number]} */
  #range() {
    const time = this.#store.result.motion?.time;
    return time?.length ? [time[0], time[time.length - 1]] : [0, 0];
  }

  /** @param {number} time */
  #frameAt(time) {
    return frameAt(this.#store.result.motion?.time ?? [0], time);
  }
}
