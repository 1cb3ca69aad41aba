/**
 * Which points of a linkage differ from one of its ways to assemble to another. Knows no DOM.
 *
 * @typedef {import('three').Vector3} Vector3
 */

/**
 * Of the same points in each way those that are apart in at least two of them.
 * @param {Vector3[][]} ways @param {number} apart least distance @returns {Vector3[]} in all ways
 */
export function differing(ways, apart) {
  const [first, ...others] = ways.filter(({ length }) => length === ways[0].length);
  if (!others.length) return [];
  return first.flatMap((point, index) => (others.some((way) => way[index].distanceTo(point) > apart) ? [point, ...others.map((way) => way[index])] : []));
}

/** The longest edge of the box around points. @param {Vector3[]} points */
export function spanOf(points) {
  const edge = (/** @type {'x' | 'y' | 'z'} */ axis) => points.reduce((most, point) => Math.max(most, point[axis]), -Infinity) - points.reduce((least, point) => Math.min(least, point[axis]), Infinity);
  return Math.max(edge('x'), edge('y'), edge('z'));
}
