/** The real chair as it tells of itself, live: state in words, battery, stop switch, how old its last answer is, speeds. */
import { t } from "../texts.js";
import { h, write } from "./dom.js";
import { facts } from "./facts.js";
import { number, percent } from "./format.js";

const JUST_NOW = 0.2; // s: it tells every 0.1 s
const DEGREES = 180 / Math.PI;
const TONES = { silent: "bad", fault: "bad", disarmed: "plain", checking: "att", armed: "" };

/**
 * @import { ChairMoment } from "types/api"
 */

/**
 * @param {import("../live/live.js").Live} live @param {AbortSignal} signal
 * @param {{hasWhy?: boolean}} [options] whether it says why the chair does not drive
 */
export function chairCard(live, signal, { hasWhy = true } = {}) {
  const tag = h("span", { class: "tag" });
  const list = facts(["chair-drives", "chair-battery", "chair-switch", "chair-age"]);
  const why = h("p", { class: "why", role: "status" });
  const show = () => {
    const chair = live.latest?.chair;
    if (!chair) return;
    const { state } = chair;
    tag.className = `tag ${TONES[state]}`;
    write(tag, t(`chair-state-${state}`));
    write(why, whyNot(chair));
    // The last report of a silent chair does not tell how it is now.
    /** @param {string} words */
    const current = (words) => (state === "silent" ? number(null, 0) : words);
    const twist = { v: number(chair.v, 2), omega: number(chair.omega * DEGREES, 0) };
    list.write("chair-drives", current(t("chair-drives-value", twist)));
    list.write("chair-battery", current(chair.battery === null ? t("chair-battery-unknown") : percent(chair.battery)));
    list.write("chair-switch", current(t(chair.stop_input ? "chair-switch-pressed" : "chair-switch-released")));
    list.write("chair-age", chair.age === null ? t("chair-never") : ageWords(chair.age));
  };
  live.addEventListener("tick", show, { signal });
  const title = h("h2", {}, t("chair-card"), tag);
  const element = h("section", { class: "card" }, title, list.element, hasWhy && why);
  show();
  return { element, title };
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
