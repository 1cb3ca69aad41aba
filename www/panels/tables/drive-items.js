/**
 * What the menu of a joint offers for driving it: one entry for each of its variables.
 */
import { driverIndex } from '../../core/driven.js';
import { chainVariables, variableName } from '../../core/joint-types.js';

/**
 * @param {import('../../core/store.js').Store} store
 * @param {ReturnType<typeof import('./forms.js').createForms>} forms
 * @param {number} chain @param {number} joint
 */
export const driveItems = (store, forms, chain, joint) =>
  chainVariables(store.doc.chains[chain])
    .filter((one) => one.joint === joint)
    .map(({ variable, freedom, row }) => ({
      label: `Drive ${variableName(variable, row)}`,
      disabled: driverIndex(store.doc, { chain, joint, freedom }) < 0 ? '' : 'It is driven already',
      act: () => forms.driveJoint({ chain, joint, freedom }),
    }));
