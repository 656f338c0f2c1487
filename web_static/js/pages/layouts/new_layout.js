/**
 * The ways to a new layout: of the shirt in use, of a file of signals, with a number of channels, or a file that has one.
 * @import { ShirtLayout } from "types/api"
 * @import { List } from "./layout_list.js"
 * @typedef {typeof SOURCES[number]} Source where the channels of a new layout come from
 */
import { failureWords } from "../../api.js";
import { h, useRef, useSignal } from "../../preact.js";
import { REFERENCE, textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Choices, Field, Selection } from "../../widgets/fields.js";
import { nameOfNew, newLayout, WHOLE, withGroups, withJointLabel } from "./layout_document.js";

const SOURCES = /** @type {const} */ (["stream", "file", "count", "import"]);
const USUAL_COUNT = 8;
const LARGEST = 1_000_000; // bytes of a file with a layout: a hundred times what one needs

/** @param {{list: List, onSaved: (name: string) => void}} card onSaved: the new layout is in the list */
export function NewLayout({ list: { app, layouts, equipment }, onSaved }) {
  const source = useSignal(/** @type {Source} */ ("stream"));
  const signals = equipment.value.files.filter(({ kind }) => kind === "signals");
  const chosen = useSignal(""); // name of a file of signals
  const problem = useSignal("");
  const isSending = useSignal(false); // a second tap would make a second layout
  const form = useRef(/** @type {HTMLFormElement | null} */ (null));
  const file = signals.find(({ name }) => name === chosen.value)?.name ?? signals[0]?.name ?? "";
  /** @returns {Promise<ShirtLayout>} */
  const made = async () => {
    const entered = new FormData(/** @type {HTMLFormElement} */ (form.current));
    if (source.value === "count") return newLayout("", Number(entered.get("count")), t("layouts-whole"));
    if (source.value === "import") return readLayout(/** @type {File} */ (entered.get("document")));
    if (source.value === "file") return layoutOfFile(app, file);
    const { layout } = equipment.value;
    if (!layout) throw new Error(t("layouts-use-no-shirt"));
    return layout;
  };
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.value) return;
    problem.value = "";
    isSending.value = true;
    try {
      const layout = await made();
      const typed = String(new FormData(/** @type {HTMLFormElement} */ (form.current)).get("name") ?? "").trim();
      const name = typed || nameOfNew(String(layout.name || t("layouts-new")), layouts.value);
      layouts.value = await app.api.post("/layouts", { ...layout, name });
      onSaved(name);
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };
  return h(
    "form",
    { class: "card stack", onSubmit: submit, ref: form },
    h("h2", {}, t("layouts-new")),
    h(Choices, {
      label: t("layouts-new-source"),
      options: SOURCES.map((value) => ({
        value,
        label: t(`layouts-from-${value}`),
        hint: t(`layouts-from-${value}-hint`),
      })),
      chosen: source.value,
      onChange: (value) => {
        source.value = /** @type {Source} */ (value);
        problem.value = "";
      },
    }),
    source.value === "file" &&
      (signals.length
        ? h(
            Field,
            { key: "file", label: t("source-file") },
            h(Selection, {
              options: signals.map(({ name }) => ({ value: name, label: name })),
              chosen: file,
              onChange: (name) => void (chosen.value = name),
            }),
          )
        : h("p", { key: "none", class: "quiet small" }, t("layouts-no-file"))),
    source.value === "count" &&
      h(
        Field,
        { key: "count", label: t("layouts-count") },
        h("input", {
          type: "number",
          name: "count",
          required: true,
          min: 1,
          max: REFERENCE.numbers.layout_channels,
          step: 1,
          defaultValue: String(USUAL_COUNT),
        }),
      ),
    source.value === "import" &&
      h(
        Field,
        { key: "import", label: t("layouts-import-file") },
        h("input", { type: "file", name: "document", accept: ".json,application/json", required: true }),
      ),
    h(
      Field,
      { key: "name", label: t("layouts-name"), hint: t("layouts-new-name-hint") },
      h("input", { type: "text", name: "name", ...textLimits("ShirtLayout", "name"), autocomplete: "off" }),
    ),
    h("p", { key: "problem", class: "problem", role: "alert" }, problem.value),
    h(
      "div",
      { key: "go", class: "spread" },
      h(
        "button",
        {
          class: "btn go",
          "aria-disabled": isSending.value || undefined,
          disabled: source.value === "file" && !signals.length,
        },
        t("layouts-new-go"),
      ),
    ),
  );
}

/** The first layout of a file of signals, with the joints that its names or its signals say. @param {import("../../main.js").App} app @param {string} file its name @returns {Promise<ShirtLayout>} */
async function layoutOfFile(app, file) {
  const { layout, proposal } = await app.api.post("/layouts/draft", { file });
  if (!proposal) return layout;
  app.toasts.show(proposal.message);
  const whole = withJointLabel(layout, WHOLE, t("layouts-whole"));
  return withGroups(whole, proposal.groups, (number) => t("layouts-group", { number }));
}

/** @param {File} file @returns {Promise<ShirtLayout>} as far as the server accepts it */
async function readLayout(file) {
  try {
    if (file.size > LARGEST) throw new RangeError();
    const document = JSON.parse(await file.text());
    if (!Array.isArray(document?.channels)) throw new TypeError();
    return document;
  } catch {
    throw new Error(t("layouts-import-wrong", { file: file.name }));
  }
}
