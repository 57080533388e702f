// combs.js -- curvature combs: on lines of a surface and on curves a tooth wherever they are drawn, as long as the curve bends there.
// @ts-check

/** The curvature vector at b of the circle through three points of space: it points to the middle. */
export function bendAt(/** @type {ArrayLike<number>} */ a, /** @type {ArrayLike<number>} */ b, /** @type {ArrayLike<number>} */ c) {
  const p = [0, 1, 2].map((k) => a[k] - b[k]), q = [0, 1, 2].map((k) => c[k] - b[k]);
  const dot = (/** @type {number[]} */ x, /** @type {number[]} */ y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  const pp = dot(p, p), qq = dot(q, q), pq = dot(p, q), way = pp + qq - 2 * pq;
  if (!(pp > 0 && qq > 0 && way > 0)) return [0, 0, 0];
  return [0, 1, 2].map((k) => 2 / way * ((1 - pq / pp) * p[k] + (1 - pq / qq) * q[k]));
}

/**
 * The bends at the inner points of a path through numbered points.
 * @param {number[]} path
 * @param {Float32Array} points
 */
export function bendsOf(path, points) {
  const at = (/** @type {number} */ k) => points.subarray(3 * path[k], 3 * path[k] + 3);
  return path.map((_, k) => bendAt(at(Math.max(k - 1, 0)), at(k), at(Math.min(k + 1, path.length - 1))));
}

/**
 * The teeth of several paths and the crests over them, as pairs of points, away from where the curve bends to; the longest but
 * for 2 of 100 is `length` long.
 * @param {{ path: number[], points: Float32Array }[]} paths
 * @param {number} length
 * @returns {number[]}
 */
export function combsOf(paths, length) {
  const all = paths.map(({ path, points }) => bendsOf(path, points));
  const sizes = all.flat().map((bend) => Math.hypot(...bend)).sort((a, b) => a - b);
  const most = sizes[Math.floor(0.98 * (sizes.length - 1))] ?? 0;
  if (!(most > 0)) return [];
  const pairs = /** @type {number[]} */ ([]);
  all.forEach((bends, p) => {
    const { path, points } = paths[p];
    /** @type {number[] | null} */
    let crest = null;
    for (let k = 1; k + 1 < path.length; k++) {
      const foot = [...points.subarray(3 * path[k], 3 * path[k] + 3)], bend = bends[k], share = Math.min(1.5, Math.hypot(...bend) / most);
      const unit = Math.hypot(...bend) || 1, tip = foot.map((x, c) => x - length * share * bend[c] / unit);
      pairs.push(...foot, ...tip);
      if (crest !== null) pairs.push(...crest, ...tip);
      crest = tip;
    }
  });
  return pairs;
}
