/**
 * Rows of a long table that are rendered anew only where something that they show is another thing.
 *
 * @typedef {{key: unknown, of: unknown[], make: () => unknown}} Row `key` finds its nodes again; `of` is all that it shows, told
 *   apart by identity: an edit keeps the objects that it does not change
 */
import { guard } from 'lit-html/directives/guard.js';

/** @param {Pick<ReturnType<typeof import('./cells.js').createCells>, 'noting' | 'know'>} cells */
export function createKeptRows(cells) {
  /** @type {Map<unknown, {of: unknown[], noted: ReturnType<typeof cells.noting>}>} */
  let kept = new Map();

  /** @param {Row[]} rows @returns {{key: unknown, body: unknown}[]} */
  return (rows) => {
    const former = kept;
    kept = new Map();
    return rows.map(({ key, of, make }) => {
      const old = former.get(key);
      const stays = old?.of.length === of.length && of.every((part, at) => Object.is(part, old.of[at]));
      // Its cells are known all the same.
      if (stays) cells.know(old.noted.specs);
      const row = stays ? old : { of, noted: cells.noting(make) };
      kept.set(key, row);
      return { key, body: guard([row], () => row.noted.made) };
    });
  };
}
