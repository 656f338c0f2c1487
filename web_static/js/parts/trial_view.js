/** A running trial: the 3D view fills the page; over it time, place, plan, speed, and what can be done. */
import { t } from "../texts.js";
import { cross } from "./cross.js";
import { speedDial } from "./dial.js";
import { h, put, write } from "./dom.js";
import { clock, number } from "./format.js";
import { miniPlan } from "./mini_plan.js";
import { pads } from "./pads.js";
import { trialCue } from "./trial_cue.js";
import { viewBar } from "./view_bar.js";
import { viewFrame } from "./view_frame.js";

const WIDE = matchMedia("(min-width: 1000px)"); // narrower, the plots would be drawn at the cost of the picture
const OFF_PATH = 0.01; // m: less is drawn as on the path

/**
 * Show the picture and what lies over it; `begin` is told of the trial once it runs.
 * @param {import("../main.js").App} app @param {HTMLElement} root
 * @param {{plan: any, path: any, isVisitor: boolean}} what @param {AbortSignal} signal
 * @returns {{ready: Promise<void>, begin: (trial: any) => void}}
 */
export function showTrial(app, root, { plan, path, isVisitor }, signal) {
  let trial = null;
  const end = endButton(app);
  const cue = trialCue(app, end.run);
  const mini = miniPlan(plan, path);
  const place = placeCard(plan, path);
  const view = viewFrame(signal);
  const onPlots = (isOpen) => {
    mini.element.hidden = isOpen; // the plots stand in the same corner, and show the same line
    view.setPlots(isOpen);
  };
  const views = viewBar(app, view.surface);
  const bar = bottomBar(app, path, [views.element, end.element], onPlots, signal);
  const title = h("h1", { class: "unseen", tabindex: "-1" }, plan.title);
  const show = ({ detail: now }) => {
    if (!trial) return;
    cue.show(now);
    if (now.trial?.id !== trial.id) return;
    place.show(now);
    mini.show(now.pose, now.trial.leader);
    bar.show(now);
  };
  app.live.addEventListener("tick", show, { signal });
  root.className = "page filled";
  put(
    root,
    title,
    view.element,
    place.element,
    mini.element,
    cue.element,
    h(
      "div",
      { class: "lower" },
      h("div", { class: "hud dial-card" }, h("b", { class: "small" }, t("dial.title")), speedDial(app, signal)),
      views.pad,
      isVisitor && h("div", { class: "pad-dock" }, pads(app, signal, { hasNote: false }).element),
      bar.element,
    ),
  );
  app.setShowsTrial(true);
  const begin = (started) => {
    trial = started;
    end.element.disabled = false;
    const words = t("trial.name", { number: trial.number, plan: trial.floorplan_title });
    write(title, words);
    place.name(words);
  };
  return { ready: view.ready, begin };
}

const DEGREES = 180 / Math.PI;
const NEAR = 0.5; // m beside the asked distance to a leader

/** How far: metres along the line, or degrees that are left to turn. */
function progressWords(now) {
  if (now.kind !== "turn") return t("trial.done", { done: number(now.done, 1), length: number(now.length, 0) });
  const left = (now.length - now.done) * DEGREES;
  return t(left < -0.5 ? "trial.turned.over" : "trial.turned", { left: number(Math.abs(left), 0) });
}

/** How well: beside the line, off the spot, behind a leader. */
function asideWords(now, asked) {
  if (now.leader)
    return `${t("trial.behind", { distance: number(now.leader_distance, 1) })}: ${t(`trial.behind.${nearness(now, asked)}`)}`;
  const distance = Math.abs(now.cross_track) < OFF_PATH ? 0 : Math.abs(now.cross_track);
  return t(now.kind === "turn" ? "trial.spot" : "trial.off", { distance: number(distance, 2) });
}

/** @returns {"near" | "right" | "far"} */
function nearness(now, asked) {
  const error = now.leader_distance - asked;
  return Math.abs(error) <= NEAR ? "right" : error < 0 ? "near" : "far";
}

function placeCard(plan, path) {
  const [name, time, done, off, contacts] = [
    h("div", { class: "quiet small" }),
    h("div", { class: "big" }),
    h("span", {}),
    h("span", {}),
    h("span", {}),
  ];
  const element = h(
    "div",
    { class: "hud place" },
    name,
    time,
    h("div", { class: "small number facts" }, done, off, contacts),
  );
  const show = ({ trial: now, contacts: count }) => {
    write(time, clock(now.t));
    write(done, progressWords(now));
    write(off, asideWords(now, asked));
    off.dataset.tone = now.leader ? nearness(now, asked) : "";
    write(contacts, count ? t("trial.contacts", { count }) : "");
    if (now.stages > 1) write(name, t("trial.stage", { stage: now.stage + 1, stages: now.stages, title: now.title }));
  };
  const asked = path.task.distance;
  write(name, `${plan.title} · ${path.title}`);
  write(time, clock(0));
  return { element, show, name: (words) => write(name, words) };
}

function bottomBar(app, path, [views, endElement], onPlots, signal) {
  const speed = h("span", {});
  const instruction = h("p", { class: "grow instruction" }, path.instruction);
  const square = cross({ hasWords: false });
  const ask = (call) => call.catch((error) => app.toasts.show(error.message));
  let isOpen = false;
  const plots = h("button", { type: "button", class: "btn wide-only", "aria-pressed": "false" }, t("trial.plots"));
  const setPlots = (open) => {
    isOpen = open;
    plots.setAttribute("aria-pressed", String(open));
    onPlots(open);
    ask(app.api.post("/view/clinician/plots", { open }));
  };
  // A page that was loaded again may have left them open.
  ask(app.api.post("/view/clinician/plots", { open: false }));
  plots.addEventListener("click", () => setPlots(!isOpen));
  WIDE.addEventListener("change", () => isOpen && !WIDE.matches && setPlots(false), { signal });
  signal.addEventListener("abort", () => isOpen && setPlots(false));
  const element = h(
    "div",
    { class: "hud bar" },
    h(
      "div",
      { class: "speed" },
      h("div", { class: "quiet small" }, t("trial.speed")),
      h("div", { class: "big" }, speed, " ", h("small", {}, t("unit.speed"))),
    ),
    square.element,
    instruction,
    h("div", { class: "spread actions" }, views, plots, endElement),
  );
  const show = (now) => {
    write(speed, number(now.v, 2));
    if (now.trial) write(instruction, now.trial.instruction);
    square.show(now.u1 ?? 0, now.u2 ?? 0);
  };
  show({ v: 0, u1: 0, u2: 0 });
  return { element, show };
}

function endButton(app) {
  const element = h("button", { type: "button", class: "btn end", disabled: true }, t("trial.end"));
  const run = async () => {
    element.disabled = true;
    write(element, t("trial.ending"));
    try {
      const trial = await app.api.post("/trials/current/end", { reason: "by hand" });
      app.go(`#/drive/over/${trial.id}`);
    } catch (error) {
      app.toasts.show(error.message);
      element.disabled = false;
      write(element, t("trial.end"));
    }
  };
  element.addEventListener("click", run);
  return { element, run };
}
