/**
 * The planner's worker. It exports nothing: start it, or let the other entries do it.
 */
export {};
