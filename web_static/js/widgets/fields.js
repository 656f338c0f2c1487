/**
 * Pieces of a form: labelled fields, selections, choices, switches.
 * @import { ComponentChildren, VNode } from "../preact.js"
 */
import { cloneElement, h, useState } from "../preact.js";

let made = 0; // so that every label finds its own field

/** A labelled control; its child is the control. @param {{label: string, hint?: string, children?: ComponentChildren}} field */
export function Field({ label, hint, children: control }) {
  const [id] = useState(() => `field-${++made}`);
  const hintId = hint ? `${id}-hint` : undefined;
  return h(
    "div",
    { class: "field" },
    h("label", { for: id }, label),
    cloneElement(/** @type {VNode<any>} */ (control), { id, "aria-describedby": hintId }),
    hint && h("span", { class: "hint", id: hintId }, hint),
  );
}

/**
 * @template {string} Value
 * @typedef {{value: Value, label: string, group?: string}} Option
 */

/**
 * A selection; options of one group stand together, under its words. Other attributes are those of its element.
 * @template {string} Value
 * @param {{options: Option<Value>[], chosen: NoInfer<Value> | null, onChange: (value: NoInfer<Value>) => void,
 *   "aria-label"?: string}} selection
 */
export function Selection({ options, chosen, onChange, ...attributes }) {
  /** @param {string | undefined} name */
  const members = (name) =>
    options
      .filter(({ group }) => group === name)
      .map(({ value, label }) => h("option", { key: value, value, selected: value === chosen }, label));
  const groups = [...new Set(options.map(({ group }) => group))];
  return h(
    "select",
    {
      ...attributes,
      onChange: (/** @type {Event} */ { currentTarget }) =>
        onChange(/** @type {Value} */ (/** @type {HTMLSelectElement} */ (currentTarget).value)),
    },
    groups.map((label) => (label ? h("optgroup", { key: label, label }, members(label)) : members(label))),
  );
}

/**
 * A few choices side by side; `disabled`: the values that cannot be chosen.
 * @param {{label: string, options: Option<string>[], chosen: string, hidden?: boolean, disabled?: string[],
 *   onChange(value: string): void}} segments
 */
export function Segments({ label, options, chosen, hidden, disabled = [], onChange }) {
  const [name] = useState(() => `segments-${++made}`);
  return h(
    "div",
    { class: "segments", role: "radiogroup", "aria-label": label, hidden },
    options.map(({ value, label: words }) =>
      h(
        "label",
        { key: value },
        h("input", {
          type: "radio",
          name,
          value,
          checked: value === chosen,
          disabled: disabled.includes(value),
          onChange: () => onChange(value),
        }),
        words,
      ),
    ),
  );
}

/**
 * @template {string} Value
 * @typedef {{value: Value, label: string, hint?: string}} Choice
 */

/**
 * Choices with an explanation each, one below the other.
 * @template {string} Value
 * @param {{label: string, options: Choice<Value>[], chosen: NoInfer<Value> | null,
 *   onChange: (value: NoInfer<Value>) => void}} choices
 */
export function Choices({ label, options, chosen, onChange }) {
  const [name] = useState(() => `choices-${++made}`);
  return h(
    "div",
    { class: "stack", role: "radiogroup", "aria-label": label },
    options.map(({ value, label: words, hint }) =>
      h(
        "label",
        { class: "choice", key: value },
        h("input", { type: "radio", name, value, checked: value === chosen, onChange: () => onChange(value) }),
        h("span", { class: "grow" }, h("b", {}, words), hint && h("span", {}, hint)),
      ),
    ),
  );
}

/** A switch. @param {{label: string, on: boolean, onChange: (on: boolean) => void}} toggle */
export function Toggle({ label, on, onChange }) {
  return h(
    "label",
    { class: "switch" },
    h("input", {
      type: "checkbox",
      role: "switch",
      defaultChecked: on, // what differs from it is a change that was not sent
      checked: on,
      onChange: (/** @type {Event} */ { currentTarget }) =>
        onChange(/** @type {HTMLInputElement} */ (currentTarget).checked),
    }),
    h("span", {}, label),
  );
}
