// A line for each bar: what was measured, what it may be, whether it holds.

/** @typedef {{what: string, value: number, limit: number, least?: boolean, write: (value: number) => string, more?: string}} Bar `least`: the limit is a least value */

/** @param {Bar} bar */
export const holds = ({ value, limit, least }) => (least ? value >= limit : value <= limit);

/** @param {Bar} bar */
export function print(bar) {
  const { what, value, limit, least, write, more = '' } = bar;
  const bound = `${least ? 'at least' : 'at most'} ${write(limit)}`;
  console.log(`${holds(bar) ? '  ' : '✗ '}${what.padEnd(46)} ${write(value).padStart(10)}   ${bound.padEnd(18)} ${holds(bar) ? 'holds' : 'OVER ITS BAR'}${more ? `   ${more}` : ''}`);
}

export const kilobytes = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1)} kB`;
export const milliseconds = (/** @type {number} */ ms) => `${ms.toFixed(ms < 100 ? 1 : 0)} ms`;
export const times = (/** @type {number} */ value) => `${value.toFixed(2)} ×`;
export const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(1)} %`;
export const count = (/** @type {number} */ value) => value.toFixed(0);
