/**
 * What two-minute tests came to: the figures of one, the curve of a measure over all, and whether the newest is better.
 * @import { App } from "../main.js"
 * @import { InterfaceTestView, InterfaceTestsView } from "types/api"
 * @import { ReadonlySignal } from "../preact.js"
 */
import { ChartPlace } from "../charts/chart_place.js";
import { newestAnswer } from "../live/newest_answer.js";
import { Fragment, h, useSignal } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { GroupMark } from "../results/source_group.js";
import { t } from "../texts.js";
import { Field, Selection } from "../widgets/fields.js";
import { moment, number } from "../widgets/format.js";
import { ScrollTable, TableHead } from "../widgets/scroll_table.js";
import { testChart } from "./test_chart.js";
import { testEntry, testFigure, testMeasure, testNames } from "./test_measures.js";

/** @type {Record<string, string>} */
const TONES = { better: "good", worse: "bad" };

/**
 * A signal of a patient's two-minute tests, which are read again after news of tests; null until they were read.
 * @param {App} app @param {number} patient id @param {AbortSignal} left
 */
export function patientTests(app, patient, left) {
  const ask = () => app.api.get(`/interface-tests?patient=${patient}`);
  const tests = newestAnswer(app, left, /** @type {InterfaceTestsView | null} */ (null), ask, ["test"]);
  app.toasts.attempt(async () => {
    const first = await ask();
    tests.value ??= first; // unless news came meanwhile
  });
  return tests;
}

/**
 * A patient's two-minute tests, as a part of a page about the patient; empty while there is none.
 * @param {{app: App, left: AbortSignal, tests: ReadonlySignal<InterfaceTestsView | null>, isHidden?: boolean}} part
 */
export function PatientTests({ app, left, tests, isHidden = false }) {
  const read = tests.value;
  const test = read && newestTest(read);
  return h(
    "div",
    { class: "stack", hidden: isHidden },
    read &&
      test &&
      h(
        Fragment,
        {},
        h("h2", {}, t("rail-interface-test")),
        h(TestFigures, { key: test.id, test }),
        h(TestCourse, { app, left, read }),
      ),
  );
}

/** The newest test that ended. @param {InterfaceTestsView} read */
export function newestTest({ tests }) {
  return tests.findLast((test) => test.status === "done") ?? null;
}

/** The figures of one test. @param {{test: InterfaceTestView}} card */
export function TestFigures({ test }) {
  const { measures, end, number: which, session, started } = test;
  const large = REFERENCE.measures.leading_of_tests;
  const title = h(
    "h2",
    {},
    t("test-result", { number: which }),
    " ",
    h("span", { class: "quiet" }, `${t("test-session", { number: session })}, ${moment(started)}`),
  );
  if (end !== "complete" || !measures) {
    const reached = measures
      ? t("test-so-far", { count: measures.acquired, seconds: number(measures.duration, 0) })
      : "";
    return h("section", { class: "card" }, title, h("p", {}, t(`test-end-${end ?? "fault"}`), " ", reached));
  }
  return h(
    "section",
    { class: "card" },
    title,
    h(
      "div",
      { class: "test-large" },
      large.map((name) =>
        h(
          "div",
          { key: name },
          h("div", { class: "quiet" }, testEntry(name).name),
          h("div", { class: "big" }, largeFigure(test, name)),
        ),
      ),
    ),
    h(
      "p",
      {},
      t("test-reached", {
        acquired: measures.acquired,
        missed: measures.missed,
        seconds: REFERENCE.numbers.target_missed_after,
      }),
    ),
    h(
      "details",
      {},
      h("summary", {}, t("test-details")),
      h(
        ScrollTable,
        { label: t("test-ways"), kind: "test-ways" },
        h(TableHead, { columns: ["way", "acquired", "missed", "time"].map((name) => t(`test-ways-${name}`)) }),
        h(
          "tbody",
          {},
          Object.entries(measures.directions).map(([way, { acquired, missed, movement_time: time }]) =>
            h(
              "tr",
              { key: way },
              h("th", { scope: "row" }, t(`test-way-${way}`)),
              h("td", {}, acquired),
              h("td", {}, missed),
              h("td", {}, time === null ? "–" : `${number(time, 2)} s`),
            ),
          ),
        ),
      ),
      testNames()
        .filter((name) => !large.includes(name))
        .map((name) =>
          h(
            "p",
            { key: name },
            `${testEntry(name).name}: ${testFigure(test, name)}. `,
            h("span", { class: "quiet" }, testEntry(name).meaning),
          ),
        ),
      large.map((name) =>
        h("p", { key: name, class: "quiet small" }, `${testEntry(name).name}: ${testEntry(name).meaning}`),
      ),
      h("p", { class: "quiet small" }, t("test-publications")),
    ),
  );
}

/** A figure with its unit in small letters. @param {InterfaceTestView} test @param {string} name */
function largeFigure(test, name) {
  const { digits, unit } = testEntry(name);
  return [number(testMeasure(test, name), digits), " ", h("small", {}, unit)];
}

/**
 * The curve of a measure over the tests, and what is better than noise.
 * @param {{app: App, left: AbortSignal, read: InterfaceTestsView}} card
 */
export function TestCourse({ app, left, read }) {
  const { course, source } = read;
  const measure = useSignal(testNames()[0]);
  const choice = h(Selection, {
    options: testNames().map((name) => ({ value: name, label: testEntry(name).name })),
    chosen: measure.value,
    onChange: (name) => (measure.value = name),
  });
  const few = course.counted.length < 2;
  return h(
    "section",
    { class: "card test-course" },
    h("h2", {}, t("test-curve"), " ", source && h(GroupMark, { group: source })),
    h("div", { class: "columns" }, h(Field, { label: t("review-measure") }, choice)),
    h(ChartPlace, {
      app,
      left,
      of: [read, measure.value],
      make: (until) => testChart(read, measure.value, until),
    }),
    few
      ? h("p", { class: "quiet" }, t("test-one"))
      : [verdictTable(read), h("p", { class: "quiet small" }, t("test-noise"))],
    workloadLine(read),
  );
}

/** @param {InterfaceTestsView} read */
function verdictTable({ course }) {
  const columns = course.comparisons.map(({ earlier }) => t("test-against", { number: earlier }));
  return h(
    ScrollTable,
    { label: t("verdict-title"), kind: "test-verdicts" },
    h(TableHead, { columns: [t("over-measure"), ...columns] }),
    h(
      "tbody",
      {},
      testNames().map((name) =>
        h(
          "tr",
          { key: name },
          h("th", { scope: "row" }, testEntry(name).name),
          course.comparisons.map(({ earlier, verdicts }) => {
            const word = verdicts[name]?.word;
            return h(
              "td",
              { key: earlier, class: `change ${TONES[word ?? ""] ?? ""}` },
              word ? REFERENCE.measures.verdicts_of_tests[word] : "–",
            );
          }),
        ),
      ),
    ),
  );
}

/** How demanding the tests felt, one after the other. @param {InterfaceTestsView} read */
function workloadLine({ tests }) {
  const asked = tests.filter(({ raw_tlx: mean }) => mean !== null);
  if (!asked.length) return null;
  const values = asked
    .slice(-8)
    .map(({ number: which, raw_tlx: mean }) => t("test-workload-of", { number: which, value: number(mean, 0) }));
  return h("p", {}, h("b", {}, REFERENCE.measures.workload), ": ", values.join(", "), ".");
}
