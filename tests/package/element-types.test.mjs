// What the package says of the element: types for TypeScript, React, Vue and Svelte, and the manifest of elements. The
// frameworks are not installed: what their own types say of elements is declared here as far as these types touch it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import { ATTRIBUTES } from '../../www/element/attributes.js';
import { EVENTS, MEMBERS } from '../../www/element/descriptions.js';
import { installed } from './installed.mjs';

const tsc = fileURLToPath(new URL('../../node_modules/.bin/tsc', import.meta.url));

const FRAMEWORKS = {
  'react/index.d.ts': `
    export interface HTMLAttributes<T> { className?: string; children?: unknown; onClick?: (event: { currentTarget: T }) => void }
    export type DetailedHTMLProps<E, T> = { ref?: { current: T | null }; key?: string } & E;
    export namespace JSX { interface Element { readonly made: true } interface ElementChildrenAttribute { children: {} } interface IntrinsicElements { p: HTMLAttributes<HTMLParagraphElement> } }`,
  'react/jsx-runtime.d.ts': `
    import type { JSX as React } from './index.js';
    export namespace JSX { type Element = React.Element; interface ElementChildrenAttribute extends React.ElementChildrenAttribute {} interface IntrinsicElements extends React.IntrinsicElements {} }
    export function jsx(): React.Element; export function jsxs(): React.Element;`,
  'vue/index.d.ts': 'export interface HTMLAttributes { class?: unknown } export interface PublicProps { key?: string } export interface GlobalComponents {}',
  'svelte/elements.d.ts': 'export interface HTMLAttributes<T> { class?: string; onclick?: (event: { currentTarget: T }) => void } export interface SvelteHTMLElements {}',
};
const NAMES = { react: { '.': './index.d.ts', './jsx-runtime': './jsx-runtime.d.ts' }, vue: { '.': './index.d.ts' }, svelte: { './elements': './elements.d.ts' } };

const GOOD = {
  'react.tsx': `
    import type {} from 'synthetica/react';
    import type { SyntheticaLinkage } from 'synthetica/element';
    const ref: { current: SyntheticaLinkage | null } = { current: null };
    export const app = (
      <synthetica-linkage ref={ref} className="wide" type="3RPS" loop bounce={false} frame={12} view="top" linkage={null} interaction="full"
        onframechange={({ detail }) => detail.frame.toFixed()} onready={() => ref.current?.play().then(() => {})}>
        <p>Three legs</p>
      </synthetica-linkage>
    );`,
  'vue.ts': `
    import type {} from 'synthetica/vue';
    import type { GlobalComponents } from 'vue';
    type Props = InstanceType<GlobalComponents['synthetica-linkage']>['$props'];
    export const props: Props = { class: 'wide', type: '3RPS', loop: true, frame: 12, view: "top", linkage: null, onFramechange: ({ detail }) => detail.time.toFixed() };`,
  'svelte.ts': `
    import type {} from 'synthetica/svelte';
    import type { SvelteHTMLElements } from 'svelte/elements';
    export const props: SvelteHTMLElements['synthetica-linkage'] = { class: 'wide', type: '3RPS', loop: true, frame: 12, view: "top", linkage: null, onframechange: ({ detail }) => detail.time.toFixed() };`,
  'plain.ts': `
    import type { LinkageAttributes, LinkageEventMap, SyntheticaLinkage } from 'synthetica/element';
    const linkage: SyntheticaLinkage = document.querySelector('synthetica-linkage')!;
    linkage.view = "top";
    linkage.loop = linkage.bounce = true;
    linkage.play().then(() => linkage.ended, ({ name }: DOMException) => name);
    const state: 0 | 1 | 4 = linkage.readyState;
    linkage.toCSV({ headings: 'plain' }).then((text) => text.trim());
    linkage.addEventListener('error', ({ detail }) => detail.where.length + state);
    type Names<Map> = Record<keyof Map, 0>;
    export const events: Names<LinkageEventMap> = ${JSON.stringify(Object.fromEntries(Object.keys(EVENTS).map((name) => [name, 0])))};
    export const members: Names<Omit<SyntheticaLinkage, Exclude<keyof HTMLElement, 'focus'> | keyof LinkageAttributes>> = ${JSON.stringify(
      Object.fromEntries(Object.keys(MEMBERS).map((name) => [name, 0])),
    )};`,
};

let project;
/** @param {string[]} files @returns {string} what tsc says against them */
function check(files) {
  const options = ['--noEmit', '--strict', '--target', 'es2022', '--module', 'esnext', '--moduleResolution', 'bundler', '--jsx', 'react-jsx', '--types', ''];
  try {
    execFileSync(tsc, [...options, ...files], { cwd: project, encoding: 'utf8', stdio: 'pipe' });
    return '';
  } catch (error) {
    return error.stdout;
  }
}

before(() => {
  project = installed();
  const put = (file, text) => {
    const path = join(project, 'node_modules', file);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
  };
  for (const [file, text] of Object.entries(FRAMEWORKS)) put(file, text);
  for (const [name, types] of Object.entries(NAMES)) put(`${name}/package.json`, JSON.stringify({ name, version: '0.0.0', exports: Object.fromEntries(Object.entries(types).map(([entry, file]) => [entry, { types: file }])) }));
  for (const [file, text] of Object.entries(GOOD)) writeFileSync(join(project, file), text);
});

test('TypeScript, React, Vue and Svelte know attributes, properties and events', () => {
  assert.equal(check(Object.keys(GOOD)), '');
});

test('and refuse what is none', () => {
  const wrong = [];
  for (const [file, text] of Object.entries(GOOD)) {
    assert.ok(text.includes('"top"'), file);
    wrong.push(file.replace('.', '-wrong.'));
    writeFileSync(join(project, wrong.at(-1)), text.replace('"top"', '"above"'));
  }
  const said = check(wrong);
  for (const file of wrong) assert.match(said, new RegExp(`^${file}\\(\\d+,\\d+\\): error .*("above"|view)`, 'm'));
});

test('the manifest of elements names what there is', () => {
  const { customElements } = JSON.parse(readFileSync(join(project, 'node_modules/synthetica/package.json'), 'utf8'));
  const { modules } = JSON.parse(readFileSync(join(project, 'node_modules/synthetica', customElements), 'utf8'));
  const [{ path, declarations, exports }] = modules;
  const [element] = declarations;
  assert.match(readFileSync(join(project, 'node_modules/synthetica', path), 'utf8'), /SyntheticaLinkage/);
  assert.deepEqual(exports.map(({ kind, name }) => [kind, name]), [['js', 'SyntheticaLinkage'], ['custom-element-definition', 'synthetica-linkage']]);
  const names = (list) => list.map(({ name }) => name);
  assert.deepEqual(names(element.attributes), Object.keys(ATTRIBUTES));
  assert.deepEqual(names(element.members), [...Object.keys(ATTRIBUTES), ...Object.keys(MEMBERS)]);
  assert.deepEqual(names(element.events), Object.keys(EVENTS));
  const { type, default: standard, description } = element.attributes.find(({ name }) => name === 'interaction');
  assert.deepEqual([type.text, standard], ["'none' | 'ctrl' | 'full'", "'ctrl'"]);
  assert.match(description, /pointer/);
  assert.equal(element.attributes.find(({ name }) => name === 'panels').type.text, 'string');
  for (const { description: text } of [...element.attributes, ...element.members, ...element.events]) assert.ok(text && !text.includes(']('), text);
});
