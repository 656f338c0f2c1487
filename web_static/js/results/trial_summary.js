/**
 * What a trial came to: the large figures, the driven line, and a table beside the trials before.
 * @import { FloorPlan, TrialDetail, TrialVerdicts, TrialView } from "types/api"
 * @import { Measures } from "./measures.js"
 * @import { TrialReading } from "./trial_over.js"
 * @typedef {{title: string, reached: boolean, time: number | null, [name: string]: unknown}} StageResult one of a course
 */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { number } from "../widgets/format.js";
import { Made } from "../widgets/made.js";
import {
  comparable,
  entryOf,
  figure,
  largeMeasures,
  leadingMeasures,
  measured,
  measureNames,
  nameOf,
  unitOf,
  withUnit,
} from "./measures.js";
import { interruptionWords, isInterrupted } from "./interruptions.js";
import { originWords } from "./origin_words.js";
import { planPicture } from "../plan/plan_svg.js";
import { ScrollTable, TableHead } from "../widgets/scroll_table.js";
import { groupOf } from "./source_group.js";
import { isFamiliarisation, NoiseNote, verdictLine, verdictWords } from "./verdict_words.js";
import { wayDone } from "./way_done.js";

/** The trials before this one of the same source, on the same path, that count and were measured. @param {TrialDetail} trial @param {TrialView[]} trials */
function earlierTrials(trial, trials) {
  const pathName = trial.path_name;
  return trials.filter(
    (one) =>
      one.id < trial.id &&
      groupOf(one) === groupOf(trial) &&
      one.floorplan === trial.floorplan &&
      one.path === pathName &&
      one.kept &&
      one.measures,
  );
}

/** @param {{reading: TrialReading, left: AbortSignal}} summary */
export function TrialSummary({ reading: { trial, trials, plan, verdicts: found }, left }) {
  const earlier = earlierTrials(trial, trials);
  const { measures } = trial;
  const large = largeMeasures(trial);
  return h(
    "div",
    { class: "stack" },
    trial.origin && h("p", { class: "quiet" }, originWords(trial.origin)),
    !trial.kept && h("p", { class: "problem" }, t("over-discarded", { reason: trial.discard_reason ?? "" })),
    interruptionNote(trial),
    !measures && h("p", { class: "problem" }, t("over-no-measures")),
    measures && !measures.reached && h("p", { class: "card" }, unfinishedWords(trial, measures)),
    isFamiliarisation(found, trial.id) && h("p", { class: "card quiet" }, t("verdict-familiarisation")),
    measures &&
      large.length > 0 &&
      h(
        "div",
        { class: "large-figures" },
        large.map((name) => largeFigure(name, measures, found)),
      ),
    measures?.parts ? stagesCard(/** @type {StageResult[]} */ (measures.parts)) : null,
    h(
      "div",
      { class: "summary-columns" },
      drivenCard(trial, plan, left),
      measures && tableCard(measures, earlier, trial.kept ? found : null),
    ),
  );
}

/** What interrupted the trial; and that it counts only when somebody says so. @param {TrialDetail} trial */
function interruptionNote({ kept, measures }) {
  const words = interruptionWords(measures);
  if (!words) return null;
  const ask = !kept && isInterrupted(measures);
  return h(
    "p",
    { class: "card interruptions" },
    h("b", {}, `${words}.`),
    " ",
    t("interruption-left-out"),
    ask && [" ", t("interruption-ask")],
  );
}

/** How far an unfinished trial came, and that it is not compared. @param {TrialDetail} trial @param {Measures} measures */
function unfinishedWords(trial, measures) {
  if (!("e_diff" in measures)) return t("over-not-done");
  const way = wayDone(trial);
  const far = way && t("over-way", { done: number(way.done, 1), length: number(way.length, 1) });
  return [far && h("b", {}, far), " ", t("over-not-reached")];
}

/** @param {string} name @param {Measures} measures @param {TrialVerdicts | null} found */
function largeFigure(name, measures, found) {
  const verdict = verdictWords(name, found?.verdicts[name]);
  return h(
    "section",
    { class: "card", key: name },
    h("h2", {}, nameOf(name)),
    h("div", { class: "big" }, figureOf(name, measures)),
    h(
      "p",
      { class: `change ${verdict?.tone ?? ""}` },
      verdict
        ? verdictLine(verdict)
        : name === "dist"
          ? t("over-path-length", { length: number(measured(measures, "path_length"), 2) })
          : "\u00a0",
    ),
  );
}

/** A figure with its unit small behind it; a degree sign is as large as the figure. @param {string} name @param {Measures} measures */
function figureOf(name, measures) {
  const value = measured(measures, name);
  if (entryOf(name).unit === "°") return withUnit(name, value);
  return [figure(name, value), " ", h("small", {}, unitOf(name, measures))];
}

/** @param {TrialDetail} trial @param {FloorPlan} plan */
function requestOf(trial, plan) {
  return plan.paths.find(({ name }) => name === trial.path_name) ?? null;
}

/** The stages of a course, each with what it came to. @param {StageResult[]} parts */
function stagesCard(parts) {
  /** @param {StageResult} part @param {number} index */
  const row = ({ title, reached, time, ...own }, index) => {
    const [first] = leadingMeasures(own).filter((name) => comparable(name, { ...own, reached }) && name !== "dist");
    return h(
      "tr",
      { key: index },
      h("th", { scope: "row" }, `${index + 1}. ${title}`),
      h("td", { class: reached ? "change good" : "change" }, t(reached ? "over-stage-done" : "over-stage-open")),
      h("td", {}, reached ? withUnit("time", time) : "–"),
      h("td", {}, first ? `${nameOf(first)}: ${withUnit(first, measured(own, first))}` : ""),
    );
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("over-stages")),
    h(ScrollTable, { label: t("over-stages"), kind: "measures" }, h("tbody", {}, parts.map(row))),
  );
}

/** @param {TrialDetail} trial @param {FloorPlan | null} plan @param {AbortSignal} left */
function drivenCard(trial, plan, left) {
  const { trajectory } = trial;
  if (!plan || !trajectory)
    return h(
      "section",
      { class: "card" },
      h("h2", {}, t("over-driven")),
      h("p", { class: "quiet" }, t("over-no-trajectory")),
    );
  const make = () => {
    const picture = planPicture(plan, trial.path, {
      label: t("over-driven"),
      hasRooms: true,
      request: requestOf(trial, plan),
    });
    picture.setTrajectory(trajectory.x.map((x, i) => [x, trajectory.y[i]]));
    return picture.element;
  };
  return h("section", { class: "card driven-card" }, h("h2", {}, t("over-driven")), h(Made, { left, make }));
}

/** @param {Measures} measures @param {TrialView[]} earlier @param {TrialVerdicts | null} found */
function tableCard(measures, earlier, found) {
  const compares = measureNames().some((name) => comparable(name, measures));
  const previous = (compares && earlier.find(({ id }) => id === found?.earlier)) || null;
  const title = t(previous ? "over-table" : "over-measures");
  const rows = measureNames()
    .filter((name) => measured(measures, name) !== null && (measures.reached || !entryOf(name).of_whole))
    .map((name) => {
      const verdict = verdictWords(name, found?.verdicts[name]);
      return h(
        "tr",
        { key: name },
        h("th", { scope: "row" }, nameOf(name)),
        h("td", { class: "own" }, withUnit(name, measured(measures, name))),
        previous && [
          h("td", { class: `change ${verdict?.tone ?? ""}` }, verdict ? `${verdict.arrow} ${verdict.words}` : "–"),
          h("td", {}, comparable(name, measures) ? withUnit(name, measured(previous.measures, name)) : "–"),
          h("td", {}, verdict?.noise ?? "–"),
          h("td", {}, comparable(name, measures) ? withUnit(name, found?.best[name]) : "–"),
        ],
      );
    });
  const columns = [
    t("over-measure"),
    t("over-this"),
    ...(previous
      ? [t("verdict-column"), t("over-previous", { number: previous.number }), t("verdict-noise"), t("over-best")]
      : []),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, title),
    h(ScrollTable, { label: title, kind: "measures" }, h(TableHead, { columns }), h("tbody", {}, rows)),
    previous && h(NoiseNote, {}),
    h("details", { class: "small" }, h("summary", {}, t("measure-details")), h("p", {}, t("measure-details-words"))),
  );
}
