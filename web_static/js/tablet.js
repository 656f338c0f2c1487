/** The page that explains how a device learns to trust the clinic's machine, and that checks whether it does. */
import { h, put } from "./widgets/dom.js";
import { dayAndTime } from "./widgets/format.js";
import { followSystem } from "./shell/theme.js";
import { check } from "./tablet/check.js";
import { DEVICES, deviceOf, stepList } from "./tablet/steps.js";
import { signPicture } from "./tablet/pictures.js";
import { t } from "./tablet/texts.js";

/** @typedef {import("./tablet/check.js").Finding} Finding */

const EVERY = 3000; // ms between two checks
const APART = 120_000; // ms by which clocks may disagree without a word

let device = deviceOf(navigator);
let shown = "";
const result = h(
  "section",
  { class: "check", role: "status" },
  signPicture("waiting"),
  h("h2", {}, t("tablet-checking")),
);
const steps = h("section", {});
const fingerprint = h("p", { class: "fingerprint" });

/** Show the steps for the chosen device. */
function showSteps() {
  put(
    steps,
    h("h2", {}, t("tablet-device")),
    h(
      "div",
      { class: "devices" },
      DEVICES.map((each) =>
        h(
          "button",
          { type: "button", "aria-pressed": String(each === device), onclick: () => choose(each) },
          t(`tablet-${each}`),
        ),
      ),
    ),
    stepList(device),
  );
}

/** @param {import("./tablet/steps.js").Device} chosen */
function choose(chosen) {
  device = chosen;
  showSteps();
  const pressed = steps.querySelector('[aria-pressed="true"]');
  if (pressed instanceof HTMLElement) pressed.focus();
}

/** @param {Finding} finding */
function showResult({ state, facts, apart }) {
  const apartWords =
    facts &&
    state !== "clock" &&
    Math.abs(apart) > APART &&
    t("tablet-clock-apart", { minutes: String(Math.round(Math.abs(apart) / 60_000)) });
  const key = `${state} ${facts?.link} ${apartWords}`;
  if (key === shown) return; // a screen reader would read it again
  shown = key;
  result.dataset.state = state;
  put(
    result,
    signPicture(state === "trusted" || state === "clock" ? state : "waiting"),
    h(
      "div",
      {},
      h("h2", {}, t(`tablet-${state}`)),
      h("p", {}, leadOf(state, facts)),
      apartWords && h("p", {}, apartWords),
    ),
    state === "trusted" && facts && h("a", { class: "go", href: facts.link }, t("tablet-go")),
  );
  steps.hidden = state === "trusted";
  put(fingerprint, facts?.installs && [t("tablet-fingerprint"), " ", (facts.fingerprint.match(/../g) ?? []).join(":")]);
}

/** @param {Finding["state"]} state @param {Finding["facts"]} facts */
function leadOf(state, facts) {
  if (!facts) return t("tablet-lost-lead");
  if (state === "not-yet" && !facts.installs) return t("tablet-not-yet-own", { link: facts.link });
  return t(`tablet-${state}-lead`, {
    here: dayAndTime(Date.now()),
    there: dayAndTime(facts.now),
    start: dayAndTime(facts.start),
    end: dayAndTime(facts.end),
  });
}

/** Check now and again, until this device trusts the machine. */
async function keepChecking() {
  const finding = await check();
  showResult(finding);
  if (finding.state !== "trusted") setTimeout(keepChecking, EVERY);
}

followSystem();
showSteps();
put(
  /** @type {HTMLElement} */ (document.getElementById("main")),
  h("h1", {}, t("tablet-title")),
  h("p", { class: "lead" }, t("tablet-lead")),
  result,
  steps,
  fingerprint,
);
keepChecking();
