/**
 * What can be made of a posture that the linkage was moved to by hand: a key frame or the start.
 */
import { keyFramesOf } from '../../core/key-frames.js';
import { takeStarts } from '../../core/edits.js';
import { asWritten } from '../../core/document-angles.js';
import { addKeyFrame } from '../../core/key-frame-edits.js';
import { hasDrivers } from '../../core/driven.js';
import { element } from '../../ui/dom.js';
import { degrees } from '../../core/format.js';
import { plain, shownFrame } from '../../core/shown-frame.js';

/**
 * The buttons, for where a posture is told of.
 * @param {Pick<import('../../element/workbench.js').App, 'store'>} app
 */
export function postureActions({ store }) {
  /** The reached pose as the last key frame. */
  function addKey() {
    const fresh = shownFrame(store, 'pose');
    if (!fresh) return;
    store.edit((doc) => addKeyFrame(doc, fresh));
    store.setView({ selected: `motion.key_frames[${keyFramesOf(store.doc).length - 1}]` });
  }

  function useAsStart() {
    const { result, view } = store;
    if (!view.posture || !result.motion) return;
    const { joints } = view.posture;
    let at = 0;
    const starts = result.motion.report.chains.map(({ variables }) =>
      variables.map(({ unit }) => plain(unit === 'rad' ? asWritten(store.doc, degrees(joints[at++])) : joints[at++])),
    );
    store.edit((doc) => takeStarts(doc, doc.chains.map((chain, index) => ({ ...chain, start: starts[index] }))));
  }

  if (store.readonly) return [];
  const key = element('button', { class: 'link', title: 'The pose reached here becomes the last key frame', click: addKey }, 'Add key frame here');
  // Where joints are driven there are no key frames.
  const offer = () => (key.hidden = hasDrivers(store.doc));
  store.subscribe('document', offer);
  offer();
  return [
    key,
    element('button', { class: 'link', title: 'Plan the motion from these joint values', click: useAsStart }, 'Use as start'),
  ];
}
