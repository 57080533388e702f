// main.js -- the page: its parts are unpacked, wired together and offered to scripts as window.taut.
// @ts-check
import { Actions, download } from "./actions.js";
import { Engine } from "./engine.js";
import { Hand } from "./hand.js";
import { readable } from "./number.js";
import { Panel } from "./panel.js";
import { bytesOf, runPart, textOf } from "./parts.js";
import { showProof } from "./proof.js";
import { remedyOf } from "./remedy.js";
import { Scene } from "./scene.js";
import { documentOf, fragmentOf, keep, kept } from "./share.js";
import { isFilm, parsed, Studio } from "./studio.js";

const EXPORTS = [["step", "STEP"], ["obj", "OBJ mesh"], ["stl", "STL mesh"], ["ply", "PLY mesh"], ["glb", "GLB mesh"], ["vtu", "VTU"], ["svg", "SVG picture"]];

/** @type {Record<string, string>} Colours from 0 on, with their names. */
const ONE_SIDED = { change: "moved", isothermality: "from isothermal", gap: "gap per area" };

const at = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (at(id));

/** @type {Studio} */
let studio;
/** @type {Scene} */
let scene;
/** @type {import("./remedy.js").Remedies} */
let remedies = {};
let opened = 0; // milliseconds from opening the page to its first picture

/** What is wrong, where, and what helps: in the picture and at the member. */
function showFault(/** @type {Panel} */ panel, /** @type {import("./studio.js").Failure | null} */ error) {
  at("fault").hidden = error === null;
  at("fault").replaceChildren();
  if (error !== null) {
    const construct = error.construct ?? studio?.document?.construct, remedy = remedyOf(remedies, construct, error.reason);
    const rest = [error.where ? `at ${error.where}` : "", remedy ? `what helps: ${remedy}` : ""].filter((part) => part !== "").join(" · ");
    const small = document.createElement("small");
    small.textContent = rest;
    at("fault").append(error.message, small);
  }
  panel.mark(error);
}

/** The chosen points as numbers to type. */
function showChosen(/** @type {import("./places.js").Place[]} */ places) {
  const rows = places.slice(0, 20).map(({ pointer, at: point }) => {
    const row = document.createElement("div"), name = document.createElement("span");
    row.className = "point";
    name.textContent = pointer;
    const fields = point.map((x, c) => {
      const field = document.createElement("input");
      field.type = "number";
      field.step = "any";
      field.value = String(x);
      field.setAttribute("aria-label", `${"xyz"[c]} of ${pointer}`);
      field.addEventListener("change", () => {
        const moved = [...point];
        moved[c] = Number(field.value);
        studio.set(pointer, moved).catch(() => {});
      });
      return field;
    });
    row.append(name, ...fields);
    return row;
  });
  const heading = document.createElement("h2");
  heading.textContent = places.length === 1 ? "One point" : `${places.length} points`;
  at("chosen").replaceChildren(...(places.length > 0 ? [heading, ...rows] : []));
}

function showLegend() {
  at("legend").hidden = scene.colour === "none";
  const oneSided = ONE_SIDED[scene.colour];
  at("legend-name").textContent = oneSided ?? scene.colour;
  const isTold = scene.colour !== "gap" || scene.gaps.some((gap) => gap !== null);
  at("legend").classList.toggle("untold", !isTold);
  at("legend-low").textContent = oneSided ? "0" : readable(-scene.limit, 3);
  at("legend").classList.toggle("one-sided", oneSided !== undefined);
  at("legend-high").textContent = isTold ? readable(scene.limit, 3) : "no witness tells it";
}

/** @returns {import("./studio.js").Views} */
function viewsOf(/** @type {Panel} */ panel) {
  return {
    proof(certificate, isDraft) {
      showProof(at("proof"), certificate, isDraft);
      showLegend();
      at("state").textContent = isDraft ? "draft" : "";
    },
    document(problem) {
      panel.show(problem);
      at("title").textContent = problem.name ?? problem.construct ?? "trace";
      keep(JSON.stringify(problem));
      showLegend();
    },
    fault: (error) => showFault(panel, error),
    chosen: showChosen,
    busy: (word) => { at("state").textContent = word; },
    legend: showLegend,
  };
}

async function exportAs(/** @type {string} */ format) {
  await studio.last;
  try {
    download(`${studio.document.construct ?? "model"}.${format}`, await studio.engine.write(studio.text(), format), "application/octet-stream");
  } catch (/** @type {any} */ error) {
    studio.views.fault(error);
  }
}

async function share() {
  location.hash = await fragmentOf(studio.text());
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  studio.views.busy("the address of this page holds the problem now");
}

function toggleDark() {
  document.documentElement.classList.toggle("dark");
  scene.restyle();
}

function showColour(/** @type {string} */ colour) {
  input("colour").value = colour;
  studio.colour(colour);
  showLegend();
}

function showLines(/** @type {string} */ kind) {
  input("lines").value = kind;
  scene.setLines(kind);
}

function showSection() {
  const axis = Number(input("section").value);
  input("section-at").hidden = axis < 0;
  scene.setSection(axis, Number(input("section-at").value));
}

const turns = [["ArrowLeft", -10, 0], ["ArrowRight", 10, 0], ["ArrowUp", 0, 10], ["ArrowDown", 0, -10]];
const views = [["from the front", "1", -90, 0], ["from the right", "2", 0, 0], ["from above", "3", -90, 90], ["from a corner", "4", -55, 28]];

/** @returns {import("./actions.js").Action[]} */
function actionsOf(/** @type {Hand} */ hand) {
  return [
    { menu: "File", name: "Open a problem", key: "Ctrl+O", act: () => input("file").click() },
    { menu: "File", name: "Save the problem", key: "Ctrl+S", act: () => download("problem.json", studio.text() + "\n", "application/json") },
    { menu: "File", name: "Save the model, proved", key: "Ctrl+Shift+S", act: () => exportAs("json") },
    ...EXPORTS.map(([format, name]) => ({ menu: "File", name: `Export ${name}`, key: "", act: () => exportAs(format) })),
    { menu: "File", name: "Save the picture", key: "", act: () => scene.canvas.toBlob((blob) => blob && download("taut.png", blob, "image/png")) },
    { menu: "File", name: "Share by address", key: "", act: share },
    { menu: "Edit", name: "Undo", key: "Ctrl+Z", act: () => studio.step("undo") },
    { menu: "Edit", name: "Redo", key: "Ctrl+Shift+Z", act: () => studio.step("redo") },
    { menu: "Edit", name: "Choose all points", key: "Ctrl+A", act: () => hand.choose(hand.places.filter(({ isFree }) => !isFree).map(({ pointer }) => pointer)) },
    { menu: "Edit", name: "Hold or free the chosen points", key: "P", act: () => hand.chosen().length > 0 && studio.hold(hand.chosen()).catch(() => {}) },
    { menu: "Edit", name: "Choose none, or give up a drag", key: "Escape", act: () => hand.cancel() || hand.choose([]) },
    { menu: "View", name: "All of it", key: "F", act: () => scene.frame(hand.places.map((place) => place.at)) },
    ...views.map(([name, key, azimuth, elevation]) => ({ menu: "View", name: `Look ${name}`, key: String(key), act: () => scene.lookFrom(Number(azimuth), Number(elevation)) })),
    ...turns.map(([key, right, up]) => ({ menu: "View", name: `Turn ${String(key).slice(5).toLowerCase()}`, key: String(key), act: () => scene.turn(Number(right), Number(up)) })),
    { menu: "View", name: "Nearer", key: "+", act: () => scene.zoom(1.2) },
    { menu: "View", name: "Farther", key: "-", act: () => scene.zoom(1 / 1.2) },
    { menu: "View", name: "Net", key: "N", act: () => input("net").click() },
    { menu: "View", name: "Forces on the supports of a film", key: "A", act: () => showLines(input("lines").value === "forces" ? "none" : "forces") },
    { menu: "View", name: "Colour by H", key: "H", act: () => showColour(scene.colour === "H" ? "none" : "H") },
    { menu: "View", name: "Colour by K", key: "K", act: () => showColour(scene.colour === "K" ? "none" : "K") },
    { menu: "View", name: "Colour by what moved", key: "M", act: () => showColour(scene.colour === "change" ? "none" : "change") },
    { menu: "View", name: "Colour by isothermality", key: "I", act: () => showColour(scene.colour === "isothermality" ? "none" : "isothermality") },
    { menu: "View", name: "Colour by the gap to the least area", key: "G", act: () => showColour(scene.colour === "gap" ? "none" : "gap") },
    { menu: "View", name: "Reflection lines", key: "R", act: () => showLines(input("lines").value === "reflection" ? "none" : "reflection") },
    { menu: "View", name: "Height lines", key: "Z", act: () => showLines(input("lines").value === "height" ? "none" : "height") },
    { menu: "View", name: "Curvature combs", key: "C", act: () => showLines(input("lines").value === "combs" ? "none" : "combs") },
    { menu: "View", name: "Light or dark", key: "D", act: toggleDark },
    { menu: "Help", name: "Keys", key: "?", act: () => /** @type {HTMLDialogElement} */ (at("keys")).showModal() },
  ];
}

const attempt = (/** @type {any} */ problem) => studio.load(problem).catch((error) => studio.views.fault(error));

/** Example, file and drop. */
function wireSources(/** @type {Record<string, any>} */ examples) {
  const select = /** @type {HTMLSelectElement} */ (at("examples"));
  select.append(new Option("choose one", ""), ...Object.keys(examples).map((name) => new Option(name, name)));
  select.addEventListener("change", () => select.value !== "" && attempt(examples[select.value]));
  input("file").addEventListener("change", async () => {
    const file = input("file").files?.[0];
    input("file").value = "";
    if (file) await attempt(await file.text());
  });
  window.addEventListener("dragover", (event) => { event.preventDefault(); document.body.classList.add("drop"); });
  window.addEventListener("dragleave", () => document.body.classList.remove("drop"));
  window.addEventListener("drop", async (event) => {
    event.preventDefault();
    document.body.classList.remove("drop");
    const file = event.dataTransfer?.files[0];
    if (file) await attempt(await file.text());
  });
}

function wireTools() {
  input("net").addEventListener("change", () => { scene.setNet(input("net").checked); studio.handOn(studio.document); });
  input("lines").addEventListener("change", () => showLines(input("lines").value));
  for (const name of ["section", "section-at"]) input(name).addEventListener("input", showSection);
  input("colour").addEventListener("change", () => showColour(input("colour").value));
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const follow = () => {
    document.documentElement.classList.toggle("dark", dark.matches);
    scene.restyle();
  };
  dark.addEventListener("change", follow);
  if (dark.matches) follow();
}

/** What was edited last time, if it is another problem than the one that the page was written for. */
function offerKept(/** @type {string | null} */ before, /** @type {any} */ given) {
  if (before === null || before === JSON.stringify(given)) return;
  at("resume").hidden = false;
  at("resume-yes").addEventListener("click", () => { at("resume").hidden = true; attempt(before); });
  at("resume-no").addEventListener("click", () => { at("resume").hidden = true; });
}

/** Until what the page says while it loads is seen. A page that nobody looks at draws nothing, and does not wait for that. */
const seen = () => new Promise((resolve) => {
  requestAnimationFrame(() => setTimeout(resolve));
  setTimeout(resolve, document.hidden ? 0 : 100);
});

/** The problem of the page's address, or the one that it was written for. */
async function problemGiven() {
  return parsed(await documentOf(location.hash) ?? at("given").textContent ?? "null");
}

/** The library, which begins with the first surface while the picture is made ready. */
async function beginEngine(/** @type {any} */ problem) {
  const [wasm, worker] = await Promise.all([bytesOf("wasm").then((bytes) => WebAssembly.compile(bytes)), textOf("worker")]);
  const engine = new Engine(worker, wasm);
  engine.foresee(JSON.stringify(problem), isFilm(problem));
  return engine;
}

async function start() {
  const before = kept();
  await seen();
  const given = await problemGiven();
  const [engine, schema, examples, reasons] = await Promise.all(
    [beginEngine(given), textOf("schema"), textOf("examples"), textOf("reasons"), runPart("three")]);
  remedies = JSON.parse(reasons);
  scene = new Scene(/** @type {HTMLCanvasElement} */ (at("canvas")));
  const panel = new Panel(at("panel"), JSON.parse(schema), (pointer, value) => studio.set(pointer, value), (pointer, value) => studio.preview([{ pointer, value }]));
  studio = new Studio(engine, scene, viewsOf(panel));
  /** @type {Hand} */
  const hand = new Hand(scene, {
    preview: (edits) => studio.preview(edits),
    commit: (edits) => studio.commit(edits),
    cancel: () => studio.cancel(),
    chosen: () => showChosen(hand.chosen()),
    mode: () => ({ axis: input("axis").value, step: Number(input("step").value) || 0, mirror: input("mirror").value }),
  });
  studio.hand = hand;
  const actions = new Actions(actionsOf(hand));
  actions.showMenus(at("menus"));
  actions.showKeys(at("key-table"));
  wireSources(JSON.parse(examples));
  wireTools();
  scene.resize();
  await studio.begin(given);
  scene.render();
  opened = performance.now();
  offerKept(before, studio.document);
}

const ready = start().catch((error) => {
  at("fault").hidden = false;
  at("fault").textContent = `The studio did not start: ${error.message}`;
  throw error;
});
ready.catch(() => {});

/** What scripts and tests see; errors have `reason`, `where` and `message`. */
Object.assign(window, {
  taut: Object.freeze({
    version: VERSION,
    ready,
    problem: () => structuredClone(studio.document),
    load: async (/** @type {any} */ problem) => { await ready; await studio.load(problem); },
    set: async (/** @type {string} */ pointer, /** @type {unknown} */ value) => { await ready; await studio.set(pointer, value); },
    model: async () => { await ready; return studio.model(); },
    undo: async () => { await ready; return studio.step("undo"); },
    redo: async () => { await ready; return studio.step("redo"); },
    stats: () => ({ ...studio.engine.stats, frames: scene.frames, open_ms: opened }),
  }),
});
