/** Places on the floor, in metres: [x, y]. @typedef {[number, number]} Place */

export const STEP = 0.1; // m, the grid

/** @param {number} value m @returns {number} to a tenth of a millimetre, as documents have it */
export function tidy(value) {
  return Number(value.toFixed(4)) + 0; // never −0
}

/** @param {Place} place @param {number} step m; 0: as it is @returns {Place} */
export function snapped([x, y], step) {
  if (!step) return [tidy(x), tidy(y)];
  return [tidy(Math.round(x / step) * step), tidy(Math.round(y / step) * step)];
}

/** @param {Place} a @param {Place} b */
export function distance(a, b) {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** @param {Place} a @param {Place} b @returns {number} rad, from x counter-clockwise */
export function heading(a, b) {
  return Math.atan2(b[1] - a[1], b[0] - a[0]);
}

/** The length of a line. @param {Place[]} points */
export function lengthOf(points) {
  return points.slice(1).reduce((sum, point, i) => sum + distance(points[i], point), 0);
}

/**
 * Where on the piece from a to b it is nearest to a place.
 * @param {Place} a @param {Place} b @param {Place} place
 * @returns {{at: Place, along: number, away: number}} along: m from a
 */
export function nearestOn(a, b, place) {
  const length = distance(a, b);
  const [ux, uy] = length ? [(b[0] - a[0]) / length, (b[1] - a[1]) / length] : [0, 0];
  const along = Math.min(length, Math.max(0, (place[0] - a[0]) * ux + (place[1] - a[1]) * uy));
  /** @type {Place} */
  const at = [a[0] + along * ux, a[1] + along * uy];
  return { at, along, away: distance(at, place) };
}

/** How far a place is from a line. @param {Place[]} points @param {Place} place */
export function awayFrom(points, place) {
  if (points.length === 1) return distance(points[0], place);
  return Math.min(...points.slice(1).map((point, i) => nearestOn(points[i], point, place).away));
}

/** The smallest upright rectangle round some places; null for none. @param {Place[]} places */
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
