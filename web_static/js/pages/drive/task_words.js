/**
 * A task of a floor plan, and what people read of it.
 * @import { FloorPlanView, PathView } from "types/api"
 * @typedef {{plan: FloorPlanView, path: PathView}} Task
 */
import { t } from "../../texts.js";
import { number } from "../../widgets/format.js";

const WITHOUT_LENGTH = new Set(["turn", "course"]);

/** Find a task by its names; undefined when it is not offered. @param {FloorPlanView[]} plans @param {string} [floorplan] @param {string} [name] of the path @returns {Task | undefined} */
export function findTask(plans, floorplan, name) {
  const plan = plans.find((one) => one.name === floorplan);
  const path = plan?.paths.find((one) => one.name === name);
  return plan && path && { plan, path };
}

/** The address of the Drive page with a task, or of a page below it that leads back there. @param {string} page @param {Task} task */
export function taskLink(page, { plan, path }) {
  return `#/drive/${page}/${plan.name}/${path.name}`;
}

/** What is asked, and how far it is. @param {PathView} path */
export function pathWords({ task, length }) {
  const words = [];
  if (task !== "path") words.push(t(`task-${task}`));
  if (!WITHOUT_LENGTH.has(task)) words.push(t("drive-length", { length: number(length, 0) }));
  return words.join(" · ");
}

/** Where a task is, how difficult, what is asked, and how far. @param {Task} task */
export function taskWords({ plan, path }) {
  return [plan.scene?.title ?? plan.title, plan.level?.title, pathWords(path)].filter(Boolean).join(" · ");
}
