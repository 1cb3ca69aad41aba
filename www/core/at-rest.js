/**
 * Listeners that may wait while a hand moves something: what is read, not what follows the hand. They hear of the last state
 * when the hand rests or lets go.
 *
 * @typedef {import('./store.js').Store} Store
 */

/**
 * @param {Pick<Store, 'subscribe' | 'view'>} store
 * @param {('document' | 'result' | 'view')[]} parts of the state
 * @param {() => void} listener
 * @param {() => void} [meanwhile] what is done in its place while a hand moves
 */
export function atRest(store, parts, listener, meanwhile = () => {}) {
  let missed = false;
  /** @param {boolean} is whether there is something to hear of */
  const look = (is) => {
    missed ||= is;
    if (!missed) return;
    if (store.view.moving) return is ? meanwhile() : undefined;
    missed = false;
    listener();
  };
  for (const part of parts) store.subscribe(part, () => look(true));
  // It tells when a hand begins and ends too.
  if (!parts.includes('view')) store.subscribe('view', () => look(false));
}
