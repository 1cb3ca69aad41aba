/**
 * Renders a panel's HTML so that nodes, and with them focus, selection and scroll position, stay where they were: lit-html,
 * of which the page uses templates, lists with keys, and attributes that depend on state.
 */
export { html, nothing, render, svg } from 'lit-html';
export { ifDefined } from 'lit-html/directives/if-defined.js';
export { live } from 'lit-html/directives/live.js';
export { repeat } from 'lit-html/directives/repeat.js';
