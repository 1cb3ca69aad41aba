/**
 * What other pages load: one script with a stable name that defines <synthetica-linkage>. The pieces that it imports have
 * names of their own, which change with their content.
 */
import './define.js';

export { SyntheticaLinkage } from './element.js';
