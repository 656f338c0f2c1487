/**
 * The paths that a patient has driven: which, in what order, and in what words.
 * @import { FloorPlanView, TrialView } from "types/api"
 * @typedef {{key: string, floorplan: string, name: string, title: string}} PathChoice
 */

const GETTING_USED = 3; // trials of a day that are not compared

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
 * The path that is shown first: the last driven of those in which two days can be compared, else the last driven.
 * @param {PathChoice[]} paths the last driven last @param {TrialView[]} trials
 */
export function firstPath(paths, trials) {
  /** @param {PathChoice} path */
  const hasTwoDays = ({ key }) => {
    /** @type {Map<string, number>} */
    const days = new Map();
    for (const trial of trials) {
      if (!trial.kept || trial.measures?.reached === false || keyOf(trial) !== key) continue;
      const day = `${trial.source.simulated} ${new Date(trial.started).toDateString()}`;
      days.set(day, (days.get(day) ?? 0) + 1);
    }
    return [...days.values()].filter((count) => count > GETTING_USED).length > 1;
  };
  return paths.findLast(hasTwoDays) ?? paths[paths.length - 1];
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
