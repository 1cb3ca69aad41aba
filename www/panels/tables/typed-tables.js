/**
 * Tables of what only some documents have, loaded together.
 */
export { createAxesTable } from './axes-table.js';
export { rotationCell } from './rotation-cell.js';
export { default as look } from '../../style/axes.css?inline';
