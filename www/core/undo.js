/**
 * What undo takes back: a posture by hand first, then the last edit; and the notice that offers to undo one step.
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

/**
 * Says that a step has just been made, with a way back to `former`: only while that step is the last one. Afterwards undo
 * would take something else back.
 * @param {Pick<import('./linkage.js').Parts, 'store' | 'say'>} parts
 * @param {import('./types.js').MechanismDocument} former what was shown before the step
 * @param {string} text
 */
export function sayUndo({ store, say }, former, text) {
  // What changes nothing is no step.
  if (store.history.past.at(-1) !== former) return say(text);
  say(text, {
    label: 'Undo',
    act: () => store.undo(),
    until(end) {
      const leave = store.subscribe('document', () => {
        leave();
        end();
      });
    },
  });
}
