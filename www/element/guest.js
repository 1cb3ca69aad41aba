/**
 * What an element needs only in somebody else's page: it takes no more of pointer, wheel, fingers and keys than is its own.
 */
import { guardKeys } from '../ui/key-guard.js';
import { wear } from '../ui/style-sheets.js';
import { createInteraction } from '../view3d/interaction.js';
import look from '../style/guest.css?inline';

/** @param {import('./workbench.js').App} app */
export function createGuest(app) {
  const { root, keys, signal } = app;
  wear(root, look);
  createInteraction(app);
  if (keys === root) guardKeys(root, signal);
}
