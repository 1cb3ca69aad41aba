/**
 * Text for the clipboard.
 */

/** What is said beside a text that could not be copied, and has been selected. */
export const NOT_COPIED = 'This browser does not let pages copy: it is selected, copy it with Ctrl+C.';

/** @param {string} text @returns {Promise<boolean>} false where the browser does not let a page copy */
export async function copyText(text) {
  try {
    // Without HTTPS there is no clipboard.
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
