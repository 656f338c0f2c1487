/**
 * The measures of all tasks: unit, digits, which way is better, and how two trials compare.
 * @typedef {{readonly [name: string]: unknown}} Measures of a trial, as the server answers them: most are numbers
 */
import { t } from "../texts.js";
import { number, signed } from "../widgets/format.js";

/** of: the measure that says how many there are. @type {Record<string, {unit: string, digits: number, better: "low" | "high", needsGoal: boolean, of?: string}>} */
export const MEASURES = {
  stages_done: { unit: "", digits: 0, better: "high", needsGoal: false, of: "stages" },
  follow_error_rms: { unit: "m", digits: 2, better: "low", needsGoal: false },
  follow_error_max: { unit: "m", digits: 2, better: "low", needsGoal: false },
  follow_near: { unit: "", digits: 2, better: "high", needsGoal: false },
  heading_error_deg: { unit: "°", digits: 0, better: "low", needsGoal: true },
  turn_drift: { unit: "m", digits: 2, better: "low", needsGoal: false },
  cones_touched: { unit: "", digits: 0, better: "low", needsGoal: false, of: "cones" },
  gap_clearance: { unit: "m", digits: 2, better: "high", needsGoal: false },
  door_contacts: { unit: "", digits: 0, better: "low", needsGoal: false },
  dist: { unit: "m", digits: 2, better: "low", needsGoal: true },
  e_diff: { unit: "m²", digits: 2, better: "low", needsGoal: true },
  time: { unit: "s", digits: 1, better: "low", needsGoal: true },
  dist_ratio: { unit: "", digits: 2, better: "low", needsGoal: true },
  cross_track_rms: { unit: "m", digits: 2, better: "low", needsGoal: false },
  cross_track_max: { unit: "m", digits: 2, better: "low", needsGoal: false },
  mean_speed: { unit: "m/s", digits: 2, better: "high", needsGoal: false },
  stops: { unit: "", digits: 0, better: "low", needsGoal: false },
  collisions: { unit: "", digits: 0, better: "low", needsGoal: false },
  contact_time: { unit: "s", digits: 1, better: "low", needsGoal: false },
  turn_reversals: { unit: "", digits: 0, better: "low", needsGoal: false },
  pulses_per_metre: { unit: "/m", digits: 1, better: "low", needsGoal: false },
  sparc: { unit: "", digits: 2, better: "high", needsGoal: false },
  ldlj: { unit: "", digits: 2, better: "high", needsGoal: false },
};

/** What leads, by what a trial has: the first whose named measures are all there. */
const LARGE = [
  { has: ["stages_done"], large: ["stages_done", "time", "collisions"] },
  { has: ["heading_error_deg"], large: ["heading_error_deg", "turn_drift", "time"] },
  { has: ["follow_error_rms"], large: ["follow_error_rms", "follow_near", "e_diff"] },
  { has: ["gaps", "gap_clearance"], large: ["gap_clearance", "e_diff", "time"] }, // only where the task has gaps, not at every door
  { has: ["cones_touched"], large: ["cones_touched", "e_diff", "time"] },
  { has: [], large: ["dist", "e_diff", "time"] },
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

/** @param {string} name @param {number | null | undefined} value */
export function withUnit(name, value) {
  return joined(number(value, MEASURES[name].digits), MEASURES[name].unit);
}

/** A degree sign stands close to its figure. @param {string} figure @param {string} unit */
function joined(figure, unit) {
  return unit === "°" ? `${figure}${unit}` : `${figure} ${unit}`.trim();
}

/** What stands small behind a measure: its unit, or of how many. @param {string} name @param {Measures} measures */
export function unitOf(name, measures) {
  const { unit, of } = MEASURES[name];
  const count = of ? measured(measures, of) : null;
  return count === null ? unit : t("measure.of", { count });
}

/** Tell whether a trial's measure can stand beside others. @param {string} name @param {Measures | null} measures */
export function comparable(name, measures) {
  return comparison(name, measures) !== null;
}

/** A trial's measure where it can stand beside others; otherwise null. @param {string} name @param {Measures | null} measures */
function comparison(name, measures) {
  return measures?.reached || !MEASURES[name].needsGoal ? measured(measures, name) : null;
}

/**
 * How one trial stands against another in one measure; null when they cannot be compared.
 * @param {string} name @param {Measures | null} measures @param {Measures | null} before
 * @returns {{words: string, amount: string, arrow: string, tone: "good" | "bad" | ""} | null}
 */
export function change(name, measures, before) {
  const [now, then] = [comparison(name, measures), comparison(name, before)];
  if (now === null || then === null) return null;
  const { unit, digits, better } = MEASURES[name];
  const difference = Number((now - then).toFixed(digits));
  if (difference === 0) return { words: t("over.same"), amount: "", arrow: "=", tone: "" };
  const isBetter = difference < 0 === (better === "low");
  return {
    words: t(isBetter ? "over.better" : "over.worse"),
    amount: joined(signed(difference, digits), unit),
    arrow: difference < 0 ? "↓" : "↑",
    tone: isBetter ? "good" : "bad",
  };
}

/** The best of several trials in one measure; null when there is none. @param {string} name @param {{measures: Measures | null}[]} trials */
export function best(name, trials) {
  const values = trials.flatMap(({ measures }) => comparison(name, measures) ?? []);
  if (!values.length) return null;
  return MEASURES[name].better === "low" ? Math.min(...values) : Math.max(...values);
}
