/**
 * One chart on the page: its plot, a legend that hides and shows series and gives their values, and its table.
 *
 * @typedef {import('./chart-list.js').Chart} Chart
 *
 * What all charts share: the scale along x, and what is done with a frame that is pointed at.
 * @typedef {{x: ArrayLike<number>, extent: [number, number] | null, heads: [string, ArrayLike<number>, number][]}} Along values of the scale, its extent
 *   where only a part of the motion is planned, and columns of the table with their decimals
 * @typedef {{hidden: Set<string>, sync: string, signal: AbortSignal, onHover: (frame: number | null) => void, onScrub: (frame: number) => void}} Shared
 */
import { element, setText } from '../../ui/dom.js';
import { html, nothing, render } from '../../ui/render.js';
import { short } from '../../core/format.js';
import { summary, tableFrames, withUnit, writeValue } from './chart-list.js';
import { createPlot } from './plot.js';

const COLOURS = 6;
/** Strokes and gaps in pixels. Another count than the colours: a pair comes again after twelve lines only. */
const DASHES = [[], [7, 3], [2, 2], [9, 3, 2, 3]];

const SVG = 'http://www.w3.org/2000/svg';

/** @param {Chart} chart @param {Shared} shared */
export function createCard(chart, { hidden, sync, signal, onHover, onScrub }) {
  let shown = chart;
  const many = chart.series.length > 1;
  const styles = chart.series.map((_, i) => ({ colour: `var(--chart-${i % COLOURS})`, dash: DASHES[i % DASHES.length] }));
  const values = chart.series.map(() => element('span', { class: 'value' }));
  const host = element('div', { class: 'plot', role: 'img' });
  const unit = chart.unit && element('small', {}, chart.unit);

  const toggles = chart.series.map(({ name }, i) => {
    const key = `${chart.id}/${name}`;
    const button = element('button', { 'aria-pressed': String(!hidden.has(key)), title: 'Hide or show', click: toggle }, sample(styles[i]), name);
    function toggle() {
      const on = hidden.delete(key);
      if (!on) hidden.add(key);
      button.setAttribute('aria-pressed', String(on));
      plot.show(i, on);
    }
    return button;
  });

  const table = element('table', { class: 'plain' });
  const data = element(
    'details',
    { class: 'data', toggle: openTable },
    element('summary', {}, 'Table', element('span', { class: 'sr' }, ` of ${chart.title}`)),
    element('div', { class: 'rows', tabindex: 0, role: 'region', 'aria-label': `Table of ${chart.title}` }, table),
  );
  const root = element(
    'section',
    { class: 'chart', 'aria-label': chart.title },
    element(
      'header',
      {},
      element('h2', {}, chart.title, ...(unit ? [' ', unit] : [])),
      element('ul', {}, ...values.map((value, i) => element('li', {}, ...(many ? [toggles[i]] : []), value))),
    ),
    host,
    data,
  );

  const plot = createPlot(host, {
    series: chart.series.map(({ name }, i) => ({ name, ...styles[i], steps: chart.steps })),
    log: chart.log,
    floor: chart.floor,
    zero: chart.zero,
    span: chart.span,
    write: (value) => writeValue(chart, value),
    sync,
    signal,
    onHover,
    onScrub,
  });
  chart.series.forEach(({ name }, i) => {
    if (hidden.has(`${chart.id}/${name}`)) plot.show(i, false);
  });

  /** @type {Along} */
  let along = { x: [], extent: null, heads: [] };

  function openTable() {
    if (!data.open) return;
    fillTable();
    data.scrollIntoView({ block: 'nearest' });
  }

  function fillTable() {
    const { every, shown: frames } = tableFrames(along.x.length);
    const { length } = along.x;
    render(
      html`<caption>${every > 1 ? `${shown.title}, every ${every}th of ${length} frames` : `${shown.title}, all ${length} frames`}</caption>
        <thead>
          <tr>
            <th scope="col">frame</th>
            ${along.heads.map(([head]) => html`<th scope="col">${head}</th>`)}
            ${shown.series.map(({ name }) => html`<th scope="col">${many ? name : 'value'}${shown.unit ? html`<small>${shown.unit}</small>` : nothing}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${frames.map(
            (frame) => html`<tr>
              <th scope="row">${frame + 1}</th>
              ${along.heads.map(([, column, decimals]) => html`<td>${short(column[frame], decimals)}</td>`)}
              ${shown.series.map((one) => html`<td>${writeValue(shown, one.values[frame])}</td>`)}
            </tr>`,
          )}
        </tbody>`,
      table,
    );
  }

  return {
    root,
    /** New values of the same series. @param {Chart} next @param {Along} scale */
    update(next, scale) {
      shown = next;
      along = scale;
      plot.setData(along.x, next.series.map((one) => one.values), along.extent);
      host.setAttribute('aria-label', summary(next));
      if (data.open) fillTable();
    },
    /** @param {number} frame at the playhead @param {number} read frame whose values the legend gives */
    showAt(frame, read) {
      plot.setPlayhead(along.x[frame]);
      shown.series.forEach((one, i) => setText(values[i], withUnit(shown, one.values[read])));
    },
    destroy() {
      plot.destroy();
      root.remove();
    },
  };
}

/** A piece of the line. @param {{colour: string, dash: number[]}} style */
function sample({ colour, dash }) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 22 8');
  svg.setAttribute('aria-hidden', 'true');
  const line = document.createElementNS(SVG, 'path');
  line.setAttribute('d', 'M0 4h22');
  line.setAttribute('stroke-dasharray', dash.join(' '));
  line.style.stroke = colour;
  svg.append(line);
  return svg;
}
