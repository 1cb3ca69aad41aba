// Code for other pages, and what a frame's address means.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { elementCode, fileCode, frameCode } from '../../www/app/files/codes.js';
import { attributesOf, ownFile, parentOrigin, withoutContent } from '../../www/embed/address.js';

const HOME = 'https://kinematics.example/tools/';
const plain = { controls: true, autoplay: false, readonly: false, panels: [], height: 420 };

test('a frame holds the document in its address, and nothing that is so anyway', () => {
  assert.equal(
    frameCode('2TPR "mine"', HOME, '1.abc', plain),
    '<iframe src="https://kinematics.example/tools/embed.html#d=1.abc" title="2TPR &quot;mine&quot;" width="100%" height="420" loading="lazy" style="border: 0"></iframe>',
  );
  const all = frameCode('x', HOME, '1.abc', { controls: false, autoplay: true, readonly: true, panels: ['info', 'motion'], height: 300 });
  const address = new URL(/src="([^"]*)"/.exec(all)[1].replaceAll('&amp;', '&'));
  assert.deepEqual(attributesOf(address.search), [['autoplay', ''], ['bounce', ''], ['readonly', ''], ['panels', 'info motion'], ['theme', 'auto']]);
});

test('an element holds the document in a script that nothing in it can end; its own script is a classic one', () => {
  const code = elementCode('{"name":"</script><b>"}', HOME, { ...plain, panels: ['info'], autoplay: true });
  assert.match(code, /^<synthetica-linkage controls autoplay bounce panels="info" style="height: 420px">/);
  assert.match(code, /<\/synthetica-linkage>\n<script src="https:\/\/kinematics\.example\/tools\/inline\.js" async><\/script>$/);
  const inside = /<script type="application\/json">(.*?)<\/script>/.exec(code)[1];
  assert.deepEqual(JSON.parse(inside), { name: '</script><b>' });
});

test('one file: the script is inside, and its strings do not end it', () => {
  const page = fileCode('a < b', '{}', 'const s = "</script><!--";', plain);
  assert.equal(page.match(/<\/script>/g).length, 2);
  assert.ok(page.includes('<h1>a &lt; b</h1>'));
});

test('a frame has controls and the reader’s colours unless its address says otherwise', () => {
  assert.deepEqual(attributesOf(''), [['controls', ''], ['theme', 'auto']]);
  assert.deepEqual(attributesOf('?embed&controls=0&theme=dark&autoplay=no&speed=0.5&panels='), [['speed', '0.5'], ['theme', 'dark']].sort((a, b) => (a[0] < b[0] ? -1 : 1)));
  assert.deepEqual(attributesOf('?interaction=full&theme=dark'), [['theme', 'dark'], ['interaction', 'full'], ['controls', '']]);
  assert.deepEqual(attributesOf('?loop=bounce&onclick=alert(1)&src=x'), [['bounce', ''], ['controls', ''], ['theme', 'auto']]);
});

test('who may talk to a frame: as written, else as the browser tells', () => {
  assert.equal(parentOrigin('?origin=https://course.example/some/page', 'https://other.example/'), 'https://course.example');
  assert.equal(parentOrigin('', 'https://course.example/unit/3'), 'https://course.example');
  assert.equal(parentOrigin('?origin=*', ''), '*');
  assert.equal(parentOrigin('', ''), '');
  assert.equal(parentOrigin('?origin=file:///x', ''), '');
  assert.equal(parentOrigin('?origin=nonsense', 'https://course.example/'), '');
});

const EMBED = 'https://kinematics.example/tools/embed.html?src=x';

test('a frame loads documents of its own folder only', () => {
  for (const src of ['mechanisms/3rps.json', './a.json?v=2', '/tools/deep/er/a.json', `${HOME}a.json`, 'x/../a.json']) {
    assert.ok(ownFile(src, EMBED).href.startsWith(HOME), src);
  }
  for (const src of [
    '../secret.json', '/secret.json', '/tools', '/toolsecret/a.json', 'x/../../secret.json', 'x/%2e%2e/%2e%2e/secret.json', '..\\secret.json',
    'x/..%2f..%2fsecret.json', 'x/..%5C..%5csecret.json', '//kinematics.example:8443/tools/a.json', 'https://other.example/tools/a.json',
    'http://kinematics.example/tools/a.json', 'data:application/json,{}', 'blob:https://kinematics.example/tools/1', 'file:///tools/a.json', 'https://',
  ]) {
    assert.throws(() => ownFile(src, EMBED), ({ message }) => message.startsWith(`src is “${src}”`) && /Accepted: a document in the folder/.test(message), src);
  }
  // Opened from a disk.
  assert.throws(() => ownFile('../a.json', 'file:///home/me/site/embed.html'), /does not load/);
});

test('of a file that is no document a foreign page hears the kind and the place, and no word of it', () => {
  const told = (where) => withoutContent({ message: 'salary: 12', where, code: 'unknown-field' });
  assert.deepEqual(told('chains[1].joints[0].salary'), {
    message: 'The document that src names cannot be shown (unknown-field, in chains[1].joints[0]). What is wrong stands in the frame.', where: 'chains[1].joints[0]', code: 'unknown-field',
  });
  assert.deepEqual([told('salary').where, told('').where, told('parameters.chains').where, told('motion.key_frames[2].motion').where], ['', '', '', 'motion.key_frames[2].motion']);
  assert.doesNotMatch(JSON.stringify(told('salary[3].joints')), /salary/);
});
