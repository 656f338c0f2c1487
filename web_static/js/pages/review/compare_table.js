/**
 * All measures of two trials, what lies between them, and whether that is more than noise.
 * @import { TrialDetail, TrialVerdicts } from "types/api"
 * @import { Measures } from "../../results/measures.js"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { scrollTable } from "../../widgets/scroll_table.js";
import { comparable, measured, measureNames, nameOf, signedWithUnit, withUnit } from "../../results/measures.js";
import { interruptionWords } from "../../results/interruptions.js";
import { groupOf } from "../../results/source_group.js";
import { isFamiliarisation, noiseNote, verdictWords } from "../../results/verdict_words.js";

/**
 * @param {TrialDetail[]} trials two of them, as GET /trials/ID answered, the earlier first
 * @param {TrialVerdicts | null} found on the second against the first; null where they cannot be compared
 */
export function compareTable(trials, found) {
  const [first, second] = trials.map(({ measures }) => measures ?? {});
  const isMixed = groupOf(trials[0]) !== groupOf(trials[1]); // then no trial is called the better one
  const used = trials.filter(({ id }) => isFamiliarisation(found, id)).map((one) => one.number);
  /** @param {string} name */
  const row = (name) => {
    const verdict = verdictWords(name, found?.verdicts[name]);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, nameOf(name)),
      [first, second].map((measures) => h("td", { class: "own" }, withUnit(name, measured(measures, name)))),
      found && h("td", { class: `change ${verdict?.tone ?? ""}` }, verdict ? `${verdict.arrow} ${verdict.words}` : "–"),
      h(
        "td",
        {},
        isMixed || ![first, second].every((one) => comparable(name, one)) ? "–" : difference(name, first, second),
      ),
      found && h("td", {}, verdict?.noise ?? "–"),
    );
  };
  const interrupted = [first, second].map(interruptionWords);
  const interruptions = h(
    "tr",
    {},
    h("th", { scope: "row" }, t("interruption-column")),
    interrupted.map((words) => h("td", { class: "own" }, words || t("interruption-none"))),
    h("td", {}, "–"),
    found && [h("td", {}, "–"), h("td", {}, "–")],
  );
  const names = measureNames().filter((name) => [first, second].some((one) => measured(one, name) !== null));
  const head = [
    t("over-measure"),
    ...trials.map((one) => t("compare-trial", { number: one.number })),
    ...(found ? [t("compare-verdict", { number: trials[1].number })] : []),
    t("compare-difference"),
    ...(found ? [t("verdict-noise")] : []),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("compare-measures")),
    isMixed && h("p", { class: "quiet" }, t("compare-mixed")),
    used.length > 0 && h("p", { class: "quiet" }, t("compare-used", { numbers: used.join(", ") })),
    names.length === 0 && h("p", { class: "quiet" }, t("compare-no-measures")),
    names.length > 0 &&
      scrollTable(
        t("compare-measures"),
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
        h("tbody", {}, [names.map(row), interrupted.some(Boolean) && interruptions]),
      ),
    found && noiseNote(),
  );
}

/** @param {string} name @param {Measures} first @param {Measures} second */
function difference(name, first, second) {
  return signedWithUnit(name, Number(measured(second, name)) - Number(measured(first, name)));
}
