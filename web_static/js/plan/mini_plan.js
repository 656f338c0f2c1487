/** The small plan while driving: path, driven line, chair. It can be folded away. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { planPicture } from "./plan_svg.js";

const STEP = 0.05; // m between two points of the driven line
const PLACE = "bodydrive-mini-plan";

/** @param {any} plan @param {any} path */
export function miniPlan(plan, path) {
  const picture = planPicture(plan, path.points, {
    label: t("drive.plan.label", { plan: plan.title, path: path.title }),
    isNear: path.task.kind === "path" || path.task.kind === "follow",
    asked: path,
  });
  /** @type {[number, number][]} */
  const driven = [];
  const details = h(
    "details",
    { class: "hud mini", open: localStorage.getItem(PLACE) !== "closed" },
    h("summary", {}, t("trial.above")),
    picture.element,
  );
  details.addEventListener("toggle", () => localStorage.setItem(PLACE, details.open ? "open" : "closed"));
  /** @param {number[]} pose @param {{leader: number[] | null, target: number[]}} trial */
  const show = (pose, { leader, target }) => {
    if (leader) picture.setLeader(leader);
    picture.setGoal(target);
    const [x, y] = pose;
    const last = driven.at(-1);
    if (!last || Math.hypot(x - last[0], y - last[1]) >= STEP) {
      driven.push([x, y]);
      picture.setDriven(driven);
    }
    picture.setPose(pose);
  };
  return { element: details, show };
}
