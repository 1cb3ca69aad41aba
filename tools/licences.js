// Which npm packages are in a build, and their licences: other people's code comes with them.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** @param {{moduleIds?: string[]}[]} output chunks of a build @returns {string[]} names of packages */
export function packagesIn(output) {
  const sources = output.flatMap(({ moduleIds = [] }) => moduleIds);
  return [...new Set(sources.map((id) => id.match(/\/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]).filter(Boolean))].sort();
}

/** With the page of each package, from which its source can be had. @param {string[]} packages */
export const licences = (packages) =>
  packages.map((name) => `${name}\nhttps://www.npmjs.com/package/${name}\n\n${readFileSync(at(`node_modules/${name}/LICENSE`), 'utf8').trim()}\n`).join('\n\n');
