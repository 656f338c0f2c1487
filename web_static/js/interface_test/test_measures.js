/** The measures of the two-minute test as pages write them, by the catalogue that the server serves. */
import { REFERENCE } from "../reference.js";
import { joined } from "../results/measures.js";
import { number } from "../widgets/format.js";

/** @typedef {import("types/api").InterfaceTestView} InterfaceTestView */

/** The keys of the measures, in the order in which they are shown. */
export const testNames = () => Object.keys(REFERENCE.measures.test);

/** Name, unit, digits and direction of a measure. @param {string} name */
export const testEntry = (name) => REFERENCE.measures.test[name];

/** A measure of a test, as people read it; null where it has none. @param {InterfaceTestView} test @param {string} name */
export function testMeasure({ measures }, name) {
  const value = measures?.[/** @type {"throughput"} */ (name)];
  return typeof value === "number" ? value * testEntry(name).factor : null;
}

/** @param {InterfaceTestView} test @param {string} name */
export function testFigure(test, name) {
  const value = testMeasure(test, name);
  const { digits, unit } = testEntry(name);
  return value === null ? "–" : joined(number(value, digits), unit);
}
