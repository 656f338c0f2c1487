/**
 * Two sessions of a patient side by side: each task with medians and verdicts, and what changed in the parameters.
 * @import { ComparedTests, MeasureOfSessions, SessionComparison, TaskComparison } from "types/api"
 */
import { differenceWords } from "../chair/difference_words.js";
import { comparedTests } from "../../interface_test/test_table.js";
import { entryOf, figure, joined, measureNames, nameOf, REACHED } from "../../results/measures.js";
import { groupMark } from "../../results/source_group.js";
import { noiseNote, shareWords, verdictWords } from "../../results/verdict_words.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [, first, second] }) {
  const found = await app.api.get(`/sessions/${Number(first)}/comparison?other=${Number(second)}`);
  if (signal.aborted) return;
  const { earlier, later, tasks, tests } = found;
  app.setSubject({ code: earlier.code, sessions: [earlier.number, later.number] });
  /** @param {SessionComparison["earlier"]} session */
  const link = ({ id, number: place, started, goal }) =>
    h(
      "li",
      {},
      h("a", { href: `#/session/${id}` }, t("verdict-session", { number: place })),
      ` (${moment(started)})`,
      goal && `: ${goal}`,
    );
  put(
    root,
    h(
      "div",
      { class: "body session-record" },
      h("h1", { tabindex: "-1" }, t("record-compare-title")),
      h(
        "p",
        { class: "lead" },
        t("record-compare-lead", { code: earlier.code, earlier: earlier.number, later: later.number }),
      ),
      h("ul", { class: "card two-sessions" }, link(earlier), link(later)),
      tasks.length === 0 && tests.length === 0 && h("p", { class: "card quiet" }, t("record-compare-nothing")),
      tasks.map((task) => taskCard(found, task)),
      tasks.length > 0 &&
        h("div", { class: "card" }, h("p", { class: "quiet small" }, t("record-compare-spread")), noiseNote()),
      tests.map((compared) => testsCard(found, compared)),
      changesCard(found),
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: `#/session/patient/${earlier.patient_id}` }, t("record-back")),
    ),
  );
}

/** @param {SessionComparison} found @param {TaskComparison} task */
function taskCard({ earlier, later }, { floorplan_title: plan, path_title: path, source, trials, counted, measures }) {
  const title = t("record-compare-task", { plan, path });
  const names = [REACHED, ...measureNames()].filter((name) => measures[name]);
  const compared = /** @type {const} */ (["earlier", "later"]).map((when) =>
    Math.max(0, ...names.map((name) => measures[name][when]?.trials ?? 0)),
  );
  /** @param {string} name */
  const row = (name) => {
    const { earlier: before, later: now, verdict } = measures[name];
    const inWords = verdictWords(name, verdict ?? undefined);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, nameOf(name)),
      h("td", { class: `change ${inWords?.tone ?? ""}` }, inWords ? `${inWords.arrow} ${inWords.words}` : "–"),
      h("td", {}, name === REACHED ? shareWords(verdict?.earlier ?? null) : summaryWords(name, before)),
      h("td", { class: "own" }, name === REACHED ? shareWords(verdict?.later ?? null) : summaryWords(name, now)),
    );
  };
  const sessions = [earlier, later].map((one) => t("verdict-session", { number: one.number }));
  const head = [t("over-measure"), t("verdict-column"), ...sessions];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, title, " ", groupMark(source)),
    h(
      "p",
      { class: "small" },
      [earlier, later].map(
        (one, i) =>
          `${t("record-compare-trials", { number: one.number, driven: trials[i], counted: counted[i], compared: compared[i] })} `,
      ),
    ),
    names.length === 0
      ? h("p", { class: "quiet" }, t("record-compare-none"))
      : scrollTable(
          title,
          "measures in-view",
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              head.map((words) => h("th", { scope: "col" }, words)),
            ),
          ),
          h("tbody", {}, names.map(row)),
        ),
  );
}

/** @param {SessionComparison} found @param {ComparedTests} compared */
function testsCard({ earlier, later }, compared) {
  const sessions = [earlier, later];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-tests"), " ", groupMark(compared.source)),
    h(
      "p",
      { class: "small" },
      sessions.map((one, i) => `${t("record-compare-tests", { number: one.number, complete: compared.complete[i] })} `),
      t("record-compare-tests-newest"),
    ),
    comparedTests(
      compared,
      sessions.map((one) => t("verdict-session", { number: one.number })),
    ),
    h("p", { class: "quiet small" }, t("test-noise")),
  );
}

/** The median and the range, each on a line of its own where there is room. @param {string} name of the measure @param {MeasureOfSessions["earlier"]} summary */
function summaryWords(name, summary) {
  if (!summary) return "–";
  const [median, low, high] = [summary.median, summary.low, summary.high].map((value) => figure(name, value));
  return [
    h("span", { class: "whole" }, joined(median, entryOf(name).unit)),
    " ",
    h("span", { class: "whole small" }, t("record-compare-range", { low, high })),
  ];
}

/** @param {SessionComparison} found */
function changesCard({ earlier, later, sets: [before, now], changes }) {
  const maps =
    before &&
    now &&
    t("record-compare-maps", {
      earlier: before.version,
      first: earlier.number,
      later: now.version,
      second: later.number,
    });
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-compare-changed")),
    maps && h("p", {}, maps),
    changes === null && h("p", { class: "quiet" }, t("record-compare-unknown")),
    changes?.length === 0 && h("p", {}, t("record-compare-same")),
    changes !== null &&
      changes.length > 0 &&
      h(
        "ul",
        {},
        changes.map((change) => h("li", {}, differenceWords(change))),
      ),
  );
}
