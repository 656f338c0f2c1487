/**
 * The fields of a shirt's configuration, made of its JSON schema (docs/drivers.md): a new kind of shirt needs no code here.
 * @import { App } from "../../main.js"
 * @import { FileView, ShirtLayout } from "types/api"
 * @import { ConfigSchema, FieldSchema, ShirtConfig } from "types/documents"
 * @import { ReadonlySignal, VNode } from "../../preact.js"
 * @typedef {object} Surroundings what the fields offer
 * @property {App} app
 * @property {ShirtConfig | null} now the configuration in use when it is of this kind
 * @property {ReadonlySignal<ShirtLayout | null>} layout of the shirt in use
 * @property {ReadonlySignal<FileView[]>} files @property {ReadonlySignal<string[]>} keys names of the keys of paired shirts
 * @property {ReadonlySignal<string[]>} found names of the sensors that the shirt in use has found
 * @property {ReadonlySignal<ShirtLayout[]>} layouts those that were saved
 * @typedef {{element: VNode<any> | null, isNarrow?: boolean, read: () => unknown}} FormField narrow ones stand side by side
 * @typedef {(schema: FieldSchema, value: any, around: Surroundings) => FormField} Maker makes a field that shows `value`
 */
import { h, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Segments, Selection, Toggle } from "../../widgets/fields.js";
import { unrounded } from "../../widgets/format.js";
import { Stepper } from "../../widgets/setting.js";
import { AddFile, FileField, ImportLink } from "./signal_files.js";

const REPLAYED = new Set(["signals", "recording"]);
const LEAST_CHANNELS = 3; // with fewer, two choices of channels would name the same ones

/** Makers of fields by the `format` of their schema. @type {Record<string, Maker>} */
const OF_FORMAT = {
  hidden: (_schema, value) => ({ element: null, read: () => value }),
  "signal-file": signalFile,
  "shirt-key": shirtKey,
  tracker,
  layout: layoutFile,
  channels,
  stepper: steps,
};

/**
 * The fields of a schema, and what reads them; a file that is no JSON document rejects with a sentence.
 * @param {ConfigSchema} form @param {Surroundings} around
 * @returns {{fields: VNode<any>[], config: () => Promise<Record<string, unknown>>}}
 */
export function configFields(form, around) {
  const { kind, ...properties } = form.properties;
  /** @type {[string, FormField][]} */
  const made = Object.entries(properties).map(([name, schema]) => {
    const value = around.now?.[name] ?? schema.default;
    return [name, makerOf(schema)({ ...valueSchema(schema), ...schema }, value, around)];
  });
  const bringsFiles = Object.values(properties).some(({ format }) => format === "signal-file");
  return {
    fields: [
      ...inColumns(made.map(([, one]) => one)),
      ...(bringsFiles ? [h(AddFile, { app: around.app }), h(ImportLink, {})] : []),
    ],
    config: async () => {
      const values = await Promise.all(made.map(async ([name, { read }]) => [name, await read()]));
      return { kind: kind.const, ...Object.fromEntries(values) };
    },
  };
}

/** The schema of the value of a field that may also be null. @param {FieldSchema} schema */
const valueSchema = (schema) => schema.anyOf?.find(({ type }) => type !== "null") ?? schema;

/** @param {FieldSchema} schema @returns {Maker} */
function makerOf(schema) {
  const { type, examples, enum: values } = { ...valueSchema(schema), ...schema };
  if (schema.format && schema.format in OF_FORMAT) return OF_FORMAT[schema.format];
  if (examples || values) return offered;
  if (type === "boolean") return flag;
  return type === "string" ? text : figure;
}

/** Consecutive narrow fields stand side by side. @param {FormField[]} fields @returns {VNode<any>[]} */
function inColumns(fields) {
  /** @type {{isNarrow: boolean, elements: VNode<any>[]}[]} */
  const rows = [];
  for (const { element, isNarrow = false } of fields) {
    if (!element) continue;
    const last = rows.at(-1);
    if (isNarrow && last?.isNarrow) last.elements.push(element);
    else rows.push({ isNarrow, elements: [element] });
  }
  return rows.map(({ elements }) => (elements.length > 1 ? h("div", { class: "columns" }, elements) : elements[0]));
}

/** @param {FieldSchema} schema */
const isOptional = ({ anyOf = [] }) => anyOf.some(({ type }) => type === "null");

/**
 * An input that keeps what is typed, and what reads that.
 * @param {string} label @param {string | undefined} hint @param {unknown} value @param {object} attributes
 */
function typedField(label, hint, value, attributes) {
  let typed = String(value ?? "");
  const onInput = (/** @type {Event} */ { currentTarget }) =>
    void (typed = /** @type {HTMLInputElement} */ (currentTarget).value.trim());
  const element = h(Field, { label, hint }, h("input", { defaultValue: typed, ...attributes, onInput }));
  return { element, typed: () => typed };
}

/** @type {Maker} */
function text(schema, value) {
  const { title = "", description, minLength, maxLength } = schema;
  const limits = { minlength: minLength, maxlength: maxLength, required: !isOptional(schema) };
  const { element, typed } = typedField(title, description, value, { type: "text", ...limits, autocomplete: "off" });
  return { element, isNarrow: true, read: () => typed() || (isOptional(schema) ? null : "") };
}

/** @type {Maker} */
function figure(schema, value) {
  const { title = "", description, unit, minimum, maximum, type } = schema;
  const step = type === "integer" ? 1 : "any";
  const limits = { min: minimum, max: maximum, step, required: !isOptional(schema) };
  const label = unit ? t("source-unit", { value: title, unit: `(${unit})` }) : title;
  const { element, typed } = typedField(label, description, value, { type: "number", ...limits });
  return { element, isNarrow: true, read: () => (typed() === "" && isOptional(schema) ? null : Number(typed())) };
}

/** A selection among the values that the schema offers, and the one in use. @type {Maker} */
function offered({ title = "", description, unit = "", examples, enum: values, titles = {} }, value) {
  const all = values ?? [...new Set([...(examples ?? []), value])].sort((a, b) => Number(a) - Number(b));
  let chosen = value ?? all[0];
  const words = (/** @type {string | number} */ one) =>
    typeof one === "number" ? unrounded(one) : (titles[one] ?? one);
  const options = all.map((one) => ({
    value: String(one),
    label: t("source-unit", { value: words(one), unit }).trim(),
  }));
  const onChange = (/** @type {string} */ name) => void (chosen = all.find((one) => String(one) === name) ?? chosen);
  const select = h(Selection, { options, chosen: String(chosen), onChange });
  return { element: h(Field, { label: title, hint: description }, select), read: () => chosen };
}

/** @type {Maker} */
function flag({ title = "" }, value) {
  let on = Boolean(value);
  const element = h(Toggle, { label: title, on, onChange: (/** @type {boolean} */ isOn) => void (on = isOn) });
  return { element, read: () => on };
}

/** A whole number between − and +. @type {Maker} */
function steps({ title = "", unit = "", minimum, maximum }, value) {
  let now = Number(value ?? minimum);
  const limits = { low: Number(minimum), high: Number(maximum), step: 1, digits: 0 };
  const Steps = () => {
    const shown = useSignal(now);
    const onChange = (/** @type {number} */ next) => void (now = shown.value = next);
    return h(Stepper, { label: title, value: shown.value, ...limits, unit, onChange });
  };
  return { element: row(title, h(Steps, {})), read: () => now };
}

/** Choices of channels by their place in the layout of the shirt in use, 0 to 1. @type {Maker} */
function channels({ title = "", choices = [] }, value, { now, layout }) {
  /** @type {string[]} */
  let names = value;
  const all = (now && layout.peek()?.channels.map(({ name }) => name)) ?? [];
  if (all.length < LEAST_CHANNELS) return { element: null, read: () => names };
  const sets = choices.map(({ at }) => at.map((place) => all[Math.floor(place * all.length)]));
  const options = choices.map((choice, i) => ({ value: String(i), label: choice.title }));
  const Sets = () => {
    const chosen = useSignal(
      sets.findIndex((set) => set.length === names.length && set.every((name, i) => name === names[i])),
    );
    const onChange = (/** @type {string} */ i) => void (names = sets[(chosen.value = Number(i))]);
    return h(Segments, { label: title, options, chosen: String(chosen.value), onChange });
  };
  return { element: row(title, h(Sets, {})), read: () => names };
}

/** A file of signals that lies on the machine; without one, the server says what is missing. @type {Maker} */
function signalFile({ title }, value, { files }) {
  const config = { file: value };
  const Replayed = () =>
    h(FileField, { files: files.value.filter(({ kind }) => REPLAYED.has(kind)), config, label: title });
  return { element: h(Replayed, {}), read: () => config.file };
}

/** @type {Maker} */
function shirtKey({ title = "", description }, value, { keys }) {
  let key = keys.peek().includes(value) ? value : "";
  const onChange = (/** @type {string} */ name) => void (key = name);
  const Key = () => {
    const options = ["", ...keys.value].map((name) => ({ value: name, label: name || t("source-key-none") }));
    return h(Field, { label: title, hint: description }, h(Selection, { options, chosen: key, onChange }));
  };
  return { element: h(Key, {}), read: () => key || null };
}

/** A selection among the sensors that the shirt in use has found, and the one in use. @type {Maker} */
function tracker({ title = "", description }, value, { found }) {
  let chosen = String(value ?? "");
  const onChange = (/** @type {string} */ name) => void (chosen = name);
  const Sensor = () => {
    const names = [...new Set(["", ...(value ? [String(value)] : []), ...found.value])];
    const options = names.map((name) => ({ value: name, label: name || t("source-sensor-none") }));
    return h(Field, { label: title, hint: description }, h(Selection, { options, chosen, onChange }));
  };
  return { element: h(Sensor, {}), isNarrow: true, read: () => chosen || null };
}

/**
 * A layout out of a file, or one that was saved. Without one: of a kind whose device describes its channels, what the
 * configuration in use has; of others the layout in use, and without that the kind's own. @type {Maker}
 */
function layoutFile(schema, value, { layout, layouts }) {
  const { title = "", description } = schema;
  /** @type {File | undefined} */
  let file;
  let name = ""; // of a layout that was saved; where there is one, there is no file
  const Layout = () => {
    const chosen = useSignal(name);
    const input = useRef(/** @type {HTMLInputElement | null} */ (null));
    const bring = (/** @type {Event} */ { currentTarget }) => {
      file = /** @type {HTMLInputElement} */ (currentTarget).files?.[0];
      if (file) name = chosen.value = "";
    };
    const choose = (/** @type {string} */ next) => {
      name = chosen.value = next;
      file = undefined;
      if (input.current) input.current.value = "";
    };
    const names = layouts.value.map((one) => one.name);
    const options = ["", ...names].map((one) => ({ value: one, label: one || t("source-layout-kept") }));
    const saved = h(Selection, { options, chosen: chosen.value, onChange: choose });
    const bringing = h("input", { type: "file", accept: ".json,application/json", onChange: bring, ref: input });
    return h(
      "div",
      { class: "stack" },
      names.length > 0 && h(Field, { label: t("source-layout-saved") }, saved),
      h(Field, { label: title, hint: description }, bringing),
    );
  };
  const saved = () => layouts.peek().find((one) => one.name === name);
  const kept = () => (isOptional(schema) ? (value ?? null) : (layout.peek() ?? undefined));
  return { element: h(Layout, {}), read: async () => (file ? readDocument(file) : (saved() ?? kept())) };
}

/** A line with a control. @param {string} title @param {VNode<any>} control */
const row = (title, control) => h("div", { class: "row" }, h("b", { class: "small" }, title), control);

/** @param {File} file @returns {Promise<ShirtLayout>} as far as the server accepts it */
async function readDocument(file) {
  try {
    return JSON.parse(await file.text());
  } catch {
    throw new Error(t("source-layout-wrong", { file: file.name }));
  }
}
