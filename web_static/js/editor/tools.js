/**
 * What a tap does, for each tool: from one state to the next, without a page.
 * @import { Point } from "../plan/floor_plan.js"
 * @import { ObstacleItem, Plan, Ref } from "./document.js"
 * @typedef {typeof TOOLS[number]} Tool
 * @typedef {object} State
 * @property {Plan} plan
 * @property {Tool | "placing"} tool placing: the next tap moves the chosen item to it
 * @property {Point[]} pending the points of the line or box that is being drawn
 * @property {Ref | null} chosen
 * @property {number} doorWidth m, of the next door
 * @typedef {State & {words?: string}} NextState words: the key of a text to show
 */
import { heading } from "../plan/floor_plan.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { add, change, itemNear, itemOf, moveTo, newPath, pointsOf, remove } from "./document.js";
import { changeDoor, doorOf, insertDoor, removeDoor } from "./doors.js";
import { distance, tidy } from "./geometry.js";
import { snapPlace } from "./snap.js";

export const TOOLS = /** @type {const} */ ([
  "move",
  "wall",
  "door",
  "box",
  "round",
  "cone",
  "path",
  "heading",
  "erase",
]);
const SMALLEST = 0.05; // m, a side or a radius

/** Choose a tool; an unfinished line is finished first. @param {State} state @param {Tool} tool @returns {NextState} */
export function withTool(state, tool) {
  return { ...finishLine(state), tool, pending: [] };
}

/**
 * @param {State} state @param {Point} place where the finger was @param {{step: number, reach: number}} how
 * step: m, of the grid, 0 for none; reach: m, the distance from the finger within which an item is hit
 * @returns {NextState}
 */
export function tap(state, place, { step, reach }) {
  const { plan, chosen, pending } = state;
  const at = snapPlace(plan, place, step, reach);
  switch (state.tool) {
    case "placing": {
      const moved = placeChosen(state, at, reach);
      return { ...moved, tool: "move" };
    }
    case "wall":
    case "path":
      return tapLine(state, at, reach);
    case "door": {
      const made = insertDoor(plan, place, state.doorWidth, 2 * reach);
      return "problem" in made
        ? { ...state, words: `editor-door-${made.problem}` }
        : { ...state, ...selectionOf(made) };
    }
    case "box":
      if (!pending.length) return { ...state, pending: [at], chosen: null };
      return withObstacle(state, boxBetween(pending[0], at));
    case "round":
      if (!pending.length) return { ...state, pending: [at], chosen: null };
      return withObstacle(state, {
        kind: "cylinder",
        label: t("editor-new-round"),
        position: pending[0],
        radius: tidy(Math.max(SMALLEST, distance(pending[0], at))),
      });
    case "cone": {
      const { cone_radius: radius, cone_height: height } = REFERENCE.numbers;
      return { ...state, ...selectionOf(add(plan, "cones", { position: at, radius, height })) };
    }
    case "heading":
      return tapHeading(state, place, reach);
    case "erase": {
      const ref = itemNear(plan, place, reach, null);
      return ref ? erase(state, ref) : state;
    }
    default:
      return { ...state, chosen: itemNear(plan, place, reach, chosen) };
  }
}

/** Remove an item; the gap of a door is closed again. @param {State} state @param {Ref} ref @returns {NextState} */
export function erase(state, ref) {
  const plan = ref.list === "doors" ? removeDoor(state.plan, ref) : remove(state.plan, ref);
  return { ...state, plan, chosen: null };
}

/**
 * Move the chosen item, or its chosen point, to a place.
 * @param {State} state @param {Point} at @param {number} reach m @returns {NextState}
 */
export function placeChosen(state, at, reach) {
  const { plan, chosen } = state;
  if (!chosen) return state;
  if (chosen.list !== "doors") return { ...state, plan: moveTo(plan, chosen, at) };
  const made = changeDoor(plan, chosen, at, doorOf(plan, chosen).width, 4 * reach);
  return { ...state, plan: made.plan, chosen: made.ref, words: made.problem && `editor-door-${made.problem}` };
}

/**
 * Finish the line that is being drawn; with fewer than two points there is none.
 * @param {State} state @returns {NextState}
 */
export function finishLine(state) {
  const { plan, tool, pending } = state;
  if ((tool !== "wall" && tool !== "path") || pending.length < 2) return { ...state, pending: [] };
  const made = tool === "wall" ? add(plan, "walls", pending) : add(plan, "paths", newPath(plan, pending));
  return { ...state, ...selectionOf(made), pending: [] };
}

/** @param {State} state @param {Point} at @param {number} reach m @returns {NextState} */
function tapLine(state, at, reach) {
  const { pending } = state;
  // A second tap at the last point finishes the line.
  if (pending.length && distance(pending[pending.length - 1], at) < SMALLEST) return finishLine(state);
  const closes = state.tool === "wall" && pending.length > 2 && distance(pending[0], at) <= reach / 2;
  const next = { ...state, pending: [...pending, closes ? pending[0] : at], chosen: null };
  return closes ? finishLine(next) : next;
}

/** @param {State} state @param {Point} place @param {number} reach m @returns {NextState} */
function tapHeading(state, place, reach) {
  const { plan, chosen } = state;
  /** @type {Ref | null} */
  const ref =
    chosen?.list === "paths" && itemOf(plan, chosen)
      ? chosen
      : plan.paths.length === 1
        ? { list: "paths", index: 0 }
        : itemNear(plan, place, reach, null, ["paths"]);
  if (!ref) return { ...state, words: "editor-heading-choose" };
  if (ref !== chosen && plan.paths.length > 1) return { ...state, chosen: ref, words: "editor-heading-now" };
  const start = pointsOf(plan, ref)[0];
  if (distance(start, place) < SMALLEST) return { ...state, chosen: ref };
  const next = change(plan, { list: "paths", index: ref.index }, { start_heading: tidy(heading(start, place)) });
  return { ...state, plan: next, chosen: { list: "paths", index: ref.index } };
}

/** @param {Point} a @param {Point} b two opposite corners @returns {ObstacleItem} */
function boxBetween(a, b) {
  /** @param {0 | 1} axis */
  const side = (axis) => tidy(Math.max(SMALLEST, Math.abs(b[axis] - a[axis])));
  return {
    kind: "box",
    label: t("editor-new-box"),
    position: [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2)],
    size: [side(0), side(1)],
    height: REFERENCE.numbers.obstacle_height,
  };
}

/** @param {State} state @param {ObstacleItem} obstacle @returns {NextState} */
function withObstacle(state, obstacle) {
  return { ...state, ...selectionOf(add(state.plan, "obstacles", obstacle)), pending: [] };
}

/** @param {{plan: Plan, ref: Ref}} change */
function selectionOf({ plan, ref }) {
  return { plan, chosen: ref };
}
