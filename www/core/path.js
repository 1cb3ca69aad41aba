/**
 * Paths into a document, in the form that Rust's faults use: `chains[1].joints[0].rows[0].alpha`.
 */

/** Paths already taken apart: the tables ask for the same ones at every edit. @type {Map<string, readonly (string | number)[]>} */
const known = new Map();

/** @param {string} path @returns {readonly (string | number)[]} */
export function parsePath(path) {
  const keys = known.get(path) ?? Array.from(path.matchAll(/([^.[\]]+)|\[(\d+)\]/g), ([, name, index]) => name ?? Number(index));
  known.set(path, keys);
  return keys;
}

/** @param {any} root @param {string} path @returns {any} undefined where the path leads nowhere */
export function valueAt(root, path) {
  return parsePath(path).reduce((value, key) => value?.[key], root);
}

/**
 * A copy of `root` with `value` at `path`; everything off the path is shared, missing places are made.
 * @template T
 * @param {T} root
 * @param {string} path
 * @param {unknown} value undefined removes the place
 * @returns {T}
 */
export function withValueAt(root, path, value) {
  /** @param {any} node @param {readonly (string | number)[]} keys @returns {any} */
  const put = (node, [key, ...rest]) => {
    if (key === undefined) return value;
    /** @type {any} */
    const copy = Array.isArray(node) ? [...node] : node ? { ...node } : typeof key === 'number' ? [] : {};
    const next = put(node?.[key], rest);
    if (next === undefined) delete copy[key];
    else copy[key] = next;
    return copy;
  };
  return put(root, parsePath(path));
}

/**
 * How well a container's path covers a fault's: its length if it is the same place or above it, else -1.
 * @param {string} container
 * @param {string} place
 */
export function covers(container, place) {
  if (container === place) return container.length;
  const next = place[container.length];
  return place.startsWith(container) && (next === '.' || next === '[' || container === '') ? container.length : -1;
}
