/** The settings of the picture for two eyes; stored in this browser. */
import { signal } from "../preact.js";

const STORAGE_KEY = "bodydrive-stereo";
export const MODES = /** @type {const} */ (["side", "squeezed", "red-cyan"]);
export const MOST_APART = 80; // mm
export const CONVERGENCES = /** @type {const} */ (["0.5", "0.75", "1", "1.5", "2", "3", "5", "10", "Infinity"]); // m

/**
 * @typedef {typeof MODES[number]} Mode
 * @typedef {typeof CONVERGENCES[number]} Convergence m
 * @typedef {{mode: Mode, apart: number, convergence: Convergence, swapped: boolean, split: boolean}} Choices apart: mm
 *   between the eyes; swapped: each eye has the other's side; split: a line between both pictures
 */

// Two lenses of a holder look straight ahead; on one surface for both eyes, far things shall lie behind it.
/** @type {Record<Mode, Convergence>} */
const SUITABLE = { side: "Infinity", squeezed: "3", "red-cyan": "3" };
/** @type {Choices} */
const USUAL = { mode: "side", apart: 63, convergence: SUITABLE.side, swapped: false, split: false };
/** @type {Record<string, (value: unknown) => boolean>} */
const IS_VALID = {
  mode: (value) => MODES.some((one) => one === value),
  apart: (value) => Number.isInteger(value) && Number(value) >= 0 && Number(value) <= MOST_APART,
  convergence: (value) => CONVERGENCES.some((one) => one === value),
  swapped: (value) => typeof value === "boolean",
  split: (value) => typeof value === "boolean",
};

/** What is chosen now. */
export const chosen = signal(/** @type {Choices} */ ({ ...USUAL, ...storedChoices() }));

/** Choose; with another mode comes its suitable convergence. @param {Partial<Choices>} change */
export function choose(change) {
  const suitable = change.mode ? { convergence: SUITABLE[change.mode] } : {};
  chosen.value = { ...chosen.value, ...suitable, ...change };
  localStorage.setItem(STORAGE_KEY, JSON.stringify(chosen.value));
}

/** The stored choices that are valid. @returns {Partial<Choices>} */
function storedChoices() {
  try {
    const stored = Object.entries(JSON.parse(localStorage.getItem(STORAGE_KEY) ?? "{}"));
    return Object.fromEntries(stored.filter(([name, value]) => IS_VALID[name]?.(value)));
  } catch {
    return {};
  }
}
