/** The form at the side: the chosen thing in numbers and words, or the plan itself. */
import { h } from "../widgets/dom.js";
import { field, selection } from "../widgets/fields.js";
import { number } from "../widgets/format.js";
import { t } from "../texts.js";
import { LISTS, pointsOf, thing, timeFor } from "./document.js";
import { lengthOf } from "./geometry.js";

const DEGREES = 180 / Math.PI;

/**
 * @typedef {{
 *   change: (fields: Record<string, any>) => void, points: (points: any[]) => void, plan: (fields: Record<string, any>) => void,
 *   choose: (ref: any) => void, erase: () => void, place: () => void, door: (width: number) => void,
 *   insert: () => void, drop: () => void, model: (file: File) => void,
 * }} Acts
 */

/** What the panel shows. @param {{plan: any, chosen: any, models: any[]}} state @param {Acts} acts */
export function form({ plan, chosen, models }, acts) {
  const found = chosen && thing(plan, chosen);
  return [
    thingList(plan, found ? chosen : null, acts),
    found ? thingForm(plan, chosen, models, acts) : planForm(plan, acts),
  ];
}

/** Everything of the plan by name: who cannot tap the picture chooses here. */
function thingList(plan, chosen, acts) {
  const refs = LISTS.flatMap((list) => (plan[list] ?? []).slice(0, 300).map((_, index) => ({ list, index })));
  const options = refs.map((ref) => ({ value: `${ref.list} ${ref.index}`, label: nameOf(plan, ref) }));
  const select = selection(
    [{ value: "", label: t("editor.plan") }, ...options],
    chosen ? `${chosen.list} ${chosen.index}` : "",
    (value) => acts.choose(value ? refs[options.findIndex((one) => one.value === value)] : null),
  );
  select.dataset.key = "list";
  return field(t("editor.chosen"), select);
}

/** @param {any} plan @param {any} ref */
export function nameOf(plan, ref) {
  const found = thing(plan, ref);
  const own = found.title ?? found.label ?? found.name;
  return t(`editor.one.${ref.list}`, { number: ref.index + 1, name: own ?? "" });
}

function planForm(plan, acts) {
  return [
    textRow("title", t("editor.title"), plan.title, 80, (title) => acts.plan({ title })),
    numberRow("wall_height", t("editor.wall-height"), plan.wall_height ?? 2.6, "m", (wall_height) =>
      acts.plan({ wall_height }),
    ),
    numberRow("wall_thickness", t("editor.wall-thickness"), plan.wall_thickness ?? 0.1, "m", (wall_thickness) =>
      acts.plan({ wall_thickness }),
    ),
    h("p", { class: "quiet small" }, t("editor.plan.hint")),
  ];
}

function thingForm(plan, chosen, models, acts) {
  const found = thing(plan, chosen);
  const isLine = Array.isArray(found) || Boolean(found.points);
  const rows = {
    paths: () => pathRows(found, acts),
    obstacles: () => obstacleRows(found, models, acts),
    cones: () => [
      size("radius", t("editor.radius"), found.radius ?? 0.15, acts),
      size("height", t("editor.height"), found.height ?? 0.5, acts),
    ],
    doors: () => [numberRow("width", t("editor.width"), found.width ?? 1, "m", acts.door)],
    rooms: () => [textRow("label", t("editor.label"), found.label, 80, (label) => acts.change({ label }))],
  }[chosen.list];
  return [
    rows?.(),
    isLine ? pointRows(plan, chosen, acts) : placeRows(plan, chosen, acts),
    h(
      "div",
      { class: "spread" },
      button("place", t(chosen.point === undefined ? "editor.move-to" : "editor.point.move-to"), acts.place),
      button("erase", t("editor.erase"), acts.erase),
    ),
  ];
}

function pathRows(path, acts) {
  const length = lengthOf(path.points);
  const degrees = path.start_heading === undefined || path.start_heading === null ? "" : path.start_heading * DEGREES;
  const heading = numberRow("start_heading", t("editor.start-heading"), degrees, "°", (value) =>
    acts.change({ start_heading: value === null ? undefined : Number((value / DEGREES).toFixed(4)) }),
  );
  heading.querySelector("input").placeholder = t("editor.start-heading.along");
  return [
    h("p", { class: "number" }, t("editor.length", { value: number(length, 2) })),
    textRow("title", t("editor.path.title"), path.title, 80, (title) => acts.change({ title })),
    textRow("name", t("editor.path.name"), path.name, 64, (name) => acts.change({ name })),
    textRow("instruction", t("editor.instruction"), path.instruction, 200, (instruction) =>
      acts.change({ instruction }),
    ),
    size("goal_radius", t("editor.goal-radius"), path.goal_radius ?? 0.5, acts),
    numberRow(
      "time_limit",
      t("editor.time-limit", { value: timeFor(path.points) }),
      path.time_limit ?? 180,
      "s",
      (value) => acts.change({ time_limit: value ?? timeFor(path.points) }),
    ),
    heading,
    path.task &&
      path.task.kind !== "path" &&
      h("p", { class: "quiet small" }, t("editor.task", { kind: path.task.kind })),
  ];
}

function obstacleRows(one, models, acts) {
  const label = textRow("label", t("editor.label"), one.label, 80, (words) => acts.change({ label: words }));
  const height = size("height", t("editor.height"), one.height ?? 0.75, acts);
  if (one.kind === "cylinder") return [label, size("radius", t("editor.radius"), one.radius, acts), height];
  const sides = [0, 1].map((axis) =>
    numberRow(`size${axis}`, t(`editor.size.${axis}`), one.size[axis], "m", (value) =>
      acts.change({ size: one.size.map((side, i) => (i === axis && value ? value : side)) }),
    ),
  );
  const angle = numberRow("angle", t("editor.angle"), (one.angle ?? 0) * DEGREES, "°", (value) =>
    acts.change({ angle: Number(((value ?? 0) / DEGREES).toFixed(4)) }),
  );
  return [
    label,
    h("div", { class: "pair" }, sides),
    h("div", { class: "pair" }, height, angle),
    modelRow(one, models, acts),
  ];
}

/** Which 3D object is drawn in a box's place. */
function modelRow(one, models, acts) {
  const options = models.map(({ name, size: [a, b, c] }) => ({
    value: name,
    label: t("editor.model.option", { name, size: [a, b, c].map((side) => number(side, 2)).join(" × ") }),
  }));
  const isThere = !one.model || models.some(({ name }) => name === one.model);
  const select = selection(
    [
      { value: "", label: t("editor.model.none") },
      ...options,
      ...(isThere ? [] : [{ value: one.model, label: one.model }]),
    ],
    one.model ?? "",
    (model) => acts.change({ model: model || undefined }),
  );
  select.dataset.key = "model";
  const own = models.find(({ name }) => name === one.model);
  const file = h("input", {
    type: "file",
    accept: ".glb,model/gltf-binary",
    class: "unseen",
    tabindex: "-1",
    "aria-hidden": "true",
  });
  file.addEventListener("change", () => file.files[0] && acts.model(file.files[0]));
  const asLarge = () => acts.change({ size: own.size.slice(0, 2), height: own.size[2] });
  return [
    field(t("editor.model"), select, t("editor.model.hint")),
    h(
      "div",
      { class: "spread" },
      button("model-add", t("editor.model.add"), () => file.click()),
      file,
      own && button("model-size", t("editor.model.size"), asLarge),
    ),
  ];
}

/** One point of a line at a time: thousands of them would fill no screen. */
function pointRows(plan, chosen, acts) {
  const points = pointsOf(plan, chosen);
  const i = chosen.point;
  const go = (to) => acts.choose({ ...chosen, point: (to + points.length) % points.length });
  const step = h(
    "div",
    { class: "spread" },
    button("point-before", "‹", () => go((i ?? 0) - 1), t("editor.point.before")),
    h(
      "span",
      { class: "grow" },
      i === undefined
        ? t("editor.points", { count: points.length })
        : t("editor.point", { number: i + 1, all: points.length }),
    ),
    button("point-after", "›", () => go((i ?? -1) + 1), t("editor.point.after")),
  );
  if (i === undefined) return step;
  return [
    step,
    coordinates(points[i], (place) => acts.points(points.map((point, at) => (at === i ? place : point)))),
    h(
      "div",
      { class: "spread" },
      button("point-insert", t("editor.point.insert"), acts.insert),
      points.length > 2 && button("point-drop", t("editor.point.drop"), acts.drop),
    ),
  ];
}

function placeRows(plan, chosen, acts) {
  return coordinates(pointsOf(plan, chosen)[0], (place) => acts.points([place]));
}

function coordinates(place, onChange) {
  const rows = ["x", "y"].map((axis, at) =>
    numberRow(axis, t(`editor.${axis}`), place[at], "m", (value) =>
      onChange(place.map((old, i) => (i === at ? (value ?? old) : old))),
    ),
  );
  return h("div", { class: "pair" }, rows);
}

function size(name, label, value, acts) {
  return numberRow(name, label, value, "m", (next) => next && acts.change({ [name]: next }));
}

/** A number in its unit; an empty field is null. */
function numberRow(key, label, value, unit, onChange) {
  const shown = value === "" ? "" : String(Number(Number(value).toFixed(unit === "°" ? 1 : 3)));
  const input = h("input", { type: "number", step: "any", value: shown, "data-key": key, inputmode: "decimal" });
  input.addEventListener("change", () =>
    onChange(input.value === "" || !Number.isFinite(input.valueAsNumber) ? null : input.valueAsNumber),
  );
  return field(`${label} (${unit})`, input);
}

function textRow(key, label, value, maxlength, onChange) {
  const input = h("input", { type: "text", value, maxlength, autocomplete: "off", "data-key": key });
  input.addEventListener("change", () => input.value.trim() && onChange(input.value.trim()));
  return field(label, input);
}

function button(key, words, onclick, label) {
  return h("button", { type: "button", class: "btn small", onclick, "data-key": key, "aria-label": label }, words);
}
