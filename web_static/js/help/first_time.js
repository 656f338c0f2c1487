/** Sentences over the page for a person's first time; each has a number that also stands on what it is about. */
import { h, put, set } from "../widgets/dom.js";
import { loadStyles, t } from "./help_words.js";

// The first sentence is about Stop; the others are named after the step of the rail that they are about.
const SENTENCES = ["help-first-stop", "help-first-calibrate", "help-first-controls", "help-first-review"];
const FOR_REVIEWERS = ["help-first-reviewer-stop", "help-first-reviewer-patients", "help-first-reviewer-review"];

const WITH_STEPS = "calibrate"; // this page has numbers of its own, so that none stand on the rail
const BEFORE = ["sign_in", "invitation"]; // the page of a person is not shown yet

/**
 * Show them, and fold them to one line as soon as the person goes on to another page; a tap opens them again.
 * @param {import("../main.js").App} app @param {HTMLElement} place between the header and the page
 */
export async function showFirstTime(app, place) {
  await loadStyles();
  if (!app.me?.signed_in || place.hasChildNodes()) return; // it was asked for twice, or somebody signed out meanwhile
  const isReviewer = app.me?.role === "reviewer";
  const sentences = isReviewer ? FOR_REVIEWERS : SENTENCES;
  for (const [i, id] of sentences.entries()) {
    const link = app.frame.querySelector(`.rail a[href="#/${id.split("-").at(-1)}"]`);
    if (link) set(link, { "data-first": i + 1 });
  }
  const done = new AbortController();
  const putAway = async () => {
    done.abort();
    if (app.me) app.me = { ...app.me, introduced: true };
    app.frame.classList.remove("first-time");
    put(place);
    app.root.querySelector("h1")?.focus();
    await app.toasts.attempt(() => app.api.post("/auth/introduction"));
  };
  const title = t(isReviewer ? "help-first-reviewer-title" : "help-first-title");
  const list = h(
    "ol",
    { tabindex: "-1", "aria-label": title },
    sentences.map((id) => h("li", {}, t(id))),
  );
  const open = () => {
    fold(false);
    list.focus();
  };
  const opener = h("button", { type: "button", class: "btn bare", "aria-expanded": "false", onclick: open }, title);
  const section = h(
    "section",
    { class: "first-sentences", "aria-label": title },
    opener,
    list,
    h("button", { type: "button", class: "btn", onclick: putAway }, t("help-first-done")),
  );
  /** @param {boolean} isFolded */
  const fold = (isFolded) => {
    list.hidden = isFolded;
    opener.hidden = !isFolded;
    section.classList.toggle("folded", isFolded);
    app.frame.classList.toggle("first-time", !isFolded && app.route.page !== WITH_STEPS);
  };
  let first = "";
  const follow = () => {
    const { page } = app.route;
    if (!section.isConnected)
      done.abort(); // somebody signed out, or the page is locked
    else if (!BEFORE.includes(page)) {
      first ||= page;
      if (page !== first || page === WITH_STEPS) fold(true);
    }
  };
  put(place, section);
  fold(false);
  follow();
  app.addEventListener("route", follow, { signal: done.signal });
}
