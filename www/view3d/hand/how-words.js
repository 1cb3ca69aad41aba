/**
 * How the thing in hand is moved, in words for screen readers: what a key or a button of the move bar did.
 */
import { plural } from '../../core/format.js';

/** @param {import('./toolbar.js').How} how @param {unknown[] | null} freedoms of the workpiece; null: it has none, or they are not known yet */
export function howWords({ mode, space, snap }, freedoms) {
  if (mode === 'freedoms') return freedoms ? `Freedoms: the workpiece moves along ${plural(freedoms.length, 'freedom')} here.` : 'Freedoms: the workpiece moves along those that exist here.';
  const axes = space === 'world' ? 'the axes of the world' : 'its own axes';
  return `${mode === 'turn' ? 'Turn: about' : 'Move: along'} ${axes}${snap ? ', in round steps' : ''}.`;
}
