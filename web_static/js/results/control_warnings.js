/**
 * Warnings of the quality of control: what was seen, what to do, and on which page.
 * @import { ControlWarning } from "types/api"
 */
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";

const WHERE = { sensor: "#/shirt", map: "#/calibrate", noise: "#/controls", span: "#/calibrate" };

/**
 * @param {ControlWarning[]} warnings
 * @param {boolean} mayChange whether to lead to the pages @param {boolean} [isOpen] at first; otherwise a tap opens it
 * @returns {HTMLElement | false} nothing when there is nothing to look at
 */
export function controlWarnings(warnings, mayChange, isOpen = true) {
  if (!warnings.length) return false;
  return h(
    "details",
    { class: "card control-warnings", open: isOpen },
    h("summary", {}, h("h2", {}, t("quality-warnings", { count: together(warnings).length })), summaryOf(warnings)),
    h(
      "ul",
      {},
      together(warnings).map(([first, ...others]) =>
        h(
          "li",
          {},
          [first, ...others].map(({ message }) => h("p", {}, message)),
          h("p", { class: "quiet" }, h("strong", {}, t("quality-do")), " ", first.advice),
          mayChange && h("a", { class: "btn small", href: WHERE[first.kind] }, t(`quality-go-${first.kind}`)),
        ),
      ),
    ),
  );
}

/** The kinds and joints of the warnings in one line. @param {ControlWarning[]} warnings */
function summaryOf(warnings) {
  const parts = together(warnings).map((same) => {
    const joints = [...new Set(same.map(({ joint }) => joint))].join(", ");
    return t(`quality-kind-${same[0].kind}`, { joints });
  });
  return h("span", { class: "quiet small" }, parts.join(" · "));
}

/** Group the warnings with the same advice, so that it is given once. @param {ControlWarning[]} warnings */
function together(warnings) {
  return [...new Set(warnings.map(({ advice }) => advice))].map((same) =>
    warnings.filter(({ advice }) => advice === same),
  );
}

/**
 * A place that fills itself with a patient's warnings, anew after each trial; empty when there are none, or none can be read.
 * @param {import("../main.js").App} app @param {number} patient @param {AbortSignal} signal
 */
export function warningsPlace(app, patient, signal) {
  const place = h("div", { class: "control-warnings-place" });
  let shown = "[]";
  const read = async () => {
    const { warnings } = await app.api.get(`/patients/${patient}/quality`);
    const found = JSON.stringify(warnings);
    if (signal.aborted || found === shown) return; // what was opened stays open
    shown = found;
    put(place, controlWarnings(warnings, app.me?.role !== "reviewer", false));
  };
  const tryToRead = () => read().catch(() => {}); // the page works without the warnings
  app.live.addEventListener("changed", ({ detail }) => detail === "trial" && tryToRead(), { signal });
  tryToRead();
  return place;
}
