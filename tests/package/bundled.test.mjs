// A small project that has the package installed: its TypeScript compiles, Vite builds it, and the page lives.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { build, createServer } from 'vite';
import { installed } from './installed.mjs';
import { alive, course, open, openBrowser, serve } from './site.mjs';

const tsc = fileURLToPath(new URL('../../node_modules/.bin/tsc', import.meta.url));

const MAIN = `
import 'synthetica/element';
import { configure, plan, DocumentFault, type Motion } from 'synthetica';
import type * as inline from 'synthetica/inline';
import type { Chain, MechanismDocument } from 'synthetica/types';
import sample from 'synthetica/samples/2tpr.json';

const linkage = document.querySelector('synthetica-linkage')!;
linkage.addEventListener('framechange', ({ detail }) => { document.title = detail.frame.toFixed(0); });
linkage.addEventListener('error', ({ detail }) => console.warn(detail.where, detail.message));
linkage.addEventListener('click', ({ clientX }) => clientX.toFixed());
linkage.bounce = true;

const chain: Chain = { joints: [{ type: 'R', rows: [{ alpha: 90 }] }] };
export const made: MechanismDocument = { version: 1, chains: [chain], motion: { key_frames: [{ x: 1 }, { roll: 30 }] } };

export const given: Parameters<typeof configure>[0] = { wasm: new Response(), worker: new URL('https://example.org/worker.js') };
export const all: typeof inline.plan = plan;
export const left: typeof inline.SyntheticaLinkage | undefined = globalThis.synthetica?.SyntheticaLinkage;
const motion: Motion = await plan(sample);
document.body.dataset.rank = String(motion.report.mobility_rank);
try {
  await plan({ ...sample, version: 2 });
} catch (error) {
  if (error instanceof DocumentFault) document.body.dataset.where = error.where;
}
`;

let browser, project;
before(async () => {
  browser = await openBrowser();
  project = installed();
  writeFileSync(join(project, 'main.ts'), MAIN);
  writeFileSync(join(project, 'index.html'), course('<script type="module" src="./main.ts"></script>'));
});
after(() => browser.close());

for (const [name, module, resolution] of [['a bundler’s', 'esnext', 'bundler'], ['Node’s', 'nodenext', 'nodenext']]) {
  test(`TypeScript compiles by ${name} rules, the declarations themselves too`, () => {
    const options = ['--noEmit', '--strict', '--target', 'es2022', '--module', module, '--moduleResolution', resolution, '--resolveJsonModule', '--types', ''];
    const code = resolution === 'nodenext' ? MAIN.replace("2tpr.json'", "2tpr.json' with { type: 'json' }") : MAIN;
    const file = join(project, `${resolution}.ts`);
    writeFileSync(file, code);
    execFileSync(tsc, [...options, file], { cwd: project, encoding: 'utf8', stdio: ['ignore', 'inherit', 'inherit'] });
    // What is wrong is refused, so that the types are not just anything.
    for (const wrong of ["linkage.loop = 'never';", "plan(12);", "plan(sample, { signal: 5 });", "configure({ worker: 5 });", "inline.nothing;", "motion.report.nothing;"]) {
      writeFileSync(file, `${code}\n${wrong}`);
      assert.throws(() => execFileSync(tsc, [...options, file], { cwd: project, stdio: 'pipe' }), wrong);
    }
  });
}

test('Vite builds what imports from the one script, which asks for no file', async () => {
  const own = join(project, 'own');
  mkdirSync(own);
  writeFileSync(join(own, 'main.js'), "import { plan } from 'synthetica/inline';\nimport sample from 'synthetica/samples/2tpr.json';\ndocument.body.dataset.frames = String((await plan(sample)).frames);\n");
  writeFileSync(join(own, 'index.html'), course('<script type="module" src="./main.js"></script>'));
  await build({ root: own, configFile: false, base: './', logLevel: 'error', build: { target: 'es2022' } });
  const site = await serve({ '/': pathToFileURL(join(own, 'dist/')) });
  after(() => site.close());
  const { page, problems, requests } = await open(browser, `${site.address}/index.html`);
  await page.waitForFunction(() => document.body.dataset.frames === '129');
  assert.equal(await alive(page), 129);
  assert.ok(!requests.some((address) => /wasm|worker/.test(address)), requests.join());
  assert.deepEqual(problems, []);
});

/** @param {import('playwright-core').Page} page */
async function lives(page) {
  assert.equal(await alive(page), 129);
  await page.waitForFunction(() => document.body.dataset.where);
  assert.deepEqual(await page.evaluate(() => ({ ...document.body.dataset })), { rank: '2', where: 'version' });
  // One for all elements, one for the program.
  assert.equal(page.workers().length, 2);
  assert.equal(await page.getAttribute('synthetica-linkage', 'bounce'), '');
}

test('Vite builds it, with its own defaults', async () => {
  await build({ root: project, configFile: false, base: './', logLevel: 'error', build: { target: 'es2022' } });
  const site = await serve({ '/deep/down/': pathToFileURL(join(project, 'dist/')) });
  after(() => site.close());
  const { page, problems, requests } = await open(browser, `${site.address}/deep/down/index.html`);
  await lives(page);
  assert.ok(requests.some((address) => /assets\/synthetica-[\w-]+\.wasm$/.test(address)), 'the wasm is an asset of the build');
  assert.deepEqual(problems, []);
});

test('Vite serves it while one works on it, as the README says', async () => {
  const server = await createServer({ root: project, configFile: false, logLevel: 'error', server: { port: 0, host: '127.0.0.1' }, optimizeDeps: { exclude: ['synthetica'] } });
  await server.listen();
  after(() => server.close());
  const { page } = await open(browser, server.resolvedUrls.local[0]);
  await lives(page);
});
