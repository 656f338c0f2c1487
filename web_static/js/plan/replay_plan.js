/** The plan from above in a replay: what was driven, and where the chair and all that moved are at the moment. */
import { drawnPlan } from "./drawn_plan.js";
import { planPicture } from "./plan_svg.js";
import { placeOf } from "../pages/review/play_head.js";

/**
 * @param {any} plan @param {any} trial what GET /trials/ID answered @param {any} line its time line
 * @param {string} label
 */
export function replayPlan(plan, trial, line, label) {
  const asked = plan.paths.find(({ name }) => name === trial.path_name) ?? null;
  const picture = planPicture(plan, trial.path, { label, hasRooms: true, asked });
  picture.setDriven(trajectoryOf(line));
  /** @param {number} t s */
  const show = (t) => {
    const { pose, movers } = momentAt(line, t);
    picture.setPose(pose);
    if (movers.length === plan.movers.length) picture.setMovers(movers);
  };
  return { element: picture.element, show };
}

/**
 * The drawn plan of a replay, which follows the chair as it did while driving.
 * @param {any} plan @param {any} trial @param {any} line
 */
export function replayDrawn(plan, trial, line) {
  const path = plan.paths.find(({ name }) => name === trial.path_name);
  if (!path) return null;
  const drawn = drawnPlan(plan, path);
  drawn.setDriven(trajectoryOf(line));
  return { ...drawn, show: (t) => drawn.show(momentAt(line, t)) };
}

/** @param {any} line @returns {[number, number][]} */
function trajectoryOf(line) {
  return line.x.map((x, i) => [x, line.y[i]]);
}

/** Where the chair and all that moves by itself were. @param {any} line @param {number} t s */
function momentAt(line, t) {
  const { place, pose } = poseAt(line, t);
  return { pose, movers: line.movers.map(({ x, y, theta }) => [x[place], y[place], theta[place]]) };
}

/** Where the chair was, between two points of the time line too. @param {any} line @param {number} t s */
export function poseAt(line, t) {
  const place = placeOf(line.t, t);
  const next = Math.min(place + 1, line.t.length - 1);
  const step = line.t[next] - line.t[place];
  const share = step > 0 ? Math.min(1, Math.max(0, (t - line.t[place]) / step)) : 0;
  const between = (column) => column[place] + share * (column[next] - column[place]);
  const turned = Math.atan2(
    Math.sin(line.theta[next] - line.theta[place]),
    Math.cos(line.theta[next] - line.theta[place]),
  );
  return { place, pose: [between(line.x), between(line.y), line.theta[place] + share * turned] };
}
