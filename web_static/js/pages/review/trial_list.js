/**
 * Every trial on one path, the newest first: opened one by one, or two side by side.
 * @import { TrialView } from "types/api"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { scrollTable } from "../../widgets/scroll_table.js";
import { comparable, measured, leadingMeasures, nameOf, withUnit } from "../../results/measures.js";
import { interruptionMark } from "../../results/interruptions.js";
import { originWords } from "../../results/origin_words.js";
import { groupMark, groupOf } from "../../results/source_group.js";

/**
 * @param {{id: number}} patient @param {TrialView[]} trials the newest last
 * @param {Set<number>} used ids of the trials in which the patient got used to the task on their day
 * @param {ReturnType<typeof import("./compare_choice.js").compareChoice>} compare which two are to be compared
 * @param {import("../../results/unread_marks.js").UnreadMark} unread
 */
export function trialList(patient, trials, used, compare, unread) {
  const listed = leadingMeasures(trials.findLast(({ measures }) => measures)?.measures ?? {});
  /** @param {TrialView} trial */
  const row = (trial) =>
    h(
      "tr",
      { class: trial.kept ? null : "discarded" },
      h(
        "th",
        { scope: "row" },
        h(
          "a",
          {
            class: "row-link",
            href: `#/review/${patient.id}/trial/${trial.id}`,
            "aria-label": t("review-open", { number: trial.number }),
          },
          String(trial.number),
        ),
        unread({ trial_id: trial.id }),
      ),
      h("td", {}, moment(trial.started)),
      h("td", {}, t(`review-end-${trial.end}`), interruptionMark(trial.measures)),
      listed.map((name) =>
        h("td", {}, comparable(name, trial.measures) ? withUnit(name, measured(trial.measures, name)) : "–"),
      ),
      h(
        "td",
        { title: trial.source.description },
        groupMark(groupOf(trial)) ?? t("source-group-worn"),
        trial.origin && h("div", { class: "quiet small" }, originWords(trial.origin)),
      ),
      h(
        "td",
        {},
        trial.kept
          ? t(used.has(trial.id) ? "review-used" : "review-kept")
          : h("div", { class: "sentence" }, trial.discard_reason),
      ),
      h("td", {}, compare.box(trial)),
    );
  const head = [
    t("review-column-number"),
    t("review-column-when"),
    t("review-column-end"),
    ...listed.map(nameOf),
    t("review-column-source"),
    t("review-column-kept"),
    t("compare-column"),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("review-trials")),
    scrollTable(
      t("review-trials"),
      "measures trials",
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          head.map((words) => h("th", { scope: "col" }, words)),
        ),
      ),
      h("tbody", {}, trials.toReversed().map(row)),
    ),
    trials.length > 1 && compare.element,
  );
}
