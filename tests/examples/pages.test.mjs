// The example pages (examples/pages), each built by the tools of its kind and opened: the linkage in it is planned and drawn.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { dist, open, openBrowser, serve } from '../package/site.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const pages = join(root, 'examples/pages');
const modules = join(pages, 'node_modules');
/** What is built, in a folder that git ignores. */
const built = join(modules, '.built');
const python = process.env.EXAMPLES_PYTHON;

let browser;
let site;
let next;
before(async () => {
  assert.ok(python, 'EXAMPLES_PYTHON is not set: scripts/dev.sh test sets it to a Python that has tests/examples/requirements.txt');
  // A copy, as an installed package is: the link that npm makes leads out of the project, where bundlers do not follow.
  const installed = join(modules, 'synthetica');
  rmSync(installed, { recursive: true, force: true });
  cpSync(fileURLToPath(dist), installed, { recursive: true });
  rmSync(built, { recursive: true, force: true });
  mkdirSync(built, { recursive: true });
  site = await serve({ '/built/': pathToFileURL(`${built}/`), '/': pathToFileURL(`${pages}/`) });
  // Its pages ask for their files from the root of the server.
  next = await serve({ '/': pathToFileURL(join(pages, 'next/out/')) });
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
  site?.close();
  next?.close();
});

/** Runs a tool in a folder of the examples; where it fails, what it said is the error. @param {string} folder @param {string} program @param {string[]} words */
function run(folder, program, ...words) {
  try {
    return execFileSync(program, words, { cwd: join(pages, folder), encoding: 'utf8', stdio: 'pipe', env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1' } });
  } catch (error) {
    throw new Error(`${program} ${words.join(' ')}:\n${error.stdout}\n${error.stderr}`);
  }
}

const vite = (folder) => run(folder, 'node', join(modules, 'vite/bin/vite.js'), 'build', '--base', './', '--outDir', join(built, folder), '--logLevel', 'error');

/** Opens a page and waits until its linkage is planned and drawn. @param {string} path */
async function lives(path, server = site) {
  const opened = await open(browser, `${server.address}/${path}`);
  const linkage = opened.page.locator('synthetica-linkage');
  await linkage.scrollIntoViewIfNeeded();
  await opened.page.waitForFunction(() => document.querySelector('synthetica-linkage').trajectory?.frames === 129);
  await opened.page.waitForFunction(() => document.querySelector('synthetica-linkage').shadowRoot.querySelector('canvas')?.dataset.draws > 0);
  const { width, height } = await linkage.boundingBox();
  assert.ok(width > 250 && height > 150, `${width} x ${height}`);
  return opened;
}

test('a plain page', async () => {
  const { problems } = await lives('plain/index.html');
  assert.deepEqual(problems, []);
});

test('a slide of reveal.js: what is typed in the linkage does not change the slide', async () => {
  const { page, problems } = await lives('reveal/index.html#/1');
  const slide = () => page.evaluate(() => window.Reveal.getIndices().h);
  const cell = page.locator('[data-path="chains[0].base.x"]');
  await cell.fill('0.25');
  await cell.press('ArrowLeft');
  await cell.press('Home');
  await cell.pressSequentially('0.');
  await page.locator('synthetica-linkage #canvas').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await slide(), 1);
  assert.equal(await page.evaluate(() => window.Reveal.isPaused()), false);
  // Where the linkage has not the focus, the keys are the slides'.
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.keyboard.press('ArrowRight');
  assert.equal(await slide(), 2);
  assert.deepEqual(problems, []);
});

for (const [name, folder] of [['React', 'react'], ['Vue', 'vue'], ['Svelte', 'svelte']]) {
  test(`${name}, built by Vite: the document is a property, the event a handler`, async () => {
    vite(folder);
    const { page, problems } = await lives(`built/${folder}/index.html`);
    await page.evaluate(() => {
      document.querySelector('synthetica-linkage').frame = 12;
    });
    await page.getByText('Frame 12', { exact: true }).waitFor();
    assert.deepEqual(problems, []);
  });
}

test('the React page’s types are right, and a wrong one is refused', () => {
  const tsc = join(root, 'node_modules/.bin/tsc');
  const options = ['--noEmit', '--strict', '--target', 'es2022', '--module', 'esnext', '--moduleResolution', 'bundler', '--resolveJsonModule', '--jsx', 'react-jsx', '--lib', 'es2022,dom,dom.iterable'];
  run('react', tsc, ...options, 'main.tsx');
  // Copied to where the installed packages are found.
  for (const name of ['right.tsx', 'wrong.tsx']) cpSync(join(root, 'tests/examples', name), join(built, name));
  run('react', tsc, ...options, join(built, 'right.tsx'));
  assert.throws(() => run('react', tsc, ...options, join(built, 'wrong.tsx')), /"some"' is not assignable to type '"ctrl"/);
});

test('Next plans in a server component, and the element lives in a client component', async () => {
  const said = run('next', 'node', join(modules, 'next/dist/bin/next'), 'build', '--webpack');
  assert.doesNotMatch(said, /synthetica|Critical dependency/);
  const { page, problems } = await lives('index.html', next);
  assert.match(readFileSync(join(pages, 'next/out/index.html'), 'utf8'), /3 freedoms, 129 frames/, 'planned before it was sent');
  assert.equal(await page.getByText('3 freedoms, 129 frames', { exact: true }).count(), 1);
  assert.deepEqual(problems, []);
});

/** Pages that other programs write have a copy of the one script beside them. @param {string} folder */
const scriptBeside = (folder) => cpSync(new URL('inline.js', dist), join(built, folder, 'synthetica/inline.js'));

/** What such a page asks of other hosts, which are not there in a test, is its own matter. @param {string[]} problems */
const ours = (problems) => problems.filter((text) => !/net::ERR|Failed to load resource/.test(text));

test('Jupyter’s HTML of a notebook', async () => {
  run('jupyter', python, '-m', 'nbconvert', '--log-level', 'ERROR', '--to', 'html', 'notebook.ipynb', '--output-dir', join(built, 'jupyter'));
  scriptBeside('jupyter');
  const { problems } = await lives('built/jupyter/notebook.html');
  assert.deepEqual(ours(problems), []);
});

test('a Quarto document, written by pandoc, which Quarto writes its HTML with', async () => {
  mkdirSync(join(built, 'quarto'));
  run('quarto', python, '-c', `import pypandoc; pypandoc.convert_file('lecture.qmd', 'html', format='markdown', outputfile=${JSON.stringify(join(built, 'quarto/lecture.html'))}, extra_args=['--standalone'])`);
  scriptBeside('quarto');
  const { problems } = await lives('built/quarto/lecture.html');
  assert.deepEqual(problems, []);
});

test('a site of MkDocs', async () => {
  run('mkdocs', python, '-m', 'mkdocs', 'build', '--quiet', '--site-dir', join(built, 'mkdocs'));
  scriptBeside('mkdocs');
  const { problems } = await lives('built/mkdocs/index.html');
  assert.deepEqual(ours(problems), []);
});

test('nothing that is built lies among them', () => {
  const files = execFileSync('git', ['ls-files', '.'], { cwd: pages, encoding: 'utf8' }).trim().split('\n');
  assert.ok(files.length > 10 && files.length < 40, `${files.length} files`);
  assert.deepEqual(files.filter((file) => /(^|\/)(\.next|dist|out|site|node_modules)\//.test(file)), []);
});

test('every folder is tested and named in the examples’ README', () => {
  const readme = readFileSync(join(pages, 'README.md'), 'utf8');
  const tests = readFileSync(fileURLToPath(import.meta.url), 'utf8');
  const folders = readdirSync(pages, { withFileTypes: true }).filter((entry) => entry.isDirectory() && entry.name !== 'node_modules');
  assert.equal(folders.length, 9);
  for (const { name } of folders) {
    assert.ok(readme.includes(`| \`${name}\` |`), `${name} in ${dirname(pages)}`);
    assert.ok(tests.includes(`'${name}`), name);
  }
});
