/**
 * The newest session of a task against the one before and the first: what is better than noise, as a card of Review.
 * @import { SessionVerdicts } from "types/api"
 * @import { Learning } from "types/documents"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { MEASURES, withUnit } from "../../results/measures.js";
import { noiseNote, verdictLine, verdictWords } from "../../results/verdict_words.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/** @param {Pick<Learning, "verdicts">} learning @param {string} measure that stands first */
export function sessionVerdicts({ verdicts: { sessions, deterioration } }, measure) {
  const worse = deterioration[measure];
  return h(
    "section",
    { class: "card session-verdicts" },
    h("h2", {}, t("verdict.title")),
    worse && h("p", { class: "problem" }, worse),
    sessions.length === 0 && h("p", { class: "quiet" }, t("verdict.none")),
    sessions.map((one) => comparison(one, measure)),
    sessions.length > 0 && noiseNote(),
  );
}

/** @param {SessionVerdicts} compared @param {string} measure */
function comparison(compared, measure) {
  const { earlier, later, trials, verdicts } = compared;
  const verdict = verdictWords(measure, verdicts[measure]);
  const title = t("verdict.sessions", { earlier, later, first: trialsWords(trials[0]), second: trialsWords(trials[1]) });
  return h(
    "div",
    { class: "session-verdict" },
    h("h3", {}, title),
    verdict &&
      h(
        "p",
        {},
        `${t(`measure.${measure}`)}: ${withUnit(measure, verdicts[measure].earlier)} → ${withUnit(measure, verdicts[measure].later)} `,
        h("b", { class: `change ${verdict.tone}` }, verdictLine(verdict)),
      ),
    Object.keys(verdicts).length > 0 && h("details", {}, h("summary", {}, t("verdict.all")), table(compared, title)),
  );
}

/** @param {number} count */
function trialsWords(count) {
  return t("verdict.trials", { count });
}

/** @param {SessionVerdicts} compared @param {string} title */
function table({ earlier, later, verdicts }, title) {
  /** @param {string} name */
  const row = (name) => {
    const verdict = verdictWords(name, verdicts[name]);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, t(`measure.${name}`)),
      h("td", { class: `change ${verdict?.tone ?? ""}` }, verdict ? `${verdict.arrow} ${verdict.words}` : "–"),
      h("td", {}, withUnit(name, verdicts[name].earlier)),
      h("td", { class: "own" }, withUnit(name, verdicts[name].later)),
      h("td", {}, verdict?.noise ?? "–"),
    );
  };
  const head = [
    t("over.measure"),
    t("verdict.column"),
    t("verdict.session", { number: earlier }),
    t("verdict.session", { number: later }),
    t("verdict.noise"),
  ];
  return scrollTable(
    title,
    "measures",
    h("thead", {}, h("tr", {}, head.map((words) => h("th", { scope: "col" }, words)))),
    h("tbody", {}, Object.keys(MEASURES).filter((name) => verdicts[name]).map(row)),
  );
}
