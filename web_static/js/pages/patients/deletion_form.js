/** The form that asks why a patient is deleted, while the records must be kept. */
import { failureWords } from "../../api.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

/** @param {{message: string, send: (reason: string) => Promise<unknown>, onClose: () => void}} form message: why a reason is needed */
export function DeletionForm({ message, send, onClose }) {
  const problem = useSignal("");
  /** @param {SubmitEvent} event */
  const submit = (event) => {
    event.preventDefault();
    const { reason } = Object.fromEntries(new FormData(/** @type {HTMLFormElement} */ (event.currentTarget)));
    return send(String(reason).trim()).catch((error) => (problem.value = failureWords(error)));
  };
  return h(
    "form",
    { class: "card stack", onSubmit: submit },
    h("p", {}, message),
    h(
      Field,
      {
        label: t("deleted-reason"),
        hint: t("deleted-reason-hint"),
      },
      h("input", { type: "text", name: "reason", required: true, minlength: 3, maxlength: 400 }),
    ),
    h("p", { class: "problem", role: "alert" }, problem.value),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("deleted-reason-go")),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
