/**
 * Incidents: the archives that were made, and the mark that keeps their patients, which an owner lifts with a reason.
 * @import { IncidentView } from "types/api"
 * @import { BackupStore } from "./store.js"
 */
import { textLimits } from "../../reference.js";
import { focusFirst, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { moment } from "../../widgets/format.js";

/** @param {{store: BackupStore}} card */
export function IncidentsCard({ store }) {
  const { incidents, fingerprint } = store.view.value;
  const lifting = useSignal(/** @type {number | null} */ (null)); // id of an incident
  /** @param {IncidentView} incident */
  const row = (incident) => {
    const { id, hash, patients, lifted, reason } = incident;
    const when = moment(incident.made);
    return h(
      "div",
      { class: "made-backup", role: "listitem", key: id },
      h("span", { class: "fingerprint" }, t("incidents-of", { when, hash: hash.slice(0, 16) })),
      h("div", { class: "quiet small" }, t("incidents-patients", { count: patients.length })),
      lifted
        ? h("p", { class: "small" }, t("incidents-lifted", { when: moment(lifted), reason: reason ?? "" }))
        : h(
            "button",
            {
              type: "button",
              class: "btn small",
              "aria-label": t("incidents-lift-label", { when }),
              onClick: () => (lifting.value = id),
            },
            t("incidents-lift"),
          ),
      lifting.value === id && h(LiftingForm, { store, id, onClose: () => (lifting.value = null) }),
    );
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("incidents-title")),
    h("p", { class: "quiet small" }, t("incidents-lead")),
    h(
      "div",
      { class: "made-backups", role: incidents.length ? "list" : undefined },
      incidents.length ? incidents.map(row) : h("p", { class: "quiet" }, t("incidents-none")),
    ),
    h("p", { class: "small fingerprint" }, fingerprint && `${t("incidents-key")}: ${fingerprint}`),
  );
}

/** @param {{store: BackupStore, id: number, onClose: () => void}} form id: of an incident */
function LiftingForm({ store: { app, change }, id, onClose }) {
  const problem = useSignal("");
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    const entered = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    const reason = String(entered.get("reason")).trim();
    problem.value = await change(() => app.api.post(`/incidents/${id}/lifting`, { reason }));
    if (!problem.value) onClose();
  };
  return h(
    "form",
    { class: "confirm stack", onSubmit: submit },
    h(
      Field,
      { label: t("deleted-reason"), hint: t("deleted-reason-hint") },
      h("input", {
        name: "reason",
        type: "text",
        required: true,
        ...textLimits("Lifting", "reason"),
        ref: focusFirst,
      }),
    ),
    h("p", { class: "problem", role: "alert" }, problem),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("incidents-lift")),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
