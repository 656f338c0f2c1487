/**
 * Floor plan documents: each function returns another document and leaves the given one as it is.
 * @import { Box, Cone, Cylinder, Door, FloorPlan, Gap, Mover, PrescribedPath, Room } from "types/api"
 * @import { Point } from "../plan/floor_plan.js"
 * @typedef {typeof LISTS[number]} ListName
 * @typedef {{list: ListName, index: number, point?: number}} Ref an item of a plan, and maybe one of its points
 * @typedef {Record<string, unknown>} Fields new values by the name of the field
 */

/**
 * A document in which only some fields must be written; the others have defaults (docs/floorplans.md).
 * @template T @template {keyof T} Needed
 * @typedef {Partial<T> & Pick<T, Needed>} Sparse
 */

/**
 * @typedef {Sparse<PrescribedPath, "name" | "title" | "points" | "instruction">} PathItem
 * @typedef {Sparse<Box, "kind" | "label" | "position" | "size">} BoxItem
 * @typedef {Sparse<Cylinder, "kind" | "label" | "position" | "radius">} CylinderItem
 * @typedef {BoxItem | CylinderItem} ObstacleItem
 * @typedef {Sparse<Door, "position">} DoorItem
 * @typedef {Sparse<Gap, "label" | "position" | "width">} GapItem
 * @typedef {Sparse<Cone, "position">} ConeItem
 * @typedef {Sparse<Mover, "name" | "kind" | "points" | "pace">} MoverItem
 */

/**
 * A floor plan as it is edited.
 * @typedef {Partial<Pick<FloorPlan, "wall_height" | "wall_thickness" | "ground" | "lights">> & PlanLists} Plan
 * @typedef {object} PlanLists
 * @property {string} name
 * @property {string} title
 * @property {Point[][]} walls
 * @property {PathItem[]} paths
 * @property {ObstacleItem[]} [obstacles]
 * @property {Room[]} [rooms]
 * @property {DoorItem[]} [doors]
 * @property {ConeItem[]} [cones]
 * @property {GapItem[]} [gaps]
 * @property {MoverItem[]} [movers]
 */

/**
 * The geometry and the words of an item; which of them an item has depends on its list.
 * @typedef {object} ItemFields
 * @property {Point} [position]
 * @property {Point[]} [points]
 * @property {number} [radius] m
 * @property {[number, number]} [size] m
 * @property {number} [width] m
 * @property {number} [height] m
 * @property {number} [angle] rad
 * @property {number} [heading] rad
 * @property {string} [label]
 * @property {string} [title]
 * @property {string} [name]
 * @typedef {Point[] | ItemFields} Item a wall is its points
 */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { boundsOf, distance, distanceToLine, lengthOf, tidy } from "./geometry.js";

export const LISTS = /** @type {const} */ ([
  "paths",
  "cones",
  "doors",
  "obstacles",
  "walls",
  "movers",
  "gaps",
  "rooms",
]);

/** @param {string} title @returns {Plan} */
export function emptyPlan(title) {
  return { name: "plan", title, walls: [], obstacles: [], rooms: [], doors: [], cones: [], paths: [] };
}

/** The items of one list. @param {Plan} plan @param {ListName} list @returns {Item[]} */
export function itemsOf(plan, list) {
  return plan[list] ?? [];
}

/** @param {Plan} plan @param {Ref} ref */
export function itemOf(plan, ref) {
  return itemsOf(plan, ref.list)[ref.index];
}

/** The fields of an item; a wall has none. @param {Plan} plan @param {Ref} ref @returns {ItemFields} */
export function fieldsOf(plan, ref) {
  const item = itemOf(plan, ref);
  return Array.isArray(item) ? {} : item;
}

/**
 * The points of a wall, a path or a mover; the position of another item.
 * @param {Plan} plan @param {Ref} ref @returns {Point[]}
 */
export function pointsOf(plan, ref) {
  const item = itemOf(plan, ref);
  if (Array.isArray(item)) return item;
  return item.points ?? [/** @type {Point} */ (item.position)]; // every item has points or a position
}

/** @param {Plan} plan @param {ListName} list @param {Item} item @returns {{plan: Plan, ref: Ref}} */
export function add(plan, list, item) {
  const all = [...itemsOf(plan, list), item];
  return { plan: { ...plan, [list]: all }, ref: { list, index: all.length - 1 } };
}

/** @param {Plan} plan @param {Ref} ref @param {Item} other @returns {Plan} */
function replaceItem(plan, { list, index }, other) {
  return { ...plan, [list]: itemsOf(plan, list).map((item, i) => (i === index ? other : item)) };
}

/** Change fields of an item; undefined removes a field. @param {Plan} plan @param {Ref} ref @param {Fields} fields */
export function change(plan, ref, fields) {
  /** @type {Fields} */
  const next = { ...itemOf(plan, ref), ...fields };
  for (const [name, value] of Object.entries(fields)) if (value === undefined) delete next[name];
  return replaceItem(plan, ref, next);
}

/** Remove an item. @param {Plan} plan @param {Ref} ref @returns {Plan} */
export function remove(plan, { list, index }) {
  return { ...plan, [list]: itemsOf(plan, list).filter((_, i) => i !== index) };
}

/** @param {Plan} plan @param {Ref} ref @param {Point[]} points @returns {Plan} */
export function setPoints(plan, ref, points) {
  const item = itemOf(plan, ref);
  if (Array.isArray(item)) return replaceItem(plan, ref, points);
  return item.points ? change(plan, ref, { points }) : change(plan, ref, { position: points[0] });
}

/** Move an item, or only its chosen point. @param {Plan} plan @param {Ref} ref @param {number} dx m @param {number} dy m */
export function moveBy(plan, ref, dx, dy) {
  /** @param {Point} point @param {number} i @returns {Point} */
  const move = ([x, y], i) => (ref.point === undefined || ref.point === i ? [tidy(x + dx), tidy(y + dy)] : [x, y]);
  return setPoints(plan, ref, pointsOf(plan, ref).map(move));
}

/**
 * Move an item so that its first point lies at a place, or move only its chosen point there.
 * @param {Plan} plan @param {Ref} ref @param {Point} place
 */
export function moveTo(plan, ref, place) {
  const [x, y] = pointsOf(plan, ref)[ref.point ?? 0];
  return moveBy(plan, ref, place[0] - x, place[1] - y);
}

/**
 * Insert a point halfway between the chosen one and the next, or 1 m beyond the last one.
 * @param {Plan} plan @param {Ref} ref @returns {{plan: Plan, ref: Ref}}
 */
export function insertPoint(plan, ref) {
  const points = pointsOf(plan, ref);
  const i = ref.point ?? points.length - 1;
  const [a, b] = i + 1 < points.length ? [points[i], points[i + 1]] : [points[i], beyond(points)];
  /** @type {Point} */
  const middle = i + 1 < points.length ? [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2)] : b;
  const next = [...points.slice(0, i + 1), middle, ...points.slice(i + 1)];
  return { plan: setPoints(plan, ref, next), ref: { ...ref, point: i + 1 } };
}

/** The point 1 m beyond the end of a line. @param {Point[]} points @returns {Point} */
function beyond(points) {
  const [[ax, ay], [bx, by]] = points.slice(-2);
  const length = Math.hypot(bx - ax, by - ay) || 1;
  return [tidy(bx + (bx - ax) / length), tidy(by + (by - ay) / length)];
}

/** Remove the chosen point; a line keeps two. @param {Plan} plan @param {Ref} ref @returns {{plan: Plan, ref: Ref}} */
export function removePoint(plan, ref) {
  const points = pointsOf(plan, ref);
  if (ref.point === undefined || points.length <= 2) return { plan, ref };
  const next = points.filter((_, i) => i !== ref.point);
  return { plan: setPoints(plan, ref, next), ref: { ...ref, point: Math.min(ref.point, next.length - 1) } };
}

/**
 * A path through some points, with a name that no other path of the plan has.
 * @param {Pick<Plan, "paths">} plan @param {Point[]} points @returns {PathItem}
 */
export function newPath(plan, points) {
  const names = plan.paths.map(({ name }) => name);
  const number = firstFree((n) => (n === 1 ? "main" : `path-${n}`), names);
  return {
    name: number === 1 ? "main" : `path-${number}`,
    title: number === 1 ? t("editor-new-path-main") : t("editor-new-path", { number }),
    points,
    goal_radius: REFERENCE.numbers.goal_radius,
    time_limit: timeFor(points),
    instruction: t("editor-new-instruction"),
  };
}

/** The time limit of a path for a slow driver. @param {Point[]} points @returns {number} s */
export function timeFor(points) {
  const { shortest_time_limit: shortest, slowest_mean_speed: slowest } = REFERENCE.numbers;
  return Math.round(Math.max(shortest, lengthOf(points) / slowest));
}

/** The first number, from 1, whose name is free. @param {(number: number) => string} name @param {string[]} taken */
function firstFree(name, taken) {
  let number = 1;
  while (taken.includes(name(number))) number += 1;
  return number;
}

/** A document name made from its title, different from all that are taken. @param {string} title @param {string[]} taken */
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
  // The part of a name before a dot may be the name of a scene, which is taken too.
  const scenes = others.map((name) => name.split(".")[0]);
  const number = firstFree((n) => (n === 1 ? plain : `${plain}-${n}`), [...others, ...scenes]);
  return number === 1 ? plain : `${plain}-${number}`;
}

/**
 * The item at a place, or a point of the chosen item; null when none is within reach.
 * @param {Plan} plan @param {Point} place @param {number} reach m @param {Ref | null} chosen
 * @param {readonly ListName[]} [lists] searched in this order; of items at the same distance the first is returned
 * @returns {Ref | null}
 */
export function itemNear(plan, place, reach, chosen, lists = LISTS) {
  if (chosen && lists.includes(chosen.list) && itemOf(plan, chosen)) {
    const points = pointsOf(plan, chosen);
    const near = points.map((point) => distance(point, place));
    const best = near.indexOf(Math.min(...near));
    if (points.length > 1 && near[best] <= reach) return { ...chosen, point: best };
  }
  /** @type {{ref: Ref, away: number} | null} */
  let nearest = null;
  for (const list of lists)
    for (const index of itemsOf(plan, list).keys()) {
      const away = distanceToItem(plan, { list, index }, place);
      if (away <= reach && (!nearest || away < nearest.away)) nearest = { ref: { list, index }, away };
    }
  return nearest && nearest.ref;
}

/** The distance (m) from a place to the edge of an item. @param {Plan} plan @param {Ref} ref @param {Point} place */
function distanceToItem(plan, ref, place) {
  const { radius, size, width, angle } = fieldsOf(plan, ref);
  const points = pointsOf(plan, ref);
  if (points.length > 1) return distanceToLine(points, place);
  const away = distance(points[0], place);
  if (radius !== undefined) return Math.max(0, away - radius);
  if (size) return distanceToBox(points[0], size, angle, place);
  return Math.max(0, away - (width ?? 0) / 2);
}

/** @param {Point} middle @param {[number, number]} size m @param {number | undefined} angle rad @param {Point} place */
function distanceToBox(middle, size, angle = 0, [x, y]) {
  const [dx, dy] = [x - middle[0], y - middle[1]];
  const along = Math.abs(dx * Math.cos(angle) + dy * Math.sin(angle)) - size[0] / 2;
  const across = Math.abs(dy * Math.cos(angle) - dx * Math.sin(angle)) - size[1] / 2;
  return Math.hypot(Math.max(0, along), Math.max(0, across));
}

/** The upright rectangle around everything; null for an empty plan. @param {Plan} plan */
export function boundsOfPlan(plan) {
  const places = LISTS.flatMap((list) => itemsOf(plan, list).flatMap((_, index) => pointsOf(plan, { list, index })));
  const area = plan.ground?.area;
  if (area) places.push([area[0], area[1]], [area[2], area[3]]);
  return boundsOf(places);
}
