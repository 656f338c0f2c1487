/**
 * The bound gestures as live bars, each with the mark from where it counts: to look at, not to set.
 * @import { DriveParameters, Gesture } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { ReadonlySignal } from "../../preact.js"
 * @typedef {ReturnType<typeof boundGestures>[number]} BoundGesture
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { gestureWithin, gestureWords, jointLabels, TOGETHER } from "../../widgets/gestures.js";

const SHORTEST = 1.2; // FS/s or FS: the bar's end at least

/**
 * Each gesture that does something, in words, alone and `within` a sentence, with what it does; the stop gesture's
 * parts among them.
 * @param {DriveParameters} parameters
 */
export function boundGestures({ profile, gestures, bindings }) {
  const labels = jointLabels(profile);
  return gestures
    .map((gesture) => ({
      gesture,
      words: gestureWords(gesture, labels),
      within: gestureWithin(gesture, labels),
      does: bindings
        .filter((one) => one.gestures.includes(gesture.name))
        .map(({ control }) => t(`control-${control}`))
        .join(", "),
    }))
    .filter(({ does }) => does);
}

/** How strong a gesture is now, FS/s or FS. @param {Gesture} gesture @param {LiveMessage | null} now */
function valueOf({ name }, now) {
  return now?.rate[now.gestures.indexOf(name)] ?? 0;
}

/** The gestures that count now, within a sentence. @param {BoundGesture[]} gestures @param {LiveMessage} now */
export function movingWords(gestures, now) {
  const moving = gestures.filter(({ gesture }) => valueOf(gesture, now) > gesture.dead_zone);
  return moving.map(({ within }) => within).join(", ");
}

/** @param {{gestures: BoundGesture[], latest: ReadonlySignal<LiveMessage | null>}} levels */
export function GestureLevels({ gestures, latest }) {
  return h(
    "div",
    { class: "levels" },
    gestures.map(({ gesture, words, does }) =>
      h(
        "div",
        { key: gesture.name, class: "level" },
        h("div", { class: "row small" }, h("span", {}, words), h("span", { class: "quiet" }, does)),
        levelBar(gesture, valueOf(gesture, latest.value)),
      ),
    ),
  );
}

/** @param {Gesture} gesture @param {number} value */
function levelBar({ dead_zone: from, full }, value) {
  const end = Math.max(SHORTEST, full * 1.2);
  /** @param {number} place FS/s or FS */
  const share = (place) => `${(100 * Math.min(end, Math.max(0, place))) / end}%`;
  return h(
    "div",
    { class: value > from ? "level-bar counts" : "level-bar" },
    h("div", { class: "fill", style: { width: share(value) } }),
    h("div", { class: "mark", style: { left: `${(100 * from) / end}%` } }),
  );
}

/** The patient's stop gesture in words; empty when none is bound. @param {DriveParameters} parameters */
export function stopGesture({ profile, gestures, bindings }) {
  const labels = jointLabels(profile);
  const names = bindings.filter(({ control }) => control === "stop").flatMap((binding) => binding.gestures);
  const bound = names.flatMap((name) => gestures.find((gesture) => gesture.name === name) ?? []);
  return bound.map((gesture) => gestureWithin(gesture, labels)).join(TOGETHER);
}

/** How the patient stops the chair, or that the patient cannot. @param {DriveParameters} parameters */
export function stopWords(parameters) {
  const gestures = stopGesture(parameters);
  return gestures ? t("neutral-stop", { gestures }) : t("neutral-no-stop");
}
