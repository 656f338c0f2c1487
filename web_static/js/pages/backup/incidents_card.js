/**
 * Incidents: the archives that were made, and the mark that keeps their patients, which an owner lifts with a reason.
 * @import { BackupsView, IncidentView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { moment } from "../../widgets/format.js";
import { rowList } from "../../widgets/list.js";

/** @param {import("../../main.js").App} app @param {BackupsView} first @param {(view: BackupsView) => void} onChanged */
export function incidentsCard(app, first, onChanged) {
  const list = rowList("made-backups");
  const key = h("p", { class: "small fingerprint" });
  let shown = first;
  /** @type {number | null} id of the incident whose mark somebody is about to lift */
  let lifting = null;
  const draw = (view = shown) => {
    shown = view;
    list.show(view.incidents.map(row), h("p", { class: "quiet" }, t("incidents-none")));
    write(key, view.fingerprint && `${t("incidents-key")}: ${view.fingerprint}`);
  };
  /** @param {IncidentView | null} incident */
  const ask = (incident) => {
    lifting = incident?.id ?? null;
    draw();
    list.querySelector("input")?.focus();
  };
  /** @param {IncidentView} incident */
  const form = (incident) => {
    const reason = h("input", { type: "text", required: true, ...textLimits("Lifting", "reason") });
    const problem = h("p", { class: "problem", role: "alert" });
    /** @param {SubmitEvent} event */
    const submit = async (event) => {
      event.preventDefault();
      try {
        const view = await app.api.post(`/incidents/${incident.id}/lifting`, { reason: reason.value.trim() });
        lifting = null;
        onChanged(view);
      } catch (error) {
        write(problem, failureWords(error));
      }
    };
    return h(
      "form",
      { class: "confirm stack", onsubmit: submit },
      field(t("deleted-reason"), reason, t("deleted-reason-hint")),
      problem,
      h(
        "div",
        { class: "spread" },
        h("button", { class: "btn go" }, t("incidents-lift")),
        h("button", { type: "button", class: "btn", onclick: () => ask(null) }, t("cancel")),
      ),
    );
  };
  /** @param {IncidentView} incident */
  const row = (incident) => {
    const when = moment(incident.made);
    return h(
      "div",
      { class: "made-backup" },
      h("span", { class: "fingerprint" }, t("incidents-of", { when, hash: incident.hash.slice(0, 16) })),
      h("div", { class: "quiet small" }, t("incidents-patients", { count: incident.patients.length })),
      incident.lifted
        ? h(
            "p",
            { class: "small" },
            t("incidents-lifted", { when: moment(incident.lifted), reason: incident.reason ?? "" }),
          )
        : h(
            "button",
            {
              type: "button",
              class: "btn small",
              "aria-label": t("incidents-lift-label", { when }),
              onclick: () => ask(incident),
            },
            t("incidents-lift"),
          ),
      lifting === incident.id && form(incident),
    );
  };
  draw();
  const element = h(
    "section",
    { class: "card" },
    h("h2", {}, t("incidents-title")),
    h("p", { class: "quiet small" }, t("incidents-lead")),
    list,
    key,
  );
  return { element, draw };
}
