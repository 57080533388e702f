// worker.js -- the library in a worker: a document in, what is drawn, proved or written out.
// @ts-check
import { load } from "../web/taut.mjs";

const LINES = 65, ALL_POINTS = 40000; // of one surface; of all

/** @type {any} */
let library = null;
/** @type {{ text: string, surface: any } | null} */
let made = null; // the document that was asked for last

/** The model of a document; that of the last one is kept. */
function modelOf(/** @type {string} */ text) {
  if (made !== null && made.text === text) return made.surface;
  const surface = library.open(text);
  try {
    surface.make();
  } catch (error) {
    surface.close();
    throw error;
  }
  made?.surface.close();
  made = { text, surface };
  return surface;
}

/** Points of all curves. */
function curvesOf(/** @type {any} */ surface) {
  const count = Math.max(9, Math.min(LINES, Math.floor(ALL_POINTS / Math.max(1, surface.curveCount))));
  return Array.from({ length: surface.curveCount }, (_, c) => surface.curve(c, count).slice());
}

/** Grids and nets of all surfaces. */
function draft(/** @type {any} */ surface) {
  const lines = Math.max(5, Math.min(LINES, Math.floor(Math.sqrt(ALL_POINTS / Math.max(1, surface.count)))));
  return Array.from({ length: surface.count }, (_, s) => {
    const name = surface.name(s), net = surface.points(s);
    const points = net.points.slice();
    const { positions, normals } = surface.grid(s, lines, lines);
    const grid = { positions: positions.slice(), normals: normals.slice() };
    const { mean, gaussian } = surface.curvatures(s, lines, lines);
    return { name, lines, ...grid, mean: mean.slice(), gaussian: gaussian.slice(), net: { nu: net.nu, nv: net.nv, points } };
  });
}

/** @type {Record<string, (question: any) => any>} */
const answers = {
  async load({ wasm }) {
    library = await load(wasm);
    return {};
  },
  draft({ text }) {
    const surface = modelOf(text);
    return { surfaces: draft(surface), curves: curvesOf(surface) };
  },
  proof({ text }) {
    const surface = modelOf(text);
    const holds = surface.certify();
    return { holds, json: surface.write("json") };
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
    if (error instanceof WebAssembly.RuntimeError) made = null;
    postMessage({ error: { message: error.message, reason: error.reason ?? "fault", where: error.where ?? "" } });
  }
}

/** @type {Promise<void>} */
let last = Promise.resolve(); // one after another: the first loads the library
onmessage = ({ data }) => {
  last = last.then(() => answer(data));
};
