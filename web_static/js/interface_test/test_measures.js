/** The measures of the two-minute test; directions are those of app/scoring/verdict/measure_comparison.py. */
import { joined } from "../results/measures.js";
import { number } from "../widgets/format.js";

/** @typedef {import("types/api").InterfaceTestView} InterfaceTestView */

/** @type {Record<string, {unit: string, digits: number, better: "low" | "high", factor: number}>} */
export const TEST_MEASURES = {
  acquisitions_per_minute: { unit: "", digits: 1, better: "high", factor: 1 },
  throughput: { unit: "bit/s", digits: 2, better: "high", factor: 1 },
  first_entry: { unit: "s", digits: 2, better: "low", factor: 1 },
  dial_in: { unit: "s", digits: 2, better: "low", factor: 1 },
  path_efficiency: { unit: "%", digits: 0, better: "high", factor: 100 },
};

/** A measure of a test, as people read it; null where it has none. @param {InterfaceTestView} test @param {string} name */
export function testMeasure({ measures }, name) {
  const value = measures?.[/** @type {"throughput"} */ (name)];
  return typeof value === "number" ? value * TEST_MEASURES[name].factor : null;
}

/** @param {InterfaceTestView} test @param {string} name */
export function testFigure(test, name) {
  const value = testMeasure(test, name);
  const { digits, unit } = TEST_MEASURES[name];
  return value === null ? "–" : joined(number(value, digits), unit);
}
