/**
 * Which points of a linkage differ from one of its ways to assemble to another, and from which side that is seen best. Knows no DOM.
 */
import { Vector3 } from 'three';

/** Sides from which pictures may be seen beside the present one: around, and from so high, in degrees. From higher a plate hides its legs. */
const AROUND = 30;
const HIGH = [10, 25];

/** Another side must show this much more: people know their linkage from the present one. */
const BETTER = 1.4;

/** At most so many ways are compared, each with each. */
const MOST = 24;

/**
 * Of the same points in each way those that are apart in at least two of them.
 * @param {Vector3[][]} ways @param {number} apart least distance @returns {Vector3[]} in all ways
 */
export function differing(ways, apart) {
  const [first, ...others] = ways.filter(({ length }) => length === ways[0].length);
  if (!others.length) return [];
  return first.flatMap((point, index) => (others.some((way) => way[index].distanceTo(point) > apart) ? [point, ...others.map((way) => way[index])] : []));
}

/** How much of the difference of the two ways that look most alike is seen from a direction. @param {Vector3[][]} differences of each pair of ways, point by point @param {Vector3} from unit */
const seen = (differences, from) => Math.min(...differences.map((points) => Math.max(...points.map((apart) => apart.clone().addScaledVector(from, -apart.dot(from)).length()))));

/**
 * A common direction to look from, in which no two ways look alike if that can be: the present one, unless another shows more.
 * @param {Vector3[][]} ways the same points in each @param {Vector3} present unit @param {number} apart least distance; ways that differ by less everywhere are not compared
 * @returns {Vector3 | undefined} unit; undefined for the present one
 */
export function clearestDirection(ways, present, apart) {
  const some = ways.filter(({ length }) => length === ways[0].length).slice(0, MOST);
  const differences = some
    .flatMap((one, i) => some.slice(i + 1).map((other) => one.map((point, at) => point.clone().sub(other[at]))))
    .filter((points) => points.some((point) => point.length() > apart));
  if (!differences.length) return undefined;
  /** @type {Vector3 | undefined} */
  let best;
  let most = BETTER * seen(differences, present);
  for (const high of HIGH.map((degrees) => (degrees * Math.PI) / 180)) {
    for (let around = 0; around < 2 * Math.PI - 1e-9; around += (AROUND * Math.PI) / 180) {
      const from = new Vector3(Math.cos(high) * Math.cos(around), Math.cos(high) * Math.sin(around), Math.sin(high));
      const share = seen(differences, from);
      if (share > most) [best, most] = [from, share];
    }
  }
  return best;
}

/** The longest edge of the box around points. @param {Vector3[]} points */
export function spanOf(points) {
  const edge = (/** @type {'x' | 'y' | 'z'} */ axis) => points.reduce((most, point) => Math.max(most, point[axis]), -Infinity) - points.reduce((least, point) => Math.min(least, point[axis]), Infinity);
  return Math.max(edge('x'), edge('y'), edge('z'));
}
