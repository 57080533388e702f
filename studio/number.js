// number.js -- numbers as people read them.
// @ts-check

/** `digits` digits that count; powers of ten only where they shorten. */
export function readable(/** @type {number | null | undefined} */ x, digits = 6) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "-";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e-3 && size < 1e7) return String(Number(x.toPrecision(digits)));
  const [mantissa, power] = x.toExponential(Math.max(0, Math.min(digits, 3) - 1)).split("e");
  return `${Number(mantissa)}e${Number(power)}`;
}
