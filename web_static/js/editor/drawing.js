/** The plan as a picture on a grid. */
import { REFERENCE } from "../reference.js";
import { put, s, set } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { t } from "../texts.js";
import { fieldsOf, itemOf, pointsOf } from "./document.js";
import { distance, lengthOf, STEP } from "./geometry.js";
import { toPixel, toPlace } from "./viewport.js";
import { points } from "../plan/plan_marks.js";

const NEAREST_LINES = 5; // px between the lines of a grid
const THINNEST = 3; // px of a wall
const HANDLE = 7; // px

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("./document.js").ItemFields} ItemFields
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./document.js").Ref} Ref
 * @typedef {import("./viewport.js").View} View
 * @typedef {import("./viewport.js").Size} Size
 */

/**
 * @typedef {object} DrawingContent
 * @property {Plan} plan
 * @property {Point[]} pending the line that is being drawn
 * @property {Ref | null} chosen
 * @property {Point | null} ghost the place of the next tap
 * @property {Point | null} cursor the place that the arrow keys have reached
 * @property {Ref | null} wrong the item that a verdict names
 * @property {Point | null} at the place that a verdict names
 */

/** @param {string} label */
export function drawing(label) {
  const world = s("g", {});
  const words = s("g", { class: "words" });
  const fine = s("path", { class: "grid-fine" });
  const coarse = s("path", { class: "grid-coarse" });
  const element = s(
    "svg",
    { class: "sheet", role: "application", tabindex: "0", "aria-label": label },
    fine,
    coarse,
    world,
    words,
  );
  /** @param {DrawingContent} content @param {View} view @param {Size} size */
  const show = (content, view, size) => {
    const middle = `translate(${size.width / 2} ${size.height / 2})`;
    set(world, { transform: `${middle} scale(${view.scale} ${-view.scale}) translate(${-view.x} ${-view.y})` });
    set(fine, { d: gridLines(view, size, STEP) });
    set(coarse, { d: gridLines(view, size, 1) });
    const px = 1 / view.scale;
    put(world, items(content, px), pendingLine(content, px));
    put(words, labels(content, view, size));
  };
  return { element, show };
}

/**
 * The lines of a grid as an SVG path in px; empty where they would be too dense.
 * @param {View} view @param {Size} size @param {number} step m
 */
function gridLines(view, size, step) {
  if (step * view.scale < NEAREST_LINES) return "";
  const [left, top] = toPlace(view, size, [0, 0]);
  const [right, bottom] = toPlace(view, size, [size.width, size.height]);
  let d = "";
  for (let i = Math.ceil(left / step); i <= right / step; i += 1)
    d += `M${toPixel(view, size, [i * step, 0])[0].toFixed(1)} 0V${size.height}`;
  for (let i = Math.ceil(bottom / step); i <= top / step; i += 1)
    d += `M0 ${toPixel(view, size, [0, i * step])[1].toFixed(1)}H${size.width}`;
  return d;
}

/** All items of the plan, and what is marked. @param {DrawingContent} content @param {number} px m */
function items({ plan, chosen, wrong, at }, px) {
  /** @param {import("./document.js").ListName} list @param {number} index */
  const classes = (list, index) =>
    (chosen?.list === list && chosen.index === index ? " chosen" : "") +
    (wrong?.list === list && wrong.index === index ? " wrong" : "");
  /**
   * @template Item
   * @param {import("./document.js").ListName} list @param {Item[] | undefined} all
   * @param {(item: Item, more: string) => SVGElement} draw more: classes
   */
  const each = (list, all, draw) => (all ?? []).map((item, index) => draw(item, classes(list, index)));
  const area = plan.ground?.area;
  const thickness = Math.max(plan.wall_thickness ?? REFERENCE.numbers.wall_thickness, THINNEST * px);
  return [
    area && s("rect", { class: "area", x: area[0], y: area[1], width: area[2] - area[0], height: area[3] - area[1] }),
    each("obstacles", plan.obstacles, (one, more) => obstacle(one, more)),
    each("gaps", plan.gaps, (one, more) => across(one, `gap${more}`)),
    each("walls", plan.walls, (one, more) =>
      s("polyline", { class: `wall${more}`, points: points(one), "stroke-width": thickness }),
    ),
    each("doors", plan.doors, (one, more) => across(one, `door${more}`)),
    each("cones", plan.cones, (one, more) => round(one, `cone${more}`)),
    each("rooms", plan.rooms, (one, more) =>
      s("circle", { class: `room${more}`, cx: one.position[0], cy: one.position[1], r: 4 * px }),
    ),
    each("movers", plan.movers, (one, more) => s("polyline", { class: `mover${more}`, points: points(one.points) })),
    each("paths", plan.paths, (one, more) => path(one, more, px)),
    chosen && itemOf(plan, chosen) && handles(plan, chosen, px),
    at && s("circle", { class: "at", cx: at[0], cy: at[1], r: Math.max(REFERENCE.numbers.chair_radius, 12 * px) }),
  ];
}

/** @param {import("./document.js").ObstacleItem} one @param {string} more classes */
function obstacle(one, more) {
  if (one.kind === "cylinder") return round(one, `thing${more}`);
  const [[x, y], [a, b]] = [one.position, one.size];
  const turn = one.angle ? `rotate(${(one.angle * 180) / Math.PI} ${x} ${y})` : null;
  return s("rect", { class: `thing${more}`, x: x - a / 2, y: y - b / 2, width: a, height: b, transform: turn });
}

/** @param {{position: Point, radius?: number}} item @param {string} name class */
function round({ position: [x, y], radius }, name) {
  return s("circle", { class: name, cx: x, cy: y, r: radius ?? REFERENCE.numbers.cone_radius });
}

/**
 * A line as wide as a door or gap, across the way through it.
 * @param {{position: Point, width?: number, heading?: number}} item @param {string} name class
 */
function across({ position: [x, y], width = REFERENCE.numbers.door_width, heading = 0 }, name) {
  const along = heading + Math.PI / 2;
  const [dx, dy] = [(Math.cos(along) * width) / 2, (Math.sin(along) * width) / 2];
  return s("line", { class: name, x1: x - dx, y1: y - dy, x2: x + dx, y2: y + dy });
}

/** @param {import("./document.js").PathItem} one @param {string} more classes @param {number} px m */
function path(one, more, px) {
  const [[x, y], next] = one.points;
  const [goalX, goalY] = one.points[one.points.length - 1];
  const back = one.task?.kind === "back" ? Math.PI : 0;
  const heading = one.start_heading ?? Math.atan2(next[1] - y, next[0] - x) + back;
  const chair = REFERENCE.numbers.chair_radius;
  const tip = chair + 26 * px;
  return s(
    "g",
    { class: `path${more}` },
    s("polyline", { points: points(one.points) }),
    s("circle", { class: "start", cx: x, cy: y, r: chair }),
    s("line", {
      class: "start-heading",
      x1: x,
      y1: y,
      x2: x + Math.cos(heading) * tip,
      y2: y + Math.sin(heading) * tip,
    }),
    s("circle", { class: "goal", cx: goalX, cy: goalY, r: one.goal_radius ?? REFERENCE.numbers.goal_radius }),
  );
}

/** @param {Plan} plan @param {Ref} chosen @param {number} px m */
function handles(plan, chosen, px) {
  const all = pointsOf(plan, chosen);
  if (all.length > 300) return chosen.point === undefined ? null : handle(all[chosen.point], true, px);
  return all.map((point, i) => handle(point, chosen.point === i, px));
}

/** @param {Point} point @param {boolean} isChosen @param {number} px m */
function handle([x, y], isChosen, px) {
  return s("circle", {
    class: isChosen ? "handle chosen" : "handle",
    cx: x,
    cy: y,
    r: (isChosen ? 1.4 : 1) * HANDLE * px,
  });
}

/** The line that is being drawn, and the place of the next tap. @param {DrawingContent} content @param {number} px m */
function pendingLine({ pending, ghost, cursor }, px) {
  const whole = ghost && pending.length ? [...pending, ghost] : pending;
  return [
    whole.length > 1 && s("polyline", { class: "pending", points: points(whole) }),
    pending.map((point) => handle(point, false, px)),
    ghost && s("circle", { class: "ghost", cx: ghost[0], cy: ghost[1], r: 4 * px }),
    cursor &&
      s("path", {
        class: "cursor",
        d: `M${cursor[0] - 16 * px} ${cursor[1]}h${32 * px}M${cursor[0]} ${cursor[1] - 16 * px}v${32 * px}`,
      }),
  ];
}

/**
 * The lengths (m) of the pending line and of the chosen item, and the names of rooms.
 * @param {DrawingContent} content @param {View} view @param {Size} size
 */
function labels({ plan, pending, chosen, ghost }, view, size) {
  /** @param {Point} place @param {string} words @param {string} name class */
  const at = (place, words, name) => {
    const [x, y] = toPixel(view, size, place);
    if (x < -50 || y < -50 || x > size.width + 50 || y > size.height + 50) return null;
    return s("text", { class: name, x, y: y - 8, "text-anchor": "middle" }, words);
  };
  /** @param {Point[]} line */
  const lengths = (line) =>
    line.slice(1).map((b, i) => {
      const a = line[i];
      const long = distance(a, b) * view.scale > 44;
      return (
        long &&
        at([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], t("editor-m", { value: number(distance(a, b), 2) }), "length")
      );
    });
  const drawn = ghost && pending.length ? [...pending, ghost] : pending;
  const isThere = chosen && itemOf(plan, chosen);
  const line = isThere ? pointsOf(plan, chosen) : [];
  const { size: sides, radius, width } = isThere ? fieldsOf(plan, chosen) : {};
  return [
    (plan.rooms ?? []).map(({ label, position }) => at(position, label, "label")),
    lengths(drawn),
    line.length <= 60 && lengths(line),
    sides && at(line[0], `${number(sides[0], 2)} × ${number(sides[1], 2)} m`, "length"),
    radius && at(line[0], t("editor-radius-m", { value: number(radius, 2) }), "length"),
    width && at(line[0], t("editor-m", { value: number(width, 2) }), "length"),
    drawn.length > 2 &&
      at(drawn[drawn.length - 1], t("editor-whole", { value: number(lengthOf(drawn), 2) }), "length whole"),
  ];
}
