/** How strong a signal is, and how well a movement repeats, in words; the limits are those of app/calibration/grades.py. */
import { t } from "../texts.js";

const SIGNAL = { strong: 8, fair: 4 }; // times above the noise
const SPREAD = { well: 0.3, fairly: 0.6 }; // of the repetitions' peaks

/** @param {number} signalToNoise */
export function signalWord(signalToNoise) {
  return t(`signal.${signalToNoise >= SIGNAL.strong ? "strong" : signalToNoise >= SIGNAL.fair ? "fair" : "weak"}`);
}

/** @param {number} spread */
export function repeatsWord(spread) {
  return t(`repeats.${spread <= SPREAD.well ? "well" : spread <= SPREAD.fairly ? "fairly" : "poorly"}`);
}
