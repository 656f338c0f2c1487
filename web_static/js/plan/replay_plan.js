/** The plan from above in a replay: what was driven, and where the chair and all that moved are at the moment. */
import { drawnPlan } from "./drawn_plan.js";
import { planPicture } from "./plan_svg.js";
import { placeOf } from "../pages/review/play_head.js";

/**
 * @typedef {import("./floor_plan.js").FloorPlan} FloorPlan
 * @typedef {import("types/api").Timeline} Timeline
 * @typedef {import("types/api").TrialDetail} Trial
 */

/**
 * The whole floor plan in a replay, with what was driven.
 * @param {FloorPlan} plan @param {Trial} trial @param {Timeline} line @param {string} label
 */
export function replayPlan(plan, trial, line, label) {
  const request = plan.paths.find(({ name }) => name === trial.path_name) ?? null;
  const picture = planPicture(plan, trial.path, { label, hasRooms: true, request });
  picture.setTrajectory(trajectoryOf(line));
  /** @param {number} t s */
  const show = (t) => {
    const { pose, movers } = momentAt(line, t);
    picture.setPose(pose);
    if (movers.length === plan.movers.length) picture.setMovers(movers);
  };
  return { element: picture.element, show };
}

/**
 * The drawn plan in a replay, which follows the chair as in a trial; null when the plan has the trial's path no more.
 * @param {FloorPlan} plan @param {Trial} trial @param {Timeline} line
 */
export function replayDrawn(plan, trial, line) {
  const path = plan.paths.find(({ name }) => name === trial.path_name);
  if (!path) return null;
  const drawn = drawnPlan(plan, path);
  drawn.setTrajectory(trajectoryOf(line));
  /** @param {number} t s */
  const show = (t) => drawn.show(momentAt(line, t));
  return { ...drawn, show };
}

/** The line that was driven. @param {Timeline} line @returns {import("./floor_plan.js").Point[]} */
export function trajectoryOf(line) {
  return line.x.map((x, i) => [Number(x), Number(line.y[i])]);
}

/** The poses of the chair and of all movers. @param {Timeline} line @param {number} t s */
function momentAt(line, t) {
  const { place, pose } = poseAt(line, t);
  return { pose, movers: line.movers.map(({ x, y, theta }) => [x[place], y[place], theta[place]]) };
}

/**
 * The pose of the chair, interpolated between two points of the time line, and the place of the first of them.
 * @param {Pick<Timeline, "t" | "x" | "y" | "theta">} line @param {number} t s
 * @returns {{place: number, pose: import("./floor_plan.js").Pose}}
 */
export function poseAt(line, t) {
  const place = placeOf(line.t, t);
  const next = Math.min(place + 1, line.t.length - 1);
  /** @param {(number | null)[]} column @returns {[number, number]} */
  const ends = (column) => [Number(column[place]), Number(column[next])];
  const [before, after] = ends(line.t);
  const share = after > before ? Math.min(1, Math.max(0, (t - before) / (after - before))) : 0;
  /** @param {(number | null)[]} column */
  const between = (column) => {
    const [from, to] = ends(column);
    return from + share * (to - from);
  };
  const [from, to] = ends(line.theta);
  const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  return { place, pose: [between(line.x), between(line.y), from + share * turn] };
}
