// studio.mjs -- how the page of `taut studio` follows a hand, in Chromium without a window.
//
//     node bench/web/studio.mjs build/release/bin/taut
//
// Of each document a point is dragged by MOVES moves of the pointer, then let go. Milliseconds, the middle of ROUNDS drags, with the least
// and the largest: from asking for a move until it is there to be drawn, from letting go until the surface is made, and until it is
// proved. After letting go the page waits for its picture first, which the processor draws in some 40 ms.
// @ts-check
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";

const { Browser, Page } = createRequire(import.meta.url)("../../tests/viewer/browser.js");
const [taut, ...only] = process.argv.slice(2);
const ROUNDS = 5, MOVES = 8;
const example = (/** @type {string} */ name) => JSON.parse(execFileSync(taut, ["example", name], { encoding: "utf8" }));

/** A net of n x n points; those that `known` says are given. */
function net(/** @type {string} */ construct, /** @type {object} */ u, /** @type {object} */ v, /** @type {number} */ n,
  /** @type {(i: number, j: number) => boolean} */ known, more = {}) {
  const place = (/** @type {number} */ i, /** @type {number} */ j) => {
    const x = i / (n - 1), y = j / (n - 1);
    return [x, y, 0.15 * Math.sin(3 * x + 2 * y) + 0.05 * Math.cos(5 * y)];
  };
  const points = Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => (known(i, j) ? place(i, j) : null)));
  return { taut: 1, construct, u, v, points, ...more };
}
const frame = (/** @type {number} */ n) => (/** @type {number} */ i, /** @type {number} */ j) => i % (n - 1) === 0 || j % (n - 1) === 0;
const spline = { type: "bspline", degree: 3, count: 30 };
const bezier = (/** @type {number} */ n, length = 1) => ({ type: "bezier", degree: n - 1, range: [0, length] });

/** @type {[string, any][]} */
const cases = [
  ["`dirichlet`, 30 x 30", net("dirichlet", spline, spline, 30, frame(30))],
  ["`harmonic`, rows of 30 x 30, 1 by 12", net("harmonic", bezier(30), bezier(30, 12), 30, (i) => i % 29 === 0)],
  ["`biharmonic`, four rows of 10 x 10", net("biharmonic", bezier(10), bezier(10), 10, frame(10))],
  ["`film`, a sail of 12 x 12", example("film-sail")],
  ["`film`, a sail of 30 x 30", { ...example("film-sail"), u: spline, v: spline }],
  ["`plateau`, `\"normal\"`, 30 x 30", net("plateau", spline, spline, 30, frame(30), { method: "normal" })],
  ["`pipe`, g2", example("pipe-g2")],
  ["`asymptotic`, four curves", example("asymptotic-4")],
];

const middle = (/** @type {number[]} */ list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const told = (/** @type {number[]} */ list) => `${middle(list).toFixed(0)} (${Math.min(...list).toFixed(0)} to ${Math.max(...list).toFixed(0)})`;

/** Times in the page: when the hand let go, and when all was proved. */
const WATCH = `window.marks = {}; addEventListener("pointerup", () => { marks.up = performance.now(); }, true);
  new MutationObserver(() => { const s = document.getElementById("proof").dataset.state; if (s !== "draft") marks.proved = performance.now(); })
    .observe(document.getElementById("proof"), { attributes: true, subtree: true, childList: true });`;

async function measure(/** @type {any} */ browser, /** @type {string} */ file, /** @type {any} */ document) {
  const page = await Page.open(browser, file, 840, 600);
  await page.evaluate("taut.ready.then(() => true)");
  await page.evaluate(`taut.load(${JSON.stringify(document)})`);
  await page.evaluate(WATCH);
  await page.until('document.getElementById("proof").dataset.state !== "draft"');
  const box = await page.evaluate('(() => { const r = document.getElementById("canvas").getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()');
  const drafts = [], made = [], proved = [];
  for (let round = 0; round < ROUNDS; round++) {
    const at = await page.evaluate(`(() => { /* a place where a hand finds a point */
      const canvas = document.getElementById("canvas");
      for (let y = 30; y < ${box[3]} - 60; y += 6) for (let x = 10; x < ${box[2]} - 10; x += 6) {
        canvas.dispatchEvent(new PointerEvent("pointermove", { clientX: ${box[0]} + x, clientY: ${box[1]} + y, bubbles: true }));
        if (canvas.style.cursor === "grab") return [${box[0]} + x, ${box[1]} + y];
      }
      return null; })()`);
    if (at === null) throw new Error("nothing to take");
    await page.mouse("mousePressed", at[0], at[1], { buttons: 1 });
    for (let k = 1; k <= MOVES; k++) {
      const { solves } = await page.evaluate("taut.stats()");
      await page.mouse("mouseMoved", at[0] + 4 + k, at[1] + 4 + k, { buttons: 1 });
      await page.until(`taut.stats().solves > ${solves}`);
      drafts.push((await page.evaluate("taut.stats()")).draft_ms);
    }
    const text = JSON.stringify(await page.evaluate("taut.problem()"));
    await page.evaluate("marks.proved = 0");
    await page.mouse("mouseReleased", at[0] + 4 + MOVES, at[1] + 4 + MOVES);
    await page.until(`JSON.stringify(taut.problem()) !== ${JSON.stringify(text)} && document.getElementById("proof").dataset.state !== "draft" && marks.proved > 0`);
    const stats = await page.evaluate("taut.stats()"), marks = await page.evaluate("marks");
    made.push(stats.draft_ms);
    proved.push(marks.proved - marks.up);
  }
  if (page.complaints.length > 0) console.error(page.complaints.join("\n"));
  await page.close();
  return [drafts, made, proved];
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "taut-bench-studio-")), file = path.join(folder, "studio.html");
execFileSync(taut, ["studio", "-o", file]);
console.log("| document | a move, ms | let go, made, ms | let go, proved, ms |");
console.log("|---|---|---|---|");
for (const [name, document] of cases.filter(([name]) => only.length === 0 || only.some((word) => name.includes(word)))) {
  const browser = new Browser(process.env.CHROMIUM || "chromium");
  try {
    console.log(`| ${name} | ${(await measure(browser, file, document)).map(told).join(" | ")} |`);
  } finally {
    await browser.close();
  }
}
fs.rmSync(folder, { recursive: true });
