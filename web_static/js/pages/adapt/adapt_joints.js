/**
 * What would change of each joint: before and after, side by side, and the reason in a sentence.
 * @import { JointView, ProposalView } from "types/api"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { number, ofFull, percent } from "../../widgets/format.js";
import { jointLabel, jointWithin } from "../../widgets/joint_words.js";

const TONES = { applied: "", refused: "bad", unchanged: "plain" };

/** @param {{proposal: ProposalView}} cards */
export function JointCards({ proposal: { joints, applied } }) {
  const still = joints.filter(({ status }) => status === "unchanged");
  const others = joints.filter((joint) => !still.includes(joint));
  return h(
    "div",
    { class: "stack" },
    h(
      "div",
      { class: "joint-cards" },
      others.map((joint) => h(JointCard, { key: joint.name, joint, isApplied: applied !== null })),
    ),
    still.length > 0 && h("p", { class: "quiet" }, t("adapt-others", { joints: still.map(jointWithin).join(", ") })),
  );
}

/** @param {{joint: JointView, isApplied: boolean}} card */
function JointCard({ joint, isApplied }) {
  const status = isApplied && joint.status === "applied" ? "changed" : joint.status;
  const { evr_before: fit, evr_after: fitThen, cross_talk_before: talk, cross_talk_after: talkThen } = joint;
  return h(
    "section",
    { class: "card adapt-joint" },
    h("h2", {}, jointLabel(joint), h("span", { class: `tag ${TONES[joint.status]}` }, t(`adapt-joint-${status}`))),
    h(
      "dl",
      { class: "adapt-figures" },
      figure("turn", [turn(joint)], false),
      figure("evr", [percent(fit), percent(fitThen)], sign(fit, fitThen) > 0),
      figure("cross_talk", [percent(talk), percent(talkThen)], sign(talk, talkThen) < 0),
      figure("felt", [percent(joint.felt_change)], false),
      figure("dead_zone", [rate(joint.dead_zone_before), rate(joint.dead_zone_after)], false),
      figure("full", [rate(joint.full_before), rate(joint.full_after)], false),
    ),
    h("p", { class: "small reason" }, joint.reason),
  );
}

/**
 * A figure before and after; equal values are written once.
 * @param {string} name @param {string[]} values before and after @param {boolean} better
 */
function figure(name, values, better) {
  const [before, after] = values.length > 1 && values[0] !== values[1] ? values : [null, values[values.length - 1]];
  return h(
    "div",
    {},
    h("dt", { class: "quiet small" }, t(`adapt-row-${name}`)),
    h(
      "dd",
      { class: "number" },
      before !== null && [before, " → "],
      h("b", { class: better ? "change good" : undefined }, after),
    ),
  );
}

/** The angle that is applied, and the proposed one where that is larger. @param {JointView} joint */
function turn({ angle_applied_deg: applied, angle_proposed_deg: asked }) {
  if (asked === null || asked - applied < 0.05) return `${number(applied, 1)}°`;
  return t("adapt-row-turn-asked", { applied: number(applied, 1), asked: number(asked, 1) });
}

/**
 * 1: more is there after than before, −1: less, 0: alike, or not known.
 * @param {number | null} before @param {number | null} after
 */
function sign(before, after) {
  return before === null || after === null ? 0 : Math.sign(after - before);
}

/** @param {number | null} value */
function rate(value) {
  return ofFull(value, t("unit-rate"));
}
