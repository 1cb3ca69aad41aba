/**
 * The groups in which samples and makers are listed: their order, and their headings.
 */

const HEADINGS = new Map([
  ['from the paper', 'From the paper'],
  ['one freedom', 'One freedom'],
  ['parallel robots', 'Parallel robots'],
  ['overconstrained', 'Overconstrained'],
  ['arms', 'Arms and other single chains'],
]);

/**
 * Those of each group, in the order of the groups; a group that is not known comes last, and one that has none is left out.
 * @template {{group: string}} T @param {readonly T[]} all @returns {{heading: string, members: T[]}[]}
 */
export function inGroups(all) {
  const names = new Set([...HEADINGS.keys(), ...all.map(({ group }) => group)]);
  return [...names].map((name) => ({ heading: HEADINGS.get(name) ?? name, members: all.filter(({ group }) => group === name) })).filter(({ members }) => members.length);
}
