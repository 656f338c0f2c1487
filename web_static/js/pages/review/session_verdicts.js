/**
 * The newest session of a task against the one before and the first: what is better than noise, as a card of Review.
 * @import { SessionVerdicts, Verdict } from "types/api"
 * @import { Learning } from "types/documents"
 */
import { h } from "../../preact.js";
import { measureNames, nameOf, REACHED, withUnit } from "../../results/measures.js";
import { NoiseNote, shareWords, verdictLine, verdictWords } from "../../results/verdict_words.js";
import { t } from "../../texts.js";
import { day } from "../../widgets/format.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

/**
 * @param {{learning: Learning, measure: string, patient: {id: number, sessions: number}}} card measure: the one whose
 *   verdict stands first
 */
export function SessionVerdictsCard({ learning: { trials, verdicts }, measure, patient }) {
  const { sessions, deterioration, needed } = verdicts;
  const worse = [deterioration[measure], deterioration[REACHED]].filter(Boolean);
  const days = new Map(trials.map(({ session, started }) => [session, day(started)]));
  return h(
    "section",
    { class: "card session-verdicts" },
    h("h2", {}, t("verdict-title")),
    worse.map((words) => h("p", { class: "problem", key: words }, words)),
    sessions.length === 0 && h("p", {}, countWords(trials), " ", t("verdict-needed", { count: needed })),
    sessions.map((compared) =>
      h(Comparison, { key: `${compared.earlier} ${compared.later}`, compared, measure, needed, days }),
    ),
    sessions.length > 0 && h(NoiseNote, {}),
    patient.sessions > 1 &&
      h("p", {}, h("a", { class: "btn", href: `#/session/patient/${patient.id}/compare` }, t("verdict-compare"))),
  );
}

/** How many trials of the task count towards a verdict. @param {Learning["trials"]} trials */
export function countWords(trials) {
  const count = trials.filter(({ familiarisation }) => !familiarisation).length;
  return t(count ? "verdict-counts" : "verdict-counts-none", { count, all: trials.length });
}

/** What a measure with too few trials lacks; empty for any other verdict. @param {Verdict} verdict @param {number} needed */
function lackWords({ word, trials }, needed) {
  if (word !== "too few") return "";
  return t(trials < needed ? "verdict-few" : "verdict-few-sessions", { count: trials, needed });
}

/**
 * Two sessions.
 * @param {{compared: SessionVerdicts, measure: string, needed: number, days: Map<number, string>}} comparison
 *   needed: trials; days: by session
 */
function Comparison({ compared, measure, needed, days }) {
  const { earlier, later, trials, verdicts } = compared;
  const own = verdicts[measure];
  const inWords = verdictWords(measure, own);
  const [earlierTrials, laterTrials] = trials;
  const [earlierDay, laterDay] = [days.get(earlier), days.get(later)];
  const title = t("verdict-sessions", { earlier, earlierDay, earlierTrials, later, laterDay, laterTrials });
  return h(
    "div",
    { class: "session-verdict" },
    h("h3", {}, title),
    inWords &&
      h(
        "p",
        {},
        `${nameOf(measure)}: ${withUnit(measure, own.earlier)} → ${withUnit(measure, own.later)} `,
        own.word !== "number" && h("b", { class: `change ${inWords.tone}` }, verdictLine(inWords)),
        ` ${lackWords(own, needed)}`,
      ),
    verdicts[REACHED] && reachedLine(verdicts[REACHED]),
    Object.keys(verdicts).length > 0 &&
      h("details", {}, h("summary", {}, t("verdict-all")), h(VerdictTable, { compared, title })),
  );
}

/** How often the goal was reached in the two sessions. @param {Verdict} verdict */
function reachedLine(verdict) {
  const inWords = verdictWords(REACHED, verdict);
  return h(
    "p",
    {},
    `${nameOf(REACHED)}: ${shareWords(verdict.earlier)} → ${shareWords(verdict.later)} `,
    inWords && h("b", { class: `change ${inWords.tone}` }, verdictLine(inWords)),
  );
}

/** @param {{compared: SessionVerdicts, title: string}} table */
function VerdictTable({ compared: { earlier, later, verdicts }, title }) {
  /** @param {string} name */
  const row = (name) => {
    const inWords = verdictWords(name, verdicts[name]);
    return h(
      "tr",
      { key: name },
      h("th", { scope: "row" }, nameOf(name)),
      h("td", { class: `change ${inWords?.tone ?? ""}` }, inWords ? `${inWords.arrow} ${inWords.words}` : "–"),
      h("td", {}, withUnit(name, verdicts[name].earlier)),
      h("td", { class: "own" }, withUnit(name, verdicts[name].later)),
      h("td", {}, inWords?.noise ?? "–"),
    );
  };
  const columns = [
    ...[t("over-measure"), t("verdict-column")],
    ...[earlier, later].map((number) => t("verdict-session", { number })),
    t("verdict-noise"),
  ];
  const names = measureNames().filter((name) => verdicts[name]);
  return h(ScrollTable, { label: title, kind: "measures" }, h(TableHead, { columns }), h("tbody", {}, names.map(row)));
}
