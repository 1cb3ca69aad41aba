/**
 * Motions whose joints are driven: which they are, and the words for them, loaded with the first. There is no goal then, and no
 * distance from one.
 *
 * @typedef {import('./types.js').Motion} Motion
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {Pick<typeof import('./driven-words.js'), 'drivenWords' | 'driveReasons' | 'statusMeaning' | 'drivenSeries' | 'pathSeries'>} Words
 */

/** Whether joints are driven in a motion. @param {Motion | null} motion */
export const drivesJoints = (motion) => (motion?.report?.drivers?.length ?? 0) > 0;

/** Whether a document drives joints. @param {MechanismDocument | null} doc */
export const hasDrivers = (doc) => (doc?.motion.drivers?.length ?? 0) > 0;

/** Which driver drives a variable, all counted from 0; −1 for none. @param {MechanismDocument} doc @param {{chain: number, joint: number, freedom: number}} variable */
export const driverIndex = ({ motion: { drivers = [] } }, { chain, joint, freedom }) =>
  drivers.findIndex((one) => Number(one.chain) === chain + 1 && Number(one.joint) === joint + 1 && Number(one.freedom ?? 1) === freedom + 1);

/** What there is to say where the words could not be loaded. @type {Words} */
const FEW = { drivenWords: () => '', driveReasons: () => [], statusMeaning: () => '', drivenSeries: () => [], pathSeries: () => [] };

/** The words for motions with driven joints. */
export const told = { words: FEW };

/** Loads them where a motion needs them, before it is shown. @param {Motion} motion */
export async function loadWords(motion) {
  if (!drivesJoints(motion) || told.words !== FEW) return;
  told.words = await import('./driven-words.js').catch(() => FEW);
}
