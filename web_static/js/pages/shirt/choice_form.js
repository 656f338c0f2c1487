/** A form that chooses one of several kinds, and has the settings of that kind. */
import { failureWords } from "../../api.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";

/**
 * @typedef {import("../../preact.js").ComponentChildren} ComponentChildren
 * @param {object} form
 * @param {ComponentChildren} form.choices the kinds @param {() => Promise<void>} form.onUse rejects with a sentence
 * @param {import("../../preact.js").Ref<HTMLDivElement>} [form.place] of the settings and the button
 * @param {boolean} [form.isReady] @param {ComponentChildren} [form.children] the settings
 */
export function ChoiceForm({ choices, onUse, place, isReady = true, children }) {
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
    choices,
    h(
      "div",
      { class: "stack", ref: place },
      h("div", { class: "stack settings" }, children),
      h("p", { class: "problem", role: "alert" }, problem),
      h("button", { class: "btn go", hidden: !isReady }, t("source-use")),
    ),
  );
}
