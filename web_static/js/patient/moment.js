/**
 * The large word at the start and at the end of a trial: rest, go, goal reached.
 * @import { ScreenStore } from "./store.js"
 */
import { h } from "../preact.js";
import { t } from "../texts.js";

/** The look of a word; the others have none of their own. @type {Record<string, string>} */
const TONES = { go: "go", goal: "good" };

/** @param {Pick<ScreenStore, "moment">} card */
export function Moment({ moment }) {
  const { word, waits } = moment.value;
  const why = { rest: waits, goal: t("patient-goal-why"), ended: t("patient-ended-why"), go: "", "": "" }[word];
  return h(
    "div",
    { class: "moment", "aria-live": "polite" },
    word !== "" &&
      h(
        "div",
        { key: word, class: `hud ${TONES[word] ?? ""}` },
        h("div", { class: "word" }, t(`patient-${word}`)),
        why && h("p", {}, why),
      ),
  );
}
