/** The form for a new patient. */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

const FIELDS = {
  code: { required: true, pattern: "[A-Za-z0-9][A-Za-z0-9_.\\-]*" },
  pseudonym: { required: true },
  note: {},
};

/** @param {{app: import("../../main.js").App, onAdded: (patient: import("types/api").PatientView) => void, onClose: () => void}} form */
export function NewPatientForm({ app, onAdded, onClose }) {
  const problem = useSignal("");
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.value = "";
    const entries = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    /** @param {keyof typeof FIELDS} name */
    const entry = (name) => String(entries.get(name)).trim();
    try {
      const patient = { code: entry("code"), pseudonym: entry("pseudonym"), note: entry("note") };
      onAdded(await app.api.post("/patients", patient));
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  return h(
    "form",
    { class: "card new-patient", onSubmit: submit },
    h("h2", {}, t("patients-new-title")),
    h(
      "div",
      { class: "columns" },
      Object.entries(FIELDS).map(([name, attributes]) =>
        h(
          Field,
          {
            key: name,
            label: t(`patients-${name}`),
            hint: t(`patients-${name}-hint`),
          },
          h("input", {
            type: "text",
            name,
            ...textLimits("NewPatient", name),
            autocomplete: "off",
            ...attributes,
          }),
        ),
      ),
    ),
    h("p", { class: "problem", role: "alert" }, problem.value),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("patients-add")),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
