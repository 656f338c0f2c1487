/**
 * A line of settings: words at the left, and at the right their control, such as a number between − and +.
 * @import { ComponentChildren } from "../preact.js"
 */
import { giveFocus } from "../focus.js";
import { h, useLayoutEffect, useRef } from "../preact.js";
import { number } from "./format.js";
import { repeatWhileHeld } from "./held_button.js";

/**
 * @param {{title: string, hint?: string, note?: string, children?: ComponentChildren}} setting
 *   note: a remark below the hint
 */
export function Setting({ title, hint, note, children: control }) {
  return h(
    "div",
    { class: "setting" },
    h(
      "div",
      { class: "words" },
      h("b", { class: "small" }, title),
      hint && h("span", {}, hint),
      note && h("span", { class: "held" }, note),
    ),
    control,
  );
}

/**
 * A number between − and +; holding a button goes on.
 * @param {object} stepper
 * @param {string} stepper.label @param {number} stepper.value
 * @param {number} stepper.low @param {number} stepper.high @param {number} stepper.step
 * @param {number} stepper.digits after the point @param {string} stepper.unit
 * @param {(value: number) => void} stepper.onChange
 */
export function Stepper({ label, value, low, high, step, digits, unit, onChange }) {
  /** @param {1 | -1} direction */
  const turn = (direction) => onChange(nextStep(value, direction, { low, high, step }));
  return h(
    "span",
    { class: "stepper", role: "group", "aria-label": label },
    h(HeldButton, { label: `${label} −`, isOff: value <= low + step / 1000, onPress: () => turn(-1) }, "−"),
    h("output", { "aria-live": "off" }, `${number(value, digits)} ${unit}`.trim()),
    h(HeldButton, { label: `${label} +`, isOff: value >= high - step / 1000, onPress: () => turn(1) }, "+"),
  );
}

/**
 * The number one step further, within its limits; each step leads to a whole number of steps.
 * @param {number} value @param {1 | -1} direction @param {{low: number, high: number, step: number}} range
 */
function nextStep(value, direction, { low, high, step }) {
  const next = Math.min(high, Math.max(low, Math.round((value + direction * step) / step) * step));
  return Number(next.toFixed(6));
}

/**
 * A button that acts again and again while it is held.
 * @param {{label: string, isOff: boolean, onPress: () => void, children?: ComponentChildren}} button
 */
function HeldButton({ label, isOff, onPress, children }) {
  const button = useRef(/** @type {HTMLButtonElement | null} */ (null));
  const press = useRef(onPress);
  press.current = onPress; // from the value that is shown now
  useLayoutEffect(() => {
    if (button.current) repeatWhileHeld(button.current, () => press.current());
  }, []);
  useLayoutEffect(() => {
    const { current: held } = button;
    // At the end of the range, the other button has the focus.
    if (isOff && held && held === document.activeElement) giveFocus(held.parentElement?.querySelector(":enabled"));
  }, [isOff]);
  return h("button", { type: "button", "aria-label": label, disabled: isOff, ref: button }, children);
}
