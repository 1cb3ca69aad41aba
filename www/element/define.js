/**
 * Defines <synthetica-linkage>, and nothing else.
 */
import { SyntheticaLinkage } from './element.js';

const registry = globalThis.customElements;
if (registry && !registry.get('synthetica-linkage')) registry.define('synthetica-linkage', SyntheticaLinkage);
