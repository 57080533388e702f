// history.js -- the document that is edited, and the ones before and after it.
// @ts-check

const KEPT = 200; // steps of undo, of some kilobytes each

/**
 * @template T
 */
export class History {
  /** @param {T} value */
  constructor(value) {
    this.value = value;
    /** @type {T[]} */
    this.past = [];
    /** @type {T[]} */
    this.future = [];
  }

  /** One step: what was undone before is gone. */
  push(/** @type {T} */ value) {
    this.past.push(this.value);
    if (this.past.length > KEPT) this.past.shift();
    this.future = [];
    this.value = value;
  }

  /** The step back or forward; false where there is none. */
  undo() {
    return this.move(this.past, this.future);
  }

  redo() {
    return this.move(this.future, this.past);
  }

  /**
   * @param {T[]} from
   * @param {T[]} to
   */
  move(from, to) {
    if (from.length === 0) return false;
    to.push(this.value);
    this.value = /** @type {T} */ (from.pop());
    return true;
  }
}
