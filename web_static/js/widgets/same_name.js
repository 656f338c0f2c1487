/**
 * The question about an upload whose name is taken: a person keeps both, replaces the old one, or cancels.
 * @import { NameChoice } from "../api.js"
 * @typedef {"ask" | "keep-both" | "replace"} SameName
 */
import { ApiError } from "../api.js";
import { t } from "../texts.js";
import { h, onEscape, put } from "./dom.js";

/** An empty place, beside the pages that are drawn again, in which the question appears. @returns {HTMLElement} */
export function questionPlace() {
  return h("div", { class: "card ask question", role: "alertdialog", hidden: true, tabindex: "-1" });
}

/**
 * Send an upload; when its name is taken, ask and send it again. The page around the question stays usable, Stop above
 * all.
 * @template Answer
 * @param {HTMLElement} place the page frame's, as of `questionPlace`
 * @param {(sameName: SameName) => Promise<Answer>} send
 * @returns {Promise<Answer | null>} the answer; null when the person cancelled
 */
export async function sendUnderName(place, send) {
  try {
    return await send("ask");
  } catch (error) {
    if (!(error instanceof ApiError && error.choice)) throw error;
    const chosen = await choiceOf(place, error.message, error.choice);
    return chosen ? send(chosen) : null;
  }
}

/**
 * What the person chose; null when they cancelled.
 * @param {HTMLElement} place @param {string} question @param {NameChoice} choice @returns {Promise<SameName | null>}
 */
function choiceOf(place, question, { proposed, may_replace: mayReplace }) {
  const before = /** @type {HTMLElement | null} */ (document.activeElement);
  return new Promise((resolve) => {
    /** @param {SameName | null} sameName */
    const choose = (sameName) => {
      place.hidden = true;
      onEscape(place, null);
      removeEventListener("hashchange", leave);
      put(place);
      before?.focus?.();
      resolve(sameName);
    };
    const leave = () => choose(null);
    /** @param {SameName | null} sameName @param {string} words */
    const button = (sameName, words, kind = "btn") =>
      h("button", { type: "button", class: kind, onclick: () => choose(sameName) }, words);
    put(
      place,
      h("p", {}, question),
      mayReplace && h("p", { class: "quiet small" }, t("same-name.kept")),
      h(
        "div",
        { class: "spread" },
        button("keep-both", t("same-name.keep-both", { name: proposed }), "btn go"),
        mayReplace && button("replace", t("same-name.replace")),
        button(null, t("cancel")),
      ),
    );
    onEscape(place, leave);
    place.setAttribute("aria-label", question);
    addEventListener("hashchange", leave);
    place.hidden = false;
    place.focus();
  });
}
