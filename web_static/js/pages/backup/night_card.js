/**
 * Where the backups of every night go, from which hour on, and whether they are encrypted.
 * @import { BackupsView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { field, selection, toggle } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {BackupsView} settings @param {(view: BackupsView) => void} onSaved */
export function nightCard(app, settings, onSaved) {
  const folder = h("input", {
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    ...textLimits("BackupSettings", "folder"),
    value: settings.folder ?? "",
  });
  const hours = Array.from({ length: 24 }, (_, hour) => ({
    value: String(hour),
    label: `${String(hour).padStart(2, "0")}:00`,
  }));
  const hour = selection(hours, String(settings.hour));
  let { encrypted, with_keys: withKeys } = settings;
  const passphrase = h("input", {
    type: "password",
    autocomplete: "new-password",
    ...textLimits("BackupSettings", "passphrase"),
  });
  const secret = field(
    t("backup-passphrase"),
    passphrase,
    t(settings.encrypted ? "backup-passphrase-kept" : "backup-passphrase-new", {
      count: textLimits("BackupSettings", "passphrase").minlength,
    }),
  );
  secret.hidden = !encrypted;
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn" }, t("backup-save"));
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    write(problem, "");
    go.disabled = true;
    try {
      const view = await app.api.put("/backups/settings", {
        folder: folder.value.trim() || null,
        hour: Number(hour.value),
        encrypted,
        with_keys: withKeys,
        passphrase: (encrypted && passphrase.value) || null,
      });
      passphrase.value = "";
      app.toasts.show(t("backup-saved"));
      onSaved(view);
    } catch (error) {
      write(problem, failureWords(error));
    }
    go.disabled = false;
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("backup-place")),
    h("p", { class: "quiet small" }, t("backup-kept")),
    h(
      "form",
      { class: "stack", onsubmit: submit },
      field(t("backup-folder"), folder, t("backup-folder-hint")),
      field(t("backup-hour"), hour),
      toggle(t("backup-encrypted"), encrypted, (on) => {
        encrypted = on;
        secret.hidden = !on;
      }),
      secret,
      toggle(t("backup-with-keys"), withKeys, (on) => (withKeys = on)),
      problem,
      h("div", {}, go),
    ),
  );
}
