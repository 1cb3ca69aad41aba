/**
 * What <synthetica-linkage> has in common with the media elements: their words, and its attributes as properties.
 *
 * @typedef {Exclude<import('./attributes.js').Name, 'frame' | 'speed' | 'view' | 'panels'>} Plain
 * @typedef {{[N in Plain]: ReturnType<typeof ATTRIBUTES[N]['read']>}} Reflected defined below the class, from the list
 */
import { createLinkage } from '../core/linkage.js';
import { isEmpty } from '../core/nothing.js';
import { Refusal } from '../core/refusal.js';
import { ATTRIBUTES, write } from './attributes.js';
import { createPlayhead } from './playhead.js';

/** @param {import('../core/linkage.js').Linkage} linkage */
const withPlayhead = (linkage) => Object.assign(linkage, { playhead: createPlayhead(linkage) });

/** A server that renders pages may load the class, and has no elements. */
const Base = /** @type {new () => HTMLElement & Reflected} */ (globalThis.HTMLElement ?? class {});

export class LinkageWords extends Base {
  /** Its state, its planner and its playhead: for the applet, which is built around this element. */
  parts = withPlayhead(createLinkage());

  // --- the media element's words ---

  /** @returns {Promise<void>} resolves when it plays, after the first motion if need be; else rejects with what prevents it */
  play() {
    return this.parts.player.play();
  }

  pause() {
    this.parts.player.pause();
  }

  get paused() {
    return this.parts.player.paused;
  }

  get ended() {
    return this.parts.player.ended;
  }

  get seeking() {
    return this.parts.player.seeking;
  }

  /** From the first frame: seconds, or parts of the way from 0 to 1 where the key frames name no times. */
  get currentTime() {
    return this.parts.playhead.time;
  }

  set currentTime(time) {
    const value = Number(time);
    if (!Number.isFinite(value)) throw new Refusal(`The property currentTime is “${time}”. Accepted: a number, from 0 to the duration.`);
    this.parts.playhead.time = value;
  }

  get duration() {
    return this.parts.playhead.duration;
  }

  /** How far it is: 0 without a document, 1 when that is read, 4 when its motion is there. */
  get readyState() {
    const { store, player } = this.parts;
    return player.first.isRequested || isEmpty(store) ? 0 : player.first.isAwaited ? 1 : 4;
  }

  /** The same as `speed`, by the name that the media elements have for it. */
  get playbackRate() {
    return this.speed;
  }

  set playbackRate(factor) {
    this.speed = factor;
  }

  // --- attributes whose property is not just what stands there ---

  /** Counted from 0, as in the columns. */
  get frame() {
    return this.parts.playhead.frame;
  }

  set frame(frame) {
    this.parts.playhead.frame = ATTRIBUTES.frame.read(String(frame));
  }

  /** A factor: 2 is twice as fast. */
  get speed() {
    return this.parts.player.playbackRate;
  }

  set speed(speed) {
    write(this, 'speed', ATTRIBUTES.speed.write(ATTRIBUTES.speed.read(String(speed))));
  }

  /** The standard view, such as `front`; empty for any other. */
  get view() {
    return this.parts.store.view.side;
  }

  set view(side) {
    write(this, 'view', ATTRIBUTES.view.write(ATTRIBUTES.view.read(String(side ?? ''))));
  }

  /** Names with blanks between them. */
  get panels() {
    return this.getAttribute('panels') ?? '';
  }

  set panels(names) {
    write(this, 'panels', ATTRIBUTES.panels.write(ATTRIBUTES.panels.read(String(names ?? ''))));
  }
}

for (const name of /** @type {import('./attributes.js').Name[]} */ (Object.keys(ATTRIBUTES))) {
  /** @type {import('./attributes.js').Attribute<any>} */
  const { type, read, write: written } = ATTRIBUTES[name];
  if (Object.hasOwn(LinkageWords.prototype, name)) continue;
  Object.defineProperty(LinkageWords.prototype, name, {
    configurable: true,
    enumerable: true,
    /** @this {LinkageWords} */
    get() {
      try {
        return read(this.getAttribute(name));
      } catch {
        return read(null);
      }
    },
    /** @this {LinkageWords} @param {unknown} value */
    set(value) {
      // What a framework hands over for "none" is none.
      write(this, name, written(type === 'boolean' ? Boolean(value) : read(value == null ? null : String(value))));
    },
  });
}
