/**
 * For how many years after the last session records must be kept.
 * @import { BackupsView } from "types/api"
 */
import { numberLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {BackupsView} kept @param {(view: BackupsView) => void} onSaved */
export function recordTimeCard(app, kept, onSaved) {
  const years = h("input", {
    type: "number",
    ...numberLimits("RecordTime", "years"),
    step: 1,
    value: kept.years ?? "",
  });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    write(problem, "");
    try {
      onSaved(await app.api.put("/record-keeping", { years: years.value ? Number(years.value) : null }));
      app.toasts.show(t("backup-saved"));
    } catch (error) {
      write(problem, failureWords(error));
    }
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("records-title")),
    h(
      "form",
      { class: "stack", onsubmit: submit },
      field(t("records-years"), years, t("records-years-hint")),
      problem,
      h("div", {}, h("button", { class: "btn" }, t("backup-save"))),
    ),
  );
}
