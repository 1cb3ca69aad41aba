/**
 * A solved motion as one short text and back: numbers as they are in memory, packed with gzip, in base64.
 *
 * @typedef {import('../core/types.js').Motion} Motion
 * @typedef {import('../core/types.js').MechanismDocument} MechanismDocument
 */

/**
 * The motion's columns, and how each is kept. What is only drawn has 7 digits as single floats; a double more would
 * double the file.
 */
const COLUMNS = /** @type {const} */ ({
  rows: Float32Array,
  time: Float64Array,
  goal: Float64Array,
  pose: Float64Array,
  joints: Float64Array,
  metric: Float64Array,
  translation_gap: Float64Array,
  rotation_gap: Float64Array,
  closure: Float64Array,
  misfit: Float64Array,
  sigma_min: Float64Array,
  projected_gradient: Float64Array,
  iterations: Uint32Array,
  status: Uint8Array,
});

/** @typedef {keyof typeof COLUMNS} Column */
const NAMES = /** @type {Column[]} */ (Object.keys(COLUMNS));

/**
 * @param {Motion} motion @param {MechanismDocument} doc
 * @param {MechanismDocument} plain what it stands for; the same where nothing is typed
 * @returns {Promise<string>}
 */
export async function pack(motion, doc, plain = doc) {
  const { frames, partial, goal_frames, report, milliseconds } = motion;
  const parts = NAMES.map((name) => new Uint8Array(COLUMNS[name].from(motion[name]).buffer));
  const head = new TextEncoder().encode(JSON.stringify({ doc, ...(plain !== doc && { plain }), frames, partial, goal_frames, report, milliseconds, bytes: parts.map((part) => part.length) }));
  const whole = new Blob([new Uint32Array([head.length]), head, ...parts]);
  const packed = await new Response(whole.stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer();
  return base64(new Uint8Array(packed));
}

/** @param {string} text @returns {Promise<{motion: Motion, doc: MechanismDocument, plain: MechanismDocument}>} */
export async function unpack(text) {
  const packed = Uint8Array.from(atob(text.trim()), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const whole = await new Response(stream).arrayBuffer();
  let at = 4 + new DataView(whole).getUint32(0, true);
  const { doc, plain = doc, bytes, ...rest } = JSON.parse(new TextDecoder().decode(whole.slice(4, at)));
  const columns = NAMES.map((name, index) => {
    const column = new COLUMNS[name](whole.slice(at, at + bytes[index]));
    at += bytes[index];
    return [name, name === 'rows' ? Float64Array.from(column) : column];
  });
  return { motion: { ...rest, ...Object.fromEntries(columns) }, doc, plain };
}

/** @param {Uint8Array} bytes */
function base64(bytes) {
  let text = '';
  // In pieces: a function takes only so many arguments.
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}
