/**
 * The service worker of the built page: keeps every file of one build, so that the page works offline after its first
 * load. A newer build is fetched beside it and takes over when no page of the old one is open any more: a page never
 * meets files of two builds.
 */

/** Addresses and fingerprint of the build's files; the build writes them here. @type {{version: string, files: string[]}} */
const { version, files } = { version: '', files: [] };

const PREFIX = 'synthetica-';
const NAME = PREFIX + version;

/** The few things of a service worker that the page's types do not know. @typedef {Event & {waitUntil: (done: Promise<unknown>) => void, request: Request, respondWith: (answer: Promise<Response>) => void}} WorkerEvent */
const on = (/** @type {string} */ name, /** @type {(event: WorkerEvent) => void} */ act) => self.addEventListener(name, /** @type {EventListener} */ (act));

const pathOf = (/** @type {string} */ address) => new URL(address, location.href).pathname;
const kept = new Set(files.map(pathOf));

/** The applet's own page has two addresses. @param {string} url */
const isHome = (url) => ['./', './index.html'].map(pathOf).includes(pathOf(url));

async function keep() {
  const cache = await caches.open(NAME);
  // Hashed names may come from the browser's own cache; whatever else, the pages first, must be this build's.
  await cache.addAll(files.map((file) => new Request(file, { cache: file.startsWith('./assets/') ? 'default' : 'reload' })));
}

async function forgetOthers() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== NAME).map((name) => caches.delete(name)));
}

/** @param {Request} request */
async function answer(request) {
  const cache = await caches.open(NAME);
  // Whatever is asked of a page, such as ?sample=2tpr.json, is asked of the same file.
  const page = request.mode === 'navigate';
  // A server's `Vary: Origin` would part the script that asks from the one that was kept; the files do not vary.
  const found = await cache.match(isHome(request.url) ? './' : request, { ignoreSearch: page, ignoreVary: true });
  return found ?? fetch(request);
}

on('install', (event) => event.waitUntil(keep()));
on('activate', (event) => event.waitUntil(forgetOthers()));
on('fetch', (event) => {
  const { method, url, mode } = event.request;
  const own = isHome(url) || kept.has(pathOf(url));
  if (method === 'GET' && new URL(url).origin === location.origin && (own || mode !== 'navigate')) event.respondWith(answer(event.request));
});
