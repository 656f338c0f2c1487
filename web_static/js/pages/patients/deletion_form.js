/** The form that asks why a patient is deleted, while the records must be kept. */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";

/**
 * @param {string} words why a reason is needed
 * @param {{send: (reason: string) => Promise<unknown>, onClose: () => void}} then
 */
export function deletionForm(words, { send, onClose }) {
  const reason = h("input", { type: "text", required: true, minlength: 3, maxlength: 400 });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    try {
      await send(reason.value.trim());
    } catch (error) {
      write(problem, failureWords(error));
    }
  };
  return h(
    "form",
    { class: "card stack", onsubmit: submit },
    h("p", {}, words),
    field(t("deleted-reason"), reason, t("deleted-reason-hint")),
    problem,
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("deleted-reason-go")),
      h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel")),
    ),
  );
}
