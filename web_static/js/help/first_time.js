/** Sentences over the page for a person's first time; each has a number that also stands on what it is about. */
import { h, put, set } from "../widgets/dom.js";
import { loadStyles, words } from "./help_words.js";

// The first sentence is about Stop; the others are named after the step of the rail that they are about.
const SENTENCES = /** @type {const} */ (["first.stop", "first.calibrate", "first.controls", "first.review"]);
const FOR_REVIEWERS = /** @type {const} */ (["first.reviewer.stop", "first.reviewer.patients", "first.reviewer.review"]);

/** @param {import("../main.js").App} app @param {HTMLElement} place between the header and the page */
export function showFirstTime(app, place) {
  loadStyles();
  const isReviewer = app.me?.role === "reviewer";
  const sentences = isReviewer ? FOR_REVIEWERS : SENTENCES;
  app.frame.classList.add("first-time");
  for (const [i, key] of sentences.entries()) {
    const link = app.frame.querySelector(`.rail a[href="#/${key.split(".").at(-1)}"]`);
    if (link) set(link, { "data-first": i + 1 });
  }
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
      { class: "first-sentences", "aria-label": words(isReviewer ? "first.reviewer.title" : "first.title") },
      h("ol", {}, sentences.map((key) => h("li", {}, words(key)))),
      h("button", { type: "button", class: "btn", onclick: putAway }, words("first.done")),
    ),
  );
}
