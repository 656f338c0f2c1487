/**
 * The measures of trials as pages write them, by the catalogue that the server serves.
 * @typedef {{readonly [name: string]: unknown}} Measures of a trial, as the server answers them: most are numbers
 */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { number, signed } from "../widgets/format.js";

/** The keys of the measures, in the order in which they are shown. */
export const measureNames = () => Object.keys(REFERENCE.measures.trial);

/** Unit, digits and direction of a measure. @param {string} name */
export const entryOf = (name) => REFERENCE.measures.trial[name];

/** Reaching the goal: it has a verdict between sessions, beside the measures of a trial. */
export const REACHED = "reached";

/** What people call a measure. @param {string} name */
export function nameOf(name) {
  return name === REACHED ? REFERENCE.measures.reached : (entryOf(name)?.name ?? name);
}

/** A measure as a number; null when it was not measured. @param {Measures | null} measures @param {string} name */
export function measured(measures, name) {
  const value = measures?.[name];
  return typeof value === "number" && Number.isFinite(value) ? value : null;
}

/** The three measures that say most about a task, by what was measured. @param {Measures} measures @returns {string[]} */
export function leadingMeasures(measures) {
  return (
    REFERENCE.measures.leading.find(({ has }) => has.every((name) => measured(measures, name) !== null))?.names ?? []
  );
}

/** The measures in large figures: none of a trial that does not count. @param {{kept: boolean, measures: Measures | null}} trial */
export function largeMeasures({ kept, measures }) {
  return kept && measures ? leadingMeasures(measures).filter((name) => comparable(name, measures)) : [];
}

/** A measure's value in its unit; NaN without one. @param {string} name @param {number | null | undefined} value */
export function inUnit(name, value) {
  return (value ?? NaN) * entryOf(name).factor;
}

/** A measure's value as a figure without its unit. @param {string} name @param {number | null | undefined} value */
export function figure(name, value) {
  return number(inUnit(name, value), entryOf(name).digits);
}

/** A difference of two values of a measure, with its sign and unit. @param {string} name @param {number} difference */
export function signedWithUnit(name, difference) {
  return joined(signed(inUnit(name, difference), entryOf(name).digits), entryOf(name).unit);
}

/** @param {string} name @param {number | null | undefined} value */
export function withUnit(name, value) {
  return Number.isFinite(value) ? joined(figure(name, value), entryOf(name).unit) : figure(name, value);
}

/** A degree sign stands close to its figure. @param {string} words @param {string} unit */
export function joined(words, unit) {
  return unit === "°" ? `${words}${unit}` : `${words} ${unit}`.trim();
}

/** What stands small behind a measure: its unit, or of how many. @param {string} name @param {Measures} measures */
export function unitOf(name, measures) {
  const { unit, of } = entryOf(name);
  const count = of ? measured(measures, of) : null;
  return count === null ? unit : t("measure-of", { count });
}

/** Tell whether a trial's measure can stand beside others. @param {string} name @param {Measures | null} measures */
export function comparable(name, measures) {
  return Boolean(measures?.reached || !entryOf(name).needs_goal) && measured(measures, name) !== null;
}
