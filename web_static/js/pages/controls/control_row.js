/**
 * One of the five controls: which gestures it answers to, their live bars, and the fine-tuning.
 * @import { Binding, Gesture } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { Control, ControlsDraft } from "./controls_draft.js"
 * @typedef {{name: string, which: "dead_zone" | "full", stepper: ReturnType<typeof stepper>}} Threshold a gesture's
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { selection, segments, setting, stepper } from "../../widgets/fields.js";
import { anyOf } from "../../widgets/format.js";
import { gestureFor, gestureWithin, gestureWords, jointLabels, TOGETHER } from "../../widgets/gestures.js";
import { handleBar } from "./handle_bar.js";
import { icon } from "../../widgets/icons.js";

/** @type {Gesture["feature"][]} */
const FEATURES = ["rate", "displacement"];
const THRESHOLD = { step: 1, digits: 0 }; // % of the full movement
const GAIN = { step: 0.1, digits: 1 };

/**
 * @param {Control} control @param {ControlsDraft} draft @param {boolean} isOpen
 * @param {(control: Control, isOpen: boolean) => void} onToggle
 */
export function controlRow(control, draft, isOpen, onToggle) {
  const binding = draft.binding(control);
  const labels = jointLabels(draft.profile);
  const gestures = binding.gestures.flatMap((name) => draft.gesture(name) ?? []);
  const words = gestures.map((gesture) => gestureWords(gesture, labels));
  const live = h("span", { class: "tag", style: "visibility:hidden" }, t("control-live"));
  const isStop = control === "stop";
  const bars = isStop
    ? []
    : gestures.map((gesture, i) => ({
        gesture,
        bar: handleBar(gesture, words[i], (from, full) => draft.setHandles(gesture.name, from, full)),
      }));
  const within = gestures.map((gesture) => gestureWithin(gesture, labels));
  const joined = (isStop ? within.join(TOGETHER) : anyOf(within)) || t("control-nothing");
  /** @type {Threshold[]} */
  const steppers = [];
  const tuning = h("div", { hidden: !isOpen }, fineTune(control, binding, gestures, words, labels, draft, steppers));
  const tune = h(
    "button",
    { type: "button", class: "btn bare small tune", "aria-expanded": String(isOpen) },
    t("tune"),
  );
  tune.addEventListener("click", () => {
    tuning.hidden = !tuning.hidden;
    tune.setAttribute("aria-expanded", String(!tuning.hidden));
    onToggle(control, !tuning.hidden);
  });
  const title = h("h2", {}, t(`control-${control}`), h("span", { class: "quiet" }, ` ← ${joined}`));
  const element = h(
    "section",
    { class: "control" },
    h("div", { class: "row" }, title, h("span", { class: "grow" }), live, tune),
    bars.map(({ bar }) => bar.element),
    isStop && h("p", { class: "quiet small" }, t("control-together")),
    tuning,
  );

  /** @param {LiveMessage} now */
  const showLive = (now) => {
    /** @param {string} name */
    const index = (name) => now.gestures.indexOf(name);
    for (const { gesture, bar } of bars) bar.showLive(now.rate[index(gesture.name)] ?? 0);
    const levels = gestures.map(({ name }) => now.activation[index(name)] ?? 0);
    const isLive =
      levels.length > 0 && (isStop ? levels.every((level) => level > 0) : levels.some((level) => level > 0));
    live.style.visibility = isLive ? "visible" : "hidden";
  };
  /** Follow handles that were moved elsewhere: on the bar, by the steppers, in another row. @param {Gesture} changed */
  const follow = (changed) => {
    for (const { gesture, bar } of bars)
      if (gesture.name === changed.name) bar.setHandles(changed.dead_zone, changed.full);
    for (const { name, which, stepper: one } of steppers) if (name === changed.name) one.setValue(100 * changed[which]);
  };
  return { element, showLive, follow };
}

/**
 * @param {Control} control @param {Binding} binding @param {Gesture[]} gestures @param {string[]} words of each gesture
 * @param {Record<string, string>} labels of the joints @param {ControlsDraft} draft @param {Threshold[]} steppers to add to
 */
function fineTune(control, binding, gestures, words, labels, draft, steppers) {
  const chips = gestures.map((gesture, i) =>
    h(
      "button",
      {
        type: "button",
        class: "btn small chip",
        "aria-label": t("tune-remove", { gesture: words[i] }),
        onclick: () => draft.unbind(control, gesture.name),
      },
      words[i],
      icon("cross", 16),
    ),
  );
  const [, highestGain] = draft.limits.gain;
  return h(
    "div",
    { class: "tuning" },
    setting(t("tune-gestures"), "", h("span", { class: "spread" }, chips, addGesture(control, binding, labels, draft))),
    control !== "stop" &&
      setting(
        t("tune-gain"),
        t("tune-gain-hint"),
        stepper({
          label: t("tune-gain"),
          value: binding.gain,
          low: 0,
          high: highestGain,
          ...GAIN,
          unit: "×",
          onChange: (gain) => draft.setGain(control, gain),
        }),
      ),
    control !== "stop" && gestures.map((gesture, i) => oneGesture(gesture, words[i], draft, steppers)),
  );
}

/** @param {Gesture} gesture @param {string} words @param {ControlsDraft} draft @param {Threshold[]} steppers to add to */
function oneGesture(gesture, words, draft, steppers) {
  const unit = t(`unit-${gesture.feature}`);
  const high = 100 * draft.limits.threshold[1];
  /** @param {"from" | "full"} place @param {Threshold["which"]} which @param {(value: number) => void} onChange */
  const threshold = (place, which, onChange) => {
    const label = t(`handle-${place}-label`, { gesture: words });
    const one = stepper({
      label,
      value: 100 * gesture[which],
      low: 0,
      high,
      ...THRESHOLD,
      unit,
      onChange: (share) => onChange(share / 100),
    });
    steppers.push({ name: gesture.name, which, stepper: one });
    return setting(t(`tune-${place}`), words, one);
  };
  const now = () => draft.gesture(gesture.name) ?? gesture;
  const options = FEATURES.map((value) => ({ value, label: t(`tune-${value}`) }));
  return [
    threshold("from", "dead_zone", (value) => draft.setHandles(gesture.name, value, now().full)),
    threshold("full", "full", (value) => draft.setHandles(gesture.name, now().dead_zone, value)),
    setting(
      t("tune-feature"),
      words,
      segments(t("tune-feature"), options, gesture.feature, (feature) => draft.setFeature(gesture.name, feature)),
    ),
  ];
}

/** @param {Control} control @param {Binding} binding @param {Record<string, string>} labels @param {ControlsDraft} draft */
function addGesture(control, binding, labels, draft) {
  const options = [{ value: "", label: t("tune-add") }];
  for (const direction of [1, -1]) {
    for (const joint of Object.keys(labels)) {
      const gesture = gestureFor(draft.settings.gestures, joint, direction);
      if (gesture && binding.gestures.includes(gesture.name)) continue;
      options.push({
        value: `${joint}:${direction}`,
        label: gestureWords({ joint, direction, feature: "rate" }, labels),
      });
    }
  }
  const select = selection(options, "", (value) => {
    const [joint, direction] = value.split(":");
    if (joint) draft.bind(control, joint, direction === "1" ? 1 : -1);
  });
  select.setAttribute("aria-label", t("tune-add"));
  return select;
}
