/** What is drawn on a plan for a task: how the chair begins, where it is to get, the way round; gaps, doors; the chair; who moves. */
import { s } from "../widgets/dom.js";

const ARROW = 0.45; // m, of somebody who moves by himself, of a start and of a mark
const ROUND = 0.95; // m, radius of the way round
const CHAIR_RADIUS = 0.32; // m: what touches things (app/world/kinematics.py)

/** @typedef {[number, number]} Point */

/** @param {Point[]} line */
export function points(line) {
  return line.map(([x, y]) => `${x},${y}`).join(" ");
}

/**
 * How the chair begins and where it is to get. @param {Point[]} line
 * @param {{task: any, start_heading: number | null} | null} asked null: to follow the line
 * @param {number} scale by which marks are larger than life, so that they are seen on a large plan
 */
export function marks(line, asked, scale) {
  const kind = asked?.task.kind ?? "path";
  const along = heading(line[0], line[1]);
  const begins = asked?.start_heading ?? (kind === "back" ? along + Math.PI : along);
  const start = arrow("start", line[0], begins, scale);
  if (kind === "turn") return { element: [start, ...wayRound(line, begins, asked.task.direction)], goal: null };
  const [x, y] = line.at(-1);
  const goal = s("circle", { class: "goal", cx: x, cy: y, r: 0.34 * scale });
  return { element: [start, goal], goal };
}

/** The way round to the mark, with a head, and the mark. */
function wayRound([spot, mark], begins, direction) {
  const sign = direction === "left" ? 1 : -1;
  const ends = heading(spot, mark);
  const sweep = modulo(sign * (ends - begins), 2 * Math.PI) || 2 * Math.PI;
  const at = (angle) => [spot[0] + ROUND * Math.cos(angle), spot[1] + ROUND * Math.sin(angle)];
  // In two arcs: one alone cannot go all the way round. It ends short of the mark, for its head.
  const [first, half, last] = [begins, begins + (sign * sweep) / 2, begins + sign * (sweep - 0.3)];
  const arc = (angle) => `A${ROUND} ${ROUND} 0 0 ${sign > 0 ? 1 : 0} ${at(angle).join(" ")}`;
  return [
    s("path", { class: "round", d: `M${at(first).join(" ")} ${arc(half)} ${arc(last)}` }),
    arrow("round-head", at(last), last + (sign * Math.PI) / 2, 0.7),
    s("circle", { class: "mark", cx: mark[0], cy: mark[1], r: 0.2 }),
  ];
}

/** A line from one side of a gap to the other. */
export function gap({ position: [x, y], width, heading: way }) {
  const [dx, dy] = [(-Math.sin(way) * width) / 2, (Math.cos(way) * width) / 2];
  return s("polyline", { class: "gap", points: points([[x - dx, y - dy], [x + dx, y + dy]]) });
}

/** A doorway: its sill between the frame's two sides. */
export function door({ position: [x, y], width, heading: way }) {
  const half = width / 2;
  return s(
    "g",
    { class: "door", transform: placed([x, y], way) },
    s("path", { class: "sill", d: `M0 ${-half} L0 ${half}` }),
    s("path", { class: "jambs", d: `M-.09 ${-half} L.09 ${-half} M-.09 ${half} L.09 ${half}` }),
  );
}

/** Somebody who moves by himself: where he begins, how much room he takes, and his way. */
export function mover({ points: line, radius }, scale) {
  const body = s(
    "g",
    { class: "mover-body", transform: placed(line[0], heading(line[0], line[1])) },
    s("circle", { class: "reach", r: radius }),
    arrow("mover", [0, 0], 0, scale),
  );
  return { way: s("polyline", { class: "mover-way", points: points(line) }), body };
}

/** The chair true to size: the circle that touches things, seat and wheels, and an arrow to where it looks. */
export function chairOutline() {
  return s(
    "g",
    { class: "chair-outline" },
    s("circle", { class: "reach", r: CHAIR_RADIUS }),
    s("path", { class: "wheels", d: "M-.17 .29H.17 M-.17 -.29H.17 M.34 .2H.44 M.34 -.2H.44" }),
    s("rect", { class: "seat", x: -0.32, y: -0.23, width: 0.6, height: 0.46, rx: 0.08 }),
    s("path", { class: "nose", d: "M.78 0 L.46 .2 L.46 -.2 Z" }),
    s("path", { class: "shaft", d: "M-.2 0 H.48" }),
  );
}

/** Which way the chair looks when a stage of a course begins; null for the first, which has its own rule. */
export function headingBefore(stages, number) {
  if (number === 0) return null;
  const { points: line, task } = stages[number - 1];
  if (task.kind === "turn") return heading(line[0], line[1]);
  const along = heading(line.at(-2), line.at(-1));
  return task.kind === "back" ? along + Math.PI : along;
}

/** @param {string} name @param {number[]} at @param {number} angle rad @param {number} scale */
function arrow(name, at, angle, scale = 1) {
  const size = ARROW * scale;
  const d = `M${size} 0 L${-size} ${size * 0.7} L${-size} ${-size * 0.7} Z`;
  return s("path", { class: name, d, transform: placed(at, angle) });
}

/** @param {number[]} at @param {number} angle rad */
export function placed([x, y], angle) {
  return `translate(${x} ${y}) rotate(${(angle * 180) / Math.PI})`;
}

function heading(from, to) {
  return Math.atan2(to[1] - from[1], to[0] - from[0]);
}

function modulo(a, b) {
  return ((a % b) + b) % b;
}
