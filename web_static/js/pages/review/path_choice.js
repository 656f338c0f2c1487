/**
 * The paths that a patient has driven: which, in what order, and in what words.
 * @import { FloorPlanView, ListedTrial, TrialView } from "types/api"
 * @typedef {{key: string, floorplan: string, name: string, title: string}} PathChoice
 */

import { REFERENCE } from "../../reference.js";
import { GROUPS, groupOf } from "../../results/source_group.js";

/** Which path a trial was driven on. @param {{floorplan: string, path: string}} trial */
export function keyOf({ floorplan, path }) {
  return `${floorplan}/${path}`;
}

/** The paths of some trials, the last driven last. @param {TrialView[]} trials @returns {PathChoice[]} */
export function pathsOf(trials) {
  /** @type {Map<string, PathChoice>} */
  const found = new Map();
  for (const trial of trials) {
    found.delete(keyOf(trial));
    found.set(keyOf(trial), {
      key: keyOf(trial),
      floorplan: trial.floorplan,
      name: trial.path,
      title: trial.floorplan_title,
    });
  }
  return [...found.values()];
}

/**
 * The path that is shown first: the last driven of those with enough trials for a verdict, else of those in which two
 * sessions can be compared, else of all.
 * @param {PathChoice[]} paths the last driven last @param {ListedTrial[]} trials
 */
export function firstPath(paths, trials) {
  /** @param {PathChoice} path @param {number} needed trials */
  const isCompared = ({ key }, needed) =>
    GROUPS.some((group) => {
      const own = trials.filter((one) => keyOf(one) === key && groupOf(one) === group && one.compared_in !== null);
      return new Set(own.map((one) => one.compared_in)).size > 1 && own.length >= needed;
    });
  return (
    paths.findLast((path) => isCompared(path, REFERENCE.numbers.trials_for_verdict)) ??
    paths.findLast((path) => isCompared(path, 2)) ??
    paths[paths.length - 1]
  );
}

/** Sort by place and level as on the Drive page, then by task; paths that no longer exist come last. @param {PathChoice[]} paths @param {FloorPlanView[]} plans */
export function inOrder(paths, plans) {
  /** @param {PathChoice} path */
  const rank = ({ floorplan, name }) => {
    const at = plans.findIndex((plan) => plan.name === floorplan);
    return at < 0 ? Infinity : at + plans[at].paths.findIndex((one) => one.name === name) / 100;
  };
  return paths.toSorted((a, b) => (rank(a) === rank(b) ? 0 : rank(a) - rank(b)));
}

/** The words of a path: floor plan and task, and the scene under which its levels stand together. @param {PathChoice} path @param {FloorPlanView[]} plans */
export function pathWords({ floorplan, name, title }, plans) {
  const plan = plans.find((one) => one.name === floorplan);
  const task = plan?.paths.find((one) => one.name === name)?.title ?? name;
  return { label: `${title}: ${task}`, group: plan?.scene?.title ?? title };
}
