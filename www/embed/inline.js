/**
 * The one script that loads nothing: defines the element, and in the page for frames, which marks it with `data-frame`,
 * makes that page's linkage. A frame in a sandbox may load no modules.
 */
import { startFrame } from './frame.js';

export { SyntheticaLinkage } from '../element/element.js';

if (document.currentScript?.hasAttribute('data-frame')) startFrame();
