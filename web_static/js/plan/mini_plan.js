/** The small plan while driving: path, trajectory, chair. It can be folded away. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { planPicture } from "./plan_svg.js";

const STEP = 0.05; // m between two points of the trajectory
const STORAGE_KEY = "bodydrive-mini-plan";

/** @param {import("./floor_plan.js").FloorPlan} plan @param {import("./floor_plan.js").PrescribedPath} path */
export function miniPlan(plan, path) {
  const picture = planPicture(plan, path.points, {
    label: t("drive-plan-label", { plan: plan.title, path: path.title }),
    isNear: path.task.kind === "path" || path.task.kind === "follow",
    request: path,
  });
  /** @type {import("./floor_plan.js").Point[]} */
  const trajectory = [];
  const details = h(
    "details",
    { class: "hud mini", open: localStorage.getItem(STORAGE_KEY) !== "closed" },
    h("summary", {}, t("trial-above")),
    picture.element,
    path.task.kind === "path" && h("p", { class: "legend" }, t("trial-above-line")),
  );
  details.addEventListener("toggle", () => localStorage.setItem(STORAGE_KEY, details.open ? "open" : "closed"));
  /** @param {(number | null)[]} pose @param {Pick<import("types/api").TrialMoment, "leader" | "target">} trial */
  const show = (pose, { leader, target }) => {
    if (leader) picture.setLeader(leader);
    picture.setGoal(target);
    const [x, y] = pose;
    const last = trajectory.at(-1);
    if (x !== null && y !== null && (!last || Math.hypot(x - last[0], y - last[1]) >= STEP)) {
      trajectory.push([x, y]);
      picture.setTrajectory(trajectory);
    }
    picture.setPose(pose);
  };
  return { element: details, show };
}
