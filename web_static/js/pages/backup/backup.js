/**
 * Backup, for owners: the newest backups and one now, folder and passphrase, deleted patients, incidents.
 * @import { BackupsView } from "types/api"
 */
import { ApiError, FORBIDDEN } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { deletedCard } from "./deleted_card.js";
import { incidentsCard } from "./incidents_card.js";
import { madeCard } from "./made_card.js";
import { nightCard } from "./night_card.js";
import { recordTimeCard } from "./record_time_card.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  if (app.me?.role !== "owner") throw new ApiError(t("backup-owner"), FORBIDDEN);
  const first = await app.api.get("/backups");
  if (signal.aborted) return;
  const made = madeCard(app, first, signal);
  /** @param {BackupsView} view */
  const drawn = (view) => (made.draw(view), deleted.draw(view), incidents.draw(view));
  const deleted = deletedCard(app, first, drawn);
  const incidents = incidentsCard(app, first, drawn);
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("rail-backup")),
      h("p", { class: "lead" }, t("backup-lead")),
      h(
        "div",
        { class: "settings-columns" },
        h("div", { class: "stack" }, made.element, nightCard(app, first, drawn)),
        h("div", { class: "stack" }, deleted.element, recordTimeCard(app, first, drawn), incidents.element),
      ),
      h("p", { class: "after-list" }, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
  );
}
