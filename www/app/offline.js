/**
 * Makes the built page work offline after its first load, where the browser and the address allow it.
 */

/** Registers the service worker once the page has come to rest, so that the first view has the network to itself. */
export function workOffline() {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator) || !isSecureContext) return;
  const register = () => {
    // A browser that refuses (private windows, blocked storage) shows the page all the same.
    navigator.serviceWorker.register('./service-worker.js').catch(() => {});
  };
  setTimeout(register, REST);
}

/** Milliseconds after which the first motion has long been shown. */
const REST = 2000;
