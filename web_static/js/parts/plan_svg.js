/** A floor plan from above: walls, doors, furniture, rooms, the prescribed path and what was driven. */
import { s, set } from "./dom.js";

const MARGIN = 0.4; // m around the walls
const NEAR = 1.8; // m around the path: as far as a chair strays
const CHAIR = "M.55 0 L-.35 .34 L-.35 -.34 Z"; // m, pointing ahead

const BORDER = 0.3; // m around an open ground
const ARROW = 0.45; // m, of somebody who moves by himself, and of a mark

/** @typedef {{walls: [number, number][][], obstacles: any[], rooms: any[], paths: any[], wall_thickness: number, ground: any, cones: any[], movers: any[]}} FloorPlan */

/**
 * @param {FloorPlan} plan @param {[number, number][]} path
 * @param {{label: string, hasRooms?: boolean, isNear?: boolean, task?: any}} options isNear: show only what lies near the path;
 * task: what is asked along it
 */
export function planPicture(plan, path, { label, hasRooms = false, isNear = false, task = null }) {
  const { area } = plan.ground;
  const corners = area ? [area.slice(0, 2), area.slice(2)] : [];
  const box = isNear ? bounds(path, NEAR) : bounds([...plan.walls.flat(), ...path, ...corners], area ? BORDER : MARGIN);
  const driven = s("polyline", { class: "driven" });
  const chair = s("path", { class: "chair", d: CHAIR, visibility: "hidden" });
  const movers = s("g", { class: "movers" }, plan.movers.map(mover));
  const lines = s(
    "g",
    { class: "lines" },
    s("polyline", { class: `prescribed ${task?.kind ?? "path"}`, points: points(path) }),
    ends(path, task),
    driven,
    chair,
  );
  // The plan's y goes up, the picture's down.
  const scene = s(
    "g",
    { transform: "scale(1 -1)" },
    area && s("rect", { class: `ground ${plan.ground.kind}`, x: area[0], y: area[1], width: area[2] - area[0], height: area[3] - area[1] }),
    s("g", { class: "things" }, plan.obstacles.map(obstacle)),
    s("g", { class: "cones" }, plan.cones.map(({ position: [x, y], radius }) => s("circle", { cx: x, cy: y, r: radius }))),
    s(
      "g",
      { class: "walls", "stroke-width": plan.wall_thickness },
      plan.walls.map((wall) => s("polyline", { points: points(wall) })),
    ),
    lines,
    movers,
  );
  const element = s(
    "svg",
    {
      class: "plan",
      viewBox: `${box.x} ${-box.y - box.height} ${box.width} ${box.height}`,
      role: "img",
      "aria-label": label,
    },
    scene,
    hasRooms &&
      plan.rooms.map(({ label: words, position: [x, y] }) =>
        s("text", { class: "room", x, y: -y, "text-anchor": "middle" }, words),
      ),
  );
  element.style.setProperty("--unit", String(Math.max(box.width, box.height) / 100));
  return {
    element,
    box,
    setDriven: (line) => set(driven, { points: points(line) }),
    /** The only one that is followed: plans with a leader to follow have him first. */
    setLeader: ([x, y, theta]) =>
      movers.firstChild &&
      set(movers.firstChild, { transform: `translate(${x} ${y}) rotate(${(theta * 180) / Math.PI})` }),
    setPose: ([x, y, theta]) =>
      set(chair, {
        visibility: "visible",
        transform: `translate(${x} ${y}) rotate(${(theta * 180) / Math.PI}) scale(${Math.max(1, box.width / 18)})`,
      }),
  };
}

/** @param {[number, number][]} line */
function points(line) {
  return line.map(([x, y]) => `${x},${y}`).join(" ");
}

/** Start and goal; of a turn on the spot the way round and the mark. */
function ends(path, task) {
  const [x, y] = path[0];
  const [goalX, goalY] = path.at(-1);
  const start = s("circle", { class: "start", cx: x, cy: y, r: 0.28 });
  if (task?.kind === "turn") return [start, s("path", { class: "mark", d: arrow(), transform: pointing(path.at(-1), path[0], path.at(-1)) })];
  return [start, s("circle", { class: "goal", cx: goalX, cy: goalY, r: 0.34 })];
}

/** Somebody who moves by himself, where he begins. */
function mover({ points: line }) {
  return s("path", { d: arrow(), transform: pointing(line[0], line[0], line[1]) });
}

function arrow() {
  return `M${ARROW} 0 L${-ARROW} ${ARROW * 0.7} L${-ARROW} ${-ARROW * 0.7} Z`;
}

/** @param {[number, number]} at @param {[number, number]} from @param {[number, number]} to */
function pointing([x, y], from, to) {
  const angle = (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
  return `translate(${x} ${y}) rotate(${angle})`;
}

function obstacle(one) {
  const [x, y] = one.position;
  if (one.kind === "cylinder") return s("circle", { cx: x, cy: y, r: one.radius });
  const [width, depth] = one.size;
  return s("rect", {
    x: x - width / 2,
    y: y - depth / 2,
    width,
    height: depth,
    rx: 0.06,
    transform: one.angle ? `rotate(${(one.angle * 180) / Math.PI} ${x} ${y})` : null,
  });
}

function bounds(line, margin) {
  const xs = line.map(([x]) => x);
  const ys = line.map(([, y]) => y);
  const [x, y] = [Math.min(...xs) - margin, Math.min(...ys) - margin];
  return { x, y, width: Math.max(...xs) + margin - x, height: Math.max(...ys) + margin - y };
}
