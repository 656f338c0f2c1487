/**
 * The versions of a patient's map, with what each of them changed.
 * @import { JointDifference, MapVersion } from "types/documents"
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { moment, number, ofFull, percent } from "../../widgets/format.js";
import { jointLabel } from "../../widgets/joint_words.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/** @param {MapVersion[]} maps of GET /patients/ID/maps @param {Record<string, string>} labels of the joints */
export function mapVersions(maps, labels) {
  const head = ["version", "when", "origin", "difference", "trials"];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("adapt-versions")),
    h("p", { class: "quiet small" }, t("adapt-versions-lead")),
    scrollTable(
      t("adapt-versions"),
      "measures in-view map-versions",
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          head.map((name) => h("th", { scope: "col" }, t(`adapt-${name}`))),
        ),
      ),
      h(
        "tbody",
        {},
        maps.map((one) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, String(one.version)),
            h("td", {}, moment(one.created)),
            h("td", {}, origin(one)),
            h("td", { class: "words" }, changes(one, labels)),
            h("td", {}, String(one.trials.length)),
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
  return joints.map((words) => h("div", {}, words));
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
