/**
 * The limits of speed and of its change, as steppers and in words: those of a set, of the clinic, of a chair.
 * @import { Speeds } from "types/api"
 */
import { limitsOf } from "../reference.js";
import { hasText, t } from "../texts.js";
import { h, write } from "./dom.js";
import { segments, setting, stepper } from "./fields.js";
import { number } from "./format.js";

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

/** What anybody may choose from, in SI units, where nothing narrower is set. @param {keyof Speeds} name @returns {[number, number]} */
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
 * A stepper for each limit, or three words where only an owner sets the number; `note` writes a remark below one.
 * @param {Speeds} speeds in SI units @param {Partial<Record<string, [number, number]>>} limits
 * @param {(name: keyof Speeds, value: number) => void} onChange @param {{hasNumbers: boolean}} options
 */
export function speedRows(speeds, limits, onChange, { hasNumbers }) {
  /** @type {Map<string, HTMLElement>} */
  const notes = new Map();
  const elements = SPEEDS.map(({ name, unit, step, digits, factor, soft }) => {
    const [low, high] = limits[name] ?? rangeOf(name);
    const label = t(`speed-${name}`);
    const hint = `speed-${name}-hint`;
    const note = h("span", { class: "held" });
    notes.set(name, note);
    // The steps are whole in the unit that people read; the result is kept within the chair's limits.
    /** @param {number} value as people read it */
    const change = (value) => onChange(name, Math.min(high, Math.max(low, value / factor)));
    if (soft && !hasNumbers) {
      const options = SOFTNESS.map((value) => ({ value, label: t(`softness-${value}`) }));
      const words = segments(label, options, softness(soft, speeds[name]), (word) =>
        change(soft[SOFTNESS.indexOf(word)] * factor),
      );
      return setting(label, [hasText(hint) && t(hint), note], words);
    }
    const control = stepper({
      label,
      value: speeds[name] * factor,
      low: low * factor,
      high: high * factor,
      step,
      digits,
      unit: t(`unit-${unit}`),
      onChange: change,
    });
    return setting(label, [hasText(hint) && t(hint), note], control);
  });
  /** @param {keyof Speeds} name @param {string} words */
  const note = (name, words) => {
    const place = notes.get(name);
    if (place) write(place, words);
  };
  return { elements, note };
}
