/**
 * Which document is shown: at the start by the address, the kept work or the first sample; later whatever is opened,
 * as a step that undo takes back.
 *
 * @typedef {import('./types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./files/keeper.js').Work} Work
 */
import { readAddress, plainAddress } from './files/address.js';
import { DamagedLink, decode } from './files/codec.js';
import { applyOverrides, BadOverride, parseOverrides } from './files/overrides.js';
import { saveFile } from './files/save.js';
import { DocumentFault, PlannerFailure } from './planner.js';
import { samples } from './samples.js';
import { sentence } from './view/fault-note.js';

/**
 * @param {Pick<import('./main.js').App, 'store' | 'planner' | 'player' | 'say'>} parts
 * @param {ReturnType<typeof import('./files/keeper.js').createKeeper>} keeper
 */
export function createOpening({ store, planner, player, say }, keeper) {
  /** The document with every default written out. @param {string} text @returns {Promise<MechanismDocument>} */
  const whole = async (text) => JSON.parse(await planner.normalise(text));

  /** @param {MechanismDocument} document @param {string} [title] @param {FileSystemFileHandle | null} [handle] */
  function show(document, title = '', handle = null) {
    const { document: former, unsaved } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    store.open(document, { title, handle, saved: document });
    const name = former.name || 'the linkage';
    if (unsaved) say(`Opened ${document.name || title || 'a linkage'} in place of ${name}, which has changes that are in no file.`, { label: 'Undo', act: () => store.backTo(former) });
  }

  /**
   * @param {string} text a document
   * @param {string} [title] what its file is called
   * @param {FileSystemFileHandle | null} [handle] the file, where it can be written to
   * @returns {Promise<boolean>} whether it is shown now; if not, the reason has been told
   */
  async function open(text, title = '', handle = null) {
    try {
      show(await whole(text), title, handle);
      return true;
    } catch (error) {
      say(`${title ? `“${title}”` : 'The document'} was not opened. ${reason(error)}`, { stays: true });
      return false;
    }
  }

  /** The document that an address asks for, and what was wrong with it. @param {ReturnType<typeof readAddress>} asked */
  async function answer({ payload, sample, sets }) {
    /** @type {string[]} */
    const problems = [];
    const found = samples.find(({ file }) => file === sample || file === `${sample}.json`);
    if (sample !== null && !found) problems.push(`There is no sample “${sample}”. Accepted: ${samples.map(({ file }) => file).join(', ')}.`);
    let document = await whole((found ?? samples[0]).text);
    let title = (found ?? samples[0]).file;
    if (payload !== null) {
      try {
        document = await whole(await decode(payload));
        title = '';
      } catch (error) {
        problems.push(`This link cannot be opened: a sample is shown in its place. ${reason(error)}`);
      }
    }
    try {
      if (sets.length) document = await whole(JSON.stringify(applyOverrides(document, parseOverrides(sets))));
    } catch (error) {
      problems.push(`The changes in the address (set=…) were left out. ${reason(error)}`);
    }
    return { document, title, problems };
  }

  /** Shows kept work with its undo steps, behind the present document's. @param {Work} work */
  function takeUp(work) {
    const { history } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    const past = [...history.past, history.document, ...work.past];
    store.restore({ document: work.document, past, future: work.future }, originOf(work));
  }

  /** @param {Work} work @returns {Promise<boolean>} false if there is no motion to show with it */
  async function showKept(work) {
    const origin = originOf(work);
    if (!(await isGood(work.document))) {
      if (!work.good || !(await isGood(work.good))) return false;
      // While the document is at fault, the last good motion is shown.
      store.restore({ document: work.good, past: [], future: [] }, origin);
      await firstMotion();
    }
    store.restore(work, origin);
    return true;
  }

  const isGood = (/** @type {MechanismDocument} */ document) => whole(JSON.stringify(document)).then(() => true, () => false);

  const firstMotion = () =>
    new Promise((resolve) => {
      const leave = store.subscribe('result', () => {
        leave();
        resolve(null);
      });
    });

  /** At the start. */
  async function start() {
    const asked = readAddress(location);
    const { work, broken } = keeper.load();
    const explicit = asked.payload !== null || asked.sample !== null || asked.sets.length > 0;
    const shown = !explicit && work !== null && (await showKept(work));
    const unreadable = broken || (!explicit && work !== null && !shown);
    if (unreadable && !broken) keeper.setAside();
    if (unreadable) tellBroken();
    if (!shown) {
      const { document, title, problems } = await answer(asked);
      store.restore({ document, past: [], future: [] }, { title, handle: null, saved: document });
      for (const problem of problems) say(problem, { stays: true });
      if (explicit && work) {
        keeper.disown();
        if (work.unsaved || work.past.length) {
          say('This was opened by its address. Your last document is kept.', { label: 'Restore my last document', act: () => takeUp(work), stays: true });
        }
      }
    }
    watchAddress();
  }

  const tellBroken = () =>
    say('What this browser kept of your last document cannot be read. A sample is shown in its place.', {
      label: 'Download it',
      act: () => saveFile('kept-document.txt', new Blob([keeper.broken()], { type: 'text/plain' })),
      stays: true,
    });

  /** An address describes its document until the first edit; another one may be put in while the page is open. */
  function watchAddress() {
    let { document } = store;
    store.subscribe('document', () => {
      if (store.document === document) return;
      document = store.document;
      const plain = plainAddress(location.href);
      if (plain !== location.href) history.replaceState(null, '', plain);
    });
    addEventListener('hashchange', async () => {
      const asked = readAddress(location);
      if (asked.payload === null) return;
      const shared = await answer(asked);
      if (shared.problems.length) say(shared.problems[0].replace(': a sample is shown in its place', ''), { stays: true });
      else {
        document = shared.document;
        show(shared.document);
      }
    });
  }

  return { open, start };
}

/** @param {Work} work @returns {import('./types.js').Origin} */
const originOf = ({ document, title, unsaved }) => ({ title, handle: null, saved: unsaved ? null : document });

/** Why a document was not opened, in words. @param {unknown} error */
function reason(error) {
  if (error instanceof DocumentFault) return sentence(error.fault.message);
  if (error instanceof DamagedLink || error instanceof BadOverride) return error.message;
  if (error instanceof PlannerFailure) return `The planner failed (${error.message}).`;
  throw error;
}
