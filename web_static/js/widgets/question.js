/**
 * A question that a person has to answer before something is done. The page around it stays usable, Stop above all.
 * @import { Child } from "types/dom"
 */
import { giveFocus } from "../focus.js";
import { h, onEscape, put } from "./dom.js";

/** An empty place, beside the pages that are drawn again, in which the question appears. @returns {HTMLElement} */
export function questionPlace() {
  return h("div", { class: "card ask question", role: "alertdialog", hidden: true, tabindex: "-1" });
}

/**
 * Ask, and return the value of the answer; null when the person cancelled, pressed Escape or left the page.
 * @template {string} Value
 * @param {HTMLElement} place the page frame's, as of `questionPlace`
 * @param {string} question
 * @param {{value: Value | null, label: string, kind?: string}[]} answers `kind`: classes of the button
 * @param {...Child} details below the question
 * @returns {Promise<Value | null>}
 */
export function ask(place, question, answers, ...details) {
  const before = document.activeElement;
  return new Promise((resolve) => {
    /** @param {Value | null} value */
    const choose = (value) => {
      place.hidden = true;
      onEscape(place, null);
      removeEventListener("hashchange", leave);
      put(place);
      giveFocus(before);
      resolve(value);
    };
    const leave = () => choose(null);
    const buttons = answers.map(({ value, label, kind = "btn" }) =>
      h("button", { type: "button", class: kind, onclick: () => choose(value) }, label),
    );
    put(place, h("p", {}, question), ...details, h("div", { class: "spread" }, buttons));
    onEscape(place, leave);
    place.setAttribute("aria-label", question);
    addEventListener("hashchange", leave);
    place.hidden = false;
    place.focus();
  });
}
