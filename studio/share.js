// share.js -- a document in the fragment of an address, and in the browser's storage.
// @ts-check

const KEY = "taut-studio", MARK = "#p=";

const packed = (/** @type {string} */ text) =>
  new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer();
const unpacked = (/** @type {Uint8Array} */ bytes) =>
  new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();

/** "#p=" and the document, deflated, in base64 of addresses. */
export async function fragmentOf(/** @type {string} */ text) {
  let letters = "";
  for (const byte of new Uint8Array(await packed(text))) letters += String.fromCharCode(byte);
  return MARK + btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The document of a fragment; null where it holds none. */
export async function documentOf(/** @type {string} */ fragment) {
  if (!fragment.startsWith(MARK)) return null;
  try {
    const letters = atob(fragment.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/"));
    return await unpacked(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)));
  } catch {
    return null;
  }
}

/** Keeps the document for the next time; a browser that keeps nothing for files on the disk does not matter. */
export function keep(/** @type {string} */ text) {
  try {
    localStorage.setItem(KEY, text);
  } catch { /* nothing is kept */ }
}

export function kept() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
