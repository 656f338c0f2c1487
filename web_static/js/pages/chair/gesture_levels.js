/**
 * The bound gestures as live bars, each with the mark from where it counts: to look at, not to set.
 * @import { DriveParameters, Gesture } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { gestureWithin, gestureWords, jointLabels, TOGETHER } from "../../widgets/gestures.js";

const SHORTEST = 1.2; // FS/s or FS: the bar's end at least
const SETTLED = 300; // ms: what changes sooner is not said in words

/**
 * @param {DriveParameters} parameters what drives @param {(moving: string[]) => void} [onMoving] the gestures that count now, as words within a sentence
 */
export function gestureLevels(parameters, onMoving) {
  const labels = jointLabels(parameters.profile);
  const rows = boundGestures(parameters).map(({ gesture, controls }) => {
    const words = gestureWithin(gesture, labels);
    const does = controls.map((control) => t(`control-${control}`)).join(", ");
    return { gesture, words, ...levelBar(gesture, gestureWords(gesture, labels), does) };
  });
  /** @type {string | null} */
  let words = null;
  /** @type {string | null} */
  let wanted = null;
  let wantedAt = 0;
  /** @param {LiveMessage} now */
  const show = (now) => {
    for (const row of rows) row.show(now.rate[now.gestures.indexOf(row.gesture.name)] ?? 0);
    const moving = rows.filter((row) => row.counts()).map(({ words }) => words);
    const key = moving.join();
    if (key !== wanted) [wanted, wantedAt] = [key, performance.now()];
    if (key === words || performance.now() - wantedAt < SETTLED) return;
    words = key;
    onMoving?.(moving);
  };
  const element = h(
    "div",
    { class: "levels" },
    rows.map((row) => row.element),
  );
  return { element, show };
}

/** The patient's stop gesture in words; empty when none is bound. @param {DriveParameters} parameters */
export function stopGesture({ profile, gestures, bindings }) {
  const labels = jointLabels(profile);
  const names = bindings.filter(({ control }) => control === "stop").flatMap((binding) => binding.gestures);
  const bound = names.flatMap((name) => gestures.find((gesture) => gesture.name === name) ?? []);
  return bound.map((gesture) => gestureWithin(gesture, labels)).join(TOGETHER);
}

/** Each gesture that does something, with what it does; the stop gesture's parts among them. @param {DriveParameters} parameters */
function boundGestures({ gestures, bindings }) {
  return gestures
    .map((gesture) => ({
      gesture,
      controls: bindings.filter((one) => one.gestures.includes(gesture.name)).map(({ control }) => control),
    }))
    .filter(({ controls }) => controls.length);
}

/** @param {Gesture} gesture @param {string} words @param {string} does */
function levelBar({ dead_zone: from, full }, words, does) {
  const end = Math.max(SHORTEST, full * 1.2);
  const fill = h("div", { class: "fill" });
  const mark = h("div", { class: "mark" });
  mark.style.left = `${(100 * from) / end}%`;
  const bar = h("div", { class: "level-bar" }, fill, mark);
  let value = 0;
  /** @param {number} now */
  const show = (now) => {
    value = now;
    fill.style.width = `${(100 * Math.min(end, Math.max(0, now))) / end}%`;
    bar.classList.toggle("counts", now > from);
  };
  const element = h(
    "div",
    { class: "level" },
    h("div", { class: "row small" }, h("span", {}, words), h("span", { class: "quiet" }, does)),
    bar,
  );
  return { element, show, counts: () => value > from };
}
