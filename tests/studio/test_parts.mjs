// test_parts.mjs -- the parts of the studio that need no browser: pointers, steps of undo, places, edges, numbers, questions to a worker, fields.
//
//     node --test tests/studio/
//
// @ts-check
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { Channel } from "../../studio/channel.js";
import { bendAt, combsOf } from "../../studio/combs.js";
import { arrowsOf, forcesOf } from "../../studio/forces.js";
import { alongAxis, distanceTo, editsOf, tidy } from "../../studio/hand.js";
import { middleOf, withImages } from "../../studio/mirror.js";
import { History } from "../../studio/history.js";
import { readable } from "../../studio/number.js";
import { kindOf, membersOf, resolve, schemaOf } from "../../studio/panel.js";
import { edgesOf, freePlacesOf, placesOf } from "../../studio/places.js";
import { below, valueAt, withEdits, withValue } from "../../studio/pointer.js";
import { placeOnBar, wantsMore, wordOf } from "../../studio/proof.js";
import { remedyOf } from "../../studio/remedy.js";
import { documentOf, fragmentOf } from "../../studio/share.js";

const root = path.join(path.dirname(fileURLToPath(import.meta.url)), "../..");
const examples = fs.readdirSync(path.join(root, "examples")).filter((name) => name.endsWith(".json"))
  .map((name) => JSON.parse(fs.readFileSync(path.join(root, "examples", name), "utf8")));
const schema = JSON.parse(fs.readFileSync(path.join(root, "docs/schema/problem.json"), "utf8"));

test("pointers read and write, and leave the document as it was", () => {
  const document = { a: [1, { "b/c": 2, "d~e": 3 }], __proto__x: 4 };
  assert.equal(valueAt(document, "/a/1/b~1c"), 2);
  assert.equal(valueAt(document, "/a/1/d~0e"), 3);
  assert.deepEqual(withValue(document, "/a/0", 9), { ...document, a: [9, document.a[1]] });
  assert.deepEqual(withValue(document, "/a/2", 7).a.length, 3);
  assert.deepEqual(withValue(document, "/a/1/b~1c", undefined).a[1], { "d~e": 3 });
  assert.equal(document.a[0], 1);
  for (const wrong of ["a", "/x/y", "/a/9", "/a/01", "/a/-"]) {
    assert.throws(() => withValue(document, wrong, 1), (/** @type {any} */ error) => error.reason === "missing" && error.where === wrong);
  }
  assert.equal(below("/a", "b/c~"), "/a/b~1c~0");
  assert.equal(Object.getPrototypeOf(withValue({}, "/__proto__", { polluted: 1 })).polluted, undefined);
});

test("any edits of examples come back by undo", () => {
  for (const document of examples) {
    const history = new History(document), places = placesOf(document);
    const edits = places.slice(0, 5).map(({ pointer, at }) => ({ pointer, value: at.map((x) => x + 1) }));
    history.push(withEdits(document, edits));
    for (const { pointer, value } of edits) assert.deepEqual(valueAt(history.value, pointer), value);
    assert.ok(history.undo() && !history.undo());
    assert.equal(history.value, document);
    assert.ok(history.redo() && !history.redo());
  }
});

test("places are points that stand in the document, edges are made of them", () => {
  for (const document of examples) {
    const places = placesOf(document);
    for (const { pointer, at } of places) assert.deepEqual(valueAt(document, pointer), at);
    for (const { members } of edgesOf(document, places)) members.forEach((member) => assert.ok(member >= 0 && member < places.length));
  }
  const points = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], null]];
  assert.deepEqual(edgesOf({ points }, placesOf({ points })).map(({ name }) => name), ["u0", "v0"]);
  assert.equal(placesOf({ points }).length, 3);
});

test("points that a document leaves free stand where the surface has them", () => {
  const points = [[[0, 0, 0], null], [[1, 0, 0], [1, 1, 0]]], net = { nu: 2, nv: 2, points: [0, 0, 0, 0.25, 0.5, 0.75, 1, 0, 0, 1, 1, 0] };
  assert.deepEqual(freePlacesOf({ construct: "dirichlet", points }, net), [{ pointer: "/points/0/1", at: [0.25, 0.5, 0.75], isFree: true }]);
  assert.deepEqual(freePlacesOf({ construct: "harmonic", points }, net), []);
  assert.deepEqual(freePlacesOf({ construct: "dirichlet", points }, { ...net, nu: 3 }), []);
  assert.deepEqual(freePlacesOf({ construct: "dirichlet", points }, undefined), []);
});

test("images do what points do, mirrored", () => {
  const places = [[0, 0, 0], [2, 0, 0], [1, 1, 0], [0, 2, 1], [2, 2, 1]].map((at, k) => ({ pointer: `/p/${k}`, at }));
  assert.deepEqual(middleOf(places).middle, [1, 1, 0.5]);
  assert.deepEqual(withImages([{ pointer: "/p/0", value: [0.25, 0, 3] }], places, ""), [{ pointer: "/p/0", value: [0.25, 0, 3] }]);
  assert.deepEqual(withImages([{ pointer: "/p/0", value: [0.25, 0, 3] }], places, "x"),
    [{ pointer: "/p/0", value: [0.25, 0, 3] }, { pointer: "/p/1", value: [1.75, 0, 3] }]);
  /* of p0 and p1 only, as no point is the image of p0 across y: the heights differ */
  assert.deepEqual(withImages([{ pointer: "/p/2", value: [1.5, 1, 2] }], places, "xy"), [{ pointer: "/p/2", value: [1, 1, 2] }]);
});

test("a hand moves along its axis, on its grid, to no more digits than it sees", () => {
  assert.deepEqual(alongAxis([1, 2, 3], [0, 1, 0]), [0, 2, 0]);
  assert.deepEqual(alongAxis([1, 2, 3], null), [1, 2, 3]);
  assert.equal(tidy(1.23456789, 0.01, 0), 1.235);
  assert.equal(tidy(1.23456789, 0.01, 0.25), 1.25);
  assert.ok(Object.is(tidy(-1e-9, 0.01, 0), 0));
  assert.equal(distanceTo([0, 1], [-1, 0], [1, 0]), 1);
  assert.equal(distanceTo([3, 0], [-1, 0], [1, 0]), 2);
  assert.deepEqual(editsOf([{ pointer: "/p", at: [0.1, 0.2, 0.3] }], [1, 0, 0], 0.01, 0), [{ pointer: "/p", value: [1.1, 0.2, 0.3] }]);
});

test("of questions that a newer one may replace only the newest waits, and failures are errors", async () => {
  /** @type {any[]} */
  const asked = [];
  const worker = { onmessage: /** @type {any} */ (null), postMessage: (/** @type {any} */ message) => asked.push(message), terminate() {} };
  const channel = new Channel(() => worker);
  const first = channel.newest(1), second = channel.newest(2), third = channel.newest(3), kept = channel.ask(4);
  const fifth = channel.newest(5);
  assert.deepEqual(asked, [1]);
  for (let k = 0; k < 3; k++) worker.onmessage({ data: { told: asked.at(-1) } });
  assert.deepEqual(await Promise.all([first, second, third, kept, fifth]), [{ told: 1 }, null, null, { told: 4 }, { told: 5 }]);
  const wrong = channel.ask(6);
  worker.onmessage({ data: { error: { message: "no", reason: "value", where: "/a" } } });
  await assert.rejects(wrong, (/** @type {any} */ error) => error.reason === "value" && error.where === "/a" && error.message === "no");
});

test("numbers stay in one piece", () => {
  assert.deepEqual([0, 1.5, 19.0070659123, 1.965e-14, 1e-17, 12345678.9, null, NaN].map((x) => readable(x)),
    ["0", "1.5", "19.0071", "1.97e-14", "1e-17", "1.23e7", "-", "-"]);
  assert.equal(placeOnBar(1), 100);
  assert.equal(placeOnBar(0), 0);
  assert.ok(placeOnBar(1e-12) < placeOnBar(1e-6));
});

test("only bounds and exact claims are proved", () => {
  const claim = (/** @type {string} */ kind, /** @type {boolean | null} */ holds) => ({ claim: "c", kind, residual: 0, limit: 1, holds });
  const whole = (/** @type {boolean | null} */ holds, /** @type {any[]} */ claims) => ({ holds, claims });
  assert.equal(wordOf(whole(true, [claim("bound", true), claim("exact", true)]), false), "proved");
  assert.equal(wordOf(whole(true, [claim("bound", true), claim("check", true)]), false), "holds");
  assert.equal(wordOf(whole(false, [claim("bound", false)]), false), "fails");
  assert.equal(wordOf(whole(null, [claim("bound", null)]), false), "undecided");
  assert.equal(wordOf(whole(true, []), true), "draft");
});

test("claims that hold above their limit say so", () => {
  const claim = { claim: "stable", kind: "check" };
  assert.ok(wantsMore({ ...claim, holds: true, residual: 5, limit: 1e-6 }) && wantsMore({ ...claim, holds: false, residual: 1e-9, limit: 1e-6 }));
  assert.ok(!wantsMore({ ...claim, holds: true, residual: 0.1, limit: 1 }) && !wantsMore({ ...claim, holds: null, residual: 2, limit: 1 }));
  assert.ok(!wantsMore({ ...claim, holds: true, residual: null, limit: 1 }));
});

test("every construction of the examples has fields", () => {
  for (const document of examples.filter((one) => !Array.isArray(one))) {
    const own = schemaOf(schema, document);
    assert.ok(Object.keys(own.properties).length > 0, document.construct);
  }
  assert.equal(kindOf([resolve(schema, { type: "number" })], undefined), "number");
  assert.equal(kindOf([{ enum: ["a"] }], "a"), "choice");
  assert.equal(kindOf([{}], [1]), null);
  const basis = membersOf(schema, { $ref: "#/$defs/basis" }, { type: "bspline", degree: 3, count: 8 });
  assert.deepEqual(Object.keys(basis).sort(), ["count", "degree", "type"]);
  assert.ok(basis.type.enum.includes("bezier") && basis.type.enum.includes("c-bspline"));
});

test("a document travels in an address", async () => {
  for (const document of examples.slice(0, 20)) {
    const text = JSON.stringify(document), fragment = await fragmentOf(text);
    assert.match(fragment, /^#p=[A-Za-z0-9_-]+$/);
    assert.equal(await documentOf(fragment), text);
  }
  assert.equal(await documentOf("#p=***"), null);
  assert.equal(await documentOf("#else"), null);
});

test("a reason has a remedy", () => {
  const headers = fs.readdirSync(path.join(root, "include/taut")).map((name) => path.join(root, "include/taut", name));
  const remedies = JSON.parse(execFileSync("awk", ["-f", path.join(root, "studio/reasons.awk"), ...headers], { encoding: "utf8" }));
  assert.match(remedyOf(remedies, "film", "cable-too-weak"), /force/);
  assert.match(remedyOf(remedies, "harmonic-extension", "fault"), /report/);
  assert.match(remedyOf(remedies, undefined, "syntax"), /line and column/);
  assert.equal(remedyOf(remedies, "film", "no-such-word"), "");
  for (const [list, words] of Object.entries(remedies)) {
    for (const [word, remedy] of Object.entries(words)) assert.ok(/^[a-z0-9-]+$/.test(word) && remedy.length > 3, `${list} ${word}: ${remedy}`);
  }
});

test("forces on supports are arrows to their corners", () => {
  const points = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]];
  const model = { surfaces: [{ name: "a", points: [[[9, 9, 9]]] }, { name: "b", points }], details: { supports: ["b.u1v0", "b.u0v1", "c.u0v0", "b.u0v0"] },
    certificate: { figures: { reactions: [[0, 0, -2], [1, 0, 0], [1, 1, 1], [0, 0, 0]] } } };
  const forces = forcesOf(model);
  assert.deepEqual(forces, [{ corner: [1, 0, 0], force: [0, 0, -2] }, { corner: [0, 1, 0], force: [1, 0, 0] }]);
  const pairs = arrowsOf(forces, forces.map(({ corner }) => corner), 0.5);
  assert.equal(pairs.length, 2 * 5 * 6);
  assert.deepEqual(pairs.slice(0, 6), [1, 0, 0.5, 1, 0, 0]); // the longest, from outside
  assert.deepEqual(pairs.slice(30, 36), [-0.25, 1, 0, 0, 1, 0]);
  for (let k = 6; k < 30; k += 6) { // barbs, from the head back and aside
    assert.deepEqual(pairs.slice(k, k + 3), [1, 0, 0]);
    assert.ok(Math.abs(pairs[k + 5] - 0.11) < 1e-15 && Math.abs(Math.hypot(pairs[k + 3] - 1, pairs[k + 4]) - 0.035) < 1e-15);
  }
  assert.deepEqual(forcesOf({ surfaces: [{ points }] }), []);
});

test("combs are as long as a curve bends", () => {
  const radius = 2.5, angle = 0.1; // of a circle, whose middle is where the bend points
  const points = Float32Array.from({ length: 63 }, (_, k) => [radius * Math.cos(angle * Math.floor(k / 3)), 0, radius * Math.sin(angle * Math.floor(k / 3))][k % 3]);
  const bend = bendAt(points.subarray(0, 3), points.subarray(3, 6), points.subarray(6, 9));
  assert.ok(Math.abs(Math.hypot(...bend) - 1 / radius) < 1e-5);
  assert.ok(Math.abs(bend[0] + Math.cos(angle) / radius) < 1e-4 && bend[1] === 0);
  const path = Array.from({ length: 21 }, (_, k) => k), pairs = combsOf([{ path, points }], 0.5);
  assert.equal(pairs.length, 6 * (19 + 18)); // teeth, and the crest between them
  assert.ok(Math.abs(Math.hypot(pairs[3], pairs[5]) - radius - 0.5) < 1e-3); // away from the middle
  assert.deepEqual(combsOf([{ path, points: points.map((_, k) => Math.floor(k / 3)) }], 1), []); // a straight line has none
  assert.deepEqual(bendAt([0, 0, 0], [0, 0, 0], [1, 0, 0]), [0, 0, 0]);
});
