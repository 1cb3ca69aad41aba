/**
 * Composition of the applet: a linkage element with all its panels, and around it what is done with documents.
 */
import './pieces-at-once.js';
import '../element/define.js';
import { byId } from '../ui/dom.js';
import { createExport } from '../export/menu.js';
import { createAutosave } from './files/autosave.js';
import { createDocuments } from './files/documents.js';
import { createKeeper } from './files/browser-storage.js';
import { start } from './files/start.js';
import { createHelp } from './help/help.js';
import { workOffline } from './offline.js';
import { createDrop } from './drop.js';
import { createHeader } from './header.js';
import { createHistory } from './history.js';

/** @type {import('../element/element.js').SyntheticaLinkage} */
const element = byId('linkage');
const { parts: linkage } = element;
// All scripts are here: see public/first.js.
byId('start-note').remove();
const keeper = createKeeper(() => localStorage, Math.random().toString(36).slice(2));

// What it shows comes from the start, however long that waits for the planner.
element.document = null;
// Both need the planner, and neither the other.
const [app] = await Promise.all([element.workbench, start(linkage, keeper)]);
if (!matchMedia('(prefers-reduced-motion: reduce)').matches) linkage.player.play();
createHistory(linkage.store);
const documents = createDocuments(app);
createHeader(app, documents, keeper);
createDrop(documents, linkage.open);
createExport(app);
createHelp(app);
createAutosave(linkage, keeper);
// Until here nothing in it would have answered.
/** @type {HTMLElement} */ (byId('menus').parentElement).inert = false;
workOffline();
