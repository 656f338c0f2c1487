/**
 * Where the shirt's signals come from: the form, and the configuration that it makes.
 * @import { App } from "../../main.js"
 * @import { Body } from "types/requests"
 * @import { Equipment, ShirtConfig, ShirtKind } from "types/documents"
 * @typedef {Body<"put", "/equipment/shirt">} ShirtRequest
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices } from "../../widgets/fields.js";
import { configFields } from "./config_fields.js";

/** In one line what is in use. @param {ShirtConfig | null} shirt @param {ShirtKind[]} shirts */
export function sourceWords(shirt, shirts) {
  if (!shirt) return t("source-none");
  const form = shirts.find(({ kind }) => kind === shirt.kind)?.form;
  return (form?.in_use ?? shirt.kind).replace(/\{(\w+)\}/g, (_, name) => String(shirt[name]));
}

/**
 * @param {App} app @param {Equipment} equipment @param {ShirtKind[]} shirts the kinds to choose from
 * @param {(config: ShirtRequest) => Promise<void>} onUse rejects with a sentence
 * @param {{kind: string, onKind: (kind: string) => void}} shown the kind whose settings are shown
 */
export function sourceForm(app, equipment, shirts, onUse, { kind: first, onKind }) {
  const { shirt, layout, files, shirt_keys: keys } = equipment;
  /** @param {boolean} isSimulated */
  const kinds = (isSimulated) =>
    shirts
      .filter(({ simulated }) => simulated === isSimulated)
      .map(({ kind, form }) => ({ value: kind, label: form.title, hint: form.description }));
  const settings = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @type {ReturnType<typeof configFields> | null} */
  let parts = null;
  /** @param {string} kind */
  const show = (kind) => {
    onKind(kind);
    const chosen = shirts.find((one) => one.kind === kind);
    if (!chosen) return;
    const now = shirt?.kind === kind ? shirt : null;
    parts = configFields(chosen.form, { app, now, layout, files, keys });
    put(settings, parts.fields);
    use.hidden = false;
  };
  /** @param {string} kind */
  const choose = (kind) => {
    show(kind);
    use.scrollIntoView({ block: "nearest" }); // it is the next step
  };
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      if (parts) await onUse(/** @type {ShirtRequest} */ (await parts.config()));
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  const use = h("button", { class: "btn go", hidden: true }, t("source-use"));
  if (first) show(first);
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    choices(
      t("source-title"),
      [
        { words: t("source-worn"), options: kinds(false) },
        { words: t("source-practice"), options: kinds(true) },
      ],
      first,
      choose,
    ),
    settings,
    problem,
    use,
  );
}
