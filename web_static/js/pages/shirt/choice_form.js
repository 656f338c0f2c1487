/** A form that chooses one of several kinds, and has the settings of that kind. */
import { failureWords } from "../../api.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Choices } from "../../widgets/fields.js";

/**
 * @typedef {import("../../widgets/fields.js").Choice<string>} Choice
 * @param {object} form
 * @param {string} form.label @param {(Choice | import("../../widgets/fields.js").ChoiceGroup<string>)[]} form.options
 * @param {string} form.chosen @param {(kind: string) => void} form.onChoose
 * @param {() => Promise<void>} form.onUse rejects with a sentence
 * @param {import("../../preact.js").Ref<HTMLButtonElement>} [form.button] @param {boolean} [form.isReady]
 * @param {import("../../preact.js").ComponentChildren} [form.children] the settings
 */
export function ChoiceForm({ label, options, chosen, onChoose, onUse, button, isReady = true, children }) {
  const problem = useSignal("");
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.value = "";
    try {
      await onUse();
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(Choices, { label, options, chosen, onChange: onChoose }),
    h("div", { class: "stack settings" }, children),
    h("p", { class: "problem", role: "alert" }, problem),
    h("button", { class: "btn go", hidden: !isReady, ref: button }, t("source-use")),
  );
}
