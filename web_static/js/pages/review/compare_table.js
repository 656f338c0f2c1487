/**
 * All measures of two trials, what lies between them, and which is better.
 * @import { TrialDetail } from "types/api"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { scrollTable } from "../../widgets/scroll_table.js";
import { change, measured, MEASURES, withUnit } from "../../results/measures.js";
import { groupOf } from "../../results/source_group.js";

/** @param {TrialDetail[]} trials two of them, as GET /trials/ID answered */
export function compareTable(trials) {
  const [first, second] = trials.map(({ measures }) => measures ?? {});
  const isMixed = groupOf(trials[0]) !== groupOf(trials[1]); // then no trial is called the better one
  /** @param {string} name */
  const row = (name) => {
    const difference = isMixed ? null : change(name, second, first);
    const isBetter = difference?.tone && trials[difference.tone === "good" ? 1 : 0];
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, t(`measure.${name}`)),
      [first, second].map((measures) => h("td", { class: "own" }, withUnit(name, measured(measures, name)))),
      h("td", {}, difference?.amount || (difference ? difference.words : "–")),
      h("td", {}, isBetter ? t("compare.trial", { number: isBetter.number }) : difference ? "=" : "–"),
    );
  };
  const names = Object.keys(MEASURES).filter((name) => [first, second].some((one) => measured(one, name) !== null));
  const head = [
    t("over.measure"),
    ...trials.map((one) => t("compare.trial", { number: one.number })),
    t("compare.difference"),
    t("compare.better"),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("compare.measures")),
    isMixed && h("p", { class: "quiet" }, t("compare.mixed")),
    names.length === 0 && h("p", { class: "quiet" }, t("compare.no-measures")),
    names.length > 0 &&
      scrollTable(
        t("compare.measures"),
        "measures",
        h("thead", {}, h("tr", {}, head.map((words) => h("th", { scope: "col" }, words)))),
        h("tbody", {}, names.map(row)),
      ),
  );
}
