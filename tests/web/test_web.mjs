// test_web.mjs -- the WebAssembly module against the program: every example, made and certified by both.
//
//     TAUT=build/release/bin/taut TAUT_WASM=build/wasm/bin/taut.wasm node --test tests/web/
//
// @ts-check
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import zlib from "node:zlib";
import { load } from "../../web/taut.mjs";

const root = path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), "../..");
const program = process.env.TAUT ?? path.join(root, "build/release/bin/taut");
const bytes = fs.readFileSync(process.env.TAUT_WASM ?? path.join(root, "build/wasm/bin/taut.wasm"));
const taut = await load(bytes);
const examples = fs.readdirSync(path.join(root, "examples")).filter((name) => name.endsWith(".json")).sort();
const read = (/** @type {string} */ name) => fs.readFileSync(path.join(root, "examples", name), "utf8");
const native = (/** @type {string} */ text) =>
  spawnSync(program, ["make", "-", "--quiet"], { input: text, encoding: "utf8", maxBuffer: 1 << 28 });

/** Largest difference of two models' points, over the size of the first. */
function distance(/** @type {any} */ a, /** @type {any} */ b) {
  let apart = 0, size = 0;
  a.surfaces.forEach((/** @type {any} */ surface, /** @type {number} */ s) => {
    const one = surface.points.flat(Infinity), other = b.surfaces[s].points.flat(Infinity);
    assert.equal(one.length, other.length);
    one.forEach((/** @type {number} */ x, /** @type {number} */ k) => {
      apart = Math.max(apart, Math.abs(x - other[k]));
      size = Math.max(size, Math.abs(x));
    });
  });
  return apart / size;
}

test("the module is small", () => {
  assert.ok(bytes.length <= 1.25e6, `${bytes.length} bytes`);
  assert.ok(zlib.brotliCompressSync(bytes).length <= 420e3, `${zlib.brotliCompressSync(bytes).length} bytes by brotli`);
});

for (const name of examples) {
  test(name, () => {
    const text = read(name), document = JSON.parse(text);
    if (document.construct === "pattern" || (document.construct === "film" && (document.patches || document.cells))) { // nor are these read
      assert.throws(() => taut.open(text), (/** @type {any} */ error) => error.reason === "not-installed");
      return;
    }
    const theirs = native(text);
    const surface = taut.open(text);
    if (document.construct === "trace") { // not in this module
      assert.throws(() => surface.make(), (/** @type {any} */ error) => error.reason === "not-installed");
      surface.close();
      return;
    }
    surface.make();
    const holds = surface.certify();
    const written = surface.write("json");
    const ours = JSON.parse(written), model = JSON.parse(theirs.stdout);
    assert.equal(holds, model.certificate.holds);
    assert.deepEqual(
      ours.certificate.claims.map((/** @type {any} */ c) => [c.claim, c.kind, c.holds]),
      model.certificate.claims.map((/** @type {any} */ c) => [c.claim, c.kind, c.holds]),
    );
    assert.ok(written === theirs.stdout, `points differ by ${distance(model, ours)} of the size`);
    // a model is opened as well, and certified without its problem
    const again = taut.open(written);
    assert.equal(again.count, ours.surfaces.length);
    again.close();
    surface.close();
  });
}

test("a point that is set moves the surface as the program would", () => {
  const surface = taut.open(read("dirichlet-tent.json"));
  surface.make();
  const document = surface.problem();
  const before = surface.write("json");
  const [i, j] = [document.points.length - 1, document.points[0].length - 1];
  document.points[i][j] = [3, 4, 5.25];
  surface.set(`/points/${i}/${j}`, document.points[i][j]);
  assert.deepEqual(surface.problem(), document);
  surface.make();
  surface.certify();
  assert.ok(surface.write("json") === native(JSON.stringify(document)).stdout);
  surface.set("/name", "moved"); // a member that was not there, or was
  assert.equal(surface.problem().name, "moved");
  // what is refused says where, and leaves all as it was
  for (const [pointer, value] of [["/points/0/99", null], ["/u", 7], ["/nothing", 1], ["points", 1]]) {
    assert.throws(() => surface.set(/** @type {string} */ (pointer), value), (error) => "where" in /** @type {any} */ (error));
  }
  surface.set("/name", document.name ?? "dirichlet");
  surface.make();
  surface.certify();
  assert.notEqual(surface.write("json"), before);
  surface.close();
  const model = taut.open(before);
  assert.equal(model.problem(), null);
  assert.throws(() => model.set("/name", "x"));
  model.close();
});

test("a draft leads to the film that is made", () => {
  const document = { ...JSON.parse(read("film-sail.json")), least: false };
  const before = taut.open(JSON.stringify(document));
  before.make();
  document.corners.u0v0 = [-1.1, -0.9, 0.65];
  const film = taut.open(JSON.stringify(document)), draft = taut.open(JSON.stringify(document));
  film.make();
  assert.equal(draft.draft(before), true);
  assert.equal(draft.draft(draft, 40), true);
  const points = film.points(0).points.slice(), drafted = draft.points(0).points;
  assert.deepEqual([...drafted.subarray(0, 3)], document.corners.u0v0);
  assert.ok(points.every((/** @type {number} */ x, /** @type {number} */ k) => Math.abs(x - drafted[k]) < 0.05)); // they slide within it
  assert.equal(draft.curveCount, 4);
  const other = taut.open(read("dirichlet-tent.json"));
  assert.equal(other.draft(before), false);
  for (const surface of [before, film, draft, other]) surface.close();
});

test("how far parameters are from isothermal comes with curvatures", () => {
  const surface = taut.open(read("plateau-scherk.json"));
  surface.make();
  const { isothermality } = surface.curvatures(0, 9, 9);
  assert.ok(isothermality.every((/** @type {number} */ x) => x >= 0 && x <= 1));
  assert.equal(surface.gaps(0, 9, 9), null); // the studio's module alone has them
  surface.close();
});

test("a grid lies on the surface", () => {
  const surface = taut.open(read("dirichlet-tent.json"));
  surface.make();
  const { positions, normals } = surface.grid(0, 9, 5);
  const { nu, nv, points } = surface.points(0);
  assert.equal(positions.length, 135);
  for (let c = 0; c < 3; c++) { // the corners of the net are on it
    assert.equal(positions[c], Math.fround(points[c]));
    assert.equal(positions[132 + c], Math.fround(points[3 * (nu * nv - 1) + c]));
  }
  for (let k = 0; k < normals.length; k += 3) {
    assert.ok(Math.abs(Math.hypot(normals[k], normals[k + 1], normals[k + 2]) - 1) < 1e-6);
  }
  assert.throws(() => surface.grid(0, 1, 5));
  assert.throws(() => surface.grid(7, 5, 5));
  surface.close();
});

test("formats", () => {
  const surface = taut.open(read("dirichlet-tent.json"));
  surface.make();
  assert.match(surface.write("svg"), /^<\?xml[\s\S]*<svg/);
  assert.match(surface.write("obj"), /^#|\nv /);
  assert.match(surface.write("step"), /^ISO-10303-21;[\s\S]*END-ISO-10303-21;\s*$/);
  assert.throws(() => surface.write("iges"), /not written in the browser/);
  assert.throws(() => surface.write("png"), /not installed/);
  assert.throws(() => surface.write("nonsense"), /ending/);
  surface.close();
});

test("what is wrong is told as the program tells it", () => {
  assert.throws(() => taut.open("{"), /./);
  assert.throws(() => taut.open('{"taut": 1, "construct": "dirichlt"}'), (/** @type {any} */ error) => error.where === "/construct");
  for (let k = 0; k < 1000; k++) { // nothing is kept
    assert.throws(() => taut.open("[1,"));
  }
  assert.ok(taut.raw.memory.buffer.byteLength < 1 << 28);
});
