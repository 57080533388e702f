// pointer.js -- places in a JSON document by JSON pointers (RFC 6901). Documents are never changed in place.
// @ts-check

/** @typedef {{ pointer: string, value: unknown }} Edit */

/** The steps of a pointer; "" is the whole document. */
export function stepsOf(/** @type {string} */ pointer) {
  if (pointer === "") return [];
  if (!pointer.startsWith("/")) throw refusal(pointer, `"${pointer}" is no JSON pointer`);
  return pointer.slice(1).split("/").map((step) => step.replaceAll("~1", "/").replaceAll("~0", "~"));
}

/** A pointer one step longer. */
export function below(/** @type {string} */ pointer, /** @type {string | number} */ step) {
  return pointer + "/" + String(step).replaceAll("~", "~0").replaceAll("/", "~1");
}

/** An error as the library's are. */
function refusal(/** @type {string} */ where, /** @type {string} */ message) {
  return Object.assign(new Error(message), { reason: "missing", where });
}

/** Is `step` a place of `value`? The end of a list is one where something may be added. */
function isPlace(/** @type {any} */ value, /** @type {string} */ step, /** @type {boolean} */ mayAdd) {
  if (Array.isArray(value)) {
    return /^(0|[1-9][0-9]*)$/.test(step) && Number(step) < value.length + (mayAdd ? 1 : 0);
  }
  return value !== null && typeof value === "object" && (mayAdd || Object.hasOwn(value, step));
}

/** What stands there. */
export function valueAt(/** @type {any} */ document, /** @type {string} */ pointer) {
  return stepsOf(pointer).reduce((value, step) => {
    if (!isPlace(value, step, false)) throw refusal(pointer, `there is nothing at ${pointer}`);
    return value[step];
  }, document);
}

/** Puts `made` into a copy of `value`, as its own member whatever its name. */
function withMember(/** @type {any} */ value, /** @type {string} */ step, /** @type {unknown} */ made) {
  if (Array.isArray(value)) return value.slice(0, Number(step)).concat([made], value.slice(Number(step) + 1));
  const members = Object.entries(value).filter(([name]) => name !== step || made !== undefined);
  const at = members.findIndex(([name]) => name === step);
  if (at >= 0) members[at] = [step, made];
  else if (made !== undefined) members.push([step, made]);
  return Object.fromEntries(members);
}

/** The document with another value there; undefined takes a member out. */
export function withValue(/** @type {any} */ document, /** @type {string} */ pointer, /** @type {unknown} */ value) {
  const steps = stepsOf(pointer);
  /** @type {(inner: any, from: number) => any} */
  const replace = (inner, from) => {
    if (from === steps.length) return value;
    const step = steps[from];
    if (!isPlace(inner, step, from + 1 === steps.length)) throw refusal(pointer, `there is nothing at ${pointer}`);
    return withMember(inner, step, replace(inner[step], from + 1));
  };
  return replace(document, 0);
}

/** The document after several edits, in order. */
export function withEdits(/** @type {any} */ document, /** @type {Edit[]} */ edits) {
  return edits.reduce((made, { pointer, value }) => withValue(made, pointer, value), document);
}
