/** Backup, for owners: the newest backups and one now, folder and passphrase, deleted patients, incidents. */
import { ApiError, FORBIDDEN } from "../../api.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { DeletedCard } from "./deleted_card.js";
import { IncidentsCard } from "./incidents_card.js";
import { MadeCard } from "./made_card.js";
import { NightCard } from "./night_card.js";
import { RecordTimeCard } from "./record_time_card.js";
import { backupStore } from "./store.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  if (app.me?.role !== "owner") throw new ApiError(t("backup-owner"), FORBIDDEN);
  const first = await app.api.get("/backups");
  if (left.aborted) return;
  const store = backupStore(app, first, left);
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("rail-backup")),
      h("p", { class: "lead" }, t("backup-lead")),
      h(
        "div",
        { class: "settings-columns" },
        h("div", { class: "stack" }, h(MadeCard, { store }), h(NightCard, { store })),
        h(
          "div",
          { class: "stack" },
          h(DeletedCard, { store }),
          h(RecordTimeCard, { store }),
          h(IncidentsCard, { store }),
        ),
      ),
      h("p", { class: "after-list" }, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
  );
}
