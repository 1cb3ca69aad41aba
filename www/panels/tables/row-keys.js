/**
 * Keys for the rows of a list, by which a rendering finds each row's nodes again after an edit: the items have no names of
 * their own.
 */

/**
 * @template T
 * @param {(item: T) => unknown} [identity] what of an item says that it is the same one; the whole item unless told
 * @returns {(items: T[]) => number[]} the keys of a list, given after every edit
 */
export function createRowKeys(identity = (item) => item) {
  /** @type {T[]} */
  let items = [];
  /** @type {number[]} */
  let keys = [];
  let made = 0;

  return (next) => {
    if (next === items) return keys;
    /** Places of the former rows that no row has been found for. */
    const free = new Set(items.keys());
    /** @type {(number | undefined)[]} */
    const found = next.map(() => undefined);
    /** @param {(item: T, index: number) => number | undefined} former */
    const match = (former) =>
      next.forEach((item, index) => {
        const at = found[index] === undefined ? former(item, index) : undefined;
        if (at !== undefined && free.delete(at)) found[index] = keys[at];
      });
    // An edit keeps the objects that it does not change; what it writes anew may say the same; else a row that is changed
    // stays where it is.
    match((item, index) => (items[index] === item ? index : undefined));
    const finder = (/** @type {(item: T) => unknown} */ nameOf) => {
      /** The free rows of each name, in their order. @type {Map<unknown, number[]>} */
      const named = new Map();
      for (const at of free) {
        const name = nameOf(items[at]);
        const others = named.get(name);
        if (others) others.push(at);
        else named.set(name, [at]);
      }
      return (/** @type {T} */ item) => named.get(nameOf(item))?.shift();
    };
    match(finder((item) => item));
    if (free.size) match(finder((item) => JSON.stringify(identity(item))));
    match((_, index) => index);
    [items, keys] = [next, found.map((key) => key ?? ++made)];
    return keys;
  };
}
