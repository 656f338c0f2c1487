/**
 * The limits of speed and of its change, as steppers and in words: those of a set, of the clinic, of a chair.
 * @import { Speeds } from "types/api"
 */
import { Fragment, h } from "../preact.js";
import { limitsOf } from "../reference.js";
import { hasText, t } from "../texts.js";
import { Segments } from "./fields.js";
import { number } from "./format.js";
import { Setting, Stepper } from "./setting.js";

const DEGREES = 180 / Math.PI; // people read degrees, the chair radians

const LOWEST = 0.05; // m/s or rad/s, of speeds for which the server takes any number above 0

/**
 * In the order of wheelchair programming.
 * `soft`: what Soft, Medium and Brisk are, in SI units, where people choose a word and only an owner the number.
 * @type {{name: keyof Speeds, unit: string, step: number, digits: number, factor: number, soft?: [number, number, number]}[]}
 */
export const SPEEDS = [
  { name: "forward", unit: "speed", step: 0.05, digits: 2, factor: 1 },
  { name: "reverse", unit: "speed", step: 0.05, digits: 2, factor: 1 },
  { name: "turn", unit: "turn", step: 5, digits: 0, factor: DEGREES },
  { name: "acceleration", unit: "acceleration", step: 0.1, digits: 1, factor: 1 },
  { name: "deceleration", unit: "acceleration", step: 0.1, digits: 1, factor: 1 },
  { name: "turn_acceleration", unit: "turn_acceleration", step: 20, digits: 0, factor: DEGREES },
  { name: "jerk", unit: "details-jerk", step: 0.5, digits: 1, factor: 1, soft: [2, 8, 20] },
  { name: "turn_jerk", unit: "details-turn-jerk", step: 100, digits: 0, factor: DEGREES, soft: [15, 60, 240] },
];

const SOFTNESS = /** @type {const} */ (["soft", "medium", "brisk"]);

/** Which of three values is the nearest, as a ratio. @param {[number, number, number]} soft @param {number} value */
function softness(soft, value) {
  const ratios = soft.map((one) => Math.abs(Math.log(one / value)));
  return SOFTNESS[ratios.indexOf(Math.min(...ratios))];
}

/** What anybody may choose from, in SI units. @param {keyof Speeds} name @returns {[number, number]} */
function rangeOf(name) {
  const { minimum, maximum } = limitsOf("Speeds", name);
  return [minimum ?? LOWEST, maximum ?? Infinity];
}

/** A limit with its unit, or in a word. @param {typeof SPEEDS[number]} speed @param {number} value in SI units */
export function speedWords({ unit, digits, factor, soft }, value) {
  if (soft) return t(`softness-${softness(soft, value)}`);
  return `${number(value * factor, digits)} ${t(`unit-${unit}`)}`;
}

/**
 * A stepper for each limit, or three words where only an owner sets the number.
 * @param {object} rows
 * @param {Speeds} rows.speeds in SI units
 * @param {boolean} [rows.hasNumbers] also where others choose a word
 * @param {Partial<Record<string, string>>} [rows.notes] remarks on single limits
 * @param {(name: keyof Speeds, value: number) => void} rows.onChange
 */
export function SpeedRows({ speeds, hasNumbers = false, notes = {}, onChange }) {
  const rows = SPEEDS.map(({ name, unit, step, digits, factor, soft }) => {
    const [low, high] = rangeOf(name);
    const label = t(`speed-${name}`);
    const hint = `speed-${name}-hint`;
    // The steps are whole in the unit that people read; the result is kept within the limits.
    /** @param {number} value as people read it */
    const change = (value) => onChange(name, Math.min(high, Math.max(low, value / factor)));
    const control =
      soft && !hasNumbers
        ? h(Segments, {
            label,
            options: SOFTNESS.map((value) => ({ value: String(value), label: t(`softness-${value}`) })),
            chosen: softness(soft, speeds[name]),
            onChange: (/** @type {typeof SOFTNESS[number]} */ word) => change(soft[SOFTNESS.indexOf(word)] * factor),
          })
        : h(Stepper, {
            label,
            value: speeds[name] * factor,
            low: low * factor,
            high: high * factor,
            step,
            digits,
            unit: t(`unit-${unit}`),
            onChange: change,
          });
    return h(Setting, { key: name, title: label, hint: hasText(hint) ? t(hint) : "", note: notes[name] }, control);
  });
  return h(Fragment, {}, rows);
}
