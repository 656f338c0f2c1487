/**
 * The quality of control over trials: a figure to choose, for all joints or one, and what to look at.
 * @import { QualityView } from "types/api"
 */
import { ChartPlace } from "../../charts/chart_place.js";
import { qualityChart } from "../../charts/quality_chart.js";
import { Fragment, h, useSignal } from "../../preact.js";
import { ControlWarnings } from "../../results/control_warnings.js";
import { OF_JOINT } from "../../results/quality_card.js";
import { GroupMark } from "../../results/source_group.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { jointLabel } from "../../widgets/joint_words.js";

const OF_ALL = ["map_angle_deg", "evr", "null_space_share", "cross_talk", "activations_per_metre", "activations"];
const ALL = "";

/** @param {{app: import("../../main.js").App, left: AbortSignal, view: QualityView}} section */
export function QualitySection({ app, left, view }) {
  const { source, trials, warnings, note } = view;
  return h(
    "div",
    { class: "stack" },
    h(ControlWarnings, { warnings, mayChange: app.me?.role !== "reviewer" }),
    h(
      "section",
      { class: "card" },
      h("h2", {}, t("quality-over"), " ", h(GroupMark, { group: source })),
      trials.length ? h(Course, { app, left, view }) : h("p", { class: "quiet" }, t("quality-empty")),
      note && h("p", { class: "quiet small" }, note),
    ),
  );
}

/**
 * One figure over the trials.
 * @param {{app: import("../../main.js").App, left: AbortSignal, view: QualityView}} course
 */
function Course({ app, left, view }) {
  const chosen = useSignal({ name: "map_angle_deg", joint: ALL });
  const joint = chosen.value.joint in view.labels ? chosen.value.joint : ALL;
  /** @type {readonly string[]} */
  const names = joint === ALL ? OF_ALL : OF_JOINT;
  const name = names.includes(chosen.value.name) ? chosen.value.name : names[0];
  const joints = Object.entries(view.labels).map(([value, label]) => ({
    value,
    label: jointLabel({ name: value, label }),
  }));
  const nameChoice = h(Selection, {
    options: names.map((value) => ({ value, label: t(`quality-${value}`) })),
    chosen: name,
    onChange: (value) => (chosen.value = { name: value, joint }),
  });
  const jointChoice = h(Selection, {
    options: [{ value: ALL, label: t("quality-all-joints") }, ...joints],
    chosen: joint,
    onChange: (value) => (chosen.value = { name, joint: value }),
  });
  return h(
    Fragment,
    {},
    h(
      "div",
      { class: "columns filters" },
      h(Field, { label: t("quality-choose") }, nameChoice),
      h(Field, { label: t("quality-choose-joint") }, jointChoice),
    ),
    h(ChartPlace, {
      app,
      left,
      of: [view, name, joint],
      make: (until) => qualityChart(view.trials, name, joint, until),
    }),
  );
}
