/**
 * The measures of all tasks, in the order in which pages and reports show them: unit, digits, which way is better, and
 * in which trials they can stand beside others.
 * @typedef {{readonly [name: string]: unknown}} Measures of a trial, as the server answers them: most are numbers
 */
import { t } from "../texts.js";
import { number, signed } from "../widgets/format.js";

/**
 * Directions and needsGoal are those of app/scoring/verdict/measure_comparison.py. factor: what a stored value is
 * multiplied by to be in its unit (100 for a share in percent); of: the measure that says how many there are.
 * @type {Record<string, {unit: string, digits: number, factor?: number, better: "low" | "high" | null, needsGoal: boolean, of?: string}>}
 */
export const MEASURES = {
  stages_done: { unit: "", digits: 0, better: "high", needsGoal: false, of: "stages" },
  follow_error_rms: { unit: "m", digits: 2, better: "low", needsGoal: true },
  follow_error_max: { unit: "m", digits: 2, better: "low", needsGoal: true },
  follow_near: { unit: "%", digits: 0, factor: 100, better: "high", needsGoal: true },
  heading_error_deg: { unit: "°", digits: 0, better: "low", needsGoal: true },
  turn_drift: { unit: "m", digits: 2, better: "low", needsGoal: true },
  cones_touched: { unit: "", digits: 0, better: "low", needsGoal: true, of: "cones" },
  gap_clearance: { unit: "m", digits: 2, better: "high", needsGoal: true },
  door_contacts: { unit: "", digits: 0, better: "low", needsGoal: true },
  e_diff: { unit: "m²", digits: 2, better: "low", needsGoal: true },
  dist: { unit: "m", digits: 2, better: "low", needsGoal: true },
  time: { unit: "s", digits: 1, better: "low", needsGoal: true },
  dist_ratio: { unit: "", digits: 2, better: "low", needsGoal: true },
  cross_track_rms: { unit: "m", digits: 2, better: "low", needsGoal: true },
  cross_track_max: { unit: "m", digits: 2, better: "low", needsGoal: true },
  mean_speed: { unit: "m/s", digits: 2, better: null, needsGoal: true },
  stops: { unit: "", digits: 0, better: "low", needsGoal: true },
  collisions: { unit: "", digits: 0, better: "low", needsGoal: true },
  contact_time: { unit: "s", digits: 1, better: "low", needsGoal: true },
  turn_reversals: { unit: "", digits: 0, better: "low", needsGoal: true },
  pulses_per_metre: { unit: "/m", digits: 1, better: "low", needsGoal: true },
  sparc: { unit: "", digits: 2, better: "high", needsGoal: true },
  ldlj: { unit: "", digits: 2, better: "high", needsGoal: true },
};

/** What leads, by what a trial has: the first whose named measures are all there. Equal to LEADING of app/reports/measure_words.py. */
const LARGE = [
  { has: ["stages_done"], large: ["stages_done", "time", "collisions"] },
  { has: ["heading_error_deg"], large: ["heading_error_deg", "turn_drift", "time"] },
  { has: ["follow_error_rms"], large: ["follow_error_rms", "follow_near", "e_diff"] },
  { has: ["gaps", "gap_clearance"], large: ["gap_clearance", "e_diff", "time"] }, // only where the task has gaps, not at every door
  { has: ["cones_touched"], large: ["cones_touched", "e_diff", "time"] },
  { has: [], large: ["e_diff", "dist", "time"] },
];

/** A measure as a number; null when it was not measured. @param {Measures | null} measures @param {string} name */
export function measured(measures, name) {
  const value = measures?.[name];
  return typeof value === "number" && Number.isFinite(value) ? value : null;
}

/** The three measures that say most about a task, by what was measured. @param {Measures} measures @returns {string[]} */
export function leadingMeasures(measures) {
  return LARGE.find(({ has }) => has.every((name) => measured(measures, name) !== null))?.large ?? [];
}

/** The measures in large figures: none of a trial that does not count. @param {{kept: boolean, measures: Measures | null}} trial */
export function largeMeasures({ kept, measures }) {
  return kept && measures ? leadingMeasures(measures).filter((name) => comparable(name, measures)) : [];
}

/** A measure's value in its unit; NaN without one. @param {string} name @param {number | null | undefined} value */
export function inUnit(name, value) {
  return (value ?? NaN) * (MEASURES[name].factor ?? 1);
}

/** A measure's value as a figure without its unit. @param {string} name @param {number | null | undefined} value */
export function figure(name, value) {
  return number(inUnit(name, value), MEASURES[name].digits);
}

/** A difference of two values of a measure, with its sign and unit. @param {string} name @param {number} difference */
export function signedWithUnit(name, difference) {
  return joined(signed(inUnit(name, difference), MEASURES[name].digits), MEASURES[name].unit);
}

/** @param {string} name @param {number | null | undefined} value */
export function withUnit(name, value) {
  return Number.isFinite(value) ? joined(figure(name, value), MEASURES[name].unit) : figure(name, value);
}

/** A degree sign stands close to its figure. @param {string} words @param {string} unit */
export function joined(words, unit) {
  return unit === "°" ? `${words}${unit}` : `${words} ${unit}`.trim();
}

/** What stands small behind a measure: its unit, or of how many. @param {string} name @param {Measures} measures */
export function unitOf(name, measures) {
  const { unit, of } = MEASURES[name];
  const count = of ? measured(measures, of) : null;
  return count === null ? unit : t("measure.of", { count });
}

/** Tell whether a trial's measure can stand beside others. @param {string} name @param {Measures | null} measures */
export function comparable(name, measures) {
  return Boolean(measures?.reached || !MEASURES[name].needsGoal) && measured(measures, name) !== null;
}
