/**
 * Whose data the page shows: the header and the title of the page name the patient and the session.
 * @import { App } from "../main.js"
 */
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";
import { SESSION_PAGES } from "./other_session.js";

/** @typedef {{code: string, sessions: number[]}} Subject `sessions`: numbers of those that the page shows; empty: all */

/** The subject of the page: its own, or the open session. @param {App} app @returns {Subject | null} */
function subjectOf({ subject, session }) {
  if (subject) return subject;
  return session?.patient && session.session
    ? { code: session.patient.code, sessions: [session.session.number] }
    : null;
}

/** What is shown of the subject, in words. @param {App} app @param {Subject} subject */
function part({ session }, { code, sessions: [first, second] }) {
  if (first === undefined) return t("who-shown");
  if (second !== undefined && second !== first) return t("who-shown-two", { first, second });
  const isOpen = session?.patient?.code === code && session.session?.number === first;
  return t(isOpen ? "who-open" : "who-shown-one", { number: first });
}

/** The place in the header. @param {App} app */
export function subjectPlace(app) {
  const element = h("span", { class: "who" });
  const show = () => {
    const subject = subjectOf(app);
    element.hidden = !app.me?.signed_in;
    if (app.lock.isLocked || !app.me?.signed_in) return put(element);
    if (!subject) return put(element, t("who-nobody"));
    put(element, h("b", {}, subject.code), " ", h("span", {}, part(app, subject)));
  };
  for (const event of /** @type {const} */ (["me", "session", "subject"])) app.addEventListener(event, show);
  show();
  return element;
}

/** The title of the page: the browser shows it in its list of tabs. @param {App} app */
export function pageTitle(app) {
  if (app.lock.isLocked) return t("app-title", { page: t("lock-title") });
  const page = t(`rail-${app.route.page}`);
  const subject = app.subject || SESSION_PAGES.has(app.route.page) ? subjectOf(app) : null;
  if (!subject) return t("app-title", { page });
  return t("app-title-of", { code: subject.code, part: part(app, subject), page });
}
