/**
 * The element and the planner in one script, which loads nothing. Imported, it gives all functions of the package and the
 * element's class; imported or as a plain script (`inline.js`) it leaves them in a global `synthetica`.
 */
export * from './index.js';
export { SyntheticaLinkage } from './element.js';

declare global {
  var synthetica: typeof import('./index.js') & Pick<typeof import('./element.js'), 'SyntheticaLinkage'>;
}
