// parts.js -- what the page carries packed: gzip in base64, in script elements that run nothing.
// @ts-check

/** @returns {Promise<ArrayBuffer>} */
export async function bytesOf(/** @type {string} */ name) {
  const packed = /** @type {HTMLElement} */ (document.getElementById("part-" + name)).textContent ?? "";
  const letters = atob(packed), bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) bytes[k] = letters.charCodeAt(k);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

export async function textOf(/** @type {string} */ name) {
  return new TextDecoder().decode(await bytesOf(name));
}

/** Runs a script that is carried so. */
export async function runPart(/** @type {string} */ name) {
  const address = URL.createObjectURL(new Blob([await textOf(name)], { type: "text/javascript" }));
  await new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = address;
    script.onload = resolve;
    script.onerror = () => reject(new Error(`${name} did not load`));
    document.head.append(script);
  });
  URL.revokeObjectURL(address);
}
