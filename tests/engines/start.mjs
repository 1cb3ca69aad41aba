// Starts Firefox and WebKit on a screen of their own, and speaks WebDriver with both: with Firefox over the socket that
// its `--marionette` opens, with WebKit over HTTP through its driver. The commands and their arguments are the same.
import { spawn } from 'node:child_process';
import { accessSync, constants, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createServer, connect } from 'node:net';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Milliseconds that a browser may take to start, and a page to do what it is asked, on a loaded machine. */
export const LIMIT = 30_000;
const SCREEN = '1400x1000x24';

/** Where that program is on the PATH. @param {string} name */
function onPath(name) {
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    try {
      accessSync(join(folder, name), constants.X_OK);
      return join(folder, name);
    } catch {
      // The next folder.
    }
  }
  return null;
}

/** MiniBrowser, which Debian keeps beside WebKit's library. */
function miniBrowser() {
  const libraries = existsSync('/usr/lib') ? readdirSync('/usr/lib').filter((name) => name.endsWith('-linux-gnu')) : [];
  const places = libraries.flatMap((name) => ['webkit2gtk-4.1', 'webkitgtk-6.0', 'webkit2gtk-4.0'].map((version) => `/usr/lib/${name}/${version}/MiniBrowser`));
  return process.env.WEBKIT_BROWSER || places.find((path) => existsSync(path)) || null;
}

const xvfb = () => process.env.XVFB || onPath('Xvfb');

/** What each engine is started with; `missing` names the programs that are not there. */
export const ENGINES = [
  {
    name: 'Firefox',
    programs: () => ({ firefox: process.env.FIREFOX || onPath('firefox-esr') || onPath('firefox'), Xvfb: xvfb() }),
    start: startFirefox,
  },
  {
    name: 'WebKit',
    programs: () => ({ WebKitWebDriver: process.env.WEBKIT_DRIVER || onPath('WebKitWebDriver'), MiniBrowser: miniBrowser(), Xvfb: xvfb() }),
    start: startWebKit,
  },
];

/** The programs of that engine that are not installed. */
export const missing = ({ programs }) => Object.entries(programs()).flatMap(([name, path]) => (path ? [] : [name]));

/** The commands of WebDriver that the tests use: method and path over HTTP, name in Firefox. */
const COMMANDS = {
  timeouts: ['POST', 'timeouts', 'WebDriver:SetTimeouts'],
  size: ['POST', 'window/rect', 'WebDriver:SetWindowRect'],
  go: ['POST', 'url', 'WebDriver:Navigate'],
  run: ['POST', 'execute/async', 'WebDriver:ExecuteAsyncScript'],
  act: ['POST', 'actions', 'WebDriver:PerformActions'],
  picture: ['GET', 'screenshot', 'WebDriver:TakeScreenshot'],
  end: ['DELETE', '', 'WebDriver:DeleteSession'],
};

/** A program that is ended with everything that was begun here. */
function begin(program, args, options = {}) {
  const child = spawn(program, args, { stdio: ['ignore', 'pipe', 'pipe'], ...options });
  const ended = new Promise((resolve) => child.once('exit', resolve));
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream?.on('data', (data) => (said = (said + data).slice(-4000)));
  return {
    child,
    said: () => said,
    running: () => child.exitCode === null && child.signalCode === null,
    async end() {
      child.kill();
      const late = setTimeout(() => child.kill('SIGKILL'), 5000);
      await ended;
      clearTimeout(late);
    },
  };
}

/** Tries until it gives something, and says in the end what the program said. @template T @param {() => Promise<T | null> | T | null} attempt */
async function until(attempt, program, what) {
  for (const from = Date.now(); Date.now() - from < LIMIT && program.running(); ) {
    const got = await attempt();
    if (got !== null) return got;
    await new Promise((next) => setTimeout(next, 50));
  }
  throw new Error(`${what}: ${program.running() ? `not within ${LIMIT / 1000} s` : 'it has ended'}\n${program.said()}`);
}

/** A screen in memory, on a display that was free. */
async function startScreen(program) {
  const screen = begin(program, ['-displayfd', '1', '-screen', '0', SCREEN, '-nolisten', 'tcp', '-noreset']);
  const display = await until(() => /^(\d+)\n/m.exec(screen.said())?.[1] ?? null, screen, 'Xvfb does not start');
  // Without a graphics card: Mesa draws.
  return { ...screen, env: { ...process.env, DISPLAY: `:${display}`, WAYLAND_DISPLAY: '', GDK_BACKEND: 'x11', LIBGL_ALWAYS_SOFTWARE: '1' } };
}

const freePort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

/** What Firefox sends and takes: the length of a JSON text, a colon, the text. */
async function marionette(port) {
  const socket = connect(port, '127.0.0.1');
  const waiting = new Map();
  let rest = Buffer.alloc(0);
  let greet;
  const greeted = new Promise((resolve, reject) => {
    greet = resolve;
    socket.once('error', reject);
  });
  socket.on('data', (data) => {
    rest = Buffer.concat([rest, data]);
    for (;;) {
      const colon = rest.indexOf(':');
      const end = colon + 1 + Number(rest.subarray(0, Math.max(colon, 0)));
      if (colon < 0 || rest.length < end) return;
      const message = JSON.parse(rest.subarray(colon + 1, end));
      rest = rest.subarray(end);
      if (!Array.isArray(message)) greet();
      else {
        const [, id, error, result] = message;
        const { resolve, reject } = waiting.get(id);
        waiting.delete(id);
        if (error) reject(new Error(`${error.error}: ${error.message}`));
        else resolve(result !== null && 'value' in result ? result.value : result);
      }
    }
  });
  socket.on('close', () => {
    for (const { reject } of waiting.values()) reject(new Error('Firefox has closed the connection'));
  });
  await greeted;
  let last = 0;
  return {
    close: () => socket.destroy(),
    ask: (name, parameters = {}) =>
      new Promise((resolve, reject) => {
        const id = ++last;
        waiting.set(id, { resolve, reject });
        const text = JSON.stringify([0, id, name, parameters]);
        socket.write(`${Buffer.byteLength(text)}:${text}`);
      }),
  };
}

async function startFirefox({ programs }, home) {
  const [firefox, screenProgram] = Object.values(programs());
  const screen = await startScreen(screenProgram);
  const profile = join(home, 'profile');
  mkdirSync(profile);
  const settings = {
    // A free port, which Firefox writes into its profile.
    'marionette.port': 0,
    'webgl.force-enabled': true,
    'browser.shell.checkDefaultBrowser': false,
    'datareporting.policy.dataSubmissionEnabled': false,
    'browser.download.useDownloadDir': true,
    'browser.download.folderList': 2,
    'browser.download.dir': home,
  };
  writeFileSync(join(profile, 'user.js'), Object.entries(settings).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`).join(''));
  const browser = begin(firefox, ['--marionette', '--no-remote', '--profile', profile, 'about:blank'], { env: { ...screen.env, MOZ_DISABLE_CONTENT_SANDBOX: '1' } });
  const end = async () => {
    await browser.end();
    await screen.end();
  };
  try {
    const active = join(profile, 'MarionetteActivePort');
    const port = await until(() => (existsSync(active) && Number(readFileSync(active, 'utf8'))) || null, browser, 'Firefox does not start');
    const { ask, close } = await marionette(port);
    await ask('WebDriver:NewSession', { capabilities: { alwaysMatch: { timeouts: { script: LIMIT, pageLoad: LIMIT } } } });
    return {
      command: (name, parameters) => ask(COMMANDS[name][2], parameters),
      async end() {
        close();
        await end();
      },
    };
  } catch (error) {
    await end();
    throw error;
  }
}

async function startWebKit({ programs }, home) {
  const [driverProgram, browser, screenProgram] = Object.values(programs());
  const screen = await startScreen(screenProgram);
  const port = await freePort();
  // The language of this locale is C, which is no language tag: the page is to work there too.
  const driver = begin(driverProgram, [`--port=${port}`], { env: { ...screen.env, LC_ALL: 'C.UTF-8', LANGUAGE: '', HOME: home, XDG_DATA_HOME: join(home, 'data'), XDG_CACHE_HOME: join(home, 'cache'), XDG_CONFIG_HOME: join(home, 'config') } });
  const ask = async (method, path, parameters) => {
    const response = await fetch(`http://127.0.0.1:${port}/${path}`, { method, ...(method === 'POST' && { body: JSON.stringify(parameters ?? {}) }) });
    const { value } = await response.json();
    if (!response.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  const end = async () => {
    await driver.end();
    await screen.end();
  };
  try {
    await until(() => ask('GET', 'status').then(({ ready }) => ready || null, () => null), driver, 'WebKitWebDriver does not start');
    const { sessionId } = await ask('POST', 'session', {
      capabilities: { alwaysMatch: { timeouts: { script: LIMIT, pageLoad: LIMIT }, 'webkitgtk:browserOptions': { binary: browser, args: ['--automation'] } } },
    });
    const command = (name, parameters) => {
      const [method, path] = COMMANDS[name];
      return ask(method, ['session', sessionId, path].filter(Boolean).join('/'), parameters);
    };
    return {
      command,
      async end() {
        await command('end').catch(() => null);
        await end();
      },
    };
  } catch (error) {
    await end();
    throw new Error(`${error.message}\n${driver.said()}`);
  }
}

// For scripts/dev.sh: run by itself, it says what is not installed.
if (process.argv[1] === fileURLToPath(import.meta.url)) console.log(ENGINES.flatMap((engine) => (missing(engine).length > 0 ? [`${engine.name} (${missing(engine).join(', ')})`] : [])).join('; '));
