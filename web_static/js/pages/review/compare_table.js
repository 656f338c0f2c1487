/**
 * All measures of two trials, what lies between them, and whether that is more than noise.
 * @import { TrialDetail, TrialVerdicts } from "types/api"
 * @import { Measures } from "../../results/measures.js"
 */
import { Fragment, h } from "../../preact.js";
import { interruptionWords } from "../../results/interruptions.js";
import { comparable, measured, measureNames, nameOf, signedWithUnit, withUnit } from "../../results/measures.js";
import { groupOf } from "../../results/source_group.js";
import { isFamiliarisation, NoiseNote, verdictWords } from "../../results/verdict_words.js";
import { t } from "../../texts.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

/**
 * @param {{trials: TrialDetail[], verdicts: TrialVerdicts | null}} table trials: two of them, the earlier first;
 *   verdicts: on the second against the first, null where they cannot be compared
 */
export function CompareTable({ trials, verdicts }) {
  const both = trials.map(({ measures }) => measures ?? {});
  const isMixed = groupOf(trials[0]) !== groupOf(trials[1]); // then no trial is called the better one
  const used = trials.filter(({ id }) => isFamiliarisation(verdicts, id)).map(({ number }) => number);
  /** @param {string} name */
  const row = (name) => {
    const verdict = verdictWords(name, verdicts?.verdicts[name]);
    const isCompared = !isMixed && both.every((one) => comparable(name, one));
    return h(
      "tr",
      { key: name },
      h("th", { scope: "row" }, nameOf(name)),
      both.map((one, i) => h("td", { key: i, class: "own" }, withUnit(name, measured(one, name)))),
      verdicts &&
        h("td", { class: `change ${verdict?.tone ?? ""}` }, verdict ? `${verdict.arrow} ${verdict.words}` : "–"),
      h("td", {}, isCompared ? difference(name, both) : "–"),
      verdicts && h("td", {}, verdict?.noise ?? "–"),
    );
  };
  const interruptions = both.map(interruptionWords);
  const names = measureNames().filter((name) => both.some((one) => measured(one, name) !== null));
  const columns = [
    t("over-measure"),
    ...trials.map(({ number }) => t("compare-trial", { number })),
    ...(verdicts ? [t("compare-verdict", { number: trials[1].number })] : []),
    t("compare-difference"),
    ...(verdicts ? [t("verdict-noise")] : []),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("compare-measures")),
    isMixed && h("p", { class: "quiet" }, t("compare-mixed")),
    used.length > 0 && h("p", { class: "quiet" }, t("compare-used", { numbers: used.join(", ") })),
    names.length
      ? h(
          ScrollTable,
          { label: t("compare-measures"), kind: "measures" },
          h(TableHead, { columns }),
          h(
            "tbody",
            {},
            names.map(row),
            interruptions.some(Boolean) && h(Interruptions, { words: interruptions, hasVerdicts: verdicts !== null }),
          ),
        )
      : h("p", { class: "quiet" }, t("compare-no-measures")),
    verdicts && h(NoiseNote, {}),
  );
}

/** What interrupted each of the two trials. @param {{words: string[], hasVerdicts: boolean}} row */
function Interruptions({ words, hasVerdicts }) {
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, t("interruption-column")),
    words.map((one, i) => h("td", { key: i, class: "own" }, one || t("interruption-none"))),
    h("td", {}, "–"),
    hasVerdicts && h(Fragment, {}, h("td", {}, "–"), h("td", {}, "–")),
  );
}

/** @param {string} name @param {Measures[]} both */
function difference(name, [first, second]) {
  return signedWithUnit(name, Number(measured(second, name)) - Number(measured(first, name)));
}
