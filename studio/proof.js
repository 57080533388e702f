// proof.js -- the certificate beside the picture: each claim with its residual against its limit, and the figures.
// @ts-check
import { readable } from "./number.js";

/** @typedef {{ claim: string, kind: string, residual: number | null, limit: number | null, holds: boolean | null, where?: string }} Claim */

/** Where a residual and its limit stand between 1e-17 and 1, in parts of a hundred. */
export function placeOnBar(/** @type {number | null} */ x) {
  if (x === null || !(Math.abs(x) > 0)) return 0;
  return Math.min(100, Math.max(0, 100 * (Math.log10(Math.abs(x)) + 17) / 17));
}

/** "holds", "fails" or "undecided". */
export const verdictOf = (/** @type {boolean | null} */ holds) => holds === true ? "holds" : holds === false ? "fails" : "undecided";
const styleOf = (/** @type {boolean | null} */ holds) => holds === true ? "holds" : holds === false ? "fails" : "open";

/** Does the claim want its residual at the limit or above, as `stable` and `regular` do? */
export const wantsMore = (/** @type {Claim} */ { holds, residual, limit }) =>
  residual !== null && limit !== null && (holds === true ? residual > limit : holds === false && residual < limit);

function element(/** @type {string} */ tag, /** @type {string} */ style, /** @type {string} */ text = "") {
  const made = document.createElement(tag);
  if (style !== "") made.className = style;
  made.textContent = text;
  return made;
}

function rowOf(/** @type {Claim} */ claim) {
  const row = element("tr", "claim"), first = element("th", "", claim.claim), second = element("td", "");
  first.title = claim.where ? `at ${claim.where}` : "";
  first.append(document.createElement("br"), element("small", "", claim.kind));
  const sign = wantsMore(claim) ? "at least" : "limit", line = element("span", "row");
  const numbers = claim.residual === null ? `${sign} ${readable(claim.limit, 3)}` : `${readable(claim.residual, 3)}, ${sign} ${readable(claim.limit, 3)}`;
  line.append(element("span", styleOf(claim.holds), verdictOf(claim.holds)), element("small", "number", numbers));
  second.append(line);
  if (claim.limit !== null && claim.limit > 0) {
    const bar = element("span", `bar ${styleOf(claim.holds)}`), fill = document.createElement("i"), limit = document.createElement("b");
    fill.style.width = `${placeOnBar(claim.residual)}%`;
    limit.style.left = `${placeOnBar(claim.limit)}%`;
    bar.append(fill, limit);
    second.append(bar);
  }
  row.append(first, second);
  return row;
}

function figureRows(/** @type {Record<string, unknown>} */ figures) {
  return Object.entries(figures).filter(([, value]) => typeof value === "number").map(([name, value]) => {
    const row = document.createElement("tr");
    row.append(element("th", "", name.replaceAll("_", " ")), element("td", "number", readable(/** @type {number} */ (value), 9)));
    return row;
  });
}

/** "proved" is for claims that are exact or bounds; with checks among them the whole holds. */
export function wordOf(/** @type {{ holds: boolean | null, claims: Claim[] } | null} */ certificate, /** @type {boolean} */ isDraft) {
  if (isDraft || certificate === null) return "draft";
  const isProof = certificate.holds === true && certificate.claims.every(({ kind, holds }) => kind !== "check" && holds === true);
  return isProof ? "proved" : verdictOf(certificate.holds);
}

/** Shows a certificate; `isDraft`: it is of the document before, its like is on the way. */
export function showProof(/** @type {HTMLElement} */ place, /** @type {{ holds: boolean | null, claims: Claim[], figures: Record<string, unknown> } | null} */ certificate,
  /** @type {boolean} */ isDraft) {
  const heading = element("h2", "", "Proof");
  const word = wordOf(certificate, isDraft);
  heading.append(element("span", `badge ${word === "draft" ? "open" : styleOf(/** @type {any} */ (certificate).holds)}`, word));
  place.replaceChildren(heading);
  place.dataset.state = word;
  if (certificate === null) return;
  const claims = document.createElement("table"), figures = document.createElement("table");
  claims.append(...certificate.claims.map(rowOf));
  figures.append(...figureRows(certificate.figures ?? {}));
  place.append(claims, element("p", ""), figures);
  place.style.opacity = isDraft ? "0.6" : "1";
}
