/**
 * While the real chair is armed: how fast it goes, whether it may, what the body does, what the chair says; dial, end.
 * @import { App } from "../../main.js"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { Halt } from "../../shell/halt.js"
 * @import { Reading } from "./store.js"
 * @typedef {ReturnType<typeof panelStore>} PanelStore
 */
import { giveFocus } from "../../focus.js";
import { computed, drawFoot, drawPage, Fragment, h, signal, useLayoutEffect, useRef } from "../../preact.js";
import { urgency } from "../../shell/halt.js";
import { t } from "../../texts.js";
import { cross } from "../../widgets/control_cross.js";
import { SpeedDial } from "../../widgets/dial.js";
import { h as make } from "../../widgets/dom.js";
import { clock, number } from "../../widgets/format.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { faultCard, waitWords } from "../../widgets/trial_cue.js";
import { ChairCard } from "./chair_card.js";
import { boundGestures, GestureLevels, stopWords } from "./gesture_levels.js";
import { bodyOf } from "./store.js";

const DEGREES = 180 / Math.PI;
const STRAIGHT = 1; // °/s: a smaller turn rate is called straight on
const FIRST_PICTURES = 3000; // ms
const BACKWARDS = -0.005; // m/s

/**
 * @param {App} app @param {HTMLElement} root @param {Reading} read
 * @param {number} id of the drive @param {AbortSignal} left
 */
export function showDrivePanel(app, root, read, id, left) {
  const store = panelStore(app, read, id, left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
  app.setShowsTrial(true);
  root.querySelector("h1")?.focus({ preventScroll: true });
}

/** @param {App} app @param {Reading} read @param {number} id of the drive @param {AbortSignal} left */
function panelStore(app, read, id, left) {
  const latest = signal(/** @type {LiveMessage | null} */ (null)); // the newest live picture of the drive
  const chair = signal(app.live.latest?.chair ?? null); // as it told of itself last
  const time = computed(() => clock(latest.value?.drive?.t ?? 0));
  const state = signal({ key: "", name: "", halt: /** @type {Halt | null} */ (null) });
  const isEnding = signal(false);
  const square = cross();
  const waits = waitWords("driving-paused");
  const openedAt = performance.now();
  let isSeen = false;
  /** @param {LiveMessage} now */
  const show = (now) => {
    isSeen ||= now.drive?.id === id;
    // A drive that is missing in the live picture has ended, here or on another screen. The first pictures after the
    // start may be older than the drive.
    if (!now.drive && now.control === "alive" && (isSeen || performance.now() - openedAt > FIRST_PICTURES))
      return app.go(`#/drive/chair/over/${id}`);
    latest.value = now;
    chair.value = now.chair ?? chair.value;
    waits.show(now.drive?.waits);
    square.show(now.u1 ?? 0, now.u2 ?? 0);
    const halt = app.halt(now.fault, now.stops);
    const key = halt?.key ?? now.state;
    if (key !== state.value.key) state.value = { key, name: now.state, halt };
  };
  const end = async () => {
    if (isEnding.value) return;
    isEnding.value = true;
    const drive = await app.toasts.attempt(() => app.api.post("/drives/current/end"));
    if (drive) return app.go(`#/drive/chair/over/${drive.id}`);
    isEnding.value = false;
  };
  square.show(0, 0);
  if (app.live.latest?.drive) show(app.live.latest);
  app.live.addEventListener("tick", ({ detail }) => show(detail), { signal: left });
  const signals = { latest, chair, time, state, isEnding };
  return { app, left, read, name: read.chair?.name ?? "", ...bodyOf(app, read), ...signals, square, waits, end };
}

/** @param {{store: PanelStore}} page */
function Page({ store }) {
  const { app, left, name, read, latest, chair, square, isVisitor } = store;
  const { parameters } = read.controls;
  return h(
    Fragment,
    {},
    h("h1", { class: "unseen", tabindex: -1 }, t("driving-title", { name })),
    h(
      "div",
      { class: "drive-panel" },
      h(StateCard, { store }),
      h(SpeedCard, { store }),
      h(
        "section",
        { class: "card commands" },
        h("h2", {}, t("driving-commands")),
        h(Made, { left, make: () => square.element }),
      ),
      h("div", { class: "chair-report" }, h(ChairCard, { chair, latest })),
      h(
        "section",
        { class: "card movements" },
        h("h2", {}, t("driving-movements")),
        isVisitor && h(Made, { left, make: (gone) => pads(app, gone, { hasNote: false }).element }),
        h(GestureLevels, { gestures: boundGestures(parameters), latest }),
        h("p", { class: "small" }, stopWords(parameters)),
      ),
    ),
  );
}

/** Resting, driving, or stopped: then why, what to do, and Continue. @param {{store: PanelStore}} card */
function StateCard({ store: { app, name, time, state, waits, end } }) {
  const { key, halt, name: word } = state.value;
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    app.root.scrollTop = 0; // the fault and Continue must be in view
    const button = () => make("button", { type: "button", class: "btn", onclick: end }, t("driving-end"));
    const hadFocus = place.current?.contains(document.activeElement);
    place.current?.replaceChildren(...(halt ? [faultCard(app, halt, waits.element, button())] : []));
    if (hadFocus) giveFocus(place.current?.querySelector("button"));
  }, [key]);
  return h(
    "section",
    { class: "card drive-state", "data-state": word || undefined },
    h(
      "div",
      { class: "grow", "aria-live": urgency(halt) },
      h("div", { ref: place }),
      key !== "" &&
        !halt &&
        h(
          Fragment,
          { key },
          h("div", { class: "huge long" }, t(`driving-${key}`)),
          h("p", {}, t(`driving-${key}-why`)),
        ),
    ),
    h("p", { class: "quiet about" }, name, " · ", h("span", { class: "number" }, time)),
  );
}

/** @param {{store: PanelStore}} card */
function SpeedCard({ store: { app, left, read, latest } }) {
  const now = latest.value;
  const twist = now?.chair ?? now;
  const v = twist?.v ?? 0;
  const turn = (twist?.omega ?? 0) * DEGREES;
  const turning = `driving-turn-${turn > 0 ? "left" : "right"}`;
  const words = [
    v < BACKWARDS ? t("driving-reverse") : "",
    Math.abs(turn) < STRAIGHT ? "" : t(turning, { turn: number(Math.abs(turn), 0) }),
  ];
  const way = words.filter(Boolean).join(", ") || (v ? t("driving-straight") : t("driving-stands"));
  const highest = highestSpeed(read, (now ?? app.live.latest)?.dial ?? 1);
  return h(
    "section",
    { class: "card drive-speed" },
    h("h2", {}, t("driving-speed")),
    h("div", { class: "big giant" }, h("span", {}, number(Math.abs(v), 2)), h("small", {}, t("unit-speed"))),
    h("p", { class: "way" }, way),
    h(
      "div",
      { class: "dial" },
      h("b", { class: "small" }, t("dial-title")),
      h(
        "div",
        { class: "spread" },
        h(SpeedDial, { app, left }),
        h("span", { class: "quiet small number" }, t("dial-up-to", { speed: number(highest, 2) })),
      ),
      h("p", { class: "quiet small" }, t("dial-hint")),
    ),
  );
}

/** How fast forward the chair may go, m/s. @param {Reading} read @param {number} dial its share now */
function highestSpeed({ controls, clinic, chair }, dial) {
  // The summary was read with the dial as it stood then; the set's own limits do not change while it is armed.
  const levels = [controls.parameters.speeds, clinic, ...(chair ? [chair.speeds] : [])];
  return dial * Math.min(...levels.map(({ forward }) => forward));
}

/** @param {{store: PanelStore}} foot */
function Foot({ store: { isSimulated, isEnding, end } }) {
  return h(
    Fragment,
    {},
    h("span", { class: "grow" }, isSimulated && `${t("chair-simulated")} `, t("arm-front")),
    h(
      "button",
      { type: "button", class: "btn large", "aria-disabled": isEnding.value || undefined, onClick: end },
      t(isEnding.value ? "driving-ending" : "driving-end"),
    ),
  );
}
