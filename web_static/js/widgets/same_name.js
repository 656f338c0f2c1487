/** The question about an upload whose name is taken: a person keeps both, replaces the old one, or cancels. */
import { t } from "../texts.js";
import { h, put } from "./dom.js";

/** An empty place, beside the pages that are drawn again, in which the question appears. @returns {HTMLElement} */
export function questionPlace() {
  return h("div", { class: "card ask question", role: "alertdialog", hidden: true, tabindex: "-1" });
}

/**
 * Send an upload; when its name is taken, ask and send it again. The page around the question stays usable, Stop above
 * all.
 * @param {HTMLElement} place the page frame's, as of `questionPlace`
 * @param {(sameName: "ask" | "keep-both" | "replace") => Promise<any>} send
 * @returns {Promise<any>} the answer; null when the person cancelled
 */
export async function sendUnderName(place, send) {
  try {
    return await send("ask");
  } catch (error) {
    if (!error.choice) throw error;
    const chosen = await asked(place, error);
    return chosen ? send(chosen) : null;
  }
}

/** @param {HTMLElement} place @param {import("../api.js").ApiError} error @returns {Promise<any>} */
function asked(place, error) {
  const { proposed, may_replace: mayReplace } = error.choice;
  const before = document.activeElement;
  return new Promise((resolve) => {
    const choose = (sameName) => {
      place.hidden = true;
      place.onkeydown = null;
      removeEventListener("hashchange", leave);
      put(place);
      before?.focus?.();
      resolve(sameName);
    };
    const leave = () => choose(null);
    const button = (sameName, words, kind = "btn") =>
      h("button", { type: "button", class: kind, onclick: () => choose(sameName) }, words);
    put(
      place,
      h("p", {}, error.message),
      mayReplace && h("p", { class: "quiet small" }, t("same-name.kept")),
      h(
        "div",
        { class: "spread" },
        button("keep-both", t("same-name.keep-both", { name: proposed }), "btn go"),
        mayReplace && button("replace", t("same-name.replace")),
        button(null, t("cancel")),
      ),
    );
    place.onkeydown = (event) => event.key === "Escape" && choose(null);
    place.setAttribute("aria-label", error.message);
    addEventListener("hashchange", leave);
    place.hidden = false;
    place.focus();
  });
}
