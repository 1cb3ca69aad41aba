/**
 * What a chain is called wherever the page speaks of it: the name that the document gives it, or its number.
 */

/** @param {{name?: string} | undefined} chain @param {number} index from 0 */
export const chainName = (chain, index) => chain?.name?.trim() || `chain ${index + 1}`;

/** As the first word of a sentence. @param {string} text */
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
