/**
 * How a question to the planner can end without an answer.
 */

/** The document is at fault, and a person can mend it. */
export class DocumentFault extends Error {
  name = 'DocumentFault';

  /** @param {import('../core/types.js').Fault} fault */
  constructor(fault) {
    super(fault.message);
    /** All that is known of it: for text that is no JSON, line and column too. @type {import('../core/types.js').Fault} */
    this.fault = fault;
    /** Names the kind of fault. */
    this.code = fault.code;
    /** The place in the document, such as `chains[1].joints[0].rows[0].alpha`; empty for the whole. */
    this.where = fault.where;
  }
}

/** A newer call of the same kind took this one's place, or its asker has left: nobody waits for its answer. */
export class Superseded extends Error {
  name = 'Superseded';
  message = 'nobody waits for the answer any more';
}

/** The planner itself failed: our mistake, not the document's. */
export class PlannerFailure extends Error {
  name = 'PlannerFailure';
}

/** The planner could not be loaded, as when the network fails. It is loaded anew for the next question. */
export class PlannerNotLoaded extends PlannerFailure {
  name = 'PlannerNotLoaded';
}
