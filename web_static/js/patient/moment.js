/** The large word at the start and at the end of a trial: rest, go, goal reached. */
import { h, put } from "../widgets/dom.js";
import { t } from "../texts.js";

const GO_FOR = 1600; // ms
const OVER_FOR = 8000; // ms

/** @typedef {import("./message.js").PatientMessage} PatientMessage */

export function momentCard() {
  const element = h("div", { class: "moment", "aria-live": "assertive" });
  let word = "";
  let until = 0;
  /** @type {PatientMessage | null} */
  let before = null;
  /** @param {string} name of the word; empty: none */
  const say = (name, why = "", tone = "") => {
    if (word === name) return;
    word = name;
    put(
      element,
      name &&
        h(
          "div",
          { class: `hud ${tone}` },
          h("div", { class: "word" }, t(`patient.${name}`)),
          why && h("p", {}, why),
        ),
    );
  };
  /** @param {PatientMessage} now */
  const show = (now) => {
    const over = before && now.over?.id !== before.over?.id ? now.over : null;
    const begins = before && now.state === "armed" && before.state !== "armed";
    before = now;
    if (now.state === "fault" || now.cue) say("");
    else if (now.state === "checking") say("rest", now.waits.words);
    else if (over) {
      const name = over.end === "goal" ? "goal" : "ended";
      say(name, t(`patient.${name}.why`), name === "goal" ? "good" : "");
      until = performance.now() + OVER_FOR;
    } else if (begins) {
      say("go", "", "go");
      until = performance.now() + GO_FOR;
    } else if (performance.now() > until || word === "rest") say("");
  };
  return { element, show };
}
