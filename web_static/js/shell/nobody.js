/** What a page shows while nobody is here: what to do next. */
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";

/** @param {HTMLElement} root @param {string} title @param {string} lead @param {string} hash @param {string} [action] none: there is nothing to do */
export function emptyPage(root, title, lead, hash, action) {
  put(
    root,
    h(
      "div",
      { class: "body empty" },
      h("h1", { tabindex: "-1" }, title),
      h("p", { class: "lead" }, lead),
      action && h("a", { class: "btn go large", href: hash }, action),
    ),
  );
}

/**
 * Who is here, and whether that patient is calibrated; null, with the empty page shown, when nobody is here.
 * @param {import("../main.js").App} app @param {HTMLElement} root
 */
export function patientHere(app, root) {
  const { patient = null, has_profile: hasProfile = false } = app.session ?? {};
  if (patient) return { patient, hasProfile };
  emptyPage(root, t("nobody-title"), t("nobody-lead"), "#/patients", t("nobody-go"));
  return null;
}
