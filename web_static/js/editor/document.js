/**
 * Floor plan documents: each function returns another document and leaves the given one as it is.
 * @typedef {import("./geometry.js").Place} Place
 * @typedef {{list: string, index: number, point?: number}} Ref one thing of a plan, and maybe one of its points
 * @typedef {Record<string, any>} Plan as docs/floorplans.md describes it
 */
import { awayFrom, boundsOf, distance, lengthOf, tidy } from "./geometry.js";

export const LISTS = ["paths", "cones", "doors", "obstacles", "walls", "movers", "gaps", "rooms"];
const PACE = 0.25; // m/s, the mean speed that a new path's time limit allows
const SHORTEST_TIME = 60; // s

/** @param {string} title @returns {Plan} */
export function emptyPlan(title) {
  return { name: "plan", title, walls: [], obstacles: [], rooms: [], doors: [], cones: [], paths: [] };
}

/** @param {Plan} plan @param {Ref} ref */
export function thing(plan, ref) {
  return (plan[ref.list] ?? [])[ref.index];
}

/** The points of a wall, a path or a mover; of other things their position. @param {Plan} plan @param {Ref} ref @returns {Place[]} */
export function pointsOf(plan, ref) {
  const found = thing(plan, ref);
  return Array.isArray(found) ? found : (found.points ?? [found.position]);
}

/** @param {Plan} plan @param {string} list @param {any} added @returns {{plan: Plan, ref: Ref}} */
export function add(plan, list, added) {
  const all = [...(plan[list] ?? []), added];
  return { plan: { ...plan, [list]: all }, ref: { list, index: all.length - 1 } };
}

/** @param {Plan} plan @param {Ref} ref @param {any} other @returns {Plan} */
function replaced(plan, { list, index }, other) {
  return { ...plan, [list]: plan[list].map((one, i) => (i === index ? other : one)) };
}

/** Change fields of a thing; undefined takes one away. @param {Plan} plan @param {Ref} ref @param {Record<string, any>} fields */
export function change(plan, ref, fields) {
  const next = { ...thing(plan, ref), ...fields };
  for (const [name, value] of Object.entries(fields)) if (value === undefined) delete next[name];
  return replaced(plan, ref, next);
}

/** Take a thing away. @param {Plan} plan @param {Ref} ref @returns {Plan} */
export function remove(plan, { list, index }) {
  return { ...plan, [list]: plan[list].filter((_, i) => i !== index) };
}

/** @param {Plan} plan @param {Ref} ref @param {Place[]} points @returns {Plan} */
export function setPoints(plan, ref, points) {
  const found = thing(plan, ref);
  if (Array.isArray(found)) return replaced(plan, ref, points);
  return found.points ? change(plan, ref, { points }) : change(plan, ref, { position: points[0] });
}

/** Move a thing, or the one of its points that is chosen. @param {Plan} plan @param {Ref} ref @param {number} dx m @param {number} dy m */
export function movedBy(plan, ref, dx, dy) {
  const points = pointsOf(plan, ref).map(([x, y], i) =>
    ref.point === undefined || ref.point === i ? [tidy(x + dx), tidy(y + dy)] : [x, y],
  );
  return setPoints(plan, ref, points);
}

/** The same, to a place: where the thing's first point, or the chosen one, comes to lie. @param {Plan} plan @param {Ref} ref @param {Place} place */
export function movedTo(plan, ref, place) {
  const [x, y] = pointsOf(plan, ref)[ref.point ?? 0];
  return movedBy(plan, ref, place[0] - x, place[1] - y);
}

/** Put a point between a chosen one and the next (or beyond the last one). @param {Plan} plan @param {Ref} ref @returns {{plan: Plan, ref: Ref}} */
export function withPointAfter(plan, ref) {
  const points = pointsOf(plan, ref);
  const i = ref.point ?? points.length - 1;
  const [a, b] = i + 1 < points.length ? [points[i], points[i + 1]] : [points[i], beyond(points)];
  const middle = i + 1 < points.length ? [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2)] : b;
  const next = [...points.slice(0, i + 1), middle, ...points.slice(i + 1)];
  return { plan: setPoints(plan, ref, next), ref: { ...ref, point: i + 1 } };
}

function beyond(points) {
  const [[ax, ay], [bx, by]] = points.slice(-2);
  const length = Math.hypot(bx - ax, by - ay) || 1;
  return [tidy(bx + (bx - ax) / length), tidy(by + (by - ay) / length)];
}

/** Take a chosen point away; a line keeps two. @param {Plan} plan @param {Ref} ref @returns {{plan: Plan, ref: Ref}} */
export function withoutPoint(plan, ref) {
  const points = pointsOf(plan, ref);
  if (ref.point === undefined || points.length <= 2) return { plan, ref };
  const next = points.filter((_, i) => i !== ref.point);
  return { plan: setPoints(plan, ref, next), ref: { ...ref, point: Math.min(ref.point, next.length - 1) } };
}

/** A path's document through points, with a name of its own. @param {Plan} plan @param {Place[]} points */
export function newPath(plan, points) {
  const names = plan.paths.map(({ name }) => name);
  const number = firstFree((n) => (n === 1 ? "main" : `path-${n}`), names);
  return {
    name: number === 1 ? "main" : `path-${number}`,
    title: number === 1 ? "Main path" : `Path ${number}`,
    points,
    goal_radius: 0.5,
    time_limit: timeFor(points),
    instruction: "Follow the white line to its end.",
  };
}

/** How long a path may take at a slow pace. @param {Place[]} points @returns {number} s */
export function timeFor(points) {
  return Math.round(Math.max(SHORTEST_TIME, lengthOf(points) / PACE));
}

function firstFree(name, taken) {
  let number = 1;
  while (taken.includes(name(number))) number += 1;
  return number;
}

/** A document's name made of its title, that nothing else has. @param {string} title @param {string[]} taken */
export function nameFrom(title, taken) {
  const plain =
    title
      .normalize("NFKD")
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-+|-+$/g, "")
      .slice(0, 56)
      .replace(/-+$/, "") || "plan";
  const others = taken.map((name) => name.toLowerCase());
  // What stands before a dot may be a scene's name, and those are taken as a whole.
  const scenes = others.map((name) => name.split(".")[0]);
  const number = firstFree((n) => (n === 1 ? plain : `${plain}-${n}`), [...others, ...scenes]);
  return number === 1 ? plain : `${plain}-${number}`;
}

/**
 * What lies at a place, the smallest first: a point of the chosen thing, or a thing.
 * @param {Plan} plan @param {Place} place @param {number} reach m @param {Ref | null} chosen @param {string[]} [lists]
 * @returns {Ref | null}
 */
export function thingAt(plan, place, reach, chosen, lists = LISTS) {
  if (chosen && lists.includes(chosen.list) && thing(plan, chosen)) {
    const points = pointsOf(plan, chosen);
    const near = points.map((point) => distance(point, place));
    const best = near.indexOf(Math.min(...near));
    if (points.length > 1 && near[best] <= reach) return { ...chosen, point: best };
  }
  /** @type {{ref: Ref, away: number} | null} */
  let found = null;
  for (const list of lists)
    for (const [index] of (plan[list] ?? []).entries()) {
      const away = awayFromThing(plan, { list, index }, place);
      if (away <= reach && (!found || away < found.away)) found = { ref: { list, index }, away };
    }
  return found && found.ref;
}

function awayFromThing(plan, ref, place) {
  const found = thing(plan, ref);
  const points = pointsOf(plan, ref);
  if (points.length > 1) return awayFrom(points, place);
  const away = distance(points[0], place);
  if (found.radius !== undefined) return Math.max(0, away - found.radius);
  if (found.size) return awayFromBox(found, place);
  return Math.max(0, away - (found.width ?? 0) / 2);
}

function awayFromBox({ position, size, angle = 0 }, [x, y]) {
  const [dx, dy] = [x - position[0], y - position[1]];
  const along = Math.abs(dx * Math.cos(angle) + dy * Math.sin(angle)) - size[0] / 2;
  const across = Math.abs(dy * Math.cos(angle) - dx * Math.sin(angle)) - size[1] / 2;
  return Math.hypot(Math.max(0, along), Math.max(0, across));
}

/** The rectangle round everything; null for an empty plan. @param {Plan} plan */
export function boundsOfPlan(plan) {
  const places = LISTS.flatMap((list) => (plan[list] ?? []).flatMap((_, index) => pointsOf(plan, { list, index })));
  const area = plan.ground?.area;
  if (area) places.push([area[0], area[1]], [area[2], area[3]]);
  return boundsOf(places);
}
