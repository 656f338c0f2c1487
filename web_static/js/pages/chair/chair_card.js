/**
 * The real chair as it tells of itself, live: state in words, battery, stop switch, how old its last answer is, speeds.
 * @import { ChairMoment } from "types/api"
 * @import { ReadonlySignal } from "../../preact.js"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { FactList } from "../../widgets/fact_list.js";
import { number, percent } from "../../widgets/format.js";

const JUST_NOW = 0.2; // s: it tells every 0.1 s
const DEGREES = 180 / Math.PI;
const TONES = { silent: "bad", fault: "bad", disarmed: "plain", checking: "att", armed: "" };

/**
 * @param {{chair: ReadonlySignal<ChairMoment | null>, step?: number}} card
 *   step: its number before arming, where another list says why the chair does not drive
 */
export function ChairCard({ chair: { value: chair }, step }) {
  return h(
    "section",
    { class: "card" },
    h(
      "h2",
      {},
      step && h("span", { class: "step-number" }, step),
      t("chair-card"),
      h("span", { class: chair ? `tag ${TONES[chair.state]}` : "tag" }, chair && t(`chair-state-${chair.state}`)),
    ),
    h(FactList, { facts: chair ? factsOf(chair) : [] }),
    !step && h("p", { class: "why", role: "status" }, chair && whyNot(chair)),
  );
}

/** @param {ChairMoment} chair @returns {[string, string][]} */
function factsOf({ state, v, omega, battery, stop_input: isPressed, age }) {
  /** The last report of a silent chair does not tell how it is now. @param {string} words */
  const current = (words) => (state === "silent" ? number(null, 0) : words);
  const twist = { v: number(v, 2), omega: number(omega * DEGREES, 0) };
  return [
    [t("chair-drives"), current(t("chair-drives-value", twist))],
    [t("chair-battery"), current(battery === null ? t("chair-battery-unknown") : percent(battery))],
    [t("chair-switch"), current(t(isPressed ? "chair-switch-pressed" : "chair-switch-released"))],
    [t("chair-age"), age === null ? t("chair-never") : ageWords(age)],
  ];
}

/** @param {ChairMoment} chair */
function whyNot({ stop_input: isPressed, message, state }) {
  if (isPressed && state !== "silent") return t("chair-switch-why");
  return state === "silent" || state === "fault" ? message : "";
}

/** @param {number} age s */
function ageWords(age) {
  if (age < JUST_NOW) return t("chair-now");
  return t("chair-age-value", { age: number(age, age < 10 ? 1 : 0) });
}
