/**
 * The fields of a shirt's configuration, made of its JSON schema (docs/drivers.md): a new kind of shirt needs no code here.
 * @import { App } from "../../main.js"
 * @import { FileView, ShirtLayout } from "types/api"
 * @import { ConfigSchema, FieldSchema, ShirtConfig } from "types/documents"
 * @import { Child } from "types/dom"
 * @typedef {object} Surroundings what the fields offer
 * @property {App} app
 * @property {ShirtConfig | null} now the configuration in use when it is of this kind
 * @property {ShirtLayout | null} layout of the shirt in use
 * @property {FileView[]} files @property {string[]} keys names of the keys of paired shirts
 * @typedef {{element: Child, isNarrow?: boolean, read: () => unknown}} FormField narrow ones stand side by side
 * @typedef {(schema: FieldSchema, value: any, around: Surroundings) => FormField} Maker makes a field that shows `value`
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field, segments, selection, stepper, toggle } from "../../widgets/fields.js";
import { unrounded } from "../../widgets/format.js";
import { addFile, fileField } from "./signal_files.js";

const REPLAYED = new Set(["signals", "recording"]);
const LEAST_CHANNELS = 3; // with fewer, two choices of channels would name the same ones

/** Makers of fields by the `format` of their schema. @type {Record<string, Maker>} */
const OF_FORMAT = {
  hidden: (_schema, value) => ({ element: null, read: () => value }),
  "signal-file": signalFile,
  "shirt-key": shirtKey,
  layout: layoutFile,
  channels,
  stepper: steps,
};

/**
 * The fields of a schema, and what reads them; a file that is no JSON document rejects with a sentence.
 * @param {ConfigSchema} form @param {Surroundings} around
 * @returns {{fields: Child[], config: () => Promise<Record<string, unknown>>}}
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
    fields: [...inColumns(made.map(([, one]) => one)), bringsFiles && addFile(around.app)],
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

/** Consecutive narrow fields stand side by side. @param {FormField[]} fields @returns {Child[]} */
function inColumns(fields) {
  /** @type {FormField[][]} */
  const rows = [];
  for (const one of fields) {
    const last = rows.at(-1);
    if (one.isNarrow && last?.[0].isNarrow) last.push(one);
    else rows.push([one]);
  }
  return rows.map((row) => {
    const elements = row.map(({ element }) => element);
    return row.length > 1 ? h("div", { class: "columns" }, elements) : elements[0];
  });
}

/** @param {FieldSchema} schema */
const isOptional = ({ anyOf = [] }) => anyOf.some(({ type }) => type === "null");

/** @type {Maker} */
function text(schema, value) {
  const { title = "", description, minLength, maxLength } = schema;
  const limits = { minlength: minLength, maxlength: maxLength };
  const input = h("input", { type: "text", value, ...limits, required: !isOptional(schema), autocomplete: "off" });
  const read = () => input.value.trim() || (isOptional(schema) ? null : "");
  return { element: field(title, input, description), isNarrow: true, read };
}

/** @type {Maker} */
function figure(schema, value) {
  const { title = "", description, unit, minimum, maximum, type } = schema;
  const limits = { min: minimum, max: maximum, step: type === "integer" ? 1 : "any" };
  const input = h("input", { type: "number", value, ...limits, required: !isOptional(schema) });
  const read = () => (input.value === "" && isOptional(schema) ? null : Number(input.value));
  return {
    element: field(unit ? t("source-unit", { value: title, unit: `(${unit})` }) : title, input, description),
    isNarrow: true,
    read,
  };
}

/** A selection among the values that the schema offers, and the one in use. @type {Maker} */
function offered({ title = "", description, unit = "", examples, enum: values }, value) {
  const all = values ?? [...new Set([...(examples ?? []), value])].sort((a, b) => Number(a) - Number(b));
  let chosen = value ?? all[0];
  const options = all.map((one) => ({
    value: String(one),
    label: t("source-unit", { value: typeof one === "number" ? unrounded(one) : String(one), unit }).trim(),
  }));
  const select = selection(
    options,
    String(chosen),
    (name) => (chosen = all.find((one) => String(one) === name) ?? chosen),
  );
  return { element: field(title, select, description), read: () => chosen };
}

/** @type {Maker} */
function flag({ title = "" }, value) {
  let on = Boolean(value);
  return { element: toggle(title, on, (isOn) => (on = isOn)), read: () => on };
}

/** A whole number between − and +. @type {Maker} */
function steps({ title = "", unit = "", minimum, maximum }, value) {
  let now = Number(value ?? minimum);
  const onChange = (/** @type {number} */ next) => (now = next);
  const limits = { low: Number(minimum), high: Number(maximum), step: 1, digits: 0 };
  return { element: row(title, stepper({ label: title, value: now, ...limits, unit, onChange })), read: () => now };
}

/** Choices of channels by their place in the layout of the shirt in use, 0 to 1. @type {Maker} */
function channels({ title = "", choices = [] }, value, { now, layout }) {
  let names = value;
  const all = now && layout ? layout.channels.map(({ name }) => name) : [];
  if (all.length < LEAST_CHANNELS) return { element: null, read: () => names };
  const sets = choices.map(({ at }) => at.map((place) => all[Math.floor(place * all.length)]));
  const options = choices.map((choice, i) => ({ value: String(i), label: choice.title }));
  const chosen = sets.findIndex((set) => JSON.stringify(set) === JSON.stringify(value));
  const choose = (/** @type {string} */ i) => (names = sets[Number(i)]);
  return { element: row(title, segments(title, options, String(chosen), choose)), read: () => names };
}

/** A file of signals that lies on the machine; without one, the server says what is missing. @type {Maker} */
function signalFile({ title }, value, { files }) {
  const chosen = { file: value };
  const element = fileField(
    files.filter(({ kind }) => REPLAYED.has(kind)),
    chosen,
    title,
  );
  return { element, read: () => chosen.file };
}

/** @type {Maker} */
function shirtKey({ title = "", description }, value, { keys }) {
  let key = keys.includes(value) ? value : "";
  const options = ["", ...keys].map((name) => ({ value: name, label: name || t("source-key-none") }));
  const select = selection(options, key, (name) => (key = name));
  return { element: field(title, select, description), read: () => key || null };
}

/** A layout out of a file; without one the layout in use, and without that the kind's own. @type {Maker} */
function layoutFile({ title = "", description }, _value, { layout }) {
  const input = h("input", { type: "file", accept: ".json,application/json" });
  const read = async () => (input.files?.[0] ? readDocument(input.files[0]) : (layout ?? undefined));
  return { element: field(title, input, description), read };
}

/** @param {string} title @param {HTMLElement} control */
const row = (title, control) => h("div", { class: "row" }, h("b", { class: "small" }, title), control);

/** @param {File} file @returns {Promise<ShirtLayout>} as far as the server accepts it */
async function readDocument(file) {
  try {
    return JSON.parse(await file.text());
  } catch {
    throw new Error(t("source-layout-wrong", { file: file.name }));
  }
}
