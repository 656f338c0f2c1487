/** What a page shows while nobody is here: what to do next. */
import { drawPage, Fragment, h } from "../preact.js";
import { t } from "../texts.js";

/** @param {HTMLElement} root @param {string} title @param {string} lead @param {string} hash @param {string} [action] none: there is nothing to do */
export function emptyPage(root, title, lead, hash, action) {
  const way = action && h("a", { class: "btn go large", href: hash }, action);
  const page = h(Fragment, {}, h("h1", { tabindex: -1 }, title), h("p", { class: "lead" }, lead), way);
  drawPage(root, page, "body empty");
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
