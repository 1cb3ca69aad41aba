/**
 * A link as a QR code (ISO/IEC 18004), to be taken over by a phone.
 */
import { correction, generate, mode } from 'lean-qr';

/** Bytes that the largest one holds, version 40 of the level L. */
export const MOST = 2953;

/** Empty modules around it, which the standard asks for. */
const QUIET = 4;

/** CSS pixels: the least of the picture's side and of a module's, which has a whole number of them. */
const LEAST = 180;
const MODULE = 3;

/** @param {string} text @returns {boolean[][]} its modules, row by row, dark ones true */
export function qrModules(text) {
  // Plain bytes, as every reader knows them; the level M where it takes no more modules.
  const code = generate(mode.bytes(new TextEncoder().encode(text)), { minCorrectionLevel: correction.L, maxCorrectionLevel: correction.M });
  const along = Array.from({ length: code.size }, (_, at) => at);
  return along.map((y) => along.map((x) => code.get(x, y)));
}

/** Dark on white in every colour scheme: some readers know no other. @param {string} text @param {string} name @returns {SVGSVGElement} */
export function qrPicture(text, name) {
  const modules = qrModules(text);
  const side = modules.length + 2 * QUIET;
  const make = (/** @type {string} */ tag, /** @type {Record<string, string | number>} */ attributes, /** @type {Element[]} */ ...children) => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    made.append(...children);
    return made;
  };
  const dark = modules.flatMap((row, y) => row.flatMap((on, x) => (on ? [`M${x + QUIET} ${y + QUIET}h1v1h-1z`] : []))).join('');
  const size = side * Math.max(MODULE, Math.ceil(LEAST / side));
  const picture = make(
    'svg',
    { class: 'qr', role: 'img', 'aria-label': name, viewBox: `0 0 ${side} ${side}`, width: size, height: size, 'shape-rendering': 'crispEdges' },
    make('rect', { width: side, height: side, fill: '#fff' }),
    make('path', { d: dark, fill: '#000' }),
  );
  return /** @type {SVGSVGElement} */ (picture);
}
