/**
 * One plot on the page: a thin shell around uPlot that knows the page's colours, a playhead, and scrubbing.
 * Heavy; import it only where something is plotted.
 *
 * The host element gives the size (its style sheet must give it a height) and is followed when that changes.
 *
 * @typedef {object} PlotSeries
 * @property {string} name
 * @property {string} colour a colour as in a style sheet, `var(--chart-0)`
 * @property {number[]} [dash] lengths of strokes and gaps in pixels, so that lines are told apart without colour
 * @property {boolean} [steps] values hold until the next, as counts do
 *
 * @typedef {object} PlotOptions
 * @property {PlotSeries[]} series
 * @property {boolean} [log] logarithmic values; what is not above `floor` is drawn at `floor`
 * @property {number} [floor]
 * @property {boolean} [zero] the scale begins at zero
 * @property {number} [span] smallest extent of the scale, so that rounding is not drawn as a mountain range
 * @property {(value: number) => string} [write] a value on a logarithmic scale as text
 * @property {string} [sync] plots with the same key share the cursor
 * @property {(index: number | null) => void} [onHover] the point under the cursor, null when it has left
 * @property {AbortSignal} [signal] ends it
 * @property {(index: number) => void} [onScrub] the point that was clicked or dragged to
 */
import uPlot from 'uplot';
import { element } from '../../ui/dom.js';
import { short } from '../../core/format.js';
import { logTicks, tickText } from './ticks.js';

/** What a tree with plots in it wears. */
export { default as plotLook } from 'uplot/dist/uPlot.min.css?inline';

const FONT = '11px system-ui, sans-serif';
const LINE_WIDTH = 1.6;
/** Room above and below the values, as a share of their extent. */
const MARGIN = 0.06;

/** @param {HTMLElement} host @param {PlotOptions} options */
export function createPlot(host, { series, log = false, floor = 1e-16, zero = false, span = 1e-9, write = (value) => short(value), sync, onHover, onScrub, signal }) {
  let colour = createColours(host);
  const line = element('div', { class: 'playhead' });
  /** @type {number | null} */
  let playhead = null;
  /** Of the scale along x, where it goes further than the points. @type {[number, number] | null} */
  let extent = null;

  /** @type {uPlot.Range.Function} */
  const range = (_, low, high) => {
    if (low === null || high === null) return log ? [1e-3, 1] : [0, span];
    const from = zero ? Math.min(0, low) : low;
    if (log) return uPlot.rangeLog(from, Math.max(high, from * 1.01), 10, true);
    const missing = Math.max(0, span - (high - from));
    const margin = MARGIN * Math.max(high - from, span);
    return zero ? [from - (from < 0 ? margin : 0), high + missing + margin] : [from - missing / 2 - margin, high + missing / 2 + margin];
  };

  /** On a logarithmic scale only what has room is ruled and labelled. @type {uPlot.Axis.Filter} */
  const powers = (self, splits) => {
    const { min = 1, max = 1 } = self.scales.y;
    return logTicks(splits, Math.log10(Number(max) / Number(min)), self.over.clientHeight);
  };
  const only = log ? { filter: powers } : {};
  /** Ticks of a linear scale, as finely as they lie; where everything is zero only that. @param {uPlot} self @param {number[]} all */
  const linear = (self, all) => {
    const none = self.data.slice(1).every((column, i) => !self.series[i + 1].show || Array.from(column).every((value) => value === 0));
    return all.map((value) => (none && zero && value !== 0 ? '' : tickText(value, all[1] - all[0])));
  };
  const ink = { stroke: () => colour('var(--muted)'), font: FONT, gap: 3 };
  const rules = { stroke: () => colour('var(--line)'), width: 1 };
  const plot = new uPlot(
    {
      width: Math.max(1, host.clientWidth),
      height: Math.max(1, host.clientHeight),
      padding: [6, 8, 0, 0],
      legend: { show: false },
      cursor: {
        // A finger leaves no cursor behind.
        show: matchMedia('(any-hover: hover)').matches,
        y: false,
        drag: { setScale: false, x: false, y: false },
        points: { size: 5 },
        ...(sync && { sync: { key: sync, scales: ['x', null] } }),
      },
      scales: {
        x: { time: false, range: (_, low, high) => (extent ?? (low === high ? [low - 0.5, high + 0.5] : [low, high])) },
        y: { distr: log ? 3 : 1, range },
      },
      axes: [
        { ...ink, grid: rules, ticks: { ...rules, size: 4 }, size: 20, space: 56, values: (_, all) => all.map((value) => short(value)) },
        {
          ...ink,
          ...only,
          grid: { ...rules, ...only },
          ticks: { ...rules, ...only, size: 4 },
          space: 26,
          size: (_, texts) => 12 + 6.4 * Math.max(2, ...(texts ?? []).map((text) => text?.length ?? 0)),
          values: (self, all) => (log ? all.map((value) => (value === null ? '' : write(value))) : linear(self, all)),
        },
      ],
      series: [
        {},
        ...series.map((one) => ({
          label: one.name,
          stroke: () => colour(one.colour),
          width: LINE_WIDTH,
          dash: one.dash,
          points: { show: false },
          // On whole pixels a slow curve would be a staircase.
          pxAlign: 0,
          paths: one.steps ? uPlot.paths.stepped?.({ align: 1 }) : undefined,
        })),
      ],
      hooks: { draw: [place] },
    },
    [[], ...series.map(() => [])],
    (self, begin) => {
      host.append(self.root);
      begin();
    },
  );
  plot.over.append(line);

  function place() {
    // The first drawing comes before the plot is returned.
    if (!plot) return;
    line.hidden = playhead === null;
    if (playhead !== null) line.style.transform = `translateX(${plot.valToPos(playhead, 'x')}px)`;
  }

  const { over } = plot;
  const under = (/** @type {PointerEvent} */ event) => plot.posToIdx(event.clientX - over.getBoundingClientRect().left);
  if (onHover) {
    over.addEventListener('pointermove', (event) => event.pointerType !== 'touch' && onHover?.(under(event)));
    over.addEventListener('pointerleave', () => onHover?.(null));
  }
  if (onScrub) {
    over.classList.add('scrubs');
    const scrub = (/** @type {PointerEvent} */ event) => onScrub?.(under(event));
    over.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      scrub(event);
    });
    over.addEventListener('pointermove', (event) => {
      if (over.hasPointerCapture(event.pointerId)) scrub(event);
    });
  }

  const follow = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = host;
    if (width > 0 && height > 0 && (width !== plot.width || height !== plot.height)) plot.setSize({ width, height });
  });
  follow.observe(host);

  function repaint() {
    colour.forget();
    plot.redraw(false);
  }
  const life = new AbortController();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint, { signal: life.signal });
  matchMedia('(forced-colors: active)').addEventListener('change', repaint, { signal: life.signal });
  window.addEventListener('synthetica-theme', repaint, { signal: life.signal });

  function destroy() {
    life.abort('destroyed');
    follow.disconnect();
    plot.destroy();
    // V8 keeps the first object with a getter that some code made, and uPlot makes one: what it holds must not hold the page.
    host = element('div');
    colour = createColours(host);
    write = String;
    onHover = onScrub = signal = undefined;
  }
  // uPlot listens to the window: it must not outlive its page's interest.
  signal?.addEventListener('abort', destroy, { signal: life.signal });

  return {
    /** @param {ArrayLike<number>} x growing @param {ArrayLike<number>[]} columns one a series @param {[number, number] | null} [along] the extent of the scale along x */
    setData(x, columns, along = null) {
      extent = along;
      const drawn = log ? columns.map((column) => Array.from(column, (value) => Math.max(value, floor))) : columns;
      plot.setData(/** @type {uPlot.AlignedData} */ ([x, ...drawn]));
    },
    /** @param {number} index of the series @param {boolean} on */
    show(index, on) {
      if (plot.series[index + 1].show !== on) plot.setSeries(index + 1, { show: on });
    },
    /** Moves the line at the present moment without drawing anew. @param {number | null} x */
    setPlayhead(x) {
      playhead = x;
      place();
    },
    destroy,
  };
}

/** Colours of the style sheet as a canvas needs them. @param {HTMLElement} host */
function createColours(host) {
  const probe = element('i', { hidden: true });
  // Or a browser with forced colours would give the same for all.
  probe.style.forcedColorAdjust = 'none';
  host.append(probe);
  /** @type {Map<string, string>} */
  const known = new Map();
  /** @param {string} css */
  const colour = (css) => {
    let found = known.get(css);
    if (!found) {
      probe.style.color = css;
      found = getComputedStyle(probe).color;
      known.set(css, found);
    }
    return found;
  };
  colour.forget = () => known.clear();
  return colour;
}
