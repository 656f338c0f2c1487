/** Points and lines on the floor, in metres. @import { Point } from "../plan/floor_plan.js" */

export const STEP = 0.1; // m, the grid

/** @param {number} value m @returns {number} rounded to a tenth of a millimetre, as in documents */
export function tidy(value) {
  return Number(value.toFixed(4)) + 0; // never −0
}

/** @param {Point} a @param {Point} b */
export function distance(a, b) {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** The length of a line. @param {Point[]} points */
export function lengthOf(points) {
  return points.slice(1).reduce((sum, point, i) => sum + distance(points[i], point), 0);
}

/**
 * The point of the piece from a to b that is nearest to a place.
 * @param {Point} a @param {Point} b @param {Point} place
 * @returns {{at: Point, along: number, away: number}} along: m from a; away: m from the place
 */
export function nearestOn(a, b, place) {
  const length = distance(a, b);
  const [ux, uy] = length ? [(b[0] - a[0]) / length, (b[1] - a[1]) / length] : [0, 0];
  const along = Math.min(length, Math.max(0, (place[0] - a[0]) * ux + (place[1] - a[1]) * uy));
  /** @type {Point} */
  const at = [a[0] + along * ux, a[1] + along * uy];
  return { at, along, away: distance(at, place) };
}

/** The distance (m) from a place to a line. @param {Point[]} points @param {Point} place */
export function distanceToLine(points, place) {
  if (points.length === 1) return distance(points[0], place);
  return Math.min(...points.slice(1).map((point, i) => nearestOn(points[i], point, place).away));
}

/** The smallest upright rectangle around some points; null for none. @param {Point[]} places */
export function boundsOf(places) {
  if (!places.length) return null;
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const place of places)
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], place[axis]);
      high[axis] = Math.max(high[axis], place[axis]);
    }
  return { x: low[0], y: low[1], width: high[0] - low[0], height: high[1] - low[1] };
}
