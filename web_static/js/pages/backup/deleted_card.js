/**
 * Deleted patients: how many days are left, undo, and erase for good now.
 * @import { DeletedPatientView } from "types/api"
 */
import { passFocus } from "../../focus.js";
import { focusFirst, h, useSignal } from "../../preact.js";
import { REFERENCE } from "../../reference.js";
import { t } from "../../texts.js";

const DAY = 86_400_000; // ms

/** @param {{store: import("./store.js").BackupStore}} card */
export function DeletedCard({ store: { app, view, show } }) {
  const { deleted } = view.value;
  const erasing = useSignal(/** @type {number | null} */ (null)); // id of the patient whom somebody is about to erase
  /** @param {DeletedPatientView} patient */
  const undo = (patient) =>
    app.toasts.attempt(async () => {
      await app.api.post(`/patients/${patient.id}/restore`);
      show(await app.api.get("/backups"));
      app.toasts.show(t("deleted-undone", { code: patient.code }));
    });
  /** @param {DeletedPatientView} patient */
  const erase = (patient) => {
    erasing.value = null;
    return app.toasts.attempt(async () => {
      show(await app.api.post(`/deleted-patients/${patient.id}/erasure`));
      app.toasts.show(t("deleted-erased", { code: patient.code }));
    });
  };
  /** @param {DeletedPatientView} patient */
  const row = (patient) => {
    const { id, code } = patient;
    const left = Math.ceil((Date.parse(patient.until) - Date.now()) / DAY);
    return h(
      "div",
      { class: "made-backup", role: "listitem", key: id },
      h("b", {}, code),
      ` ${patient.pseudonym}`,
      h(
        "div",
        { class: "quiet small" },
        left > 0 ? t("deleted-left", { count: left }) : t("deleted-due"),
        ` · ${t("deleted-what", { count: patient.recordings })}`,
      ),
      patient.why_not && h("p", { class: "small" }, patient.why_not),
      h(
        "div",
        { class: "spread" },
        smallButton(t("deleted-undo"), t("deleted-undo-label", { code }), () => undo(patient)),
        !patient.why_not &&
          smallButton(t("deleted-erase"), t("deleted-erase-label", { code }), () => (erasing.value = id)),
      ),
      erasing.value === id &&
        confirmation(
          code,
          () => erase(patient),
          () => (erasing.value = null),
        ),
    );
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("deleted-title")),
    h("p", { class: "quiet small" }, t("deleted-lead", { days: REFERENCE.numbers.deleted_days })),
    h(
      "div",
      { class: "made-backups", role: deleted.length ? "list" : undefined },
      deleted.length ? deleted.map(row) : h("p", { class: "quiet" }, t("deleted-none")),
    ),
  );
}

/** @param {string} words @param {string} label @param {() => unknown} onClick */
const smallButton = (words, label, onClick) =>
  h("button", { type: "button", class: "btn small", "aria-label": label, ref: passFocus, onClick }, words);

/** @param {string} code @param {() => unknown} onErase @param {() => unknown} onClose */
function confirmation(code, onErase, onClose) {
  return h(
    "div",
    { class: "confirm", role: "group", "aria-label": t("deleted-erase-label", { code }) },
    h("b", {}, t("deleted-erase-title", { code })),
    h("p", {}, t("deleted-erase-lead")),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", onClick: onErase }, t("deleted-erase-go")),
      h("button", { type: "button", class: "btn", ref: focusFirst, onClick: onClose }, t("cancel")),
    ),
  );
}
