/**
 * The maps of a joint, as they did on repetitions they had not seen, and which of them drives.
 * @import { MapCheck } from "types/api"
 * @import { JointResult } from "types/documents"
 * @import { OnMap } from "./calibration_result.js"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { number, percent } from "../../widgets/format.js";
import { jointLabel } from "../../widgets/joint_words.js";

/** @type {["in_phase" | "hit_rate" | "false_per_minute", (value: number) => string][]} */
const ROWS = [
  ["in_phase", percent],
  ["hit_rate", percent],
  ["false_per_minute", (value) => number(value, 1)],
];
const WORDS = { in_phase: "result-maps-in-phase", hit_rate: "result-maps-hit", false_per_minute: "result-maps-false" };

/** The choice of a joint that has more than the standard calibration. @param {JointResult} joint @param {OnMap} onMap */
export function mapChoice({ name, label, map, guided, prior }, onMap) {
  /** @type {("pca" | "guided" | "prior")[]} */
  const offered = ["pca"];
  if (guided?.offered) offered.push("guided");
  if (prior?.offered) offered.push("prior");
  if (offered.length < 2) return null;
  return h(
    "details",
    { class: "maps", open: true },
    h("summary", {}, t(map === "pca" ? "result-maps-better" : `result-maps-in-use-${map}`)),
    guided?.offered && checkTables({ guided, prior: null }),
    prior?.offered && checkTables({ guided: null, prior }),
    segments(
      t("result-maps-choose", { joint: jointLabel({ name, label }) }),
      offered.map((value) => ({ value, label: t(`result-maps-${value}`) })),
      map,
      (chosen) => onMap(name, chosen),
    ),
  );
}

/** Each map that is not the standard one beside it, where both were tried. @param {Pick<JointResult, "guided" | "prior">} joint */
export function checkTables({ guided, prior }) {
  return [
    guided?.pca_check && guided.check && checkTable("guided", guided.repetitions, guided.pca_check, guided.check),
    prior?.pca_check && prior.check && checkTable("prior", prior.repetitions, prior.pca_check, prior.check),
  ];
}

/** The standard map and another one side by side. @param {"guided" | "prior"} kind @param {number} repetitions @param {MapCheck} pca @param {MapCheck} other */
function checkTable(kind, repetitions, pca, other) {
  return [
    h("p", { class: "quiet small" }, t(`result-maps-lead-${kind}`, { count: repetitions })),
    h(
      "table",
      { class: "small" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td", {}),
          ["pca", kind].map((one) => h("th", { scope: "col" }, t(`result-maps-${one}`))),
        ),
      ),
      h(
        "tbody",
        {},
        ROWS.map(([key, shown]) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, t(WORDS[key])),
            [pca, other].map((check) => h("td", {}, shown(check[key]))),
          ),
        ),
      ),
    ),
  ];
}
