/** The range of an axis, chosen so that what was measured fills the chart. */

const MARGIN = 0.12; // of what the values span
const BELOW_ZERO = 0.03; // of the same, so that a mark at 0 is whole
const ROUNDING = 1e-9; // of the greatest value: values that differ by less are one value

/**
 * @param {number[]} values those that are not finite are left out @param {boolean} isFromZero whether it begins at 0
 * @returns {[number, number] | undefined} undefined without a value
 */
export function extent(values, isFromZero) {
  const finite = values.filter(Number.isFinite);
  if (!finite.length) return undefined;
  const [least, greatest] = limits(isFromZero ? [0, ...finite] : finite);
  const size = Math.max(Math.abs(least), Math.abs(greatest));
  const span = greatest - least > ROUNDING * size ? greatest - least : size || 1;
  return [least - (isFromZero && least === 0 ? BELOW_ZERO : MARGIN) * span, greatest + MARGIN * span];
}

/** The least and the greatest of values, however many. @param {number[]} values @returns {[number, number]} */
export function limits(values) {
  return [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];
}

/**
 * From half a step before the first number to half a step after the last.
 * @param {number[]} numbers rising @returns {[number, number]}
 */
export function aroundNumbers(numbers) {
  return numbers.length ? [numbers[0] - 0.5, numbers[numbers.length - 1] + 0.5] : [0.5, 1.5];
}
