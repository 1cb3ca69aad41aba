/**
 * Where names stand beside their points: on one of four sides, and left out where each would cover another name. No DOM.
 *
 * @typedef {{x: number, y: number, width: number, height: number}} Box in pixels, y down, x and y its corner at the top left
 * @typedef {object} Name
 * @property {number} x its point @property {number} y
 * @property {number} width @property {number} height
 * @property {number} left from the point to the name on its usual side, above right @property {number} top negative
 * @property {number} rank those of a higher rank have the first choice
 * @property {boolean} kept shown also where it covers another one
 */

/** @param {Box} a @param {Box} b */
const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** From a name's point to its corner on a side: 0 above right, 1 below right, 2 above left, 3 below left. @param {Pick<Name, 'left' | 'top' | 'width' | 'height'>} name @param {number} side @returns {[number, number]} */
export const offsetOn = ({ left, top, width, height }, side) => [side < 2 ? left : -left - width, side % 2 === 0 ? top : -top - height];

/**
 * @param {Name[]} names
 * @param {Box[]} others what they must not cover
 * @param {{width: number, height: number}} room
 * @returns {number[]} the side of each; −1 for one that is left out
 */
export function layOut(names, others, room) {
  const taken = [...others];
  const sides = names.map(() => -1);
  const order = names.map((_, index) => index).sort((a, b) => names[b].rank - names[a].rank || a - b);
  for (const index of order) {
    const name = names[index];
    const boxOn = (/** @type {number} */ side) => {
      const [right, down] = offsetOn(name, side);
      return { x: name.x + right, y: name.y + down, width: name.width, height: name.height };
    };
    const inside = (/** @type {Box} */ { x, y, width, height }) => x >= 0 && y >= 0 && x + width <= room.width && y + height <= room.height;
    const free = [0, 1, 2, 3].filter((side) => !taken.some((box) => overlap(box, boxOn(side))));
    const side = free.find((one) => inside(boxOn(one))) ?? free[0] ?? (name.kept ? 0 : -1);
    sides[index] = side;
    if (side >= 0) taken.push(boxOn(side));
  }
  return sides;
}
