/**
 * A trial that is shown while it runs: its picture, what the live picture says of it, and what a person can do.
 * @import { App } from "../../main.js"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { FloorPlan, PrescribedPath } from "../../plan/floor_plan.js"
 * @import { TrialView } from "types/api"
 * @typedef {ReturnType<typeof trialStore>} TrialStore
 */
import { computed, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { cross } from "../../widgets/control_cross.js";
import { DrivePicture } from "./drive_picture.js";
import { miniPlan } from "../../plan/mini_plan.js";
import { trialCue } from "../../widgets/trial_cue.js";
import { chosenView, viewBar } from "../../view/view_bar.js";

const WIDE = matchMedia("(min-width: 1000px)"); // narrower, the plots would be drawn at the cost of the picture

/**
 * @param {App} app @param {{plan: FloorPlan, path: PrescribedPath, isVisitor: boolean}} what is driven, and whether a
 *   visitor moves the simulated body @param {AbortSignal} left
 */
export function trialStore(app, { plan, path, isVisitor }, left) {
  const trial = signal(/** @type {TrialView | null} */ (null)); // null until it runs
  const title = computed(
    () => trial.value && t("trial-name", { number: trial.value.number, plan: trial.value.floorplan_title }),
  );
  const moment = signal(/** @type {LiveMessage | null} */ (null)); // the newest one of this trial
  const isEnding = signal(false); // its end was asked for here, or it is being measured
  const isPlotsOpen = signal(false);
  const picture = new DrivePicture(app.live, plan, path, chosenView() === "plan" ? "plan" : "view", left);
  const shows = signal(picture.shows);
  const mini = miniPlan(plan, path);
  const square = cross({ hasWords: false });
  const views = viewBar(app, picture.view.surface, (which) => picture.choose(which));
  /**
   * End the trial. While the trial is measured the live picture says so: a program that needs longer than one answer
   * may take is no refusal.
   * @returns {Promise<void>}
   */
  const end = async () => {
    const stops = cue.seenStops(); // the stop of a halted trial ends with it, when the person has seen it
    isEnding.value = true;
    cue.setEnding(true);
    const over = await app.toasts.attempt(async () => {
      try {
        return await app.api.post("/trials/current/end", { reason: "by hand", stops });
      } catch (error) {
        if (!app.live.latest?.trial?.measuring) throw error;
      }
    });
    if (over) return app.go(`#/drive/over/${over.id}`);
    cue.setEnding(false);
    isEnding.value = !!app.live.latest?.trial?.measuring;
  };
  const cue = trialCue(app, picture, end, views.choosePlan);
  /** @param {boolean} open */
  const sendPlots = (open) => app.toasts.attempt(() => app.api.post("/view/clinician/plots", { open }));
  /** @param {boolean} open */
  const setPlots = (open) => {
    isPlotsOpen.value = open;
    mini.element.hidden = open; // the plots use the same corner and show the same line
    picture.view.setPlots(open);
    sendPlots(open);
  };
  /** @param {CustomEvent<LiveMessage>} event */
  const show = ({ detail: now }) => {
    if (!trial.value) return;
    cue.show(now);
    if (now.trial?.id !== trial.value.id) return;
    moment.value = now;
    mini.show(now.pose, now.trial);
    picture.drawn.show({ ...now.trial, pose: now.pose });
    square.show(now.u1 ?? 0, now.u2 ?? 0);
    if (now.trial.measuring) isEnding.value = true;
  };
  /** Follow what the picture shows, and report it. */
  const followPicture = () => {
    app.screen.show(picture.reported);
    shows.value = picture.shows;
    if (picture.shows !== "view" && isPlotsOpen.value) setPlots(false); // the plots stand inside the 3D view
    if (!trial.value) cue.prepare();
    else if (app.live.latest) cue.show(app.live.latest);
  };
  /** Show the trial from now on: it runs. @param {TrialView} started */
  const begin = (started) => {
    trial.value = started;
    isEnding.value = false;
  };
  square.show(0, 0);
  sendPlots(false); // a page that was loaded again may have left them open
  app.live.addEventListener("tick", show, { signal: left });
  picture.addEventListener("change", followPicture, { signal: left });
  WIDE.addEventListener("change", () => isPlotsOpen.value && !WIDE.matches && setPlots(false), { signal: left });
  left.addEventListener("abort", () => {
    if (isPlotsOpen.value) setPlots(false);
    app.screen.show("none"); // a page that is left shows no picture
  });
  const state = { trial, title, moment, shows, isEnding, isPlotsOpen };
  const elements = { picture, mini, square, views, cue };
  return { app, left, plan, path, isVisitor, ...state, ...elements, end, setPlots, followPicture, begin };
}
