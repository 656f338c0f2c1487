/**
 * A form by which somebody comes in: fields, why it was refused, and a button.
 * @import { ComponentChildren } from "../preact.js"
 */
import { failureWords } from "../api.js";
import { h, useSignal } from "../preact.js";
import { t } from "../texts.js";

/**
 * @param {object} form
 * @param {string} form.action words of the button
 * @param {(typed: Record<string, string>) => Promise<unknown>} form.send called with what was typed, by the fields' names
 * @param {boolean} [form.hasStatus] whether it says that one has to wait
 * @param {ComponentChildren} [form.children] the fields
 */
export function DoorForm({ action, send, hasStatus, children }) {
  const problem = useSignal("");
  const isSending = useSignal(false);
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.value) return; // a second tap would count as a second try
    const form = /** @type {HTMLFormElement} */ (event.currentTarget);
    const typed = Object.fromEntries([...new FormData(form)].map(([name, value]) => [name, String(value)]));
    problem.value = "";
    isSending.value = true; // the password's hash alone takes a moment
    await send(typed).catch((error) => (problem.value = failureWords(error)));
    isSending.value = false;
  };
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    children,
    h("p", { class: "problem", role: "alert" }, problem),
    h("button", { class: "btn go large", "aria-disabled": isSending.value || undefined }, action),
    hasStatus && h("p", { class: "quiet", role: "status" }, isSending.value && t("loading")),
  );
}
