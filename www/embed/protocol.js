/**
 * What a frame and the page around it say to each other by `postMessage`. Every message is
 * `{synthetica: 1, type, …}`, with the version of this protocol.
 *
 * From the frame: `hello` (it is there, and whether it `listens`; in answer to the page's `hello` also all that it has told
 * so far, marked with `again`), `ready`, `document` (after an edit), `state` (frame, time, playing), `height` (what it would
 * fill), `error`. To the frame: `hello`, `document` (to show it), `state` (to change it), and `get` with `what` and an `id`,
 * which comes back with the answer. The frame listens to its parent window only, and only if that is of the origin that it
 * knows; without a known origin it tells that it is there, when it is ready and how high it is, and listens to nobody.
 *
 * @typedef {import('../element/element.js').SyntheticaLinkage} SyntheticaLinkage
 * @typedef {import('../element/element.js').LinkageError} LinkageError
 * @typedef {{synthetica: number, type: string, id?: unknown} & Record<string, any>} Message
 */
import { VERSION } from './version.js';

/** What a page may change, by the names of the element's properties. */
const CHANGEABLE = /** @type {const} */ (['frame', 'currentTime', 'loop', 'bounce', 'speed', 'view', 'theme', 'panels', 'interaction']);

/** @param {SyntheticaLinkage} element */
function stateOf(element) {
  const { frame, currentTime, duration, paused, ended, loop, bounce, speed, view, interaction, trajectory } = element;
  return { frame, frames: trajectory?.frames ?? 0, currentTime, duration, paused, ended, loop, bounce, speed, view, interaction };
}

/**
 * @param {SyntheticaLinkage} element
 * @param {object} place
 * @param {Window} place.window
 * @param {Window} place.parent
 * @param {string} place.origin of the parent, see parentOrigin in address.js
 * @param {() => number} place.height
 * @param {(error: LinkageError) => LinkageError} place.tellable what the parent may hear of an error
 * @param {() => void} place.sent the parent gives a document
 */
export function speak(element, { window, parent, origin, height, tellable, sent }) {
  /** @param {string} type @param {object} [content] @param {string} [to] */
  const send = (type, content = {}, to = origin) => {
    if (to) parent.postMessage({ synthetica: VERSION, type, ...content }, to);
  };
  /** What anybody may know. @param {string} type @param {object} [content] */
  const tell = (type, content) => send(type, content, origin || '*');

  let ready = false;
  let told = 0;
  const tellHeight = () => tell('height', { height: (told = height()) });
  const greeting = () => ({ listens: origin !== '', ...(ready && { ready: { version: VERSION } }), ...(told && { height: told }) });
  /** All that has been told, for a page that begins to listen late. */
  function greetAgain() {
    const { error } = element;
    tell('hello', {
      ...greeting(),
      again: true,
      ...(origin && ready && { document: element.document, state: stateOf(element) }),
      ...(origin && error && { error: tellable(error) }),
    });
  }

  let asked = 0;
  const sendState = () => {
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      send('state', { state: stateOf(element) });
    });
  };
  element.addEventListener('ready', () => {
    ready = true;
    tell('ready', { version: VERSION });
    send('document', { document: element.document });
    sendState();
    tellHeight();
  });
  element.addEventListener('change', () => send('document', { document: element.document }));
  for (const name of ['framechange', 'play', 'pause', 'ended']) element.addEventListener(name, sendState);
  element.addEventListener('error', (event) => send('error', { error: tellable(/** @type {CustomEvent} */ (/** @type {Event} */ (event)).detail) }));
  new ResizeObserver(() => height() !== told && tellHeight()).observe(element);

  /** @type {Record<string, () => unknown>} */
  const answers = {
    document: () => element.document,
    trajectory: () => element.trajectory,
    state: () => stateOf(element),
    height,
  };

  /** @param {Message} message */
  function obey({ synthetica, type, id, what, document, state }) {
    if (synthetica !== VERSION) throw new TypeError(`This frame speaks version ${VERSION}, not ${synthetica}.`);
    if (type === 'hello') return greetAgain();
    if (type === 'get') {
      if (!Object.hasOwn(answers, what)) throw new TypeError(`There is no “${what}” to get. Accepted: ${Object.keys(answers).join(', ')}.`);
      return send(what, { id, [what]: answers[what]() });
    }
    if (type === 'document') {
      sent();
      element.document = document;
    } else if (type === 'state') {
      // As pages had it when `loop` said how: once, loop or bounce.
      if (typeof state.loop === 'string') state = { ...state, loop: state.loop === 'loop', bounce: state.loop === 'bounce' };
      for (const name of CHANGEABLE) if (name in state) /** @type {any} */ (element)[name] = state[name];
      if (state.paused === true) element.pause();
      if (state.paused === false) element.play();
    } else throw new TypeError(`There is no message of type “${type}”. Accepted: hello, document, state, get.`);
  }

  window.addEventListener('message', ({ source, origin: from, data }) => {
    if (source !== parent || typeof data !== 'object' || data === null || !('synthetica' in data)) return;
    // It listens to nobody, and says so.
    if (!origin && data.type === 'hello') return greetAgain();
    if (!origin || (origin !== '*' && from !== origin)) return;
    try {
      obey(data);
    } catch (error) {
      send('error', { id: data.id, error: { message: /** @type {Error} */ (error).message, where: '', code: 'message' } });
    }
  });
  tell('hello', greeting());
}
