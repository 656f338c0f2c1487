/** The range of an axis, chosen so that what was measured fills the chart. */

const MARGIN = 0.12; // of what the values span
const BELOW_ZERO = 0.03; // of the same, so that a mark at 0 is whole

/**
 * @param {number[]} values those that are not finite are left out @param {boolean} isFromZero whether it begins at 0
 * @returns {[number, number] | undefined} undefined without a value
 */
export function extent(values, isFromZero) {
  const finite = values.filter(Number.isFinite);
  if (!finite.length) return undefined;
  const least = finite.reduce((a, b) => Math.min(a, b), isFromZero ? 0 : Infinity);
  const greatest = finite.reduce((a, b) => Math.max(a, b), isFromZero ? 0 : -Infinity);
  const span = greatest - least || Math.abs(greatest) || 1;
  return [least - (isFromZero && least === 0 ? BELOW_ZERO : MARGIN) * span, greatest + MARGIN * span];
}
