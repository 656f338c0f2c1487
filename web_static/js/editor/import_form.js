/** The form that imports a plan from a drawing, a picture or a robot's map, and asks for what the file does not contain. */
import { REFERENCE } from "../reference.js";
import { failureWords } from "../api.js";
import { h, put } from "../widgets/dom.js";
import { field, segments, selection, toggle } from "../widgets/fields.js";
import { t } from "../texts.js";
import { importPreview } from "./import_preview.js";

const ACCEPTED = ".dxf,.png,.jpg,.jpeg,.yaml,.yml,.pgm";
const UNITS = ["mm", "cm", "m", "inch", "foot"];
const IS_PICTURE = /\.(png|jpe?g)$/i;
const IS_DRAWING = /\.dxf$/i;
const IS_MAP = /\.ya?ml$/i;

/**
 * @typedef {import("types/api").DraftView} DraftView
 * @typedef {() => Record<string, unknown>} Options of the import, as the form has them
 */

/** @param {import("../main.js").App} app @param {(draft: DraftView) => void} onDraft */
export function importForm(app, onDraft) {
  const input = h("input", { type: "file", multiple: true, accept: ACCEPTED, id: "plan-files" });
  const more = h("div", { class: "stack" });
  const preview = h("div", { class: "stack" });
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go", disabled: true }, t("import-read"));
  /** @type {Options} */
  let options = () => ({});
  /** @type {string[] | null} */
  let layers = null;
  const choose = () => {
    const names = [...(input.files ?? [])].map(({ name }) => name);
    const isMap = names.some((name) => IS_MAP.test(name));
    layers = null;
    problem.textContent = "";
    go.disabled = !names.length;
    options = () => ({});
    put(more);
    put(preview);
    if (isMap) options = mapFields(more);
    else if (names.some((name) => IS_PICTURE.test(name))) options = pictureFields(more);
    if (names.some((name) => IS_DRAWING.test(name))) options = drawingFields(more);
  };
  input.addEventListener("change", choose);
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const { files } = input;
    if (!files?.length) return;
    problem.textContent = "";
    put(preview);
    go.disabled = true;
    const sent = new FormData();
    for (const file of files) sent.append("files", file);
    sent.append("options", JSON.stringify({ title: titleOf(files), ...options(), ...(layers && { layers }) }));
    try {
      /** @type {DraftView} */
      const draft = await app.api.call("POST", "/floorplans/import", sent);
      if (IS_DRAWING.test(files[0].name) && !layers && draft.layers.length > 1) offerLayers(draft);
      put(
        preview,
        importPreview(draft, () => onDraft(draft)),
      );
    } catch (error) {
      problem.textContent = failureWords(error);
    }
    go.disabled = false;
  };
  /** Ask which layers of a drawing are walls. @param {DraftView} draft */
  const offerLayers = (draft) => {
    const chosen = new Set(draft.taken);
    layers = draft.taken;
    const boxes = draft.layers.map((layer) => {
      const box = h("input", { type: "checkbox", checked: draft.taken.includes(layer) });
      box.addEventListener("change", () => {
        if (box.checked) chosen.add(layer);
        else chosen.delete(layer);
        layers = [...chosen];
      });
      return h("label", { class: "choice" }, box, h("b", { class: "grow" }, layer));
    });
    more.append(
      h(
        "fieldset",
        { class: "layers stack" },
        h("legend", {}, t("import-layers")),
        h("p", { class: "quiet small" }, t("import-layers-hint")),
        boxes,
      ),
    );
  };
  return h(
    "form",
    { class: "card stack import-form", onsubmit: submit },
    h("h2", {}, t("import-title")),
    h("p", { class: "quiet small" }, t("import-lead")),
    field(t("import-files"), input, t("import-files-hint", { megabytes: REFERENCE.numbers.upload_megabytes })),
    more,
    problem,
    h("div", {}, go),
    preview,
  );
}

/** The name of the first file without its ending. @param {FileList} files */
function titleOf(files) {
  const plain = files[0].name.replace(/\.[^.]*$/, "").slice(0, 80);
  return plain || t("plans-new-title");
}

/** The fields for a picture. @param {HTMLElement} place @returns {Options} */
function pictureFields(place) {
  const value = h("input", { type: "number", step: "any", min: 0, required: true, inputmode: "decimal" });
  const threshold = h("input", {
    type: "number",
    step: "0.05",
    min: 0.05,
    max: 0.95,
    value: 0.6,
    inputmode: "decimal",
  });
  let by = "width";
  const label = h("div", {});
  const show = () => put(label, field(t(`import-${by}`), value, t(`import-${by}-hint`)));
  show();
  put(
    place,
    segments(
      t("import-scale"),
      ["width", "metres_per_pixel"].map((one) => ({ value: one, label: t(`import-by-${one}`) })),
      by,
      (chosen) => {
        by = chosen;
        show();
      },
    ),
    label,
    field(t("import-threshold"), threshold, t("import-threshold-hint")),
  );
  const outside = mapFields(place);
  return () => ({ [by]: value.valueAsNumber, threshold: threshold.valueAsNumber, ...outside() });
}

/** The choice that maps and pictures have. @param {HTMLElement} place @returns {Options} */
function mapFields(place) {
  let outside = false;
  place.append(
    toggle(t("import-outside"), outside, (on) => {
      outside = on;
    }),
    h("p", { class: "quiet small" }, t("import-outside-hint")),
  );
  return () => ({ outside });
}

/** The fields for a drawing. @param {HTMLElement} place @returns {Options} */
function drawingFields(place) {
  const unit = selection(
    [
      { value: "", label: t("import-unit-own") },
      ...UNITS.map((one) => ({ value: one, label: t(`import-unit-${one}`) })),
    ],
    "",
  );
  put(place, field(t("import-unit"), unit, t("import-unit-hint")));
  return () => (unit.value ? { unit: unit.value } : {});
}
