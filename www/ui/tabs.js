/**
 * Tabs, by the ARIA pattern: arrow keys choose, Tab goes into the panel.
 */

/** @param {HTMLElement} list holds the tabs, each naming its panel by `aria-controls` */
export function createTabs(list) {
  /** The dock's tabs come and go with the width of the window. */
  const all = () => /** @type {HTMLElement[]} */ ([...list.querySelectorAll('[role=tab]')]);
  const root = /** @type {Document | ShadowRoot} */ (list.getRootNode());
  const panel = (/** @type {HTMLElement} */ tab) => root.getElementById(tab.getAttribute('aria-controls') ?? '');

  /** @param {HTMLElement} chosen */
  function choose(chosen) {
    for (const tab of all()) {
      const on = tab === chosen;
      tab.setAttribute('aria-selected', String(on));
      tab.tabIndex = on ? 0 : -1;
      panel(tab)?.classList.toggle('shown', on);
    }
  }

  list.addEventListener('click', (event) => {
    const tab = all().find((candidate) => candidate.contains(/** @type {Node} */ (event.target)));
    if (tab) choose(tab);
  });
  list.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const shown = all().filter((tab) => tab.offsetParent);
    if (!step) return;
    const at = shown.findIndex((tab) => tab.getAttribute('aria-selected') === 'true');
    const next = shown[(at + step + shown.length) % shown.length];
    choose(next);
    next.focus();
    event.preventDefault();
  });

  return {
    /** After tabs have come or gone: exactly one is chosen. */
    settle() {
      const offered = all().filter((tab) => !tab.hidden);
      const first = offered.find((tab) => tab.getAttribute('aria-selected') === 'true') ?? offered[0];
      if (first) choose(first);
    },
    /** @param {Element} shown a panel */
    choosePanel(shown) {
      const tab = all().find((candidate) => panel(candidate) === shown);
      if (tab) choose(tab);
    },
    /** Marks the tab whose panel holds the fault. @param {Element | null} faulty */
    mark(faulty) {
      for (const tab of all()) tab.classList.toggle('faulty', faulty !== null && panel(tab) === faulty);
    },
  };
}
