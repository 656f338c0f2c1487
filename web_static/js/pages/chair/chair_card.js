/**
 * The real chair as it tells of itself, live: state in words, battery, stop switch, how old its last answer is, speeds.
 * @import { ChairMoment } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
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
 * @param {{
 *   chair: ReadonlySignal<ChairMoment | null>,
 *   latest?: ReadonlySignal<LiveMessage | null>,
 *   step?: number,
 * }} card
 *   latest: the newest live picture, whose commanded speeds stand above what the chair does
 *   step: its number before arming, where another list says why the chair does not drive
 */
export function ChairCard({ chair: { value: chair }, latest, step }) {
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
    h(FactList, { facts: chair ? [...commandedFacts(latest?.value ?? null), ...factsOf(chair)] : [] }),
    !step && h("p", { class: "why", role: "status" }, chair && whyNot(chair)),
  );
}

/** @param {LiveMessage | null} now @returns {[string, string][]} */
function commandedFacts(now) {
  return now ? [[t("chair-commanded"), speedWords(now.v ?? 0, now.omega ?? 0)]] : [];
}

/** @param {number} v m/s @param {number} omega rad/s */
function speedWords(v, omega) {
  return t("chair-drives-value", { v: number(v, 2), omega: number(omega * DEGREES, 0) });
}

/** @param {ChairMoment} chair @returns {[string, string][]} */
function factsOf({ state, v, omega, measured: isMeasured, battery, stop_input: isPressed, age }) {
  /** The last report of a silent chair does not tell how it is now. @param {string} words */
  const current = (words) => (state === "silent" ? number(null, 0) : words);
  return [
    [t(isMeasured ? "chair-measured" : "chair-drives"), current(speedWords(v, omega))],
    [t("chair-battery"), current(battery === null ? t("chair-battery-unknown") : percent(battery))],
    [t("chair-switch"), current(t(isPressed ? "chair-switch-pressed" : "chair-switch-released"))],
    [t("chair-age"), age === null ? t("chair-never") : ageWords(age)],
  ];
}

/** @param {ChairMoment} chair */
function whyNot({ stop_input: isPressed, own_joystick: isMoved, message, state }) {
  if (isPressed && state !== "silent") return t("chair-switch-why");
  if (isMoved && state !== "silent") return t("chair-joystick-why");
  return state === "silent" || state === "fault" ? message : "";
}

/** @param {number} age s */
function ageWords(age) {
  if (age < JUST_NOW) return t("chair-now");
  return t("chair-age-value", { age: number(age, age < 10 ? 1 : 0) });
}
