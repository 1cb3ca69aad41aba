// The digests of examples/digest.rs, for a motion as JavaScript has it; runs in Node and in a page.

/** The columns of a motion that are compared: all that hold numbers. */
export const COLUMNS = [
  'time', 'goal', 'pose', 'joints', 'rows', 'metric', 'translation_gap', 'rotation_gap', 'closure', 'misfit', 'sigma_min', 'projected_gradient', 'iterations', 'status',
];

/** FNV-1a over 64-bit words. @param {Iterable<bigint>} words */
function digest(words) {
  let count = 0;
  let hash = 0xcbf29ce484222325n;
  for (const word of words) {
    hash = BigInt.asUintN(64, (hash ^ word) * 0x100000001b3n);
    count += 1;
  }
  return `${count}:${hash.toString(16).padStart(16, '0')}`;
}

/** A number's bits; a count as it is. @param {Float64Array | Uint32Array | Uint8Array} column */
const wordsOf = (column) => (column instanceof Float64Array ? new BigUint64Array(column.slice().buffer) : Array.from(column, BigInt));

export const digests = (motion) => Object.fromEntries(COLUMNS.map((name) => [name, digest(wordsOf(motion[name]))]));
