/** The large word at the start and at the end of a trial: rest, go, goal reached. */
import { h, put } from "../widgets/dom.js";
import { t } from "../texts.js";
import { momentWords } from "./moment_word.js";

/** The look of a word; the others have none of their own. @type {Record<string, string>} */
const TONES = { go: "go", goal: "good" };

/** @typedef {import("../live/live.js").PatientMessage} PatientMessage */

export function momentCard() {
  const element = h("div", { class: "moment", "aria-live": "polite" });
  const wordOf = momentWords();
  let word = "";
  /** @param {PatientMessage} now */
  const show = (now) => {
    const next = wordOf(now, performance.now());
    if (next === word) return;
    word = next;
    const why = { rest: now.waits.message, goal: t("patient-goal-why"), ended: t("patient-ended-why"), go: "", "": "" }[
      next
    ];
    put(
      element,
      next &&
        h(
          "div",
          { class: `hud ${TONES[next] ?? ""}` },
          h("div", { class: "word" }, t(`patient-${next}`)),
          why && h("p", {}, why),
        ),
    );
  };
  return { element, show };
}
