/**
 * Whether the body is at rest: every bound gesture against its mark, in words, and the gesture that stops the chair.
 * @import { DriveParameters } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 */
import { t } from "../../texts.js";
import { h, put, write } from "../../widgets/dom.js";
import { gestureLevels, stopGesture } from "./gesture_levels.js";

/** @param {import("../../live/live.js").Live} live @param {AbortSignal} signal */
export function neutralCard(live, signal) {
  const title = h("h2", {}, t("neutral-card"));
  const words = h("p", { class: "at-rest", role: "status" });
  const place = h("div", {});
  const stop = h("p", { class: "small" });
  /** @type {ReturnType<typeof gestureLevels> | null} */
  let levels = null;
  let used = "";
  /** @param {{parameters: DriveParameters, hash: string}} controls what would drive */
  const use = ({ parameters, hash }) => {
    if (hash === used) return;
    used = hash;
    levels = gestureLevels(parameters, (moving) => {
      words.classList.toggle("moves", moving.length > 0);
      write(words, moving.length ? t("neutral-moves", { gestures: moving.join(", ") }) : t("neutral-rest"));
    });
    put(place, levels.element);
    write(stop, stopWords(parameters));
    stop.classList.toggle("quiet", stopGesture(parameters) !== "");
  };
  /** @param {CustomEvent<LiveMessage>} event */
  const show = ({ detail: now }) => {
    if (now.shirt.alive) levels?.show(now);
    else write(words, t("neutral-no-shirt"));
  };
  live.addEventListener("tick", show, { signal });
  const element = h(
    "section",
    { class: "card" },
    title,
    h("p", { class: "quiet" }, t("neutral-lead")),
    place,
    words,
    stop,
  );
  return { element, title, use };
}

/** @param {DriveParameters} parameters */
export function stopWords(parameters) {
  const gestures = stopGesture(parameters);
  return gestures ? t("neutral-stop", { gestures }) : t("neutral-no-stop");
}
