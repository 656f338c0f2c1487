/** A floor plan from above: walls, doors, furniture, rooms, the prescribed path and what was driven. */
import { s, set } from "./dom.js";

const MARGIN = 0.4; // m around the walls
const NEAR = 1.8; // m around the path: as far as a chair strays
const CHAIR = "M.55 0 L-.35 .34 L-.35 -.34 Z"; // m, pointing ahead

/** @typedef {{walls: [number, number][][], obstacles: any[], rooms: any[], paths: any[], wall_thickness: number}} FloorPlan */

/**
 * @param {FloorPlan} plan @param {[number, number][]} path
 * @param {{label: string, hasRooms?: boolean, isNear?: boolean}} options isNear: show only what lies near the path
 */
export function planPicture(plan, path, { label, hasRooms = false, isNear = false }) {
  const box = isNear ? bounds(path, NEAR) : bounds([...plan.walls.flat(), ...path], MARGIN);
  const driven = s("polyline", { class: "driven" });
  const chair = s("path", { class: "chair", d: CHAIR, visibility: "hidden" });
  const lines = s(
    "g",
    { class: "lines" },
    s("polyline", { class: "prescribed", points: points(path) }),
    ends(path),
    driven,
    chair,
  );
  // The plan's y goes up, the picture's down.
  const scene = s(
    "g",
    { transform: "scale(1 -1)" },
    s("g", { class: "things" }, plan.obstacles.map(obstacle)),
    s(
      "g",
      { class: "walls", "stroke-width": plan.wall_thickness },
      plan.walls.map((wall) => s("polyline", { points: points(wall) })),
    ),
    lines,
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

function ends(path) {
  const [x, y] = path[0];
  const [goalX, goalY] = path.at(-1);
  return [
    s("circle", { class: "start", cx: x, cy: y, r: 0.28 }),
    s("circle", { class: "goal", cx: goalX, cy: goalY, r: 0.34 }),
  ];
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
