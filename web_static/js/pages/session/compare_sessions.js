/**
 * Two sessions of a patient side by side: each task with medians and verdicts, and what changed in the parameters.
 * @import { ComparedTests, MeasureOfSessions, SessionComparison, TaskComparison } from "types/api"
 */
import { differenceWords } from "../chair/difference_words.js";
import { ComparedTestsTable } from "../../interface_test/test_table.js";
import { Fragment, h } from "../../preact.js";
import { entryOf, figure, joined, measureNames, nameOf, REACHED } from "../../results/measures.js";
import { GroupMark } from "../../results/source_group.js";
import { NoiseNote, shareWords, verdictWords } from "../../results/verdict_words.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";
import { drawWithLinks } from "./frame.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest: [, first, second] }) {
  const found = await app.api.get(`/sessions/${Number(first)}/comparison?other=${Number(second)}`);
  if (left.aborted) return;
  const { earlier, later } = found;
  app.setSubject({ patient: earlier.patient_id, code: earlier.code, sessions: [earlier.number, later.number] });
  drawWithLinks(root, h(Page, { found }), { [`#/session/patient/${earlier.patient_id}`]: t("record-back") });
}

/** @param {{found: SessionComparison}} page */
function Page({ found }) {
  const { earlier, later, tasks, tests } = found;
  const numbers = { earlier: earlier.number, later: later.number };
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("record-compare-title")),
    h("p", { class: "lead" }, t("record-compare-lead", { code: earlier.code, ...numbers })),
    h("ul", { class: "card two-sessions" }, [earlier, later].map(sessionLine)),
    tasks.length === 0 && tests.length === 0 && h("p", { class: "card quiet" }, t("record-compare-nothing")),
    tasks.map((task) => taskCard(found, task)),
    tasks.length > 0 &&
      h("div", { class: "card" }, h("p", { class: "quiet small" }, t("record-compare-spread")), h(NoiseNote, {})),
    tests.map((compared) => testsCard(found, compared)),
    changesCard(found),
  );
}

/** @param {SessionComparison["earlier"]} session */
function sessionLine({ id, number, started, goal }) {
  return h(
    "li",
    { key: id },
    h("a", { href: `#/session/${id}` }, t("verdict-session", { number })),
    ` (${moment(started)})`,
    goal && `: ${goal}`,
  );
}

/** @param {SessionComparison} found @param {TaskComparison} task */
function taskCard({ earlier, later }, { floorplan_title: plan, path_title: path, source, trials, counted, measures }) {
  const title = t("record-compare-task", { plan, path });
  const names = [REACHED, ...measureNames()].filter((name) => measures[name]);
  const compared = /** @type {const} */ (["earlier", "later"]).map((when) =>
    Math.max(0, ...names.map((name) => measures[name][when]?.trials ?? 0)),
  );
  const sessions = [earlier, later].map(({ number }) => t("verdict-session", { number }));
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, title, " ", h(GroupMark, { group: source })),
    h(
      "p",
      { class: "small" },
      [earlier, later].map(
        ({ number }, i) =>
          `${t("record-compare-trials", { number, driven: trials[i], counted: counted[i], compared: compared[i] })} `,
      ),
    ),
    names.length === 0
      ? h("p", { class: "quiet" }, t("record-compare-none"))
      : h(
          ScrollTable,
          { label: title, kind: "measures in-view" },
          h(TableHead, { columns: [t("over-measure"), t("verdict-column"), ...sessions] }),
          h(
            "tbody",
            {},
            names.map((name) => measureRow(name, measures[name])),
          ),
        ),
  );
}

/** @param {string} name of the measure @param {MeasureOfSessions} compared */
function measureRow(name, { earlier, later, verdict }) {
  const inWords = verdictWords(name, verdict ?? undefined);
  const isShare = name === REACHED;
  return h(
    "tr",
    { key: name },
    h("th", { scope: "row" }, nameOf(name)),
    h("td", { class: `change ${inWords?.tone ?? ""}` }, inWords ? `${inWords.arrow} ${inWords.words}` : "–"),
    h("td", {}, isShare ? shareWords(verdict?.earlier ?? null) : summaryWords(name, earlier)),
    h("td", { class: "own" }, isShare ? shareWords(verdict?.later ?? null) : summaryWords(name, later)),
  );
}

/** @param {SessionComparison} found @param {ComparedTests} compared */
function testsCard({ earlier, later }, compared) {
  const numbers = [earlier.number, later.number];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-tests"), " ", h(GroupMark, { group: compared.source })),
    h(
      "p",
      { class: "small" },
      numbers.map((number, i) => `${t("record-compare-tests", { number, complete: compared.complete[i] })} `),
      t("record-compare-tests-newest"),
    ),
    h(ComparedTestsTable, { compared, sessions: numbers.map((number) => t("verdict-session", { number })) }),
    h("p", { class: "quiet small" }, t("test-noise")),
  );
}

/**
 * The median and the range, each on a line of its own where there is room.
 * @param {string} name of the measure @param {MeasureOfSessions["earlier"]} summary
 */
function summaryWords(name, summary) {
  if (!summary) return "–";
  const [median, low, high] = [summary.median, summary.low, summary.high].map((value) => figure(name, value));
  return h(
    Fragment,
    {},
    h("span", { class: "whole" }, joined(median, entryOf(name).unit)),
    " ",
    h("span", { class: "whole small" }, t("record-compare-range", { low, high })),
  );
}

/** @param {SessionComparison} found */
function changesCard({ earlier, later, sets: [before, now], changes }) {
  const maps = { earlier: before?.version, first: earlier.number, later: now?.version, second: later.number };
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-compare-changed")),
    before && now && h("p", {}, t("record-compare-maps", maps)),
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
