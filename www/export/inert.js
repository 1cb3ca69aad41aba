/**
 * Code that is to stand in a script tag.
 */

/** What would end a script's element, or hide its end, inside of its strings. @param {string} code */
export const inert = (code) => code.replaceAll('\r', '\\r').replace(/<\/(script)/gi, '<\\/$1').replaceAll('<!--', '<\\!--');
