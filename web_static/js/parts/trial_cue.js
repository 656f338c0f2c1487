/** What stands over the 3D view: the starting cue, and what to do after a stop or fault. */
import { t } from "../texts.js";
import { h, put, write } from "./dom.js";
import { clock } from "./format.js";
import { icon } from "./icons.js";
import { continueButton, faultKey } from "./notices.js";

const LONG = 6; // letters; longer words are written smaller
const GO_SHOWN = 1600; // ms

/** @param {import("../main.js").App} app @param {() => Promise<void>} onEnd */
export function trialCue(app, onEnd) {
  const element = h("div", { class: "over-view", "aria-live": "assertive" });
  const waits = waitWords("trial.paused");
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
    waits.show(now.trial?.waits);
    const key = now.control !== "alive" ? "control" : now.fault ? faultKey(now) : now.state;
    if (key === shown) return;
    clearTimeout(timer);
    const before = shown;
    shown = key;
    if (now.fault && now.control === "alive") put(element, overView(app, now.fault, waits.element, onEnd));
    else if (key === "checking") put(element, word(t("trial.rest"), t("trial.rest.why")));
    else if (key === "armed" && before !== "start") {
      put(element, word(t("trial.go"), "", "go"));
      timer = setTimeout(() => put(element), GO_SHOWN);
    } else if (key !== "disarmed" || before !== "start") put(element);
  };
  return { element, show };
}

function overView(app, fault, waits, onEnd) {
  const end = h("button", { type: "button", class: "btn", onclick: onEnd }, t("trial.end"));
  return faultCard(app, fault, waits, end);
}

/**
 * For how much longer a halted trial or drive waits for Continue: counted down for the eye, and read out once.
 * @param {string} key of the words
 */
export function waitWords(key) {
  const left = h("b", { class: "number", role: "timer" });
  const element = h("p", { class: "waits" }, t(key), " ", left);
  return { element, show: (seconds) => write(left, clock(seconds)) };
}

/** What happened, what to do, Continue, and how to end. @param {import("../main.js").App} app @param {{happened: string, next_step: string}} fault @param {Node} waits @param {Node} end */
export function faultCard(app, { happened, next_step: next }, waits, end) {
  return h(
    "div",
    { class: "hud fault-card" },
    h("h2", {}, icon("warning", 28), happened),
    h("p", {}, next),
    waits,
    h("div", { class: "spread" }, continueButton(app), end),
  );
}
