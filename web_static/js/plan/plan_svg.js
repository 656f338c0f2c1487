/** A floor plan from above: ground, walls, furniture, rooms, the prescribed path and what was driven. */
import { put, s, set } from "../widgets/dom.js";
import { chairOutline, door, gap, headingBefore, marks, mover, placed, points } from "./plan_marks.js";

const MARGIN = 0.4; // m around the walls
const NEAR = 1.8; // m around the path: as far as a chair strays
const BORDER = 0.3; // m around an open ground
const LIFE = 18; // m: of a plan that is wider, marks are drawn larger than life
const CHAIR = "M.55 0 L-.35 .34 L-.35 -.34 Z"; // m, pointing ahead

/** @typedef {{walls: [number, number][][], obstacles: any[], rooms: any[], doors: any[], paths: any[], wall_thickness: number, ground: any, cones: any[], gaps: any[], movers: any[]}} FloorPlan */

/**
 * @param {FloorPlan} plan @param {[number, number][]} path
 * @param {{label: string, hasRooms?: boolean, isNear?: boolean, asked?: any, isTrue?: boolean}} options isNear: show only what lies near the path;
 * asked: the prescribed path, for what is asked along it; isTrue: chair and marks true to size, whatever the size of the plan
 */
export function planPicture(plan, path, { label, hasRooms = false, isNear = false, asked = null, isTrue = false }) {
  const { area } = plan.ground;
  const corners = area ? [area.slice(0, 2), area.slice(2)] : [];
  const box = isNear ? bounds(path, NEAR) : bounds([...plan.walls.flat(), ...path, ...corners], area ? BORDER : MARGIN);
  const scale = isTrue ? 1 : Math.max(1, box.width / LIFE);
  const driven = s("polyline", { class: "driven" });
  const chair = isTrue ? chairOutline() : s("path", { class: "chair", d: CHAIR });
  set(chair, { visibility: "hidden" });
  const movers = plan.movers.map((one) => mover(one, scale));
  const ends = s("g", {});
  let { element: marked, goal } = marks(path, asked, scale);
  put(ends, marked);
  const prescribed = prescribedLine(path, asked?.task.kind ?? "path", isTrue);
  const lines = s("g", { class: "lines" }, prescribed, ends, driven, chair);
  // The plan's y goes up, the picture's down.
  const scene = s(
    "g",
    { transform: "scale(1 -1)" },
    area && s("rect", { class: `ground ${plan.ground.kind}`, x: area[0], y: area[1], width: area[2] - area[0], height: area[3] - area[1] }),
    s("g", { class: "things" }, plan.obstacles.map(obstacle)),
    s("g", { class: "cones" }, plan.cones.map(({ position: [x, y], radius }) => s("circle", { cx: x, cy: y, r: radius * scale }))),
    s("g", { class: "gaps" }, plan.gaps.map(gap)),
    isTrue && s("g", { class: "doors" }, plan.doors.map(door)),
    s(
      "g",
      { class: "walls", "stroke-width": plan.wall_thickness },
      plan.walls.map((wall) => s("polyline", { points: points(wall) })),
    ),
    s("g", { class: "movers" }, movers.map(({ way }) => way)),
    lines,
    s("g", { class: "movers" }, movers.map(({ body }) => body)),
  );
  const rooms = (hasRooms ? plan.rooms : []).map(({ label: words, position: [x, y] }) => ({
    at: [x, -y],
    text: s("text", { class: "room", x, y: -y, "text-anchor": "middle" }, words),
  }));
  const all = s("g", {}, scene, rooms.map(({ text }) => text));
  const element = s(
    "svg",
    {
      class: "plan",
      viewBox: `${box.x} ${-box.y - box.height} ${box.width} ${box.height}`,
      role: "img",
      "aria-label": label,
    },
    all,
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
  const stages = asked?.task.stages ?? [];
  let stage = -1;
  /** Mark what is asked in one stage of a course: its way, how it begins, where to get. @param {number} number from 0 */
  const setStage = (number) => {
    if (number === stage || !stages[number]) return;
    stage = number;
    const { points: way, task } = stages[number];
    ({ element: marked, goal } = marks(way, { task, start_heading: headingBefore(stages, number) }, scale));
    put(ends, prescribedLine(way, task.kind, isTrue), marked);
    prescribed.classList.add("later");
  };
  /** Look at a point so near that `metres` are seen across the shorter side. @param {{x: number, y: number, turn: number, metres: number, middle: number}} camera
   * turn: degrees clockwise; middle: at which share of the height the point is seen */
  const look = ({ x, y, turn, metres, middle }) => {
    set(element, { viewBox: `${-metres / 2} ${-metres * middle} ${metres} ${metres}` });
    element.style.setProperty("--unit", String(metres / 100));
    set(all, { transform: `rotate(${turn}) translate(${-x} ${y})` });
    for (const { at, text } of rooms) set(text, { transform: `rotate(${-turn} ${at.join(" ")})` });
  };
  return {
    element,
    box,
    another,
    look,
    setStage,
    setDriven: (line) => set(driven, { points: points(line) }),
    setLeader: ([x, y, theta]) => leader && set(leader, { transform: placed([x, y], theta) }),
    /** Where all movers are, in the plan's order. @param {number[][]} places */
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

/** The prescribed line; one that is driven by has a rim, because it is white as on the floor of the 3D view. */
function prescribedLine(line, kind, hasRim) {
  const at = points(line);
  return s("g", {}, hasRim && s("polyline", { class: `rim ${kind}`, points: at }), s("polyline", { class: `prescribed ${kind}`, points: at }));
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
