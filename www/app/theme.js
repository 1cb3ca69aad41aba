/**
 * The colour scheme: the system's, light or dark. Tells the window of a change by the event `synthetica-theme`.
 */
import { byId } from '../ui/dom.js';

const KEY = 'synthetica.theme';

const THEMES = /** @type {const} */ (['system', 'light', 'dark']);

export function createTheme() {
  const root = document.documentElement;
  const button = byId('theme');
  const now = () => THEMES.find((theme) => theme === root.dataset.theme) ?? 'system';
  const after = (/** @type {typeof THEMES[number]} */ theme) => THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length];

  function show() {
    const words = `Colours: ${now() === 'system' ? 'as the system' : now()}`;
    button.setAttribute('aria-label', `${words}. Change to ${after(now())}`);
    button.title = `${words}; click for ${after(now())}`;
    button.dataset.theme = now();
  }

  /** @param {typeof THEMES[number]} theme */
  function set(theme) {
    if (theme === 'system') delete root.dataset.theme;
    else root.dataset.theme = theme;
    try {
      if (theme === 'system') localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, theme);
    } catch {
      // It holds until the page is left.
    }
    show();
    dispatchEvent(new Event('synthetica-theme'));
  }

  button.addEventListener('click', () => set(after(now())));
  show();
}
