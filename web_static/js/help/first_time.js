/** Four sentences over the page for a person's first time; each has a number that also stands on what it is about. */
import { h, put } from "../widgets/dom.js";
import { loadStyles, words } from "./help_words.js";

const SENTENCES = /** @type {const} */ (["stop", "calibrate", "controls", "review"]);

/** @param {import("../main.js").App} app @param {HTMLElement} place between the header and the page */
export function showFirstTime(app, place) {
  loadStyles();
  app.frame.classList.add("first-time");
  const putAway = async () => {
    if (app.me) app.me = { ...app.me, introduced: true };
    app.frame.classList.remove("first-time");
    put(place);
    app.root.querySelector("h1")?.focus();
    await app.toasts.attempt(() => app.api.post("/auth/introduction"));
  };
  put(
    place,
    h(
      "section",
      { class: "first-sentences", "aria-label": words("first.title") },
      h("ol", {}, SENTENCES.map((name) => h("li", {}, words(`first.${name}`)))),
      h("button", { type: "button", class: "btn", onclick: putAway }, words("first.done")),
    ),
  );
}
