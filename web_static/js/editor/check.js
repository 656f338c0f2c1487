/** Asks the application, a moment after the last change, whether a plan can be driven in. */
import { t } from "../texts.js";

const WAIT = 400; // ms

/**
 * @param {import("../main.js").App} app
 * @param {(answer: {good: boolean, begun?: boolean, sentence: string, place: any[], at: any}) => void} onAnswer
 */
export function checker(app, onAnswer) {
  let timer = 0;
  let asked = 0;
  const ask = async (plan) => {
    const mine = ++asked;
    if (!plan.paths.length)
      return onAnswer({ good: false, begun: true, sentence: t("editor.no-path"), place: [], at: null });
    try {
      const answer = await app.api.post("/floorplans/check", plan);
      if (mine === asked) onAnswer(answer);
    } catch (error) {
      if (mine === asked) onAnswer({ good: false, sentence: error.message, place: [], at: null });
    }
  };
  return {
    /** @param {any} plan */
    later(plan) {
      clearTimeout(timer);
      asked += 1; // what was asked about an older plan is not told any more
      timer = setTimeout(() => ask(plan), WAIT);
    },
    end() {
      clearTimeout(timer);
      asked += 1;
    },
  };
}

/** The thing of a plan that an answer is about. @param {any[]} place */
export function refOf(place) {
  const [list, index] = place;
  return typeof list === "string" && typeof index === "number" ? { list, index } : null;
}
