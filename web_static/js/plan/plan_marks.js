/** What is drawn on a plan: the start, goal and turning direction of a task; gaps, doors, movers and the chair. */
import { REFERENCE } from "../reference.js";
import { s } from "../widgets/dom.js";
import { heading } from "./floor_plan.js";

/**
 * @typedef {import("./floor_plan.js").Point} Point
 * @typedef {import("./floor_plan.js").Stage} Stage
 * @typedef {Pick<import("./floor_plan.js").PrescribedPath, "task" | "start_heading">} Request what is asked along a path
 */

const ARROW = 0.45; // m, half the length of the arrow of a mover, of a start and of a mark
const TURN_RADIUS = 0.95; // m, of the arc that shows the direction of a turn

/** The points of a line as SVG has them. @param {readonly (readonly number[])[]} line */
export function points(line) {
  return line.map(([x, y]) => `${x},${y}`).join(" ");
}

/**
 * Draw the start of a task and its goal, or the arc of a turn.
 * @param {Point[]} line
 * @param {Request | null} request null: to follow the line
 * @param {number} scale by which marks are drawn larger than life, so that they are seen on a large plan
 */
export function marks(line, request, scale) {
  const task = request?.task ?? { kind: "path" };
  const along = heading(line[0], line[1]);
  const startHeading = request?.start_heading ?? (task.kind === "back" ? along + Math.PI : along);
  const start = arrow("start", line[0], startHeading, scale);
  if (task.kind === "turn") return { element: [start, ...turnArc(line, startHeading, task.direction)], goal: null };
  const [x, y] = line[line.length - 1];
  const goal = s("circle", { class: "goal", cx: x, cy: y, r: 0.34 * scale });
  return { element: [start, goal], goal };
}

/**
 * The arc from the start heading to the mark, with an arrow head, and the mark.
 * @param {Point[]} line the place of the turn, and the mark @param {number} startHeading rad
 * @param {"left" | "right"} direction
 */
function turnArc([spot, mark], startHeading, direction) {
  const sign = direction === "left" ? 1 : -1;
  const sweep = modulo(sign * (heading(spot, mark) - startHeading), 2 * Math.PI) || 2 * Math.PI;
  /** @param {number} angle rad @returns {Point} */
  const at = (angle) => [spot[0] + TURN_RADIUS * Math.cos(angle), spot[1] + TURN_RADIUS * Math.sin(angle)];
  // Two arcs, because one SVG arc cannot draw a full circle. The second ends 0.3 rad early to leave room for its head.
  const [first, half, last] = [startHeading, startHeading + (sign * sweep) / 2, startHeading + sign * (sweep - 0.3)];
  /** @param {number} angle rad */
  const arc = (angle) => `A${TURN_RADIUS} ${TURN_RADIUS} 0 0 ${sign > 0 ? 1 : 0} ${at(angle).join(" ")}`;
  return [
    s("path", { class: "round", d: `M${at(first).join(" ")} ${arc(half)} ${arc(last)}` }),
    arrow("round-head", at(last), last + (sign * Math.PI) / 2, 0.7),
    s("circle", { class: "mark", cx: mark[0], cy: mark[1], r: 0.2 }),
  ];
}

/** A line from one side of a gap to the other. @param {import("./floor_plan.js").Gap} gap */
export function gap({ position: [x, y], width, heading: direction }) {
  const [dx, dy] = [(-Math.sin(direction) * width) / 2, (Math.cos(direction) * width) / 2];
  return s("polyline", {
    class: "gap",
    points: points([
      [x - dx, y - dy],
      [x + dx, y + dy],
    ]),
  });
}

/** A doorway: its sill between the two sides of its frame. @param {import("./floor_plan.js").Door} door */
export function door({ position, width, heading: direction }) {
  const half = width / 2;
  return s(
    "g",
    { class: "door", transform: placement(position, direction) },
    s("path", { class: "sill", d: `M0 ${-half} L0 ${half}` }),
    s("path", { class: "jambs", d: `M-.09 ${-half} L.09 ${-half} M-.09 ${half} L.09 ${half}` }),
  );
}

/**
 * A mover at its start, its radius, and the line along which it moves.
 * @param {import("./floor_plan.js").Mover} mover @param {number} scale
 */
export function mover({ points: line, radius }, scale) {
  const body = s(
    "g",
    { class: "mover-body", transform: placement(line[0], heading(line[0], line[1])) },
    s("circle", { class: "reach", r: radius }),
    arrow("mover", [0, 0], 0, scale),
  );
  return { way: s("polyline", { class: "mover-way", points: points(line) }), body };
}

/** The chair: the circle that touches things, true to size; seat, wheels and an arrow ahead (m) show where it faces. */
export function chairOutline() {
  return s(
    "g",
    { class: "chair-outline" },
    s("circle", { class: "reach", r: REFERENCE.numbers.chair_radius }),
    s("path", { class: "wheels", d: "M-.17 .29H.17 M-.17 -.29H.17 M.34 .2H.44 M.34 -.2H.44" }),
    s("rect", { class: "seat", x: -0.32, y: -0.23, width: 0.6, height: 0.46, rx: 0.08 }),
    s("path", { class: "nose", d: "M.78 0 L.46 .2 L.46 -.2 Z" }),
    s("path", { class: "shaft", d: "M-.2 0 H.48" }),
  );
}

/**
 * The heading (rad) of the chair when a stage of a course begins; null for the first stage, whose task says it.
 * @param {Stage[]} stages @param {number} number from 0
 */
export function headingBefore(stages, number) {
  if (number === 0) return null;
  const { points: line, task } = stages[number - 1];
  if (task.kind === "turn") return heading(line[0], line[1]);
  const along = heading(line[line.length - 2], line[line.length - 1]);
  return task.kind === "back" ? along + Math.PI : along;
}

/** @param {string} name @param {readonly number[]} at @param {number} angle rad @param {number} scale */
function arrow(name, at, angle, scale = 1) {
  const size = ARROW * scale;
  const d = `M${size} 0 L${-size} ${size * 0.7} L${-size} ${-size * 0.7} Z`;
  return s("path", { class: name, d, transform: placement(at, angle) });
}

/** The SVG transform to a place and an angle. @param {readonly (number | null)[]} at @param {number | null} angle rad */
export function placement([x, y], angle) {
  return `translate(${x} ${y}) rotate(${(Number(angle) * 180) / Math.PI})`;
}

/** @param {number} a @param {number} b */
function modulo(a, b) {
  return ((a % b) + b) % b;
}
