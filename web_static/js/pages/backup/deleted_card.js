/**
 * Deleted patients: how many days are left, undo, and erase for good now.
 * @import { BackupsView, DeletedPatientView } from "types/api"
 */
import { REFERENCE } from "../../reference.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { rowList } from "../../widgets/list.js";

const DAY = 86_400_000; // ms

/** @param {import("../../main.js").App} app @param {BackupsView} first @param {(view: BackupsView) => void} onChanged */
export function deletedCard(app, first, onChanged) {
  const list = rowList("made-backups");
  let shown = first;
  /** @type {number | null} id of the patient whom somebody is about to erase */
  let erasing = null;
  const draw = (view = shown) => {
    shown = view;
    list.show(view.deleted.map(row), h("p", { class: "quiet" }, t("deleted.none")));
  };
  /** @param {DeletedPatientView} patient */
  const undo = (patient) =>
    app.toasts.attempt(async () => {
      await app.api.post(`/patients/${patient.id}/restore`);
      onChanged(await app.api.get("/backups"));
      app.toasts.show(t("deleted.undone", { code: patient.code }));
    });
  /** @param {DeletedPatientView} patient */
  const erase = async (patient) => {
    ask(null);
    await app.toasts.attempt(async () => {
      onChanged(await app.api.post(`/deleted-patients/${patient.id}/erasure`));
      app.toasts.show(t("deleted.erased", { code: patient.code }));
    });
  };
  /** @param {DeletedPatientView | null} patient */
  const ask = (patient) => {
    erasing = patient?.id ?? null;
    draw();
    /** @type {HTMLElement | null} */ (list.querySelector("[data-first]"))?.focus();
  };
  /** @param {DeletedPatientView} patient */
  const row = (patient) => {
    const left = Math.ceil((Date.parse(patient.until) - Date.now()) / DAY);
    const { code } = patient;
    return h(
      "div",
      { class: "made-backup" },
      h("b", {}, code),
      " ",
      patient.pseudonym,
      h(
        "div",
        { class: "quiet small" },
        left > 0 ? t("deleted.left", { count: left }) : t("deleted.due"),
        " · ",
        t("deleted.what", { count: patient.recordings }),
      ),
      patient.why_not && h("p", { class: "small" }, patient.why_not),
      h(
        "div",
        { class: "spread" },
        h(
          "button",
          {
            type: "button",
            class: "btn small",
            "aria-label": t("deleted.undo.label", { code }),
            onclick: () => undo(patient),
          },
          t("deleted.undo"),
        ),
        !patient.why_not &&
          h(
            "button",
            {
              type: "button",
              class: "btn small",
              "aria-label": t("deleted.erase.label", { code }),
              onclick: () => ask(patient),
            },
            t("deleted.erase"),
          ),
      ),
      erasing === patient.id && confirmation(patient, erase, () => ask(null)),
    );
  };
  draw();
  const element = h(
    "section",
    { class: "card" },
    h("h2", {}, t("deleted.title")),
    h("p", { class: "quiet small" }, t("deleted.lead", { days: REFERENCE.numbers.deleted_days })),
    list,
  );
  return { element, draw };
}

/** @param {DeletedPatientView} patient @param {(patient: DeletedPatientView) => void} onErase @param {() => void} onClose */
function confirmation(patient, onErase, onClose) {
  const { code } = patient;
  return h(
    "div",
    { class: "confirm", role: "group", "aria-label": t("deleted.erase.label", { code }) },
    h("b", {}, t("deleted.erase.title", { code })),
    h("p", {}, t("deleted.erase.lead")),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", onclick: () => onErase(patient) }, t("deleted.erase.go")),
      h("button", { type: "button", class: "btn", "data-first": true, onclick: onClose }, t("cancel")),
    ),
  );
}
