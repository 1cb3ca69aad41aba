/**
 * Changed copies of lists, and a name that no item of a list has yet.
 */

/** @template T @param {T[]} list @param {number} index @param {T[]} items */
export const insert = (list, index, ...items) => [...list.slice(0, index), ...items, ...list.slice(index)];

/** @template T @param {T[]} list @param {number} from @param {number} to */
export const moved = (list, from, to) => insert(without(list, from), to, list[from]);

/** @template T @param {T[]} list @param {number} index */
export const without = (list, index) => list.filter((_, i) => i !== index);

/**
 * Where the items of a list are in a changed one; −1 for an item that is gone. The same item twice is told apart by its order.
 * @param {unknown[]} before @param {unknown[]} after
 */
export function placesIn(before, after) {
  /** @type {Set<number>} */
  const taken = new Set();
  return before.map((item) => {
    const at = after.findIndex((other, index) => other === item && !taken.has(index));
    taken.add(at);
    return at;
  });
}

/**
 * A new name of the form "chain 4" that no item has yet.
 * @param {string} word
 * @param {{name?: string}[]} items
 */
export function freshName(word, items) {
  const taken = new Set(items.map((item) => item.name));
  let number = items.length + 1;
  while (taken.has(`${word} ${number}`)) number++;
  return `${word} ${number}`;
}

/** Characters of a name that leave room for a number: Rust accepts 100. */
const NUMBERED = 90;

/**
 * The name of a chain's copy: of "RPS 1" it is "RPS 2".
 * @param {string | undefined} name @param {{name?: string}[]} chains
 */
export const copyName = (name, chains) => freshName(name?.replace(/\s*\d+$/, '').slice(0, NUMBERED) || 'chain', chains);
