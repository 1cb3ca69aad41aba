/**
 * How both methods converge: distance to the minimum and projected gradient over the iterations, side by side.
 *
 * @typedef {import('../../core/types.js').Trace} Trace
 * @typedef {import('./algorithm-words.js').Method} Method
 */
import { element, setText } from '../../ui/dom.js';
import { scientific } from '../../core/format.js';
import { METHODS, SLOPES, above, comparison, kept, leastMetric } from './algorithm-words.js';
import { createPlot } from '../charts/plot.js';

/** @param {Method} method */
const seriesOf = (method) => [
  { name: 'f − f*', colour: 'var(--chart-0)' },
  { name: SLOPES[method].name, colour: 'var(--chart-1)', dash: [6, 3] },
];
/** Rows of the table, at most. */
const ROWS = 40;

/** @param {(method: Method, at: number) => void} choose @param {AbortSignal} signal */
export function createConvergence(choose, signal) {
  const words = element('p', { class: 'why-few' });
  const plots = /** @type {Method[]} */ (['gradient', 'newton']).map((method) => {
    const host = element('div', { class: 'plot', role: 'img' });
    const table = element('table', { class: 'plain' });
    const details = element(
      'details',
      { class: 'data', toggle: () => fill() },
      element('summary', {}, 'Table', element('span', { class: 'sr' }, ` of ${METHODS[method]}`)),
      element('div', { class: 'rows', tabindex: 0, role: 'region', 'aria-label': `Convergence of ${METHODS[method]}` }, table),
    );
    const heading = element('h4', {}, METHODS[method]);
    const plot = createPlot(host, { series: seriesOf(method), log: true, floor: 1e-17, write: scientific, onScrub: (at) => choose(method, at), signal });
    /** @type {Trace | null} */
    let shown = null;
    function fill() {
      if (!details.open || !shown) return;
      const history = shown[method];
      const rest = above(history, leastMetric(shown));
      const every = Math.ceil(kept(history) / ROWS);
      const rows = rest.map((_, at) => at).filter((at) => at % every === 0 || at === rest.length - 1);
      table.replaceChildren(
        element('thead', {}, element('tr', {}, ...['iteration', ...seriesOf(method).map(({ name }) => name)].map((name) => element('th', { scope: 'col' }, name)))),
        element(
          'tbody',
          {},
          ...rows.map((at) => element('tr', {}, element('th', { scope: 'row' }, String(history.iteration[at])), element('td', {}, scientific(rest[at])), element('td', {}, scientific(history.projected_gradient[at])))),
        ),
      );
    }
    return {
      method,
      root: element('div', {}, heading, host, details),
      /** @param {Trace} trace */
      show(trace) {
        shown = trace;
        const history = trace[method];
        plot.setData(Array.from(history.iteration), [above(history, leastMetric(trace)), history.projected_gradient]);
        host.setAttribute('aria-label', `${METHODS[method]}: ${history.last} iterations, logarithmic; ${SLOPES[method].name} goes from ${scientific(history.projected_gradient[0])} to ${scientific(history.projected_gradient.at(-1) ?? NaN)}. Values are in the table.`);
        fill();
      },
      /** @param {number | null} iteration */
      point: (iteration) => plot.setPlayhead(iteration),
    };
  });

  return {
    root: element(
      'section',
      { class: 'block wide-block', 'aria-label': 'Convergence' },
      element('h3', {}, 'Convergence'),
      element('ul', { class: 'keys-of-lines' }, element('li', { class: 'solid' }, 'f − f*, distance to the minimum'), element('li', { class: 'dashed' }, `${SLOPES.gradient.name}, or Newton’s projected gradient`)),
      element('div', { class: 'side-by-side' }, ...plots.map(({ root }) => root)),
      words,
    ),
    /** @param {Trace} trace */
    show(trace) {
      for (const plot of plots) plot.show(trace);
      setText(words, comparison(trace));
    },
    /** @param {Method} method @param {number} iteration */
    point(method, iteration) {
      for (const plot of plots) plot.point(plot.method === method ? iteration : null);
    },
  };
}
