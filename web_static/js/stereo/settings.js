/** What was chosen for the two eyes; remembered on this screen. */

const PLACE = "bodydrive-stereo";
export const MODES = ["side", "squeezed", "red-cyan"];
export const MOST_APART = 80; // mm
export const CONVERGENCES = ["0.5", "0.75", "1", "1.5", "2", "3", "5", "10", "Infinity"]; // m
// Two lenses of a holder look straight ahead; on one surface for both eyes, far things shall lie behind it.
const SUITS = { side: "Infinity", squeezed: "3", "red-cyan": "3" };
const USUAL = { mode: "side", apart: 63, convergence: SUITS.side, swapped: false, split: false };
const IS_VALID = {
  mode: (value) => MODES.includes(value),
  apart: (value) => Number.isInteger(value) && value >= 0 && value <= MOST_APART,
  convergence: (value) => CONVERGENCES.includes(value),
  swapped: (value) => typeof value === "boolean",
  split: (value) => typeof value === "boolean",
};

/** Tells "change" when something was chosen. */
export class Settings extends EventTarget {
  #chosen = { ...USUAL, ...remembered() };

  /** @returns {Readonly<typeof USUAL>} */
  get chosen() {
    return this.#chosen;
  }

  /** Choose; another mode brings the convergence that suits it. @param {Partial<typeof USUAL>} what */
  choose(what) {
    const suited = what.mode ? { convergence: SUITS[what.mode] } : {};
    this.#chosen = { ...this.#chosen, ...suited, ...what };
    localStorage.setItem(PLACE, JSON.stringify(this.#chosen));
    this.dispatchEvent(new Event("change"));
  }
}

function remembered() {
  try {
    const found = Object.entries(JSON.parse(localStorage.getItem(PLACE) ?? "{}"));
    return Object.fromEntries(found.filter(([name, value]) => IS_VALID[name]?.(value)));
  } catch {
    return {};
  }
}
