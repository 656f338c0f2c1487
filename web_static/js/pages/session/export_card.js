/**
 * The export of recordings and measures in one of five forms, or of the whole patient as an archive, and how far it is.
 * An export needs the patient's consent to sharing outside.
 * @import { ArchiveRoomView, SessionRow } from "types/api"
 */
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { ExportProgress } from "./export_progress.js";

const ARCHIVE = "archive"; // of the whole patient, for another clinic
const FORMS = ["csv", "parquet", "xdf", "bids", "fhir", ARCHIVE];
const ALL = "";

/**
 * @typedef {object} Exported what is exported
 * @property {import("../../main.js").App} app @property {AbortSignal} left
 * @property {number} patient id @property {string} code @property {SessionRow[]} sessions
 */

/** @param {Exported & {isConsented: boolean}} card */
export function ExportCard({ isConsented, ...exported }) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("export-title")),
    h("p", { class: "quiet small" }, t("export-lead")),
    isConsented ? h(ExportChoice, exported) : h("p", {}, t("export-consent")),
  );
}

/** @param {Exported} choice */
function ExportChoice({ app, left, patient, code, sessions }) {
  const form = useSignal(FORMS[0]);
  const session = useSignal(ALL);
  const room = useSignal(/** @type {ArchiveRoomView | null} */ (null)); // for an archive on the disk of the clinic
  const exportId = useSignal(""); // of the export that was begun last
  const isArchive = form.value === ARCHIVE;
  const isOpen = sessions.some(({ ended }) => ended === null);
  /** @param {string} value */
  const chooseForm = async (value) => {
    form.value = value;
    room.value = null;
    if (value !== ARCHIVE || isOpen) return;
    const answer = await app.toasts.attempt(() => app.api.get(`/patients/${patient}/archive/room`));
    if (form.value === ARCHIVE) room.value = answer ?? null;
  };
  const message = () => {
    if (!isArchive) return form.value === "csv" && t("export-csv-how");
    if (isOpen) return t("export-archive-open");
    return room.value && (room.value.message || t("export-archive-how", { size: size(room.value.bytes) }));
  };
  const query = new URLSearchParams({ form: form.value, ...(session.value && { session: session.value }) });
  /** The click follows the address, which names the export. @param {{currentTarget: HTMLAnchorElement}} event */
  const begin = ({ currentTarget: link }) => {
    exportId.value = crypto.randomUUID();
    const address = new URL(link.href);
    address.searchParams.set("course", exportId.value);
    link.href = address.href;
  };
  const numbers = sessions.map(({ number }) => ({ value: String(number), label: t("export-session", { number }) }));
  return h(
    "div",
    { class: "stack" },
    h(
      "div",
      { class: "columns" },
      h(
        Field,
        { label: t("export-form") },
        h(Selection, {
          options: FORMS.map((value) => ({ value, label: t(`export-form-${value}`) })),
          chosen: form.value,
          onChange: chooseForm,
        }),
      ),
      !isArchive &&
        h(
          Field,
          { label: t("export-what") },
          h(Selection, {
            options: [{ value: ALL, label: t("export-all") }, ...numbers],
            chosen: session.value,
            onChange: (value) => (session.value = value),
          }),
        ),
    ),
    h("p", { role: "status" }, message()),
    h(
      "p",
      { hidden: isArchive && room.value?.message !== "" }, // until there is room on the disk
      h(
        "a",
        {
          class: "btn",
          href: `/api/v1/patients/${patient}/${isArchive ? ARCHIVE : `export?${query}`}`,
          download: "",
          onClick: begin,
          "aria-label": t("export-go-label", { code }),
        },
        t("export-go"),
      ),
    ),
    h(ExportProgress, { app, left, id: exportId.value }),
    h("p", { class: "quiet small" }, t("export-wait")),
  );
}
