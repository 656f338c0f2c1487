/** The form that imports a plan from a drawing, a picture or a robot's map, and asks for what the file does not contain. */
import { failureWords } from "../api.js";
import { Fragment, h, useSignal } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { Field, Segments, Selection, Toggle } from "../widgets/fields.js";
import { ImportPreview } from "./import_preview.js";

const ACCEPTED = ".dxf,.png,.jpg,.jpeg,.yaml,.yml,.pgm";
const UNITS = ["mm", "cm", "m", "inch", "foot"];
const SCALES = ["width", "metres_per_pixel"];
const IS_PICTURE = /\.(png|jpe?g)$/i;
const IS_DRAWING = /\.dxf$/i;
const IS_MAP = /\.ya?ml$/i;
/** What the form contains at first, for files of every kind. */
const AT_FIRST = { unit: "", by: SCALES[0], scale: "", threshold: "0.6", outside: false };

/**
 * @typedef {import("types/api").DraftView} DraftView
 * @typedef {typeof AT_FIRST} Entries by: what the scale of a picture is given by
 * @typedef {{all: string[], walls: string[]}} Layers of a drawing, and those that are walls
 * @typedef {{entries: Entries, enter: (part: Partial<Entries>) => void}} EntriesProps
 */

/** @param {{app: import("../main.js").App, onOpen: (draft: DraftView) => unknown}} form */
export function ImportForm({ app, onOpen }) {
  const files = useSignal(/** @type {File[]} */ ([]));
  const entries = useSignal(AT_FIRST);
  const layers = useSignal(/** @type {Layers | null} */ (null)); // null: not known
  const made = useSignal(/** @type {DraftView | null} */ (null)); // of the files
  const problem = useSignal("");
  const isSending = useSignal(false);
  /** @param {{currentTarget: HTMLInputElement}} event */
  const choose = ({ currentTarget }) => {
    files.value = [...(currentTarget.files ?? [])];
    entries.value = AT_FIRST;
    layers.value = null;
    made.value = null;
    problem.value = "";
  };
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const [chosen, known] = [files.value, layers.value];
    if (!chosen.length || isSending.value) return;
    problem.value = "";
    made.value = null;
    isSending.value = true;
    const sent = new FormData();
    for (const file of chosen) sent.append("files", file);
    const options = {
      title: titleOf(chosen),
      ...optionsOf(chosen, entries.value),
      ...(known && { layers: known.walls }),
    };
    sent.append("options", JSON.stringify(options));
    try {
      /** @type {DraftView} */
      const draft = await app.api.call("POST", "/floorplans/import", sent);
      if (IS_DRAWING.test(chosen[0].name) && !known && draft.layers.length > 1)
        layers.value = { all: draft.layers, walls: draft.taken };
      made.value = draft;
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };
  const isOff = isSending.value || !files.value.length;
  const kind = kindOf(files.value);
  /** @type {EntriesProps} */
  const shown = {
    entries: entries.value,
    enter: (part) => void (entries.value = { ...entries.value, ...part }),
  };
  return h(
    "form",
    { class: "card stack import-form", onSubmit: submit },
    h("h2", {}, t("import-title")),
    h("p", { class: "quiet small" }, t("import-lead")),
    h(
      Field,
      { label: t("import-files"), hint: t("import-files-hint", { megabytes: REFERENCE.numbers.upload_megabytes }) },
      h("input", { type: "file", multiple: true, accept: ACCEPTED, onChange: choose }),
    ),
    h(
      "div",
      { class: "stack" },
      kind === "drawing" && h(DrawingFields, shown),
      kind === "picture" && h(PictureFields, shown),
      (kind === "picture" || kind === "map") && h(OutsideField, shown),
      layers.value && h(LayerFields, { layers: layers.value, onChange: (next) => void (layers.value = next) }),
    ),
    h("p", { class: "problem", role: "alert" }, problem),
    h("div", {}, h("button", { class: "btn go", "aria-disabled": isOff || undefined }, t("import-read"))),
    h("div", { class: "stack" }, h(ImportPreview, { made, onOpen })),
  );
}

/** What the files are together; null: nothing that needs an answer. @param {File[]} files */
function kindOf(files) {
  /** @param {RegExp} ending */
  const has = (ending) => files.some(({ name }) => ending.test(name));
  if (has(IS_DRAWING)) return "drawing";
  if (has(IS_MAP)) return "map";
  return has(IS_PICTURE) ? "picture" : null;
}

/** The options of the import. @param {File[]} files @param {Entries} entries @returns {Record<string, unknown>} */
function optionsOf(files, { unit, by, scale, threshold, outside }) {
  switch (kindOf(files)) {
    case "drawing":
      return unit ? { unit } : {};
    case "picture":
      return { [by]: parseFloat(scale), threshold: parseFloat(threshold), outside };
    case "map":
      return { outside };
    default:
      return {};
  }
}

/** The name of the first file without its ending. @param {File[]} files */
function titleOf(files) {
  const plain = files[0].name.replace(/\.[^.]*$/, "").slice(0, 80);
  return plain || t("plans-new-title");
}

/** The fields for a picture. @param {EntriesProps} fields */
function PictureFields({ entries: { by, scale, threshold }, enter }) {
  return h(
    Fragment,
    {},
    h(Segments, {
      label: t("import-scale"),
      options: SCALES.map((one) => ({ value: one, label: t(`import-by-${one}`) })),
      chosen: by,
      onChange: (one) => enter({ by: one }),
    }),
    h(
      "div",
      {},
      h(
        Field,
        { label: t(`import-${by}`), hint: t(`import-${by}-hint`) },
        h("input", {
          type: "number",
          step: "any",
          min: 0,
          required: true,
          inputmode: "decimal",
          value: scale,
          onInput: (/** @type {{currentTarget: HTMLInputElement}} */ { currentTarget }) =>
            enter({ scale: currentTarget.value }),
        }),
      ),
    ),
    h(
      Field,
      { label: t("import-threshold"), hint: t("import-threshold-hint") },
      h("input", {
        type: "number",
        step: "0.05",
        min: 0.05,
        max: 0.95,
        inputmode: "decimal",
        value: threshold,
        onInput: (/** @type {{currentTarget: HTMLInputElement}} */ { currentTarget }) =>
          enter({ threshold: currentTarget.value }),
      }),
    ),
  );
}

/** The choice that maps and pictures have. @param {EntriesProps} field */
function OutsideField({ entries: { outside }, enter }) {
  return h(
    Fragment,
    {},
    h(Toggle, { label: t("import-outside"), on: outside, onChange: (on) => enter({ outside: on }) }),
    h("p", { class: "quiet small" }, t("import-outside-hint")),
  );
}

/** The field for a drawing. @param {EntriesProps} field */
function DrawingFields({ entries: { unit }, enter }) {
  const own = { value: "", label: t("import-unit-own") };
  return h(
    Field,
    { label: t("import-unit"), hint: t("import-unit-hint") },
    h(Selection, {
      options: [own, ...UNITS.map((one) => ({ value: one, label: t(`import-unit-${one}`) }))],
      chosen: unit,
      onChange: (one) => enter({ unit: one }),
    }),
  );
}

/** Which layers of a drawing are walls. @param {{layers: Layers, onChange: (layers: Layers) => void}} fields */
function LayerFields({ layers: { all, walls }, onChange }) {
  return h(
    "fieldset",
    { class: "layers stack" },
    h("legend", {}, t("import-layers")),
    h("p", { class: "quiet small" }, t("import-layers-hint")),
    all.map((layer) =>
      h(
        "label",
        { class: "choice", key: layer },
        h("input", {
          type: "checkbox",
          checked: walls.includes(layer),
          onChange: (/** @type {{currentTarget: HTMLInputElement}} */ { currentTarget }) => {
            const others = walls.filter((one) => one !== layer);
            onChange({ all, walls: currentTarget.checked ? [...others, layer] : others });
          },
        }),
        h("b", { class: "grow" }, layer),
      ),
    ),
  );
}
