/**
 * What the page of Review shows: the trials of a patient on one path, what was learnt on it, and which are compared.
 * @import { App } from "../../main.js"
 * @import { CommentView, FloorPlan, FloorPlanView, ListedTrial, PatientView } from "types/api"
 * @import { QualityView, TrajectoriesView, TrialView } from "types/api"
 * @import { Learning } from "types/documents"
 * @import { ReadonlySignal } from "../../preact.js"
 * @import { SourceGroup } from "../../results/source_group.js"
 * @typedef {{learning: Learning, measure: string, plan: FloorPlan | null}} PathReview what was learnt on a path, by a
 *   measure
 * @typedef {ReturnType<typeof reviewStore>} ReviewStore
 */
import { failureWords } from "../../api.js";
import { newestAnswer } from "../../live/newest_answer.js";
import { computed, signal } from "../../preact.js";
import { entryOf, leadingMeasures, measured, measureNames } from "../../results/measures.js";
import { withChoice } from "../../results/pair_choice.js";
import { firstGroup } from "../../results/source_group.js";
import { firstPath, keyOf, pathsOf } from "./path_choice.js";

const MEASURE_PLACE = "bodydrive-measure";
/** What may change of a trial, beside its measures. */
const FIELDS = /** @type {const} */ (["id", "status", "end", "kept", "discard_reason", "compared_in"]);

/** Whether a trial has not changed. @param {ListedTrial} trial @param {ListedTrial} before */
function isUnchanged(trial, before) {
  return (
    FIELDS.every((name) => trial[name] === before[name]) &&
    measureNames().every((name) => measured(trial.measures, name) === measured(before.measures, name))
  );
}

/**
 * A signal of a patient's trials, which are read again after news of trials; `onChange` is called when the trials have
 * changed.
 * @param {App} app @param {number} patient id @param {ListedTrial[]} first as they were read @param {AbortSignal} left
 * @param {() => unknown} onChange
 */
export function followTrials(app, patient, first, left, onChange) {
  /** @returns {Promise<ListedTrial[] | null>} */
  const ask = async () => {
    const now = await app.api.get(`/trials?patient=${patient}`);
    const before = trials.value;
    return now.length === before.length && now.every((trial, i) => isUnchanged(trial, before[i])) ? null : now;
  };
  const trials = newestAnswer(app, left, first, ask, { what: ["trial"], patient });
  trials.subscribe((now) => void (now !== first && !left.aborted && onChange()));
  return trials;
}

/**
 * @param {App} app
 * @param {{patients: ReadonlySignal<PatientView[]>, patient: PatientView, first: ListedTrial[], plans: FloorPlanView[],
 *   unread: ReadonlySignal<CommentView[]>}} given first: the trials of the patient, at least one
 * @param {string} named key of the path to show, if it was driven @param {AbortSignal} left
 */
export function reviewStore(app, { patients, patient, first, plans, unread }, named, left) {
  const trials = followTrials(app, patient.id, first, left, () => app.toasts.attempt(read));
  const paths = computed(() => pathsOf(trials.value));
  const path = signal(paths.value.find(({ key }) => key === named) ?? firstPath(paths.value, first));
  const trialsOfPath = computed(() => trials.value.filter((trial) => keyOf(trial) === path.value.key));
  const group = signal(firstGroup(first));
  const wish = signal(sessionStorage.getItem(MEASURE_PLACE) ?? "e_diff"); // the measure that somebody has chosen
  const allMeasures = computed(() => trialsOfPath.value.flatMap((trial) => (trial.measures ? [trial.measures] : [])));
  /** The measures that the task has: a turn on the spot has no distance driven. */
  const measures = computed(() => {
    const names = measureNames().filter((name) => allMeasures.value.some((one) => measured(one, name) !== null));
    return names.length ? names : [wish.value];
  });
  const measure = computed(() => {
    const names = measures.value;
    if (names.includes(wish.value)) return wish.value;
    const leading = leadingMeasures(allMeasures.value[allMeasures.value.length - 1]);
    return leading.find((name) => names.includes(name)) ?? names[0];
  });
  /** null: it could not be read. */
  const review = signal(/** @type {PathReview | "reading" | null} */ ("reading"));
  const trajectories = signal(/** @type {TrajectoriesView | null} */ (null));
  const quality = signal(/** @type {QualityView | null} */ (null));
  const pair = signal(/** @type {TrialView[]} */ ([])); // the trials to compare, at most two

  let questions = 0;
  /** Read what is shown of the path; until it has come, what is shown stays. */
  const read = async () => {
    const question = ++questions;
    const isNewest = () => question === questions && !left.aborted;
    const { floorplan, name } = path.value;
    const by = measure.value;
    const where = `floorplan=${encodeURIComponent(floorplan)}&path=${encodeURIComponent(name)}&source=${group.value}`;
    /** @template Answer @param {{value: Answer | null}} place @param {Promise<Answer>} answer */
    const showLater = (place, answer) =>
      answer.then(
        (now) => void (isNewest() && (place.value = now)),
        (error) => isNewest() && app.toasts.show(failureWords(error)),
      );
    try {
      const [answer, plan] = await Promise.all([
        app.api.get(`/patients/${patient.id}/learning?${where}${entryOf(by) ? `&measure=${by}` : ""}`),
        plans.some((one) => one.name === floorplan) ? app.api.get(`/floorplans/${floorplan}`) : null,
      ]);
      if (!isNewest()) return;
      const learning = /** @type {Learning} */ (answer);
      review.value = { learning, measure: by, plan };
      if (!learning.trials.length) return void (trajectories.value = quality.value = null);
      // The server may have to read old recordings for these, so the curve is shown first.
      showLater(trajectories, app.api.get(`/patients/${patient.id}/trajectories?${where}`));
      showLater(quality, app.api.get(`/patients/${patient.id}/quality?${where}`));
    } catch (error) {
      if (!isNewest()) return;
      if (review.value === "reading") review.value = null;
      throw error;
    }
  };
  /** Read what was chosen: until it has come, nothing of the choice before is shown. */
  const readChoice = () => {
    review.value = "reading";
    trajectories.value = quality.value = null;
    app.toasts.attempt(read);
  };
  /** @param {string} key */
  const choosePath = (key) => {
    path.value = paths.value.find((one) => one.key === key) ?? path.value;
    pair.value = [];
    readChoice();
  };
  /** @param {string} name */
  const chooseMeasure = (name) => {
    wish.value = name;
    sessionStorage.setItem(MEASURE_PLACE, name);
    readChoice();
  };
  /** @param {SourceGroup} chosen */
  const chooseGroup = (chosen) => {
    group.value = chosen;
    readChoice();
  };
  /**
   * Choose a trial to compare, or not.
   * @param {TrialView} trial @param {boolean} isChosen
   */
  const chooseTrial = (trial, isChosen) => void (pair.value = withChoice(pair.value, trial, isChosen));
  const choices = { paths, path, trialsOfPath, group, measures, measure, pair };
  const actions = { read, choosePath, chooseMeasure, chooseGroup, chooseTrial };
  return { app, left, patients, patient, plans, unread, ...choices, review, trajectories, quality, ...actions };
}
