// Code for other pages, and what a frame's address means.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { elementCode, fileCode, frameCode } from '../../www/app/files/codes.js';
import { attributesOf, parentOrigin } from '../../www/embed/address.js';

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

test('an element holds the document in a script that nothing in it can end', () => {
  const code = elementCode('{"name":"</script><b>"}', HOME, { ...plain, panels: ['info'], autoplay: true });
  assert.match(code, /^<script type="module" src="https:\/\/kinematics\.example\/tools\/element\.js"><\/script>\n<synthetica-linkage controls autoplay bounce panels="info" style="height: 420px">/);
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
