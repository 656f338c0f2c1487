/** Where the backups of every night go, from which hour on, and whether they are encrypted. */
import { textLimits } from "../../reference.js";
import { h, useMemo, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection, Toggle } from "../../widgets/fields.js";

const HOURS = Array.from({ length: 24 }, (_, hour) => ({
  value: String(hour),
  label: `${String(hour).padStart(2, "0")}:00`,
}));

/** @param {{store: import("./store.js").BackupStore}} card */
export function NightCard({ store: { app, view, change } }) {
  const first = useMemo(() => view.peek(), []);
  const folder = useSignal(first.folder ?? "");
  const hour = useSignal(String(first.hour));
  const isEncrypted = useSignal(first.encrypted);
  const withKeys = useSignal(first.with_keys);
  const passphrase = useSignal("");
  const problem = useSignal("");
  const isSending = useSignal(false);
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.value) return;
    const settings = {
      folder: folder.value.trim() || null,
      hour: Number(hour.value),
      encrypted: isEncrypted.value,
      with_keys: withKeys.value,
      passphrase: (isEncrypted.value && passphrase.value) || null,
    };
    problem.value = "";
    isSending.value = true;
    problem.value = await change(() => app.api.put("/backups/settings", settings));
    isSending.value = false;
    if (problem.value) return;
    passphrase.value = "";
    app.toasts.show(t("backup-saved"));
  };
  /** @param {{value: string}} typed */
  const input = (typed) => ({
    value: typed.value,
    onInput: (/** @type {Event} */ { currentTarget }) =>
      void (typed.value = /** @type {HTMLInputElement} */ (currentTarget).value),
  });
  const limits = textLimits("BackupSettings", "passphrase");
  const passphraseHint = view.value.encrypted ? "backup-passphrase-kept" : "backup-passphrase-new";
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("backup-place")),
    h("p", { class: "quiet small" }, t("backup-kept", { ...view.value.kept })),
    h(
      "form",
      { class: "stack", onSubmit: submit },
      h(
        Field,
        { label: t("backup-folder"), hint: t("backup-folder-hint") },
        h("input", {
          type: "text",
          autocomplete: "off",
          spellcheck: false,
          ...textLimits("BackupSettings", "folder"),
          ...input(folder),
        }),
      ),
      h(
        Field,
        { label: t("backup-hour") },
        h(Selection, { options: HOURS, chosen: hour.value, onChange: (value) => (hour.value = value) }),
      ),
      h(Toggle, {
        label: t("backup-encrypted"),
        on: isEncrypted.value,
        onChange: (on) => (isEncrypted.value = on),
      }),
      isEncrypted.value &&
        h(
          Field,
          { label: t("backup-passphrase"), hint: t(passphraseHint, { count: limits.minlength }) },
          h("input", { type: "password", autocomplete: "new-password", ...limits, ...input(passphrase) }),
        ),
      h(Toggle, { label: t("backup-with-keys"), on: withKeys.value, onChange: (on) => (withKeys.value = on) }),
      h("p", { class: "problem", role: "alert" }, problem),
      h("div", {}, h("button", { class: "btn", "aria-disabled": isSending.value || undefined }, t("backup-save"))),
    ),
  );
}
