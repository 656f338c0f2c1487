/**
 * The export of recordings and measures in one of five forms, or of the whole patient as an archive, and how far it is. It
 * needs the patient's consent to sharing outside.
 * @import { ConsentsView, SessionRow } from "types/api"
 */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { exportProgress } from "./export_progress.js";
import { mayExport } from "../../results/report_choice.js";

const ARCHIVE = "archive"; // of the whole patient, for another clinic
const FORMS = /** @type {const} */ (["csv", "parquet", "xdf", "bids", "fhir", ARCHIVE]);
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
    h("h2", {}, t("export-title")),
    h("p", { class: "quiet small" }, t("export-lead")),
    isShared ? choice(app, patient, code, sessions) : h("p", {}, t("export-consent")),
  );
}

/** @param {import("../../main.js").App} app @param {number} patient @param {string} code @param {SessionRow[]} sessions */
function choice(app, patient, code, sessions) {
  /** @type {(typeof FORMS)[number]} */
  let form = FORMS[0];
  let session = ALL;
  const progress = exportProgress(app);
  const go = () => {
    const address = new URL(link.href);
    address.searchParams.set("course", progress.begin());
    link.href = address.href; // the click follows this address
  };
  const link = h(
    "a",
    { class: "btn", download: "", onclick: go, "aria-label": t("export-go-label", { code }) },
    t("export-go"),
  );
  const offer = h("p", {}, link);
  const isOpen = sessions.some(({ ended }) => ended === null);
  const words = h("p", { role: "status" });
  const draw = () => {
    const query = new URLSearchParams({ form, ...(session && { session }) });
    const isArchive = form === ARCHIVE;
    link.setAttribute("href", `/api/v1/patients/${patient}/${isArchive ? ARCHIVE : `export?${query}`}`);
    offer.hidden = isArchive; // until the disk of the clinic was looked at
    what.hidden = isArchive;
    write(words, isArchive && isOpen ? t("export-archive-open") : form === "csv" ? t("export-csv-how") : "");
    if (isArchive && !isOpen) lookForRoom();
  };
  const lookForRoom = async () => {
    const room = await app.toasts.attempt(() => app.api.get(`/patients/${patient}/archive/room`));
    if (form !== ARCHIVE || !room) return;
    offer.hidden = Boolean(room.message);
    write(words, room.message || t("export-archive-how", { size: size(room.bytes) }));
  };
  const forms = selection(
    FORMS.map((value) => ({ value, label: t(`export-form-${value}`) })),
    form,
    (value) => ((form = value), draw()),
  );
  const numbers = sessions.map(({ number }) => ({ value: String(number), label: t("export-session", { number }) }));
  const which = selection(
    [{ value: ALL, label: t("export-all") }, ...numbers],
    session,
    (value) => ((session = value), draw()),
  );
  const what = field(t("export-what"), which);
  draw();
  return h(
    "div",
    { class: "stack" },
    h("div", { class: "columns" }, field(t("export-form"), forms), what),
    words,
    offer,
    progress.element,
    h("p", { class: "quiet small" }, t("export-wait")),
  );
}
