/**
 * Answers the questions to the planner, by its wasm module. Documents are opened once and asked many times; a plan goes in
 * portions, between which other messages are taken.
 *
 * @typedef {import('../core/types.js').Fault} Fault
 * @typedef {import('../core/types.js').Progress} Progress
 * @typedef {import('../core/types.js').Best} Best
 * @typedef {import('../core/types.js').Modes} Modes
 *
 * A question of a document names it by a number of the asker's choice; its text comes with the first question. `stop`
 * asks for what there is so far of a plan, `cancel` for nothing more; `close` frees a document. `wasm`, before all others,
 * says what to load (configure.js). `prepare` loads all that questions may need, so that the first of them need not wait.
 * @typedef {{kind: 'ask', id: number, call: Call, args: unknown[], doc?: number, text?: string}
 *   | {kind: 'stop' | 'cancel', id: number}
 *   | {kind: 'close', doc: number}
 *   | {kind: 'wasm', wasm: import('./configuration.js').Wasm} | {kind: 'prepare'}} Message
 * @typedef {{id: number, kind: 'value', value: unknown}
 *   | {id: number, kind: 'fault', fault: Fault}
 *   | {id: number, kind: 'failure', message: string, loading?: boolean}
 *   | {id: number, kind: 'received' | 'begun'}
 *   | {id: number, kind: 'progress', progress: Progress | Best | Modes}
 *   | {id: number, kind: 'cancelled'}} Answer `received`, at once, `begun`, when the planner is loaded, and `progress` are
 *   followed by others, all else is the last; `loading` where the planner could not be loaded
 *
 * @typedef {'plan' | 'pull' | 'explain' | 'text' | 'find_start' | 'drive' | 'trace' | 'matrix' | 'compare_metrics' | 'export_motion' | 'by_axes'
 *   | 'looks_standard' | 'best' | 'best_motion' | 'best_path' | 'calm_motion' | 'export_best' | 'modes' | 'text_with_mode'} DocumentCall
 *   methods of the packages' Session
 * @typedef {DocumentCall | 'ready' | 'defaults' | 'enumeration' | 'assemble' | 'make' | 'makers' | 'make_named' | 'read_poses' | 'schema' | 'chain_by_index' | 'assembly_by_index'} Call
 * @typedef {import('./packages.js').Open} Open
 *
 * A question that is answered in portions.
 * @typedef {{id: number, question: {stopped: boolean}, isWanted: () => boolean}} Portioned
 */
import { configuration } from './configuration.js';
import { first, isFault, isRead, NotLoaded, packageFor, putInWords, sessionOf, valueOf, whole } from './packages.js';

/** How long a portion of a plan is, in milliseconds: two pictures of a screen, so that what is dragged goes on. */
const PORTION = 30;

/** Least pause between two answers that tell what a search has found so far, in milliseconds. */
const TELL_EVERY = 250;

/** @param {(answer: Answer) => void} send */
export function createAnswers(send) {
  /** @type {Map<number, Open>} */
  const documents = new Map();
  /** Questions without an answer yet. @type {Map<number, {stopped: boolean}>} */
  const asked = new Map();
  /** The key frame whose ways to assemble a session searches. @type {WeakMap<object, unknown>} */
  const keys = new WeakMap();

  /** @param {Message} message */
  function receive(message) {
    if (message.kind === 'ask') return answer(message);
    if (message.kind === 'close') return close(message.doc);
    // Where it cannot be loaded, the question that needs it tells.
    if (message.kind === 'prepare') return void whole.load().catch(() => {});
    if (message.kind === 'wasm') {
      configuration.wasm = message.wasm;
      return;
    }
    const question = asked.get(message.id);
    if (!question) return;
    if (message.kind === 'stop') question.stopped = true;
    else {
      asked.delete(message.id);
      send({ id: message.id, kind: 'cancelled' });
    }
  }

  /** @param {Message & {kind: 'ask'}} question */
  async function answer({ id, call, args, doc: number, text }) {
    if (number !== undefined && text !== undefined) documents.set(number, { text, sessions: new Map(), users: 0, closed: false });
    const doc = number === undefined ? undefined : documents.get(number);
    const question = { stopped: false };
    asked.set(id, question);
    send({ id, kind: 'received' });
    const isWanted = () => asked.get(id) === question;
    if (doc) doc.users += 1;
    /** @type {Answer | null} */
    let last = null;
    try {
      let module = await packageFor(call, doc);
      if (!isWanted()) return;
      if (doc && module === first && !isRead(doc)) {
        module = await whole.load();
        if (!isWanted()) return;
      }
      send({ id, kind: 'begun' });
      if (doc) {
        const of = { id, question, isWanted };
        const done = await prepare(call, args, sessionOf(doc, module), of).catch(async (error) => {
          // The smaller package leaves a motion to the whole one too: one on which a slider runs away.
          if (error !== null || module !== first) throw error;
          doc.forWhole = true;
          module = await whole.load();
          return isWanted() && prepare(call, args, sessionOf(doc, module), of);
        });
        const value = done && (await valueOf(call, args, doc, module));
        if (value && call === 'plan') await putInWords(value, doc, module);
        if (done && isWanted()) last = { id, kind: 'value', value };
      } else last = { id, kind: 'value', value: call === 'ready' ? undefined : module[call](...args) };
    } catch (error) {
      if (isFault(error)) last = { id, kind: 'fault', fault: error };
      else if (error instanceof NotLoaded) last = { id, kind: 'failure', message: error.message, loading: true };
      else last = { id, kind: 'failure', message: String(error) };
    } finally {
      const wanted = isWanted();
      if (wanted) asked.delete(id);
      if (doc) doc.users -= 1;
      // After a failure the memory of wasm is in no known state, and is given up as a whole.
      if (doc && last?.kind !== 'failure') free(doc);
      if (wanted && last) send(last);
    }
  }

  /**
   * What must be planned before a question can be answered, in portions.
   * @param {Call} call @param {unknown[]} args @param {any} session @param {Portioned} of
   * @returns {Promise<boolean>} whether an answer is still wanted
   */
  async function prepare(call, args, session, of) {
    if (call === 'plan' || call === 'export_motion') return plan(session, of);
    if (call === 'compare_metrics') return compare(session, of);
    if (call === 'best') return search('best', session, of);
    if (call !== 'modes') return true;
    // Of one key frame at a time; of the same one it goes on where it was.
    const [key] = args;
    if (keys.get(session) !== key) session.begin_modes(key);
    keys.set(session, key);
    return search('modes', session, of);
  }

  /**
   * Plans a document's motion with either metric, in portions.
   * @param {any} session @param {{isWanted: () => boolean}} of
   * @returns {Promise<boolean>} whether an answer is still wanted
   */
  async function compare(session, { isWanted }) {
    while (session.advance_comparison(PORTION)) {
      await nextTurn();
      if (!isWanted()) return false;
    }
    return true;
  }

  /**
   * Searches in portions, on from where it was ended before.
   * @param {'best' | 'modes'} what @param {any} session @param {Portioned} of
   * @returns {Promise<boolean>} whether an answer is still wanted
   */
  async function search(what, session, { id, question, isWanted }) {
    let told = performance.now();
    while (session[`advance_${what}`](PORTION)) {
      if (performance.now() > told + TELL_EVERY) {
        send({ id, kind: 'progress', progress: session[what]() });
        told = performance.now();
      }
      await nextTurn();
      if (!isWanted()) return false;
      if (question.stopped) break;
    }
    return true;
  }

  /**
   * Plans a document's motion in portions, on from where it was stopped before.
   * @param {any} session @param {Portioned} of
   * @returns {Promise<boolean>} whether an answer is still wanted
   */
  async function plan(session, { id, question, isWanted }) {
    while (session.advance_plan(PORTION)) {
      send({ id, kind: 'progress', progress: session.plan_progress() });
      await nextTurn();
      if (!isWanted()) return false;
      if (question.stopped) break;
    }
    return true;
  }

  /** @param {number} number */
  function close(number) {
    const doc = documents.get(number);
    documents.delete(number);
    if (!doc) return;
    doc.closed = true;
    free(doc);
  }

  return { receive };
}

/** Frees the memory of a document that is closed, after its last question is answered. @param {Open} doc */
function free({ sessions, users, closed }) {
  if (!closed || users > 0) return;
  for (const session of sessions.values()) session.free();
  sessions.clear();
}

/** After the messages that have come by now; a timer would wait 4 ms each time. @returns {Promise<void>} */
const nextTurn = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
