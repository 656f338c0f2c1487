/**
 * Every trial on one path, the newest first: opened one by one, or two side by side.
 * @import { TrialView } from "types/api"
 * @import { Learning } from "types/documents"
 * @import { ReviewStore } from "./store.js"
 */
import { h } from "../../preact.js";
import { interruptionWords } from "../../results/interruptions.js";
import { comparable, leadingMeasures, measured, nameOf, withUnit } from "../../results/measures.js";
import { originWords } from "../../results/origin_words.js";
import { PairLink } from "../../results/pair_choice.js";
import { SourceCell } from "../../results/source_group.js";
import { UnreadCount } from "../../results/unread_marks.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

/** @param {{store: ReviewStore, learning: Learning}} list */
export function TrialList({ store, learning }) {
  const trials = store.trialsOfPath.value;
  const names = leadingMeasures(trials.findLast(({ measures }) => measures)?.measures ?? {});
  // The ids of the trials in which the patient got used to the task.
  const used = new Set(learning.trials.filter(({ familiarisation }) => familiarisation).map(({ id }) => id));
  const columns = [
    ...[t("review-column-number"), t("review-column-when"), t("review-column-end")],
    ...names.map(nameOf),
    ...[t("review-column-source"), t("review-column-kept"), t("compare-column")],
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("review-trials")),
    h(
      ScrollTable,
      { label: t("review-trials"), kind: "measures trials" },
      h(TableHead, { columns }),
      h(
        "tbody",
        {},
        trials.toReversed().map((trial) => h(Row, { key: trial.id, store, trial, names, isUsed: used.has(trial.id) })),
      ),
    ),
    trials.length > 1 && h(Comparison, { store }),
  );
}

/**
 * @param {{store: ReviewStore, trial: TrialView, names: string[], isUsed: boolean}} row names: of the measures that are
 *   listed; isUsed: whether the patient got used to the task in this trial
 */
function Row({ store: { patient, unread, pair, chooseTrial }, trial, names, isUsed }) {
  const { id, number, started, end, kept, discard_reason: reason, measures, origin } = trial;
  const interruptions = interruptionWords(measures);
  return h(
    "tr",
    { class: kept ? undefined : "discarded" },
    h(
      "th",
      { scope: "row" },
      h(
        "a",
        { class: "row-link", href: `#/review/${patient.id}/trial/${id}`, "aria-label": t("review-open", { number }) },
        String(number),
      ),
      h(UnreadCount, { comments: unread, about: { trial_id: id } }),
    ),
    h("td", {}, moment(started)),
    h("td", {}, t(`review-end-${end}`), interruptions && h("div", { class: "quiet small sentence" }, interruptions)),
    names.map((name) =>
      h("td", { key: name }, comparable(name, measures) ? withUnit(name, measured(measures, name)) : "–"),
    ),
    h(SourceCell, { of: trial }, origin && h("div", { class: "quiet small" }, originWords(origin))),
    h("td", {}, kept ? t(isUsed ? "review-used" : "review-kept") : h("div", { class: "sentence" }, reason)),
    h(
      "td",
      {},
      h(
        "label",
        { class: "pick" },
        h("input", {
          type: "checkbox",
          "aria-label": t("compare-pick", { number }),
          checked: pair.value.some((one) => one.id === id),
          onChange: ({ currentTarget }) => chooseTrial(trial, currentTarget.checked),
        }),
      ),
    ),
  );
}

/** The link that compares the two trials that are ticked. @param {{store: ReviewStore}} comparison */
function Comparison({ store: { patient, pair } }) {
  const [first, second] = [...pair.value].sort((a, b) => a.id - b.id);
  return h(PairLink, {
    words: t("compare-go"),
    href: second && `#/review/${patient.id}/compare/${first.id}/${second.id}`,
    state: second
      ? t("compare-chosen", { first: first.number, second: second.number })
      : t("compare-choose", { count: 2 - pair.value.length }),
  });
}
