/**
 * Where flags stand beside what they name: at the end of a leader in one of eight directions, clear of the thing, of other
 * flags and of what else is there; left out where there is no room. A flag stays where it stood while it can. No DOM.
 *
 * @typedef {{x: number, y: number, width: number, height: number}} Box in pixels, y down, x and y its corner at the top left
 * @typedef {object} Name
 * @property {number} x its point @property {number} y
 * @property {number} width @property {number} height
 * @property {number} clear half the size of the thing around the point, which the flag does not cover; negative: it has no leader, and stands on its point
 * @property {number} rank those of a higher rank have the first choice
 * @property {boolean} kept shown also where it covers another one
 * @property {number} spot where it stood last: a direction, plus 8 for each step farther off; −1 for nowhere
 */

/** How far from the thing a flag stands, near and farther off, in pixels. */
const AWAY = [9, 30, 75];

/** A flag that moves elsewhere has so many pixels to spare, so that it does not come back at once. */
const SPARE = 4;

/** Directions by their distance from the best one, which is away from the middle of the scene. */
const TURNS = [0, 1, -1, 2, -2, 3, -3, 4];

/** How far a direction may be from the best one before a flag leaves it. */
const STAYS = 2;

/** @param {Box} a @param {Box} b @param {number} [spare] */
const overlap = (a, b, spare = 0) => a.x < b.x + b.width + spare && b.x < a.x + a.width + spare && a.y < b.y + b.height + spare && b.y < a.y + a.height + spare;

/** @param {Box} a @param {Box} b */
const within = (a, b) => a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;

/** Of the eight directions. */
const WAYS = Array.from({ length: 8 }, (_, spot) => /** @type {[number, number]} */ ([Math.round(Math.cos((spot * Math.PI) / 4)), -Math.round(Math.sin((spot * Math.PI) / 4))]));

/** Right and down of a direction, counted anticlockwise from the right: −1, 0 or 1 each. @param {number} spot */
export const wayOf = (spot) => WAYS[spot & 7];

/** From a name's point to the near end of its flag: the length of its leader. @param {Pick<Name, 'clear'>} name @param {number} spot */
export const leaderOf = ({ clear }, spot) => Math.round(clear + AWAY[spot >> 3]);

/** From a name's point to the corner of its flag. @param {Pick<Name, 'clear' | 'width' | 'height'>} name @param {number} spot @returns {[number, number]} */
export function offsetOn(name, spot) {
  const { width, height, clear } = name;
  const [right, down] = clear < 0 ? [0, 0] : wayOf(spot);
  const far = leaderOf(name, spot) * (right && down ? Math.SQRT1_2 : 1);
  return [right * far + ((right - 1) * width) / 2, down * far + ((down - 1) * height) / 2];
}

/** @param {Name} name @param {number} spot @returns {Box} */
export function boxOn(name, spot) {
  const [right, down] = offsetOn(name, spot);
  return { x: name.x + right, y: name.y + down, width: name.width, height: name.height };
}

/**
 * @param {Name[]} names
 * @param {Box[]} others what they must not cover
 * @param {Box} view where they must be
 * @param {{x: number, y: number}} middle of the scene
 * @returns {number[]} the spot of each; −1 for one that is left out
 */
export function layOut(names, others, view, middle) {
  const taken = [...others];
  const spots = names.map(() => -1);
  const things = names.map(({ x, y, clear }) => ({ x: x - clear / 2, y: y - clear / 2, width: clear, height: clear }));
  const order = names.map((_, index) => index).sort((a, b) => names[b].rank - names[a].rank || a - b);
  for (const index of order) {
    const name = names[index];
    const best = Math.round((Math.atan2(middle.y - name.y, name.x - middle.x) * 4) / Math.PI);
    const covers = (/** @type {number} */ spot, /** @type {Box[]} */ boxes, /** @type {number} */ spare) => {
      const own = boxOn(name, spot);
      return boxes.some((box) => overlap(box, own, spare));
    };
    const turn = Math.abs(((name.spot - best + 12) % 8) - 4);
    const stays = name.spot >= 0 && turn <= STAYS && !covers(name.spot, taken, 0) && !covers(name.spot, things, 0) && within(boxOn(name, name.spot), view);
    let spot = name.spot;
    if (!stays) {
      const tries = name.clear < 0 ? [0] : [0, 8, 16].flatMap((far) => TURNS.map((turn) => ((best + turn + 16) % 8) + far));
      const inView = tries.filter((one) => name.clear < 0 || within(boxOn(name, one), view));
      const free = inView.filter((one) => !covers(one, taken, name.clear < 0 ? 0 : SPARE));
      spot = free.find((one) => !covers(one, things, 0)) ?? free[0] ?? (name.kept ? (inView[0] ?? tries[0]) : -1);
    }
    spots[index] = spot;
    if (spot >= 0) taken.push(boxOn(name, spot));
  }
  return spots;
}
