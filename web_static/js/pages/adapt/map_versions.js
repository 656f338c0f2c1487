/**
 * The versions of a patient's map, with what each of them changed.
 * @import { JointDifference, MapVersion } from "types/documents"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { moment, number, ofFull, percent } from "../../widgets/format.js";
import { jointLabel } from "../../widgets/joint_words.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

const COLUMNS = ["version", "when", "origin", "difference", "trials"];

/** @param {{maps: MapVersion[], labels: Record<string, string>}} card labels: of the joints */
export function MapVersions({ maps, labels }) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("adapt-versions")),
    h("p", { class: "quiet small" }, t("adapt-versions-lead")),
    h(
      ScrollTable,
      { label: t("adapt-versions"), kind: "measures in-view map-versions" },
      h(TableHead, { columns: COLUMNS.map((name) => t(`adapt-${name}`)) }),
      h(
        "tbody",
        {},
        maps.map((one) =>
          h(
            "tr",
            { key: one.version },
            h("th", { scope: "row" }, one.version),
            h("td", {}, moment(one.created)),
            h("td", {}, origin(one)),
            h("td", { class: "words" }, changes(one, labels)),
            h("td", {}, one.trials.length),
          ),
        ),
      ),
    ),
  );
}

/** @param {MapVersion} version */
function origin({ origin: how, parent, difference }) {
  const itself = difference?.by_itself ? "-itself" : "";
  return t(`adapt-origin-${how}${itself}`, { parent: parent ?? "", to: difference?.back_to ?? "" });
}

/** @param {MapVersion} version @param {Record<string, string>} labels */
function changes({ difference }, labels) {
  const joints = Object.entries(difference?.joints ?? {}).map(([name, joint]) =>
    t("adapt-difference-joint", {
      joint: labels[name] ?? jointLabel({ name, label: name.replaceAll("_", " ") }),
      changes: ofJoint(joint).join(", "),
    }),
  );
  const felt = difference?.felt_change;
  if (joints.length && typeof felt === "number" && Number.isFinite(felt))
    joints.push(t("adapt-difference-felt", { percent: percent(felt) }));
  return joints.map((words) => h("div", { key: words }, words));
}

/** @param {JointDifference} joint */
function ofJoint(joint) {
  const found = [];
  if (joint.angle_applied_deg) found.push(t("adapt-difference-turn", { angle: number(joint.angle_applied_deg, 1) }));
  for (const name of /** @type {const} */ (["dead_zone", "full"])) {
    const [before, after] = [joint[`${name}_before`], joint[`${name}_after`]];
    if (before !== after) found.push(t(`adapt-difference-${name}`, { value: ofFull(after, t("unit-rate")) }));
  }
  if (joint.range_moved) found.push(t("adapt-difference-range"));
  return found;
}
