// channel.js -- questions to a worker, one at a time. Of those that only the newest answer counts for, one waits at most.
// @ts-check

/**
 * @typedef {{ postMessage(message: any): void, onmessage: ((event: { data: any }) => void) | null, terminate(): void }} WorkerLike
 * @typedef {{ message: any, mayDrop: boolean, resolve: (reply: any) => void, reject: (error: unknown) => void }} Question
 */

export class Channel {
  /** @param {() => WorkerLike} start */
  constructor(start) {
    this.start = start;
    /** @type {Question[]} */
    this.waiting = [];
    /** @type {Question | null} */
    this.asked = null;
    this.worker = this.open();
  }

  open() {
    const worker = this.start();
    worker.onmessage = (event) => this.hear(event.data);
    return worker;
  }

  /** The answer, or the library's error. */
  ask(/** @type {any} */ message) {
    return this.put(message, false);
  }

  /** The answer, or null where a newer question took its place. */
  newest(/** @type {any} */ message) {
    this.waiting = this.waiting.filter((question) => {
      if (question.mayDrop) question.resolve(null);
      return !question.mayDrop;
    });
    return this.put(message, true);
  }

  /** Gives up what is being answered, if it may be, and takes another worker. */
  restart() {
    if (this.asked === null || !this.asked.mayDrop) return;
    this.worker.terminate();
    this.asked.resolve(null);
    this.asked = null;
    this.worker = this.open();
    this.next();
  }

  put(/** @type {any} */ message, /** @type {boolean} */ mayDrop) {
    return new Promise((resolve, reject) => {
      this.waiting.push({ message, mayDrop, resolve, reject });
      this.next();
    });
  }

  next() {
    if (this.asked !== null) return;
    this.asked = this.waiting.shift() ?? null;
    if (this.asked !== null) this.worker.postMessage(this.asked.message);
  }

  hear(/** @type {any} */ reply) {
    const question = this.asked;
    this.asked = null;
    if (question !== null && reply.error) question.reject(Object.assign(new Error(reply.error.message), reply.error));
    else if (question !== null) question.resolve(reply);
    this.next();
  }
}
