/**
 * What a tap does, for each tool: from one state to the next, without a page.
 * @typedef {import("./geometry.js").Place} Place
 * @typedef {{plan: any, tool: string, pending: Place[], chosen: any, doorWidth: number}} State
 * @typedef {State & {words?: string}} After words: the key of a text to say
 */
import { add, change, movedTo, newPath, pointsOf, remove, thing, thingAt } from "./document.js";
import { changedDoor, withDoor, withoutDoor } from "./doors.js";
import { distance, heading, snapped, tidy } from "./geometry.js";

export const TOOLS = ["move", "wall", "door", "box", "round", "cone", "path", "heading", "erase"];
const SMALLEST = 0.05; // m, a side or a radius
const CONE = { radius: 0.15, height: 0.5 };
const LINES = new Set(["wall", "path"]);

/** Snap a place: to the end of a wall that is near, otherwise to the grid. @param {any} plan @param {Place} place @param {number} step m @param {number} reach m */
export function snapPlace(plan, place, step, reach) {
  if (!step) return snapped(place, 0);
  let best = null;
  for (const wall of plan.walls)
    for (const end of [wall[0], wall.at(-1)]) {
      const away = distance(end, place);
      if (away <= reach && (!best || away < best.away)) best = { end, away };
    }
  return best ? best.end : snapped(place, step);
}

/** Take up another tool; a line that was begun is finished first. @param {State} state @param {string} tool @returns {After} */
export function withTool(state, tool) {
  return { ...finished(state), tool, pending: [] };
}

/**
 * @param {State} state @param {Place} place where the finger was @param {{step: number, reach: number}} how
 * step: m, of the grid, 0 for none; reach: m, how far from the finger something counts as meant
 * @returns {After}
 */
export function tapped(state, place, { step, reach }) {
  const { plan, chosen, pending } = state;
  const at = snapPlace(plan, place, step, reach);
  switch (state.tool) {
    case "placing": {
      const moved = placed(state, at, reach);
      return { ...moved, tool: "move" };
    }
    case "wall":
    case "path":
      return lineTapped(state, at, reach);
    case "door": {
      const made = withDoor(plan, place, state.doorWidth, 2 * reach);
      return "problem" in made ? { ...state, words: `editor.door.${made.problem}` } : { ...state, ...chosenIn(made) };
    }
    case "box":
      if (!pending.length) return { ...state, pending: [at], chosen: null };
      return madeOf(state, boxBetween(pending[0], at));
    case "round":
      if (!pending.length) return { ...state, pending: [at], chosen: null };
      return madeOf(state, {
        kind: "cylinder",
        label: "Round",
        position: pending[0],
        radius: tidy(Math.max(SMALLEST, distance(pending[0], at))),
      });
    case "cone":
      return { ...state, ...chosenIn(add(plan, "cones", { position: at, ...CONE })) };
    case "heading":
      return headingTapped(state, place, reach);
    case "erase": {
      const ref = thingAt(plan, place, reach, null);
      return ref ? erased(state, ref) : state;
    }
    default:
      return { ...state, chosen: thingAt(plan, place, reach, chosen) };
  }
}

/** Take a thing away; a door's gap is closed again. @param {State} state @param {any} ref @returns {After} */
export function erased(state, ref) {
  const plan = ref.list === "doors" ? withoutDoor(state.plan, ref) : remove(state.plan, ref);
  return { ...state, plan, chosen: null };
}

/** Put the chosen thing, or its chosen point, somewhere else. @param {State} state @param {Place} at @param {number} reach m @returns {After} */
export function placed(state, at, reach) {
  const { plan, chosen } = state;
  if (!chosen) return state;
  if (chosen.list !== "doors") return { ...state, plan: movedTo(plan, chosen, at) };
  const made = changedDoor(plan, chosen, at, thing(plan, chosen).width, 4 * reach);
  return { ...state, plan: made.plan, chosen: made.ref, words: made.problem && `editor.door.${made.problem}` };
}

/** End a line that was begun; with fewer than two points there was none. @param {State} state @returns {After} */
export function finished(state) {
  const { plan, tool, pending } = state;
  if (!LINES.has(tool) || pending.length < 2) return { ...state, pending: [] };
  const made = tool === "wall" ? add(plan, "walls", pending) : add(plan, "paths", newPath(plan, pending));
  return { ...state, ...chosenIn(made), pending: [] };
}

function lineTapped(state, at, reach) {
  const { pending } = state;
  // At the last point again: a double tap, or a finger that says: that was it.
  if (pending.length && distance(pending.at(-1), at) < SMALLEST) return finished(state);
  const closes = state.tool === "wall" && pending.length > 2 && distance(pending[0], at) <= reach / 2;
  const next = { ...state, pending: [...pending, closes ? pending[0] : at], chosen: null };
  return closes ? finished(next) : next;
}

function headingTapped(state, place, reach) {
  const { plan, chosen } = state;
  const ref =
    chosen?.list === "paths" && thing(plan, chosen)
      ? chosen
      : plan.paths.length === 1
        ? { list: "paths", index: 0 }
        : thingAt(plan, place, reach, null, ["paths"]);
  if (!ref) return { ...state, words: "editor.heading.choose" };
  if (ref !== chosen && plan.paths.length > 1) return { ...state, chosen: ref, words: "editor.heading.now" };
  const start = pointsOf(plan, ref)[0];
  if (distance(start, place) < SMALLEST) return { ...state, chosen: ref };
  const next = change(plan, { list: "paths", index: ref.index }, { start_heading: tidy(heading(start, place)) });
  return { ...state, plan: next, chosen: { list: "paths", index: ref.index } };
}

function boxBetween(a, b) {
  return {
    kind: "box",
    label: "Box",
    position: [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2)],
    size: [0, 1].map((axis) => tidy(Math.max(SMALLEST, Math.abs(b[axis] - a[axis])))),
    height: 0.75,
  };
}

function madeOf(state, obstacle) {
  return { ...state, ...chosenIn(add(state.plan, "obstacles", obstacle)), pending: [] };
}

function chosenIn({ plan, ref }) {
  return { plan, chosen: ref };
}
