/**
 * What pictures of a linkage in its ways to assemble show, and from which side it is seen best how they differ. Knows no DOM.
 */
import { Vector3 } from 'three';

/** Sides from which pictures may be seen beside the present one: around, and from so high, in degrees. From higher a plate hides its legs. */
const AROUND = 30;
const HIGH = [10, 25];

/** Another side must show this much more: people know their linkage from the present one. */
const BETTER = 1.4;

/** At most so many ways are compared, each with each. */
const MOST = 24;

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

/**
 * What the one camera of all pictures takes in, the whole linkage in each of its ways, and where it looks from.
 * @param {{points: Vector3[], joints: Vector3[]}[]} ways @param {Vector3} present unit @param {number} apart least distance of joints that differ
 */
export const framingOf = (ways, present, apart) => ({
  points: ways.flatMap(({ points }) => points),
  from: clearestDirection(ways.map(({ joints }) => joints), present, apart),
});
