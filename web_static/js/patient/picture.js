/** The patient's picture: the 3D view, or else the drawn plan; the page tells the server which one it shows. */
import { Api } from "../api.js";
import { h, put, write } from "../widgets/dom.js";
import { drawnPlan } from "../plan/drawn_plan.js";
import { LOOK_EVERY, ageLimit } from "../view/picture_age.js";
import { viewFrame } from "../view/view_frame.js";
import { t } from "../texts.js";

const ASK_AGAIN_AFTER = 1000; // ms after a plan could not be read
const SAY_EVERY = 1000; // ms: the server halts a trial after 3 s without a word of this screen
const MAY_MOVE = new Set(["checking", "armed"]);

/** @param {import("../live/live.js").Live} live @param {AbortSignal} signal */
export function patientPicture(live, signal) {
  const view = renewedView(live, signal);
  const plan = planOfTrial();
  const words = h("p", { class: "hud picture-words", role: "status", hidden: true });
  const element = h("div", { class: "picture-place" }, view.element, plan.element, words);
  const limit = ageLimit();
  /** @type {"view" | "plan" | "none"} */
  let shows = "plan"; // until the 3D view is there
  let wasAskedForPlan = false;

  const wanted = (asks) => (!asks.plan && view.why() === "" ? "view" : "plan");
  /** When the 3D view is lost while the chair may move, the drawn plan appears only after the chair has stopped. */
  const next = (now) => {
    const which = wanted(now.asks);
    if (live.age > limit().limit || (which === "plan" && !plan.isThere(now.trial))) return "none";
    const isByHand = now.asks.plan !== wasAskedForPlan;
    wasAskedForPlan = now.asks.plan;
    if (which === shows || isByHand || !now.trial || !MAY_MOVE.has(now.state)) return which;
    return shows === "plan" ? "plan" : "none";
  };
  const look = () => {
    const now = live.latest;
    if (!now) return;
    const before = shows;
    shows = next(now);
    if (shows !== before) say();
    view.setWanted(!now.asks.plan);
    plan.element.hidden = shows === "view" || !plan.has();
    const isInstead = view.why() === "webgl" && !now.asks.plan && !now.trial;
    const why = shows === "none" ? "patient.no-picture" : isInstead ? "patient.plan" : "";
    words.hidden = !why;
    write(words, why && t(why));
  };
  const say = () => live.send({ picture: shows });
  const show = (now) => {
    plan.show(now);
    look();
  };
  live.addEventListener("open", say, { signal });
  const timers = [setInterval(look, LOOK_EVERY), setInterval(say, SAY_EVERY)];
  signal.addEventListener("abort", () => timers.forEach(clearInterval));
  return { element, show };
}

/** The 3D view; made anew when the connection is back, because a frame that failed to load stays as it is. */
function renewedView(live, signal) {
  const element = h("div", { class: "view-place" });
  let shown = new AbortController();
  let frame = null;
  const make = () => {
    shown.abort();
    shown = new AbortController();
    frame = viewFrame(shown.signal, "patient");
    const inside = frame.element.querySelector("iframe");
    if (inside) inside.title = t("patient.view");
    put(element, frame.element);
  };
  live.addEventListener("connection", () => live.connected && make(), { signal });
  signal.addEventListener("abort", () => shown.abort());
  make();
  return { element, why: () => frame?.why() ?? "coming", setWanted: (is) => frame.setWanted(is) };
}

/** The drawn plan of the trial that is driven; the plan of the last trial stays until another trial begins. */
function planOfTrial() {
  const api = new Api(() => {});
  const element = h("div", { class: "drawn-place", hidden: true });
  let drawn = null;
  let trial = null; // the id of the trial whose plan is drawn, requested, or failed to load
  let isAsking = false;
  let hasFailed = false;
  const read = async (id) => {
    isAsking = true;
    trial = id;
    const shown = await api.get("/view/patient/plan").catch(() => null);
    isAsking = false;
    hasFailed = shown?.trial !== id;
    if (hasFailed) return setTimeout(() => (trial = null), ASK_AGAIN_AFTER);
    const path = shown.floorplan.paths.find(({ name }) => name === shown.path);
    drawn = drawnPlan(shown.floorplan, path);
    put(element, drawn.element);
  };
  return {
    element,
    has: () => drawn !== null,
    /** Whether the plan is drawn, requested, or not needed. */
    isThere: (now) => !now || !hasFailed,
    show: (now) => {
      if (now.trial && now.trial.id !== trial && !isAsking) read(now.trial.id);
      if (drawn && now.trial?.id === trial) drawn.show({ ...now.trial, pose: now.pose });
    },
  };
}
