/** What stands over the 3D view: the starting cue, and what to do after a stop or fault. */
import { t } from "../texts.js";
import { h, put } from "./dom.js";
import { icon } from "./icons.js";
import { continueButton } from "./notices.js";

const LONG = 6; // letters; longer words are written smaller
const GO_SHOWN = 1600; // ms

/** @param {import("../main.js").App} app @param {() => Promise<void>} onEnd */
export function trialCue(app, onEnd) {
  const element = h("div", { class: "over-view", "aria-live": "assertive" });
  let shown = "start";
  let timer = 0;
  const word = (big, small, tone = "") =>
    h(
      "div",
      { class: `hud cue-card ${tone}` },
      h("div", { class: big.length > LONG ? "huge long" : "huge" }, big),
      small && h("p", {}, small),
    );
  put(element, word(t("trial.moment"), t("trial.moment.why")));
  const show = (now) => {
    const key = now.control !== "alive" ? "control" : now.fault ? `fault ${now.fault.name}` : now.state;
    if (key === shown) return;
    clearTimeout(timer);
    const before = shown;
    shown = key;
    if (now.fault && now.control === "alive") put(element, faultCard(app, now.fault, onEnd));
    else if (key === "checking") put(element, word(t("trial.rest"), t("trial.rest.why")));
    else if (key === "armed" && before !== "start") {
      put(element, word(t("trial.go"), "", "go"));
      timer = setTimeout(() => put(element), GO_SHOWN);
    } else if (key !== "disarmed" || before !== "start") put(element);
  };
  return { element, show };
}

function faultCard(app, { happened, next_step: next }, onEnd) {
  return h(
    "div",
    { class: "hud fault-card" },
    h("h2", {}, icon("warning", 28), happened),
    h("p", {}, next),
    h("p", { class: "quiet small" }, t("trial.paused")),
    h(
      "div",
      { class: "spread" },
      continueButton(app),
      h("button", { type: "button", class: "btn", onclick: onEnd }, t("trial.end")),
    ),
  );
}
