/**
 * What a trial came to: the large figures, the driven line, and a table beside the trials before.
 * @import { FloorPlan, TrialDetail, TrialView } from "types/api"
 * @import { Measures } from "./measures.js"
 * @typedef {{title: string, reached: boolean, time: number | null, [name: string]: unknown}} StageResult one of a course
 */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { best, change, measured, MEASURES, leadingMeasures, unitOf, withUnit } from "./measures.js";
import { planPicture } from "../plan/plan_svg.js";
import { scrollTable } from "../widgets/scroll_table.js";
import { groupOf } from "./source_group.js";

/** The trials before this one of the same source, on the same path, that count and were measured. @param {TrialDetail} trial @param {TrialView[]} trials */
export function earlierTrials(trial, trials) {
  const pathName = trial.path_name;
  return trials.filter(
    (one) =>
      one.id < trial.id && groupOf(one) === groupOf(trial) && one.floorplan === trial.floorplan && one.path === pathName && one.kept && one.measures,
  );
}

/** @param {TrialDetail} trial @param {TrialView[]} trials the patient's @param {FloorPlan | null} plan */
export function trialSummary(trial, trials, plan) {
  const earlier = earlierTrials(trial, trials);
  const previous = earlier.at(-1) ?? null;
  const { measures } = trial;
  return h(
    "div",
    { class: "stack" },
    !trial.kept && h("p", { class: "problem" }, t("over.discarded", { reason: trial.discard_reason ?? "" })),
    !measures && h("p", { class: "problem" }, t("over.no-measures")),
    measures && !measures.reached && h("p", { class: "card quiet" }, t("e_diff" in measures ? "over.not-reached" : "over.not-done")),
    measures &&
      h(
        "div",
        { class: "large-figures" },
        leadingMeasures(measures).map((name) => largeFigure(name, measures, previous)),
      ),
    measures?.parts ? stagesCard(/** @type {StageResult[]} */ (measures.parts)) : null,
    h("div", { class: "summary-columns" }, drivenCard(trial, plan), measures && tableCard(measures, previous, earlier)),
  );
}

/** @param {string} name @param {Measures} measures @param {TrialView | null} previous */
function largeFigure(name, measures, previous) {
  const difference = previous && change(name, measures, previous.measures);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t(`measure.${name}`)),
    h("div", { class: "big" }, figureOf(name, measures)),
    h(
      "p",
      { class: `change ${difference?.tone ?? ""}` },
      difference
        ? `${difference.arrow} ${difference.amount} ${difference.words}`
        : name === "dist"
          ? t("over.path-length", { length: number(measured(measures, "path_length"), 2) })
          : " ",
    ),
  );
}

/** A figure with its unit small behind it; a degree sign is as large as the figure. @param {string} name @param {Measures} measures */
function figureOf(name, measures) {
  const value = measured(measures, name);
  if (MEASURES[name].unit === "°") return withUnit(name, value);
  return [number(value, MEASURES[name].digits), " ", h("small", {}, unitOf(name, measures))];
}

/** @param {TrialDetail} trial @param {FloorPlan} plan */
function requestOf(trial, plan) {
  return plan.paths.find(({ name }) => name === trial.path_name) ?? null;
}

/** The stages of a course, each with what it came to. @param {StageResult[]} parts */
function stagesCard(parts) {
  /** @param {StageResult} part @param {number} index */
  const row = ({ title, reached, time, ...own }, index) => {
    const [first] = leadingMeasures(own).filter((name) => measured(own, name) !== null && name !== "dist");
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, `${index + 1}. ${title}`),
      h("td", { class: reached ? "change good" : "change" }, t(reached ? "over.stage.done" : "over.stage.open")),
      h("td", {}, reached ? withUnit("time", time) : "–"),
      h("td", {}, first ? `${t(`measure.${first}`)}: ${withUnit(first, measured(own, first))}` : ""),
    );
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("over.stages")),
    scrollTable(t("over.stages"), "measures", h("tbody", {}, parts.map(row))),
  );
}

/** @param {TrialDetail} trial @param {FloorPlan | null} plan */
function drivenCard(trial, plan) {
  const { trajectory } = trial;
  if (!plan || !trajectory)
    return h(
      "section",
      { class: "card" },
      h("h2", {}, t("over.driven")),
      h("p", { class: "quiet" }, t("over.no-trajectory")),
    );
  const picture = planPicture(plan, trial.path, { label: t("over.driven"), hasRooms: true, request: requestOf(trial, plan) });
  picture.setTrajectory(trajectory.x.map((x, i) => [x, trajectory.y[i]]));
  return h("section", { class: "card driven-card" }, h("h2", {}, t("over.driven")), picture.element);
}

/** @param {Measures} measures @param {TrialView | null} previous @param {TrialView[]} earlier */
function tableCard(measures, previous, earlier) {
  const rows = Object.keys(MEASURES)
    .filter((name) => measured(measures, name) !== null)
    .map((name) => {
      const difference = previous && change(name, measures, previous.measures);
      return h(
        "tr",
        {},
        h("th", { scope: "row" }, t(`measure.${name}`)),
        h("td", { class: "own" }, withUnit(name, measured(measures, name))),
        previous && [
          h("td", {}, withUnit(name, measured(previous.measures, name))),
          h(
            "td",
            { class: `change ${difference?.tone ?? ""}` },
            difference ? `${difference.arrow} ${difference.words}` : "–",
          ),
          h("td", {}, withUnit(name, best(name, earlier))),
        ],
      );
    });
  const head = [
    t("over.measure"),
    t("over.this"),
    ...(previous ? [t("over.previous", { number: previous.number }), t("over.change"), t("over.best")] : []),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("over.table")),
    !previous && h("p", { class: "quiet small" }, t("over.first")),
    scrollTable(
      t("over.table"),
      "measures",
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          head.map((words) => h("th", { scope: "col" }, words)),
        ),
      ),
      h("tbody", {}, rows),
    ),
  );
}
