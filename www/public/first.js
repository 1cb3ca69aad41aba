// What comes before anything is painted; and what is said while the page's scripts are on their way, or do not come.

// The applet in a frame is a page of its own, which must know who is around it: it would be told of this page instead.
if (/[?&]embed(?=[=&]|$)/.test(location.search)) {
  const origin = /[?&]origin=/.test(location.search) || !document.referrer ? '' : `&origin=${new URL(document.referrer).origin}`;
  location.replace(`./embed.html${location.search}${origin}${location.hash}`);
}
// The planner's worker loads and starts while the page's other scripts do: planner/start-worker.js takes it, with what it has
// said until then. Its address is written here by the build (tools/early.js).
else {
  const address = document.currentScript?.dataset.worker;
  if (address) {
    try {
      const worker = new Worker(address, { type: 'module' });
      /** @type {Event[]} */
      const said = [];
      const hear = (/** @type {Event} */ event) => void said.push(event);
      worker.onmessage = hear;
      worker.onerror = hear;
      // What the page asks first in any case.
      worker.postMessage({ kind: 'ask', id: 0, call: 'ready', args: [] });
      Object.assign(globalThis, { syntheticaWorker: { worker, said } });
    } catch {
      // It may not have one: then the page plans by itself.
    }
  }
}

// The chosen colour scheme; app/theme.js goes on from here.
try {
  const theme = localStorage.getItem('synthetica.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage is forbidden: the system's scheme.
}

// Nothing of the page runs without its scripts: their loading is said once it takes long, and that they cannot be loaded.
// app/main.js takes the note away.
(() => {
  /** Milliseconds after which it is said that the page is being loaded. */
  const LOADS_LONG = 2000;
  let failed = false;

  /** @param {string} text */
  function tell(text) {
    const note = document.getElementById('start-note');
    const again = document.getElementById('start-again');
    if (!note || !again) return;
    note.hidden = false;
    again.hidden = !failed;
    const place = document.getElementById('start-text');
    if (place) place.textContent = text;
    again.addEventListener('click', () => location.reload(), { once: true });
  }

  function fail() {
    if (failed) return;
    failed = true;
    const text = 'A part of this page could not be loaded, so the page cannot start. Work that this browser has kept is still there.';
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', () => tell(text));
    else tell(text);
  }

  // A script says that it, or one that it imports, could not be loaded; that does not bubble, but can be caught on its way down.
  addEventListener('error', ({ target }) => target instanceof HTMLScriptElement && target.type === 'module' && fail(), true);
  setTimeout(() => failed || tell('The page is being loaded.'), LOADS_LONG);
})();
