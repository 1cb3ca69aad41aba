// Licences of other people's code in a build: npm packages by the modules that are in it, crates by what Cargo puts into the wasm.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
const WASM = 'wasm32-unknown-unknown';
const LICENCE_FILE = /^(un)?licen[cs]e|^copying|^notice/i;

/**
 * @typedef {object} Part other people's code
 * @property {string} name
 * @property {string} version
 * @property {string} licence as it is declared, such as "MIT OR Apache-2.0"
 * @property {string} from where its source can be had
 * @property {string[]} texts of its licence and notices
 */

/** @param {{moduleIds?: string[]}[]} output chunks of a build @returns {string[]} names of npm packages whose code is in it */
export function packagesIn(output) {
  const sources = output.flatMap(({ moduleIds = [] }) => moduleIds);
  return [...new Set(sources.map((id) => id.match(/\/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]).filter(Boolean))].sort();
}

/**
 * Where a choice offers MIT it is taken, for it is short: the files of the others are left out.
 * @param {string} licence an expression such as "(MIT OR Apache-2.0) AND Unicode-3.0" or "MIT/Apache-2.0"
 * @returns {string[]} beginnings of licences that need not be given, in capitals
 */
function notChosen(licence) {
  const choices = licence.split(' AND ').map((part) => part.match(/[\w.-]+/g)?.filter((word) => word !== 'OR') ?? []);
  return choices.filter((ids) => ids.includes('MIT')).flatMap((ids) => ids.filter((id) => id !== 'MIT').map((id) => id.split('-')[0].toUpperCase()));
}

/**
 * The texts of a folder's licence files. It is an error that there are none.
 * @param {string} folder @param {{name: string, version: string, licence: string}} part @returns {string[]}
 */
export function licenceTexts(folder, { name, version, licence }) {
  const files = readdirSync(folder).filter((file) => LICENCE_FILE.test(file)).sort();
  if (!files.length) throw new Error(`${name} ${version} has no licence file in ${folder}: its code must not be shipped without one. Accepted names begin with LICENSE, LICENCE, COPYING, NOTICE or UNLICENSE`);
  const left = files.some((file) => /mit/i.test(file)) ? notChosen(licence) : [];
  const kept = files.filter((file) => !left.some((id) => file.toUpperCase().includes(id)));
  return kept.map((file) => readFileSync(join(folder, file), 'utf8').replaceAll('\r', '').trim());
}

/** @param {string} name of an npm package @returns {Part} */
function npmPart(name) {
  const folder = at(`node_modules/${name}`);
  const { version, license: licence, repository } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return { name, version, licence, from: (repository.url ?? repository).replace(/^git\+|\.git$/g, ''), texts: licenceTexts(folder, { name, version, licence }) };
}

/** Cargo, asked about the crate for the web; it needs no network once the crate has been built. @param {string[]} question */
function cargo(question) {
  try {
    return execFileSync('cargo', [...question, '--locked'], { cwd: at('..'), encoding: 'utf8', maxBuffer: 1e9, stdio: ['ignore', 'pipe', 'pipe'] });
  } catch (error) {
    throw new Error(`The crates in the wasm could not be listed for their licences, by cargo ${question[0]}: ${error.stderr || error.message}`);
  }
}

/** The standard library, which is in every wasm and in no lock file. @returns {Part} */
function standardLibrary() {
  const [, version] = execFileSync('rustc', ['--version'], { encoding: 'utf8' }).split(' ');
  const file = join(execFileSync('rustc', ['--print', 'sysroot'], { encoding: 'utf8' }).trim(), 'share/doc/rust/licenses/MIT.txt');
  if (!existsSync(file)) throw new Error(`Rust's standard library ${version} has no licence at ${file}: install Rust by rustup, which brings it`);
  // Its own file has places to fill in.
  const text = readFileSync(file, 'utf8').replaceAll('\r', '').trim().replace(/^.*<year>.*$/m, 'Copyright (c) The Rust Project Contributors');
  return { name: 'rust-std', version, licence: 'MIT OR Apache-2.0', from: 'https://github.com/rust-lang/rust', texts: [text] };
}

let crates;
/**
 * Where a crate's licence lies: with it, or in tools/licences/ where only its repository has it.
 * @param {string} name @param {string} folder
 */
function licenceFolder(name, folder) {
  const ours = at(`licences/${name}`);
  return existsSync(ours) ? ours : folder;
}

/** The crates whose code is in the wasm, the standard library among them. @returns {Part[]} */
function cratesInWasm() {
  if (crates) return crates;
  // The tree knows which optional dependencies are on, the metadata where their sources are.
  const tree = cargo(['tree', '--edges', 'normal,no-proc-macro', '--target', WASM, '--prefix', 'none', '--format', '{p}']);
  const inIt = new Set(tree.split('\n').map((line) => line.split(' ').slice(0, 2).join(' ')));
  const { packages, resolve } = JSON.parse(cargo(['metadata', '--format-version', '1', '--filter-platform', WASM]));
  const parts = packages
    .filter(({ id, name, version }) => inIt.has(`${name} v${version}`) && id !== resolve.root)
    .map(({ name, version, license: licence, repository, manifest_path: manifest }) => ({
      name, version, licence, from: repository, texts: licenceTexts(licenceFolder(name, dirname(manifest)), { name, version, licence }),
    }));
  crates = [...parts, standardLibrary()].sort((a, b) => (a.name < b.name ? -1 : 1));
  return crates;
}

/** Other people's code in a build. @param {string[]} packages of npm @param {{wasm: boolean}} has @returns {Part[]} */
export const partsOf = (packages, { wasm }) => [...packages.map(npmPart), ...(wasm ? cratesInWasm() : [])];

/** A list of what is in a build, then every licence once, below the names that it is for. @param {Part[]} parts */
export function licences(parts) {
  /** @type {Map<string, string[]>} by the words without their line ends */
  const names = new Map();
  const texts = new Map();
  for (const { name, version, texts: own } of parts)
    for (const text of own) {
      const key = text.replace(/\s+/g, ' ');
      names.set(key, [...(names.get(key) ?? []), `${name} ${version}`]);
      texts.set(key, texts.get(key) ?? text);
    }
  const list = parts.map(({ name, version, licence, from }) => `${name} ${version}, ${licence}, ${from}`);
  const each = [...names].map(([key, whose]) => `${'-'.repeat(72)}\n${whose.join(', ')}\n\n${texts.get(key)}`);
  return `${list.join('\n')}\n\n${each.join('\n\n')}\n`;
}

/** Synthetica itself, whose licence goes with it where it is not beside it. @returns {Part} */
export function ourselves() {
  const [, version] = readFileSync(at('../Cargo.toml'), 'utf8').match(/^version = "(.*)"$/m);
  return { name: 'synthetica', version, licence: 'MIT OR Apache-2.0', from: 'this program', texts: [readFileSync(at('../LICENSE-MIT'), 'utf8').trim()] };
}

/** A comment for a script that leaves the site alone: what is in it, with all licences. @param {string[]} packages @param {{wasm: boolean}} has */
export function licenceComment(packages, has) {
  const text = licences([ourselves(), ...partsOf(packages, has)]);
  return `/*! ${text.replaceAll('*/', '* /').replaceAll('©', '(c)').trim()}\n*/\n`;
}
