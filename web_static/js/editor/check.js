/** Asks the server, a moment after the last change, whether a plan can be driven in. */
import { failureWords } from "../api.js";
import { t } from "../texts.js";
import { LISTS } from "./document.js";

const WAIT = 400; // ms

/**
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("types/api").CheckView & {isIncomplete?: boolean}} Verdict isIncomplete: not yet a plan to judge
 */

/** @param {import("../main.js").App} app @param {(verdict: Verdict) => void} onVerdict */
export function checker(app, onVerdict) {
  let timer = 0;
  let newest = 0; // number of the newest request
  /** @param {Plan} plan */
  const ask = async (plan) => {
    const mine = ++newest;
    if (!plan.paths.length)
      return onVerdict({ good: false, isIncomplete: true, sentence: t("editor-no-path"), place: [], at: null });
    try {
      const answer = await app.api.post("/floorplans/check", plan);
      if (mine === newest) onVerdict(answer);
    } catch (error) {
      if (mine === newest) onVerdict({ good: false, sentence: failureWords(error), place: [], at: null });
    }
  };
  return {
    /** @param {Plan} plan */
    later(plan) {
      clearTimeout(timer);
      newest += 1; // answers about an older plan are not reported any more
      timer = setTimeout(() => ask(plan), WAIT);
    },
    end() {
      clearTimeout(timer);
      newest += 1;
    },
  };
}

/**
 * The item of a plan that a verdict names.
 * @param {Verdict["place"]} place @returns {import("./document.js").Ref | null}
 */
export function refAt([name, index]) {
  const list = LISTS.find((one) => one === name);
  return list && typeof index === "number" ? { list, index } : null;
}
