// web.mjs -- how long the WebAssembly module takes, over what the same calls take on this machine's own processor, in one run.
//
//     node --no-liftoff bench/web/web.mjs build/bench/bin/bench-web-native build/wasm/bin/taut.wasm
//
// Of each document: made on bases that are not those of the problem before, with 65 x 65 positions and normals; as a hand drags it:
// a point set, made, the same positions and normals; proved. Both take turns, ROUNDS times, and the least processor time of each
// counts. --no-liftoff: the module is compiled from the first call on as what runs often is; else node does that beside the calls, on a
// busy machine late.
// @ts-check
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { load } from "../../web/taut.mjs";

const [program, module] = process.argv.slice(2);
const ROUNDS = 7, GRID = 65;
const root = path.join(path.dirname(new URL(import.meta.url).pathname), "../..");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "taut-bench-web-"));
const taut = await load(fs.readFileSync(module));
const read = (/** @type {string} */ name) => JSON.parse(fs.readFileSync(path.join(root, "examples", name), "utf8"));

/** A place of row i, column j of n. */
const place = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ n) => {
  const u = i / (n - 1), v = j / (n - 1);
  return [u, v, 0.3 * Math.sin(3 * u + 2 * v) + 0.1 * Math.cos(5 * v)];
};

/** A net of n x n points, of which those that `known` says are given. */
function net(/** @type {string} */ construct, /** @type {number} */ n, /** @type {object} */ u, /** @type {object} */ v,
  /** @type {(i: number, j: number) => boolean} */ known) {
  const points = Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => (known(i, j) ? place(i, j, n) : null)));
  return { taut: 1, construct, u, v, points };
}
const frame = (/** @type {number} */ n) => (/** @type {number} */ i, /** @type {number} */ j) => i % (n - 1) === 0 || j % (n - 1) === 0;
const dirichlet = (/** @type {number} */ n) => {
  const basis = { type: "bspline", degree: 3, count: n };
  return net("dirichlet", n, basis, basis, frame(n));
};
const plateau = (/** @type {number} */ n) => ({ ...dirichlet(n), construct: "plateau" });
const rows = (/** @type {number} */ n, /** @type {number} */ length) => {
  const basis = { type: "bezier", degree: n - 1 };
  return net("harmonic", n, basis, { ...basis, range: [0, length] }, (i) => i % (n - 1) === 0);
};
const fourRows = (/** @type {number} */ n) => {
  const basis = { type: "bezier", degree: n - 1 };
  return net("biharmonic", n, basis, basis, frame(n));
};

/** @type {[string, object, object, string, unknown[], number][]} what it is, the document, one on other bases, a place in it, values to be set there, how often */
const cases = [
  ["`dirichlet`, 30 x 30", dirichlet(30), dirichlet(29), "/points/0/3", [0, 0.1, 0.2], 60],
  ["`harmonic`, rows of 10 x 10", rows(10, 1), rows(8, 1), "/points/0/3", [0, 0.33, 0.2], 60],
  ["`harmonic`, rows of 30 x 30, 1 by 12", rows(30, 12), rows(28, 12), "/points/0/3", [0, 0.1, 0.2], 20],
  ["`biharmonic`, four rows of 5 x 5", fourRows(5), fourRows(6), "/points/0/1", [0, 0.25, 0.2], 60],
  ["`biharmonic`, four rows of 10 x 10", fourRows(10), fourRows(9), "/points/0/3", [0, 0.33, 0.2], 20],
  ["`bonnet`, six frames", read("bonnet-enneper.json"), read("bonnet-figure-4.json"), "/alpha", [2.4], 60],
];

/** The same of what is found by iterations, whose loops are longer and whose vectors are wider on the processor. */
const iterated = cases.length;
cases.push(
  ["`plateau` by `\"normal\"`, 20 x 20", { ...plateau(20), method: "normal" }, plateau(12), "/points/0/3", [0, 0.16, 0.2], 10],
  ["`plateau-scherk`, 12 x 12 by `\"full\"`", read("plateau-scherk.json"), plateau(9), "/points/0/0", [-1, -1, 0.01], 10],
  ["`film-sail`", read("film-sail.json"), read("film-ring.json"), "/edges/u0/cable/force", [2.1], 10],
  ["`asymptotic-4`", read("asymptotic-4.json"), read("asymptotic-1.json"), "/edges/v0/legs/0", [0, 0.2, 0.105], 10],
  ["`pipe-g2`", read("pipe-g2.json"), read("pipe-elbow.json"), "/radius", [9.5], 10],
  ["`pipe-run-harness`", read("pipe-run-harness.json"), read("pipe-run-coil.json"), "/bend_radius", [19.5], 5],
);

/** Milliseconds of the processor that this process has had. */
const clock = () => {
  const used = process.cpuUsage();
  return (used.user + used.system) / 1000;
};

/** [made, dragged, proved] of the module, the least of so many times each. */
function inModule(/** @type {object} */ document, /** @type {object} */ other, /** @type {string} */ pointer, /** @type {unknown} */ value,
  /** @type {number} */ times) {
  const surface = taut.open(JSON.stringify(document)), before = taut.open(JSON.stringify(other));
  const least = [Infinity, Infinity, Infinity];
  const time = (/** @type {number} */ which, /** @type {() => void} */ work) => {
    const begin = clock();
    work();
    least[which] = Math.min(least[which], clock() - begin);
  };
  for (let k = 0; k < times; k++) {
    before.make();
    time(0, () => {
      surface.make();
      surface.grid(0, GRID, GRID);
    });
  }
  for (let k = 0; k < times; k++) {
    time(1, () => {
      surface.set(pointer, value);
      surface.make();
      surface.grid(0, GRID, GRID);
    });
  }
  for (let k = 0; k < times / 10; k++) time(2, () => void surface.certify());
  surface.close();
  before.close();
  return least;
}

function onProcessor(/** @type {string[]} */ words) {
  const run = spawnSync(program, words, { encoding: "utf8" });
  if (run.status !== 0) throw new Error(run.stderr);
  return run.stdout.trim().split(" ").map(Number);
}

const most = [0, 0];
console.log("| document | made, native; module | over | dragged, native; module | over | proved, native; module | over |");
console.log("|---|---|---|---|---|---|---|");
for (const [row, [name, document, other, pointer, value, times]] of cases.entries()) {
  const files = [document, other].map((one, k) => path.join(folder, `${k}.json`));
  fs.writeFileSync(files[0], JSON.stringify(document));
  fs.writeFileSync(files[1], JSON.stringify(other));
  const set = value.length === 1 ? value[0] : value;
  let native = [Infinity, Infinity, Infinity], own = [...native];
  for (let round = 0; round < ROUNDS; round++) {
    native = onProcessor([...files, pointer, JSON.stringify(set), String(times)]).map((ms, k) => Math.min(ms, native[k]));
    own = inModule(document, other, pointer, set, times).map((ms, k) => Math.min(ms, own[k]));
  }
  const cells = native.map((ms, k) => `${ms.toFixed(3)}; ${own[k].toFixed(3)} ms | ${(own[k] / ms).toFixed(2)}`);
  console.log(`| ${name} | ${cells.join(" | ")} |`);
  const kind = row < iterated ? 0 : 1;
  most[kind] = Math.max(most[kind], own[0] / native[0], own[1] / native[1]);
}
fs.rmSync(folder, { recursive: true });
console.log(`\nmade and dragged, the module takes at most ${most[0].toFixed(2)} times as long, by iterations ${most[1].toFixed(2)}`);
