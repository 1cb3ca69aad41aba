// The types of mechanisms in the words of Tables 2 and 3.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assemblyName, grouped, linkageOfAssembly, typeSentence } from '../../www/panels/types/type-words.js';

const chains = (...constraints) => constraints.map((count) => ({ type: 'X', constraints: count }));
const tables = {
  classes: [],
  assemblies: [{ constraints: 3, total: 464417, categories: [{ name: '3I', count: 457310 }, { name: '1I-1II', count: 7089 }] }],
};

test('thousands are grouped as in the paper', () => {
  for (const [count, text] of [[6, '6'], [464417, '464,417'], [487990859, '487,990,859']]) assert.equal(grouped(count), text);
});

test('a linkage of an assembly takes the present types where they fit, else the first of each category', () => {
  const classes = [['I', ['SPR', 'RPS']], ['II', ['TS']], ['III', ['SP']], ['IV', ['TR']]].map(([category, chains]) => ({ category, chains }));
  assert.equal(linkageOfAssembly('3I', classes, ['RPS']), '3RPS');
  assert.equal(linkageOfAssembly('1I-1III', classes, ['TS']), '1SPR+1SP');
  assert.equal(linkageOfAssembly('1I-1IV', classes, []), '1SPR+1TR');
});

test('an assembly is named by its chains’ categories', () => {
  assert.equal(assemblyName(chains(1, 1, 1)), '3I');
  assert.equal(assemblyName(chains(2, 1)), '1I-1II');
  assert.equal(assemblyName(chains(5)), null);
});

test('the sentence says where the linkage stands in Table 3, or why it does not', () => {
  assert.match(typeSentence(chains(1, 2), tables), /1I-1II: one of 7,089 such assemblies, of 464,417 with 3 constraints/);
  assert.match(typeSentence(chains(4, 4), tables), /2IV with 8 constraints: more than the five/);
  assert.match(typeSentence(chains(5), tables), /neither table/);
});
