/**
 * What the applet shows first: the document of the address, the kept work, or the first sample; and other addresses that
 * are put in while the page is open.
 *
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./browser-storage.js').Work} Work
 */
import { readAddress, plainAddress } from '../../core/address.js';
import { answerTo } from '../../core/from-address.js';
import { saveFile } from '../../export/save.js';

/**
 * @param {import('../../core/linkage.js').Linkage} linkage
 * @param {ReturnType<typeof import('./browser-storage.js').createKeeper>} keeper
 * @returns {Promise<void>} when a document is shown
 */
export function start({ store, player, say, whole, show }, keeper) {
  /** Shows kept work with its undo steps, behind the present document's. @param {Work} work */
  function takeUp(work) {
    const { history } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    const past = [...history.past, history.doc, ...work.past];
    store.restore({ doc: work.doc, past, future: work.future }, originOf(work));
  }

  /** @param {Work} work @returns {Promise<boolean>} false if there is no motion to show with it */
  async function showKept(work) {
    const origin = originOf(work);
    if (!(await isGood(work.doc))) {
      if (!work.good || !(await isGood(work.good))) return false;
      // While the document is at fault, the last good motion is shown.
      store.restore({ doc: work.good, past: [], future: [] }, origin);
      await firstMotion();
    }
    store.restore(work, origin);
    return true;
  }

  const isGood = (/** @type {MechanismDocument} */ doc) => whole(JSON.stringify(doc)).then(() => true, () => false);

  const firstMotion = () =>
    new Promise((resolve) => {
      const leave = store.subscribe('result', () => {
        leave();
        resolve(null);
      });
    });

  /** At the start. */
  async function begin() {
    const asked = readAddress(location);
    const { work, broken } = keeper.load();
    const explicit = asked.payload !== null || asked.sample !== null || asked.sets.length > 0;
    const shown = !explicit && work !== null && (await showKept(work));
    const unreadable = broken || (!explicit && work !== null && !shown);
    if (unreadable && !broken) keeper.setAside();
    if (unreadable) tellBroken();
    if (!shown) {
      const { doc, title, problems } = await answerTo(asked, whole);
      store.restore({ doc, past: [], future: [] }, { title, handle: null, saved: doc });
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
    let { doc } = store;
    store.subscribe('document', () => {
      if (store.doc === doc) return;
      doc = store.doc;
      const plain = plainAddress(location.href);
      if (plain !== location.href) history.replaceState(null, '', plain);
    });
    addEventListener('hashchange', async () => {
      const asked = readAddress(location);
      if (asked.payload === null) return;
      const shared = await answerTo(asked, whole);
      if (shared.problems.length) say(shared.problems[0].replace(': a sample is shown in its place', ''), { stays: true });
      else {
        doc = shared.doc;
        show(shared.doc);
      }
    });
  }

  return begin();
}

/** @param {Work} work @returns {import('../../core/types.js').Origin} */
const originOf = ({ doc, title, unsaved }) => ({ title, handle: null, saved: unsaved ? null : doc });
