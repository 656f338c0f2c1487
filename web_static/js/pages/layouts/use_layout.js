/**
 * A layout for the shirt in use: whether its kind takes one, and the change.
 * @import { App } from "../../main.js"
 * @import { ShirtLayout } from "types/api"
 * @import { Equipment, ShirtKind } from "types/documents"
 * @typedef {import("types/requests").Body<"put", "/equipment/shirt">} ShirtRequest
 */
import { t } from "../../texts.js";

/** Why the shirt in use takes no layout, in a sentence; empty when it takes one. @param {Equipment} equipment @param {ShirtKind[]} kinds */
export function whyNotUsed({ shirt }, kinds) {
  if (!shirt) return t("layouts-use-no-shirt");
  const form = kinds.find(({ kind }) => kind === shirt.kind)?.form;
  return form?.properties.layout ? "" : t("layouts-use-own");
}

/** Give the shirt in use a layout; a toast says what came of it. @param {App} app @param {Equipment} equipment @param {ShirtLayout} layout */
export function putLayout(app, { shirt }, layout) {
  return app.toasts.attempt(async () => {
    await app.api.put("/equipment/shirt", /** @type {ShirtRequest} */ ({ ...shirt, layout }));
    app.toasts.show(t("layouts-used", { name: layout.name }));
  });
}
