/**
 * The stroke of a slider: a collar at each limit that is given, where what slides rests against it, and a rail between them. A limit
 * that is reached has another colour.
 */
import { Group } from 'three';
import { barrel, cube, part } from './joint-shapes.js';

/** In link radii: a collar's thickness, the rail's, and how far from the motion a limit is still drawn. */
const THICK = 0.45;
const RAIL = 0.3;
const FAR = 60;

/** In link radii, by type of joint: half the length of what slides, and half the width of the collars, of which the lower one goes around the sleeve. */
const SIZES = { P: { half: 1.15, wide: [1.9, 1.35] }, C: { half: 0.6, wide: [2.3, 1.6] } };

/** Below this share of a link radius a joint is at its limit. */
const TOUCH = 1e-6;

/**
 * @param {'P' | 'C'} type
 * @param {{metal: import('three').Material, limit: import('three').Material}} materials
 * @param {number} r radius of a link
 */
export function createStops(type, { metal, limit }, r) {
  const { half, wide } = SIZES[type];
  const group = new Group();
  group.scale.setScalar(r);
  const collars = wide.map((size) => {
    const collar = part(type === 'P' ? cube() : barrel(size, THICK), metal);
    if (type === 'P') collar.scale.set(2 * size, 2 * size, THICK);
    return collar;
  });
  const rail = part(cube(), metal);
  rail.position.x = wide[1] - RAIL / 2;
  group.add(...collars, rail);
  let ends = [NaN, NaN];
  return {
    group,
    /**
     * @param {(number | null)[]} limits least and largest travel along the axis, null for none
     * @param {import('./joint-shapes.js').Travel} travel of the motion
     */
    fit([least, largest], { low, high }) {
      ends = [least !== null && low - least < FAR * r ? least : NaN, largest !== null && largest - high < FAR * r ? largest : NaN];
      const places = ends.map((end, i) => end / r + (i ? 1 : -1) * (half + THICK / 2));
      collars.forEach((collar, i) => {
        collar.visible = Number.isFinite(ends[i]);
        collar.position.z = collar.visible ? places[i] : 0;
      });
      // With one limit only, the rail goes from the seat to it.
      const [from, to] = places.map((place) => (Number.isFinite(place) ? place : 0));
      rail.visible = collars.some(({ visible }) => visible);
      rail.position.z = (from + to) / 2;
      rail.scale.set(RAIL, RAIL, Math.max(Math.abs(to - from), THICK));
    },
    /** @param {number} travel now */
    mark(travel) {
      collars.forEach((collar, i) => {
        collar.material = Math.abs(travel - ends[i]) <= TOUCH * r ? limit : metal;
      });
    },
  };
}

/**
 * The limits of a slider's travel, from its seat to the moved frame.
 * @param {import('../../core/types.js').Joint | undefined} joint by its rows, with numbers
 * @returns {(number | null)[]}
 */
export function travelLimits(joint) {
  // Of a C the turn is the first freedom.
  const own = joint?.limits?.[joint.type === 'C' ? 1 : 0];
  const offset = Number(joint?.rows?.[0]?.d ?? 0);
  return [own?.min, own?.max].map((value) => (typeof value === 'number' ? value + offset : null));
}
