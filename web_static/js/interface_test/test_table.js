/**
 * Tables of two-minute tests: each test with its figures, and the tests of two sessions side by side.
 * @import { ComparedTests, InterfaceTestView } from "types/api"
 */
import { REFERENCE } from "../reference.js";
import { groupMark, groupOf } from "../results/source_group.js";
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { scrollTable } from "../widgets/scroll_table.js";
import { testEntry, testFigure, testNames } from "./test_measures.js";

/** @type {Record<string, string>} */
const TONES = { better: "good", worse: "bad" };

/** A row for each test, with its figures, or why it does not count. @param {InterfaceTestView[]} tests */
export function testTable(tests) {
  const head = [
    t("test-number"),
    ...testNames().map((name) => testEntry(name).name),
    REFERENCE.measures.workload,
    t("review-column-source"),
  ];
  /** @param {InterfaceTestView} test */
  const row = (test) => {
    const counts = test.end === "complete" && test.measures;
    const figures = testNames().map((name) => h("td", {}, testFigure(test, name)));
    const workload = h("td", {}, test.raw_tlx === null ? "–" : number(test.raw_tlx, 0));
    return h(
      "tr",
      { class: counts ? null : "discarded" },
      h("th", { scope: "row" }, String(test.number)),
      counts
        ? [figures, workload]
        : h(
            "td",
            { colspan: String(testNames().length + 1) },
            t(test.status === "done" ? `test-end-${test.end ?? "fault"}` : "test-phase-running"),
          ),
      h("td", { title: test.source.description }, groupMark(groupOf(test)) ?? t("source-group-worn")),
    );
  };
  return scrollTable(
    t("record-tests"),
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
    h("tbody", {}, tests.map(row)),
  );
}

/** The newest complete test of each of two sessions. @param {ComparedTests} compared @param {string[]} sessions their names */
export function comparedTests({ earlier, later, verdicts }, sessions) {
  const head = [t("over-measure"), ...sessions, t("verdict-column")];
  /** @param {string} name */
  const row = (name) => {
    const word = verdicts[name]?.word;
    const [before, now] = [earlier, later].map((test) => (test ? testFigure(test, name) : "–"));
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, testEntry(name).name),
      h("td", {}, before),
      h("td", { class: "own" }, now),
      h("td", { class: `change ${TONES[word ?? ""] ?? ""}` }, word ? REFERENCE.measures.verdicts_of_tests[word] : "–"),
    );
  };
  return scrollTable(
    t("record-tests"),
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
    h("tbody", {}, testNames().map(row)),
  );
}
