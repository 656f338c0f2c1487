/** How the chair drives: control mode per axis in words, speeds with their units, tremor damping. */
import { t } from "../texts.js";
import { h } from "./dom.js";
import { choices, setting, stepper } from "./fields.js";

const DEGREES = 180 / Math.PI; // people read degrees, the chair radians
const SPEEDS = [
  { name: "forward", unit: "speed", step: 0.05, digits: 2, factor: 1 },
  { name: "reverse", unit: "speed", step: 0.05, digits: 2, factor: 1 },
  { name: "turn", unit: "turn", step: 5, digits: 0, factor: DEGREES },
  { name: "acceleration", unit: "acceleration", step: 0.1, digits: 1, factor: 1 },
  { name: "deceleration", unit: "acceleration", step: 0.1, digits: 1, factor: 1 },
  { name: "turn_acceleration", unit: "turn_acceleration", step: 20, digits: 0, factor: DEGREES },
];

/** @param {import("./controls_draft.js").ControlsDraft} draft */
export function modesCard(draft) {
  const axis = (name) =>
    h(
      "div",
      {},
      h("h3", {}, t(`how.${name}`)),
      choices(
        t(`how.${name}`),
        ["acceleration", "velocity"].map((mode) => ({
          value: mode,
          label: t(`how.${name}.${mode}`),
          hint: t(`how.${name}.${mode}.hint`),
        })),
        draft.settings[`mode_${name}`],
        (mode) => draft.setValue(`mode_${name}`, mode),
      ),
    );
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("how.title")),
    h("div", { class: "stack" }, axis("u1"), axis("u2")),
  );
}

/** @param {import("./controls_draft.js").ControlsDraft} draft */
export function speedsCard(draft) {
  const { speeds, cutoff } = draft.settings;
  const rows = SPEEDS.map(({ name, unit, step, digits, factor }) => {
    const [low, high] = draft.limits[name];
    const label = t(`speed.${name}`);
    // Whole steps of what people read, within what the chair may do.
    const onChange = (value) => draft.setSpeed(name, Math.min(high, Math.max(low, value / factor)));
    return setting(
      label,
      "",
      stepper({
        label,
        value: speeds[name] * factor,
        low: low * factor,
        high: high * factor,
        step,
        digits,
        unit: t(`unit.${unit}`),
        onChange,
      }),
    );
  });
  const [low, high] = draft.limits.cutoff;
  const damping = stepper({
    label: t("speed.cutoff"),
    value: cutoff,
    low,
    high,
    step: 0.5,
    digits: 1,
    unit: t("unit.cutoff"),
    onChange: (value) => draft.setValue("cutoff", value),
  });
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("speeds.title")),
    rows,
    setting(t("speed.cutoff"), t("speed.cutoff.hint"), damping),
  );
}
