/**
 * Play, speed, and the slider of a replay, with what happened marked on it. Space is Stop everywhere, so P plays.
 * @import { Event as TrialEvent } from "types/api"
 * @import { ComponentChildren } from "../../preact.js"
 * @import { PlayHead } from "./play_head.js"
 */
import { h } from "../../preact.js";
import { isWriting } from "../../shell/stop.js";
import { t } from "../../texts.js";
import { Segments } from "../../widgets/fields.js";
import { number, unrounded } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";

const SPEEDS = [1, 2, 4];
const STEP = 0.05; // s
const ARROW = 1; // s that an arrow key goes
const FAR = 10; // s with Shift

/** @param {{head: PlayHead, events?: TrialEvent[], children?: ComponentChildren}} bar children: other marks */
export function PlayBar({ head, events = [], children }) {
  const isPlaying = head.isPlaying.value;
  return h(
    "div",
    { class: "play-bar card" },
    h(
      "button",
      { type: "button", class: "btn go play", "aria-keyshortcuts": "P", onClick: () => head.toggle() },
      h(Icon, { name: isPlaying ? "pause" : "play", size: 20 }),
      t(isPlaying ? "replay-pause" : "replay-play"),
    ),
    h(Segments, {
      label: t("replay-speed"),
      options: SPEEDS.map((speed) => ({ value: String(speed), label: `${unrounded(speed)}×` })),
      chosen: String(head.speed.value),
      onChange: (speed) => void (head.speed.value = Number(speed)),
    }),
    h(
      "div",
      { class: "slide" },
      h(
        "div",
        { class: "event-marks", "aria-hidden": "true" },
        events.map(({ kind, t: at }, i) => h("i", { key: i, class: `is-${kind}`, style: `left: ${head.share(at)}%` })),
      ),
      children,
      h(Slider, { head }),
    ),
    h(Time, { head }),
  );
}

/** @param {{head: PlayHead}} slider */
function Slider({ head }) {
  const { t: now, start, end } = head;
  return h("input", {
    type: "range",
    min: start,
    max: end,
    step: STEP,
    value: now,
    "aria-label": t("replay-slider"),
    "aria-valuetext": t("replay-at", { t: number(now, 1), end: number(end, 1) }),
    onInput: ({ currentTarget }) => go(head, Number(currentTarget.value)),
  });
}

/** @param {{head: PlayHead}} time */
function Time({ head }) {
  return h("output", { class: "number", "aria-live": "off" }, `${number(head.t, 1)} / ${number(head.end, 1)} s`);
}

/** Go to a moment, and stay there. @param {PlayHead} head @param {number} at s */
export function go(head, at) {
  head.pause();
  head.seek(at);
}

/**
 * Let the keys of a page move its replay, whatever on it has the focus.
 * @param {HTMLElement} root of the page @param {PlayHead} head @param {AbortSignal} left
 */
export function playKeys(root, head, left) {
  /** @type {Record<string, number | undefined>} */
  const acts = { ArrowLeft: -1, ArrowRight: 1 };
  /** @type {Record<string, number | undefined>} */
  const ends = { Home: head.start, End: head.end };
  /** @param {KeyboardEvent} event */
  const press = (event) => {
    const target = /** @type {Element} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey || belongsElsewhere(target)) return;
    if (event.key.toLowerCase() === "p") {
      if (!event.repeat) head.toggle();
      return;
    }
    // Home and End move the slider only while it has the focus; elsewhere they scroll the page.
    const end = target.matches("input[type=range]") ? ends[event.key] : undefined;
    const step = (acts[event.key] ?? NaN) * (event.shiftKey ? FAR : ARROW);
    if (end === undefined && Number.isNaN(step)) return;
    event.preventDefault();
    go(head, end ?? head.t + step);
  };
  root.addEventListener("keydown", press, { signal: left });
}

/** Whether an element uses these keys itself: a field, radio buttons, a region that scrolls sideways. @param {Element} target */
function belongsElsewhere(target) {
  if (target.matches("input[type=range]")) return false;
  return isWriting(target) || target.matches("input[type=radio], .scroll-x");
}

/** What happened, one below the other; a tap goes there. @param {{events: TrialEvent[], head: PlayHead}} list */
export function EventList({ events, head }) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("replay-events")),
    h(
      "ol",
      { class: "events" },
      events.map(({ kind, message, t: at }, i) =>
        h(
          "li",
          { key: i },
          h(
            "button",
            { type: "button", class: "btn bare small", onClick: () => go(head, at) },
            h("i", { class: `event-mark is-${kind}` }),
            h("span", { class: "number" }, `${number(at, 1)} s`),
            h("span", {}, message),
          ),
        ),
      ),
    ),
  );
}
