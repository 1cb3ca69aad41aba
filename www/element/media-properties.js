/**
 * What <synthetica-linkage> has in common with the media elements: their words, and its attributes as properties.
 */
import { createLinkage } from '../core/linkage.js';
import { MEANINGS, WRITINGS, write } from './attributes.js';

/** A server that renders pages may load the class, and has no elements. */
const Base = globalThis.HTMLElement ?? class {};

export class LinkageWords extends Base {
  /** Its state, its planner and its playhead: for the applet, which is built around this element. */
  parts = createLinkage();

  // --- the media element's words ---

  play() {
    this.parts.player.play();
  }

  pause() {
    this.parts.player.pause();
  }

  get paused() {
    return this.parts.player.paused;
  }

  /** From the first frame: seconds, or parts of the way from 0 to 1 where the key frames name no times. */
  get currentTime() {
    return this.parts.player.currentTime;
  }

  set currentTime(time) {
    this.parts.player.currentTime = Number(time) || 0;
  }

  get duration() {
    return this.parts.player.duration;
  }

  // --- attributes as properties ---

  get src() {
    return this.getAttribute('src') ?? '';
  }

  set src(address) {
    this.setAttribute('src', address);
  }

  get type() {
    return this.getAttribute('type') ?? '';
  }

  set type(name) {
    this.setAttribute('type', name);
  }

  get controls() {
    return this.hasAttribute('controls');
  }

  set controls(on) {
    this.toggleAttribute('controls', on);
  }

  get autoplay() {
    return this.hasAttribute('autoplay');
  }

  set autoplay(on) {
    this.toggleAttribute('autoplay', on);
  }

  get readonly() {
    return this.hasAttribute('readonly');
  }

  set readonly(on) {
    this.toggleAttribute('readonly', on);
  }

  /** At the end: `once`, `loop` or `bounce`. */
  get loop() {
    return this.parts.player.loop;
  }

  set loop(loop) {
    write(this, 'loop', WRITINGS.loop(MEANINGS.loop(typeof loop === 'boolean' ? (loop ? '' : null) : String(loop))));
  }

  /** Counted from 0, as in the columns. */
  get frame() {
    return this.parts.player.frame;
  }

  set frame(frame) {
    this.parts.player.frame = MEANINGS.frame(String(frame));
  }

  /** A factor: 2 is twice as fast. */
  get speed() {
    return this.parts.player.playbackRate;
  }

  set speed(speed) {
    write(this, 'speed', WRITINGS.speed(MEANINGS.speed(String(speed))));
  }

  /** The standard view, such as `front`; empty for any other. */
  get view() {
    return this.parts.store.view.side;
  }

  set view(side) {
    write(this, 'view', WRITINGS.view(MEANINGS.view(String(side ?? ''))));
  }

  /** `light`, `dark`, `auto` for the system's; empty for the page's own. */
  get theme() {
    return this.getAttribute('theme') ?? '';
  }

  set theme(theme) {
    write(this, 'theme', MEANINGS.theme(String(theme ?? '')) || null);
  }

  /** Names with blanks between them: mechanism motion teach types info charts algorithm. */
  get panels() {
    return this.getAttribute('panels') ?? '';
  }

  set panels(names) {
    write(this, 'panels', MEANINGS.panels(String(names ?? '')).join(' ') || null);
  }
}
