// remedy.js -- what helps against an error, by its reason: the words are those of the library's headers (reasons.awk).
// @ts-check

/** @typedef {Record<string, Record<string, string>>} Remedies  by list, by reason */

const OWN = /** @type {Record<string, string>} */ ({
  syntax: "open a JSON file that `taut make` takes",
  missing: "name a member that the document has",
});

/**
 * Of the construction's list first, then of documents, of any call, and of whatever list has the word; "" where none does.
 * @param {Remedies} remedies
 * @param {string | undefined} construct
 * @param {string | undefined} reason
 */
export function remedyOf(remedies, construct, reason) {
  if (!reason) return "";
  const own = (construct ?? "").split("-")[0].toUpperCase();
  for (const list of [own, "DOCUMENT", "", ...Object.keys(remedies)]) {
    const found = remedies[list]?.[reason];
    if (found !== undefined) return found;
  }
  return OWN[reason] ?? "";
}
