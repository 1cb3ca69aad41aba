/**
 * Defines <synthetica-linkage>, and nothing else.
 */
import { SyntheticaLinkage } from './element.js';

if (!customElements.get('synthetica-linkage')) customElements.define('synthetica-linkage', SyntheticaLinkage);
