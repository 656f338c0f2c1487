/**
 * The report of one session, or of all sessions of a patient, as a file: PDF or HTML, on A4 or Letter paper. A report
 * for others needs the patient's consent to sharing outside; a copy for the patient does not.
 * @import { App } from "../main.js"
 * @import { ConsentsView } from "types/api"
 */
import { LANGUAGE } from "../language.js";
import { h, useLayoutEffect, useSignal } from "../preact.js";
import { Field, Selection } from "../widgets/fields.js";
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
 * A choice of session, reader, paper and, where there are several, language, with the two files.
 * @param {object} choice
 * @param {App} choice.app
 * @param {{id: number, code: string, sessions: number}} choice.patient sessions: how many there are
 * @param {number} [choice.session] number of the session that is chosen at first; without: all
 */
export function ReportChoice({ app, patient, session }) {
  const { id, code } = patient;
  const chosen = useSignal(session ? String(session) : ALL);
  const paper = useSignal(localStorage.getItem(PAPER_PLACE) === "letter" ? "letter" : "a4");
  const reader = useSignal(/** @type {string} */ ("others"));
  const language = useSignal(/** @type {string} */ (LANGUAGE));
  const consents = useSignal(/** @type {ConsentsView["consents"] | null} */ (null));
  useLayoutEffect(() => {
    const read = app.toasts.attempt(() => app.api.get(`/patients/${id}/consents`));
    read.then((found) => (consents.value = found?.consents ?? null));
  }, []);
  const isShared = consents.value?.some(({ consent, given }) => consent === "sharing" && given);
  const isHidden = reader.value === "others" && !isShared;
  const isAsked = isHidden && consents.value !== null;
  const numbers = Array.from({ length: patient.sessions }, (_, place) => String(patient.sessions - place));
  const sessions = h(Selection, {
    options: [ALL, ...numbers].map((value) => ({ value, label: wordsOf(value) })),
    chosen: chosen.value,
    onChange: (value) => (chosen.value = value),
  });
  const readers = h(Selection, {
    options: READERS.map((value) => ({ value: String(value), label: t(`report-reader-${value}`) })),
    chosen: reader.value,
    onChange: (value) => (reader.value = value),
  });
  const papers = h(Selection, {
    options: ["a4", "letter"].map((value) => ({ value, label: t(`report-paper-${value}`) })),
    chosen: paper.value,
    onChange: (value) => {
      paper.value = value;
      localStorage.setItem(PAPER_PLACE, value);
    },
  });
  const offered = app.me?.languages ?? [];
  const languages = h(Selection, {
    options: languageOptions(offered),
    chosen: language.value,
    onChange: (value) => (language.value = value),
  });
  /** @param {string} form */
  const file = (form) => {
    const href = reportAddress(id, {
      form,
      session: chosen.value,
      paper: paper.value,
      reader: reader.value,
      language: language.value,
    });
    const label = t(`report-${form}-label`, { what: wordsOf(chosen.value), code });
    return h("a", { key: form, class: "btn", download: "", href, "aria-label": label }, t(`report-${form}`));
  };
  return h(
    "div",
    { class: "stack report-choice" },
    h(
      "div",
      { class: "columns" },
      h(Field, { label: t("report-what") }, sessions),
      h(Field, { label: t("report-reader") }, readers),
      h(Field, { label: t("report-paper") }, papers),
      offered.length > 1 && h(Field, { label: t("language-title") }, languages),
    ),
    h(
      "p",
      { class: "spread" },
      h("span", { class: "grow", role: "status" }, isAsked && t("report-consent", { code })),
      h("a", { class: "btn", href: `#/session/patient/${id}`, hidden: !isAsked }, t("report-consent-go")),
    ),
    h("p", { class: "spread" }, h("span", { class: "spread", hidden: isHidden }, ["pdf", "html"].map(file))),
    h("p", { class: "quiet small" }, t("report-log"), " ", t("report-apart")),
  );
}

/**
 * The same choice as a card of a page; nothing without the right to export, or without a session.
 * @param {{app: App, patient: {id: number, code: string, sessions: number}}} card
 */
export function ReportCard({ app, patient }) {
  if (!mayExport(app) || !patient.sessions) return null;
  return h("section", { class: "card" }, h("h2", {}, t("report-title")), h(ReportChoice, { app, patient }));
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
