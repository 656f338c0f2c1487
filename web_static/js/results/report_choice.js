/**
 * The report of one session, or of all sessions of a patient, as a file: PDF or HTML, on A4 or Letter paper. A report
 * for others needs the patient's consent to sharing outside; a copy for the patient does not.
 * @import { App } from "../main.js"
 * @import { ConsentsView } from "types/api"
 */
import { LANGUAGE } from "../language.js";
import { h, write } from "../widgets/dom.js";
import { field, selection } from "../widgets/fields.js";
import { languageOptions } from "../widgets/language_choice.js";
import { t } from "../texts.js";

const PAPER_PLACE = "bodydrive-report-paper";
const ALL = "all";
const READERS = /** @type {const} */ (["others", "patient"]);

/** Whether the person who is signed in may take reports out of the clinic. @param {App} app */
export function mayExport(app) {
  return app.me?.role !== "reviewer";
}

/**
 * A choice of session, reader, paper and, where there are several, language, with the two files; null without the right to export, or without a session.
 * @param {App} app @param {{id: number, code: string, sessions: number}} patient sessions: how many there are
 * @param {number} [session] number of the session that is chosen at first; without: all
 */
export function reportChoice(app, patient, session) {
  if (!mayExport(app) || !patient.sessions) return null;
  let chosen = session ? String(session) : ALL;
  let paper = localStorage.getItem(PAPER_PLACE) === "letter" ? "letter" : "a4";
  const links = ["pdf", "html"].map((form) => ({
    form,
    link: h("a", { class: "btn", download: "" }, t(`report-${form}`)),
  }));
  /** @type {(typeof READERS)[number]} */
  let reader = "others";
  /** @type {string} */
  let language = LANGUAGE;
  /** @type {ConsentsView["consents"] | null} */
  let consents = null;
  const files = h(
    "span",
    { class: "spread" },
    links.map(({ link }) => link),
  );
  const words = h("span", { class: "grow", role: "status" });
  const enter = h("a", { class: "btn", href: `#/session/patient/${patient.id}` }, t("report-consent-go"));
  const draw = () => {
    const isShared = consents?.some(({ consent, given }) => consent === "sharing" && given);
    files.hidden = reader === "others" && !isShared;
    write(words, consents && files.hidden ? t("report-consent", { code: patient.code }) : "");
    enter.hidden = !words.textContent;
    for (const { form, link } of links) {
      link.setAttribute("href", reportAddress(patient.id, { form, session: chosen, paper, reader, language }));
      link.setAttribute("aria-label", t(`report-${form}-label`, { what: wordsOf(chosen), code: patient.code }));
    }
  };
  const numbers = Array.from({ length: patient.sessions }, (_, place) => String(patient.sessions - place));
  const sessions = selection(
    [ALL, ...numbers].map((value) => ({ value, label: wordsOf(value) })),
    chosen,
    (value) => ((chosen = value), draw()),
  );
  const papers = selection(
    ["a4", "letter"].map((value) => ({ value, label: t(`report-paper-${value}`) })),
    paper,
    (value) => (localStorage.setItem(PAPER_PLACE, (paper = value)), draw()),
  );
  const readers = selection(
    READERS.map((value) => ({ value, label: t(`report-reader-${value}`) })),
    reader,
    (value) => ((reader = value), draw()),
  );
  const offered = app.me?.languages ?? [];
  const languages =
    offered.length > 1 && selection(languageOptions(offered), language, (value) => ((language = value), draw()));
  draw();
  app.toasts
    .attempt(() => app.api.get(`/patients/${patient.id}/consents`))
    .then((found) => {
      consents = found?.consents ?? null;
      draw();
    });
  return h(
    "div",
    { class: "stack report-choice" },
    h(
      "div",
      { class: "columns" },
      field(t("report-what"), sessions),
      field(t("report-reader"), readers),
      field(t("report-paper"), papers),
      languages && field(t("language-title"), languages),
    ),
    h("p", { class: "spread" }, words, enter),
    h("p", { class: "spread" }, files),
    h("p", { class: "quiet small" }, t("report-log"), " ", t("report-apart")),
  );
}

/**
 * The same choice as a card of a page.
 * @param {App} app @param {{id: number, code: string, sessions: number}} patient @param {number} [session]
 */
export function reportCard(app, patient, session) {
  const choice = reportChoice(app, patient, session);
  return choice && h("section", { class: "card" }, h("h2", {}, t("report-title")), choice);
}

/** @param {number} patient @param {Record<"form" | "session" | "paper" | "reader" | "language", string>} chosen */
function reportAddress(patient, { form, session, paper, reader, language }) {
  const query = new URLSearchParams({
    form,
    letter: String(paper === "letter"),
    for_patient: String(reader === "patient"),
    language,
  });
  if (session !== ALL) query.set("session", session);
  return `/api/v1/patients/${patient}/report?${query}`;
}

/** @param {string} chosen */
function wordsOf(chosen) {
  return chosen === ALL ? t("report-all") : t("report-session", { number: chosen });
}
