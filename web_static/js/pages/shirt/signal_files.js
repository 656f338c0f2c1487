/**
 * The files of signals, bodies and heads that lie on the machine.
 * @import { App } from "../../main.js"
 * @import { FileView } from "types/api"
 */
import { h, useRef } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { sendUnderName } from "../../widgets/same_name.js";

/**
 * A selection among files that lie on the machine.
 * @param {{files: FileView[], config: {file?: string}, label?: string}} field config: what keeps the choice
 */
export function FileField({ files, config, label = t("source-file") }) {
  if (!files.length) return h("p", { class: "quiet small" }, t("source-no-file"));
  const chosen = files.find(({ name }) => name === config.file)?.name ?? files[0].name;
  config.file = chosen;
  const options = files.map((file) => ({
    value: file.name,
    label: t("source-file-option", { name: file.name, size: size(file.size) }),
  }));
  return h(
    Field,
    { label },
    h(Selection, { options, chosen, onChange: (/** @type {string} */ name) => void (config.file = name) }),
  );
}

/** A button that brings a file to the machine; the page reads the equipment again by itself. @param {{app: App}} button */
export function AddFile({ app }) {
  const input = useRef(/** @type {HTMLInputElement | null} */ (null));
  /** @param {Event} event */
  const add = async ({ currentTarget }) => {
    const field = /** @type {HTMLInputElement} */ (currentTarget);
    const file = field.files?.[0];
    if (!file) return;
    app.toasts.show(t("source-adding", { file: file.name }));
    await app.toasts.attempt(async () => {
      const equipment = await sendUnderName(app.question, (sameName) =>
        app.api.upload(`/equipment/files?same_name=${sameName}`, file),
      );
      if (equipment) {
        app.dispatchEvent(new CustomEvent("equipment", { detail: equipment }));
        app.toasts.show(t("source-added", { file: file.name }));
      }
    });
    field.value = "";
  };
  return h(
    "div",
    { class: "spread" },
    h("button", { type: "button", class: "btn", onClick: () => input.current?.click() }, t("source-add")),
    h("input", {
      type: "file",
      accept: ".csv,.parquet",
      class: "unseen",
      tabindex: -1,
      "aria-hidden": "true",
      ref: input,
      onChange: add,
    }),
    h("span", { class: "quiet small" }, t("source-add-hint")),
  );
}

/** The way to recordings of other programs. */
export function ImportLink() {
  return h(
    "div",
    { class: "spread" },
    h("a", { class: "btn", href: "#/import_recording" }, t("source-import")),
    h("span", { class: "quiet small" }, t("source-import-hint")),
  );
}
