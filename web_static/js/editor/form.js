/** The form at the side: the chosen item in numbers and words, or the plan itself. */
import { REFERENCE } from "../reference.js";
import { h, set } from "../widgets/dom.js";
import { field, hiddenFileInput, selection } from "../widgets/fields.js";
import { number } from "../widgets/format.js";
import { t } from "../texts.js";
import { fieldsOf, itemOf, itemsOf, LISTS, pointsOf, timeFor } from "./document.js";
import { lengthOf } from "./geometry.js";

const DEGREES = 180 / Math.PI;

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("./document.js").Fields} Fields
 * @typedef {import("./document.js").ObstacleItem} ObstacleItem
 * @typedef {import("./document.js").PathItem} PathItem
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./document.js").Ref} Ref
 * @typedef {import("types/api").ModelView} ModelView
 */

/**
 * @typedef {object} Acts what the form does to the plan
 * @property {(fields: Fields) => void} change fields of the chosen item
 * @property {(points: Point[]) => void} points of the chosen item
 * @property {(fields: Fields) => void} plan null leaves a field as it is
 * @property {(ref: Ref | null) => void} choose
 * @property {() => void} erase the chosen item
 * @property {() => void} place the chosen item by the next tap
 * @property {(width: number | null) => void} door its width in m
 * @property {() => void} insert a point
 * @property {() => void} drop the chosen point
 * @property {(file: File) => void} model upload a 3D model
 */

/** What the panel shows. @param {{plan: Plan, chosen: Ref | null, models: ModelView[]}} state @param {Acts} acts */
export function form({ plan, chosen, models }, acts) {
  const ref = chosen && itemOf(plan, chosen) ? chosen : null;
  return [itemList(plan, ref, acts), ref ? itemForm(plan, ref, models, acts) : planForm(plan, acts)];
}

/**
 * All items of the plan by name, to choose one without tapping the drawing.
 * @param {Plan} plan @param {Ref | null} chosen @param {Acts} acts
 */
function itemList(plan, chosen, acts) {
  const refs = LISTS.flatMap((list) =>
    itemsOf(plan, list)
      .slice(0, 300)
      .map((_, index) => ({ list, index })),
  );
  const options = refs.map((ref) => ({ value: `${ref.list} ${ref.index}`, label: nameOf(plan, ref) }));
  const select = selection(
    [{ value: "", label: t("editor-plan") }, ...options],
    chosen ? `${chosen.list} ${chosen.index}` : "",
    (value) => acts.choose(value ? refs[options.findIndex((one) => one.value === value)] : null),
  );
  select.dataset.key = "list";
  return field(t("editor-chosen"), select);
}

/** @param {Plan} plan @param {Ref} ref */
export function nameOf(plan, ref) {
  const { title, label, name } = fieldsOf(plan, ref);
  return t(`editor-one-${ref.list}`, { number: ref.index + 1, name: title ?? label ?? name ?? "" });
}

/** @param {Plan} plan @param {Acts} acts */
function planForm(plan, acts) {
  return [
    textRow("title", t("editor-title"), plan.title, 80, (title) => acts.plan({ title })),
    numberRow("wall_height", t("editor-wall-height"), plan.wall_height ?? 2.6, "m", (wall_height) =>
      acts.plan({ wall_height }),
    ),
    numberRow("wall_thickness", t("editor-wall-thickness"), plan.wall_thickness ?? 0.1, "m", (wall_thickness) =>
      acts.plan({ wall_thickness }),
    ),
    h("p", { class: "quiet small" }, t("editor-plan-hint", { radius: number(REFERENCE.numbers.chair_radius, 2) })),
  ];
}

/** @param {Plan} plan @param {Ref} chosen @param {ModelView[]} models @param {Acts} acts */
function itemForm(plan, chosen, models, acts) {
  const item = itemOf(plan, chosen);
  const isLine = Array.isArray(item) || Boolean(item.points);
  return [
    fieldRows(plan, chosen, models, acts),
    isLine ? pointRows(plan, chosen, acts) : placeRows(plan, chosen, acts),
    h(
      "div",
      { class: "spread" },
      button("place", t(chosen.point === undefined ? "editor-move-to" : "editor-point-move-to"), acts.place),
      button("erase", t("editor-erase"), acts.erase),
    ),
  ];
}

/** @param {Plan} plan @param {Ref} chosen @param {ModelView[]} models @param {Acts} acts */
function fieldRows(plan, chosen, models, acts) {
  const { list, index } = chosen;
  const { radius, height, width, label } = fieldsOf(plan, chosen);
  switch (list) {
    case "paths":
      return pathRows(plan.paths[index], acts);
    case "obstacles":
      return plan.obstacles && obstacleRows(plan.obstacles[index], models, acts);
    case "cones":
      return [
        size("radius", t("editor-radius"), radius ?? 0.15, acts),
        size("height", t("editor-height"), height ?? 0.5, acts),
      ];
    case "doors":
      return [numberRow("width", t("editor-width"), width ?? 1, "m", acts.door)];
    case "rooms":
      return [textRow("label", t("editor-label"), label, 80, (words) => acts.change({ label: words }))];
    default:
      return null;
  }
}

/** @param {PathItem} path @param {Acts} acts */
function pathRows(path, acts) {
  const length = lengthOf(path.points);
  const degrees = path.start_heading === undefined || path.start_heading === null ? "" : path.start_heading * DEGREES;
  const heading = numberRow("start_heading", t("editor-start-heading"), degrees, "°", (value) =>
    acts.change({ start_heading: value === null ? undefined : Number((value / DEGREES).toFixed(4)) }),
  );
  set(/** @type {HTMLInputElement} */ (heading.querySelector("input")), {
    placeholder: t("editor-start-heading-along"),
  });
  return [
    h("p", { class: "number" }, t("editor-length", { value: number(length, 2) })),
    textRow("title", t("editor-path-title"), path.title, 80, (title) => acts.change({ title })),
    textRow("name", t("editor-path-name"), path.name, 64, (name) => acts.change({ name })),
    textRow("instruction", t("editor-instruction"), path.instruction, 200, (instruction) =>
      acts.change({ instruction }),
    ),
    size("goal_radius", t("editor-goal-radius"), path.goal_radius ?? 0.5, acts),
    numberRow(
      "time_limit",
      t("editor-time-limit", { value: timeFor(path.points) }),
      path.time_limit ?? 180,
      "s",
      (value) => acts.change({ time_limit: value ?? timeFor(path.points) }),
    ),
    heading,
    path.task && path.task.kind !== "path" && h("p", { class: "quiet small" }, t(`editor-task-${path.task.kind}`)),
  ];
}

/** @param {ObstacleItem} one @param {ModelView[]} models @param {Acts} acts */
function obstacleRows(one, models, acts) {
  const label = textRow("label", t("editor-label"), one.label, 80, (words) => acts.change({ label: words }));
  const height = size("height", t("editor-height"), one.height ?? 0.75, acts);
  if (one.kind === "cylinder") return [label, size("radius", t("editor-radius"), one.radius, acts), height];
  const sides = [0, 1].map((axis) =>
    numberRow(`size${axis}`, t(`editor-size-${axis}`), one.size[axis], "m", (value) =>
      acts.change({ size: one.size.map((side, i) => (i === axis && value ? value : side)) }),
    ),
  );
  const angle = numberRow("angle", t("editor-angle"), (one.angle ?? 0) * DEGREES, "°", (value) =>
    acts.change({ angle: Number(((value ?? 0) / DEGREES).toFixed(4)) }),
  );
  return [
    label,
    h("div", { class: "pair" }, sides),
    h("div", { class: "pair" }, height, angle),
    modelRow(one, models, acts),
  ];
}

/**
 * The 3D model that is drawn in place of a box.
 * @param {import("./document.js").BoxItem} one @param {ModelView[]} models @param {Acts} acts
 */
function modelRow(one, models, acts) {
  const options = models.map(({ name, size: [a, b, c] }) => ({
    value: name,
    label: t("editor-model-option", { name, size: [a, b, c].map((side) => number(side, 2)).join(" × ") }),
  }));
  const missing = one.model && !models.some(({ name }) => name === one.model) ? one.model : null;
  const select = selection(
    [
      { value: "", label: t("editor-model-none") },
      ...options,
      ...(missing ? [{ value: missing, label: missing }] : []),
    ],
    one.model ?? "",
    (model) => acts.change({ model: model || undefined }),
  );
  select.dataset.key = "model";
  const own = models.find(({ name }) => name === one.model);
  const file = hiddenFileInput(".glb,model/gltf-binary", (model) => acts.model(model));
  const takeSize = () => own && acts.change({ size: own.size.slice(0, 2), height: own.size[2] });
  return [
    field(t("editor-model"), select, t("editor-model-hint")),
    h(
      "div",
      { class: "spread" },
      button("model-add", t("editor-model-add"), () => file.click()),
      file,
      own && button("model-size", t("editor-model-size"), takeSize),
    ),
  ];
}

/** One point of a line at a time: a line may have thousands. @param {Plan} plan @param {Ref} chosen @param {Acts} acts */
function pointRows(plan, chosen, acts) {
  const points = pointsOf(plan, chosen);
  const i = chosen.point;
  /** @param {number} to */
  const go = (to) => acts.choose({ ...chosen, point: (to + points.length) % points.length });
  const step = h(
    "div",
    { class: "spread" },
    button("point-before", "‹", () => go((i ?? 0) - 1), t("editor-point-before")),
    h(
      "span",
      { class: "grow" },
      i === undefined
        ? t("editor-points", { count: points.length })
        : t("editor-point", { number: i + 1, all: points.length }),
    ),
    button("point-after", "›", () => go((i ?? -1) + 1), t("editor-point-after")),
  );
  if (i === undefined) return step;
  return [
    step,
    coordinates(points[i], (place) => acts.points(points.map((point, at) => (at === i ? place : point)))),
    h(
      "div",
      { class: "spread" },
      button("point-insert", t("editor-point-insert"), acts.insert),
      points.length > 2 && button("point-drop", t("editor-point-drop"), acts.drop),
    ),
  ];
}

/** @param {Plan} plan @param {Ref} chosen @param {Acts} acts */
function placeRows(plan, chosen, acts) {
  return coordinates(pointsOf(plan, chosen)[0], (place) => acts.points([place]));
}

/** @param {Point} place @param {(place: Point) => void} onChange */
function coordinates([x, y], onChange) {
  return h(
    "div",
    { class: "pair" },
    numberRow("x", t("editor-x"), x, "m", (value) => onChange([value ?? x, y])),
    numberRow("y", t("editor-y"), y, "m", (value) => onChange([x, value ?? y])),
  );
}

/** @param {string} name @param {string} label @param {number} value m @param {Acts} acts */
function size(name, label, value, acts) {
  return numberRow(name, label, value, "m", (next) => next && acts.change({ [name]: next }));
}

/**
 * A number in its unit; an empty field is null.
 * @param {string} key @param {string} label @param {number | ""} value @param {string} unit
 * @param {(value: number | null) => void} onChange
 */
function numberRow(key, label, value, unit, onChange) {
  const shown = value === "" ? "" : String(Number(Number(value).toFixed(unit === "°" ? 1 : 3)));
  const input = h("input", { type: "number", step: "any", value: shown, "data-key": key, inputmode: "decimal" });
  input.addEventListener("change", () =>
    onChange(input.value === "" || !Number.isFinite(input.valueAsNumber) ? null : input.valueAsNumber),
  );
  return field(`${label} (${unit})`, input);
}

/**
 * @param {string} key @param {string} label @param {string | undefined} value @param {number} maxlength
 * @param {(value: string) => void} onChange
 */
function textRow(key, label, value, maxlength, onChange) {
  const input = h("input", { type: "text", value, maxlength, autocomplete: "off", "data-key": key });
  input.addEventListener("change", () => input.value.trim() && onChange(input.value.trim()));
  return field(label, input);
}

/** @param {string} key @param {string} words @param {() => void} onclick @param {string} [label] for screen readers */
function button(key, words, onclick, label) {
  return h("button", { type: "button", class: "btn small", onclick, "data-key": key, "aria-label": label }, words);
}
