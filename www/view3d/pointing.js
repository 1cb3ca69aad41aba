/**
 * Pointing at things in the 3D view: hover tells what a thing is, a click or a tap selects it, and what is selected or
 * pointed at elsewhere is told here. With the keyboard, [ and ] go through the things and Enter selects.
 */
import { element, setText } from '../ui/dom.js';
import { onKeys } from '../ui/keys.js';
import { hasNoGoal } from '../core/shown.js';
import { nameOf, thingsOf } from '../core/things.js';

/** How far a pointer may move in a click, in pixels: a hand on a touch screen is less steady. */
const STEADY = { mouse: 4, touch: 10 };

/** @param {Pick<import('../element/workbench.js').App, 'find' | 'store' | 'player' | 'scene'>} app */
export function createPointing({ find, store, player, scene }) {
  if (!scene) return;
  const { canvas } = scene;
  const tip = element('p', { id: 'tip', 'aria-hidden': 'true', hidden: true });
  canvas.after(tip);
  const live = find('view-live');

  /** The pointer over the canvas, as it last moved. @type {PointerEvent | null} */
  let pointer = null;
  let waiting = false;
  /** Where a press began. @type {{x: number, y: number, id: number} | null} */
  let press = null;

  /** What is not drawn where there is no goal. @param {string} place */
  const isAway = (place) => hasNoGoal(store) && /^(goal|gap)/.test(place);

  /** @param {PointerEvent} event */
  const thingAt = (event) => (scene.claims(event) ? '' : scene.pick(event));

  function look() {
    waiting = false;
    if (!pointer) return;
    store.setView({ hovered: thingAt(pointer) });
    placeTip();
  }

  /** The name of what is under the pointer stands beside the pointer. */
  function placeTip() {
    const text = pointer ? nameOf(store.view.hovered, store) : '';
    tip.hidden = !text;
    canvas.classList.toggle('pointing', text !== '');
    if (!text || !pointer) return;
    setText(tip, text);
    const box = canvas.getBoundingClientRect();
    const x = Math.min(pointer.clientX - box.left + 14, box.width - tip.offsetWidth - 6);
    const y = pointer.clientY - box.top + 18;
    const above = y + tip.offsetHeight + 6 > box.height ? tip.offsetHeight + 30 : 0;
    tip.style.transform = `translate(${Math.max(4, x)}px, ${y - above}px)`;
  }

  function leave() {
    if (pointer) store.setView({ hovered: '' });
    pointer = null;
    placeTip();
  }

  /** @param {string} place */
  function select(place) {
    const frame = /^(?:gap|ghost)\[(\d+)\]$/.exec(place)?.[1];
    if (frame) {
      // A gap's or a ghost's own frame is what there is to see of it.
      player.pause();
      player.frame = Number(frame);
    }
    store.setView({ selected: place });
    setText(live, place ? `Selected: ${nameOf(place, store)}.` : 'Nothing is selected.');
  }

  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch') return;
    if (event.buttons) return leave();
    pointer = event;
    if (!waiting) requestAnimationFrame(look);
    waiting = true;
  });
  canvas.addEventListener('pointerleave', leave);
  canvas.addEventListener('pointerdown', (event) => {
    const alone = event.isPrimary && event.button === 0 && !scene.claims(event);
    press = alone ? { x: event.clientX, y: event.clientY, id: event.pointerId } : null;
  });
  canvas.addEventListener('pointercancel', () => {
    press = null;
  });
  canvas.addEventListener('pointerup', (event) => {
    if (!press || press.id !== event.pointerId) return;
    const steady = event.pointerType === 'touch' ? STEADY.touch : STEADY.mouse;
    const still = Math.hypot(event.clientX - press.x, event.clientY - press.y) <= steady;
    press = null;
    if (still) select(thingAt(event));
  });

  /** @param {number} step */
  function goOn(step) {
    const { doc } = store.result;
    if (!doc) return;
    const things = thingsOf(doc).filter((place) => !isAway(place));
    const at = things.indexOf(store.view.hovered || store.view.selected);
    const next = at < 0 ? (step > 0 ? 0 : things.length - 1) : (at + step + things.length) % things.length;
    leave();
    store.setView({ hovered: things[next] });
    setText(live, `${nameOf(things[next], store)}, ${next + 1} of ${things.length}. Enter selects it.`);
  }

  onKeys(canvas, {
    thingAfter: () => goOn(1),
    thingBefore: () => goOn(-1),
    choose: () => store.view.hovered !== '' && select(store.view.hovered),
    chooseNone() {
      if (!store.view.selected && !store.view.hovered) return false;
      store.setView({ hovered: '' });
      select('');
    },
  });
  canvas.addEventListener('blur', () => {
    if (!pointer) store.setView({ hovered: '' });
  });

  const show = () => {
    const { selected, hovered } = store.view;
    scene.highlight(
      { place: selected, text: isAway(selected) ? '' : nameOf(selected, store) },
      { place: hovered, text: pointer || isAway(hovered) ? '' : nameOf(hovered, store) },
    );
  };
  store.subscribe('view', show);
  store.subscribe('result', () => {
    show();
    placeTip();
  });
}
