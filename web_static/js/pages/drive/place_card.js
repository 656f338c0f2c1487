/** Where the chair is in its task: time, stage, how far, how well, and how near a leader is. */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { clock, number } from "../../widgets/format.js";

const OFF_PATH = 0.01; // m: less is drawn as on the path
const DEGREES = 180 / Math.PI;
const NEAR = 0.5; // m beside the asked distance to a leader that are just right; the measures count the same

/** @param {any} plan @param {any} path */
export function placeCard(plan, path) {
  const [name, time, done, off, contacts] = [
    h("div", { class: "quiet small" }),
    h("div", { class: "big" }),
    h("span", {}),
    h("span", {}),
    h("span", {}),
  ];
  const asked = path.task.distance ?? null;
  const bar = asked === null ? null : leaderBar(asked);
  const element = h(
    "div",
    { class: "hud place" },
    name,
    time,
    bar?.element,
    h("div", { class: "small number facts" }, done, off, contacts),
  );
  const show = ({ trial: now, contacts: count }) => {
    write(time, clock(now.t));
    write(done, progressWords(now));
    if (now.leader) bar?.show(now.leader_distance);
    else write(off, asideWords(now));
    write(contacts, count ? t("trial.contacts", { count }) : "");
    if (now.stages > 1) write(name, t("trial.stage", { stage: now.stage + 1, stages: now.stages, title: now.title }));
  };
  write(name, `${plan.title} · ${path.title}`);
  write(time, clock(0));
  return { element, show, name: (words) => write(name, words) };
}

/** How far: metres along the line, or degrees that are left to turn. */
function progressWords(now) {
  if (now.kind !== "turn") return t("trial.done", { done: number(now.done, 1), length: number(now.length, 0) });
  const left = Math.round((now.length - now.done) * DEGREES);
  return t(left < 0 ? "trial.turned.over" : "trial.turned", { left: number(Math.abs(left), 0) });
}

/** How well: beside the line, off the spot. */
function asideWords({ kind, cross_track: aside }) {
  const distance = Math.abs(aside) < OFF_PATH ? 0 : Math.abs(aside);
  return t(kind === "turn" ? "trial.spot" : "trial.off", { distance: number(distance, 2) });
}

/** The distance to a leader in words, and a mark on a bar whose middle is what is asked. @param {number} asked m */
function leaderBar(asked) {
  const words = h("span", {});
  const element = h("div", { class: "leader" }, words, h("div", { class: "leader-bar", "aria-hidden": "true" }, h("i", {})));
  element.style.setProperty("--near", `${(50 * (asked - NEAR)) / asked}%`);
  element.style.setProperty("--far", `${(50 * (asked + NEAR)) / asked}%`);
  const show = (distance) => {
    const error = distance - asked;
    const tone = Math.abs(error) <= NEAR ? "right" : error < 0 ? "near" : "far";
    element.dataset.tone = tone;
    write(words, `${t("trial.behind", { distance: number(distance, 1) })}: ${t(`trial.behind.${tone}`)}`);
    element.style.setProperty("--at", `${Math.min(100, (50 * distance) / asked)}%`);
  };
  return { element, show };
}
