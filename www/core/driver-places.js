/**
 * Drivers keep their joints where chains and joints of a document change places, and go with joints that are removed.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 */
import { placesIn } from './lists.js';

/**
 * @param {MechanismDocument} before
 * @param {MechanismDocument} next with the drivers of `before`
 * @param {(chain: number, joint: number) => [chain: number, joint: number]} where a joint is now; −1 for one that is gone
 * @returns {MechanismDocument}
 */
function followed({ motion }, next, where) {
  const drivers = motion?.drivers;
  if (!drivers?.length) return next;
  const moved = drivers.map((driver) => {
    const [chain, joint] = where(Number(driver.chain) - 1, Number(driver.joint) - 1);
    if (chain < 0 || joint < 0) return null;
    return chain === Number(driver.chain) - 1 && joint === Number(driver.joint) - 1 ? driver : { ...driver, chain: chain + 1, joint: joint + 1 };
  });
  const left = moved.filter((driver) => driver !== null);
  // A motion has at least one: what it drives is to be chosen anew then.
  return { ...next, motion: { ...next.motion, drivers: left.length ? left : drivers } };
}

/** The document with other chains, some of which are those of before. @param {MechanismDocument} doc @param {MechanismDocument['chains']} chains */
export function withChains(doc, chains) {
  const places = placesIn(doc.chains, chains);
  return followed(doc, { ...doc, chains }, (chain, joint) => [places[chain] ?? chain, joint]);
}

/**
 * The document in which one chain is another one, some of whose joints are those of before.
 * @param {MechanismDocument} doc @param {number} at @param {import('./types.js').Chain} fresh
 */
export function withChain(doc, at, fresh) {
  const old = doc.chains[at].joints;
  const places = placesIn(old, fresh.joints);
  // As many as before: a joint that is another one has taken the place of the one there.
  const stays = old.length === fresh.joints.length && !fresh.joints.every((joint) => old.includes(joint));
  const where = (/** @type {number} */ joint) => (stays && places[joint] < 0 ? joint : (places[joint] ?? joint));
  const chains = doc.chains.map((chain, i) => (i === at ? fresh : chain));
  return followed(doc, { ...doc, chains }, (chain, joint) => [chain, chain === at ? where(joint) : joint]);
}
