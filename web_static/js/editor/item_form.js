/** The chosen item in numbers and words. */
import { Fragment, h, useRef } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { Field, Selection } from "../widgets/fields.js";
import { number } from "../widgets/format.js";
import { fieldsOf, itemOf, pointsOf, timeFor } from "./document.js";
import { AngleRow, Button, NumberRow, TextRow } from "./form.js";
import { lengthOf } from "./geometry.js";

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("./acts.js").Acts} Acts
 * @typedef {import("./document.js").ObstacleItem} ObstacleItem
 * @typedef {import("./document.js").PathItem} PathItem
 * @typedef {import("types/api").ModelView} ModelView
 * @typedef {{plan: import("./document.js").Plan, chosen: import("./document.js").Ref, acts: Acts}} Chosen
 */

/** @param {Chosen & {models: ModelView[]}} form */
export function ItemForm({ plan, chosen, models, acts }) {
  const item = itemOf(plan, chosen);
  const isLine = Array.isArray(item) || Boolean(item.points);
  return h(
    Fragment,
    {},
    h(FieldRows, { plan, chosen, models, acts }),
    isLine ? h(PointRows, { plan, chosen, acts }) : h(PlaceRow, { plan, chosen, acts }),
    h(
      "div",
      { class: "spread" },
      h(Button, {
        words: t(chosen.point === undefined ? "editor-move-to" : "editor-point-move-to"),
        onClick: acts.place,
      }),
      h(Button, { words: t("editor-erase"), onClick: acts.erase }),
    ),
  );
}

/** @param {Chosen & {models: ModelView[]}} rows */
function FieldRows({ plan, chosen, models, acts }) {
  const { list, index } = chosen;
  const { radius, height, width, label } = fieldsOf(plan, chosen);
  const usual = REFERENCE.numbers;
  switch (list) {
    case "paths":
      return h(PathRows, { path: plan.paths[index], acts });
    case "obstacles":
      return plan.obstacles && h(ObstacleRows, { one: plan.obstacles[index], models, acts });
    case "cones":
      return h(
        Fragment,
        {},
        h(SizeRow, { name: "radius", label: t("editor-radius"), value: radius ?? usual.cone_radius, acts }),
        h(SizeRow, { name: "height", label: t("editor-height"), value: height ?? usual.cone_height, acts }),
      );
    case "doors":
      return h(NumberRow, {
        label: t("editor-width"),
        value: width ?? usual.door_width,
        unit: "m",
        onChange: acts.door,
      });
    case "rooms":
      return h(LabelRow, { label, acts });
    default:
      return null;
  }
}

/** @param {{path: PathItem, acts: Acts}} rows */
function PathRows({ path, acts }) {
  const { points, task } = path;
  const usualTime = timeFor(points);
  const usual = REFERENCE.numbers;
  return h(
    Fragment,
    {},
    h("p", { class: "number" }, t("editor-length", { value: number(lengthOf(points), 2) })),
    h(TextRow, {
      label: t("editor-path-title"),
      value: path.title,
      maxlength: 80,
      onChange: (title) => acts.change({ title }),
    }),
    h(TextRow, {
      label: t("editor-path-name"),
      value: path.name,
      maxlength: 64,
      onChange: (name) => acts.change({ name }),
    }),
    h(TextRow, {
      label: t("editor-instruction"),
      value: path.instruction,
      maxlength: 200,
      onChange: (instruction) => acts.change({ instruction }),
    }),
    h(SizeRow, {
      name: "goal_radius",
      label: t("editor-goal-radius"),
      value: path.goal_radius ?? usual.goal_radius,
      acts,
    }),
    h(NumberRow, {
      label: t("editor-time-limit", { value: usualTime }),
      value: path.time_limit ?? usual.time_limit,
      unit: "s",
      onChange: (value) => acts.change({ time_limit: value ?? usualTime }),
    }),
    h(AngleRow, {
      label: t("editor-start-heading"),
      value: path.start_heading ?? null,
      placeholder: t("editor-start-heading-along"),
      onChange: (angle) => acts.change({ start_heading: angle ?? undefined }),
    }),
    task && task.kind !== "path" && h("p", { class: "quiet small" }, t(`editor-task-${task.kind}`)),
  );
}

/** @param {{one: ObstacleItem, models: ModelView[], acts: Acts}} rows */
function ObstacleRows({ one, models, acts }) {
  const label = h(LabelRow, { label: one.label, acts });
  const tall = one.height ?? REFERENCE.numbers.obstacle_height;
  const height = h(SizeRow, { name: "height", label: t("editor-height"), value: tall, acts });
  if (one.kind === "cylinder") {
    const radius = h(SizeRow, { name: "radius", label: t("editor-radius"), value: one.radius, acts });
    return h(Fragment, {}, label, radius, height);
  }
  const { size } = one;
  const sides = [0, 1].map((axis) =>
    h(NumberRow, {
      key: axis,
      label: t(`editor-size-${axis}`),
      value: size[axis],
      unit: "m",
      onChange: (value) => acts.change({ size: size.map((side, i) => (i === axis && value ? value : side)) }),
    }),
  );
  const angle = h(AngleRow, {
    label: t("editor-angle"),
    value: one.angle ?? 0,
    onChange: (value) => acts.change({ angle: value ?? 0 }),
  });
  return h(
    Fragment,
    {},
    label,
    h("div", { class: "pair" }, sides),
    h("div", { class: "pair" }, height, angle),
    h(ModelRow, { one, models, acts }),
  );
}

/**
 * The 3D model that is drawn in place of a box.
 * @param {{one: import("./document.js").BoxItem, models: ModelView[], acts: Acts}} row
 */
function ModelRow({ one, models, acts }) {
  const input = useRef(/** @type {HTMLInputElement | null} */ (null));
  const own = models.find(({ name }) => name === one.model);
  const missing = one.model && !own ? [{ value: one.model, label: one.model }] : [];
  const options = models.map(({ name, size }) => ({
    value: name,
    label: t("editor-model-option", { name, size: size.map((side) => number(side, 2)).join(" × ") }),
  }));
  /** @param {{currentTarget: HTMLInputElement}} event */
  const add = ({ currentTarget }) => {
    const file = currentTarget.files?.[0];
    currentTarget.value = ""; // so that the same file can be chosen again
    if (file) acts.model(file);
  };
  return h(
    Fragment,
    {},
    h(
      Field,
      { label: t("editor-model"), hint: t("editor-model-hint") },
      h(Selection, {
        options: [{ value: "", label: t("editor-model-none") }, ...options, ...missing],
        chosen: one.model ?? "",
        onChange: (model) => acts.change({ model: model || undefined }),
      }),
    ),
    h(
      "div",
      { class: "spread" },
      h(Button, { words: t("editor-model-add"), onClick: () => input.current?.click() }),
      h("input", {
        type: "file",
        accept: ".glb,model/gltf-binary",
        class: "unseen",
        tabindex: -1,
        "aria-hidden": "true",
        ref: input,
        onChange: add,
      }),
      own &&
        h(Button, {
          words: t("editor-model-size"),
          onClick: () => acts.change({ size: own.size.slice(0, 2), height: own.size[2] }),
        }),
    ),
  );
}

/** One point of a line at a time: a line may have thousands. @param {Chosen} rows */
function PointRows({ plan, chosen, acts }) {
  const points = pointsOf(plan, chosen);
  const i = chosen.point;
  /** @param {number} to */
  const go = (to) => acts.choose({ ...chosen, point: (to + points.length) % points.length });
  return h(
    Fragment,
    {},
    h(
      "div",
      { class: "spread" },
      h(Button, { words: "‹", label: t("editor-point-before"), onClick: () => go((i ?? 0) - 1) }),
      h(
        "span",
        { class: "grow" },
        i === undefined
          ? t("editor-points", { count: points.length })
          : t("editor-point", { number: i + 1, all: points.length }),
      ),
      h(Button, { words: "›", label: t("editor-point-after"), onClick: () => go((i ?? -1) + 1) }),
    ),
    i !== undefined &&
      h(Coordinates, {
        key: i,
        place: points[i],
        onChange: (place) => acts.points(points.map((point, at) => (at === i ? place : point))),
      }),
    i !== undefined &&
      h(
        "div",
        { class: "spread" },
        h(Button, { words: t("editor-point-insert"), onClick: acts.insert }),
        points.length > 2 && h(Button, { words: t("editor-point-drop"), onClick: acts.drop }),
      ),
  );
}

/** @param {Chosen} row */
function PlaceRow({ plan, chosen, acts }) {
  return h(Coordinates, { place: pointsOf(plan, chosen)[0], onChange: (place) => acts.points([place]) });
}

/** @param {{place: Point, onChange: (place: Point) => void}} row */
function Coordinates({ place: [x, y], onChange }) {
  return h(
    "div",
    { class: "pair" },
    h(NumberRow, { label: t("editor-x"), value: x, unit: "m", onChange: (value) => onChange([value ?? x, y]) }),
    h(NumberRow, { label: t("editor-y"), value: y, unit: "m", onChange: (value) => onChange([x, value ?? y]) }),
  );
}

/** @param {{label: string | undefined, acts: Acts}} row */
function LabelRow({ label, acts }) {
  return h(TextRow, {
    label: t("editor-label"),
    value: label,
    maxlength: 80,
    onChange: (words) => acts.change({ label: words }),
  });
}

/** @param {{name: string, label: string, value: number, acts: Acts}} row value: m */
function SizeRow({ name, label, value, acts }) {
  return h(NumberRow, { label, value, unit: "m", onChange: (next) => next && acts.change({ [name]: next }) });
}
