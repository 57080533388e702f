// hand.js -- points and edges under the pointer: taken, moved in the plane of the picture, along an axis or the normal, put on a grid.
// @ts-check
import { withImages } from "./mirror.js";

/** @typedef {import("./places.js").Place} Place */
/** @typedef {import("./places.js").Edge} Edge */
/** @typedef {import("./pointer.js").Edit} Edit */
/** @typedef {{ start: number[], base: Place[], all: Place[], edits: Edit[], moved: boolean }} Drag */

const REACH = 12, FINGER_REACH = 24, EDGE_REACH = 7, STILL = 3; // pixels
const FINE = 0.1;

/** A number of about three digits more than a pixel needs, or the nearest multiple of the step. */
export function tidy(/** @type {number} */ x, /** @type {number} */ pixel, /** @type {number} */ step) {
  if (step > 0) return Number((Math.round(x / step) * step).toPrecision(12));
  const digits = Math.min(15, Math.max(0, 1 - Math.floor(Math.log10(pixel))));
  return Number(x.toFixed(digits)) + 0;
}

/** The part of a way that an axis lets through: "view" all of it, "x", "y", "z" or a unit vector. */
export function alongAxis(/** @type {number[]} */ way, /** @type {number[] | null} */ axis) {
  if (axis === null) return way;
  const share = way.reduce((sum, x, c) => sum + x * axis[c], 0);
  return axis.map((x) => x * share);
}

/** The distance of a point from a segment, in the plane. */
export function distanceTo(/** @type {number[]} */ p, /** @type {number[]} */ a, /** @type {number[]} */ b) {
  const d = [b[0] - a[0], b[1] - a[1]], length = d[0] ** 2 + d[1] ** 2;
  const t = length > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / length)) : 0;
  return Math.hypot(p[0] - a[0] - t * d[0], p[1] - a[1] - t * d[1]);
}

export class Hand {
  /**
   * @param {import("./scene.js").Scene} scene
   * @param {{ preview(edits: Edit[]): void, commit(edits: Edit[]): void, cancel(): void, chosen(): void, mode(): { axis: string, step: number, mirror: string } }} owner
   */
  constructor(scene, owner) {
    this.scene = scene;
    this.owner = owner;
    /** @type {Place[]} */
    this.places = [];
    /** @type {Edge[]} */
    this.edges = [];
    /** @type {Set<string>} */
    this.taken = new Set();
    this.over = -1;
    /** @type {number[] | null} */
    this.overEdge = null;
    /** @type {Drag | null} */
    this.drag = null;
    const { canvas } = scene;
    canvas.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", () => this.cancel());
  }

  /** Another document, or the same after a change. */
  put(/** @type {Place[]} */ places, /** @type {Edge[]} */ edges) {
    const known = new Set(places.map(({ pointer }) => pointer));
    this.places = places;
    this.edges = edges;
    this.taken = new Set([...this.taken].filter((pointer) => known.has(pointer)));
    this.refresh();
  }

  refresh() {
    const marks = this.places.map(({ pointer, isFree }, k) => this.taken.has(pointer) ? 2 : k === this.over ? 1 : isFree ? -1 : 0);
    this.scene.showHandles(this.places, marks, this.overEdge);
  }

  /** The places that are taken. */
  chosen() {
    return this.places.filter(({ pointer }) => this.taken.has(pointer));
  }

  choose(/** @type {string[]} */ pointers) {
    this.taken = new Set(pointers);
    this.refresh();
    this.owner.chosen();
  }

  pixelOf(/** @type {PointerEvent} */ event) {
    const { left, top } = this.scene.canvas.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  /** The point under a pixel, or the members of the edge there. */
  find(/** @type {number[]} */ pixel, /** @type {number} */ reach) {
    const seen = this.places.map(({ at }) => this.scene.seenAt(at));
    let nearest = reach, point = -1;
    seen.forEach(([x, y], k) => {
      const distance = Math.hypot(x - pixel[0], y - pixel[1]);
      if (distance < nearest) [nearest, point] = [distance, k];
    });
    const edge = point >= 0 ? undefined : this.edges.find(({ members }) =>
      members.some((member, k) => k > 0 && distanceTo(pixel, seen[members[k - 1]], seen[member]) < EDGE_REACH));
    return { point, edge: edge ? edge.members : null };
  }

  down(/** @type {PointerEvent} */ event) {
    if (event.button !== 0 || this.drag !== null || !event.isPrimary) return;
    const start = this.pixelOf(event);
    const { point, edge } = this.find(start, event.pointerType === "touch" ? FINGER_REACH : REACH);
    const found = point >= 0 ? [point] : edge;
    if (found === null) {
      if (!event.shiftKey && this.taken.size > 0) this.start = start;
      return;
    }
    event.stopImmediatePropagation(); // the picture does not turn
    const pointers = found.map((k) => this.places[k].pointer);
    const areTaken = pointers.every((pointer) => this.taken.has(pointer));
    if (event.shiftKey && areTaken) {
      this.choose([...this.taken].filter((pointer) => !pointers.includes(pointer)));
      return;
    }
    if (!areTaken) this.choose(event.shiftKey ? [...this.taken, ...pointers] : pointers);
    this.scene.canvas.focus();
    this.scene.canvas.setPointerCapture(event.pointerId);
    this.drag = { start, base: this.chosen(), all: this.places, edits: [], moved: false };
  }

  move(/** @type {PointerEvent} */ event) {
    const pixel = this.pixelOf(event);
    if (this.drag !== null) {
      this.moveTaken(pixel, event.shiftKey);
    } else if (event.buttons === 0) {
      const { point, edge } = this.find(pixel, REACH);
      if (point === this.over && edge === this.overEdge) return;
      this.over = point;
      this.overEdge = edge;
      this.scene.canvas.style.cursor = point >= 0 || edge !== null ? "grab" : "";
      this.refresh();
    }
  }

  moveTaken(/** @type {number[]} */ pixel, /** @type {boolean} */ isFine) {
    const drag = /** @type {Drag} */ (this.drag);
    const dx = pixel[0] - drag.start[0], dy = drag.start[1] - pixel[1];
    if (!drag.moved && Math.hypot(dx, dy) < STILL) return;
    drag.moved = true;
    const { pixel: size, right, up } = this.scene.axes(), { axis, step, mirror } = this.owner.mode();
    const scale = size * (isFine ? FINE : 1);
    const way = alongAxis(right.map((/** @type {number} */ x, /** @type {number} */ c) => scale * (x * dx + up[c] * dy)), this.axisOf(axis, drag.base[0].at));
    drag.edits = withImages(editsOf(drag.base, way, scale, step), drag.all, mirror);
    this.owner.preview(drag.edits);
  }

  axisOf(/** @type {string} */ axis, /** @type {number[]} */ at) {
    if (axis === "normal") return this.scene.normalNear(at);
    const c = ["x", "y", "z"].indexOf(axis);
    return c < 0 ? null : [0, 1, 2].map((k) => k === c ? 1 : 0);
  }

  up(/** @type {PointerEvent} */ event) {
    const { drag, start } = this, pixel = this.pixelOf(event);
    this.drag = null;
    this.start = undefined;
    if (drag?.moved) this.owner.commit(drag.edits);
    else if (start !== undefined && Math.hypot(pixel[0] - start[0], pixel[1] - start[1]) < STILL) this.choose([]);
  }

  /** Gives up a drag. True if there was one. */
  cancel() {
    const was = this.drag?.moved ?? false;
    this.drag = null;
    if (was) this.owner.cancel();
    return was;
  }
}

/** Places moved by one way. */
export function editsOf(/** @type {Place[]} */ base, /** @type {number[]} */ way, /** @type {number} */ pixel, /** @type {number} */ step) {
  return base.map(({ pointer, at }) => ({ pointer, value: at.map((x, c) => way[c] === 0 ? x : tidy(x + way[c], pixel, step)) }));
}
