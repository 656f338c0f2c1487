/**
 * What was driven in a session: trials that count and those left out with their reason, calibrations and parameters.
 * @import { CommentView, SessionRecordView, SessionTrial, UsedSetView } from "types/api"
 * @import { ReadonlySignal } from "../../preact.js"
 */
import { TestTable } from "../../interface_test/test_table.js";
import { Fragment, h } from "../../preact.js";
import { interruptionWords } from "../../results/interruptions.js";
import { SourceCell } from "../../results/source_group.js";
import { UnreadCount } from "../../results/unread_marks.js";
import { t } from "../../texts.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

/** @param {{record: SessionRecordView, unread: ReadonlySignal<CommentView[]>}} card */
export function DrivenCard({ record: { patient_id: patient, trials, drives, tests, sets }, unread }) {
  const isEmpty = !trials.length && !drives.length && !tests.length;
  const columns = [
    ...[t("record-driven-task"), t("review-column-end")],
    ...[t("review-column-source"), t("record-driven-kept")],
  ];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-driven")),
    isEmpty && h("p", { class: "quiet" }, t("record-driven-none")),
    trials.length > 0 &&
      h(
        ScrollTable,
        { label: t("record-driven"), kind: "measures trials" },
        h(TableHead, { columns }),
        h(
          "tbody",
          {},
          trials.map((trial) => h(TrialRow, { key: trial.id, patient, trial, unread })),
        ),
      ),
    drives.length > 0 && h("p", {}, t("record-driven-drives", { count: drives.length })),
    tests.length > 0 && h(Fragment, {}, h("h3", {}, t("record-tests")), h(TestTable, { tests })),
    sets.length > 0 &&
      h(Fragment, {}, h("h3", {}, t("record-sets")), h("ul", { class: "sets-of-session" }, sets.map(setLine))),
  );
}

/** @param {{patient: number, trial: SessionTrial, unread: ReadonlySignal<CommentView[]>}} row patient: id */
function TrialRow({ patient, trial, unread }) {
  const { id, number, floorplan_title: plan, end, kept, discard_reason: reason, measures } = trial;
  const interruptions = interruptionWords(measures);
  return h(
    "tr",
    { class: kept ? undefined : "discarded" },
    h(
      "th",
      { scope: "row" },
      h(
        "a",
        { class: "row-link", href: `#/review/${patient}/trial/${id}` },
        t("record-driven-trial", { plan, number }),
      ),
      h(UnreadCount, { comments: unread, about: { trial_id: id } }),
    ),
    h("td", {}, t(`review-end-${end}`), interruptions && h("div", { class: "quiet small sentence" }, interruptions)),
    h(SourceCell, { of: trial }),
    h(
      "td",
      {},
      h("div", { class: "sentence" }, kept ? t("record-driven-counts") : t("record-driven-discarded", { reason })),
    ),
  );
}

/** @param {UsedSetView} used */
function setLine({ version, title, hash }) {
  return h(
    "li",
    { key: `${version} ${hash}` },
    t("record-set", { version, title }),
    h(
      "details",
      {},
      h("summary", {}, t("record-details")),
      h("p", { class: "small hash" }, t("record-set-hash", { hash })),
    ),
  );
}
