/** A field for a password, which can be shown while it is typed. */
import { h, useRef, useSignal } from "../preact.js";
import { t } from "../texts.js";
import { Field } from "../widgets/fields.js";

/** The field, whose name in its form is "password". @param {{label: string, hint?: string, autocomplete: string}} field */
export function PasswordField({ label, hint, autocomplete }) {
  return h(Field, { label, hint }, h(TypedPassword, { autocomplete }));
}

/**
 * The input, and a button in it that shows what was typed, or hides it again.
 * @param {{autocomplete: string, id?: string, "aria-describedby"?: string}} typed id and description: given by `Field`
 */
function TypedPassword({ id, ...attributes }) {
  const input = useRef(/** @type {HTMLInputElement | null} */ (null));
  const isShown = useSignal(false);
  const turn = () => {
    isShown.value = !isShown.value;
    input.current?.focus();
  };
  return h(
    "div",
    { class: "typed" },
    h("input", {
      ...attributes,
      id,
      name: "password",
      type: isShown.value ? "text" : "password",
      required: true,
      ref: input,
    }),
    h(
      "button",
      {
        type: "button",
        class: "btn bare small",
        "aria-controls": id,
        "aria-label": t(isShown.value ? "typed-hide-label" : "typed-show-label"),
        onClick: turn,
      },
      t(isShown.value ? "typed-hide" : "typed-show"),
    ),
  );
}
