/**
 * The pieces of an element that are loaded when they are first needed. A page that needs them at once puts them here, so that
 * they come with it and not after it.
 */
export const pieces = {
  workbench: () => import('./workbench.js'),
  guest: () => import('./guest.js'),
  panels: () => import('./panels.js'),
};
