/**
 * The files of signals, bodies and heads that lie on the machine.
 * @import { App } from "../../main.js"
 * @import { FileView } from "types/api"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field, hiddenFileInput, selection } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { sendUnderName } from "../../widgets/same_name.js";

/** A selection among files that lie on the machine. @param {FileView[]} files @param {{file?: string}} config @param {string} [label] */
export function fileField(files, config, label = t("source-file")) {
  if (!files.length) return h("p", { class: "quiet small" }, t("source-no-file"));
  const chosen = files.find(({ name }) => name === config.file)?.name ?? files[0].name;
  config.file = chosen;
  const options = files.map((file) => ({
    value: file.name,
    label: t("source-file-option", { name: file.name, size: size(file.size) }),
  }));
  return field(
    label,
    selection(options, chosen, (name) => (config.file = name)),
  );
}

/** A button that brings a file to the machine; the page reads the equipment again by itself. @param {App} app */
export function addFile(app) {
  const input = hiddenFileInput(".csv,.parquet", async (file) => {
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
    input.value = "";
  });
  return h(
    "div",
    { class: "spread" },
    h("button", { type: "button", class: "btn", onclick: () => input.click() }, t("source-add")),
    input,
    h("span", { class: "quiet small" }, t("source-add-hint")),
  );
}
