/**
 * The page's keys: the one list from which the help, the tooltips and the handlers come.
 *
 * @typedef {object} Key
 * @property {keyof typeof PLACES} where
 * @property {string[]} keys as they are written: `Ctrl+Z`; Command is as good as Ctrl
 * @property {string} does
 * @property {string} [by] the widget that handles it by itself, or `browser`; else a handler is given by `onKeys`
 *
 * @typedef {(event: KeyboardEvent, at: number) => unknown} Handler `at`: which of the entry's keys; false: the key was not meant
 */

/** Where keys hold, as the help says it. */
export const PLACES = {
  all: 'Anywhere',
  page: 'Anywhere but in a field',
  view: '3D view',
  hand: '3D view, a key frame or the workpiece selected',
  scrub: 'Scrub bar',
  bar: 'Animation bar, charts',
  tables: 'Tables',
  tree: 'Object tree',
};

const [ARROWS, PAGES] = [['←', '→', '↑', '↓'], ['Page Up', 'Page Down']];

/** @satisfies {Record<string, Key>} */
export const KEYS = {
  play: { where: 'page', keys: ['Space'], does: 'play or pause' },
  keys: { where: 'page', keys: ['?'], does: 'show these keys' },
  undo: { where: 'all', keys: ['Ctrl+Z'], does: 'undo; a linkage that was moved by hand first goes back' },
  redo: { where: 'all', keys: ['Ctrl+Shift+Z', 'Ctrl+Y'], does: 'redo' },
  open: { where: 'all', keys: ['Ctrl+O'], does: 'open a document' },
  save: { where: 'all', keys: ['Ctrl+S'], does: 'save the document' },
  turnView: { where: 'view', keys: ARROWS, does: 'turn the view' },
  shiftView: { where: 'view', keys: ARROWS.map((key) => `Shift+${key}`), does: 'shift the view' },
  zoomIn: { where: 'view', keys: ['+', '='], does: 'nearer' },
  zoomOut: { where: 'view', keys: ['−'], does: 'further away' },
  fit: { where: 'view', keys: ['Home'], does: 'show the whole linkage' },
  side: { where: 'view', keys: ['1', '2', '3', '4', '5', '6', '7'], does: 'view from the front, back, left, right, top, bottom; isometric' },
  projection: { where: 'view', keys: ['P'], does: 'perspective or orthographic' },
  fitChosen: { where: 'view', keys: ['F'], does: 'bring what is selected into the middle' },
  thingBefore: { where: 'view', keys: ['[', ','], does: 'point at the thing before' },
  thingAfter: { where: 'view', keys: [']', '.'], does: 'point at the next thing' },
  choose: { where: 'view', keys: ['Enter'], does: 'select what is pointed at' },
  chooseNone: { where: 'view', keys: ['Escape'], does: 'select nothing' },
  move: { where: 'hand', keys: ['G', 'T'], does: 'move along axes' },
  turn: { where: 'hand', keys: ['R'], does: 'turn about axes' },
  freedoms: { where: 'hand', keys: ['D'], does: 'move along the freedoms that exist here, the workpiece only' },
  axes: { where: 'hand', keys: ['X', 'W'], does: 'axes of the world or its own' },
  nudge: { where: 'hand', keys: ['→', '←', '↑', '↓', ...PAGES], does: 'one step along or about x, y, z' },
  round: { where: 'hand', keys: ['Shift'], does: 'hold it while dragging: round steps', by: 'view3d/hand/pointer-drags.js' },
  letGo: { where: 'hand', keys: ['Escape'], does: 'take the drag back; let go of what is in hand' },
  oneFrame: { where: 'scrub', keys: ['←', '→'], does: 'one frame back or on', by: 'browser' },
  tenFrames: { where: 'scrub', keys: PAGES, does: 'ten frames on or back' },
  ends: { where: 'scrub', keys: ['Home', 'End'], does: 'first or last frame', by: 'browser' },
  keyFrame: { where: 'scrub', keys: ['Ctrl+←', 'Ctrl+→'], does: 'key frame before or after' },
  step: { where: 'bar', keys: [',', '.'], does: 'one frame back or on' },
  cell: { where: 'tables', keys: ['↑', '↓', 'Enter'], does: 'cell above or below', by: 'panels/tables/grid-keys.js' },
  block: { where: 'tables', keys: ['Shift+arrows'], does: 'choose a block of cells; Ctrl+C copies it, Delete clears it', by: 'panels/tables/cell-block.js' },
  paste: { where: 'tables', keys: ['Ctrl+V'], does: 'fill cells with a block from a spreadsheet; key frames are added as needed', by: 'browser' },
  number: { where: 'tables', keys: PAGES, does: 'change the number by a step; with Shift by ten', by: 'panels/tables/number-slide.js' },
  reorder: { where: 'tables', keys: ['Alt+↑', 'Alt+↓'], does: 'move this joint, chain or key frame up or down', by: 'panels/tables/reorder.js' },
  nextCell: { where: 'tables', keys: ['Tab'], does: 'next cell', by: 'browser' },
  oldValue: { where: 'tables', keys: ['Escape'], does: 'give the cell its old value', by: 'panels/tables/cells.js' },
  object: { where: 'tree', keys: ARROWS, does: 'go through the objects, open and close branches', by: 'panels/tree.js' },
  chooseObject: { where: 'tree', keys: ['Space', 'Enter'], does: 'select; Enter goes to its table', by: 'panels/tree.js' },
};

/** @typedef {keyof typeof KEYS} KeyId */

/** @type {Record<string, string>} */
const WRITTEN = { ' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', PageUp: 'Page Up', PageDown: 'Page Down', '-': '−' };

/** A pressed key as the list writes it. @param {Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>} event */
export function written({ key, ctrlKey, metaKey, altKey, shiftKey }) {
  // Which signs need Shift is the keyboard's matter; that a letter is large may come from Caps Lock.
  const sign = key.length === 1 && key !== ' ' && key.toLowerCase() === key.toUpperCase();
  return `${ctrlKey || metaKey ? 'Ctrl+' : ''}${altKey ? 'Alt+' : ''}${shiftKey && !sign ? 'Shift+' : ''}${WRITTEN[key] ?? (key.length === 1 ? key.toUpperCase() : key)}`;
}

/**
 * @param {EventTarget} target
 * @param {Partial<Record<KeyId, Handler>>} handlers of keys, which hold in different places or are different
 * @param {AddEventListenerOptions} [options]
 */
export function onKeys(target, handlers, options) {
  const listen = (/** @type {KeyboardEvent} */ event) => {
    if (event.defaultPrevented) return;
    const key = written(event);
    for (const [id, act] of /** @type {[KeyId, Handler][]} */ (Object.entries(handlers))) {
      const at = KEYS[id].keys.indexOf(key);
      if (at < 0 || act(event, at) === false) continue;
      return event.preventDefault();
    }
  };
  target.addEventListener('keydown', /** @type {EventListener} */ (listen), options);
}

/** As a tooltip: what is done, and its key. @param {string} words @param {KeyId} id @param {number} [at] which of its keys */
export const withKey = (words, id, at = 0) => `${words} (${KEYS[id].keys[at]})`;

/** As `aria-keyshortcuts` wants it. @param {string} key as in the list */
export function spokenKey(key) {
  const [, held, last] = /** @type {RegExpExecArray} */ (/^((?:\w+\+)*)(.+)$/.exec(key));
  const name = last === 'Space' ? last : Object.keys(WRITTEN).find((one) => WRITTEN[one] === last);
  return held.replace('Ctrl', 'Control') + (name ?? last);
}

/** Gives a button its tooltip. @param {HTMLElement} button @param {string} words @param {KeyId} id @param {number} [at] */
export function keyTip(button, words, id, at = 0) {
  button.title = withKey(words, id, at);
  button.setAttribute('aria-keyshortcuts', spokenKey(KEYS[id].keys[at]));
}
