/** What a trial came to: the large figures, the driven line, and a table beside the trials before. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { best, change, MEASURES, mostTelling, unitOf, withUnit } from "./measures.js";
import { planPicture } from "../plan/plan_svg.js";
import { groupOf } from "./source_group.js";

/** The trials before this one of the same source, on the same path, that count and were measured. @param {any} trial @param {any[]} trials */
export function earlierTrials(trial, trials) {
  const pathName = trial.path_name ?? trial.path;
  return trials.filter(
    (one) =>
      one.id < trial.id && groupOf(one) === groupOf(trial) && one.floorplan === trial.floorplan && one.path === pathName && one.kept && one.measures,
  );
}

/** @param {any} trial what GET /trials/ID answered @param {any[]} trials the patient's @param {any} plan or null */
export function trialSummary(trial, trials, plan) {
  const earlier = earlierTrials(trial, trials);
  const previous = earlier.at(-1) ?? null;
  const { measures } = trial;
  return h(
    "div",
    { class: "stack" },
    !trial.kept && h("p", { class: "problem" }, t("over.discarded", { reason: trial.discard_reason })),
    !measures && h("p", { class: "problem" }, t("over.no-measures")),
    measures && !measures.reached && h("p", { class: "card quiet" }, t("e_diff" in measures ? "over.not-reached" : "over.not-done")),
    measures &&
      h(
        "div",
        { class: "large-figures" },
        mostTelling(measures).map((name) => largeFigure(name, measures, previous)),
      ),
    measures?.parts && stagesCard(measures.parts),
    h("div", { class: "summary-columns" }, drivenCard(trial, plan), measures && tableCard(trial, previous, earlier)),
  );
}

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
          ? t("over.path-length", { length: number(measures.path_length, 2) })
          : " ",
    ),
  );
}

/** A figure with its unit small behind it; a degree sign is as large as the figure. */
function figureOf(name, measures) {
  if (MEASURES[name].unit === "°") return withUnit(name, measures[name]);
  return [number(measures[name], MEASURES[name].digits), " ", h("small", {}, unitOf(name, measures))];
}

function requestOf(trial, plan) {
  return plan.paths.find(({ name }) => name === trial.path_name) ?? null;
}

/** The stages of a course, each with what it came to. */
function stagesCard(parts) {
  const row = ({ title, reached, time, ...own }, number_) => {
    const [first] = mostTelling(own).filter((name) => Number.isFinite(own[name]) && name !== "dist");
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, `${number_ + 1}. ${title}`),
      h("td", { class: reached ? "change good" : "change" }, t(reached ? "over.stage.done" : "over.stage.open")),
      h("td", {}, reached ? withUnit("time", time) : "–"),
      h("td", {}, first ? `${t(`measure.${first}`)}: ${withUnit(first, own[first])}` : ""),
    );
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("over.stages")),
    h(
      "div",
      { class: "scroll-x", tabindex: "0", role: "region", "aria-label": t("over.stages") },
      h("table", { class: "measures" }, h("tbody", {}, parts.map(row))),
    ),
  );
}

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

function tableCard({ measures }, previous, earlier) {
  const rows = Object.keys(MEASURES)
    .filter((name) => measures[name] !== undefined && measures[name] !== null)
    .map((name) => {
      const difference = previous && change(name, measures, previous.measures);
      return h(
        "tr",
        {},
        h("th", { scope: "row" }, t(`measure.${name}`)),
        h("td", { class: "own" }, withUnit(name, measures[name])),
        previous && [
          h("td", {}, withUnit(name, previous.measures[name])),
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
    h(
      "div",
      { class: "scroll-x", tabindex: "0", role: "region", "aria-label": t("over.table") },
      h(
        "table",
        { class: "measures" },
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
    ),
  );
}
