/** A floor plan from above: ground, walls, furniture, rooms, the prescribed path and what was driven. */
import { put, s, set } from "../widgets/dom.js";
import { chairOutline, door, gap, headingBefore, marks, mover, placement, points } from "./plan_marks.js";

/**
 * @typedef {import("./floor_plan.js").Point} Point
 * @typedef {readonly (number | null)[]} AnyPose x, y in m, heading in rad
 */

const MARGIN = 0.4; // m around the walls
const NEAR = 1.8; // m around the path: as far as a chair strays
const BORDER = 0.3; // m around an open ground
const LIFE = 18; // m: of a plan that is wider, marks are drawn larger than life
const CHAIR = "M.55 0 L-.35 .34 L-.35 -.34 Z"; // m, pointing ahead

/**
 * @typedef {object} PlanOptions
 * @property {string} label for screen readers
 * @property {boolean} [hasRooms] write the names of the rooms
 * @property {boolean} [isNear] show only what lies near the path
 * @property {import("./floor_plan.js").PrescribedPath | null} [request] the prescribed path with its task
 * @property {boolean} [isTrue] draw chair and marks true to size, whatever the size of the plan
 */

/** @param {import("./floor_plan.js").FloorPlan} plan @param {Point[]} path @param {PlanOptions} options */
export function planPicture(plan, path, { label, hasRooms = false, isNear = false, request = null, isTrue = false }) {
  const { area } = plan.ground;
  /** @type {Point[]} */
  const corners = area
    ? [
        [area[0], area[1]],
        [area[2], area[3]],
      ]
    : [];
  const box = isNear ? bounds(path, NEAR) : bounds([...plan.walls.flat(), ...path, ...corners], area ? BORDER : MARGIN);
  const scale = isTrue ? 1 : Math.max(1, box.width / LIFE);
  const trajectoryLine = s("polyline", { class: "driven" });
  const chair = isTrue ? chairOutline() : s("path", { class: "chair", d: CHAIR });
  set(chair, { visibility: "hidden" });
  const movers = plan.movers.map((one) => mover(one, scale));
  const ends = s("g", {});
  let { element: marked, goal } = marks(path, request, scale);
  put(ends, marked);
  const prescribed = prescribedLine(path, request?.task.kind ?? "path", isTrue);
  const lines = s("g", { class: "lines" }, prescribed, ends, trajectoryLine, chair);
  // The plan's y goes up, the picture's down.
  const scene = s(
    "g",
    { transform: "scale(1 -1)" },
    area &&
      s("rect", {
        class: `ground ${plan.ground.kind}`,
        x: area[0],
        y: area[1],
        width: area[2] - area[0],
        height: area[3] - area[1],
      }),
    s("g", { class: "things" }, plan.obstacles.map(obstacle)),
    s(
      "g",
      { class: "cones" },
      plan.cones.map(({ position: [x, y], radius }) => s("circle", { cx: x, cy: y, r: radius * scale })),
    ),
    s("g", { class: "gaps" }, plan.gaps.map(gap)),
    isTrue && s("g", { class: "doors" }, plan.doors.map(door)),
    s(
      "g",
      { class: "walls", "stroke-width": plan.wall_thickness },
      plan.walls.map((wall) => s("polyline", { points: points(wall) })),
    ),
    s(
      "g",
      { class: "movers" },
      movers.map(({ way }) => way),
    ),
    lines,
    s(
      "g",
      { class: "movers" },
      movers.map(({ body }) => body),
    ),
  );
  const rooms = (hasRooms ? plan.rooms : []).map(({ label: words, position: [x, y] }) => ({
    at: [x, -y],
    text: s("text", { class: "room", x, y: -y, "text-anchor": "middle" }, words),
  }));
  const all = s(
    "g",
    {},
    scene,
    rooms.map(({ text }) => text),
  );
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
  const task = request?.task;
  const leader = movers[plan.movers.findIndex(({ name }) => task?.kind === "follow" && name === task.leader)]?.body;
  /** Add a second trajectory and its chair, in another colour. */
  const another = () => {
    const line = s("polyline", { class: "driven second" });
    const other = s("path", { class: "chair second", d: CHAIR, visibility: "hidden" });
    trajectoryLine.after(line);
    chair.after(other);
    return {
      /** @param {readonly (readonly number[])[]} trajectory */
      setTrajectory: (trajectory) => set(line, { points: points(trajectory) }),
      /** @param {AnyPose} pose */
      setPose: ([x, y, theta]) =>
        set(other, { visibility: "visible", transform: `${placement([x, y], theta)} scale(${scale})` }),
    };
  };
  const stages = task?.kind === "course" ? task.stages : [];
  let stage = -1;
  /** Draw the path, start and goal of one stage of a course. @param {number} number from 0 */
  const setStage = (number) => {
    if (number === stage || !stages[number]) return;
    stage = number;
    const { points: line, task: stageTask } = stages[number];
    const startHeading = headingBefore(stages, number);
    ({ element: marked, goal } = marks(line, { task: stageTask, start_heading: startHeading }, scale));
    put(ends, prescribedLine(line, stageTask.kind, isTrue), marked);
    prescribed.classList.add("later");
  };
  /**
   * Show `metres` of the floor across the shorter side of the picture.
   * @param {{x: number, y: number, turn: number, metres: number, middle: number}} camera x, y: the point of the floor (m);
   *   turn: degrees clockwise; middle: share of the picture's height at which the point lies
   */
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
    /** @param {readonly (readonly number[])[]} trajectory */
    setTrajectory: (trajectory) => set(trajectoryLine, { points: points(trajectory) }),
    /** @param {AnyPose} pose */
    setLeader: ([x, y, theta]) => leader && set(leader, { transform: placement([x, y], theta) }),
    /** Move all movers. @param {AnyPose[]} poses in the plan's order */
    setMovers: (poses) =>
      poses.forEach(([x, y, theta], i) => set(movers[i].body, { transform: placement([x, y], theta) })),
    /** Move the goal: each stage of a course has its own. @param {readonly number[]} place */
    setGoal: ([x, y]) => goal && set(goal, { cx: x, cy: y }),
    /** @param {AnyPose} pose */
    setPose: ([x, y, theta]) =>
      set(chair, {
        visibility: "visible",
        transform: `${placement([x, y], theta)} scale(${scale})`,
      }),
  };
}

/**
 * The prescribed line; in the picture to drive by it has a rim, because there it is white as on the floor of the 3D view.
 * @param {Point[]} line @param {string} kind of the task @param {boolean} hasRim
 */
function prescribedLine(line, kind, hasRim) {
  const at = points(line);
  return s(
    "g",
    {},
    hasRim && s("polyline", { class: `rim ${kind}`, points: at }),
    s("polyline", { class: `prescribed ${kind}`, points: at }),
  );
}

/** @param {import("./floor_plan.js").Obstacle} one */
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

/** The upright rectangle around some points. @param {Point[]} line @param {number} margin m */
function bounds(line, margin) {
  const xs = line.map(([x]) => x);
  const ys = line.map(([, y]) => y);
  const [x, y] = [Math.min(...xs) - margin, Math.min(...ys) - margin];
  return { x, y, width: Math.max(...xs) + margin - x, height: Math.max(...ys) + margin - y };
}
