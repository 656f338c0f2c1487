/** How strong a signal is, and how well a movement repeats, in words. */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";

/** @param {number} signalToNoise */
export function signalWord(signalToNoise) {
  const [strong, fair] = REFERENCE.numbers.signal_to_noise;
  return t(`signal-${signalToNoise >= strong ? "strong" : signalToNoise >= fair ? "fair" : "weak"}`);
}

/** @param {number} spread */
export function repeatsWord(spread) {
  const [well, fairly] = REFERENCE.numbers.spread;
  return t(`repeats-${spread <= well ? "well" : spread <= fairly ? "fairly" : "poorly"}`);
}
