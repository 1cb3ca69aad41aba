/**
 * A linkage that lives: its document, its planner, what was planned and the playhead. Draws nothing.
 *
 * @typedef {object} Parts
 * @property {import('./store.js').Store} store
 * @property {Planner} planner
 * @property {Player} player
 * @property {import('../ui/notice.js').Say} say speaks to the person
 * @property {import('../ui/notice.js').Say} tell what `say` uses; the view sets it to show notices
 *
 * @typedef {ReturnType<typeof createLinkage>} Linkage
 */
import { NOTHING } from './nothing.js';
import { createOpening } from './open.js';
import { Planner } from '../planner/planner.js';
import { Player } from './player.js';
import { createReplanning } from './replan.js';
import { createStore } from './store.js';

export function createLinkage() {
  const planner = new Planner();
  const store = createStore(NOTHING);
  const player = new Player(store);
  /** @type {Parts} */
  const parts = {
    store,
    planner,
    player,
    tell: (text) => console.info(text),
    say: (text, action) => parts.tell(text, action),
  };
  const linkage = Object.assign(parts, createReplanning(parts), createOpening(parts));
  let interrupted = false;
  return Object.assign(linkage, {
    /** Nobody looks at it any more: what it asked is taken back. */
    leave() {
      interrupted = planner.leave();
    },
    /** Plans what was interrupted, unless that is of another document by now and planned. */
    resume() {
      const { motion, doc } = store.result;
      if (interrupted && (doc !== store.doc || motion?.partial)) linkage.replan();
      interrupted = false;
    },
  });
}
