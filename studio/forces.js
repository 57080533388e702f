// forces.js -- the forces of cables on the corners that a film is held at, by the figures of its certificate: arrows with their heads at
// the corners.
// @ts-check

const HEAD = [0.22, 0.07]; // of an arrow: how long its head is, and how wide to either side

/** @typedef {{ corner: number[], force: number[] }} Force */

/**
 * Of a model with its certificate.
 * @param {any} model
 * @returns {Force[]}
 */
export function forcesOf(model) {
  const forces = model.certificate?.figures?.reactions ?? [], supports = model.details?.supports ?? [];
  return forces.flatMap((/** @type {number[]} */ force, /** @type {number} */ k) => {
    const found = /^(?:(.*)\.)?u([01])v([01])$/.exec(supports[k] ?? "");
    const surface = found === null ? undefined : model.surfaces.find((/** @type {any} */ s) => found[1] === undefined || s.name === found[1]);
    if (found === null || surface === undefined || !(Math.hypot(...force) > 0)) return [];
    const row = surface.points[found[2] === "0" ? 0 : surface.points.length - 1];
    return [{ corner: row[found[3] === "0" ? 0 : row.length - 1], force }];
  });
}

/**
 * Ends of the lines of arrows, the longest so long: corners as they are seen, in the same space as the length.
 * @param {Force[]} forces
 * @param {number[][]} corners
 * @param {number} length
 * @returns {number[]}
 */
export function arrowsOf(forces, corners, length) {
  const most = Math.max(...forces.map(({ force }) => Math.hypot(...force)));
  return forces.flatMap(({ force }, k) => {
    const size = length * Math.hypot(...force) / most, way = force.map((x) => x / Math.hypot(...force));
    const least = way.reduce((best, x, c) => Math.abs(x) < Math.abs(way[best]) ? c : best, 0);
    const axis = [0, 1, 2].map((c) => c === least ? 1 : 0), first = unit(cross(way, axis)), second = cross(way, first);
    const behind = (/** @type {number} */ along, /** @type {number[]} */ side, /** @type {number} */ aside) =>
      corners[k].map((x, c) => x - size * (along * way[c] - aside * side[c]));
    const barbs = [[first, 1], [first, -1], [second, 1], [second, -1]].flatMap(([side, sign]) =>
      [...corners[k], ...behind(HEAD[0], /** @type {number[]} */ (side), /** @type {number} */ (sign) * HEAD[1])]);
    return [...behind(1, first, 0), ...corners[k], ...barbs];
  });
}

const cross = (/** @type {number[]} */ a, /** @type {number[]} */ b) => [0, 1, 2].map((c) => a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3]);
const unit = (/** @type {number[]} */ a) => a.map((x) => x / Math.hypot(...a));
