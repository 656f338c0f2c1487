/** What a page is for: three sentences and a drawing, beside the page, so that STOP and the page can be used meanwhile. */
import { h } from "../widgets/dom.js";
import { drawing } from "./drawings.js";
import { helpName, loadStyles, pageWords, t } from "./help_words.js";

const MORE = "/docs/clinicians";

/**
 * @typedef {Pick<import("../main.js").App, "root" | "route"> & {
 *   addEventListener: (name: "route" | "me", run: () => void, options: {signal: AbortSignal}) => void,
 * }} Shown `root` holds the page; the events say that the page changes, or who is signed in
 */

/**
 * Open the help of the page that is shown; it closes by its button, by Escape, with the page, and when it would lie over
 * what the focus goes to.
 * @param {Shown} app what shows the page @param {HTMLButtonElement} opener the button that gets the focus back
 */
export async function openPageHelp(app, opener) {
  await loadStyles();
  const name = helpName(app.route);
  const found = pageWords(name);
  if (!found || opener.getAttribute("aria-expanded") === "true") return; // a second tap came meanwhile
  const done = new AbortController();
  const { signal } = done;
  const title = h("h2", { id: "page-help-title", tabindex: "-1" }, found.title);
  const panel = h(
    "section",
    { class: "page-help", role: "dialog", "aria-labelledby": "page-help-title" },
    h(
      "div",
      { class: "spread" },
      title,
      h("button", { type: "button", class: "btn small", onclick: () => close() }, t("help-help-close")),
    ),
    drawing(name),
    found.sentences.map((sentence) => h("p", {}, sentence)),
    h("p", {}, h("a", { href: MORE, target: "_blank" }, t("help-help-more"))),
  );
  const close = (hasFocus = true) => {
    done.abort();
    panel.remove();
    opener.setAttribute("aria-expanded", "false");
    if (hasFocus) opener.focus();
  };
  opener.setAttribute("aria-expanded", "true");
  opener.addEventListener("click", (event) => (event.stopImmediatePropagation(), close()), { capture: true, signal });
  window.addEventListener("keydown", (event) => event.key === "Escape" && close(), { signal });
  /** @param {FocusEvent} event */
  const uncover = (event) => {
    const target = /** @type {Element} */ (event.target);
    const { left, top, width, height } = target.getBoundingClientRect();
    const seen = document.elementFromPoint(left + width / 2, top + height / 2);
    if (panel.contains(seen) && !panel.contains(target)) close(false);
  };
  window.addEventListener("focusin", uncover, { capture: true, signal });
  for (const event of /** @type {const} */ (["route", "me"]))
    app.addEventListener(event, () => close(false), { signal });
  app.root.before(panel);
  title.focus();
}
