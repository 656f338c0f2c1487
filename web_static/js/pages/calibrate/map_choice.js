/**
 * The maps of a joint, as they did on repetitions they had not seen, and which of them drives.
 * @import { JointResult, MapResult } from "types/documents"
 * @import { MapKind } from "./store.js"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { Segments } from "../../widgets/fields.js";
import { number, percent } from "../../widgets/format.js";
import { jointLabel } from "../../widgets/joint_words.js";

/** @type {["in_phase" | "hit_rate" | "false_per_minute", (value: number) => string][]} */
const ROWS = [
  ["in_phase", percent],
  ["hit_rate", percent],
  ["false_per_minute", (value) => number(value, 1)],
];
const WORDS = { in_phase: "result-maps-in-phase", hit_rate: "result-maps-hit", false_per_minute: "result-maps-false" };

/**
 * The choice of a joint that has more than the standard calibration.
 * @param {{joint: JointResult, onChoose: (map: MapKind) => void}} choice
 */
export function MapChoice({ joint, onChoose }) {
  const others = /** @type {const} */ (["guided", "prior"]).filter((kind) => joint[kind]?.offered);
  if (!others.length) return null;
  return h(
    "details",
    { class: "maps", open: true },
    h("summary", {}, t(joint.map === "pca" ? "result-maps-better" : `result-maps-in-use-${joint.map}`)),
    others.map((kind) => h(CheckTable, { key: kind, kind, map: joint[kind] })),
    h(Segments, {
      label: t("result-maps-choose", { joint: jointLabel(joint) }),
      options: ["pca", ...others].map((value) => ({ value, label: t(`result-maps-${value}`) })),
      chosen: joint.map ?? "",
      onChange: (/** @type {MapKind} */ map) => onChoose(map),
    }),
  );
}

/**
 * The standard map and another one side by side; nothing where they were not both tried.
 * @param {{kind: "guided" | "prior", map: MapResult | null}} table
 */
export function CheckTable({ kind, map }) {
  if (!map?.pca_check || !map.check) return null;
  const checks = [map.pca_check, map.check];
  return [
    h("p", { class: "quiet small" }, t(`result-maps-lead-${kind}`, { count: map.repetitions })),
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
          ["pca", kind].map((one) => h("th", { key: one, scope: "col" }, t(`result-maps-${one}`))),
        ),
      ),
      h(
        "tbody",
        {},
        ROWS.map(([name, written]) =>
          h(
            "tr",
            { key: name },
            h("th", { scope: "row" }, t(WORDS[name])),
            checks.map((check) => h("td", {}, written(check[name]))),
          ),
        ),
      ),
    ),
  ];
}
