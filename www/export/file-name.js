/**
 * What the file of a document is called: 3rps.csv.
 */

/**
 * @param {{name?: string} | null} doc
 * @param {string} ending
 */
export function fileName(doc, ending) {
  const plain = (doc?.name ?? '')
    .normalize('NFKD')
    .toLowerCase()
    .replace(/[’'\u0300-\u036f]/g, '')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-|-$/g, '');
  return `${plain || 'linkage'}.${ending}`;
}
