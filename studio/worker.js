// worker.js -- the library in a worker: a document in, what is drawn, proved or written out.
// @ts-check
import { load } from "../web/taut.mjs";

const LINES = 65, ALL_POINTS = 40000; // of one surface; of all

/** @type {any} */
let library = null;
/** @type {{ text: string, surface: any, took: number } | null} */
let made = null; // the document that was asked for last, and milliseconds that it took
/** @type {any} */
let shown = null; // the model that was drawn last: made, or a draft
const ROUNDS = 30; // of a draft at once: it is at rest by then

/** Lets go of a surface that nothing shows any more. */
function drop(/** @type {any} */ surface) {
  if (surface !== null && surface !== shown && surface !== made?.surface) surface.close();
}

/** Another model is drawn. */
function showing(/** @type {any} */ surface) {
  const before = shown;
  shown = surface;
  if (before !== surface) drop(before);
  return surface;
}

/** The document without what takes long and is not seen: the bound of a film's area. */
function seenOf(/** @type {string} */ text) {
  const document = JSON.parse(text);
  const isBounded = ["film", "plateau"].includes(document?.construct) && document.gap === undefined;
  return isBounded ? JSON.stringify({ ...document, least: false }) : text;
}

/** Some steps from what is drawn, of about so many milliseconds in all; null where there is no way. */
function roughly(/** @type {string} */ text, /** @type {number} */ budget) {
  if (shown === null || shown.handle === 0) return null;
  const start = performance.now(), surface = library.open(seenOf(text));
  try {
    if (surface.draft(shown, 1)) {
      const first = performance.now() - start, more = Math.min(ROUNDS, Math.floor(budget / first) - 1);
      if (more > 0) surface.draft(surface, more);
      return surface;
    }
  } catch (error) {
    surface.close();
    throw error;
  }
  surface.close();
  return null;
}

/** The model of a document; that of the last one is kept. */
function modelOf(/** @type {string} */ text) {
  if (made !== null && made.text === text) return made.surface;
  const start = performance.now(), surface = library.open(text);
  try {
    surface.make();
  } catch (error) {
    surface.close();
    throw error;
  }
  const before = made?.surface ?? null;
  made = { text, surface, took: performance.now() - start };
  drop(before);
  return surface;
}

/** Points of all curves. */
function curvesOf(/** @type {any} */ surface) {
  const count = Math.max(9, Math.min(LINES, Math.floor(ALL_POINTS / Math.max(1, surface.curveCount))));
  return Array.from({ length: surface.curveCount }, (_, c) => surface.curve(c, count).slice());
}

/** Lines of the grid of each surface. */
const linesOf = (/** @type {any} */ surface) => Math.max(5, Math.min(LINES, Math.floor(Math.sqrt(ALL_POINTS / Math.max(1, surface.count)))));

/** Grids and nets of all surfaces. */
function draft(/** @type {any} */ surface, /** @type {boolean} */ hasFields) {
  const lines = linesOf(surface);
  return Array.from({ length: surface.count }, (_, s) => {
    const name = surface.name(s), net = surface.points(s);
    const points = net.points.slice();
    const { positions, normals } = surface.grid(s, lines, lines);
    const grid = { positions: positions.slice(), normals: normals.slice() };
    const found = hasFields ? surface.curvatures(s, lines, lines) : {};
    const fields = { mean: found.mean?.slice() ?? null, gaussian: found.gaussian?.slice() ?? null, isothermality: found.isothermality?.slice() ?? null };
    return { name, lines, ...grid, ...fields, net: { nu: net.nu, nv: net.nv, points } };
  });
}

/** How far each surface is from least, where its model says so. */
function gapsOf(/** @type {any} */ surface) {
  const lines = linesOf(surface);
  return Array.from({ length: surface.count }, (_, s) => surface.gaps(s, lines, lines)?.slice() ?? null);
}

/** @type {Record<string, (question: any) => any>} */
const answers = {
  async load({ wasm }) {
    library = await load(wasm);
    return {};
  },
  /** budget: milliseconds for a draft, where there is one; 0: the model is made. Then `isRough` is false. hasFields: with curvatures. */
  draft({ text, budget, hasFields, hasModel }) {
    const rough = budget > 0 ? roughly(text, budget) : null;
    const surface = showing(rough ?? modelOf(seenOf(text)));
    const model = hasModel ? surface.write("json") : "";
    return { surfaces: draft(surface, hasFields), curves: curvesOf(surface), isRough: rough !== null, model, took: made?.took ?? 0 };
  },
  /** A model that another worker made: drafts begin from it. */
  base({ text }) {
    showing(library.open(text));
    return {};
  },
  proof({ text }) {
    const surface = modelOf(text);
    const holds = surface.certify();
    return { holds, json: surface.write("json"), gaps: gapsOf(surface) };
  },
  export({ text, format }) {
    const surface = modelOf(text);
    surface.certify();
    return { bytes: surface.bytes(format).slice() };
  },
};

async function answer(/** @type {any} */ question) {
  try {
    postMessage(await answers[question.kind](question));
  } catch (/** @type {any} */ error) {
    if (error instanceof WebAssembly.RuntimeError) made = shown = null;
    postMessage({ error: { message: error.message, reason: error.reason ?? "fault", where: error.where ?? "" } });
  }
}

/** @type {Promise<void>} */
let last = Promise.resolve(); // one after another: the first loads the library
onmessage = ({ data }) => {
  last = last.then(() => answer(data));
};
