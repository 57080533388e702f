// through_3dm.mjs -- a surface through McNeel's own 3dm writer and reader (npm's rhino3dm): JSON on standard input and output.
import fs from "node:fs";
import { createRequire } from "node:module";
const load = createRequire(process.cwd() + "/")("rhino3dm");
const rhino = await load();
const given = JSON.parse(fs.readFileSync(0, "utf8"));
const [nu, nv] = [given.places.length, given.places[0].length];
const surface = rhino.NurbsSurface.create(3, given.rational, given.orders[0], given.orders[1], nu, nv);
given.knots.forEach((knots, side) => knots.forEach((knot, i) => (side ? surface.knotsV() : surface.knotsU()).set(i, knot)));
given.places.forEach((row, i) => row.forEach((p, j) => {
  const w = given.weights[i][j];
  surface.points().set(i, j, [p[0] * w, p[1] * w, p[2] * w, w]);
}));
const file = new rhino.File3dm();
file.objects().add(surface, null);
const again = rhino.File3dm.fromByteArray(file.toByteArray()).objects().get(0).geometry();
const result = { valid: surface.isValid, places: [], weights: [], knots: [[], []], degrees: [again.degree(0), again.degree(1)] };
for (let i = 0; i < nu; i++) {
  const row = [], weights = [];
  for (let j = 0; j < nv; j++) {
    const p = again.points().get(i, j);
    row.push([p[0] / p[3], p[1] / p[3], p[2] / p[3]]);
    weights.push(p[3]);
  }
  result.places.push(row);
  result.weights.push(weights);
}
for (const [side, list] of [again.knotsU(), again.knotsV()].entries()) {
  for (let i = 0; i < list.count; i++) result.knots[side].push(list.get(i));
}
console.log(JSON.stringify(result));
process.exit(0);
