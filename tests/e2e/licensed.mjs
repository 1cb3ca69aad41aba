// What other people's code is in the wasm and in the page, and whether a text names all of it with its licence, for tests.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));
const read = (path) => readFileSync(join(root, path), 'utf8');

/** Blanks, line ends, the two ways to write a copyright sign, and letters as a script of ASCII has them do not tell texts apart. @param {string} text */
const plain = (text) =>
  text.replaceAll(/\\u([\da-f]{4})/g, (_, code) => String.fromCharCode(parseInt(code, 16))).replaceAll('©', '(c)').replaceAll(/\s+/g, ' ').trim();

/** Texts of licence files in a folder. @param {string} folder */
const licencesIn = (folder) => readdirSync(folder).filter((file) => /^(un)?licen[cs]e/i.test(file)).map((file) => readFileSync(join(folder, file), 'utf8'));

/** Every crate that is linked into the wasm, as Cargo unpacked it. @returns {{name: string, version: string, texts: string[]}[]} */
export function crates() {
  const tree = execFileSync('cargo', ['tree', '--locked', '--edges', 'normal,no-proc-macro', '--target', 'wasm32-unknown-unknown', '--prefix', 'none'], { cwd: root, encoding: 'utf8' });
  const lines = new Set(tree.split('\n').filter((line) => line && !line.includes('(/')).map((line) => line.split(' ').slice(0, 2).join(' ')));
  const sources = join(process.env.CARGO_HOME || join(homedir(), '.cargo'), 'registry/src');
  const locked = read('Cargo.lock');
  return [...lines].map((line) => {
    const [name, version] = line.split(' v');
    assert.ok(locked.includes(`name = "${name}"\nversion = "${version}"`), `${line} is locked`);
    const folder = readdirSync(sources).map((registry) => join(sources, registry, `${name}-${version}`)).find(existsSync);
    // Where a crate comes without it, it is kept from its repository.
    const kept = join(root, 'tools/licences', name);
    return { name, version, texts: [folder, ...(existsSync(kept) ? [kept] : [])].flatMap(licencesIn) };
  });
}

/** npm packages, in the versions of the lock file. @param {string[]} names */
export const packages = (names) =>
  names.map((name) => ({ name, version: JSON.parse(read('tools/package-lock.json')).packages[`node_modules/${name}`].version, texts: licencesIn(join(root, 'tools/node_modules', name)) }));

/** What the page's own modules import that is not its own. */
export function imported() {
  const modules = readdirSync(join(root, 'www'), { recursive: true }).filter((file) => file.endsWith('.js') && !/^(dist|pkg|pkg-first)\//.test(file));
  const names = modules.flatMap((file) => [...read(`www/${file}`).matchAll(/^import (?:.* from )?'([@\w][^'.]*)';$/gm)].map(([, name]) => name));
  return [...new Set(names)].sort();
}

/** @param {string} text @param {{name: string, version: string, texts: string[]}[]} parts */
export function assertLicensed(text, parts) {
  const whole = plain(text);
  assert.ok(parts.length > 0);
  for (const { name, version, texts } of parts) {
    assert.ok(text.includes(`\n${name} ${version}, `), `${name} ${version} is listed`);
    assert.ok(texts.some((licence) => whole.includes(plain(licence))), `the licence of ${name} ${version} is there`);
  }
}
