/**
 * What two-minute tests came to: the figures of one, the curve of a measure over all, and whether the newest is better.
 * @import { InterfaceTestView, InterfaceTestsView } from "types/api"
 */
import { concerns } from "../live/news.js";
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";
import { field, selection } from "../widgets/fields.js";
import { moment, number } from "../widgets/format.js";
import { scrollTable } from "../widgets/scroll_table.js";
import { testChart } from "./test_chart.js";
import { REFERENCE } from "../reference.js";
import { groupMark } from "../results/source_group.js";
import { testEntry, testFigure, testMeasure, testNames } from "./test_measures.js";

/** @type {Record<string, string>} */
const TONES = { better: "good", worse: "bad" };

/**
 * A patient's two-minute tests, as a section of a page about the patient; empty while there is none.
 * @param {import("../main.js").App} app @param {number} patient id @param {AbortSignal} signal
 */
export function testsPlace(app, patient, signal) {
  const place = h("div", { class: "stack" });
  let drawn = new AbortController();
  let shown = "";
  signal.addEventListener("abort", () => drawn.abort());
  const read = async () => {
    const found = await app.api.get(`/interface-tests?patient=${patient}`);
    const test = newestTest(found);
    const answer = JSON.stringify(found);
    if (signal.aborted || !test || answer === shown) return; // what was opened on it stays open
    shown = answer;
    drawn.abort();
    drawn = new AbortController();
    put(place, h("h2", {}, t("rail-interface-test")), testFigures(test), courseCard(found, drawn.signal));
  };
  app.live.addEventListener(
    "changed",
    ({ detail }) => concerns(detail, { what: ["test"], patient }) && app.toasts.attempt(read),
    { signal },
  );
  app.toasts.attempt(read);
  return place;
}

/** The newest test that ended. @param {InterfaceTestsView} read */
export function newestTest({ tests }) {
  return tests.findLast((test) => test.status === "done") ?? null;
}

/** The figures of one test. @param {InterfaceTestView} test */
export function testFigures(test) {
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
          {},
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
      scrollTable(
        t("test-ways"),
        "test-ways",
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ["way", "acquired", "missed", "time"].map((name) => h("th", { scope: "col" }, t(`test-ways-${name}`))),
          ),
        ),
        h(
          "tbody",
          {},
          Object.entries(measures.directions).map(([way, { acquired, missed, movement_time: time }]) =>
            h(
              "tr",
              {},
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
            {},
            `${testEntry(name).name}: ${testFigure(test, name)}. `,
            h("span", { class: "quiet" }, testEntry(name).meaning),
          ),
        ),
      large.map((name) => h("p", { class: "quiet small" }, `${testEntry(name).name}: ${testEntry(name).meaning}`)),
      h("p", { class: "quiet small" }, t("test-publications")),
    ),
  );
}

/** A figure with its unit in small letters. @param {InterfaceTestView} test @param {string} name */
function largeFigure(test, name) {
  const { digits, unit } = testEntry(name);
  return [number(testMeasure(test, name), digits), " ", h("small", {}, unit)];
}

/** The curve of a measure over the tests, and what is better than noise. @param {InterfaceTestsView} read @param {AbortSignal} signal */
export function courseCard(read, signal) {
  const { course, source } = read;
  const place = h("div", {});
  let measure = testNames()[0];
  let drawn = new AbortController();
  signal.addEventListener("abort", () => drawn.abort());
  const draw = async () => {
    drawn.abort();
    const until = (drawn = new AbortController()).signal;
    const made = await testChart(read, measure, until);
    if (!until.aborted) put(place, made);
  };
  const choice = selection(
    testNames().map((name) => ({ value: name, label: testEntry(name).name })),
    measure,
    (name) => {
      measure = name;
      draw();
    },
  );
  draw();
  const few = course.counted.length < 2;
  return h(
    "section",
    { class: "card test-course" },
    h("h2", {}, t("test-curve"), " ", source && groupMark(source)),
    h("div", { class: "columns" }, field(t("review-measure"), choice)),
    place,
    few
      ? h("p", { class: "quiet" }, t("test-one"))
      : [verdictTable(read), h("p", { class: "quiet small" }, t("test-noise"))],
    workloadLine(read),
  );
}

/** @param {InterfaceTestsView} read */
function verdictTable({ course }) {
  return scrollTable(
    t("verdict-title"),
    "test-verdicts",
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { scope: "col" }, t("over-measure")),
        course.comparisons.map(({ earlier }) => h("th", { scope: "col" }, t("test-against", { number: earlier }))),
      ),
    ),
    h(
      "tbody",
      {},
      testNames().map((name) =>
        h(
          "tr",
          {},
          h("th", { scope: "row" }, testEntry(name).name),
          course.comparisons.map(({ verdicts }) => {
            const word = verdicts[name]?.word;
            return h(
              "td",
              { class: `change ${TONES[word ?? ""] ?? ""}` },
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
