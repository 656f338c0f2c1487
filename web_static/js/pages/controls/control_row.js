/**
 * One of the five controls: which gestures it answers to, their live bars, and the fine-tuning.
 * @import { Gesture } from "types/api"
 * @import { Control, ControlsStore } from "./store.js"
 */
import { passFocus } from "../../focus.js";
import { Fragment, h, useSignal } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { Segments, Selection } from "../../widgets/fields.js";
import { anyOf } from "../../widgets/format.js";
import { gestureFor, gestureWithin, gestureWords, TOGETHER } from "../../widgets/gestures.js";
import { Icon } from "../../widgets/icons.js";
import { Setting, Stepper } from "../../widgets/setting.js";
import { HandleBar } from "./handle_bar.js";

const FEATURES = ["rate", "displacement"];
const THRESHOLD = { step: 1, digits: 0 }; // % of the full movement
const GAIN = { step: 0.1, digits: 1 };

/** @param {{store: ControlsStore, control: Control}} row */
export function ControlRow({ store, control }) {
  const isOpen = useSignal(false);
  const labels = store.labels.value;
  const gestures = store.gesturesOf(control);
  const within = gestures.map((gesture) => gestureWithin(gesture, labels));
  const isStop = control === "stop";
  const answersTo = (isStop ? within.join(TOGETHER) : anyOf(within)) || t("control-nothing");
  return h(
    "section",
    { class: "control" },
    h(
      "div",
      { class: "row" },
      h("h2", {}, t(`control-${control}`), h("span", { class: "quiet" }, ` ← ${answersTo}`)),
      h("span", { class: "grow" }),
      h(LiveTag, { store, gestures, isStop }),
      h(
        "button",
        {
          type: "button",
          class: "btn bare small tune",
          "aria-expanded": isOpen.value,
          onClick: () => (isOpen.value = !isOpen.value),
        },
        t("tune"),
      ),
    ),
    !isStop &&
      gestures.map((gesture) =>
        h(HandleBar, {
          key: `${gesture.name} ${gesture.feature}`,
          store,
          gesture,
          words: gestureWords(gesture, labels),
        }),
      ),
    isStop && h("p", { class: "quiet small" }, t("control-together")),
    h("div", { hidden: !isOpen.value }, isOpen.value && h(Tuning, { store, control })),
  );
}

/** Whether the control is given now. @param {{store: ControlsStore, gestures: Gesture[], isStop: boolean}} tag */
function LiveTag({ store: { live }, gestures, isStop }) {
  const { gestures: names = [], activation = [] } = live.value ?? {};
  const levels = gestures.map(({ name }) => activation[names.indexOf(name)] ?? 0);
  const isLive = levels.length > 0 && (isStop ? levels.every((level) => level > 0) : levels.some((level) => level > 0));
  return h("span", { class: "tag", style: { visibility: isLive ? "visible" : "hidden" } }, t("control-live"));
}

/** @param {{store: ControlsStore, control: Control}} tuning */
function Tuning({ store, control }) {
  const labels = store.labels.value;
  const gestures = store.gesturesOf(control);
  const isStop = control === "stop";
  /** @param {Gesture} gesture */
  const chip = (gesture) => {
    const words = gestureWords(gesture, labels);
    return h(
      "button",
      {
        key: gesture.name,
        type: "button",
        class: "btn small chip",
        "aria-label": t("tune-remove", { gesture: words }),
        ref: passFocus,
        onClick: () => store.unbind(control, gesture.name),
      },
      words,
      h(Icon, { name: "cross", size: 16 }),
    );
  };
  return h(
    "div",
    { class: "tuning" },
    h(
      Setting,
      { title: t("tune-gestures") },
      h("span", { class: "spread" }, gestures.map(chip), h(AddGesture, { store, control })),
    ),
    !isStop &&
      h(
        Setting,
        { title: t("tune-gain"), hint: t("tune-gain-hint") },
        h(Stepper, {
          label: t("tune-gain"),
          value: store.bindingOf(control).gain,
          low: 0,
          high: limitsOf("Binding", "gain").maximum ?? Infinity,
          ...GAIN,
          unit: "×",
          onChange: (gain) => store.setGain(control, gain),
        }),
      ),
    !isStop &&
      gestures.map((gesture) =>
        h(GestureSettings, { key: gesture.name, store, gesture, words: gestureWords(gesture, labels) }),
      ),
  );
}

/** @param {{store: ControlsStore, gesture: Gesture, words: string}} settings words: of the gesture */
function GestureSettings({ store, gesture, words }) {
  const { name, feature, dead_zone: from, full } = gesture;
  /** @param {"from" | "full"} place @param {number} value @param {(value: number) => void} onChange */
  const threshold = (place, value, onChange) =>
    h(
      Setting,
      { title: t(`tune-${place}`), hint: words },
      h(Stepper, {
        label: t(`handle-${place}-label`, { gesture: words }),
        value: 100 * value,
        low: 0,
        high: 100 * (limitsOf("Gesture", "full").maximum ?? Infinity),
        ...THRESHOLD,
        unit: t(`unit-${feature}`),
        onChange: (share) => onChange(share / 100),
      }),
    );
  return h(
    Fragment,
    {},
    threshold("from", from, (value) => store.setHandles(name, value, full)),
    threshold("full", full, (value) => store.setHandles(name, from, value)),
    h(
      Setting,
      { title: t("tune-feature"), hint: words },
      h(Segments, {
        label: t("tune-feature"),
        options: FEATURES.map((value) => ({ value, label: t(`tune-${value}`) })),
        chosen: feature,
        onChange: (/** @type {Gesture["feature"]} */ value) => store.setFeature(name, value),
      }),
    ),
  );
}

/** The choice of one more gesture. @param {{store: ControlsStore, control: Control}} choice */
function AddGesture({ store, control }) {
  const labels = store.labels.value;
  const { gestures: names } = store.bindingOf(control);
  const options = [{ value: "", label: t("tune-add") }];
  for (const direction of [1, -1]) {
    for (const joint of Object.keys(labels)) {
      const gesture = gestureFor(store.settings.value.gestures, joint, direction);
      if (gesture && names.includes(gesture.name)) continue;
      options.push({
        value: `${joint}:${direction}`,
        label: gestureWords({ joint, direction, feature: "rate" }, labels),
      });
    }
  }
  /** @param {string} value */
  const bind = (value) => {
    const [joint, direction] = value.split(":");
    if (joint) store.bind(control, joint, direction === "1" ? 1 : -1);
  };
  return h(Selection, { options, chosen: "", onChange: bind, "aria-label": t("tune-add") });
}
