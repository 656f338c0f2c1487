/**
 * Form pieces: labelled fields, choices, segments, steppers.
 * @import { Child } from "types/dom"
 * @import { ComponentChildren, VNode } from "../preact.js"
 */
import { giveFocus } from "../focus.js";
import { cloneElement, h as draw, useState } from "../preact.js";
import { h, set, write } from "./dom.js";
import { number } from "./format.js";

let made = 0; // so that every label finds its own field
const HOLD_BEFORE = 400; // ms a stepper's button is held before it repeats
const REPEAT_EVERY = 90; // ms

/**
 * A labelled input, select or textarea.
 * @param {string} label @param {HTMLElement} input @param {string} [hint]
 */
export function field(label, input, hint) {
  const id = `field-${++made}`;
  set(input, { id, "aria-describedby": hint ? `${id}-hint` : null });
  return h(
    "div",
    { class: "field" },
    h("label", { for: id }, label),
    input,
    hint && h("span", { class: "hint", id: `${id}-hint` }, hint),
  );
}

/** A labelled control as a component; its child is the control. @param {{label: string, hint?: string, children?: ComponentChildren}} field */
export function Field({ label, hint, children: control }) {
  const [id] = useState(() => `field-${++made}`);
  const hintId = hint ? `${id}-hint` : undefined;
  return draw(
    "div",
    { class: "field" },
    draw("label", { for: id }, label),
    cloneElement(/** @type {VNode<any>} */ (control), { id, "aria-describedby": hintId }),
    hint && draw("span", { class: "hint", id: hintId }, hint),
  );
}

/**
 * @template {string} Value
 * @typedef {{value: Value, label: string, group?: string}} Option
 */

/**
 * Options of one group stand together, under its words.
 * @template {string} Value
 * @param {Option<Value>[]} options @param {NoInfer<Value> | null} chosen
 * @param {(value: NoInfer<Value>) => void} [onChange]
 */
export function selection(options, chosen, onChange) {
  /** @param {Option<Value>} option */
  const option = ({ value, label }) => h("option", { value, selected: value === chosen }, label);
  const groups = [...new Set(options.map(({ group }) => group))];
  /** @param {string | undefined} group */
  const members = (group) => options.filter((one) => one.group === group).map(option);
  const select = h(
    "select",
    {},
    groups.map((group) => (group ? h("optgroup", { label: group }, members(group)) : members(group))),
  );
  if (onChange) select.addEventListener("change", () => onChange(/** @type {Value} */ (select.value)));
  return select;
}

/**
 * A selection as a component; other attributes are those of its element.
 * @template {string} Value
 * @param {{options: Option<Value>[], chosen: NoInfer<Value> | null, onChange: (value: NoInfer<Value>) => void,
 *   "aria-label"?: string}} selection
 */
export function Selection({ options, chosen, onChange, ...attributes }) {
  /** @param {string | undefined} name */
  const members = (name) =>
    options
      .filter(({ group }) => group === name)
      .map(({ value, label }) => draw("option", { key: value, value, selected: value === chosen }, label));
  const groups = [...new Set(options.map(({ group }) => group))];
  return draw(
    "select",
    {
      ...attributes,
      onChange: (/** @type {Event} */ { currentTarget }) =>
        onChange(/** @type {Value} */ (/** @type {HTMLSelectElement} */ (currentTarget).value)),
    },
    groups.map((label) => (label ? draw("optgroup", { key: label, label }, members(label)) : members(label))),
  );
}

/**
 * A few choices side by side.
 * @template {string} Value
 * @param {string} label @param {Option<Value>[]} options @param {NoInfer<Value> | null} chosen
 * @param {(value: NoInfer<Value>) => void} onChange
 */
export function segments(label, options, chosen, onChange) {
  const name = `segments-${++made}`;
  return h(
    "div",
    { class: "segments", role: "radiogroup", "aria-label": label },
    options.map((option) =>
      h(
        "label",
        {},
        h("input", {
          type: "radio",
          name,
          value: option.value,
          checked: option.value === chosen,
          onchange: () => onChange(option.value),
        }),
        option.label,
      ),
    ),
  );
}

/**
 * The same as a component; `disabled`: the values that cannot be chosen.
 * @param {{label: string, options: Option<string>[], chosen: string, hidden?: boolean, disabled?: string[],
 *   onChange(value: string): void}} segments
 */
export function Segments({ label, options, chosen, hidden, disabled = [], onChange }) {
  const [name] = useState(() => `segments-${++made}`);
  return draw(
    "div",
    { class: "segments", role: "radiogroup", "aria-label": label, hidden },
    options.map(({ value, label: words }) =>
      draw(
        "label",
        { key: value },
        draw("input", {
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
 * @template {string} Value
 * @typedef {{words: string, options: Choice<Value>[]}} ChoiceGroup
 */

/**
 * Choices with an explanation each, one below the other; those of one group stand together, under its words.
 * @template {string} Value
 * @param {string} label @param {(Choice<Value> | ChoiceGroup<Value>)[]} options @param {NoInfer<Value> | null} chosen
 * @param {(value: NoInfer<Value>) => void} onChange
 */
export function choices(label, options, chosen, onChange) {
  const name = `choices-${++made}`;
  /** @param {Choice<Value>} option */
  const one = (option) =>
    h(
      "label",
      { class: "choice" },
      h("input", {
        type: "radio",
        name,
        value: option.value,
        checked: option.value === chosen,
        onchange: () => onChange(option.value),
      }),
      h("span", { class: "grow" }, h("b", {}, option.label), option.hint && h("span", {}, option.hint)),
    );
  /** @param {ChoiceGroup<Value>} choices */
  const group = ({ words, options: members }) =>
    h("div", { class: "stack", role: "group", "aria-label": words }, h("h3", {}, words), members.map(one));
  return h(
    "div",
    { class: "stack", role: "radiogroup", "aria-label": label },
    options.map((option) => ("options" in option ? group(option) : one(option))),
  );
}

/**
 * Choices with an explanation each, as a component.
 * @template {string} Value
 * @param {{label: string, options: (Choice<Value> | ChoiceGroup<Value>)[], chosen: NoInfer<Value> | null,
 *   onChange: (value: NoInfer<Value>) => void}} choices
 */
export function Choices({ label, options, chosen, onChange }) {
  const [name] = useState(() => `choices-${++made}`);
  /** @param {Choice<Value>} choice */
  const one = ({ value, label: words, hint }) =>
    draw(
      "label",
      { class: "choice", key: value },
      draw("input", { type: "radio", name, value, checked: value === chosen, onChange: () => onChange(value) }),
      draw("span", { class: "grow" }, draw("b", {}, words), hint && draw("span", {}, hint)),
    );
  /** @param {ChoiceGroup<Value>} group */
  const group = ({ words, options: members }) =>
    draw(
      "div",
      { class: "stack", role: "group", "aria-label": words, key: words },
      draw("h3", {}, words),
      members.map(one),
    );
  return draw(
    "div",
    { class: "stack", role: "radiogroup", "aria-label": label },
    options.map((option) => ("options" in option ? group(option) : one(option))),
  );
}

/** @param {string} label @param {boolean} on @param {(on: boolean) => void} onChange */
export function toggle(label, on, onChange) {
  const input = h("input", { type: "checkbox", role: "switch", checked: on });
  input.addEventListener("change", () => onChange(input.checked));
  return h("label", { class: "switch" }, input, h("span", {}, label));
}

/** A switch as a component. @param {{label: string, on: boolean, onChange: (on: boolean) => void}} toggle */
export function Toggle({ label, on, onChange }) {
  return draw(
    "label",
    { class: "switch" },
    draw("input", {
      type: "checkbox",
      role: "switch",
      defaultChecked: on, // what differs from it is a change that was not sent
      checked: on,
      onChange: (/** @type {Event} */ { currentTarget }) =>
        onChange(/** @type {HTMLInputElement} */ (currentTarget).checked),
    }),
    draw("span", {}, label),
  );
}

/**
 * A number between − and +; holding a button goes on.
 * @param {{label: string, value: number, low: number, high: number, step: number, digits: number, unit: string, onChange: (value: number) => void}} options
 */
export function stepper({ label, value, low, high, step, digits, unit, onChange }) {
  let now = value;
  const shown = h("output", { "aria-live": "off" });
  const less = h("button", { type: "button", "aria-label": `${label} −` }, "−");
  const more = h("button", { type: "button", "aria-label": `${label} +` }, "+");
  const show = () => {
    write(shown, `${number(now, digits)} ${unit}`.trim());
    less.disabled = now <= low + step / 1000;
    more.disabled = now >= high - step / 1000;
    // At the end of the range, the other button has the focus.
    if (element.contains(document.activeElement)) giveFocus(element.querySelector(":enabled"));
  };
  /** @param {1 | -1} direction */
  const turn = (direction) => {
    now = nextStep(now, direction, { low, high, step });
    show();
    onChange(now);
  };
  repeatWhileHeld(less, () => turn(-1));
  repeatWhileHeld(more, () => turn(1));
  const element = h("span", { class: "stepper", role: "group", "aria-label": label }, less, shown, more);
  show();
  /** @param {number} other */
  const setValue = (other) => {
    now = other;
    show();
  };
  return Object.assign(element, { setValue });
}

/**
 * The number one step further, within its limits; each step leads to a whole number of steps.
 * @param {number} value @param {1 | -1} direction @param {{low: number, high: number, step: number}} range
 */
export function nextStep(value, direction, { low, high, step }) {
  const next = Math.min(high, Math.max(low, Math.round((value + direction * step) / step) * step));
  return Number(next.toFixed(6));
}

/**
 * A line with words at the left and its control at the right.
 * @param {string} title @param {Child} hint a text, or several of them @param {Node} control
 */
export function setting(title, hint, control) {
  const hints = [hint].flat().filter(Boolean);
  return h(
    "div",
    { class: "setting" },
    h(
      "div",
      { class: "words" },
      h("b", { class: "small" }, title),
      hints.map((one) => (one instanceof Node ? one : h("span", {}, one))),
    ),
    control,
  );
}

/** @param {HTMLButtonElement} button @param {() => void} act */
export function repeatWhileHeld(button, act) {
  let timer = 0;
  const end = () => clearTimeout(timer);
  const again = () => {
    if (button.disabled || !button.isConnected) return end();
    act();
    timer = setTimeout(again, REPEAT_EVERY);
  };
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    act();
    end();
    timer = setTimeout(again, HOLD_BEFORE);
  });
  for (const event of ["pointerup", "pointerleave", "pointercancel"]) button.addEventListener(event, end);
  button.addEventListener("click", (event) => event.detail === 0 && act());
}
