/** A field for a password, which can be shown while it is typed. */
import { h, write } from "../widgets/dom.js";
import { field } from "../widgets/fields.js";
import { t } from "../texts.js";

/**
 * The field with a button in it that shows what was typed, or hides it again.
 * @param {string} label @param {HTMLInputElement} input @param {string} [hint]
 */
export function passwordField(label, input, hint) {
  const element = field(label, input, hint);
  const button = h("button", { type: "button", class: "btn bare small", "aria-controls": input.id });
  /** @param {boolean} isShown */
  const show = (isShown) => {
    input.type = isShown ? "text" : "password";
    write(button, t(isShown ? "typed-hide" : "typed-show"));
    button.setAttribute("aria-label", t(isShown ? "typed-hide-label" : "typed-show-label"));
  };
  button.addEventListener("click", () => {
    show(input.type === "password");
    input.focus();
  });
  show(false);
  const place = h("div", { class: "typed" });
  input.replaceWith(place);
  place.append(input, button);
  return element;
}
