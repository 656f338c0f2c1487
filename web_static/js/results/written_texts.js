/**
 * Texts that people write on trials and sessions: a form for one, the way to change it, and what it said earlier.
 * @import { ComponentChildren } from "../preact.js"
 */
import { h, useLayoutEffect, useRef, useSignal } from "../preact.js";
import { t } from "../texts.js";
import { Field } from "../widgets/fields.js";

/**
 * A form of one text.
 * @param {object} form
 * @param {string} form.label @param {string} [form.hint] @param {string} [form.text] before
 * @param {number | null} form.longest characters
 * @param {string} form.action words of the button that sends
 * @param {boolean} [form.isOffered] false: the form stays only as long as something is typed in it
 * @param {(text: string) => Promise<boolean>} form.send called with a text that is not empty; whether it was accepted
 * @param {() => void} [form.onClose] of a form that was opened, which has the focus first; without it the form stays
 * @param {ComponentChildren} [form.children] further buttons
 */
export function TextForm({ label, hint, text = "", longest, action, isOffered = true, send, onClose, children }) {
  const draft = useSignal(text);
  const input = useRef(/** @type {HTMLTextAreaElement | null} */ (null));
  useLayoutEffect(() => {
    if (onClose) input.current?.focus();
  }, []);
  if (!isOffered && !draft.value) return null;
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const written = draft.value.trim();
    if (!written || !(await send(written))) return;
    if (onClose) return onClose();
    draft.value = "";
    input.current?.focus();
  };
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(
      Field,
      { label, hint },
      h("textarea", {
        rows: 3,
        maxlength: longest,
        required: true,
        ref: input,
        value: draft.value,
        onInput: (/** @type {{currentTarget: HTMLTextAreaElement}} */ { currentTarget }) =>
          (draft.value = currentTarget.value),
      }),
    ),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn" }, action),
      onClose && h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
      children,
    ),
  );
}

/**
 * What a text said before it was revised, folded away.
 * @param {{title: string, earlier: {text: string, written: string, byline: string}[]}} texts the newest first;
 *   byline: who wrote it, or when
 */
export function EarlierTexts({ title, earlier }) {
  return (
    earlier.length > 0 &&
    h(
      "details",
      {},
      h("summary", {}, title),
      earlier.map(({ text, written, byline }) =>
        h(
          "div",
          { class: "earlier-text", key: written },
          h("p", { class: "own-words" }, text),
          h("p", { class: "quiet small" }, byline),
        ),
      ),
    )
  );
}
