/**
 * Where the chair is in its task: time, stage, how far, how well, and how near a leader is.
 * @import { TrialMoment } from "types/api"
 * @import { TrialStore } from "./trial_store.js"
 */
import { h } from "../../preact.js";
import { REFERENCE } from "../../reference.js";
import { t } from "../../texts.js";
import { clock, number } from "../../widgets/format.js";

const OFF_PATH = 0.01; // m: less is drawn as on the path
const DEGREES = 180 / Math.PI;

/** @param {{store: TrialStore}} card */
export function PlaceCard({ store: { plan, path, title, moment } }) {
  const { trial: now, contacts: count } = moment.value ?? {};
  const stage = now && now.stages > 1 && { stage: now.stage + 1, stages: now.stages, title: now.title };
  return h(
    "div",
    { class: "hud place" },
    h(
      "div",
      { class: "quiet small" },
      stage ? t("trial-stage", stage) : (title.value ?? `${plan.title} · ${path.title}`),
    ),
    h("div", { class: "big" }, clock(now?.t ?? 0)),
    path.task.kind === "follow" &&
      h(LeaderBar, { asked: path.task.distance, distance: now?.leader ? (now.leader_distance ?? 0) : null }),
    h(
      "div",
      { class: "small number facts" },
      h("span", {}, now && progressWords(now)),
      h("span", {}, now && !now.leader && asideWords(now)),
      h("span", {}, count ? t("trial-contacts", { count }) : ""),
    ),
  );
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

/**
 * The distance to a leader in words, and a mark on a bar whose middle is what is asked.
 * @param {{asked: number, distance: number | null}} bar m; null before the leader is there
 */
function LeaderBar({ asked, distance }) {
  const near = REFERENCE.numbers.leader_near;
  const error = (distance ?? asked) - asked;
  const tone = Math.abs(error) <= near ? "right" : error < 0 ? "near" : "far";
  /** @param {number} metres */
  const share = (metres) => `${Math.min(100, (50 * metres) / asked)}%`;
  const style = `--near: ${share(asked - near)}; --far: ${share(asked + near)}; --at: ${share(distance ?? asked)}`;
  return h(
    "div",
    { class: "leader", style, "data-tone": distance === null ? undefined : tone },
    h("span", {}, distance !== null && t(`trial-behind-${tone}`, { distance: number(distance, 1) })),
    h("div", { class: "leader-bar", "aria-hidden": "true" }, h("i", {})),
  );
}
