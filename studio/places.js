// places.js -- the points of a document that a hand can take, and the edges they make.
// @ts-check
import { below } from "./pointer.js";

/** @typedef {{ pointer: string, at: number[], isFree?: boolean }} Place  isFree: null in the document, where the surface has put it */
/** @typedef {{ name: string, members: number[] }} Edge  places by their number, in order */

// Triples that are no places: vectors, and numbers that happen to be three.
const NO_PLACES = new Set(["legs", "cross_derivative", "direction", "knots", "weights", "curvature", "axes", "shape", "u", "v", "t", "range"]);

const isPoint = (/** @type {any} */ value) =>
  Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number" && Number.isFinite(x));

/** All points of a document, in its order. */
export function placesOf(/** @type {any} */ document) {
  /** @type {Place[]} */
  const places = [];
  /** @type {(value: any, pointer: string) => void} */
  const visit = (value, pointer) => {
    if (isPoint(value)) places.push({ pointer, at: value });
    else if (Array.isArray(value)) {
      value.forEach((item, i) => visit(item, below(pointer, i)));
    } else if (value !== null && typeof value === "object") {
      for (const [name, item] of Object.entries(value)) {
        if (!NO_PLACES.has(name)) visit(item, below(pointer, name));
      }
    }
  };
  visit(document, "");
  return places;
}

// Of these any pattern of points may be known.
const ANY_MASK = new Set(["dirichlet", "plateau"]);

/** The points of the net that the document leaves free, where the surface has them now: moved, they are held. */
export function freePlacesOf(/** @type {any} */ document, /** @type {{ nu: number, nv: number, points: ArrayLike<number> } | undefined} */ net) {
  const rows = document?.points;
  if (!ANY_MASK.has(document?.construct) || net === undefined || !Array.isArray(rows) || rows.length !== net.nu) return [];
  /** @type {Place[]} */
  const places = [];
  rows.forEach((row, i) => {
    if (!Array.isArray(row) || row.length !== net.nv) return;
    row.forEach((point, j) => {
      const k = 3 * (i * net.nv + j);
      if (point === null) places.push({ pointer: below(below("/points", i), j), at: [net.points[k], net.points[k + 1], net.points[k + 2]], isFree: true });
    });
  });
  return places;
}

/** The borders of every net of points, by the members that stand in a document: u0, u1, v0, v1. */
export function edgesOf(/** @type {any} */ document, /** @type {Place[]} */ places) {
  const number = new Map(places.map(({ pointer }, k) => [pointer, k]));
  /** @type {Edge[]} */
  const edges = [];
  for (const [net, rows] of netsOf(document)) {
    const last = rows.length - 1, lastOf = rows[0].length - 1;
    /** @type {[string, number[][]][]} */
    const borders = [
      ["u0", rows[0].map((_, j) => [0, j])], ["u1", rows[0].map((_, j) => [last, j])],
      ["v0", rows.map((_, i) => [i, 0])], ["v1", rows.map((_, i) => [i, lastOf])],
    ];
    for (const [name, path] of borders) {
      const members = path.map(([i, j]) => number.get(below(below(net, i), j)));
      if (members.every((member) => member !== undefined)) edges.push({ name, members: /** @type {number[]} */ (members) });
    }
  }
  return edges;
}

/** @returns {[string, unknown[][]][]} lists of rows of equal length, with their pointers */
function netsOf(/** @type {any} */ document) {
  const found = /** @type {[string, unknown[][]][]} */ ([]);
  for (const [pointer, holder] of [["", document], ["/surface", document.surface], ["/neighbour", document.neighbour]]) {
    const points = holder?.points;
    if (Array.isArray(points) && points.length > 1 && points.every((row) => Array.isArray(row) && row.length === points[0].length && row.length > 1 && !isNumbers(row))) {
      found.push([below(pointer, "points"), points]);
    }
  }
  return found;
}

const isNumbers = (/** @type {any[]} */ row) => row.some((x) => typeof x === "number");
