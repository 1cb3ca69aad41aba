/**
 * What type a mechanism is, by the paper's tables: its assembly category, and how many assemblies share it. No DOM.
 *
 * @typedef {import('../../pkg/synthetica.js').Enumeration} Enumeration
 */

const NUMERALS = ['I', 'II', 'III', 'IV'];

/** Thousands apart, as the paper prints them. @param {number} count */
export const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

/**
 * The assembly category in Table 3's words: 3I, 2I-1II; null where a chain is in none of the four categories.
 * @param {{constraints: number}[]} chains
 */
export function assemblyName(chains) {
  if (chains.some(({ constraints }) => constraints < 1 || constraints > 4)) return null;
  const parts = NUMERALS.map((numeral, index) => [chains.filter(({ constraints }) => constraints === index + 1).length, numeral]);
  return parts.filter(([count]) => count).map(([count, numeral]) => `${count}${numeral}`).join('-');
}

/**
 * A linkage of an assembly of Table 3, as text: 2I-1II is 2E+1TS, say, by a chain type for each category.
 * @param {string} assembly @param {Enumeration['classes']} classes @param {string[]} preferred types that are taken where they fit
 */
export function linkageOfAssembly(assembly, classes, preferred) {
  const parts = [...assembly.matchAll(/(\d+)(IV|I{1,3})/g)];
  return parts
    .map(([, count, numeral]) => {
      const fitting = classes.filter(({ category }) => category === numeral).flatMap(({ chains }) => chains);
      return `${count}${preferred.find((type) => fitting.includes(type)) ?? fitting[0]}`;
    })
    .join('+');
}

/**
 * The mechanism's place in Tables 2 and 3, in a sentence.
 * @param {{type: string, constraints: number}[]} chains
 * @param {Enumeration} tables
 */
export function typeSentence(chains, { assemblies }) {
  const odd = chains.find(({ constraints }) => constraints < 1 || constraints > 4);
  if (odd) return `This linkage is in neither table: a chain ${odd.type} takes away ${odd.constraints} freedoms; the tables list chains that take away one to four.`;
  const total = chains.reduce((sum, { constraints }) => sum + constraints, 0);
  const name = assemblyName(chains);
  const row = assemblies.find(({ constraints }) => constraints === total);
  const category = row?.categories.find((candidate) => candidate.name === name);
  if (!row || !category) return `This linkage is of type ${name} with ${total} constraints: more than the five that leave a freedom by count, so Table 3 does not list it.`;
  const constraints = total === 1 ? 'one constraint' : `${total} constraints`;
  return `This linkage is of type ${name}: one of ${grouped(category.count)} such assemblies, of ${grouped(row.total)} with ${constraints}.`;
}
