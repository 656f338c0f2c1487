/**
 * Tables of two-minute tests: each test with its figures, and the tests of two sessions side by side.
 * @import { ComparedTests, InterfaceTestView } from "types/api"
 */
import { h } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { SourceCell } from "../results/source_group.js";
import { t } from "../texts.js";
import { number } from "../widgets/format.js";
import { ScrollTable, TableHead } from "../widgets/scroll_table.js";
import { testEntry, testFigure, testNames } from "./test_measures.js";

/** @type {Record<string, string>} */
const TONES = { better: "good", worse: "bad" };

/** A row for each test, with its figures, or why it does not count. @param {{tests: InterfaceTestView[]}} table */
export function TestTable({ tests }) {
  const columns = [
    t("test-number"),
    ...testNames().map((name) => testEntry(name).name),
    REFERENCE.measures.workload,
    t("review-column-source"),
  ];
  return h(
    ScrollTable,
    { label: t("record-tests"), kind: "measures trials" },
    h(TableHead, { columns }),
    h(
      "tbody",
      {},
      tests.map((test) => h(TestRow, { key: test.id, test })),
    ),
  );
}

/** @param {{test: InterfaceTestView}} row */
function TestRow({ test }) {
  const counts = test.end === "complete" && test.measures;
  const figures = () => [
    testNames().map((name) => h("td", { key: name }, testFigure(test, name))),
    h("td", {}, test.raw_tlx === null ? "–" : number(test.raw_tlx, 0)),
  ];
  const reason = () => t(test.status === "done" ? `test-end-${test.end ?? "fault"}` : "test-phase-running");
  return h(
    "tr",
    { class: counts ? undefined : "discarded" },
    h("th", { scope: "row" }, String(test.number)),
    counts ? figures() : h("td", { colspan: testNames().length + 1 }, reason()),
    h(SourceCell, { of: test }),
  );
}

/**
 * The newest complete test of each of two sessions.
 * @param {{compared: ComparedTests, sessions: string[]}} table sessions: their names
 */
export function ComparedTestsTable({ compared: { earlier, later, verdicts }, sessions }) {
  /** @param {string} name */
  const row = (name) => {
    const word = verdicts[name]?.word;
    const [before, now] = [earlier, later].map((test) => (test ? testFigure(test, name) : "–"));
    return h(
      "tr",
      { key: name },
      h("th", { scope: "row" }, testEntry(name).name),
      h("td", {}, before),
      h("td", { class: "own" }, now),
      h("td", { class: `change ${TONES[word ?? ""] ?? ""}` }, word ? REFERENCE.measures.verdicts_of_tests[word] : "–"),
    );
  };
  return h(
    ScrollTable,
    { label: t("record-tests"), kind: "measures" },
    h(TableHead, { columns: [t("over-measure"), ...sessions, t("verdict-column")] }),
    h("tbody", {}, testNames().map(row)),
  );
}
