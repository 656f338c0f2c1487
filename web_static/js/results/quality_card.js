/**
 * How well the map fitted one trial: a card for a trial that is over, and for its page in Review.
 * @import { ControlQuality, JointQuality } from "types/api"
 */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { number, ofFull, percent } from "../widgets/format.js";
import { jointLabel, sensorWithin } from "../widgets/joint_words.js";
import { ScrollTable, TableHead } from "../widgets/scroll_table.js";

/** How each figure is written. @type {Record<string, (value: number | null | undefined) => string>} */
export const QUALITIES = {
  map_angle_deg: (value) => (Number.isFinite(value) ? `${number(value, 0)}°` : number(value, 0)),
  evr: percent,
  null_space_share: percent,
  cross_talk: percent,
  activations: (value) => number(value, 0),
  activations_per_metre: (value) => (Number.isFinite(value) ? `${number(value, 1)} /m` : number(value, 1)),
  span_share: percent,
  rest_rate: (value) => ofFull(value, t("unit-rate")),
};

const OF_TRIAL = /** @type {const} */ (["activations_per_metre", "cross_talk"]);
export const OF_JOINT = /** @type {const} */ ([
  "map_angle_deg",
  "evr",
  "null_space_share",
  "span_share",
  "rest_rate",
  "activations",
]);

/** @param {{quality: ControlQuality | null}} card of a trial, as GET /trials/ID answered */
export function QualityCard({ quality }) {
  const title = h("h2", {}, t("quality-title"));
  if (!quality)
    return h("section", { class: "card quality-card" }, title, h("p", { class: "quiet" }, t("quality-none")));
  const guided = quality.joints.filter((joint) => joint.guided).map(jointLabel);
  const bad = quality.bad_channels
    .filter(({ share }) => share >= 0.005) // less is shown as 0 %
    .map(({ name, share }) => t("quality-bad-one", { name: sensorWithin(name), share: percent(share) }));
  return h(
    "details",
    { class: "card quality-card" },
    h("summary", {}, h("h2", {}, t("quality-details"))),
    h("p", { class: "quiet small" }, t("quality-lead")),
    h(
      "dl",
      { class: "fact-list" },
      OF_TRIAL.map((name) =>
        h(
          "div",
          { key: name },
          h("dt", {}, t(`quality-${name}`), h("small", { class: "quiet" }, ` ${t(`quality-means-${name}`)}`)),
          h("dd", { class: "number" }, QUALITIES[name](quality[name])),
        ),
      ),
    ),
    jointTable(quality.joints),
    quality.joints.some(({ map_angle_deg }) => map_angle_deg === null) &&
      h("p", { class: "quiet small" }, t("quality-still")),
    guided.length > 0 && h("p", { class: "quiet small" }, t("quality-guided", { joints: guided.join(", ") })),
    bad.length > 0 && h("p", { class: "problem" }, t("quality-bad", { sensors: bad.join(", ") })),
  );
}

/** @param {JointQuality[]} joints */
function jointTable(joints) {
  /** @param {JointQuality} joint */
  const row = (joint) =>
    h(
      "tr",
      { key: joint.name },
      h("th", { scope: "row" }, jointLabel(joint)),
      OF_JOINT.map((name) => h("td", { key: name }, QUALITIES[name](joint[name]))),
    );
  /** @param {string} name */
  const head = (name) =>
    h(
      "th",
      { key: name, scope: "col", title: name === "activations" ? undefined : t(`quality-means-${name}`) },
      t(`quality-${name}`),
    );
  return h(
    ScrollTable,
    { label: t("quality-title"), kind: "measures" },
    h(TableHead, { columns: [t("quality-joint")] }, OF_JOINT.map(head)),
    h("tbody", {}, joints.map(row)),
  );
}
