/**
 * Whether the body is at rest: every bound gesture against its mark, in words, and the gesture that stops the chair.
 * @import { LiveMessage } from "../../live/live.js"
 */
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { useUntilGone } from "../../widgets/made.js";
import { GestureLevels, movingWords, stopGesture, stopWords } from "./gesture_levels.js";

const SETTLED = 300; // ms: what changes sooner is not said in words

/** @param {{store: import("./store.js").ArmingStore, step: number}} card step: its number before arming */
export function NeutralCard({ store: { app, left, reading, gestures }, step }) {
  const latest = useSignal(/** @type {LiveMessage | null} */ (null)); // of a shirt that sends
  const moving = useSignal(""); // the gestures that count
  const words = useSignal("");
  useUntilGone(left, (signal) => {
    /** @type {string | null} */
    let wanted = null;
    let wantedAt = 0;
    app.live.addEventListener(
      "tick",
      ({ detail: now }) => {
        if (!now.shirt.alive) return void (words.value = t("neutral-no-shirt"));
        latest.value = now;
        const found = movingWords(gestures.value, now);
        if (found !== wanted) [wanted, wantedAt] = [found, performance.now()];
        if (performance.now() - wantedAt < SETTLED) return;
        moving.value = found;
        words.value = found ? t("neutral-moves", { gestures: found }) : t("neutral-rest");
      },
      { signal },
    );
  });
  const { parameters } = reading.value.controls;
  return h(
    "section",
    { class: "card" },
    h("h2", {}, h("span", { class: "step-number" }, step), t("neutral-card")),
    h("p", { class: "quiet" }, t("neutral-lead")),
    h("div", {}, h(GestureLevels, { gestures: gestures.value, latest })),
    h("p", { class: moving.value ? "at-rest moves" : "at-rest", role: "status" }, words),
    h("p", { class: stopGesture(parameters) ? "small quiet" : "small" }, stopWords(parameters)),
  );
}
