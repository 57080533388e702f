// engine.js -- the library beside the page: one worker draws, another proves, so that no drag waits for a proof.
// @ts-check
import { Channel } from "./channel.js";

const PATIENCE_MS = 400; // with a draft or a proof that nobody waits for any more

/**
 * @typedef {{ name: string, lines: number, positions: Float32Array, normals: Float32Array, mean: Float32Array | null,
 *   gaussian: Float32Array | null, isothermality: Float32Array | null, net: { nu: number, nv: number, points: Float64Array } }} Drawn
 */

export class Engine {
  /**
   * @param {string} source  the worker's script
   * @param {WebAssembly.Module} wasm  compiled once, for all workers
   */
  constructor(source, wasm) {
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    const start = () => this.startWorker(address, wasm);
    this.drawing = new Channel(start);
    this.proving = new Channel(start);
    this.start = start;
    /** @type {Channel | null} */
    this.making = null; // films, which take long: opened when there is the first
    this.filmTook = 0; // milliseconds, the last one
    this.stats = { solves: 0, draft_ms: 0, final_ms: 0 };
    this.draftBegan = 0;
    this.proofBegan = 0;
  }

  /**
   * A worker that answers once it has loaded the library: the answer to that first message is not passed on.
   * @param {string} address
   * @param {WebAssembly.Module} wasm
   * @returns {import("./channel.js").WorkerLike}
   */
  startWorker(address, wasm) {
    const worker = new Worker(address);
    /** @type {import("./channel.js").WorkerLike} */
    const like = { postMessage: (message) => worker.postMessage(message), onmessage: null, terminate: () => worker.terminate() };
    worker.onmessage = ({ data }) => {
      if (data.error) console.error(data.error.message);
      worker.onmessage = (event) => like.onmessage?.(event);
    };
    worker.onerror = (event) => like.onmessage?.({ data: { error: { message: event.message, reason: "fault", where: "" } } });
    worker.postMessage({ kind: "load", wasm });
    return like;
  }

  /**
   * What is to be drawn; null where a newer one was asked for and this one may be dropped.
   * @param {string} text
   * @param {boolean} mayDrop
   * @param {number} budget  milliseconds for steps from what was drawn last, where that can be; 0: it is made
   * @param {boolean} hasFields  with curvatures and isothermality, which take longer than the rest
   * @returns {Promise<{ surfaces: Drawn[], curves: Float32Array[], isRough: boolean } | null>}
   */
  async draft(text, mayDrop, budget, hasFields) {
    const start = performance.now();
    const message = { kind: "draft", text, budget, hasFields };
    if (this.drawing.asked !== null && start - this.draftBegan > PATIENCE_MS) this.drawing.restart();
    if (this.drawing.asked === null) this.draftBegan = start;
    const reply = await (mayDrop ? this.drawing.newest(message) : this.drawing.ask(message));
    this.draftBegan = performance.now();
    if (reply === null) return null;
    this.stats.solves++;
    this.stats.draft_ms = performance.now() - start;
    return reply;
  }

  /**
   * A film made as a whole, which may take seconds, beside the worker that drafts; null where it was given up.
   * @param {string} text
   * @param {boolean} hasFields
   * @returns {Promise<{ surfaces: Drawn[], curves: Float32Array[], isRough: boolean } | null>}
   */
  async film(text, hasFields) {
    const start = performance.now();
    this.making ??= new Channel(this.start);
    const reply = await this.making.newest({ kind: "draft", text, budget: 0, hasFields, hasModel: true });
    if (reply === null) return null;
    this.filmTook = reply.took;
    this.drawing.ask({ kind: "base", text: reply.model }).catch(() => {}); // drafts go on from it
    this.stats.solves++;
    this.stats.draft_ms = performance.now() - start;
    return reply;
  }

  /**
   * Begins with what is drawn first, while the page makes its picture ready: what is asked for then is there already.
   * @param {string} text
   * @param {boolean} isFilm
   */
  foresee(text, isFilm) {
    const message = { kind: "draft", text, budget: 0, hasFields: false };
    const first = isFilm ? (this.making = new Channel(this.start)).newest(message) : this.drawing.ask(message);
    first.catch(() => {}); // it fails again where it is asked for
  }

  /** A newer film is on the way: the one that is being made is not waited for. */
  giveUpFilm() {
    this.making?.restart();
  }

  /**
   * The model with its certificate, the program's bytes; null where a newer one was asked for.
   * @param {string} text
   * @returns {Promise<{ holds: boolean | null, json: string, gaps: (Float32Array | null)[] } | null>}
   */
  async proof(text) {
    const start = performance.now();
    if (this.proving.asked !== null && start - this.proofBegan > PATIENCE_MS) this.proving.restart();
    if (this.proving.asked === null) this.proofBegan = start;
    const reply = await this.proving.newest({ kind: "proof", text });
    this.proofBegan = performance.now();
    if (reply !== null) this.stats.final_ms = performance.now() - start;
    return reply;
  }

  /**
   * The same, whatever is asked for meanwhile.
   * @param {string} text
   * @returns {Promise<{ holds: boolean | null, json: string }>}
   */
  model(text) {
    return this.proving.ask({ kind: "proof", text });
  }

  /**
   * @param {string} text
   * @param {string} format
   * @returns {Promise<Uint8Array>}
   */
  async write(text, format) {
    return (await this.proving.ask({ kind: "export", text, format })).bytes;
  }
}
