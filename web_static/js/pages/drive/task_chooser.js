/**
 * All tasks in groups: a tap shows the places of one group, another one leads to the Drive page with the task.
 * @import { App } from "../../main.js"
 * @import { FloorPlanView } from "types/api"
 * @import { Task } from "./task_words.js"
 */
import { drawFoot, drawPage, Fragment, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Segments } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { PlanPlace } from "./plan_place.js";
import { findTask, pathWords, taskLink } from "./task_words.js";

const GROUPS = /** @type {const} */ (["first", "corridors", "doors", "obstacles", "following", "outdoors", "own"]);

/**
 * @param {App} app @param {HTMLElement} root
 * @param {string[]} named floor plan and path of the task that the Drive page shows @param {AbortSignal} left
 */
export async function showChooser(app, root, [floorplan, path], left) {
  const plans = await app.api.get("/floorplans");
  if (left.aborted) return;
  const current = findTask(plans, floorplan, path);
  drawPage(root, h(Chooser, { app, plans, current, left }));
  const back = h("a", { class: "btn", href: current ? taskLink("task", current) : "#/drive" }, t("back"));
  drawFoot(root, [h("span", { class: "grow" }), back]);
}

/** @param {{app: App, plans: FloorPlanView[], current: Task | undefined, left: AbortSignal}} chooser */
function Chooser({ app, plans, current, left }) {
  const group = useSignal(current?.plan.group ?? "first");
  const places = placesOf(plans.filter((plan) => plan.group === group.value));
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("drive-choose-title")),
    h("p", { class: "lead" }, t("drive-choose-lead")),
    h(
      "div",
      { class: "task-groups", role: "group", "aria-label": t("drive-choose-groups") },
      GROUPS.map((name) =>
        h(
          "button",
          {
            key: name,
            type: "button",
            class: "btn",
            "aria-pressed": name === group.value,
            onClick: () => (group.value = name),
          },
          t(`drive-group-${name}`),
        ),
      ),
    ),
    h("h2", { class: "unseen" }, t(`drive-group-${group.value}`)),
    h(
      "p",
      { class: "quiet small" },
      group.value === "own" && !places.length && [t("drive-own-none"), " "],
      group.value === "own" &&
        app.me?.role !== "reviewer" &&
        h("a", { class: "btn small", href: "#/plans" }, t("drive-own-go")),
    ),
    h(
      "div",
      { class: "plan-cards" },
      places.map((levels) => h(PlaceCard, { key: levels[0].name, app, levels, current, left })),
    ),
  );
}

/** The plans that are levels of one scene together, after the buildings. @param {FloorPlanView[]} plans */
function placesOf(plans) {
  const places = Map.groupBy(plans, ({ name, scene }) => (scene ? `scene ${scene.name}` : name));
  return [...places.values()].sort(([one], [other]) => Number(Boolean(one.scene)) - Number(Boolean(other.scene)));
}

/**
 * @param {{app: App, levels: FloorPlanView[], current: Task | undefined, left: AbortSignal}} card levels: those of one
 *   scene, or one building
 */
function PlaceCard({ app, levels, current, left }) {
  const chosen = useSignal((levels.find(({ name }) => name === current?.plan.name) ?? levels[0]).name);
  const plan = levels.find(({ name }) => name === chosen.value) ?? levels[0];
  const { scene, width, height } = plan;
  const title = scene?.title ?? plan.title;
  const size = { width: number(width, 0), height: number(height, 0) };
  return h(
    "section",
    { class: "card plan-card" },
    h("h3", {}, title, !scene && h("span", { class: "quiet small" }, t("drive-size", size))),
    scene && h("p", { class: "quiet small about" }, scene.about),
    h(PlanPlace, { app, task: { plan, path: plan.paths[0] }, left }),
    h(
      "div",
      { class: "stack" },
      levels.length > 1 &&
        h(Segments, {
          label: t("drive-level", { plan: title }),
          options: levels.map(({ name, level, title: own }) => ({ value: name, label: level?.title ?? own })),
          chosen: chosen.value,
          onChange: (name) => void (chosen.value = name),
        }),
      h(
        "ul",
        { class: "paths" },
        plan.paths.map((path) => h(TaskItem, { key: `${plan.name} ${path.name}`, task: { plan, path }, current })),
      ),
    ),
  );
}

/** @param {{task: Task, current: Task | undefined}} item */
function TaskItem({ task, current }) {
  const { plan, path } = task;
  const isCurrent = plan.name === current?.plan.name && path.name === current.path.name;
  return h(
    "li",
    {},
    h(
      "a",
      { class: "choice", href: taskLink("task", task), "aria-current": isCurrent ? "true" : undefined },
      h("b", { class: "grow" }, path.title),
      h("span", { class: "number" }, pathWords(path)),
    ),
  );
}
