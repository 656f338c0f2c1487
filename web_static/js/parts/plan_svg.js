/** A floor plan from above: ground, walls, furniture, rooms, the prescribed path and what was driven. */
import { s, set } from "./dom.js";
import { gap, marks, mover, placed, points } from "./plan_marks.js";

const MARGIN = 0.4; // m around the walls
const NEAR = 1.8; // m around the path: as far as a chair strays
const BORDER = 0.3; // m around an open ground
const LIFE = 18; // m: of a plan that is wider, marks are drawn larger than life
const CHAIR = "M.55 0 L-.35 .34 L-.35 -.34 Z"; // m, pointing ahead

/** @typedef {{walls: [number, number][][], obstacles: any[], rooms: any[], paths: any[], wall_thickness: number, ground: any, cones: any[], gaps: any[], movers: any[]}} FloorPlan */

/**
 * @param {FloorPlan} plan @param {[number, number][]} path
 * @param {{label: string, hasRooms?: boolean, isNear?: boolean, asked?: any}} options isNear: show only what lies near the path;
 * asked: the prescribed path, for what is asked along it
 */
export function planPicture(plan, path, { label, hasRooms = false, isNear = false, asked = null }) {
  const { area } = plan.ground;
  const corners = area ? [area.slice(0, 2), area.slice(2)] : [];
  const box = isNear ? bounds(path, NEAR) : bounds([...plan.walls.flat(), ...path, ...corners], area ? BORDER : MARGIN);
  const scale = Math.max(1, box.width / LIFE);
  const driven = s("polyline", { class: "driven" });
  const chair = s("path", { class: "chair", d: CHAIR, visibility: "hidden" });
  const movers = plan.movers.map((one) => mover(one, scale));
  const { element: ends, goal } = marks(path, asked, scale);
  const lines = s(
    "g",
    { class: "lines" },
    s("polyline", { class: `prescribed ${asked?.task.kind ?? "path"}`, points: points(path) }),
    ends,
    driven,
    chair,
  );
  // The plan's y goes up, the picture's down.
  const scene = s(
    "g",
    { transform: "scale(1 -1)" },
    area && s("rect", { class: `ground ${plan.ground.kind}`, x: area[0], y: area[1], width: area[2] - area[0], height: area[3] - area[1] }),
    s("g", { class: "things" }, plan.obstacles.map(obstacle)),
    s("g", { class: "cones" }, plan.cones.map(({ position: [x, y], radius }) => s("circle", { cx: x, cy: y, r: radius * scale }))),
    s("g", { class: "gaps" }, plan.gaps.map(gap)),
    s(
      "g",
      { class: "walls", "stroke-width": plan.wall_thickness },
      plan.walls.map((wall) => s("polyline", { points: points(wall) })),
    ),
    s("g", { class: "movers" }, movers.map(({ way }) => way)),
    lines,
    s("g", { class: "movers" }, movers.map(({ body }) => body)),
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
  const leader = movers[plan.movers.findIndex(({ name }) => name === asked?.task.leader)]?.body;
  /** A second trajectory and its chair, told apart by their colour. */
  const another = () => {
    const line = s("polyline", { class: "driven second" });
    const other = s("path", { class: "chair second", d: CHAIR, visibility: "hidden" });
    driven.after(line);
    chair.after(other);
    return {
      setDriven: (way) => set(line, { points: points(way) }),
      setPose: ([x, y, theta]) =>
        set(other, { visibility: "visible", transform: `${placed([x, y], theta)} scale(${scale})` }),
    };
  };
  return {
    element,
    box,
    another,
    setDriven: (line) => set(driven, { points: points(line) }),
    setLeader: ([x, y, theta]) => leader && set(leader, { transform: placed([x, y], theta) }),
    /** Where all movers are, in the plan's order. @param {[number, number, number][]} places */
    setMovers: (places) =>
      places.forEach(([x, y, theta], i) => set(movers[i].body, { transform: placed([x, y], theta) })),
    /** Where to get now: the stages of a course each have their own. */
    setGoal: ([x, y]) => goal && set(goal, { cx: x, cy: y }),
    setPose: ([x, y, theta]) =>
      set(chair, {
        visibility: "visible",
        transform: `${placed([x, y], theta)} scale(${scale})`,
      }),
  };
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
