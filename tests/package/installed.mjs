// The package as others get it: packed, and installed from its file into a project of its own.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { dist } from './site.mjs';

const npm = (cwd, ...args) => execFileSync('npm', [...args, '--offline', '--no-audit', '--no-fund', '--loglevel=error'], { cwd, encoding: 'utf8' });

let project;

/** The project's folder, which is there until the tests end. */
export function installed() {
  if (project) return project;
  project = mkdtempSync(join(tmpdir(), 'project-'));
  process.on('exit', () => rmSync(project, { recursive: true }));
  writeFileSync(join(project, 'package.json'), '{ "private": true, "type": "module" }');
  const [{ filename }] = JSON.parse(npm(project, 'pack', fileURLToPath(dist), '--json'));
  npm(project, 'install', `./${filename}`);
  return project;
}
