// The rooms of www/: modules import only from rooms further down in the list.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const www = fileURLToPath(new URL('../../www/', import.meta.url));

/** From the top down. `planner/api.js` is what programs use; it stands on the page's modules. */
const FLOORS = ['app', 'embed', 'element', 'export', 'player-page', 'panels', 'bar', 'view3d', 'planner/api.js', 'core', 'planner', 'ui'];

/** @param {string} file from www/ */
const floorOf = (file) => (FLOORS.includes(file) ? FLOORS.indexOf(file) : FLOORS.indexOf(file.split('/')[0]));

/** Types do not count: `import('…')` in a comment loads nothing. @param {string} file from www/ */
const importsOf = (file) =>
  [...readFileSync(join(www, file), 'utf8').replaceAll(/\/\*[^]*?\*\//g, '').matchAll(/(?:\bfrom |^import |\bimport\()'(\.[^'?]+\.js)'/gm)].map(([, name]) => join(file, '..', name));

const files = readdirSync(www, { recursive: true, withFileTypes: true })
  .map((entry) => join(entry.parentPath, entry.name).slice(www.length))
  .filter((file) => file.endsWith('.js') && floorOf(file) >= 0);

test('imports point down', () => {
  assert.ok(files.length > 150);
  const up = files.flatMap((file) => importsOf(file).filter((target) => floorOf(target) >= 0 && floorOf(target) < floorOf(file)).map((target) => `${file} imports ${target}`));
  assert.deepEqual(up, []);
});

test('every room is in the list', () => {
  const known = [...FLOORS, 'dist', 'lessons', 'mechanisms', 'pages', 'pkg', 'pkg-first', 'public', 'style', 'thumbnails'];
  const rooms = readdirSync(www, { withFileTypes: true }).filter((entry) => entry.isDirectory()).map(({ name }) => name);
  assert.deepEqual(rooms.filter((room) => !known.includes(room)), []);
});
