/**
 * What a person has given cannot be used, and the message says why in words that are meant for them.
 */
export class Refusal extends Error {}
