/**
 * Where a drawn point lands: on a wall end nearby, on the grid, or where the finger is.
 * @import { Point } from "../plan/floor_plan.js"
 * @import { Plan } from "./document.js"
 */
import { distance, tidy } from "./geometry.js";

/** Around a finger, px: within it a wall end catches a point, and an item is hit. */
export const REACH = 22;

/** The nearest point of the grid. @param {Point} place @param {number} step m, of the grid; 0: no grid @returns {Point} */
export function snap([x, y], step) {
  if (!step) return [tidy(x), tidy(y)];
  return [tidy(Math.round(x / step) * step), tidy(Math.round(y / step) * step)];
}

/**
 * Snap a place to the nearest wall end within reach, otherwise to the grid.
 * @param {Plan} plan @param {Point} place @param {number} step m, of the grid; 0: do not snap @param {number} reach m
 */
export function snapPlace(plan, place, step, reach) {
  if (!step) return snap(place, 0);
  /** @type {{end: Point, away: number} | null} */
  let best = null;
  for (const wall of plan.walls)
    for (const end of [wall[0], wall[wall.length - 1]]) {
      const away = distance(end, place);
      if (away <= reach && (!best || away < best.away)) best = { end, away };
    }
  return best ? best.end : snap(place, step);
}
