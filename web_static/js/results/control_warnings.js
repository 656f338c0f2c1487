/**
 * Warnings of the quality of control: what was seen, what to do, and on which page.
 * @import { ControlWarning } from "types/api"
 */
import { newestAnswer } from "../live/newest_answer.js";
import { h, render } from "../preact.js";
import { t } from "../texts.js";

const WHERE = { sensor: "#/shirt", map: "#/calibrate", noise: "#/controls", span: "#/calibrate" };

/**
 * The warnings; nothing when there is nothing to look at.
 * @param {{warnings: ControlWarning[], mayChange: boolean, isOpen?: boolean}} card
 *   mayChange: whether to lead to the pages; isOpen: at first, otherwise a tap opens it
 */
export function ControlWarnings({ warnings, mayChange, isOpen = true }) {
  const groups = [...Map.groupBy(warnings, ({ advice }) => advice).values()]; // each advice is given once
  if (!groups.length) return null;
  /** @param {ControlWarning[]} group */
  const item = (group) => {
    const [{ advice, kind }] = group;
    return h(
      "li",
      { key: advice },
      group.map(({ message }) => h("p", { key: message }, message)),
      h("p", { class: "quiet" }, h("strong", {}, t("quality-do")), " ", advice),
      mayChange && h("a", { class: "btn small", href: WHERE[kind] }, t(`quality-go-${kind}`)),
    );
  };
  return h(
    "details",
    { class: "card control-warnings", open: isOpen },
    h(
      "summary",
      {},
      h("h2", {}, t("quality-warnings", { count: groups.length })),
      h("span", { class: "quiet small" }, groups.map(kindWords).join(" · ")),
    ),
    h("ul", {}, groups.map(item)),
  );
}

/** What some warnings with the same advice are about. @param {ControlWarning[]} group */
function kindWords(group) {
  const joints = [...new Set(group.map(({ joint }) => joint))].join(", ");
  return t(`quality-kind-${group[0].kind}`, { joints });
}

/**
 * A place that fills itself with a patient's warnings, read again after each trial; empty when there are none, or none
 * can be read.
 * @param {import("../main.js").App} app @param {number} patient id @param {AbortSignal} left
 */
export function warningsPlace(app, patient, left) {
  const place = document.createElement("div");
  place.className = "control-warnings-place";
  const mayChange = app.me?.role !== "reviewer";
  const ask = async () => (await app.api.get(`/patients/${patient}/quality`)).warnings;
  const warnings = newestAnswer(app, left, /** @type {ControlWarning[]} */ ([]), ask, { what: ["trial"], patient });
  const Warnings = () => h(ControlWarnings, { warnings: warnings.value, mayChange, isOpen: false });
  render(h(Warnings, {}), place);
  ask().then(
    (first) => (warnings.value = first),
    () => {}, // the page works without the warnings
  );
  return place;
}
