/** The form for a new patient. */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";

/**
 * @param {import("../../main.js").App} app
 * @param {{onAdded: (patient: import("types/api").PatientView) => void, onClose: () => void}} then
 */
export function newPatientForm(app, { onAdded, onClose }) {
  const code = h("input", {
    type: "text",
    required: true,
    ...textLimits("NewPatient", "code"),
    pattern: "[A-Za-z0-9][A-Za-z0-9_.\\-]*",
    autocomplete: "off",
  });
  const pseudonym = h("input", {
    type: "text",
    required: true,
    ...textLimits("NewPatient", "pseudonym"),
    autocomplete: "off",
  });
  const note = h("input", { type: "text", ...textLimits("NewPatient", "note"), autocomplete: "off" });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      const words = { code: code.value.trim(), pseudonym: pseudonym.value.trim(), note: note.value.trim() };
      onAdded(await app.api.post("/patients", words));
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  return h(
    "form",
    { class: "card new-patient", onsubmit: submit },
    h("h2", {}, t("patients-new-title")),
    h(
      "div",
      { class: "columns" },
      field(t("patients-code"), code, t("patients-code-hint")),
      field(t("patients-pseudonym"), pseudonym, t("patients-pseudonym-hint")),
      field(t("patients-note"), note, t("patients-note-hint")),
    ),
    problem,
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("patients-add")),
      h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel")),
    ),
  );
}
