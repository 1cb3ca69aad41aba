/**
 * The element <synthetica-linkage>.
 */
import type { MechanismDocument, Motion } from './types.js';

/** `where` is the place in the document; empty where the document is not at fault. */
export interface LinkageError {
  message: string;
  where: string;
  code: string;
}

export interface LinkageEventMap {
  /** The first motion of a document is there. */
  ready: CustomEvent<null>;
  /** The reader edits the document. */
  input: CustomEvent<null>;
  /** The edit is finished, and planned. */
  change: CustomEvent<null>;
  /** Another frame is shown. */
  framechange: CustomEvent<{ frame: number; time: number }>;
  play: CustomEvent<null>;
  pause: CustomEvent<null>;
  /** The document, its address or an attribute is at fault. */
  error: CustomEvent<LinkageError>;
}

export type View = '' | 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'isometric' | 'first';

export class SyntheticaLinkage extends HTMLElement {
  play(): void;
  pause(): void;
  readonly paused: boolean;
  /** From the first key frame: seconds, or parts of the way from 0 to 1 where the key frames name no times. */
  currentTime: number;
  readonly duration: number;
  /** Address of a document. */
  src: string;
  /** A sample by its name, or any type, such as `3RRS` or `RPS+2TS`. */
  type: string;
  controls: boolean;
  autoplay: boolean;
  readonly: boolean;
  /** At the end from the start again. */
  loop: boolean;
  /** There and back, with or without `loop`. */
  bounce: boolean;
  /** Counted from 0. */
  frame: number;
  /** A factor: 2 is twice as fast. */
  speed: number;
  view: View;
  /** `light`, `dark`, `auto` for the system's; empty for the page's own. */
  theme: '' | 'light' | 'dark' | 'auto';
  /** Names with blanks between them: mechanism motion teach types info charts algorithm. */
  panels: string;
  interaction: 'none' | 'ctrl' | 'full';
  keys: 'element' | 'page';
  loading: 'lazy' | 'eager';
  /** Address of a picture that stands there until the linkage does. */
  poster: string;
  /** The document as it is now, with every default; null before there is one. Give it an object, its text, or null: it waits for one. */
  get document(): MechanismDocument | null;
  set document(next: MechanismDocument | string | null);
  /** The planned motion; null before there is one. */
  readonly trajectory: Motion | null;
  readonly error: LinkageError | null;
  /** The planned motion as a table, degrees and the document's length unit. */
  toCSV(): Promise<string>;
  /** Loads and plans the motion wherever the element is; fails with what is wrong. */
  whenReady(): Promise<Motion>;
  /** A picture of the view as it is now, in CSS pixels, `scale` pixels to one of those. */
  toImage(wish?: { type?: 'png' | 'svg'; width?: number; height?: number; scale?: number }): Promise<Blob>;

  addEventListener<K extends keyof LinkageEventMap>(type: K, listener: (this: SyntheticaLinkage, event: LinkageEventMap[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  addEventListener<K extends Exclude<keyof HTMLElementEventMap, keyof LinkageEventMap>>(type: K, listener: (this: SyntheticaLinkage, event: HTMLElementEventMap[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
  removeEventListener<K extends keyof LinkageEventMap>(type: K, listener: (this: SyntheticaLinkage, event: LinkageEventMap[K]) => unknown, options?: boolean | EventListenerOptions): void;
  removeEventListener<K extends Exclude<keyof HTMLElementEventMap, keyof LinkageEventMap>>(type: K, listener: (this: SyntheticaLinkage, event: HTMLElementEventMap[K]) => unknown, options?: boolean | EventListenerOptions): void;
  removeEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | EventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'synthetica-linkage': SyntheticaLinkage;
  }
}
