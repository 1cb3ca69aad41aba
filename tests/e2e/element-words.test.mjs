// The element's words in other people's pages: what is asked early holds, another document begins anew, and the media
// elements' promises, properties and events.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openBrowser } from './browser.mjs';

const sample = (name) => readFileSync(new URL(`../../www/mechanisms/${name}.json`, import.meta.url), 'utf8');

let browser;
let page;
let problems;
before(async () => {
  browser = await openBrowser();
  ({ page, problems } = await browser.blankPage({ reducedMotion: 'no-preference' }));
  for (const name of ['3rps', '2tpr', 'bennett']) {
    await page.route(`${browser.address}${name}.json*`, (route) => route.fulfill({ contentType: 'application/json', body: sample(name) }));
  }
  await page.route(`${browser.address}faulty.json`, (route) => route.fulfill({ contentType: 'application/json', body: '{"version": 1, "chains": [], "motion": {"key_frames": []}}' }));
});
after(() => browser.close());

/** A page of somebody else's with this in its body, where `one` is its first linkage and `waitFor` waits for what an event tells or for a state. */
async function course(body, { script = true } = {}) {
  await page.unroute(`${browser.address}course.html`);
  await page.route(`${browser.address}course.html`, (route) =>
    route.fulfill({ contentType: 'text/html', body: `<!doctype html><html lang="en"><meta charset="utf-8"><title>A course</title>${script ? '<script type="module" src="./element.js"></script>' : ''}<body>${body}</body></html>` }),
  );
  await page.goto(`${browser.address}course.html`);
  await page.evaluate(() => {
    window.told = [];
    window.hear = (element) => {
      for (const name of ['ready', 'play', 'pause', 'ended', 'timeupdate', 'seeking', 'seeked', 'framechange', 'input', 'change', 'error']) element.addEventListener(name, ({ detail }) => told.push([name, detail]));
      return element;
    };
    window.until = async (holds) => {
      while (!holds()) await new Promise((next) => setTimeout(next, 10));
    };
    window.one = document.querySelector('synthetica-linkage');
    if (one) hear(one);
    window.outcome = (promise) => promise.then(() => 'kept', ({ name }) => name);
  });
  if (script) await page.evaluate(() => customElements.whenDefined('synthetica-linkage'));
}
const planned = () => page.waitForFunction(() => one.readyState === 4);
const texts = Object.fromEntries(['2tpr', '3rps', 'bennett'].map((name) => [name, sample(name)]));

test('frame, currentTime and play() before the first motion hold', async () => {
  await course('<synthetica-linkage id="a"></synthetica-linkage><synthetica-linkage id="b"></synthetica-linkage><synthetica-linkage id="c" frame="7"></synthetica-linkage>');
  const found = await page.evaluate(async (text) => {
    const [a, b, c] = ['a', 'b', 'c'].map((id) => document.getElementById(id));
    const before = [a.readyState, a.paused, a.duration, a.ended];
    a.frame = 40;
    b.currentTime = 0.5;
    const played = c.play();
    const asked = [a.frame, b.currentTime, c.paused];
    for (const element of [a, b, c]) element.document = text;
    await Promise.all([until(() => a.readyState === 4 && b.readyState === 4), played]);
    return { before, asked, a: a.frame, attribute: a.getAttribute('frame'), b: b.currentTime, c: [c.paused, c.readyState, c.frame >= 7] };
  }, texts['2tpr']);
  assert.deepEqual(found, { before: [0, true, 0, false], asked: [40, 0.5, false], a: 40, attribute: '40', b: 0.5, c: [false, 4, true] });
});

test('properties set before the element is defined hold; a bad one is told', async () => {
  await course('<synthetica-linkage frame="3"></synthetica-linkage>', { script: false });
  await page.evaluate((text) => Object.assign(one, { speed: 'fast', src: 'no-such.json', linkage: text, frame: 12, bounce: true, playbackRate: 2 }), texts['2tpr']);
  await page.addScriptTag({ type: 'module', url: './element.js' });
  await planned();
  const found = await page.evaluate(() => ({ frame: one.frame, bounce: one.getAttribute('bounce'), speed: one.speed, name: one.document.name, told: told.filter(([name]) => name === 'error').map(([, { message }]) => message) }));
  assert.equal(found.told.length, 1);
  assert.match(found.told[0], /speed is “fast”.*Accepted/);
  assert.deepEqual({ ...found, told: null }, { frame: 12, bounce: '', speed: 2, name: '2TPR', told: null });
});

test('an address given while it is out of the page is loaded when it is put in', async () => {
  await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned();
  const names = await page.evaluate(async () => {
    one.remove();
    one.src = 'bennett.json';
    // By then it would have come, had it been asked for.
    await (await fetch('2tpr.json?later')).text();
    const meanwhile = one.document.name;
    const loaded = performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('bennett.json')).length;
    document.body.append(one);
    await until(() => one.document?.name !== meanwhile && one.readyState === 4);
    return [meanwhile, loaded, one.document.name];
  });
  assert.deepEqual(names, ['2TPR', 0, JSON.parse(texts.bennett).name]);
});

test('a document that comes to stand inside later is seen', async () => {
  await course('<synthetica-linkage></synthetica-linkage>');
  await page.evaluate((text) => {
    const script = document.createElement('script');
    script.type = 'application/json';
    one.append(script);
    script.textContent = text;
  }, texts['2tpr']);
  await planned();
  assert.equal(await page.evaluate(() => one.document.name), '2TPR');
});

test('a document inside that the page’s parser is still reading is taken whole', async () => {
  await course('');
  const text = texts['2tpr'];
  const name = await page.evaluate(async (parts) => {
    const frame = document.createElement('iframe');
    document.body.append(frame);
    const { contentDocument: inner, contentWindow: window } = frame;
    inner.open();
    inner.write('<!doctype html><base href="/"><body>');
    await window.eval("import('./element.js')");
    inner.write('<synthetica-linkage type="bennett"><script type="application/json">');
    for (const part of parts) {
      inner.write(part);
      await new Promise((next) => setTimeout(next, 20));
    }
    inner.write('</' + 'script></synthetica-linkage>');
    const element = inner.querySelector('synthetica-linkage');
    const errors = [];
    element.addEventListener('error', ({ detail }) => errors.push(detail.message));
    inner.close();
    await until(() => element.document?.name === '2TPR' && element.readyState === 4);
    return errors;
  }, [text.slice(0, 100), text.slice(100, 900), text.slice(900)]);
  assert.deepEqual(name, []);
});

test('another document resets playhead and selection, and its motion is not the former’s', async () => {
  await course('<synthetica-linkage src="2tpr.json" frame="50" controls></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(async (text) => {
    const former = [one.frame, one.trajectory.frames];
    one.parts.store.setView({ selected: 'chains[0]' });
    one.play();
    one.document = text;
    const asked = [one.readyState, one.paused, one.frame, one.document.name, one.trajectory?.frames];
    let read;
    const leave = one.parts.store.subscribe('document', () => {
      read = [one.readyState, one.trajectory];
      leave();
    });
    await until(() => one.readyState === 4);
    return { former, asked, read, now: [one.frame, one.getAttribute('frame'), one.currentTime, one.paused, one.parts.store.view.selected, one.trajectory.frames] };
  }, texts.bennett);
  assert.deepEqual(found, { former: [50, 129], asked: [0, true, 0, '2TPR', 129], read: [1, null], now: [0, null, 0, true, '', 65] });
  // What is wanted of it after it was asked for is wanted of it.
  const set = await page.evaluate(async () => {
    one.src = '2tpr.json?again';
    one.frame = 100;
    return one.frame;
  });
  assert.equal(set, 100);
  await planned();
  assert.deepEqual(await page.evaluate(() => [one.frame, one.getAttribute('frame'), one.document.name]), [100, '100', '2TPR']);
});

test('the same address given once more is asked for again where a document was given or taken away since', async () => {
  await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(async (text) => {
    const names = [];
    for (const next of [text, null]) {
      one.document = next;
      await until(() => (next ? one.readyState === 4 : one.readyState === 0));
      names.push(one.document?.name ?? null);
      one.src = '2tpr.json';
      await until(() => one.readyState === 4);
      names.push(one.document.name);
    }
    const same = one.trajectory;
    one.src = '2tpr.json';
    return [names, one.readyState, one.trajectory.time === same.time];
  }, texts.bennett);
  assert.deepEqual(found, [["Bennett's linkage", '2TPR', null, '2TPR'], 4, true]);
});

test('a document with fewer key frames takes the place of one whose playhead has gone on', async () => {
  await course('<synthetica-linkage src="bennett.json" frame="40" controls></synthetica-linkage>');
  await planned();
  const ticks = (count) => page.waitForFunction((all) => one.shadowRoot.querySelectorAll('.tick').length === all, count);
  await ticks(5);
  const found = await page.evaluate(async (text) => {
    const events = told.length;
    one.document = text;
    await until(() => one.readyState === 4);
    return [one.frame, told.slice(events).filter(([name]) => name === 'ready' || name === 'error'), one.document.name];
  }, texts['2tpr']);
  assert.deepEqual(found, [0, [['ready', null]], '2TPR']);
  await ticks(3);
  assert.deepEqual(problems, []);
});

test('null empties it; attributes taken away give their defaults', async () => {
  await course('<synthetica-linkage src="2tpr.json" speed="3" loop view="top" frame="9" controls><p id="content">Two chains</p></synthetica-linkage>');
  await planned();
  const drawn = () => page.waitForFunction(() => one.shadowRoot.querySelector('canvas')?.dataset.draws > 0 && !one.shadowRoot.querySelector('#fallback').checkVisibility());
  await drawn();
  const state = () => page.evaluate(() => ({ document: one.document, linkage: one.linkage, trajectory: one.trajectory, readyState: one.readyState, error: one.error, frame: one.getAttribute('frame'), duration: one.duration }));
  const nothing = { document: null, linkage: null, trajectory: null, readyState: 0, error: null, frame: null, duration: 0 };
  await page.evaluate(() => {
    told.length = 0;
    one.document = null;
  });
  assert.deepEqual(await state(), nothing);
  await page.locator('#content').waitFor();
  assert.ok(!(await page.evaluate(() => told.some(([name]) => ['error', 'input', 'change', 'framechange'].includes(name)))), 'it is no edit and no fault');
  // By an attribute it comes again, and goes with it.
  await page.evaluate(() => (one.src = '2tpr.json?again'));
  await planned();
  await drawn();
  await page.evaluate(() => {
    for (const name of ['speed', 'loop', 'view']) one.removeAttribute(name);
  });
  assert.deepEqual(await page.evaluate(() => [one.speed, one.loop, one.view, one.parts.player.playbackRate, one.parts.player.loop]), [1, false, '', 1, 'once']);
  await page.evaluate(() => {
    one.frame = 5;
    one.removeAttribute('frame');
  });
  assert.equal(await page.evaluate(() => one.frame), 0);
  await page.evaluate(() => one.setAttribute('type', 'bennett'));
  await page.evaluate(() => one.removeAttribute('src'));
  await page.waitForFunction(() => one.document?.name !== '2TPR' && one.readyState === 4);
  await page.evaluate(() => one.removeAttribute('type'));
  await page.waitForFunction(() => one.document === null);
  assert.deepEqual(await state(), nothing);
  // A document that was given stays when an attribute goes that had no part in it.
  await page.evaluate((text) => {
    one.src = 'bennett.json';
    one.document = text;
    one.removeAttribute('src');
  }, texts['2tpr']);
  await planned();
  assert.equal(await page.evaluate(() => one.document.name), '2TPR');
  assert.deepEqual(problems, []);
});

test('a frame that the motion has not is told, stays in its attribute, and is refused as a property', async () => {
  await course('<synthetica-linkage src="2tpr.json" frame="999"></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(() => {
    one.parts.store.setView({ hovered: 'chains[0]' });
    let refused = '';
    try {
      one.frame = 500;
    } catch (error) {
      refused = error.message;
    }
    return [told.filter(([name]) => name === 'error').length, one.error.message, one.getAttribute('frame'), one.frame, refused];
  });
  assert.deepEqual([found[0], found[2], found[3]], [1, '999', 0]);
  assert.match(found[1], /frame is “999”.*0 to 128/);
  assert.match(found[4], /frame is “500”.*0 to 128/);
  await page.evaluate(() => (one.frame = 12));
  assert.deepEqual(await page.evaluate(() => [one.error, one.getAttribute('frame')]), [null, '12']);
});

test('change is told of edits only', async () => {
  await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage><synthetica-linkage id="other" src="2tpr.json"></synthetica-linkage>');
  await planned();
  const told = await page.evaluate(async (text) => {
    const other = document.getElementById('other');
    await until(() => other.readyState === 4);
    one.parts.store.edit((doc) => ({ ...doc, name: 'Edited' }));
    one.document = text;
    await until(() => one.readyState === 4 && one.document.name !== 'Edited');
    const opened = window.told.length;
    // Later than a change of the former document's edit would be told: that of an edit that came after it.
    const changed = new Promise((tell) => other.addEventListener('change', tell));
    other.parts.store.edit((doc) => ({ ...doc, name: 'Later' }));
    await changed;
    const late = window.told.slice(opened);
    one.parts.store.edit((doc) => ({ ...doc, name: 'Edited again' }));
    await until(() => window.told.slice(opened).some(([name]) => name === 'change'));
    return [late, window.told.slice(opened)].map((all) => all.map(([name]) => name).filter((name) => ['input', 'change', 'ready'].includes(name)));
  }, texts.bennett);
  assert.deepEqual(told, [[], ['input', 'change']]);
});

test('play() resolves when it plays, and rejects at pause, removal, another document and a fault', async () => {
  await course('<synthetica-linkage></synthetica-linkage>');
  const found = await page.evaluate(async ([text, other]) => {
    const fresh = () => document.body.appendChild(document.createElement('synthetica-linkage'));
    const all = {};
    const paused = outcome(one.play());
    one.pause();
    all.paused = await paused;
    const removed = fresh();
    const gone = outcome(removed.play());
    removed.remove();
    all.removed = await gone;
    const turned = fresh();
    turned.document = text;
    const late = outcome(turned.play());
    turned.document = other;
    all.another = await late;
    all.rests = turned.paused;
    const faulty = fresh();
    faulty.src = 'faulty.json';
    all.fault = await outcome(faulty.play());
    all.again = await outcome(faulty.play());
    all.faultyPaused = faulty.paused;
    faulty.document = text;
    all.mended = await outcome(faulty.play());
    one.document = text;
    all.kept = [await outcome(one.play()), one.paused, one.readyState];
    all.atOnce = await outcome(one.play());
    return all;
  }, [texts['2tpr'], texts.bennett]);
  assert.deepEqual(found, {
    paused: 'AbortError', removed: 'AbortError', another: 'AbortError', rests: true, fault: 'NotSupportedError', again: 'NotSupportedError', faultyPaused: true,
    mended: 'kept', kept: ['kept', false, 4], atOnce: 'kept',
  });
  assert.deepEqual(problems, [], 'a rejection that nobody awaits is none for the page');
});

test('at its end it tells so, as the media elements do; speeds go by both names', async () => {
  await course('<synthetica-linkage src="2tpr.json" controls></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(async () => {
    one.playbackRate = 4;
    const speeds = [one.speed, one.getAttribute('speed')];
    one.frame = 120;
    await until(() => told.some(([name]) => name === 'seeked'));
    told.length = 0;
    await one.play();
    await until(() => one.ended);
    const names = told.map(([name]) => name);
    const end = { paused: one.paused, frame: one.frame, atEnd: one.currentTime === one.duration };
    const count = (which) => names.filter((name) => name === which).length;
    const last = names.slice(-3);
    const played = [count('timeupdate'), count('framechange'), count('seeking')];
    one.play();
    return { speeds, end, last, same: played[0] === played[1] && played[0] > 0, seeks: played[2], anew: [one.ended, one.frame < 120 || one.currentTime < 0.5] };
  });
  assert.deepEqual(found.end, { paused: true, frame: 128, atEnd: true });
  assert.deepEqual(found.last, ['timeupdate', 'pause', 'ended']);
  assert.deepEqual([found.speeds, found.same, found.seeks, found.anew[0]], [[4, '4'], true, 0, false]);
});

test('a seek is told, and is where it was set, not at the nearest frame', async () => {
  await course('<synthetica-linkage src="2tpr.json"></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(async () => {
    told.length = 0;
    one.currentTime = 0.123;
    const during = [one.seeking, told.some(([name]) => name === 'seeked')];
    await until(() => told.some(([name]) => name === 'seeked'));
    let refused = '';
    try {
      one.currentTime = 'soon';
    } catch (error) {
      refused = error.message;
    }
    return { during, after: [one.seeking, one.currentTime, one.getAttribute('frame')], names: told.map(([name]) => name), refused };
  });
  assert.deepEqual(found.during, [true, false]);
  assert.deepEqual(found.after, [false, 0.123, '16']);
  assert.deepEqual(found.names, ['framechange', 'seeking', 'timeupdate', 'seeked']);
  assert.match(found.refused, /currentTime is “soon”.*Accepted/);
});

test('linkage is the document’s name for inline handlers', async () => {
  await course('<button onclick="heard = [typeof document.body, one.linkage.name]">Look</button><synthetica-linkage src="2tpr.json" onclick="inline = [document === this.document, linkage?.name]"></synthetica-linkage>');
  await planned();
  const found = await page.evaluate(async (text) => {
    one.click();
    const first = window.inline;
    one.linkage = text;
    await until(() => one.readyState === 4);
    return [first, one.linkage.name === one.document.name, one.linkage.name];
  }, texts.bennett);
  assert.deepEqual(found[0], [false, '2TPR']);
  assert.deepEqual(found.slice(1), [true, JSON.parse(texts.bennett).name]);
});

test('focus() puts the focus into the view, built or not', async () => {
  await course('<p style="height: 300vh">Far up</p><synthetica-linkage src="2tpr.json" controls></synthetica-linkage>');
  await page.evaluate(() => one.focus({ preventScroll: true }));
  const focused = () => page.waitForFunction(() => document.activeElement === one && one.shadowRoot.activeElement?.id === 'canvas');
  await focused();
  await page.evaluate(() => document.activeElement?.shadowRoot?.activeElement?.blur());
  assert.ok(await page.evaluate(() => one.shadowRoot.activeElement === null));
  const atOnce = await page.evaluate(() => {
    one.focus({ preventScroll: true });
    return one.shadowRoot.activeElement?.id;
  });
  assert.equal(atOnce, 'canvas');
});

test('every attribute is a property of its name, and is written back', async () => {
  await course('<synthetica-linkage></synthetica-linkage>');
  const values = { src: 'bennett.json', type: 'x', controls: true, autoplay: true, loop: true, bounce: true, speed: 2, view: 'top', theme: 'dark', readonly: true, panels: 'info', interaction: 'full', keys: 'page', loading: 'eager', poster: 'a.png' };
  const found = await page.evaluate((all) => {
    const element = document.createElement('synthetica-linkage');
    const initial = Object.fromEntries(Object.keys(all).map((name) => [name, element[name]]));
    Object.assign(element, all);
    const read = Object.fromEntries(Object.keys(all).map((name) => [name, element[name]]));
    const written = Object.fromEntries(Object.keys(all).map((name) => [name, element.getAttribute(name)]));
    for (const name of Object.keys(all)) element[name] = typeof all[name] === 'number' ? 1 : null;
    return { initial, read, written, left: element.getAttributeNames(), observed: customElements.get('synthetica-linkage').observedAttributes };
  }, values);
  assert.deepEqual(found.read, values);
  assert.deepEqual(found.written, Object.fromEntries(Object.entries(values).map(([name, value]) => [name, value === true ? '' : String(value)])));
  assert.deepEqual(found.initial, { src: '', type: '', controls: false, autoplay: false, loop: false, bounce: false, speed: 1, view: '', theme: '', readonly: false, panels: '', interaction: 'ctrl', keys: 'element', loading: 'lazy', poster: '' });
  assert.deepEqual(found.left, []);
  assert.deepEqual(found.observed.toSorted(), ['frame', ...Object.keys(values)].toSorted());
});
