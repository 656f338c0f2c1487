/**
 * How the chair drives: control mode per axis in words, speeds with their units, tremor damping, time-outs.
 * @import { ControlsDraft, ValueName } from "./controls_draft.js"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { choices, setting, stepper } from "../../widgets/fields.js";
import { SPEEDS, speedRows, speedWords } from "../../widgets/speed_rows.js";

const MODES = /** @type {const} */ (["acceleration", "velocity"]);

/** @param {ControlsDraft} draft */
export function modesCard(draft) {
  /** @param {"u1" | "u2"} name */
  const axis = (name) =>
    h(
      "div",
      {},
      h("h3", {}, t(`how-${name}`)),
      choices(
        t(`how-${name}`),
        MODES.map((mode) => ({
          value: mode,
          label: t(`how-${name}-${mode}`),
          hint: t(`how-${name}-${mode}-hint`),
        })),
        draft.settings[`mode_${name}`],
        (mode) => draft.setMode(`mode_${name}`, mode),
      ),
    );
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("how-title")),
    h("div", { class: "stack" }, axis("u1"), axis("u2")),
  );
}

/**
 * `showLowered` notes where a smaller limit than the set's own applies.
 * @param {ControlsDraft} draft
 */
export function speedsCard(draft) {
  const rows = speedRows(draft.settings.speeds, draft.limits, (name, value) => draft.setSpeed(name, value), {
    hasNumbers: false,
  });
  const showLowered = () => {
    for (const speed of SPEEDS) {
      const [own, limit] = [draft.settings.speeds[speed.name], draft.view.held?.[speed.name]];
      rows.note(speed.name, limit < own ? t("speed-held", { value: speedWords(speed, limit) }) : "");
    }
  };
  /** @param {"u1" | "u2"} axis */
  const keeps = (axis) => draft.settings[`mode_${axis}`] === "acceleration";
  showLowered();
  const element = h(
    "section",
    { class: "card" },
    h("h2", {}, t("speeds-title")),
    rows.elements,
    value(draft, "cutoff", { step: 0.5, digits: 1 }),
    keeps("u1") && value(draft, "cruise_time", { step: 1, digits: 0 }),
    keeps("u2") && value(draft, "turn_cruise_time", { step: 1, digits: 0 }),
  );
  return { element, showLowered };
}

/** @param {ControlsDraft} draft @param {ValueName} name @param {{step: number, digits: number}} scale */
function value(draft, name, { step, digits }) {
  const [low, high] = draft.limits[name];
  const label = t(`speed-${name}`);
  const control = stepper({
    label,
    value: draft.settings[name],
    low,
    high,
    step,
    digits,
    unit: t(`unit-${name}`),
    onChange: (chosen) => draft.setValue(name, chosen),
  });
  return setting(label, t(`speed-${name}-hint`), control);
}
