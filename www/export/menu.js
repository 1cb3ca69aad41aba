/**
 * The Export menu.
 */
import { byId } from '../ui/dom.js';
import { loaded } from '../ui/lazy.js';
import { menuButton } from '../ui/menu.js';

/** @param {import('../element/workbench.js').App} app */
export function createExport(app) {
  byId('menus').append(menuButton('Export', async () => (await loaded(app, 'What can be exported', () => import('./items.js'))).exportItems(app)));
}
