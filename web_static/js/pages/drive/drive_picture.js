/**
 * The picture that a trial is driven by: the 3D view or the drawn plan; and whether there is one at all.
 * @import { FloorPlan, PrescribedPath } from "../../plan/floor_plan.js"
 * @import { Why } from "../../view/view_frame.js"
 */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { TypedEvents } from "../../live/typed_events.js";
import { drawnPlan } from "../../plan/drawn_plan.js";
import { LOOK_EVERY, ageLimit } from "../../view/picture_age.js";
import { viewFrame } from "../../view/view_frame.js";

const READY_AFTER = 400; // ms with a picture: by then the server has heard of it from this screen

/** Event: `change` when `shows` or `why` has changed. */
/** @extends {TypedEvents<{change: Event}>} */
export class DrivePicture extends TypedEvents {
  /** The picture to drive by now. @type {"view" | "plan" | "none"} */
  shows = "none";
  /** Why there is no picture; empty when there is one. @type {Why} */
  why = "coming";
  /** Resolves once there is a picture: no trial begins before. @type {Promise<void>} */
  ready;
  #live;
  #chosen;
  #words = h("p", { class: "pace", role: "status" });
  #isReady = () => {};
  #readyTimer = 0;

  /**
   * @param {import("../../live/live.js").Live} live @param {FloorPlan} plan @param {PrescribedPath} path
   * @param {"view" | "plan"} chosen to begin with @param {AbortSignal} signal
   */
  constructor(live, plan, path, chosen, signal) {
    super();
    this.#live = live;
    this.#chosen = chosen;
    this.ready = new Promise((resolve) => (this.#isReady = () => resolve(undefined)));
    this.drawn = drawnPlan(plan, path);
    const limit = ageLimit();
    const look = () => this.#look(limit().limit);
    this.view = viewFrame(signal, "clinician", look);
    this.element = h("div", { class: "picture" }, this.view.element, this.drawn.element, this.#words);
    const timer = setInterval(look, LOOK_EVERY);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      clearTimeout(this.#readyTimer);
    });
    this.choose(chosen);
  }

  /** What this screen reports: a picture that is only too old pauses a trial. @returns {import("../../live/screen_worker.js").Picture} */
  get reported() {
    return this.why === "stale" ? "late" : this.shows;
  }

  /** Show the drawn plan, or the 3D view as soon as there is one. @param {"view" | "plan"} which */
  choose(which) {
    this.#chosen = which;
    this.view.setWanted(which === "view");
    this.#look(Infinity);
  }

  /** @param {number} limit s */
  #look(limit) {
    if (!this.view) return; // `viewFrame` calls back before it returns
    const viewWhy = this.view.why();
    // When the 3D view is chosen, the plan is shown until the view has a picture.
    const isPlan = this.#chosen === "plan" || (this.shows === "plan" && viewWhy !== "");
    write(this.#words, isPlan && this.#chosen === "view" ? t(`picture-${viewWhy}`) : "");
    if (!isPlan) this.#show(viewWhy === "" ? "view" : "none", viewWhy);
    else if (this.#live.age < limit) this.#show("plan", "");
    else this.#show("none", "stale");
    this.drawn.setShown(isPlan);
  }

  /** @param {"view" | "plan" | "none"} shows @param {Why} why */
  #show(shows, why) {
    if (shows === this.shows && why === this.why) return;
    [this.shows, this.why] = [shows, why];
    clearTimeout(this.#readyTimer);
    if (shows !== "none") this.#readyTimer = setTimeout(this.#isReady, READY_AFTER);
    this.dispatchEvent(new Event("change"));
  }
}
