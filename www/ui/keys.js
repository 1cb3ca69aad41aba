/**
 * The page's keys: the one list from which the help, the tooltips and the handlers come.
 *
 * @typedef {object} Key
 * @property {keyof typeof PLACES} where
 * @property {string[]} keys as they are written: `Ctrl+Z`; Command is as good as Ctrl
 * @property {string} does
 * @property {true} [native] the browser does it, or makes an event of it such as `paste`; else a handler names the entry
 *
 * @typedef {(event: KeyboardEvent, at: number) => unknown} Handler `at`: which of the entry's keys; false: the key was not meant
 */

/** Where keys hold, as the help says it. */
export const PLACES = {
  all: 'Anywhere',
  page: 'Anywhere but in a field',
  view: '3D view',
  stage: '3D view, animation bar',
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
  viewOnly: { where: 'stage', keys: ['V'], does: 'only the view and the animation bar; once more, all panels' },
  allPanels: { where: 'page', keys: ['Escape'], does: 'bring the panels back, where nothing else wants the key' },
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
  round: { where: 'hand', keys: ['Shift'], does: 'hold it while dragging: round steps' },
  letGo: { where: 'hand', keys: ['Escape'], does: 'take the drag back; let go of what is in hand' },
  oneFrame: { where: 'scrub', keys: ['←', '→'], does: 'one frame back or on', native: true },
  tenFrames: { where: 'scrub', keys: PAGES, does: 'ten frames on or back' },
  ends: { where: 'scrub', keys: ['Home', 'End'], does: 'first or last frame', native: true },
  keyFrame: { where: 'scrub', keys: ['Ctrl+←', 'Ctrl+→'], does: 'key frame before or after' },
  step: { where: 'bar', keys: [',', '.'], does: 'one frame back or on' },
  cell: { where: 'tables', keys: ['↑', '↓'], does: 'cell above or below' },
  cellAside: { where: 'tables', keys: ['←', '→'], does: 'at the end of its text: cell to the left or right' },
  nextCell: { where: 'tables', keys: ['Tab'], does: 'next cell', native: true },
  keepValue: { where: 'tables', keys: ['Enter', 'Shift+Enter'], does: 'keep what is typed; cell below or above' },
  oldValue: { where: 'tables', keys: ['Escape'], does: 'give the cell its old value; choose no block of cells' },
  number: { where: 'tables', keys: PAGES, does: 'change the number by a step' },
  numberTen: { where: 'tables', keys: PAGES.map((key) => `Shift+${key}`), does: 'change the number by ten steps' },
  slideTen: { where: 'tables', keys: ['Shift'], does: 'hold it while dragging the slider of a number: ten steps' },
  parameter: { where: 'tables', keys: ['Alt+Enter'], does: 'make a parameter of the number' },
  block: { where: 'tables', keys: ARROWS.map((key) => `Shift+${key}`), does: 'choose a block of cells' },
  clearBlock: { where: 'tables', keys: ['Delete', 'Backspace'], does: 'clear the block' },
  copy: { where: 'tables', keys: ['Ctrl+C'], does: 'copy the block', native: true },
  paste: { where: 'tables', keys: ['Ctrl+V'], does: 'fill cells with a block from a spreadsheet; key frames are added as needed', native: true },
  reorder: { where: 'tables', keys: ['Alt+↑', 'Alt+↓'], does: 'move this joint, chain or key frame up or down' },
  object: { where: 'tree', keys: ARROWS, does: 'go through the objects, open and close branches' },
  chooseObject: { where: 'tree', keys: ['Space'], does: 'select' },
  enterObject: { where: 'tree', keys: ['Enter'], does: 'select, and go to its table' },
};

/** @typedef {keyof typeof KEYS} KeyId */

/** @type {Record<string, string>} */
const WRITTEN = { ' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', PageUp: 'Page Up', PageDown: 'Page Down', '-': '−' };

/** A pressed key as the list writes it. @param {Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>} event */
export function written({ key, ctrlKey, metaKey, altKey, shiftKey }) {
  // Which signs need Shift is the keyboard's matter; that a letter is large may come from Caps Lock.
  const sign = key.length === 1 && key !== ' ' && key.toLowerCase() === key.toUpperCase();
  // Windows tells AltGr, with which some keyboards type signs, as Ctrl and Alt.
  if (sign && ctrlKey && altKey) return WRITTEN[key] ?? key;
  return `${ctrlKey || metaKey ? 'Ctrl+' : ''}${altKey ? 'Alt+' : ''}${shiftKey && !sign ? 'Shift+' : ''}${WRITTEN[key] ?? (key.length === 1 ? key.toUpperCase() : key)}`;
}

/**
 * A listener to `keydown`.
 * @param {Partial<Record<KeyId, Handler>>} handlers of keys, which hold in different places or are different
 */
export function keyListener(handlers) {
  return (/** @type {KeyboardEvent} */ event) => {
    if (event.defaultPrevented) return;
    const key = written(event);
    for (const [id, act] of /** @type {[KeyId, Handler][]} */ (Object.entries(handlers))) {
      const at = KEYS[id].keys.indexOf(key);
      if (at < 0 || act(event, at) === false) continue;
      return event.preventDefault();
    }
  };
}

/** @param {EventTarget} target @param {Parameters<typeof keyListener>[0]} handlers @param {AddEventListenerOptions} [options] */
export const onKeys = (target, handlers, options) => target.addEventListener('keydown', /** @type {EventListener} */ (keyListener(handlers)), options);

/** Whether a key that is held while one drags is down. @param {MouseEvent} event @param {KeyId} id */
export const isHeld = (event, id) => event.getModifierState(KEYS[id].keys[0]);

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

/** @type {Record<string, string>} */
const SIGNS = { '+': 'plus', '−': 'minus', '[': 'left bracket', ']': 'right bracket' };

/** For a label: what keys do, as a screen reader says it. @param {KeyId[]} ids */
export const inWords = (...ids) =>
  ids.map((id) => {
    const { keys, does } = KEYS[id];
    const [first] = keys;
    const many = first.endsWith('←') ? first.replace('←', 'arrow keys') : `${first} to ${keys[keys.length - 1]}`;
    return `${keys.length > 2 ? many : (SIGNS[first] ?? first)}: ${does}.`;
  }).join(' ');
