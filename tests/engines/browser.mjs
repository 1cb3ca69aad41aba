// The built page in another engine, for the tests beside this file: what a person does there, and what is seen.
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { preview } from 'vite';
import { lookInside } from '../e2e/browser.mjs';
import { LIMIT } from './start.mjs';

/** Of the screen in start.mjs, less the bars of the browsers. */
const WINDOW = { x: 0, y: 0, width: 960, height: 760 };

/** What WebDriver calls the keys that have no letter. */
export const KEYS = { Control: '\uE009', Shift: '\uE008', Enter: '\uE007', Escape: '\uE00C', Tab: '\uE004', Home: '\uE011', End: '\uE010', ArrowLeft: '\uE012', ArrowUp: '\uE013', ArrowRight: '\uE014', ArrowDown: '\uE015' };

/** Runs in every page before its own scripts: keeps what it complains about. */
function watch() {
  window.problems = [];
  const keep = (what) => window.problems.push(String(what));
  for (const level of ['error', 'warn']) {
    const write = console[level];
    console[level] = (...words) => {
      keep(words.join(' '));
      write.apply(console, words);
    };
  }
  // A script or a picture that cannot be loaded is told to its own element, which the window hears of first.
  addEventListener('error', (event) => {
    if (event instanceof ErrorEvent) keep(event.error?.stack ? `${event.message}\n${event.error.stack}` : event.message);
    else if (event.target.src || event.target.href) keep(`cannot load ${event.target.src || event.target.href}`);
  }, true);
  addEventListener('unhandledrejection', ({ reason }) => keep(reason?.stack ? `${reason}\n${reason.stack}` : reason));
  addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sample }) => keep(`${violatedDirective}: ${blockedURI} ${sample}`));
  try {
    localStorage.setItem('synthetica.first-minute', 'in a test');
  } catch {
    // A frame in a sandbox has no storage.
  }
}
const WATCH = `${lookInside}\nlookInside();\n${watch}\nwatch();\n`;

/**
 * Serves www/dist, and the pages in `pages` by their names: beside it, and on an origin of their own. In every page the script
 * above comes first.
 */
export async function serve() {
  /** @type {Map<string, string>} */
  const pages = new Map([['blank.html', '<!doctype html><html lang="en"><head><title>Blank</title></head></html>']]);
  // As a file of its own in the pages whose content policy wants that.
  const withWatch = (html, strict) => html.replace('<head>', () => `<head>${strict ? '<script src="/watch.js"></script>' : `<script>${WATCH}</script>`}`);
  const answer = (request, response, next) => {
    const name = request.url.replace(/^\/|[?#].*$/g, '');
    const script = name === 'watch.js' && WATCH;
    const html = pages.get(name) ?? (['', 'index.html', 'embed.html'].includes(name) && readFileSync(`www/dist/${name || 'index.html'}`, 'utf8'));
    if (script) response.setHeader('cache-control', 'no-store').setHeader('content-type', 'text/javascript').end(script);
    else if (html) response.setHeader('cache-control', 'no-store').setHeader('content-type', 'text/html').end(withWatch(html, !pages.has(name)));
    else next();
  };
  const server = await preview({
    configFile: 'tools/vite.config.js',
    preview: { port: 0 },
    plugins: [{ name: 'pages-of-tests', configurePreviewServer: ({ middlewares }) => void middlewares.use(answer) }],
  });
  const others = createServer((request, response) => answer(request, response, () => response.writeHead(404).end()));
  await new Promise((listening) => others.listen(0, '127.0.0.1', listening));
  return {
    pages,
    address: server.resolvedUrls.local[0],
    /** Another origin than that. */
    elsewhere: `http://127.0.0.1:${others.address().port}/`,
    async close() {
      others.close();
      others.closeAllConnections();
      await server.close();
    },
  };
}

/** Starts that engine and gives what a test does with it. */
export async function open(engine) {
  const home = mkdtempSync(join(tmpdir(), 'engines-'));
  const { command, end } = await engine.start(engine, home);
  await command('size', WINDOW);

  /** What that function gives in the page. */
  async function run(what, ...args) {
    const script = `const [args, done] = arguments; const { page$, page$$, pageFocus } = window; Promise.resolve().then(() => (${what})(...args)).then((value) => done({ value }), (error) => done({ error: String(error) + '\\n' + error.stack }));`;
    const { value, error } = await command('run', { script, args: [args] });
    if (error) throw new Error(error);
    return value;
  }

  /** Until that function gives something true in the page; gives it. */
  async function until(what, ...args) {
    for (const from = Date.now(); Date.now() - from < LIMIT; ) {
      const value = await run(what, ...args);
      if (value) return value;
      await new Promise((next) => setTimeout(next, 50));
    }
    throw new Error(`never: ${what} with ${JSON.stringify(args)}; the page says ${JSON.stringify(await run(() => window.problems))}`);
  }

  /** Opens that page; what comes next finds it there, and not the one before. */
  async function go(url) {
    const mark = `left-${Math.random()}`;
    await command('run', { script: 'const [mark, done] = arguments; window[mark] = true; done();', args: [mark] });
    await command('go', { url });
    await until((left) => !window[left] && document.readyState === 'complete' && typeof window.page$ === 'function', mark);
  }

  /** Keys one after the other; `Control+z` holds the first. */
  async function press(...keys) {
    const actions = keys.flatMap((text) => {
      const held = text.length > 1 ? text.split('+').map((key) => KEYS[key] ?? key) : [text];
      return [...held.map((value) => ({ type: 'keyDown', value })), ...held.reverse().map((value) => ({ type: 'keyUp', value }))];
    });
    await command('act', { actions: [{ type: 'key', id: 'keyboard', actions }] });
  }

  /** Moves the pointer through these places of the window, from the second on with its button down. */
  async function drag(...places) {
    const move = ({ x, y }) => ({ type: 'pointerMove', duration: 20, origin: 'viewport', x: Math.round(x), y: Math.round(y) });
    const [first, ...rest] = places.map(move);
    const actions = [first, { type: 'pointerDown', button: 0 }, ...rest, { type: 'pointerUp', button: 0 }];
    await command('act', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }] });
  }

  /** The box of what that selector finds (or of its n-th), once it is seen, scrolled into view and at rest. */
  const boxOf = (selector, text = '') =>
    until(
      async (wanted, words) => {
        const found = page$$(wanted).find((node) => node.textContent.includes(words) && node.checkVisibility({ visibilityProperty: true }));
        if (!found) return null;
        found.scrollIntoView({ block: 'nearest' });
        const box = () => JSON.stringify(found.getBoundingClientRect());
        const first = box();
        await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
        return first === box() && found.getBoundingClientRect().width > 0 && found.getBoundingClientRect().toJSON();
      },
      selector,
      text,
    );

  const middle = ({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 });
  /** As a person does: points first, and clicks where the thing then rests. (The name of a thing that is pointed at may be moved.) */
  async function click(selector, text) {
    const { x, y } = middle(await boxOf(selector, text));
    await command('act', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions: [{ type: 'pointerMove', duration: 20, origin: 'viewport', x: Math.round(x), y: Math.round(y) }] }] });
    await drag(middle(await boxOf(selector, text)));
  }

  /** How many colours the window has in that box once it rests, and a number that another picture would hardly have. */
  async function look(selector) {
    const box = await boxOf(selector);
    for (let last = NaN; ; ) {
      const seen = await run(
        async (data, { x, y, width, height }) => {
          const image = new Image();
          image.src = `data:image/png;base64,${data}`;
          await image.decode();
          const canvas = Object.assign(document.createElement('canvas'), { width, height });
          const pen = canvas.getContext('2d');
          pen.drawImage(image, -x, -y);
          const pixels = new Uint32Array(pen.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
          return { colours: new Set(pixels).size, sum: pixels.reduce((sum, pixel) => (Math.imul(sum, 31) + pixel) | 0, 0) };
        },
        await command('picture', {}),
        box,
      );
      if (seen.sum === last) return seen;
      last = seen.sum;
    }
  }

  /** The file that is saved by `act`, as text. */
  async function saved(ending, act) {
    const files = () => readdirSync(home, { recursive: true }).filter((name) => name.endsWith(ending));
    const before = files();
    await act();
    for (const from = Date.now(); Date.now() - from < LIMIT; ) {
      const fresh = files().find((name) => !before.includes(name));
      // A browser makes the file, and fills it when it has all.
      const text = fresh && readFileSync(join(home, fresh), 'utf8');
      if (text) return { name: fresh.split('/').at(-1), text };
      await new Promise((next) => setTimeout(next, 100));
    }
    throw new Error(`no file *${ending} was saved: ${readdirSync(home)}`);
  }

  return {
    command,
    run,
    until,
    press,
    drag,
    boxOf,
    click,
    look,
    saved,
    go,
    text: (selector) => run((wanted) => page$(wanted).textContent, selector),
    problems: () => run(() => window.problems),
    async end() {
      await end();
      rmSync(home, { recursive: true, force: true, maxRetries: 20, retryDelay: 250 });
    },
  };
}
