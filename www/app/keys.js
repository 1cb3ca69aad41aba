/**
 * The page's keys, as Help lists them: what each does, and where it works. A part that listens to keys adds its own here.
 *
 * @typedef {{keys: string[], does: string, where: string}} Key
 */

/** @type {Key[]} */
export const KEYS = [
  { keys: ['Space'], does: 'play or pause', where: 'Anywhere but in a field' },
  { keys: ['?'], does: 'show these keys', where: 'Anywhere but in a field' },
  { keys: ['Ctrl+Z'], does: 'undo; a linkage that was moved by hand first goes back', where: 'Anywhere' },
  { keys: ['Ctrl+Shift+Z', 'Ctrl+Y'], does: 'redo', where: 'Anywhere' },
  { keys: ['←', '→', '↑', '↓'], does: 'turn the view', where: '3D view' },
  { keys: ['Shift+arrows'], does: 'shift the view', where: '3D view' },
  { keys: ['+', '−'], does: 'zoom', where: '3D view' },
  { keys: ['Home'], does: 'show the whole linkage', where: '3D view' },
  { keys: ['1', '2', '3', '4', '5', '6', '7'], does: 'view from the front, back, left, right, top, bottom; isometric', where: '3D view' },
  { keys: ['P'], does: 'perspective or orthographic', where: '3D view' },
  { keys: ['F'], does: 'bring what is selected into the middle', where: '3D view' },
  { keys: ['[', ']', ',', '.'], does: 'point at the thing before or after', where: '3D view' },
  { keys: ['Enter'], does: 'select what is pointed at', where: '3D view' },
  { keys: ['Escape'], does: 'select nothing', where: '3D view' },
  { keys: ['G', 'R'], does: 'move or turn what is in hand', where: '3D view, a key frame or the workpiece selected' },
  { keys: ['D'], does: 'move along the freedoms that exist here', where: '3D view, the workpiece selected' },
  { keys: ['X'], does: 'along the axes of the world or its own', where: '3D view, a key frame or the workpiece selected' },
  { keys: ['←', '→', '↑', '↓', 'Page Up', 'Page Down'], does: 'one step along or about x, y, z', where: '3D view, a key frame or the workpiece selected' },
  { keys: ['Shift'], does: 'hold it while dragging: round steps', where: '3D view, a key frame or the workpiece selected' },
  { keys: ['Escape'], does: 'take the drag back; let go of what is in hand', where: '3D view, a key frame or the workpiece selected' },
  { keys: ['←', '→'], does: 'one frame back or on', where: 'Scrub bar' },
  { keys: ['Page Up', 'Page Down'], does: 'ten frames on or back', where: 'Scrub bar' },
  { keys: ['Home', 'End'], does: 'first or last frame', where: 'Scrub bar' },
  { keys: ['Ctrl+←', 'Ctrl+→'], does: 'key frame before or after', where: 'Scrub bar' },
  { keys: [',', '.'], does: 'one frame back or on', where: 'Animation bar, charts' },
  { keys: ['↑', '↓', 'Enter'], does: 'cell above or below', where: 'Tables' },
  { keys: ['Shift+arrows'], does: 'choose a block of cells; Ctrl+C copies it, Delete clears it', where: 'Tables' },
  { keys: ['Ctrl+V'], does: 'fill cells with a block from a spreadsheet; key frames are added as needed', where: 'Tables' },
  { keys: ['Page Up', 'Page Down'], does: 'change the number by a step; with Shift by ten', where: 'Tables' },
  { keys: ['←', '→', '↑', '↓'], does: 'go through the objects, open and close branches', where: 'Object tree' },
  { keys: ['Space', 'Enter'], does: 'select; Enter goes to its table', where: 'Object tree' },
  { keys: ['Alt+↑', 'Alt+↓'], does: 'move this joint, chain or key frame up or down', where: 'Tables' },
  { keys: ['Tab'], does: 'next cell', where: 'Tables' },
  { keys: ['Escape'], does: 'give the cell its old value', where: 'Tables' },
];
