/**
 * The newest session of a task against the one before and the first: what is better than noise, as a card of Review.
 * @import { SessionVerdicts, Verdict } from "types/api"
 * @import { Learning } from "types/documents"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { measureNames, nameOf, REACHED, withUnit } from "../../results/measures.js";
import { noiseNote, shareWords, verdictLine, verdictWords } from "../../results/verdict_words.js";
import { day } from "../../widgets/format.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/**
 * @param {Pick<Learning, "verdicts" | "trials">} learning @param {string} measure that stands first
 * @param {{id: number, sessions: number}} patient
 */
export function sessionVerdicts({ trials, verdicts: { sessions, deterioration, needed } }, measure, patient) {
  const worse = [deterioration[measure], deterioration[REACHED]].filter(Boolean);
  const days = new Map(trials.map(({ session, started }) => [session, day(started)]));
  return h(
    "section",
    { class: "card session-verdicts" },
    h("h2", {}, t("verdict-title")),
    worse.map((words) => h("p", { class: "problem" }, words)),
    sessions.length === 0 && h("p", {}, countWords(trials), " ", t("verdict-needed", { count: needed })),
    sessions.map((one) => comparison(one, measure, needed, days)),
    sessions.length > 0 && noiseNote(),
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

/** @param {SessionVerdicts} compared @param {string} measure @param {number} needed trials @param {Map<number, string>} days by session */
function comparison(compared, measure, needed, days) {
  const { earlier, later, trials, verdicts } = compared;
  const verdict = verdictWords(measure, verdicts[measure]);
  const [earlierTrials, laterTrials] = trials;
  const [earlierDay, laterDay] = [days.get(earlier), days.get(later)];
  const title = t("verdict-sessions", { earlier, earlierDay, earlierTrials, later, laterDay, laterTrials });
  return h(
    "div",
    { class: "session-verdict" },
    h("h3", {}, title),
    verdict &&
      h(
        "p",
        {},
        `${nameOf(measure)}: ${withUnit(measure, verdicts[measure].earlier)} → ${withUnit(measure, verdicts[measure].later)} `,
        verdicts[measure].word !== "number" && h("b", { class: `change ${verdict.tone}` }, verdictLine(verdict)),
        ` ${lackWords(verdicts[measure], needed)}`,
      ),
    verdicts[REACHED] && reachedLine(verdicts[REACHED]),
    Object.keys(verdicts).length > 0 && h("details", {}, h("summary", {}, t("verdict-all")), table(compared, title)),
  );
}

/** How often the goal was reached in the two sessions. @param {Verdict} verdict */
function reachedLine(verdict) {
  const said = verdictWords(REACHED, verdict);
  return h(
    "p",
    {},
    `${nameOf(REACHED)}: ${shareWords(verdict.earlier)} → ${shareWords(verdict.later)} `,
    said && h("b", { class: `change ${said.tone}` }, verdictLine(said)),
  );
}

/** @param {SessionVerdicts} compared @param {string} title */
function table({ earlier, later, verdicts }, title) {
  /** @param {string} name */
  const row = (name) => {
    const verdict = verdictWords(name, verdicts[name]);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, nameOf(name)),
      h("td", { class: `change ${verdict?.tone ?? ""}` }, verdict ? `${verdict.arrow} ${verdict.words}` : "–"),
      h("td", {}, withUnit(name, verdicts[name].earlier)),
      h("td", { class: "own" }, withUnit(name, verdicts[name].later)),
      h("td", {}, verdict?.noise ?? "–"),
    );
  };
  const head = [
    t("over-measure"),
    t("verdict-column"),
    t("verdict-session", { number: earlier }),
    t("verdict-session", { number: later }),
    t("verdict-noise"),
  ];
  return scrollTable(
    title,
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
    h(
      "tbody",
      {},
      measureNames()
        .filter((name) => verdicts[name])
        .map(row),
    ),
  );
}
