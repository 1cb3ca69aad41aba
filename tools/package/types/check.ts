// Holds the element's declarations against its code: tsc refuses what differs.
import type { SyntheticaLinkage as Real } from '../../../www/element/element.js';
import type { SyntheticaLinkage as Declared } from './element.js';

type Words = Omit<Declared, keyof HTMLElement>;
/** What is for the applet, which is built around the element, and for the browser. */
type Inner = 'parts' | 'workbench' | 'connectedCallback' | 'adoptedCallback' | 'disconnectedCallback' | 'attributeChangedCallback';
type Undeclared = Exclude<keyof Real, keyof Declared | Inner>;

declare const real: Real;
declare const declared: Declared;

export const asDeclared: Words = real;
export const asCoded: Pick<Real, keyof Words> = declared;
export const undeclared: [Undeclared] extends [never] ? null : Undeclared = null;
