// studio.js -- the document that is edited, and what follows it: picture, fields and proof.
// @ts-check
import { forcesOf } from "./forces.js";
import { History } from "./history.js";
import { edgesOf, freePlacesOf, placesOf } from "./places.js";
import { withEdits, withValue } from "./pointer.js";

const PROOF_FOLLOWS_MS = 60; // a proof as quick as this is made while dragging, too
const DRAG_MS = 8, REST_MS = 100; // steps of a draft while dragging, and when the hand lets go

/** Those that have drafts, and may take seconds to make. */
export const isFilm = (/** @type {any} */ document) => ["film", "plateau"].includes(document?.construct);

/**
 * @typedef {import("./pointer.js").Edit} Edit
 * @typedef {{ message: string, reason?: string, where?: string, construct?: string }} Failure  construct: of a document that was not taken
 * @typedef {{ proof(certificate: any, isDraft: boolean): void, document(document: any): void, fault(error: Failure | null): void,
 *   chosen(places: import("./places.js").Place[]): void, busy(word: string): void, legend(): void }} Views  what shows the state
 */

export class Studio {
  /**
   * @param {import("./engine.js").Engine} engine
   * @param {import("./scene.js").Scene} scene
   * @param {Views} views
   */
  constructor(engine, scene, views) {
    this.engine = engine;
    this.scene = scene;
    this.views = views;
    /** @type {History<any>} */
    this.history = new History(null);
    /** @type {import("./hand.js").Hand | null} */
    this.hand = null;
    /** @type {Promise<unknown>} */
    this.last = Promise.resolve();
    /** @type {any} */
    this.certificate = null;
    /** @type {string | undefined} */
    this.moving = undefined; // the document that a hand makes for now
    /** @type {{ surfaces: any[], curves: Float32Array[] } | null} */
    this.good = null; // what the document looks like
  }

  get document() {
    return this.history.value;
  }

  text() {
    return JSON.stringify(this.document);
  }

  /** One after another: what is asked for builds on what was asked for before, and a failure stops nothing. */
  inOrder(/** @type {() => Promise<any>} */ task) {
    const done = this.last.then(task);
    this.last = done.catch(() => {});
    return done;
  }

  /** The picture of a document; throws the library's error, and leaves the picture there was, greyed. */
  async draw(/** @type {any} */ document) {
    try {
      const text = JSON.stringify(document), { needsFields } = this.scene;
      const drawn = isFilm(document) ? await this.engine.film(text, needsFields) : await this.engine.draft(text, false, 0, needsFields);
      if (drawn === null) return; // a hand drags on, from the draft there is
      this.scene.setStale(false);
      this.views.fault(null);
      this.good = drawn;
      this.show(drawn);
    } catch (/** @type {any} */ error) {
      if (this.good !== null) this.show(this.good);
      this.scene.setStale(true);
      this.views.fault(Object.assign(error, { construct: document?.construct }));
      throw error;
    }
  }

  /** Another colour; what it needs of the surfaces is asked for where it was not before. */
  colour(/** @type {string} */ name) {
    this.scene.setColour(name);
    if (this.scene.lacksFields) this.inOrder(() => this.draw(this.document).then(() => this.views.legend())).catch(() => {});
  }

  /** What a hand can take: the points of the document, and those that it leaves free, where they are seen. */
  handOn(/** @type {any} */ document) {
    const places = placesOf(document), net = this.scene.hasNet ? this.scene.drawn[0]?.net : undefined;
    this.hand?.put([...places, ...freePlacesOf(document, net)], edgesOf(document, places));
  }

  /** Points that are free are held where they are; points that are held are freed. */
  hold(/** @type {import("./places.js").Place[]} */ chosen) {
    const edits = chosen.map(({ pointer, at, isFree }) => ({ pointer, value: isFree ? at : null }));
    return this.change((document) => withEdits(document, edits));
  }

  show(/** @type {{ surfaces: any[], curves: Float32Array[] }} */ drawn) {
    this.scene.show(drawn.surfaces);
    this.scene.showCurves(drawn.curves);
  }

  /** What shows the document follows it, and the proof is begun. */
  settle() {
    this.handOn(this.document);
    this.views.document(this.document);
    this.views.chosen(this.hand?.chosen() ?? []);
    this.prove(this.text());
  }

  /** Shows the certificate once it is there, if it is still wanted. */
  async prove(/** @type {string} */ text) {
    this.views.proof(this.certificate, true);
    const reply = await this.engine.proof(text).catch((error) => {
      if (text === this.text() && this.moving === undefined) this.views.fault(error);
      return null;
    });
    if (reply === null || (text !== this.text() && text !== this.moving)) return;
    const model = JSON.parse(reply.json);
    this.certificate = model.certificate;
    this.scene.setGaps(reply.gaps);
    this.scene.setForces(forcesOf(model));
    this.views.proof(this.certificate, text !== this.text());
  }

  /** One step: the document as `next` makes it; `isOther`: another problem, whose picture is framed anew. */
  change(/** @type {(document: any) => any} */ next, isOther = false) {
    return this.inOrder(async () => {
      const document = next(this.document), { moving } = this;
      if (moving === undefined) this.scene.remember(isOther);
      try {
        await this.draw(document);
      } finally {
        if (this.moving === moving) this.moving = undefined;
      }
      this.history.push(document);
      if (isOther) {
        this.certificate = null;
        this.scene.frame(placesOf(document).map(({ at }) => at));
      }
      this.settle();
    });
  }

  set(/** @type {string} */ pointer, /** @type {unknown} */ value) {
    return this.change((document) => withValue(document, pointer, value));
  }

  /** Another problem; the picture is framed anew. */
  async load(/** @type {any} */ document) {
    const given = typeof document === "string" ? parsed(document) : structuredClone(document);
    await this.change(() => given, true);
  }

  /** The first document: no step leads back beyond it. */
  async begin(/** @type {any} */ document) {
    await this.load(document);
    this.history.past = [];
  }

  step(/** @type {"undo" | "redo"} */ way) {
    return this.inOrder(async () => {
      if (!this.history[way]()) return false;
      await this.draw(this.document);
      this.settle();
      return true;
    });
  }

  /** The model of the document, with its certificate. */
  async model() {
    await this.last;
    return JSON.parse((await this.engine.model(this.text())).json);
  }

  // What a hand does between taking and letting go.

  async preview(/** @type {Edit[]} */ edits) {
    const document = withEdits(this.document, edits), text = JSON.stringify(document);
    if (this.moving === undefined) {
      this.engine.giveUpFilm();
      this.scene.remember(false);
      this.views.proof(this.certificate, true);
    }
    this.moving = text;
    this.handOn(document);
    try {
      const drawn = await this.engine.draft(text, true, DRAG_MS, this.scene.needsFields);
      if (drawn === null || this.moving !== text) return;
      this.scene.setStale(false);
      this.views.fault(null);
      this.show(drawn);
      this.handOn(document);
      if (this.engine.stats.final_ms > 0 && this.engine.stats.final_ms < PROOF_FOLLOWS_MS) this.prove(text);
    } catch (/** @type {any} */ error) {
      this.scene.setStale(true);
      this.views.fault(error);
    }
  }

  /** What took steps to draw comes to rest in the picture while it is made, in another worker, unless that takes no longer. */
  commit(/** @type {Edit[]} */ edits) {
    const document = withEdits(this.document, edits);
    if (isFilm(document) && this.engine.filmTook > REST_MS) this.rest(JSON.stringify(document));
    return this.change((now) => withEdits(now, edits)).catch(() => this.cancel(false));
  }

  async rest(/** @type {string} */ text) {
    const drawn = await this.engine.draft(text, true, REST_MS, this.scene.needsFields).catch(() => null);
    if (drawn?.isRough && this.moving === text) this.show(drawn);
  }

  /** Back to the document; `mayForget`: an error is forgotten, too. */
  cancel(mayForget = true) {
    this.moving = undefined;
    this.handOn(this.document);
    this.prove(this.text()); // what was proved last may be a place that the hand went through
    if (mayForget) this.inOrder(() => this.draw(this.document)).catch(() => {});
  }
}

/** A JSON text, or an error as the library's are. */
export function parsed(/** @type {string} */ text) {
  try {
    return JSON.parse(text);
  } catch (/** @type {any} */ error) {
    throw Object.assign(new Error(`this is no JSON text: ${error.message}`), { reason: "syntax", where: "" });
  }
}
