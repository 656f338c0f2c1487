/** The plan as a picture on a grid. */
import { h, put, s, set } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { t } from "../texts.js";
import { pointsOf, thing } from "./document.js";
import { distance, lengthOf, STEP } from "./geometry.js";
import { toPixel, toPlace } from "./viewport.js";

const NEAREST_LINES = 5; // px between the lines of a grid
const THINNEST = 3; // px of a wall
const HANDLE = 7; // px

/** @typedef {{plan: any, pending: any[], chosen: any, ghost: any, cursor: any, wrong: any, at: any}} Shown */

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
  /** @param {Shown} shown @param {import("./viewport.js").View} view @param {{width: number, height: number}} size */
  const show = (shown, view, size) => {
    const matrix = `translate(${size.width / 2} ${size.height / 2}) scale(${view.scale} ${-view.scale}) translate(${-view.x} ${-view.y})`;
    set(world, { transform: matrix });
    set(fine, { d: gridLines(view, size, STEP) });
    set(coarse, { d: gridLines(view, size, 1) });
    const px = 1 / view.scale;
    put(world, things(shown, px), line(shown, px));
    put(words, labels(shown, view, size));
  };
  return { element, show };
}

/** The grid's lines, in px; none where they would lie too near to each other. */
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

function points(line) {
  return line.map(([x, y]) => `${x},${y}`).join(" ");
}

/** Everything of the plan. @param {Shown} shown @param {number} px m */
function things({ plan, chosen, wrong, at }, px) {
  const mark = (list, index) =>
    (chosen?.list === list && chosen.index === index ? " chosen" : "") +
    (wrong?.list === list && wrong.index === index ? " wrong" : "");
  const all = (list, draw) => (plan[list] ?? []).map((one, index) => draw(one, mark(list, index)));
  const area = plan.ground?.area;
  const thickness = Math.max(plan.wall_thickness ?? 0.1, THINNEST * px);
  return [
    area && s("rect", { class: "area", x: area[0], y: area[1], width: area[2] - area[0], height: area[3] - area[1] }),
    all("obstacles", (one, more) => obstacle(one, more)),
    all("gaps", (one, more) => across(one, `gap${more}`, px)),
    all("walls", (one, more) =>
      s("polyline", { class: `wall${more}`, points: points(one), "stroke-width": thickness }),
    ),
    all("doors", (one, more) => across(one, `door${more}`, px)),
    all("cones", (one, more) => round(one, `cone${more}`)),
    all("rooms", (one, more) =>
      s("circle", { class: `room${more}`, cx: one.position[0], cy: one.position[1], r: 4 * px }),
    ),
    all("movers", (one, more) => s("polyline", { class: `mover${more}`, points: points(one.points) })),
    all("paths", (one, more) => path(one, more, px)),
    chosen && thing(plan, chosen) && handles(plan, chosen, px),
    at && s("circle", { class: "at", cx: at[0], cy: at[1], r: Math.max(0.32, 12 * px) }),
  ];
}

function obstacle(one, more) {
  if (one.kind === "cylinder") return round(one, `thing${more}`);
  const [[x, y], [a, b]] = [one.position, one.size];
  const turn = one.angle ? `rotate(${(one.angle * 180) / Math.PI} ${x} ${y})` : null;
  return s("rect", { class: `thing${more}`, x: x - a / 2, y: y - b / 2, width: a, height: b, transform: turn });
}

function round(one, name) {
  return s("circle", { class: name, cx: one.position[0], cy: one.position[1], r: one.radius ?? 0.15 });
}

/** A line of its width, across the way through it. */
function across({ position: [x, y], width, heading = 0 }, name) {
  const along = heading + Math.PI / 2;
  const [dx, dy] = [(Math.cos(along) * width) / 2, (Math.sin(along) * width) / 2];
  return s("line", { class: name, x1: x - dx, y1: y - dy, x2: x + dx, y2: y + dy });
}

function path(one, more, px) {
  const [[x, y], next] = one.points;
  const [goalX, goalY] = one.points.at(-1);
  const back = one.task?.kind === "back" ? Math.PI : 0;
  const heading = one.start_heading ?? Math.atan2(next[1] - y, next[0] - x) + back;
  const tip = 26 * px;
  return s(
    "g",
    { class: `path${more}` },
    s("polyline", { points: points(one.points) }),
    s("circle", { class: "start", cx: x, cy: y, r: 0.32 }),
    s("line", {
      class: "start-heading",
      x1: x,
      y1: y,
      x2: x + Math.cos(heading) * (0.32 + tip),
      y2: y + Math.sin(heading) * (0.32 + tip),
    }),
    s("circle", { class: "goal", cx: goalX, cy: goalY, r: one.goal_radius ?? 0.5 }),
  );
}

function handles(plan, chosen, px) {
  const all = pointsOf(plan, chosen);
  if (all.length > 300) return chosen.point === undefined ? null : handle(all[chosen.point], true, px);
  return all.map((point, i) => handle(point, chosen.point === i, px));
}

function handle([x, y], isChosen, px) {
  return s("circle", {
    class: isChosen ? "handle chosen" : "handle",
    cx: x,
    cy: y,
    r: (isChosen ? 1.4 : 1) * HANDLE * px,
  });
}

/** What is being drawn, and where the next tap would go. */
function line({ pending, ghost, cursor }, px) {
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

/** Lengths in m, beside what is drawn or chosen, and the names of rooms. */
function labels({ plan, pending, chosen, ghost }, view, size) {
  const at = (place, words, name) => {
    const [x, y] = toPixel(view, size, place);
    if (x < -50 || y < -50 || x > size.width + 50 || y > size.height + 50) return null;
    return s("text", { class: name, x, y: y - 8, "text-anchor": "middle" }, words);
  };
  const measured = (points) =>
    points.slice(1).map((b, i) => {
      const a = points[i];
      const long = distance(a, b) * view.scale > 44;
      return (
        long &&
        at([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], t("editor.m", { value: number(distance(a, b), 2) }), "length")
      );
    });
  const drawn = ghost && pending.length ? [...pending, ghost] : pending;
  const found = chosen && thing(plan, chosen);
  const line = found ? pointsOf(plan, chosen) : [];
  return [
    (plan.rooms ?? []).map(({ label, position }) => at(position, label, "label")),
    measured(drawn),
    line.length <= 60 && measured(line),
    found?.size && at(found.position, `${number(found.size[0], 2)} × ${number(found.size[1], 2)} m`, "length"),
    found?.radius && at(found.position, t("editor.radius.m", { value: number(found.radius, 2) }), "length"),
    found?.width && at(found.position, t("editor.m", { value: number(found.width, 2) }), "length"),
    drawn.length > 2 && at(drawn.at(-1), t("editor.whole", { value: number(lengthOf(drawn), 2) }), "length whole"),
  ];
}

/** The same figures in words, for who does not see the picture. @param {any[]} pending */
export function drawnWords(pending) {
  return h("span", {}, t("editor.drawn", { count: pending.length, length: number(lengthOf(pending), 2) }));
}
