/**
 * How far along its path an unfinished trial came.
 * @import { TrialDetail } from "types/api"
 */
import { distance, lengthOf, nearestOn } from "../editor/geometry.js";

const BACK = 1; // m, that a trajectory may go back along the path from one point to the next
const AHEAD = 3; // m: further ahead lies another part of the path, which may cross this one

/**
 * @param {Pick<TrialDetail, "path" | "trajectory">} trial
 * @returns {{done: number, length: number} | null} m; null without a recording, or where the task has no way
 */
export function wayDone({ path, trajectory }) {
  const length = lengthOf(path);
  if (!trajectory?.x.length || length === 0) return null;
  let done = 0;
  trajectory.x.forEach((x, i) => {
    let start = 0;
    const places = path.slice(1).map((to, k) => {
      const { along, away } = nearestOn(path[k], to, [x, trajectory.y[i]]);
      start += k ? distance(path[k - 1], path[k]) : 0;
      return { along: start + along, away };
    });
    const near = places.filter(({ along }) => along >= done - BACK && along <= done + AHEAD);
    if (near.length) done = near.reduce((best, one) => (one.away < best.away ? one : best)).along;
  });
  return { done, length };
}
