/** The patient's picture: the 3D view, or else the drawn plan; the page reports to the server which one it shows. */
import { Api } from "../api.js";
import { h, put, write } from "../widgets/dom.js";
import { drawnPlan } from "../plan/drawn_plan.js";
import { LOOK_EVERY, ageLimit } from "../view/picture_age.js";
import { viewFrame } from "../view/view_frame.js";
import { t } from "../texts.js";

const ASK_AGAIN_AFTER = 1000; // ms after a plan could not be read
const REPORT_EVERY = 1000; // ms: the server halts a trial after 3 s without a report of this screen
const MAY_MOVE = new Set(["checking", "armed"]);

/**
 * @typedef {import("../live/live.js").PatientMessage} PatientMessage
 * @typedef {import("./store.js").PatientLive} PatientLive
 */

/** The elements of the picture. @param {PatientLive} live @param {AbortSignal} signal */
export function patientPicture(live, signal) {
  const view = renewableView(live, signal);
  const plan = planOfTrial();
  const words = h("p", { class: "hud picture-words", role: "status", hidden: true });
  const limit = ageLimit();
  /** @type {import("../live/screen_worker.js").Picture} */
  let shows = "plan"; // until the 3D view is live
  let wasPlanWish = false;

  /** @param {PatientMessage["asks"]} asks */
  const wanted = (asks) => (!asks.plan && view.why() === "" ? "view" : "plan");
  /**
   * When the 3D view is lost while the chair may move, the drawn plan appears only after the chair has stopped.
   * @param {PatientMessage} now
   */
  const next = (now) => {
    const which = wanted(now.asks);
    if (live.age > limit().limit || (which === "plan" && !plan.isReady(now.trial))) return "none";
    const isByHand = now.asks.plan !== wasPlanWish;
    wasPlanWish = now.asks.plan;
    if (which === shows || isByHand || !now.trial || !MAY_MOVE.has(now.state)) return which;
    return shows === "plan" ? "plan" : "none";
  };
  const look = () => {
    const now = live.latest;
    if (!now) return;
    const before = shows;
    shows = next(now);
    if (shows !== before) report();
    view.setWanted(!now.asks.plan);
    plan.element.hidden = shows === "view" || !plan.has();
    const isInstead = view.why() === "webgl" && !now.asks.plan && !now.trial;
    const why = shows === "none" ? "patient-no-picture" : isInstead ? "patient-plan" : "";
    words.hidden = !why;
    write(words, why && t(why));
  };
  const report = () => live.send({ picture: shows });
  /** @param {PatientMessage} now */
  const show = (now) => {
    plan.show(now);
    look();
  };
  live.addEventListener("tick", ({ detail }) => show(detail), { signal });
  live.addEventListener("open", report, { signal });
  const timers = [setInterval(look, LOOK_EVERY), setInterval(report, REPORT_EVERY)];
  signal.addEventListener("abort", () => timers.forEach(clearInterval));
  return [view.element, plan.element, words];
}

/**
 * The 3D view; made anew when the connection is back, because a frame that failed to load does not try again.
 * @param {PatientLive} live @param {AbortSignal} signal
 */
function renewableView(live, signal) {
  const element = h("div", { class: "view-place" });
  let ending = new AbortController();
  const make = () => {
    ending.abort();
    ending = new AbortController();
    const frame = viewFrame(ending.signal, "patient");
    const inside = frame.element.querySelector("iframe");
    if (inside) inside.title = t("patient-view");
    put(element, frame.element);
    return frame;
  };
  let frame = make();
  live.addEventListener("connection", () => live.connected && (frame = make()), { signal });
  signal.addEventListener("abort", () => ending.abort());
  /** @param {boolean} is */
  const setWanted = (is) => frame.setWanted(is);
  return { element, why: () => frame.why(), setWanted };
}

/** The drawn plan of the running trial; the plan of the last trial stays until another trial begins. */
function planOfTrial() {
  const api = new Api({ signedOut: () => {} });
  const element = h("div", { class: "drawn-place", hidden: true });
  /** @type {ReturnType<typeof drawnPlan> | null} */
  let drawn = null;
  /** The id of the trial whose plan is drawn, requested, or failed to load. @type {number | null} */
  let trial = null;
  let isAsking = false;
  let hasFailed = false;
  /** @param {number} id of the trial */
  const read = async (id) => {
    isAsking = true;
    trial = id;
    const answer = await api.get("/view/patient/plan").catch(() => null);
    const path = answer?.floorplan.paths.find(({ name }) => name === answer.path);
    isAsking = false;
    hasFailed = answer?.trial !== id;
    if (!answer || !path || hasFailed) return void setTimeout(() => (trial = null), ASK_AGAIN_AFTER);
    drawn = drawnPlan(answer.floorplan, path);
    put(element, drawn.element);
  };
  return {
    element,
    has: () => drawn !== null,
    /** Whether the plan is drawn, requested, or not needed. @param {PatientMessage["trial"]} current */
    isReady: (current) => !current || !hasFailed,
    /** @param {PatientMessage} now */
    show: (now) => {
      if (now.trial && now.trial.id !== trial && !isAsking) read(now.trial.id);
      if (drawn && now.trial?.id === trial) drawn.show({ ...now.trial, pose: now.pose });
    },
  };
}
