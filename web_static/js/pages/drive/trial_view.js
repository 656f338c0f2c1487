/**
 * A running trial: the picture fills the page; over it time, place, plan, speed, and what can be done.
 * @import { App } from "../../main.js"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { FloorPlan, PrescribedPath } from "../../plan/floor_plan.js"
 * @import { TrialView } from "types/api"
 */
import { t } from "../../texts.js";
import { cross } from "../../widgets/control_cross.js";
import { speedDial } from "../../widgets/dial.js";
import { h, put, write } from "../../widgets/dom.js";
import { DrivePicture } from "./drive_picture.js";
import { number } from "../../widgets/format.js";
import { miniPlan } from "../../plan/mini_plan.js";
import { pads } from "../../widgets/pads.js";
import { placeCard } from "./place_card.js";
import { trialCue } from "../../widgets/trial_cue.js";
import { chosenView, viewBar } from "../../view/view_bar.js";

const PAUSES = 3; // in one trial, after which the drawn plan is offered
const WIDE = matchMedia("(min-width: 1000px)"); // narrower, the plots would be drawn at the cost of the picture

/**
 * Show the picture and what lies over it; `begin` is called with the trial once it runs.
 * @param {App} app @param {HTMLElement} root
 * @param {{plan: FloorPlan, path: PrescribedPath, isVisitor: boolean}} what @param {AbortSignal} signal
 * @returns {{picture: DrivePicture, begin: (trial: TrialView) => void}}
 */
export function showTrial(app, root, { plan, path, isVisitor }, signal) {
  /** @type {TrialView | null} */
  let trial = null;
  const end = endButton(app);
  const picture = new DrivePicture(app.live, plan, path, chosenView() === "plan" ? "plan" : "view", signal);
  const { view, drawn } = picture;
  const mini = miniPlan(plan, path);
  const place = placeCard(plan, path);
  /** @param {boolean} isOpen */
  const onPlots = (isOpen) => {
    mini.element.hidden = isOpen; // the plots use the same corner and show the same line
    view.setPlots(isOpen);
  };
  const views = viewBar(app, view.surface, (which) => picture.choose(which));
  const offer = planOffer(picture, views.choosePlan);
  const cue = trialCue(app, picture, end.run, views.choosePlan);
  end.tell(cue.setEnding);
  end.setStops(cue.seenStops);
  const bar = bottomBar(app, path, [views.element, end.element], onPlots, signal);
  const title = h("h1", { class: "unseen", tabindex: "-1" }, plan.title);
  /** @param {CustomEvent<LiveMessage>} event */
  const show = ({ detail: now }) => {
    if (!trial) return;
    cue.show(now);
    if (now.trial?.id !== trial.id) return;
    place.show(now.trial, now.contacts);
    offer.show(now.trial.pauses);
    mini.show(now.pose, now.trial);
    drawn.show({ ...now.trial, pose: now.pose });
    bar.show(now);
    if (now.trial.measuring) end.setMeasuring(true);
  };
  const tell = () => {
    app.screen.show(picture.reported);
    bar.setPicture(picture.shows);
    if (!trial) cue.prepare();
    else if (app.live.latest) cue.show(app.live.latest);
  };
  app.live.addEventListener("tick", show, { signal });
  picture.addEventListener("change", tell, { signal });
  signal.addEventListener("abort", () => app.screen.show("none")); // a page that is left shows no picture
  root.className = "page filled";
  put(
    root,
    title,
    picture.element,
    place.element,
    mini.element,
    cue.element,
    h(
      "div",
      { class: "lower" },
      h(
        "div",
        { class: "above-bar" },
        offer.element,
        h("div", { class: "hud dial-card" }, h("b", { class: "small" }, t("dial-title")), speedDial(app, signal)),
        views.pad,
        drawn.pad,
      ),
      isVisitor && h("div", { class: "pad-dock" }, pads(app, signal, { hasNote: false }).element),
      bar.element,
    ),
  );
  endAbove(picture.element, bar.element, signal);
  app.setShowsTrial(true);
  tell();
  /** @param {TrialView} started */
  const begin = (started) => {
    trial = started;
    end.setMeasuring(false);
    const words = t("trial-name", { number: started.number, plan: started.floorplan_title });
    write(title, words);
    place.name(words);
  };
  return { picture, begin };
}

/**
 * The drawn plan by one button, once the 3D view has paused the trial too often.
 * @param {DrivePicture} picture @param {() => void} onPlan
 */
function planOffer(picture, onPlan) {
  const element = h(
    "div",
    { class: "hud plan-offer", hidden: true },
    h("p", {}, t("trial-pause-often")),
    h("button", { type: "button", class: "btn go", onclick: onPlan }, t("picture-plan-show")),
  );
  /** @param {number} pauses of this trial */
  const show = (pauses) => (element.hidden = pauses < PAUSES || picture.shows === "plan");
  return { element, show };
}

/**
 * Let the picture end above the bar at the bottom, which would hide the path right before the chair.
 * @param {HTMLElement} picture @param {HTMLElement} bar @param {AbortSignal} signal
 */
function endAbove(picture, bar, signal) {
  const size = new ResizeObserver(() => picture.style.setProperty("--below", `${bar.offsetHeight}px`));
  size.observe(bar);
  signal.addEventListener("abort", () => size.disconnect());
}

/**
 * @param {App} app @param {PrescribedPath} path @param {[Node, Node]} actions the choice of views, and End
 * @param {(isOpen: boolean) => void} onPlots @param {AbortSignal} signal
 */
function bottomBar(app, path, [views, endElement], onPlots, signal) {
  const speed = h("span", {});
  const instruction = h("p", { class: "grow instruction" }, path.instruction);
  const square = cross({ hasWords: false });
  /** @param {boolean} open */
  const sendPlots = (open) => app.toasts.attempt(() => app.api.post("/view/clinician/plots", { open }));
  let isOpen = false;
  const plots = h("button", { type: "button", class: "btn wide-only", "aria-pressed": "false" }, t("trial-plots"));
  /** @param {boolean} open */
  const setPlots = (open) => {
    isOpen = open;
    plots.setAttribute("aria-pressed", String(open));
    onPlots(open);
    sendPlots(open);
  };
  // A page that was loaded again may have left them open.
  sendPlots(false);
  plots.addEventListener("click", () => setPlots(!isOpen));
  WIDE.addEventListener("change", () => isOpen && !WIDE.matches && setPlots(false), { signal });
  signal.addEventListener("abort", () => isOpen && setPlots(false));
  const element = h(
    "div",
    { class: "hud bar" },
    h(
      "div",
      { class: "speed" },
      h("div", { class: "quiet small" }, t("trial-speed")),
      h("div", { class: "big" }, speed, " ", h("small", {}, t("unit-speed"))),
    ),
    square.element,
    instruction,
    h("div", { class: "spread actions" }, views, plots, endElement),
  );
  /** @param {Pick<LiveMessage, "v" | "u1" | "u2"> & Partial<LiveMessage>} now */
  const show = (now) => {
    write(speed, number(now.v, 2));
    if (now.trial) write(instruction, now.trial.instruction);
    square.show(now.u1 ?? 0, now.u2 ?? 0);
  };
  /** The plots stand inside the 3D view. @param {"view" | "plan" | "none"} shows */
  const setPicture = (shows) => {
    if (shows !== "view" && isOpen) setPlots(false);
    plots.disabled = shows !== "view";
  };
  show({ v: 0, u1: 0, u2: 0 });
  return { element, show, setPicture };
}

/**
 * End trial. While the trial is measured the live picture says so: a program that needs longer than one answer may take is
 * no refusal.
 * @param {App} app
 */
function endButton(app) {
  const element = h("button", { type: "button", class: "btn end", disabled: true }, t("trial-end"));
  let onEnding = /** @param {boolean} _is */ (_is) => {};
  /** The stop of a halted trial ends with it, when the person has seen it. @type {() => number | null} */
  let stopsSeen = () => null;
  /** @param {boolean} is whether the trial is over and being measured */
  const setMeasuring = (is) => {
    element.disabled = is;
    write(element, t(is ? "trial-ending" : "trial-end"));
  };
  const run = async () => {
    const stops = stopsSeen();
    setMeasuring(true);
    onEnding(true);
    const trial = await app.toasts.attempt(async () => {
      try {
        return await app.api.post("/trials/current/end", { reason: "by hand", stops });
      } catch (error) {
        if (!app.live.latest?.trial?.measuring) throw error;
      }
    });
    if (trial) return app.go(`#/drive/over/${trial.id}`);
    onEnding(false);
    setMeasuring(!!app.live.latest?.trial?.measuring);
  };
  element.addEventListener("click", run);
  /** @param {typeof onEnding} listener */
  const tell = (listener) => void (onEnding = listener);
  /** @param {typeof stopsSeen} seen */
  const setStops = (seen) => void (stopsSeen = seen);
  return { element, run, setMeasuring, tell, setStops };
}
