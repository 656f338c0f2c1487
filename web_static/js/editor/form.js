/** The rows of the form at the side: numbers in their units, texts, buttons. */
import { h, useSignal } from "../preact.js";
import { Field } from "../widgets/fields.js";

const DEGREES = 180 / Math.PI;

/**
 * A number in its unit; an empty field is null.
 * @param {object} row
 * @param {string} row.label @param {number | null} row.value @param {string} row.unit @param {string} [row.placeholder]
 * @param {(value: number | null) => unknown} row.onChange
 */
export function NumberRow({ label, value, unit, placeholder, onChange }) {
  return h(
    Field,
    { label: `${label} (${unit})` },
    h(Input, {
      type: "number",
      step: "any",
      inputmode: "decimal",
      placeholder,
      value: value === null ? "" : String(Number(value.toFixed(unit === "°" ? 1 : 3))),
      onChange: ({ valueAsNumber }) => onChange(Number.isFinite(valueAsNumber) ? valueAsNumber : null),
    }),
  );
}

/**
 * An angle in degrees; an empty field is null.
 * @param {object} row
 * @param {string} row.label @param {number | null} row.value rad @param {string} [row.placeholder]
 * @param {(value: number | null) => unknown} row.onChange
 */
export function AngleRow({ label, value, placeholder, onChange }) {
  return h(NumberRow, {
    label,
    value: value === null ? null : value * DEGREES,
    unit: "°",
    placeholder,
    onChange: (degrees) => onChange(degrees === null ? null : Number((degrees / DEGREES).toFixed(4))),
  });
}

/** @param {{label: string, value: string | undefined, maxlength: number, onChange: (value: string) => void}} row */
export function TextRow({ label, value = "", maxlength, onChange }) {
  return h(
    Field,
    { label },
    h(Input, {
      type: "text",
      maxlength,
      autocomplete: "off",
      value,
      onChange: ({ value: typed }) => typed.trim() && onChange(typed.trim()),
    }),
  );
}

/**
 * An input whose value changes when it is left, or by Enter; what is not accepted gives way to the value again.
 * @param {object} input
 * @param {"text" | "number"} input.type @param {string} input.value
 * @param {(input: HTMLInputElement) => unknown} input.onChange
 * @param {string} [input.step] @param {number} [input.min] @param {number} [input.max]
 * @param {number} [input.maxlength] @param {string} [input.inputmode]
 * @param {string} [input.placeholder] @param {string} [input.autocomplete]
 */
export function Input({ value, onChange, ...attributes }) {
  const typed = useSignal(/** @type {string | null} */ (null)); // null: nothing since the last change
  return h("input", {
    ...attributes,
    value: typed.value ?? value,
    onInput: (/** @type {{currentTarget: HTMLInputElement}} */ { currentTarget }) =>
      void (typed.value = currentTarget.value),
    onChange: (/** @type {{currentTarget: HTMLInputElement}} */ { currentTarget }) => {
      onChange(currentTarget);
      typed.value = null;
    },
  });
}

/** @param {{words: string, label?: string, onClick: () => unknown}} button label: for screen readers */
export function Button({ words, label, onClick }) {
  return h("button", { type: "button", class: "btn small", "aria-label": label, onClick }, words);
}
