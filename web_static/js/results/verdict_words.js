/**
 * The verdict on a measure in words: better than noise, within noise, worse than noise, too few trials.
 * @import { TrialVerdicts, Verdict } from "types/api"
 * @typedef {{words: string, arrow: string, amount: string, noise: string, tone: "good" | "bad" | ""}} VerdictWords
 */
import { h } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { number } from "../widgets/format.js";
import { entryOf, figure, joined, REACHED, signedWithUnit } from "./measures.js";

/** @type {Record<Verdict["word"], VerdictWords["tone"]>} */
const TONES = { better: "good", within: "", worse: "bad", "too few": "", number: "" };

/**
 * A change within noise has neither an arrow nor an amount: there is nothing to be seen in it.
 * @param {string} name of the measure @param {Verdict | undefined} verdict none where a measure cannot be compared
 * @returns {VerdictWords | null}
 */
export function verdictWords(name, verdict) {
  if (!verdict) return null;
  const { word, earlier, later, low, high } = verdict;
  const difference = (later ?? NaN) - (earlier ?? NaN);
  const isChange = TONES[word] !== "";
  return {
    words: REFERENCE.measures.verdicts[word],
    arrow: isChange ? (difference < 0 ? "↓" : "↑") : "",
    amount: isChange && name !== REACHED ? signedWithUnit(name, difference) : "",
    noise:
      low === null
        ? "–"
        : joined(t("verdict-range", { low: figure(name, low), high: figure(name, high) }), entryOf(name).unit),
    tone: TONES[word],
  };
}

/** A verdict in one line: "↓ −1.20 m² better than noise". @param {VerdictWords} said */
export function verdictLine({ arrow, amount, words }) {
  return [arrow, amount, words].filter(Boolean).join(" ");
}

/** A share of trials. @param {number | null} share */
export function shareWords(share) {
  return joined(number(100 * (share ?? NaN), 0), "%");
}

/** Whether a person got used to the task in this trial. @param {TrialVerdicts | null} found @param {number} trial id */
export function isFamiliarisation(found, trial) {
  return !!found?.familiarisation.includes(trial);
}

/** What noise is, and that nobody has published a limit for it. */
export function NoiseNote() {
  const words = ["means", "chance", "missed", "unpublished"].map((name) => t(`verdict-${name}`)).join(" ");
  return h("p", { class: "quiet small noise-note" }, words);
}
