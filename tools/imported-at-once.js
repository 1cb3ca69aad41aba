// Which modules belong together because one loads the others in any case.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/**
 * A script with all that it imports at once: what is loaded together in any case is one file, not twenty.
 * @param {string} entry
 */
export function importedAtOnce(entry) {
  const found = new Set();
  const visit = (file) => {
    if (found.has(file)) return;
    found.add(file);
    const text = readFileSync(file, 'utf8');
    for (const [, name] of text.matchAll(/^(?:import|export)\b[^'"(]*?(?:from )?'(\.[^'"]+\.js)'/gm)) visit(join(dirname(file), name));
  };
  visit(entry);
  return found;
}
