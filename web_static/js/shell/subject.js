/**
 * Whose data the page shows: the header and the title of the page name the patient and the session.
 * @import { App } from "../main.js"
 * @import { FrameState } from "./frame_state.js"
 */
import { Fragment, h } from "../preact.js";
import { t } from "../texts.js";
import { placeOf } from "./pages.js";

/**
 * @typedef {{patient: number, code: string, sessions: number[]}} Subject `patient`: id; `sessions`: numbers of those
 *   that the page shows; empty: all
 */

/** @typedef {Pick<App, "subject" | "session">} Named what names the subject */

/** The subject of the page: its own, or the open session. @param {Named} named @returns {Subject | null} */
function subjectOf({ subject, session }) {
  if (subject) return subject;
  return session?.patient && session.session
    ? { patient: session.patient.id, code: session.patient.code, sessions: [session.session.number] }
    : null;
}

/** What is shown of the subject, in words. @param {Named} named @param {Subject} subject */
function part({ session }, { code, sessions: [first, second] }) {
  if (first === undefined) return t("who-shown");
  if (second !== undefined && second !== first) return t("who-shown-two", { first, second });
  const isOpen = session?.patient?.code === code && session.session?.number === first;
  return t(isOpen ? "who-open" : "who-shown-one", { number: first });
}

/** The place in the header; the lock names nobody. @param {{state: FrameState}} place */
export function SubjectPlace({ state }) {
  const named = { subject: state.subject.value, session: state.session.value };
  const subject = subjectOf(named);
  const isSignedIn = Boolean(state.me.value?.signed_in);
  const words = subject
    ? h(Fragment, {}, h("b", {}, subject.code), " ", h("span", {}, part(named, subject)))
    : t("who-nobody");
  return h("span", { class: "who", hidden: !isSignedIn }, isSignedIn && !state.isLocked.value && words);
}

/** The title of the page: the browser shows it in its list of tabs. @param {App} app */
export function pageTitle(app) {
  if (app.lock.isLocked) return t("app-title", { page: t("lock-title") });
  const page = t(`rail-${app.route.page}`);
  const subject = app.subject || placeOf(app.route.page).ofSession ? subjectOf(app) : null;
  if (!subject) return t("app-title", { page });
  return t("app-title-of", { code: subject.code, part: part(app, subject), page });
}
