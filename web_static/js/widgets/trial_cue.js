/**
 * The card over the picture: the starting cue, what to do after a stop or fault, and what to do without a picture.
 * @import { Child } from "types/dom"
 * @import { App } from "../main.js"
 * @import { LiveMessage } from "../live/live.js"
 * @import { Halt } from "../shell/halt.js"
 */
import { giveFocus } from "../focus.js";
import { t, textWith } from "../texts.js";
import { h, put, set, write } from "./dom.js";
import { clock } from "./format.js";
import { icon } from "./icons.js";
import { continueButton } from "../shell/continue_button.js";
import { urgency } from "../shell/halt.js";

const LONG = 6; // letters; longer words are written smaller
const GO_SHOWN = 1600; // ms

/**
 * @param {import("../main.js").App} app @param {import("../pages/drive/drive_picture.js").DrivePicture} picture
 * @param {() => Promise<void>} onEnd @param {() => void} onPlan show the drawn plan
 */
export function trialCue(app, picture, onEnd, onPlan) {
  const element = h("div", { class: "over-view", "aria-live": "polite" });
  const waits = waitWords("trial-paused");
  const pauseWaits = waitWords("trial-pause-left");
  const measuring = measuringCard();
  let shown = "";
  /** @type {ReturnType<typeof overView> | null} */
  let haltCard = null;
  let isBegun = false;
  let isEnding = false;
  let timer = 0;
  /** @param {string} big @param {string} small */
  const word = (big, small, tone = "") =>
    h(
      "div",
      { class: `hud cue-card ${tone}` },
      h("div", { class: big.length > LONG ? "huge long" : "huge" }, big),
      small && h("p", {}, small),
    );
  /** Show a card, or none; its first button has the focus when that of the card before had it. @param {...HTMLElement} card */
  const place = (...card) => {
    const hadFocus = element.contains(document.activeElement);
    put(element, ...card);
    if (hadFocus) giveFocus(element.querySelector("button"));
  };
  const missing = () => (picture.shows === "none" ? picture.why : "");
  /** Show the card before the trial: a picture is being opened, or there is none. */
  const prepare = () => {
    const why = missing();
    if (!why || why === "coming") place(word(t("trial-moment"), t("trial-moment-why")));
    else place(withoutPicture(why, onPlan));
  };
  /** @param {LiveMessage} now */
  const show = (now) => {
    waits.show(now.trial?.waits);
    pauseWaits.show(now.trial?.waits);
    const isOver = isEnding || !!now.trial?.measuring; // then nothing can be continued or ended any more
    measuring.count(isOver);
    const halt = now.control === "alive" && !isOver ? app.halt(now.fault, now.stops) : null;
    const key = now.control !== "alive" ? "control" : isOver ? "measuring" : (halt?.key ?? pauseKey(now));
    if (key === shown) return haltCard?.setMissing(missing());
    shown = key;
    set(element, { "aria-live": urgency(halt) });
    haltCard = halt && overView(app, halt, waits.element, onEnd, onPlan);
    if (haltCard) {
      clearTimeout(timer);
      place(haltCard.element);
      return haltCard.setMissing(missing());
    }
    if (now.trial?.paused && !isOver) {
      clearTimeout(timer);
      return place(pauseCard(now.trial.paused.name, pauseWaits.element));
    }
    if (key === "disarmed" && !isBegun) return; // the trial has not begun: keep the card of `prepare`
    clearTimeout(timer);
    isBegun ||= key === "checking";
    if (key === "measuring") place(measuring.element);
    else if (key === "checking") place(word(t("trial-rest"), t("trial-rest-why")));
    else if (key === "armed" && isBegun) {
      place(word(t("trial-go"), "", "go"));
      timer = setTimeout(() => place(), GO_SHOWN);
    } else place();
  };
  /** Its end was asked for here, before the program says that it is over; or that was refused. @param {boolean} is */
  const setEnding = (is) => {
    isEnding = is;
    if (app.live.latest) show(app.live.latest);
  };
  prepare();
  return { element, show, prepare, setEnding, seenStops: () => haltCard?.seen() ?? null };
}

/** @param {LiveMessage} now */
function pauseKey({ state, trial }) {
  return trial?.paused ? `pause ${trial.paused.name}` : state;
}

/** While the trial is paused for a slow screen: nobody has to do anything. @param {string} name of the fault @param {Node} waits */
function pauseCard(name, waits) {
  return h(
    "div",
    { class: "hud fault-card pause-card" },
    h("h2", {}, t("trial-pause")),
    h("p", {}, t(`trial-pause-${name}`)),
    h("p", {}, t("trial-pause-why")),
    waits,
  );
}

/** While a trial that is over is being measured: that, and for how long. */
function measuringCard() {
  const taken = h("b", { class: "number", role: "timer", "aria-live": "off" });
  const element = h(
    "div",
    { class: "hud cue-card" },
    h("div", { class: "huge long" }, t("trial-ending")),
    h("p", {}, t("trial-ending-why"), " ", taken),
  );
  let since = 0;
  /** @param {boolean} is whether it is being measured */
  const count = (is) => {
    since = is ? since || performance.now() : 0;
    write(taken, clock(since ? (performance.now() - since) / 1000 : 0));
  };
  return { element, count };
}

/**
 * The card of a fault. Continue and End keep their places: why there is no picture, and the drawn plan, come below them.
 * Only that is read out when the picture goes.
 * @param {App} app @param {Halt} halt @param {Node} waits @param {() => Promise<void>} onEnd @param {() => void} onPlan
 */
function overView(app, halt, waits, onEnd, onPlan) {
  const end = h("button", { type: "button", class: "btn", onclick: onEnd }, t("trial-end"));
  const go = continueButton(app);
  const element = card(halt.happened, haltWords(halt), waits, go.element, end);
  const why = h("p", { id: "why-no-continue" });
  const plan = h("button", { type: "button", class: "btn", onclick: onPlan }, t("picture-plan-show"));
  const below = h("div", { class: "no-picture" }, why, plan);
  let lacks = "";
  /** @param {string} missing why there is no picture; empty when there is one */
  const setMissing = (missing) => {
    if (missing === lacks) return;
    if (!missing !== !lacks) go.setBlocked(!!missing);
    lacks = missing;
    set(go.element, { "aria-describedby": missing ? why.id : null });
    if (missing) {
      write(why, `${t("picture-continue")} ${t(`picture-${missing}`)}`);
      if (!below.isConnected) element.append(below);
      return;
    }
    const isFocused = plan === document.activeElement;
    below.remove();
    if (isFocused) go.element.focus();
  };
  return { element, setMissing, seen: go.seen };
}

/** The card while there is no picture to drive by. @param {string} why @param {() => void} onPlan */
function withoutPicture(why, onPlan) {
  const back = h("a", { class: "btn", href: "#/drive" }, t("picture-back"));
  return card(t("picture-none"), h("p", {}, t(`picture-${why}`)), null, planButton("picture-plan-start", onPlan), back);
}

/** @param {string} words @param {() => void} onPlan */
function planButton(words, onPlan) {
  return h("button", { type: "button", class: "btn go", onclick: onPlan }, t(words));
}

/**
 * For how much longer a halted trial or drive waits for Continue: counted down for the eye, and read out once.
 * @param {string} key of the words
 */
export function waitWords(key) {
  const left = h("b", { class: "number", role: "timer", "aria-live": "off" });
  const element = h("p", { class: "waits" }, textWith(key, "left", left));
  /** @param {number | null | undefined} seconds */
  const show = (seconds) => write(left, clock(seconds ?? 0));
  return { element, show };
}

/** What happened, what to do, Continue, and how to end. @param {App} app @param {Halt} halt @param {Node} waits @param {Node} end */
export function faultCard(app, halt, waits, end) {
  return card(halt.happened, haltWords(halt), waits, continueButton(app).element, end);
}

/** That somebody stopped again, and what to do next. @param {Halt} halt */
function haltWords({ again, next_step: next }) {
  return [again && h("p", { class: "again" }, again), h("p", {}, next)];
}

/** @param {string} happened @param {Child} next @param {Node | null} waits @param {Node} go @param {Node} other */
function card(happened, next, waits, go, other) {
  return h(
    "div",
    { class: "hud fault-card" },
    h("h2", {}, icon("warning", 28), happened),
    next,
    waits,
    h("div", { class: "spread" }, go, other),
  );
}
