/**
 * What was driven in a session: trials that count and those left out with their reason, calibrations and parameters.
 * @import { SessionRecordView, SessionTrial, UsedSetView } from "types/api"
 * @import { UnreadMark } from "../../results/unread_marks.js"
 */
import { testTable } from "../../interface_test/test_table.js";
import { interruptionMark } from "../../results/interruptions.js";
import { groupMark, groupOf } from "../../results/source_group.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/** @param {SessionRecordView} record @param {UnreadMark} unread */
export function drivenCard({ patient_id: patient, trials, drives, tests, sets }, unread) {
  const isEmpty = !trials.length && !drives.length && !tests.length;
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-driven")),
    isEmpty && h("p", { class: "quiet" }, t("record-driven-none")),
    trials.length > 0 && trialTable(patient, trials, unread),
    drives.length > 0 && h("p", {}, t("record-driven-drives", { count: drives.length })),
    tests.length > 0 && [h("h3", {}, t("record-tests")), testTable(tests)],
    sets.length > 0 && [h("h3", {}, t("record-sets")), h("ul", { class: "sets-of-session" }, sets.map(setLine))],
  );
}

/** @param {number} patient id @param {SessionTrial[]} trials @param {UnreadMark} unread */
function trialTable(patient, trials, unread) {
  /** @param {SessionTrial} trial */
  const row = (trial) =>
    h(
      "tr",
      { class: trial.kept ? null : "discarded" },
      h(
        "th",
        { scope: "row" },
        h(
          "a",
          { class: "row-link", href: `#/review/${patient}/trial/${trial.id}` },
          t("record-driven-trial", { plan: trial.floorplan_title, number: trial.number }),
        ),
        unread({ trial_id: trial.id }),
      ),
      h("td", {}, t(`review-end-${trial.end}`), interruptionMark(trial.measures)),
      h("td", { title: trial.source.description }, groupMark(groupOf(trial)) ?? t("source-group-worn")),
      h(
        "td",
        {},
        h(
          "div",
          { class: "sentence" },
          trial.kept ? t("record-driven-counts") : t("record-driven-discarded", { reason: trial.discard_reason }),
        ),
      ),
    );
  const head = [t("record-driven-task"), t("review-column-end"), t("review-column-source"), t("record-driven-kept")];
  return scrollTable(
    t("record-driven"),
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
    h("tbody", {}, trials.map(row)),
  );
}

/** @param {UsedSetView} used */
function setLine({ version, title, hash }) {
  return h(
    "li",
    {},
    t("record-set", { version, title }),
    h(
      "details",
      {},
      h("summary", {}, t("record-details")),
      h("p", { class: "small hash" }, t("record-set-hash", { hash })),
    ),
  );
}
