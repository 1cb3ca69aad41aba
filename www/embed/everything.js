/**
 * Everything in one script: the element, and the planner for programs.
 */
export * from '../planner/api.js';
export { SyntheticaLinkage } from '../element/embed.js';
