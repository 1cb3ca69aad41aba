/**
 * The element and the planner in one script. It exports nothing: to import a part is what the other entries are for. As a
 * plain script it leaves a global `synthetica` with all functions of the package and the element's class.
 */
import './element.js';

declare global {
  var synthetica: typeof import('./index.js') & Pick<typeof import('./element.js'), 'SyntheticaLinkage'>;
}
