/**
 * The element <synthetica-linkage>.
 */
import type { LinkageAttributes, LinkageError, LinkageEventMap } from './attributes.js';
import type { ExportOptions, MechanismDocument, Motion } from './types.js';

export type { LinkageAttributes, LinkageError, LinkageEventMap } from './attributes.js';

/** Its attributes are properties too. */
export interface SyntheticaLinkage extends LinkageAttributes {}

export class SyntheticaLinkage extends HTMLElement {
  /** Kept when it plays, after the first motion if need be; refused with an `AbortError` or a `NotSupportedError`. */
  play(): Promise<void>;
  pause(): void;
  readonly paused: boolean;
  /** Whether it is at its end, without `loop` and `bounce`. */
  readonly ended: boolean;
  readonly seeking: boolean;
  /** From the first key frame: seconds, or parts of the way from 0 to 1 where the key frames name no times. */
  currentTime: number;
  readonly duration: number;
  /** The same as `speed`. */
  playbackRate: number;
  /** 0 without a document or while another one is asked for, 1 when it is read, 4 when its motion is there. */
  readonly readyState: 0 | 1 | 4;
  /** The document as it is now, with every default; null before there is one. Give it an object or its text; null empties the element. */
  get document(): MechanismDocument | null;
  set document(next: MechanismDocument | string | null);
  /** The same as `document`, which in the text of an inline handler is the page's own. */
  get linkage(): MechanismDocument | null;
  set linkage(next: MechanismDocument | string | null);
  /** The planned motion; null until that of the document is there. */
  readonly trajectory: Motion | null;
  readonly error: LinkageError | null;
  /** The planned motion as a table, degrees and the document's length unit; `headings` says where the units stand. */
  toCSV(options?: Pick<ExportOptions, 'headings'>): Promise<string>;
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
