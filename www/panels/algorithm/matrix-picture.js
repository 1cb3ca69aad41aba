/**
 * The matrix [A] of Eq. 21 as a picture of its blocks, its singular values as bars, and both as a table.
 *
 * @typedef {import('../../core/types.js').Matrix} Matrix
 */
import { element, setText } from '../../ui/dom.js';
import { plural, scientific, short } from '../../core/format.js';

const SVG = 'http://www.w3.org/2000/svg';
/** Entries below are zeros with rounding. */
const ZERO = 1e-14;
/** Magnitudes from palest to darkest. */
const PALE = 1e-2;
const CELL = 8;
const LEFT = 54;
/** Of a chain's name, as many as there is room for beside the picture. */
const LETTERS = 9;
const TOP = 16;
/** Where the bars of singular values end, as powers of ten. */
const LEAST = -17;
const BARS = 78;

/** @param {string} tag @param {Record<string, string | number>} attributes @param {...(Node | string)} children */
function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

/** The groups of rows and of columns, with where each begins. @param {Matrix} matrix @param {string[]} names of the chains */
export function groups({ freedoms, rows, columns }, names) {
  let first = 0;
  const chains = freedoms.map((count, i) => {
    const group = { name: names[i], first, count };
    first += count;
    return group;
  });
  return {
    columns: [...chains, { name: 'q', first, count: columns - first }],
    rows: [...freedoms.map((_, i) => ({ name: names[i], first: 6 * i, count: 6 })), { name: '|q| = 1', first: rows - 2, count: 2 }],
  };
}

/** @param {Matrix} matrix */
function rankInWords({ rows, columns, rank, singular_values: sigma, threshold }) {
  const dependent = rows - rank;
  const least = sigma[rank - 1];
  return (
    `${rows} equations in ${columns} unknowns, rank ${rank}: the null space has ${columns} − ${rank} = ${plural(columns - rank, 'direction')}.` +
    (dependent > 0 ? ` ${plural(dependent, 'equation')} ${dependent === 1 ? 'repeats' : 'repeat'} the others.` : '') +
    ` Singular values from ${scientific(sigma[0])} down to ${scientific(least)}; below ${scientific(threshold)} they would count as zero.`
  );
}

/** @param {(place: string) => void} point tells which chain is pointed at, '' for none */
export function createMatrixPicture(point) {
  const picture = svg('svg', { class: 'matrix', role: 'img', 'aria-label': 'Matrix A' });
  const bars = svg('svg', { class: 'sigmas', role: 'img', 'aria-label': 'Singular values of A' });
  const words = element('p', { class: 'muted' });
  const table = element('div', { class: 'rows', tabindex: 0, role: 'region', 'aria-label': 'Values of [A]' });
  const details = element('details', { class: 'data', toggle: () => fill() }, element('summary', {}, 'Values of [A] and σ'), table);
  /** @type {Matrix | null} */
  let shown = null;
  /** Names of the chains. @type {string[]} */
  let chains = [];

  picture.addEventListener('pointermove', (event) => {
    const chain = /** @type {Element} */ (event.target).getAttribute('data-chain');
    point(chain === null ? '' : `chains[${chain}]`);
  });
  picture.addEventListener('pointerleave', () => point(''));

  /** @param {Matrix} matrix */
  function draw(matrix) {
    const { rows, columns, values, freedoms } = matrix;
    const at = groups(matrix, chains);
    const [width, height] = [LEFT + columns * CELL + 1, TOP + rows * CELL + 1];
    picture.setAttribute('viewBox', `0 0 ${width} ${height}`);
    picture.setAttribute('aria-label', `Matrix A, ${rows} by ${columns}. Each chain’s joints move its own six rows, the workpiece q all; two more rows keep q a unit dual quaternion.`);
    const cells = [];
    for (let i = 0; i < rows; i++) {
      const chain = Math.min(Math.floor(i / 6), freedoms.length);
      for (let j = 0; j < columns; j++) {
        const size = Math.abs(values[i * columns + j]);
        if (size < ZERO) continue;
        const shade = Math.min(1, Math.max(0.2, 0.2 + 0.8 * (Math.log10(size / PALE) / 2.3)));
        const own = chain < freedoms.length;
        cells.push(
          svg('rect', {
            x: LEFT + j * CELL + 0.5, y: TOP + i * CELL + 0.5, width: CELL - 1, height: CELL - 1, 'fill-opacity': short(shade, 2),
            class: own && j < columns - 8 ? `chain-${chain % 5}` : 'of-q', ...(own && { 'data-chain': chain }),
          }),
        );
      }
    }
    const rules = [
      ...at.columns.map(({ first }) => svg('line', { x1: LEFT + first * CELL, x2: LEFT + first * CELL, y1: TOP, y2: height - 1 })),
      ...at.rows.map(({ first }) => svg('line', { x1: LEFT, x2: width - 1, y1: TOP + first * CELL, y2: TOP + first * CELL })),
    ];
    const labels = [
      ...at.columns.map(({ name, first, count }, i) =>
        svg('text', { x: LEFT + (first + count / 2) * CELL, y: TOP - 5, 'text-anchor': 'middle' }, i < freedoms.length ? `θ${subscript(i + 1)}` : name),
      ),
      ...at.rows.map(({ name, first, count }) => svg('text', { x: LEFT - 6, y: TOP + (first + count / 2) * CELL + 4, 'text-anchor': 'end' }, name.length > LETTERS ? `${name.slice(0, LETTERS - 1)}…` : name)),
    ];
    const frame = svg('rect', { class: 'frame', x: LEFT, y: TOP, width: columns * CELL, height: rows * CELL });
    picture.replaceChildren(...cells, ...rules, frame, ...labels);
    // A big matrix is scaled down to the room there is, a small one is not blown up.
    picture.setAttribute('width', String(Math.min(width * 1.25, 420)));
  }

  /** @param {Matrix} matrix */
  function drawBars({ singular_values: sigma, threshold }) {
    const step = 9;
    const width = 34 + sigma.length * step + 4;
    /** @param {number} value */
    const y = (value) => {
      const top = Math.max(1, Math.log10(sigma[0]));
      return 6 + (BARS * (top - Math.max(LEAST, Math.log10(Math.max(value, 10 ** LEAST))))) / (top - LEAST);
    };
    bars.setAttribute('viewBox', `0 0 ${width} ${BARS + 10}`);
    bars.setAttribute('width', String(Math.min(width * 1.25, 420)));
    bars.setAttribute('aria-label', `${sigma.length} singular values of A on a logarithmic scale, from ${scientific(sigma[0])} to ${scientific(sigma[sigma.length - 1])}; rank threshold at ${scientific(threshold)}.`);
    bars.replaceChildren(
      ...[1, 1e-8, 1e-16].map((tick) => svg('text', { x: 30, y: y(tick) + 3, 'text-anchor': 'end' }, tick === 1 ? '1' : tick === 1e-8 ? '10⁻⁸' : '10⁻¹⁶')),
      ...sigma.map((value, i) =>
        svg('rect', { class: value > threshold ? 'sigma' : 'sigma zero', x: 34 + i * step, width: step - 3, y: y(value), height: Math.max(1, BARS + 6 - y(value)) }, svg('title', {}, `σ${subscript(i + 1)} = ${scientific(value)}`)),
      ),
      svg('line', { class: 'threshold', x1: 32, x2: width, y1: y(threshold), y2: y(threshold) }),
    );
  }

  function fill() {
    if (!details.open || !shown) return;
    const { values, columns, singular_values: sigma } = shown;
    const at = groups(shown, chains);
    const heads = at.columns.map(({ name, count }) => element('th', { scope: 'colgroup', colspan: count }, name === 'q' ? name : `θ of ${name}`));
    const names = at.rows.flatMap(({ name, count }) => Array.from({ length: count }, (_, i) => `${name}, ${i + 1}`));
    table.replaceChildren(
      element(
        'table',
        { class: 'plain' },
        element('caption', {}, '[A] by rows'),
        element('thead', {}, element('tr', {}, element('th', { scope: 'col' }, 'row'), ...heads)),
        element(
          'tbody',
          {},
          ...names.map((name, i) =>
            element('tr', {}, element('th', { scope: 'row' }, name), ...values.slice(i * columns, (i + 1) * columns).map((value) => element('td', {}, Math.abs(value) < ZERO ? '0' : short(value, 3)))),
          ),
        ),
      ),
      element(
        'table',
        { class: 'plain' },
        element('caption', {}, 'Singular values'),
        element('tbody', {}, ...sigma.map((value, i) => element('tr', {}, element('th', { scope: 'row' }, `σ${subscript(i + 1)}`), element('td', {}, scientific(value))))),
      ),
    );
  }

  return {
    root: element('section', { class: 'block', 'aria-label': 'Matrix [A]' }, element('h3', {}, '[A] at this iterate'), picture, bars, words, details),
    /** @param {string} text */
    fail(text) {
      shown = null;
      picture.replaceChildren();
      bars.replaceChildren();
      table.replaceChildren();
      setText(words, text);
    },
    /** @param {Matrix} matrix @param {string[]} names of the chains */
    show(matrix, names) {
      shown = matrix;
      chains = names;
      draw(matrix);
      drawBars(matrix);
      setText(words, rankInWords(matrix));
      fill();
    },
  };
}

/** @param {number} n */
const subscript = (n) => String(n).replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]);
