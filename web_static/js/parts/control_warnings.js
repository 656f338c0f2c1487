/** What the clinician had better look at, calmly: what was seen, what to do, and where. */
import { t } from "../texts.js";
import { h } from "./dom.js";

const WHERE = { sensor: "#/shirt", map: "#/calibrate", noise: "#/controls", span: "#/calibrate" };

/**
 * @param {{kind: string, words: string, advice: string}[]} warnings @param {boolean} mayChange whether to lead to the pages
 * @returns {HTMLElement | false} nothing when there is nothing to look at
 */
export function controlWarnings(warnings, mayChange) {
  if (!warnings.length) return false;
  return h(
    "section",
    { class: "card control-warnings" },
    h("h2", {}, t("quality.warnings", { count: warnings.length })),
    h(
      "ul",
      {},
      warnings.map(({ kind, words, advice }) =>
        h(
          "li",
          {},
          h("p", {}, h("strong", {}, words)),
          h("p", {}, t("quality.do"), " ", advice),
          mayChange && h("a", { class: "btn small", href: WHERE[kind] }, t(`quality.go.${kind}`)),
        ),
      ),
    ),
  );
}

/**
 * A place that fills itself with a patient's warnings; it stays empty when there are none, or none can be read.
 * @param {import("../main.js").App} app @param {number} patient @param {AbortSignal} signal
 */
export function warningsPlace(app, patient, signal) {
  const place = h("div", { class: "control-warnings-place" });
  app.api
    .get(`/patients/${patient}/quality`)
    .then(({ warnings }) => {
      const shown = !signal.aborted && controlWarnings(warnings, app.me.role !== "reviewer");
      if (shown) place.append(shown);
    })
    .catch(() => {}); // the page itself does not depend on it
  return place;
}
