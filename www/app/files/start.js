/**
 * What the applet shows first: the document of the address, the kept work, or the first sample; and other addresses that
 * are put in while the page is open.
 *
 * @typedef {import('../../core/types.js').MechanismDocument} MechanismDocument
 * @typedef {import('./browser-storage.js').Work} Work
 */
import { readAddress, plainAddress } from '../../core/address.js';
import { untilAnswered } from '../../core/ask.js';
import { answerTo } from '../../core/from-address.js';
import { isEmpty } from '../../core/nothing.js';
import { saveFile } from '../../export/save.js';

/**
 * @param {import('../../core/linkage.js').Linkage} linkage
 * @param {ReturnType<typeof import('./browser-storage.js').createKeeper>} keeper
 * @returns {Promise<void>} when a document is shown
 */
export function start(linkage, keeper) {
  const { store, player, say, whole, show } = linkage;
  /** Shows kept work with its undo steps, behind the present document's. @param {Work} work */
  function takeUp(work) {
    const { history } = store;
    player.currentTime = 0;
    store.setView({ selected: '', hovered: '' });
    const past = [...history.past, ...(isEmpty(store) ? [] : [history.doc]), ...work.past];
    store.restore({ doc: work.doc, past, future: work.future }, originOf(work));
  }

  /** @param {Work} work @returns {Promise<boolean>} false if there is no motion to show with it */
  async function showKept(work) {
    const origin = originOf(work);
    if (!(await isGood(work.doc))) {
      const good = work.good ?? work.past.at(-1);
      if (!good || !(await isGood(good))) return false;
      // While the document is at fault, the last good motion is shown.
      store.restore({ doc: good, past: [], future: [] }, origin);
      await firstMotion();
    }
    store.restore(work, origin);
    return true;
  }

  /** Only a fault of the document counts against it: a planner that failed is asked again. @param {MechanismDocument} doc */
  const isGood = async (doc) => (await untilAnswered(store, () => whole(JSON.stringify(doc)))).is === 'answer';

  const firstMotion = () =>
    new Promise((resolve) => {
      const leave = store.subscribe('result', () => {
        // After trouble it is planned again.
        if (store.result.trouble) return;
        leave();
        resolve(null);
      });
    });

  /** At the start. */
  async function begin() {
    const { href } = location;
    const { work, broken } = keeper.load();
    const asked = readAddress(location);
    const explicit = asked.payload !== null || asked.src !== null || asked.sample !== null || asked.sets.length > 0;
    const shown = !explicit && work !== null && (await showKept(work));
    if (broken) {
      say('What this browser kept of your last document cannot be read. It is in the File menu (▾ beside Save), Earlier documents.', {
        label: 'Download it',
        act: () => saveFile('kept-document.txt', new Blob([broken], { type: 'text/plain' })),
        stays: true,
      });
    }
    if (!shown) {
      const { value } = await untilAnswered(store, () => answerTo(asked, linkage));
      const { doc, title, from, broken, missing, problems } = value;
      if (work && !explicit) {
        keeper.setAside();
        say('Your last document has a fault, and no motion without it is known. It is in the File menu (▾ beside Save), Earlier documents.', { label: 'Open it', act: () => takeUp(work), stays: true });
      }
      if (doc) store.restore({ doc, past: [], future: [] }, { title, handle: null, saved: doc });
      // Another linkage would be taken for the one that was asked for.
      else (await import('../missing.js')).showMissing(linkage, missing);
      if (from && doc) say(`Opened from ${from}.`);
      if (broken) say(`This link cannot be opened${doc ? ': a sample is shown in its place' : ''}. ${broken}`, { stays: true });
      for (const problem of problems) say(problem, { stays: true });
      if (explicit && work) {
        keeper.disown();
        if (work.unsaved || work.past.length) {
          say('This was opened by its address. Your last document is kept.', { label: 'Restore my last document', act: () => takeUp(work), stays: true });
        }
      }
    }
    watchAddress(href);
  }

  /**
   * An address describes its document until the first edit; another one may be put in while the page is open.
   * @param {string} begun the address that the start has seen to
   */
  function watchAddress(begun) {
    let { doc } = store;
    store.subscribe('document', () => {
      if (store.doc === doc) return;
      doc = store.doc;
      const plain = plainAddress(location.href);
      if (plain !== location.href) history.replaceState(null, '', plain);
    });
    /** Counts addresses: what an older one asked for comes too late. */
    let addresses = 0;
    async function follow() {
      const mine = ++addresses;
      const asked = readAddress(location);
      if (asked.payload === null) return;
      const shared = await answerTo(asked, linkage);
      if (mine !== addresses) return;
      if (shared.is === 'trouble') return say(`This link was not opened. ${shared.message}`, { label: 'Try again', act: follow, stays: true });
      const { broken, problems } = shared.value;
      if (broken || !shared.value.doc) return say(`This link cannot be opened. ${broken}`, { stays: true });
      doc = shared.value.doc;
      show(doc);
      for (const problem of problems) say(problem, { stays: true });
    }
    addEventListener('hashchange', follow);
    if (location.href !== begun) follow();
  }

  return begin();
}

/** @param {Work} work @returns {import('../../core/types.js').Origin} */
const originOf = ({ doc, title, unsaved }) => ({ title, handle: null, saved: unsaved ? null : doc });
