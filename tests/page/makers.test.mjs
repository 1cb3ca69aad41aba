// Makers: the drawings of their numbers, and how the page's planner asks for them.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Planner } from '../../www/planner/planner.js';

const root = new URL('../../', import.meta.url);
const makers = readdirSync(new URL('src/makers/', root)).filter((name) => name.endsWith('.json'));
const drawings = new URL('www/panels/types/drawings/', root);

/** The names of the elements whose tags do not match, or what else is no XML of the simple kind that drawings are. @param {string} svg */
function faultsIn(svg) {
  const faults = [];
  const open = [];
  const rest = svg.replace(/<(\/?)([a-z]+)((?:\s+[a-zA-Z:-]+="[^"<>&]*")*)\s*(\/?)>/g, (_, end, name, attributes, empty) => {
    const names = Array.from(attributes.matchAll(/([a-zA-Z:-]+)=/g), ([, attribute]) => attribute);
    if (new Set(names).size < names.length) faults.push(`${name}: an attribute twice`);
    if (end) {
      if (open.pop() !== name) faults.push(`</${name}>`);
    } else if (!empty) open.push(name);
    return '';
  });
  return [...faults, ...open.map((name) => `<${name}>`), ...(/[<>]|&(?!(?:[a-z]+|#\d+);)/.test(rest) ? ['a sign outside of tags'] : [])];
}

test('faults of a drawing are found', () => {
  for (const svg of ['<svg><g></svg>', '<svg><path d="M0 0"></svg>', '<svg a="1" a="2"/>', '<svg>a < b</svg>', '<svg>', '<svg><text>a & b</text></svg>']) {
    assert.ok(faultsIn(svg).length, svg);
  }
  assert.deepEqual(faultsIn('<svg a="1"><g><text>a &amp; b</text></g><path d="M0 0"/></svg>'), []);
});

for (const file of makers) {
  const maker = JSON.parse(readFileSync(new URL(`src/makers/${file}`, root), 'utf8'));
  test(`the drawing of ${maker.name} is well-formed, has the colours of the page and the names of the inputs`, () => {
    assert.equal(file, `${maker.name}.json`);
    const svg = readFileSync(new URL(`${maker.name}.svg`, drawings), 'utf8').trim();
    assert.deepEqual(faultsIn(svg), []);
    assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="0 0 240 160"/);
    assert.doesNotMatch(svg, /<(script|style|foreignObject|image|a)\b|\son[a-z]+=|href|#[0-9a-f]{3}|rgb\(/i);
    const texts = Array.from(svg.matchAll(/<text[^>]*>([^<]*)<\/text>/g), ([, text]) => text).join(' ');
    for (const { name, parts = [], is } of maker.inputs) {
      if (is === 'list' || is === 'count') continue;
      for (const word of parts.length ? parts : [name]) assert.ok(texts.includes(word), `${word} is not in “${texts}”`);
    }
  });
}

test('the planner asks for makers and for what they make', async () => {
  /** @type {unknown[]} */
  const asked = [];
  const planner = new Planner(/** @type {any} */ ({ ask: ({ call, args }) => (asked.push([call, args]), Promise.resolve('')) }));
  await planner.makers();
  await planner.makeNamed('delta', { base: 400, arms: '300,580' }, 'mm');
  await planner.makeNamed('delta', {});
  assert.deepEqual(asked, [['makers', []], ['make_named', ['delta', '{"base":400,"arms":"300,580"}', 'mm']], ['make_named', ['delta', '{}', undefined]]]);
});
