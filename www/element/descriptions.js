/**
 * What attributes, events and the rest of <synthetica-linkage> are, in sentences of Markdown: for the reference, the types and
 * the package's manifest of elements. No page loads it.
 */

/** What each attribute does. @type {Record<import('./attributes.js').Name, string>} */
export const DESCRIPTIONS = {
  src: 'Address of a document.',
  type: 'A sample by its name or its file; a maker with its inputs, such as `delta?base=400&platform=50&arms=300,580&unit=mm` (what is left out has the number of its paper); or any type, such as `3RRS` or `RPS+2TS`: chains of joints from base to workpiece, each with its count. A name alone that is a type too is the type: `?` behind it asks for the maker.',
  controls: 'The animation bar, the buttons of the view, the legend.',
  autoplay: 'Plays as soon as the motion is there, unless the reader asks for less motion.',
  loop: 'At the end from the start again, without end.',
  bounce: 'There and back without end, with or without `loop`.',
  frame: 'The frame shown first, from 0.',
  speed: 'A factor, such as `0.5`.',
  view: 'The side that is looked from; without it the linkage stands turned as it was left.',
  theme: 'The scheme: `auto` is the system’s; without it the page’s own.',
  readonly: 'Everything can be looked at, nothing edited.',
  panels: 'Which panels stand around the view, with blanks between.',
  interaction: 'What is taken of the reader’s pointer, wheel and keys: nothing, what a page does not need to scroll, or everything.',
  keys: '`page`: the keys work wherever the focus is; else only within the element.',
  loading: '`lazy`: nothing is loaded until it comes near the view, or a script asks for something; `eager`: at once.',
  poster: 'Address of a picture that stands there until the linkage does.',
};

/** When each event is told, and the type of its `detail`. @type {Record<string, {when: string, detail: string}>} */
export const EVENTS = {
  ready: { when: 'The first motion of a document is there.', detail: 'null' },
  play: { when: 'The animation begins, or will with the first motion.', detail: 'null' },
  pause: { when: 'The animation rests.', detail: 'null' },
  ended: { when: 'It has played to its end.', detail: 'null' },
  timeupdate: { when: 'The playhead is at another frame while it plays, or has been set.', detail: 'null' },
  seeking: { when: 'The playhead is set.', detail: 'null' },
  seeked: { when: 'The playhead is where it was set.', detail: 'null' },
  framechange: { when: 'Another frame is shown.', detail: '{ frame: number; time: number }' },
  input: { when: 'The reader edits the document.', detail: 'null' },
  change: { when: 'The edit is finished, and planned.', detail: 'null' },
  error: {
    when: 'The document, its address, an attribute or a property set early is at fault; or the planner failed or could not be loaded, which a button in the view asks for again.',
    detail: 'LinkageError',
  },
};

/**
 * Properties that are no attributes, and methods.
 * @type {Record<string, {type: string, what: string, given?: string, readonly?: true}>} `given`: the parameters of a method
 */
export const MEMBERS = {
  play: { type: 'Promise<void>', given: '', what: 'The animation begins, after the first motion if need be. The promise resolves when it does; it rejects with an `AbortError` by `pause()`, by another document or when the element is taken out before that, and with a `NotSupportedError` where the document is at fault.' },
  pause: { type: 'void', given: '', what: 'The animation rests.' },
  paused: { type: 'boolean', readonly: true, what: 'Whether it rests, and is not about to play.' },
  ended: { type: 'boolean', readonly: true, what: 'Whether it is at its end, without `loop` and `bounce`.' },
  seeking: { type: 'boolean', readonly: true, what: 'Whether the playhead has been set, and `seeked` is to come.' },
  currentTime: { type: 'number', what: 'From the first frame: in the unit of time of the key frames or of the driven joints; from 0 to 1 where key frames have no times. Beyond an end it is that end, as in the media elements.' },
  duration: { type: 'number', readonly: true, what: 'Of the motion, in the same unit; 0 before there is one.' },
  playbackRate: { type: 'number', what: 'The same as `speed`.' },
  readyState: { type: '0 | 1 | 4', readonly: true, what: '0 without a document or while another one is asked for, 1 when it is read, 4 when its motion is there.' },
  document: { type: 'MechanismDocument | string | null', what: 'The document as it is now, with every default; `null` before there is one. Give it an object or its text. `null` empties the element: no document, no motion, no error, until another one is asked for.' },
  linkage: { type: 'MechanismDocument | string | null', what: 'The same as `document`, which in the text of an inline handler is the page’s own.' },
  trajectory: { type: 'Motion | null', readonly: true, what: 'The planned motion, a [`Motion`](#javascript); `null` until that of the document is there.' },
  error: { type: 'LinkageError | null', readonly: true, what: 'What is wrong, `{message, where, code}`; else `null`.' },
  whenReady: { type: 'Promise<Motion>', given: '', what: 'Loads what the motion needs wherever the element is, and waits for it; fails with what is wrong where there will be none.' },
  toCSV: { type: 'Promise<string>', given: "options?: { headings?: 'units' | 'plain' | 'two-rows' }", what: 'The motion as a table; its units stand where `headings` says, see [Files for other programs](#files-for-other-programs).' },
  toImage: { type: 'Promise<Blob>', given: "wish?: { type?: 'png' | 'svg'; width?: number; height?: number; scale?: number }", what: 'A picture of the view as it is now, in CSS pixels, `scale` pixels to one of those.' },
  focus: { type: 'void', given: 'options?: FocusOptions', what: 'The view takes the focus, made or not.' },
};
