/**
 * "Why not closer" in the info panel: the certificate, the chains that hold the workpiece back, what is left of the
 * gap, and the freedoms at what is shown.
 */
import { element, focusBeside, setText } from '../../ui/dom.js';
import { shown, groupAt } from '../../core/shown.js';
import { atLimits, certificate, chainName, freedomInWords, mostHolding, percentages, twistInWords, wrenchInWords } from './why-words.js';
import { statusName } from '../../core/status-words.js';

/** @param {Pick<import('../../element/workbench.js').App, 'find' | 'store'>} app */
export function createWhy({ find, store }) {
  const root = find('why');
  const sentence = element('p', { class: 'why-sentence' });
  const limits = element('ul', { class: 'why-limits' });
  const bars = element('ul', { class: 'shares', 'aria-label': 'Share of each chain in holding the workpiece back' });
  const proof = element('p', { class: 'why-proof' });
  const gap = element('dl', { class: 'why-gap' });
  const freedoms = element('ul', { class: 'why-freedoms' });
  const freedomHead = element('summary');
  const gapDetails = element('details', {}, element('summary', {}, 'What is left of the gap'), gap);
  root.replaceChildren(
    element('h2', {}, 'Why not closer'),
    sentence, limits, bars, proof,
    gapDetails,
    element('details', {}, freedomHead, freedoms),
  );
  /** @type {HTMLElement[]} */
  let items = [];

  /** @param {string} hovered */
  const point = (hovered) => () => store.setView({ hovered });

  /** @param {number} chain @param {string} name @param {number} percent @param {string} holds */
  function bar(chain, name, percent, holds) {
    const place = `chains[${chain}]`;
    const fill = element('i', { class: `chain-${chain % 5}` });
    fill.style.width = `${percent}%`;
    const button = element(
      'button',
      {
        'aria-pressed': 'false',
        pointerenter: point(place), pointerleave: point(''), focus: point(place), blur: point(''),
        click: () => store.setView({ selected: store.view.selected === place ? '' : place }),
      },
      element('span', {}, name),
      element('span', { class: 'share-track', 'aria-hidden': 'true' }, fill),
      element('strong', {}, `${percent} %`),
    );
    return element('li', { 'data-place': place }, button, ...(percent > 0 ? [element('small', {}, holds)] : []));
  }

  /** Of which motion, frame and posture the words are. */
  function show() {
    const { motion, doc } = store.result;
    const what = shown(store);
    root.hidden = !motion;
    if (!motion || !doc || !what) return;
    const status = store.view.posture?.status ?? statusName(motion, what.index);
    const { insight } = store;
    root.classList.toggle('waiting', insight === null);
    const met = status === 'reached';
    const lost = status === 'closure_lost';
    bars.hidden = met || lost;
    limits.hidden = met || lost;
    proof.hidden = met || lost;
    gapDetails.hidden = met || lost;
    if (met) items = [];
    if (met) setText(sentence, 'The goal is met; nothing holds it back.');
    if (lost) setText(sentence, 'The loops are open here, so nothing can be said of what holds the workpiece.');
    // The words stay until the new ones are there.
    if (!insight && !met && !lost && !items.length) root.hidden = true;
    if (!insight || lost) return;
    if (!met) {
      const { metric, bounds } = motion.report;
      const shares = percentages(insight.chains.map(({ share }) => share));
      setText(sentence, mostHolding(insight, doc, metric.length) || 'No chain holds it back here: the linkage could still come nearer.');
      const focused = items.findIndex((item) => item.contains(focusBeside(root)));
      items = insight.chains.map(({ wrench }, i) => bar(i, chainName(doc, i), shares[i], `withstands ${wrenchInWords(wrench, metric.length)}`));
      bars.replaceChildren(...items);
      if (focused >= 0) items[focused]?.querySelector('button')?.focus();
      limits.replaceChildren(...atLimits(doc, motion.report, groupAt(what.joints, what)).map(({ text }) => element('li', {}, text)));
      setText(proof, certificate(insight, status, bounds));
      gap.replaceChildren(
        ...[['The gap', insight.gap], ['in free directions', insight.free_part], ['in blocked directions', insight.blocked_part]].flatMap(([name, twist]) => [
          element('dt', {}, String(name)),
          element('dd', {}, twistInWords(/** @type {number[]} */ (twist), doc.length_unit)),
        ]),
      );
    }
    setText(freedomHead, `Freedoms here: ${insight.freedoms.length}`);
    freedoms.replaceChildren(
      ...(insight.freedoms.length ? insight.freedoms.map((screw) => freedomInWords(screw, doc.length_unit)) : ['None: the workpiece is held.']).map((text) => element('li', {}, text)),
    );
    mark();
  }

  function mark() {
    const { hovered, selected } = store.view;
    for (const item of items) {
      const { place = '' } = item.dataset;
      item.classList.toggle('pointed', hovered === place || hovered.startsWith(`${place}.`));
      item.querySelector('button')?.setAttribute('aria-pressed', String(selected === place));
    }
  }

  store.subscribe('insight', show);
  store.subscribe('result', show);
  let { frame, posture } = store.view;
  store.subscribe('view', () => {
    // What is pointed at changes far more often than what is shown.
    const other = frame !== store.view.frame || posture !== store.view.posture;
    ({ frame, posture } = store.view);
    if (other) show();
    else mark();
  });
  show();
}
