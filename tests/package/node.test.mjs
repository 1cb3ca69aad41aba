// The package in Node: planned without a browser, as its README says.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { dist } from './site.mjs';
import { installed } from './installed.mjs';

const sample = (name) => readFileSync(new URL(`samples/${name}.json`, dist), 'utf8');
const readme = readFileSync(new URL('README.md', dist), 'utf8');
const { open, plan, check, normalise, findStart, pull, drive, explain, trace, matrix, compareMetrics, exportMotion, schema, enumeration, chainByIndex, assemblyByIndex, assemble, make, makers, makeNamed, readPoses, at, DocumentFault } = await import(
  new URL('index.node.js', dist)
);

/** Runs a program beside the installed package; gives its lines. @param {string} code */
const run = (code) => execFileSync('node', ['--input-type=module', '-e', code], { cwd: installed(), encoding: 'utf8' }).trim().split('\n');

test('three lines plan, and the programs of both READMEs run as printed', () => {
  const given = "import { readFileSync, readdirSync } from 'node:fs';\nconst document = JSON.parse(readFileSync('node_modules/synthetica/samples/3rps.json', 'utf8'));\n";
  const [three] = run(`${given}import { plan } from 'synthetica';\nconst motion = await plan(document);\nconsole.log(motion.report.mobility_rank)`);
  assert.equal(three, '3');
  const programs = (text) => [...text.matchAll(/```js\n([\s\S]*?)```/g)].map(([, code]) => code).filter((code) => !code.includes('synthetica/element'));
  const [short, long, session] = programs(readme).map((code) => run(given + code));
  const [own] = programs(readFileSync(new URL('../../README.md', import.meta.url), 'utf8')).map((code) => run(given + code));
  for (const [line] of [short, own]) assert.match(line, /^3 129 \d\.\d+e-\d+$/);
  assert.match(long[0], /^(reached|closest) \w+ 0\.2 \d+$/);
  assert.equal(long[1], 'unknown-version version true');
  assert.match(session[0], /^(all|\d+ of 129) 3$/);
});

test('what the exports name is there', () => {
  const [line] = run(`
    const at = (name) => import.meta.resolve('synthetica/' + name);
    import { readFileSync, readdirSync } from 'node:fs';
    console.log(['element', 'frame', 'inline', 'worker', 'types', 'wasm', 'schema', 'samples/3rps.json', 'package.json'].map((name) => readFileSync(new URL(at(name))).length > 0).join());`);
  assert.equal(line, Array(9).fill('true').join());
});

test('a server that renders pages may load the element', () => {
  const lines = run("import { SyntheticaLinkage } from 'synthetica/element'; import { linkageFrame } from 'synthetica/frame'; import 'synthetica/inline'; console.log(typeof SyntheticaLinkage, typeof linkageFrame);");
  assert.deepEqual(lines, ['function function']);
});

test('bundlers can follow every import and every address of the modules', () => {
  const modules = readdirSync(dist).filter((name) => name.endsWith('.js') && name !== 'inline.js');
  assert.ok(modules.length > 20);
  for (const name of modules) {
    const code = readFileSync(new URL(name, dist), 'utf8').replace(/^\s*(\/\/|\*|\/\*).*$/gm, '');
    for (const [call, first] of code.matchAll(/\bimport\((?:\/\*.*?\*\/)?\s*(.)/g)) assert.match(first, /["'`]/, `${name}: ${call}`);
    for (const [call, address] of code.matchAll(/new URL\(([^()]*?),\s*import\.meta\.url\)/g)) assert.match(address, /^(["'`])[^$]*\1$/, `${name}: ${call}`);
  }
});

test('every question has its answer', async () => {
  const text = sample('3rps');
  const motion = await plan(JSON.parse(text));
  assert.equal(motion.frames, 129);
  assert.ok(motion.milliseconds > 0);
  assert.ok(Math.max(...motion.closure) <= 1e-10);
  const joints = at(motion, 'joints', 64);
  const goal = at(motion, 'goal', 64);
  assert.deepEqual([joints.length, goal.length], [15, 7]);
  assert.ok((await pull(text, [...joints], goal)).closure <= 1e-10);
  assert.equal((await drive(text, joints, 0, joints[0] + 0.01)).value, joints[0] + 0.01);
  assert.equal((await explain(text, joints, goal)).freedoms.length, 3);
  assert.ok((await trace(text, 0)).newton.converged);
  assert.equal((await matrix(text, joints)).freedoms.length, 3);
  assert.deepEqual((await compareMetrics(text)).map(({ metric }) => metric), ['pose', 'dual-quaternion']);
  assert.equal((await normalise(text)).planner.method, 'newton');
  assert.equal((await findStart(text)).chains[0].start.length, 5);
  const table = (await exportMotion(text, 'csv')).trim().split('\n');
  assert.deepEqual([table.length, table[0].slice(0, 22), table[1].split(',')[0]], [130, 'frame,time,status,x[m]', '0']);
  const rows = async (headings) => (await exportMotion(text, 'csv', { headings })).split('\n').map((line) => line.split(',').slice(0, 4).join());
  assert.deepEqual((await rows('plain'))[0], 'frame,time,status,x');
  assert.deepEqual((await rows('two-rows')).slice(0, 2), ['frame,time,status,x', ',,,m']);
  assert.match(await exportMotion(text, 'mjcf', { gravity: true }), /gravity="0 0 -9.81"[^]*<position [^]*<framepos /);
  await assert.rejects(exportMotion(text, 'csv', { headings: 'none' }), (error) => error instanceof DocumentFault && error.where === 'headings' && /two-rows/.test(error.fault.accepted));
  await assert.rejects(exportMotion(text, 'json', { gravity: true }), { name: 'DocumentFault', where: 'gravity' });
  assert.equal((await schema()).$id, JSON.parse(readFileSync(new URL('document.schema.json', dist), 'utf8')).$id);
  assert.ok((await enumeration()).classes.length > 10);
  const delta = (await makers()).find(({ name }) => name === 'delta');
  assert.deepEqual(delta.inputs.map(({ name, parts, is }) => [name, parts, is]), [['base', [], 'length'], ['platform', [], 'length'], ['arms', ['upper', 'lower'], 'length']]);
  const made = await makeNamed('delta', { base: 400, platform: 50, arms: [300, 580] }, 'mm');
  assert.deepEqual(made, await assemble('delta?base=400&platform=50&arms=300,580&unit=mm'));
  assert.equal((await plan(made)).report.mobility_rank, 3);
  await assert.rejects(makeNamed('delta', { base: '4oo' }), (error) => error instanceof DocumentFault && error.where === 'base');
  assert.deepEqual((await plan(await assemble('3RRS'))).report.chains.map(({ type }) => type), ['RRS', 'RRS', 'RRS']);
  const poses = await readPoses('x,y,z\n1000,0,0\n2000,0,no\n', { scale: 0.001 });
  assert.deepEqual([poses.key_frames.map(({ x }) => x), poses.skipped.map(({ row }) => row), poses.understood.convention], [[1], [3], 'positions']);
  assert.equal((await make({ type: '3-PRS', base_radius: 350, platform_radius: 150, leg_length: 600, length_unit: 'mm' })).chains.length, 3);
  await assert.rejects(make({ type: '3-PRS', base_radius: -1 }), (error) => error instanceof DocumentFault && error.where === 'base_radius');
  assert.equal((await assemblyByIndex(3, 0)).length > 0, true);
  assert.equal(await chainByIndex(1, 1e6), undefined);
});

test('a session is asked many times, and gives the same bits as the functions', async () => {
  const text = sample('3rps');
  const session = await open(text);
  const [motion, other] = [await session.plan(), await plan(text)];
  for (const name of ['joints', 'pose', 'sigma_min', 'status']) assert.deepEqual(motion[name], other[name]);
  const joints = at(motion, 'joints', 64);
  const goal = at(motion, 'goal', 64);
  assert.deepEqual((await session.pull(joints, goal)).joints, (await pull(text, joints, goal)).joints);
  assert.equal((await session.drive(joints, 0, joints[0] + 0.01)).value, joints[0] + 0.01);
  assert.equal((await session.explain(joints, goal)).freedoms.length, 3);
  assert.ok((await session.trace(0)).newton.converged);
  assert.equal((await session.matrix(joints)).freedoms.length, 3);
  assert.equal((await session.normalise()).planner.method, 'newton');
  assert.equal((await session.findStart()).chains[0].start.length, 5);
  assert.equal(await session.exportMotion('csv'), await exportMotion(text, 'csv'));
  await assert.rejects(session.calmMotion('1'), { name: 'TypeError' });
  await assert.rejects(session.best({ gravity: true }), /The option gravity is unknown\. Accepted: signal, stop, onProgress/);
  for (const index of [-1, 1.5, NaN, 129]) await assert.rejects(session.trace(index), { name: 'DocumentFault', where: 'motion.frames' });
  await assert.rejects(session.drive(joints, -1, 0), { where: 'variable' });
  assert.equal(await chainByIndex(-1, 0), undefined);
  session.close();
  await assert.rejects(session.plan(), /closed/);
  await assert.rejects(open('{'), DocumentFault);
});

test('a session searches the best motion and the ways to assemble, and tells what it has so far', async () => {
  const session = await open({ ...JSON.parse(sample('3rps')), motion: { ...JSON.parse(sample('3rps')).motion, frames: 17 } });
  const told = [];
  const best = await session.best({ onProgress: (soFar) => told.push(soFar.progress) });
  assert.equal(best.progress, 1);
  assert.ok(told.every((progress) => progress >= 0 && progress <= 1));
  assert.ok(best.best.mean <= best.followed.mean);
  assert.equal((await session.bestMotion()).frames, 17);
  assert.ok((await session.bestPath()).points >= 17);
  const modes = await session.modes(0);
  assert.equal(modes.progress, 1);
  assert.equal((await session.withMode(modes.found[0].index)).chains.length, 3);
  await assert.rejects(session.modes(0, { signal: AbortSignal.abort() }), { name: 'AbortError' });
  session.close();
});

test('a long plan tells how far it is, ends with what there is so far, or without an answer, and holds nobody up', async () => {
  const document = JSON.parse(sample('3rps'));
  const long = { ...document, motion: { ...document.motion, frames: 5000 }, planner: { method: 'gradient' } };
  const stop = new AbortController();
  const seen = [];
  const session = await open(long);
  const motion = await session.plan({
    stop: stop.signal,
    onProgress: (progress) => {
      seen.push(progress);
      stop.abort();
    },
  });
  assert.ok(motion.partial && motion.frames === motion.time.length && motion.goal_frames === 5000 && motion.frames >= seen[0].done);
  const given = new AbortController();
  const ended = assert.rejects(session.plan({ signal: given.signal }), { name: 'AbortError' });
  assert.equal((await plan(document)).frames, 129);
  given.abort();
  await ended;
  session.close();
});

test('a fault has its code, its place and a sentence; a document that changes is planned anew', async () => {
  const document = JSON.parse(sample('2tpr'));
  const { frames } = await plan(document);
  document.motion.frames = 12;
  assert.deepEqual([frames, (await plan(document)).frames], [129, 12]);
  document.chains[1].joints[0].rows[0].alpha = 'x';
  const fault = await check(document);
  assert.ok(fault instanceof DocumentFault && fault instanceof Error);
  assert.deepEqual([fault.name, fault.where], ['DocumentFault', 'chains[1].joints[0].rows[0].alpha']);
  await assert.rejects(plan(document), { message: fault.message, code: fault.code });
  await assert.rejects(plan('{', {}), (error) => error.fault.line === 1);
  assert.equal(await check(sample('2tpr')), null);
  await assert.rejects(plan(document, { signal: AbortSignal.abort() }), { name: 'AbortError' });
});

test('it names no dependency, and holds what it lists', () => {
  const manifest = JSON.parse(readFileSync(join(installed(), 'node_modules/synthetica/package.json'), 'utf8'));
  assert.equal(manifest.dependencies, undefined);
  assert.equal(manifest.version, readFileSync(new URL('../../Cargo.toml', import.meta.url), 'utf8').match(/^version = "(.*)"$/m)[1]);
  const text = (name) => readFileSync(join(installed(), 'node_modules/synthetica', name), 'utf8');
  for (const name of ['README.md', 'LICENSE-MIT', 'LICENSE-APACHE']) assert.ok(text(name).length > 100);
  assert.match(text('LICENSE-OTHERS'), /^three \d[^]*^uplot \d[^]*Permission is hereby granted/m);
});
