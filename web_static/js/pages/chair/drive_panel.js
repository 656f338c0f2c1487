/**
 * While the real chair is armed: how fast it goes, whether it may, what the body does, what the chair says; dial and end.
 * @import { App } from "../../main.js"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { Reading } from "./arming.js"
 */
import { t } from "../../texts.js";
import { isSimulated } from "./arming.js";
import { chairCard } from "../../widgets/chair_card.js";
import { cross } from "../../widgets/control_cross.js";
import { speedDial } from "../../widgets/dial.js";
import { h, put, set, write } from "../../widgets/dom.js";
import { clock, number } from "../../widgets/format.js";
import { gestureLevels } from "./gesture_levels.js";
import { stopWords } from "./neutral_card.js";
import { urgency } from "../../shell/halt.js";
import { pads } from "../../widgets/pads.js";
import { faultCard, waitWords } from "../../widgets/trial_cue.js";

const DEGREES = 180 / Math.PI;
const STRAIGHT = 1; // °/s: a smaller turn rate is called straight on
const FIRST_PICTURES = 3000; // ms
const BACKWARDS = -0.005; // m/s

/**
 * @param {App} app @param {HTMLElement} root @param {Reading} read
 * @param {number} id of the drive @param {AbortSignal} signal
 */
export function showDrivePanel(app, root, read, id, signal) {
  const name = read.chair?.name ?? "";
  const end = endButton(app);
  const time = h("span", { class: "number" });
  const state = stateCard(app, h("p", { class: "quiet about" }, name, " · ", time), end.run);
  const speed = speedCard(app, read, signal);
  const square = cross();
  const chair = chairCard(app.live, signal);
  const isVisitor = read.equipment.body?.kind === "visitor";
  const levels = gestureLevels(read.controls.parameters);
  const openedAt = performance.now();
  let isSeen = false;
  /** @param {LiveMessage} now */
  const show = (now) => {
    isSeen ||= now.drive?.id === id;
    // A drive that is missing in the live picture has ended, here or on another screen. The first pictures after the start
    // may be older than the drive.
    if (!now.drive && now.control === "alive" && (isSeen || performance.now() - openedAt > FIRST_PICTURES))
      return app.go(`#/drive/chair/over/${id}`);
    write(time, clock(now.drive?.t ?? 0));
    state.show(now);
    speed.show(now);
    square.show(now.u1 ?? 0, now.u2 ?? 0);
    levels.show(now);
  };
  app.live.addEventListener("tick", ({ detail }) => show(detail), { signal });
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { class: "unseen", tabindex: "-1" }, t("driving-title", { name })),
      h(
        "div",
        { class: "drive-panel" },
        state.element,
        speed.element,
        h("section", { class: "card commands" }, h("h2", {}, t("driving-commands")), square.element),
        h("div", { class: "chair-report" }, chair.element),
        h(
          "section",
          { class: "card movements" },
          h("h2", {}, t("driving-movements")),
          isVisitor && pads(app, signal, { hasNote: false }).element,
          levels.element,
          h("p", { class: "small" }, stopWords(read.controls.parameters)),
        ),
      ),
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }, isSimulated(app, read) && `${t("chair-simulated")} `, t("arm-front")),
      end.element,
    ),
  );
  app.setShowsTrial(true);
  root.querySelector("h1")?.focus({ preventScroll: true });
  square.show(0, 0);
  if (app.live.latest?.drive) show(app.live.latest);
}

/**
 * Resting, driving, or stopped: then why, what to do, and Continue.
 * @param {App} app @param {Node} about @param {() => void} onEnd
 */
function stateCard(app, about, onEnd) {
  const place = h("div", { class: "grow", "aria-live": "polite" });
  const element = h("section", { class: "card drive-state" }, place, about);
  const waits = waitWords("driving-paused");
  let shown = "";
  /** @param {LiveMessage} now */
  const show = (now) => {
    waits.show(now.drive?.waits);
    const halt = app.halt(now.fault, now.stops);
    const key = halt?.key ?? now.state;
    if (key === shown) return;
    shown = key;
    element.dataset.state = now.state;
    set(place, { "aria-live": urgency(halt) });
    app.root.scrollTop = 0; // the fault and Continue must be in view
    if (halt) {
      const end = h("button", { type: "button", class: "btn", onclick: onEnd }, t("driving-end"));
      put(place, faultCard(app, halt, waits.element, end));
    } else put(place, h("div", { class: "huge long" }, t(`driving-${key}`)), h("p", {}, t(`driving-${key}-why`)));
  };
  return { element, show };
}

/** @param {App} app @param {Reading} read @param {AbortSignal} signal */
function speedCard(app, read, signal) {
  const [speed, way, upTo] = [h("span", {}), h("p", { class: "way" }), h("span", { class: "quiet small number" })];
  /** How fast forward the chair may go, m/s. @param {number | undefined} dial */
  const highest = (dial) => {
    // The summary was read with the dial as it stood then; the set's own limits do not change while it is armed.
    const { parameters } = read.controls;
    const levels = [parameters.speeds, read.clinic, ...(read.chair ? [read.chair.speeds] : [])];
    return (dial ?? 1) * Math.min(...levels.map(({ forward }) => forward));
  };
  /** @param {{v: number | null, omega: number | null}} twist @param {number | undefined} dial */
  const showTwist = ({ v: velocity, omega }, dial) => {
    const v = velocity ?? 0;
    const turn = (omega ?? 0) * DEGREES;
    write(speed, number(Math.abs(v), 2));
    const turning = `driving-turn-${turn > 0 ? "left" : "right"}`;
    const words = [
      v < BACKWARDS ? t("driving-reverse") : "",
      Math.abs(turn) < STRAIGHT ? "" : t(turning, { turn: number(Math.abs(turn), 0) }),
    ];
    write(way, words.filter(Boolean).join(", ") || (v ? t("driving-straight") : t("driving-stands")));
    write(upTo, t("dial-up-to", { speed: number(highest(dial), 2) }));
  };
  /** @param {LiveMessage} now */
  const show = (now) => showTwist(now.chair ?? now, now.dial);
  const element = h(
    "section",
    { class: "card drive-speed" },
    h("h2", {}, t("driving-speed")),
    h("div", { class: "big giant" }, speed, h("small", {}, t("unit-speed"))),
    way,
    h(
      "div",
      { class: "dial" },
      h("b", { class: "small" }, t("dial-title")),
      h("div", { class: "spread" }, speedDial(app, signal), upTo),
      h("p", { class: "quiet small" }, t("dial-hint")),
    ),
  );
  showTwist({ v: 0, omega: 0 }, app.live.latest?.dial);
  return { element, show };
}

/** @param {App} app */
function endButton(app) {
  const element = h("button", { type: "button", class: "btn large" }, t("driving-end"));
  const run = async () => {
    element.disabled = true;
    write(element, t("driving-ending"));
    const drive = await app.toasts.attempt(() => app.api.post("/drives/current/end"));
    if (drive) return app.go(`#/drive/chair/over/${drive.id}`);
    element.disabled = false;
    write(element, t("driving-end"));
  };
  element.addEventListener("click", run);
  return { element, run };
}
