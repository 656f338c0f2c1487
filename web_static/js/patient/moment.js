/** The large word of a moment: rest, go, goal reached. */
import { h, put } from "../widgets/dom.js";
import { t } from "../texts.js";

const GO_SHOWN = 1600; // ms
const OVER_SHOWN = 8000; // ms

export function momentCard() {
  const element = h("div", { class: "moment", "aria-live": "assertive" });
  let shown = "";
  let until = 0;
  /** @type {any} */
  let before = null;
  const say = (name, why = "", tone = "") => {
    if (shown === name) return;
    shown = name;
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
  /** @param {any} now a message */
  const show = (now) => {
    const isNew = before && now.over && now.over.id !== before.over?.id;
    const begins = before && now.state === "armed" && before.state !== "armed";
    before = now;
    if (now.state === "fault" || now.cue) say("");
    else if (now.state === "checking") say("rest", now.waits.words);
    else if (isNew) {
      const name = now.over.end === "goal" ? "goal" : "ended";
      say(name, t(`patient.${name}.why`), name === "goal" ? "good" : "");
      until = performance.now() + OVER_SHOWN;
    } else if (begins) {
      say("go", "", "go");
      until = performance.now() + GO_SHOWN;
    } else if (performance.now() > until || shown === "rest") say("");
  };
  return { element, show };
}
