/**
 * The export of a patient's recordings and measures, in one of five forms; only with the consent to sharing outside.
 * @import { ConsentsView, SessionRow } from "types/api"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { mayExport } from "../../results/report_choice.js";

const FORMS = /** @type {const} */ (["csv", "parquet", "xdf", "bids", "fhir"]);
const ALL = "";

/**
 * @param {import("../../main.js").App} app @param {ConsentsView} consents @param {SessionRow[]} sessions
 * @returns {HTMLElement | null} null without the right to export, or without a session
 */
export function exportCard(app, { patient_id: patient, code, consents }, sessions) {
  if (!mayExport(app) || !sessions.length) return null;
  const isShared = consents.some(({ consent, given }) => consent === "sharing" && given);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("export.title")),
    h("p", { class: "quiet small" }, t("export.lead")),
    isShared ? choice(patient, code, sessions) : h("p", {}, t("export.consent")),
  );
}

/** @param {number} patient @param {string} code @param {SessionRow[]} sessions */
function choice(patient, code, sessions) {
  /** @type {(typeof FORMS)[number]} */
  let form = FORMS[0];
  let session = ALL;
  const link = h("a", { class: "btn", download: "", "aria-label": t("export.go.label", { code }) }, t("export.go"));
  const draw = () => {
    const query = new URLSearchParams({ form, ...(session && { session }) });
    link.setAttribute("href", `/api/v1/patients/${patient}/export?${query}`);
  };
  const forms = selection(
    FORMS.map((value) => ({ value, label: t(`export.form.${value}`) })),
    form,
    (value) => ((form = value), draw()),
  );
  const numbers = sessions.map(({ number }) => ({ value: String(number), label: t("export.session", { number }) }));
  const which = selection([{ value: ALL, label: t("export.all") }, ...numbers], session, (value) => ((session = value), draw()));
  draw();
  return h(
    "div",
    { class: "stack" },
    h("div", { class: "columns" }, field(t("export.form"), forms), field(t("export.what"), which)),
    h("p", {}, link),
    h("p", { class: "quiet small" }, t("export.wait")),
  );
}
