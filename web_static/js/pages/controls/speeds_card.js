/**
 * How the chair drives: control mode per axis in words, speeds with their units, tremor damping, time-outs.
 * @import { ControlsStore, Settings } from "./store.js"
 */
import { h } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { Choices } from "../../widgets/fields.js";
import { Setting, Stepper } from "../../widgets/setting.js";
import { SpeedRows, SPEEDS, speedWords } from "../../widgets/speed_rows.js";

const MODES = ["acceleration", "velocity"];

/** @param {{store: ControlsStore}} card */
export function ModesCard({ store: { settings, change } }) {
  /** @param {"u1" | "u2"} name */
  const axis = (name) =>
    h(
      "div",
      {},
      h("h3", {}, t(`how-${name}`)),
      h(Choices, {
        label: t(`how-${name}`),
        options: MODES.map((mode) => ({
          value: mode,
          label: t(`how-${name}-${mode}`),
          hint: t(`how-${name}-${mode}-hint`),
        })),
        chosen: settings.value[`mode_${name}`],
        onChange: (mode) => change({ ...settings.value, [`mode_${name}`]: /** @type {Settings["mode_u1"]} */ (mode) }),
      }),
    );
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("how-title")),
    h("div", { class: "stack" }, axis("u1"), axis("u2")),
  );
}

/** A remark stands where a smaller limit than the set's own applies. @param {{store: ControlsStore}} card */
export function SpeedsCard({ store }) {
  const { settings, view, change } = store;
  const { speeds, mode_u1: ahead, mode_u2: turning } = settings.value;
  const { held, parameters } = view.value;
  const lower = SPEEDS.filter(({ name }) => held[name] < parameters.speeds[name]);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("speeds-title")),
    h(SpeedRows, {
      speeds,
      notes: Object.fromEntries(
        lower.map((speed) => [speed.name, t("speed-held", { value: speedWords(speed, held[speed.name]) })]),
      ),
      onChange: (name, value) => change({ ...settings.value, speeds: { ...settings.value.speeds, [name]: value } }),
    }),
    h(Value, { store, name: "cutoff", step: 0.5, digits: 1 }),
    ahead === "acceleration" && h(Value, { store, name: "cruise_time", step: 1, digits: 0 }),
    turning === "acceleration" && h(Value, { store, name: "turn_cruise_time", step: 1, digits: 0 }),
  );
}

/**
 * A setting that is one number.
 * @param {object} value
 * @param {ControlsStore} value.store @param {"cutoff" | "cruise_time" | "turn_cruise_time"} value.name
 * @param {number} value.step @param {number} value.digits after the point
 */
function Value({ store: { settings, change }, name, step, digits }) {
  const { minimum, maximum } = limitsOf("ControlSettings", name);
  const label = t(`speed-${name}`);
  return h(
    Setting,
    { title: label, hint: t(`speed-${name}-hint`) },
    h(Stepper, {
      label,
      value: settings.value[name],
      low: minimum ?? 0,
      high: maximum ?? Infinity,
      step,
      digits,
      unit: t(`unit-${name}`),
      onChange: (value) => change({ ...settings.value, [name]: value }),
    }),
  );
}
