/**
 * Play, speed, and the slider of a replay, with what happened marked on it. Space is Stop everywhere, so P plays.
 * @import { Event as TrialEvent } from "types/api"
 */
import { t } from "../../texts.js";
import { h, put, set, write } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { number, unrounded } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { isWriting } from "../../shell/stop.js";

const SPEEDS = [1, 2, 4];
const STEP = 0.05; // s
const ARROW = 1; // s that an arrow key goes
const FAR = 10; // s with Shift

/**
 * @param {import("./play_head.js").PlayHead} head
 * @param {TrialEvent[]} events
 * @param {AbortSignal} signal
 * @param {Node} [more] other marks
 */
export function playBar(head, events, signal, more) {
  const button = h("button", { type: "button", class: "btn go play", "aria-keyshortcuts": "P" });
  button.addEventListener("click", () => head.toggle());
  const slider = h("input", {
    type: "range",
    min: head.start,
    max: head.end,
    step: STEP,
    "aria-label": t("replay-slider"),
  });
  slider.addEventListener("input", () => {
    head.pause();
    head.seek(Number(slider.value));
  });
  const shown = h("output", { class: "number", "aria-live": "off" });
  const speeds = segments(
    t("replay-speed"),
    SPEEDS.map((speed) => ({ value: String(speed), label: `${unrounded(speed)}×` })),
    "1",
    (speed) => head.setSpeed(Number(speed)),
  );
  const marks = h(
    "div",
    { class: "event-marks", "aria-hidden": "true" },
    events.map((event) => h("i", { class: `is-${event.kind}`, style: `left: ${head.share(event.t)}%` })),
  );
  const showState = () => {
    put(button, icon(head.playing ? "pause" : "play", 20), t(head.playing ? "replay-pause" : "replay-play"));
  };
  const showTime = () => {
    slider.value = String(head.t);
    set(slider, { "aria-valuetext": t("replay-at", { t: number(head.t, 1), end: number(head.end, 1) }) });
    write(shown, `${number(head.t, 1)} / ${number(head.end, 1)} s`);
  };
  head.addEventListener("state", showState, { signal });
  head.addEventListener("time", showTime, { signal });
  showState();
  showTime();
  return h("div", { class: "play-bar card" }, button, speeds, h("div", { class: "slide" }, marks, more, slider), shown);
}

/**
 * Let the keys of a page move its replay, whatever on it has the focus.
 * @param {HTMLElement} root of the page @param {import("./play_head.js").PlayHead} head @param {AbortSignal} signal
 */
export function playKeys(root, head, signal) {
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
    head.pause();
    head.seek(end ?? head.t + step);
  };
  root.addEventListener("keydown", press, { signal });
}

/** Whether an element uses these keys itself: a field, radio buttons, a region that scrolls sideways. @param {Element} target */
function belongsElsewhere(target) {
  if (target.matches("input[type=range]")) return false;
  return isWriting(target) || target.matches("input[type=radio], .scroll-x");
}

/** What happened, one below the other; a tap goes there. @param {TrialEvent[]} events @param {import("./play_head.js").PlayHead} head */
export function eventList(events, head) {
  /** @param {TrialEvent} event */
  const go = (event) => {
    head.pause();
    head.seek(event.t);
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("replay-events")),
    h(
      "ol",
      { class: "events" },
      events.map((event) =>
        h(
          "li",
          {},
          h(
            "button",
            { type: "button", class: "btn bare small", onclick: () => go(event) },
            h("i", { class: `event-mark is-${event.kind}` }),
            h("span", { class: "number" }, `${number(event.t, 1)} s`),
            h("span", {}, event.message),
          ),
        ),
      ),
    ),
  );
}
