// panel.js -- the members of a document as fields, by its JSON Schema, so that what is added there appears here.
// @ts-check
import { below } from "./pointer.js";

/** @typedef {Record<string, any>} Schema */

const DEEPEST = 4, LISTED = 12;
const APART = new Set(["taut", "construct", "points", "known"]); // shown elsewhere, or not to be changed

/** The schema that a document of this construction follows. */
export function schemaOf(/** @type {Schema} */ root, /** @type {any} */ document) {
  const name = String(document?.construct ?? ("trace" in (document ?? {}) ? "trace" : ""));
  return root.$defs[name.replaceAll("-", "_")] ?? { properties: {} };
}

/** Without references. */
export function resolve(/** @type {Schema} */ root, /** @type {Schema} */ schema) {
  for (let k = 0; k < 8 && schema?.$ref !== undefined; k++) {
    const { $ref, ...own } = schema;
    schema = { ...root.$defs[$ref.slice("#/$defs/".length)], ...own };
  }
  return schema ?? {};
}

/** The ways in which a value may be told: one, or those of oneOf and anyOf. */
function waysOf(/** @type {Schema} */ root, /** @type {Schema} */ schema) {
  const whole = resolve(root, schema);
  return [whole, ...(whole.oneOf ?? []), ...(whole.anyOf ?? [])].map((way) => resolve(root, way));
}

/** Does an object have the members that this way has, and the words that it wants? */
function fits(/** @type {Schema} */ root, /** @type {Schema} */ way, /** @type {any} */ value) {
  const known = way.properties ?? {};
  return way.properties !== undefined && Object.entries(value).every(([name, member]) => {
    const wanted = name in known ? resolve(root, known[name]).const : undefined;
    return name in known && (wanted === undefined || wanted === member);
  });
}

/** The members that an object may have, as their schemas: of the ways that it takes, or of all; of words that tell the ways apart all. */
export function membersOf(/** @type {Schema} */ root, /** @type {Schema} */ schema, /** @type {any} */ value) {
  const ways = waysOf(root, schema), own = ways.filter((way) => fits(root, way, value ?? {}));
  /** @type {Record<string, Schema>} */
  const members = Object.assign({}, ...(own.length > 0 ? own : ways).map((way) => way.properties ?? {}));
  for (const name of Object.keys(members)) {
    const words = ways.map((way) => resolve(root, way.properties?.[name] ?? {}).const).filter((word) => typeof word === "string");
    if (words.length > 1) members[name] = { ...members[name], enum: [...new Set(words)] };
  }
  return members;
}

/** What a field for a value is: "number", "choice", "flag", "text" or null. */
export function kindOf(/** @type {Schema[]} */ ways, /** @type {unknown} */ value) {
  const has = (/** @type {string} */ type) => ways.some((way) => way.type === type || (Array.isArray(way.type) && way.type.includes(type)));
  if (typeof value === "number") return "number";
  if (typeof value === "boolean") return "flag";
  if (typeof value === "string") return ways.some((way) => way.enum !== undefined) ? "choice" : "text";
  if (value !== undefined) return null;
  if (has("number") || has("integer")) return "number";
  if (has("boolean")) return "flag";
  if (ways.some((way) => way.enum !== undefined)) return "choice";
  return has("string") ? "text" : null;
}

export class Panel {
  /**
   * @param {HTMLElement} place
   * @param {Schema} root
   * @param {(pointer: string, value: unknown) => Promise<unknown>} change
   * @param {(pointer: string, value: unknown) => unknown} preview  what a slider says while it is held
   */
  constructor(place, root, change, preview = () => {}) {
    this.place = place;
    this.root = root;
    this.change = change;
    this.preview = preview;
  }

  /** All fields anew; what had the focus has it again. */
  show(/** @type {any} */ document) {
    const focused = globalThis.document.activeElement?.id ?? "";
    const heading = globalThis.document.createElement("h2");
    heading.textContent = "Problem";
    const schema = schemaOf(this.root, document);
    const intro = globalThis.document.createElement("small");
    intro.textContent = schema.description ?? "";
    this.place.replaceChildren(heading, intro, ...this.fieldsOf(document, schema, "", 0));
    if (focused !== "" && this.place.querySelector("#" + CSS.escape(focused)) !== null) {
      /** @type {HTMLElement} */ (this.place.querySelector("#" + CSS.escape(focused))).focus();
    }
  }

  /**
   * @param {any} value
   * @param {Schema} schema
   * @param {string} pointer
   * @param {number} depth
   * @returns {HTMLElement[]}
   */
  fieldsOf(value, schema, pointer, depth) {
    const known = membersOf(this.root, schema, value);
    const names = [...new Set([...Object.keys(value ?? {}), ...Object.keys(known)])];
    return names.flatMap((name) => APART.has(name) ? [] : this.field(name, value?.[name], known[name] ?? {}, below(pointer, name), depth));
  }

  /**
   * @param {string} name
   * @param {any} value
   * @param {Schema} schema
   * @param {string} pointer
   * @param {number} depth
   * @returns {HTMLElement[]}
   */
  field(name, value, schema, pointer, depth) {
    const ways = waysOf(this.root, schema), kind = kindOf(ways, value);
    if (kind !== null) return [this.input(name, value, ways, kind, pointer)];
    if (value === null || typeof value !== "object" || depth >= DEEPEST) return [];
    if (Array.isArray(value) && (value.length > LISTED || value.every((item) => Array.isArray(item) || typeof item === "number"))) return [];
    const set = globalThis.document.createElement("fieldset"), legend = globalThis.document.createElement("legend");
    legend.textContent = name;
    const items = Array.isArray(value)
      ? value.flatMap((item, i) => this.field(String(i), item, ways.find((way) => way.items)?.items ?? {}, below(pointer, i), depth + 1))
      : this.fieldsOf(value, schema, pointer, depth + 1);
    set.append(legend, ...items);
    return items.length > 0 ? [set] : [];
  }

  /**
   * @param {string} name
   * @param {any} value
   * @param {Schema[]} ways
   * @param {string} kind
   * @param {string} pointer
   */
  input(name, value, ways, kind, pointer) {
    const { document } = globalThis, row = document.createElement("div"), label = document.createElement("label");
    row.className = "field";
    row.dataset.pointer = pointer;
    label.textContent = name.replaceAll("_", " ");
    label.htmlFor = "field" + pointer;
    const input = kind === "choice" ? this.choice(ways, value) : document.createElement("input");
    input.id = "field" + pointer;
    if (input instanceof HTMLInputElement) {
      input.type = kind === "flag" ? "checkbox" : kind === "number" ? "number" : "text";
      input.step = ways.some((way) => way.type === "integer") ? "1" : "any";
      input.checked = value === true;
      if (kind !== "flag") input.value = value === undefined ? "" : String(value);
      const usual = ways.find((way) => way.default !== undefined)?.default;
      if (usual !== undefined) input.placeholder = String(usual);
    }
    input.addEventListener("change", () => this.change(pointer, this.valueOf(/** @type {any} */ (input), kind)).catch(() => {}));
    row.append(label, input);
    const slider = kind === "number" && typeof value === "number" ? this.slider(ways, value, pointer, /** @type {HTMLInputElement} */ (input)) : null;
    if (slider !== null) row.append(slider);
    const told = ways.find((way) => way.description)?.description;
    if (told) {
      const note = document.createElement("small");
      note.textContent = told;
      row.append(note);
    }
    return row;
  }

  choice(/** @type {Schema[]} */ ways, /** @type {unknown} */ value) {
    const select = globalThis.document.createElement("select");
    const words = [...new Set(ways.flatMap((way) => way.enum ?? []))];
    if (value === undefined) words.unshift("");
    else if (!words.includes(value)) words.unshift(value);
    select.append(...words.map((word) => new Option(String(word), String(word), false, word === value)));
    return select;
  }

  /** Between the schema's limits, or half and twice the value. */
  slider(/** @type {Schema[]} */ ways, /** @type {number} */ value, /** @type {string} */ pointer, /** @type {HTMLInputElement} */ input) {
    const limit = (/** @type {string[]} */ names) => ways.flatMap((way) => names.map((name) => way[name])).find((x) => typeof x === "number");
    const low = limit(["minimum", "exclusiveMinimum"]), high = limit(["maximum", "exclusiveMaximum"]);
    if (ways.some((way) => way.type === "integer")) return null; // arrows of the field serve better
    const reach = Math.max(Math.abs(value), 0.5), slider = globalThis.document.createElement("input");
    slider.type = "range";
    slider.min = String(low ?? value - reach);
    slider.max = String(high !== undefined && high - value < 20 * reach ? high : value + reach);
    slider.step = "any";
    slider.value = String(value);
    slider.setAttribute("aria-label", pointer);
    slider.addEventListener("input", () => {
      input.value = String(Number(Number(slider.value).toPrecision(4)));
      this.preview(pointer, Number(input.value));
    });
    slider.addEventListener("change", () => this.change(pointer, Number(input.value)).catch(() => {}));
    return slider;
  }

  valueOf(/** @type {HTMLInputElement} */ input, /** @type {string} */ kind) {
    if (kind === "flag") return input.checked;
    if (input.value.trim() === "") return undefined;
    return kind === "number" ? Number(input.value) : input.value;
  }

  /** Marks the member that an error is about, with its sentence; null takes the marks away. */
  mark(/** @type {{ where?: string, message: string } | null} */ error) {
    this.place.querySelectorAll(".field.wrong").forEach((row) => row.classList.remove("wrong"));
    this.place.querySelectorAll("small.fails").forEach((note) => note.remove());
    if (error === null) return;
    const rows = /** @type {HTMLElement[]} */ ([...this.place.querySelectorAll(".field")]);
    const row = rows.find(({ dataset }) => dataset.pointer !== undefined && (error.where ?? "").startsWith(dataset.pointer));
    if (row === undefined) return;
    const note = globalThis.document.createElement("small");
    note.className = "fails";
    note.textContent = error.message;
    row.classList.add("wrong");
    row.append(note);
  }
}
