/**
 * The joint values of a way to assemble in words: where only joints are turned over, as universal joints are, pictures of the ways are
 * alike. Only what differs from way to way. Knows no DOM.
 *
 * @typedef {import('../../core/types.js').Mode} Mode
 */
import { chainName } from '../../core/chain-name.js';
import { angle, short } from '../../core/format.js';

/** More values than these are no words any more, of a hexapod's legs, say: only the chains are named. */
const MOST = 12;

/** Values that are nearer are the same, rad or lengths as a share of the largest. */
const SAME = 1e-3;

/** @param {Mode[]} ways @param {number} index of a joint value */
function differs(ways, index) {
  const values = ways.map(({ joints }) => joints[index]);
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-9);
  return values.some((value) => Math.abs(value - values[0]) > SAME * Math.max(1e-3, Math.min(1, largest)));
}

/**
 * Of many values: in which chains they are others than the document's start has.
 * @param {Mode} mode @param {Mode[]} ways @param {import('../../core/types.js').Motion['report']['chains']} chains
 * @returns {string[]} none for that itself, or where it is not among the ways
 */
function otherChains(mode, ways, chains) {
  const start = ways.find(({ is_start }) => is_start);
  if (!start || mode === start) return [];
  let first = 0;
  const names = chains.flatMap((chain, number) => {
    const own = chain.variables.map((_, i) => first + i);
    first += own.length;
    return own.some((index) => differs([start, mode], index)) ? [chainName(chain, number)] : [];
  });
  return names.length ? [`from the document’s start it differs in ${names.join(', ')}`] : [];
}

/**
 * A line for each chain.
 * @param {Mode} mode @param {Mode[]} ways all of them @param {import('../../core/types.js').Motion['report']['chains']} chains
 * @returns {string[]}
 */
export function jointLines(mode, ways, chains) {
  let first = 0;
  let count = 0;
  const lines = chains.flatMap((chain, number) => {
    const { variables } = chain;
    const values = variables.flatMap(({ unit, label }, i) => {
      const index = first + i;
      if (!differs(ways, index)) return [];
      const value = mode.joints[index];
      return [`${label} ${unit === 'rad' ? angle(value, 1) : short(value, 3)}`];
    });
    first += variables.length;
    count += values.length;
    return values.length ? [`${chainName(chain, number)}: ${values.join(', ')}`] : [];
  });
  return count > MOST ? otherChains(mode, ways, chains) : lines;
}
