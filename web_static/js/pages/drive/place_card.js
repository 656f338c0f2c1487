/**
 * Where the chair is in its task: time, stage, how far, how well, and how near a leader is.
 * @import { FloorPlan, PrescribedPath } from "../../plan/floor_plan.js"
 * @import { TrialMoment } from "types/api"
 */
import { REFERENCE } from "../../reference.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { clock, number } from "../../widgets/format.js";

const OFF_PATH = 0.01; // m: less is drawn as on the path
const DEGREES = 180 / Math.PI;

/** @param {FloorPlan} plan @param {PrescribedPath} path */
export function placeCard(plan, path) {
  const [name, time, done, off, contacts] = [
    h("div", { class: "quiet small" }),
    h("div", { class: "big" }),
    h("span", {}),
    h("span", {}),
    h("span", {}),
  ];
  const asked = path.task.kind === "follow" ? path.task.distance : null;
  const bar = asked === null ? null : leaderBar(asked);
  const element = h(
    "div",
    { class: "hud place" },
    name,
    time,
    bar?.element,
    h("div", { class: "small number facts" }, done, off, contacts),
  );
  /** @param {TrialMoment} now @param {number} count of contacts */
  const show = (now, count) => {
    write(time, clock(now.t ?? 0));
    write(done, progressWords(now));
    if (now.leader) bar?.show(now.leader_distance);
    else write(off, asideWords(now));
    write(contacts, count ? t("trial-contacts", { count }) : "");
    if (now.stages > 1) write(name, t("trial-stage", { stage: now.stage + 1, stages: now.stages, title: now.title }));
  };
  write(name, `${plan.title} · ${path.title}`);
  write(time, clock(0));
  /** @param {string} words */
  const setName = (words) => write(name, words);
  return { element, show, name: setName };
}

/** The progress: metres along the line, or degrees that are left to turn. @param {TrialMoment} now */
function progressWords(now) {
  if (now.kind !== "turn") return t("trial-done", { done: number(now.done, 1), length: number(now.length, 0) });
  const left = Math.round(((now.length ?? 0) - (now.done ?? 0)) * DEGREES);
  return t(left < 0 ? "trial-turned-over" : "trial-turned", { left: number(Math.abs(left), 0) });
}

/** The distance from the line, or from the spot of a turn. @param {TrialMoment} now */
function asideWords({ kind, cross_track: aside }) {
  const distance = Math.abs(aside ?? 0) < OFF_PATH ? 0 : Math.abs(aside ?? 0);
  return t(kind === "turn" ? "trial-spot" : "trial-off", { distance: number(distance, 2) });
}

/** The distance to a leader in words, and a mark on a bar whose middle is what is asked. @param {number} asked m */
function leaderBar(asked) {
  const words = h("span", {});
  const element = h(
    "div",
    { class: "leader" },
    words,
    h("div", { class: "leader-bar", "aria-hidden": "true" }, h("i", {})),
  );
  element.style.setProperty("--near", `${(50 * (asked - REFERENCE.numbers.leader_near)) / asked}%`);
  element.style.setProperty("--far", `${(50 * (asked + REFERENCE.numbers.leader_near)) / asked}%`);
  /** @param {number | null} distance m */
  const show = (distance) => {
    const metres = distance ?? 0;
    const error = metres - asked;
    const tone = Math.abs(error) <= REFERENCE.numbers.leader_near ? "right" : error < 0 ? "near" : "far";
    element.dataset.tone = tone;
    write(words, t(`trial-behind-${tone}`, { distance: number(distance, 1) }));
    element.style.setProperty("--at", `${Math.min(100, (50 * metres) / asked)}%`);
  };
  return { element, show };
}
