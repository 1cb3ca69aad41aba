/**
 * The version of the messages between a frame and the page around it; protocol.js says what they are.
 */
export const VERSION = 1;
