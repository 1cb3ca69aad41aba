/**
 * What undo takes back: a posture by hand first, then the last edit.
 *
 * @typedef {import('./store.js').Store} Store
 */

/** Whether the linkage stands where a hand has moved it, and not where an iterate of the planner is. @param {Pick<Store, 'view'>} store */
export const movedByHand = ({ view: { posture } }) => posture !== null && posture.note === undefined;

/** What came last goes first: a posture that a hand has moved to is no edit, and is shown until the motion is. @param {Store} store */
export function undoOne(store) {
  if (movedByHand(store)) store.setView({ posture: null });
  else store.undo();
}
