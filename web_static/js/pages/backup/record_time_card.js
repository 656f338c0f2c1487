/** For how many years after the last session records must be kept. */
import { numberLimits } from "../../reference.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

/** @param {{store: import("./store.js").BackupStore}} card */
export function RecordTimeCard({ store: { app, view, change } }) {
  const problem = useSignal("");
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    const entered = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget)).get("years");
    problem.value = "";
    problem.value = await change(() => app.api.put("/record-keeping", { years: entered ? Number(entered) : null }));
    if (!problem.value) app.toasts.show(t("backup-saved"));
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("records-title")),
    h(
      "form",
      { class: "stack", onSubmit: submit },
      h(
        Field,
        { label: t("records-years"), hint: t("records-years-hint") },
        h("input", {
          name: "years",
          type: "number",
          ...numberLimits("RecordTime", "years"),
          step: 1,
          defaultValue: view.value.years === null ? "" : String(view.value.years),
        }),
      ),
      h("p", { class: "problem", role: "alert" }, problem),
      h("div", {}, h("button", { class: "btn" }, t("backup-save"))),
    ),
  );
}
