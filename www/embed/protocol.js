/**
 * What a frame and the page around it say to each other by `postMessage`. Every message is
 * `{synthetica: 1, type, …}`, with the version of this protocol.
 *
 * From the frame: `ready`, `document` (after an edit), `state` (frame, time, playing), `height` (what it would fill),
 * `error`. To the frame: `document` (to show it), `state` (to change it), and `get` with `what` and an `id`, which comes
 * back with the answer. The frame listens to its parent window only, and only if that is of the origin that it knows;
 * without a known origin it tells when it is ready and how high it is, and listens to nobody.
 *
 * @typedef {import('../element/element.js').SyntheticaLinkage} SyntheticaLinkage
 * @typedef {{synthetica: number, type: string, id?: unknown} & Record<string, any>} Message
 */
export const VERSION = 1;

/** What a page may change, by the names of the element's properties. */
const CHANGEABLE = /** @type {const} */ (['frame', 'currentTime', 'loop', 'bounce', 'speed', 'view', 'theme', 'panels']);

/** @param {SyntheticaLinkage} element */
function stateOf(element) {
  const { frame, currentTime, duration, paused, loop, bounce, speed, view, trajectory } = element;
  return { frame, frames: trajectory?.frames ?? 0, currentTime, duration, paused, loop, bounce, speed, view };
}

/**
 * @param {SyntheticaLinkage} element
 * @param {{window: Window, parent: Window, origin: string, height: () => number}} place
 */
export function speak(element, { window, parent, origin, height }) {
  /** @param {string} type @param {object} [content] @param {string} [to] */
  const send = (type, content = {}, to = origin) => {
    if (to) parent.postMessage({ synthetica: VERSION, type, ...content }, to);
  };
  /** What anybody may know. @param {string} type @param {object} [content] */
  const tell = (type, content) => send(type, content, origin || '*');

  let asked = 0;
  const sendState = () => {
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      send('state', { state: stateOf(element) });
    });
  };
  element.addEventListener('ready', () => {
    tell('ready', { version: VERSION });
    send('document', { document: element.document });
    sendState();
    tell('height', { height: height() });
  });
  element.addEventListener('change', () => send('document', { document: element.document }));
  for (const name of ['framechange', 'play', 'pause']) element.addEventListener(name, sendState);
  element.addEventListener('error', () => send('error', { error: element.error }));
  let told = 0;
  const sendHeight = () => {
    const now = height();
    if (now !== told) tell('height', { height: (told = now) });
  };
  new ResizeObserver(sendHeight).observe(element);

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
    if (type === 'get') {
      if (!Object.hasOwn(answers, what)) throw new TypeError(`There is no “${what}” to get. Accepted: ${Object.keys(answers).join(', ')}.`);
      return send(what, { id, [what]: answers[what]() });
    }
    if (type === 'document') {
      element.document = document;
    } else if (type === 'state') {
      // As pages had it when `loop` said how: once, loop or bounce.
      if (typeof state.loop === 'string') state = { ...state, loop: state.loop === 'loop', bounce: state.loop === 'bounce' };
      for (const name of CHANGEABLE) if (name in state) /** @type {any} */ (element)[name] = state[name];
      if (state.paused === true) element.pause();
      if (state.paused === false) element.play();
    } else throw new TypeError(`There is no message of type “${type}”. Accepted: document, state, get.`);
  }

  window.addEventListener('message', ({ source, origin: from, data }) => {
    if (source !== parent || !origin || (origin !== '*' && from !== origin)) return;
    if (typeof data !== 'object' || data === null || !('synthetica' in data)) return;
    try {
      obey(data);
    } catch (error) {
      send('error', { id: data.id, error: { message: /** @type {Error} */ (error).message, where: '', code: 'message' } });
    }
  });
}
