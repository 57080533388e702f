// mirror.js -- moves that keep a shape symmetric: what one point does, its image in a plane through the middle does mirrored.
// @ts-check

/** @typedef {import("./places.js").Place} Place */
/** @typedef {import("./pointer.js").Edit} Edit */

const NEAR = 1e-6; // of the size: two points are images of each other

/** The middle of the places along each axis, and their size. */
export function middleOf(/** @type {Place[]} */ places) {
  const low = [0, 1, 2].map((c) => Math.min(...places.map(({ at }) => at[c]))), high = [0, 1, 2].map((c) => Math.max(...places.map(({ at }) => at[c])));
  return { middle: low.map((x, c) => (x + high[c]) / 2), size: Math.hypot(...low.map((x, c) => high[c] - x)) };
}

/**
 * Edits, and those of the images of what they move.
 * @param {Edit[]} edits
 * @param {Place[]} places  as they were before the move
 * @param {string} axes  "", "x", "y" or "xy": across which the shape is symmetric
 * @returns {Edit[]}
 */
export function withImages(edits, places, axes) {
  const { middle, size } = middleOf(places.filter(({ isFree }) => !isFree));
  const was = new Map(places.map(({ pointer, at }) => [pointer, at]));
  const made = new Map(edits.map(({ pointer, value }) => [pointer, /** @type {number[]} */ (value)]));
  for (const letter of axes) {
    const c = "xyz".indexOf(letter);
    const image = (/** @type {number[]} */ at) => at.map((x, k) => k === c ? 2 * middle[c] - x : x);
    for (const [pointer, value] of [...made]) {
      const at = was.get(pointer), sought = at && image(at);
      const partner = sought && places.find((place) => Math.hypot(...place.at.map((x, k) => x - sought[k])) < NEAR * size);
      if (!at || !partner) continue;
      if (partner.pointer === pointer) made.set(pointer, value.map((x, k) => k === c ? at[c] : x)); // it lies in the plane, and stays there
      else made.set(partner.pointer, image(value));
    }
  }
  return [...made].map(([pointer, value]) => ({ pointer, value }));
}
