/** All measures of two trials, what lies between them, and which is better. */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { change, MEASURES, withUnit } from "../../results/measures.js";
import { groupOf } from "../../results/source_group.js";

/** @param {any[]} trials two of them, as GET /trials/ID answered */
export function compareTable(trials) {
  const [first, second] = trials.map(({ measures }) => measures ?? {});
  const isMixed = groupOf(trials[0]) !== groupOf(trials[1]); // then neither is better than the other
  const row = (name) => {
    const difference = isMixed ? null : change(name, second, first);
    const isBetter = difference?.tone && trials[difference.tone === "good" ? 1 : 0];
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, t(`measure.${name}`)),
      [first, second].map((measures) => h("td", { class: "own" }, withUnit(name, measures[name]))),
      h("td", {}, difference?.amount || (difference ? difference.words : "–")),
      h("td", {}, isBetter ? t("compare.trial", isBetter) : difference ? "=" : "–"),
    );
  };
  const names = Object.keys(MEASURES).filter((name) => Number.isFinite(first[name]) || Number.isFinite(second[name]));
  const head = [
    t("over.measure"),
    ...trials.map((one) => t("compare.trial", one)),
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
      h(
        "div",
        { class: "scroll-x", tabindex: "0", role: "region", "aria-label": t("compare.measures") },
        h(
          "table",
          { class: "measures" },
          h("thead", {}, h("tr", {}, head.map((words) => h("th", { scope: "col" }, words)))),
          h("tbody", {}, names.map(row)),
        ),
      ),
  );
}
