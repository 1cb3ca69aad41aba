/**
 * The view's legend in pictures of it: its lines as the style sheet has them, laid out in rows at the foot of a picture of any size.
 *
 * @typedef {object} Line
 * @property {string} text
 * @property {string} colour of its sample
 * @property {number} thick in CSS pixels
 * @property {number[]} dashes
 */
import { element } from '../ui/dom.js';
import { render } from '../ui/render.js';
import { legendItems } from '../view3d/legend.js';

/** In CSS pixels: text, a row, a sample of a line, the space after it and between two entries, the box's edge and its distance from the picture's. */
const TEXT = 11.5;
const ROW = 18;
const SAMPLE = 20;
const AFTER = 5;
const BETWEEN = 12;
const PADDING = 7;
const MARGIN = 8;

/** @param {Pick<import('../element/workbench.js').App, 'store' | 'scene'>} app @returns {Line[]} */
export function legendLines({ store, scene }) {
  if (!scene) return [];
  // A list as the view's own, which may be folded: only one that is in the page tells how its lines look.
  const list = element('ul', { class: 'legend', 'aria-hidden': 'true' });
  Object.assign(list.style, { position: 'absolute', visibility: 'hidden' });
  render(legendItems({ store, scene }), list);
  scene.canvas.after(list);
  const lines = [...list.querySelectorAll('li')].map((item) => {
    // A line is a surface or, where it is dashed, a border.
    const { height, backgroundColor, borderTopWidth, borderTopColor, borderTopStyle } = getComputedStyle(item, '::before');
    const full = borderTopStyle === 'none';
    const thick = parseFloat(full ? height : borderTopWidth);
    const dashes = { dotted: [thick, thick], dashed: [3 * thick, 2 * thick] }[borderTopStyle] ?? [];
    return { text: item.textContent ?? '', colour: full ? backgroundColor : borderTopColor, thick, dashes };
  });
  list.remove();
  return lines;
}

/**
 * Where the entries stand: in rows, as many beside each other as the picture's width has room for.
 * @param {Line[]} lines
 * @param {{width: number, height: number}} picture in CSS pixels
 * @param {(text: string) => number} widthOf
 * @returns {{box: {x: number, y: number, width: number, height: number}, entries: (Line & {x: number, y: number})[]}} `y` is the middle of its row
 */
export function layLegend(lines, { width, height }, widthOf) {
  const room = width - 2 * (MARGIN + PADDING);
  let [x, row, widest] = [0, 0, 0];
  const entries = lines.map((line) => {
    const wide = SAMPLE + AFTER + widthOf(line.text);
    if (x > 0 && x + wide > room) [x, row] = [0, row + 1];
    const at = x;
    x += wide + BETWEEN;
    widest = Math.max(widest, x - BETWEEN);
    return { ...line, x: MARGIN + PADDING + at, y: row };
  });
  const rows = lines.length ? row + 1 : 0;
  const box = { x: MARGIN, y: height - MARGIN - rows * ROW - 6, width: widest + 2 * PADDING, height: rows * ROW + 6 };
  return { box, entries: entries.map((entry) => ({ ...entry, y: box.y + 3 + (entry.y + 0.5) * ROW })) };
}

/** How much of a picture's height the legend takes. @param {Line[]} lines @param {{width: number, height: number}} picture @param {(text: string) => number} widthOf */
export const legendHeight = (lines, picture, widthOf) => (lines.length ? picture.height - layLegend(lines, picture, widthOf).box.y : 0);

/** @param {string} font of the view */
export const legendFont = (font) => font.replace(/^\S+/, `${TEXT}px`);

/**
 * @param {CanvasRenderingContext2D} pen scaled to CSS pixels
 * @param {Line[]} lines
 * @param {{width: number, height: number}} picture
 * @param {{font: string, ink: string, paper: string}} style
 */
export function drawLegend(pen, lines, picture, { font, ink, paper }) {
  if (!lines.length) return;
  pen.save();
  pen.font = legendFont(font);
  pen.textBaseline = 'middle';
  const { box, entries } = layLegend(lines, picture, (text) => pen.measureText(text).width);
  pen.fillStyle = paper;
  pen.beginPath();
  pen.roundRect(box.x, box.y, box.width, box.height, 4);
  pen.fill();
  for (const { x, y, text, colour, thick, dashes } of entries) {
    pen.strokeStyle = colour;
    pen.lineWidth = thick;
    pen.setLineDash(dashes);
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + SAMPLE, y);
    pen.stroke();
    pen.fillStyle = ink;
    pen.fillText(text, x + SAMPLE + AFTER, y);
  }
  pen.restore();
}

/** The same as shapes of an SVG drawing. @param {Line[]} lines @param {{width: number, height: number}} picture @param {(text: string) => number} widthOf @param {{ink: string, paper: string}} style `paper` as attributes @param {(text: string) => string} escaped */
export function legendShapes(lines, picture, widthOf, { ink, paper }, escaped) {
  if (!lines.length) return [];
  const { box, entries } = layLegend(lines, picture, widthOf);
  const dashed = (/** @type {number[]} */ dashes) => (dashes.length ? ` stroke-dasharray="${dashes.join(' ')}"` : '');
  return [
    `<g id="legend" font-size="${TEXT}">`,
    `<rect x="${box.x}" y="${box.y}" width="${box.width.toFixed(1)}" height="${box.height}" rx="4" ${paper}/>`,
    ...entries.flatMap(({ x, y, text, colour, thick, dashes }) => [
      `<path d="M${x.toFixed(1)} ${y}h${SAMPLE}" stroke="${colour}" stroke-width="${thick}"${dashed(dashes)}/>`,
      `<text x="${(x + SAMPLE + AFTER).toFixed(1)}" y="${y + 4}" fill="${ink}">${escaped(text)}</text>`,
    ]),
    '</g>',
  ];
}
