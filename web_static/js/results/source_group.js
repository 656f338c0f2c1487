/**
 * Groups of trials by their source, such as worn or simulated; a curve or comparison has one group only.
 * @import { ComponentChildren } from "../preact.js"
 * @import { SourceView } from "types/api"
 * @typedef {SourceView["group"]} SourceGroup
 * @typedef {{source: Pick<SourceView, "group">}} WithSource a trial, as far as its group goes
 */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { Field, Selection } from "../widgets/fields.js";

/** @type {SourceGroup[]} */
export const GROUPS = ["worn", "camera", "phones", "slimevr", "bluetooth", "brainflow", "lsl", "simulated", "unknown"];

/** @param {WithSource} trial */
export const groupOf = ({ source: { group } }) => group;

/** The group that is shown first: worn trials where there are some, else that of the newest trial. @param {WithSource[]} trials at least one */
export function firstGroup(trials) {
  const groups = trials.map(groupOf);
  return groups.includes("worn") ? "worn" : groups[groups.length - 1];
}

/** A sign for trials of another source than a worn shirt. @param {{group: SourceGroup}} mark */
export function GroupMark({ group }) {
  return group === "worn" ? null : h("span", { class: "tag source-mark" }, t(`source-group-${group}`));
}

/**
 * The cell of a table that names the source of a trial or test.
 * @param {{of: {source: Pick<SourceView, "group" | "description">}, children?: ComponentChildren}} cell
 *   children: what stands below it
 */
export function SourceCell({ of, children }) {
  const group = groupOf(of);
  const mark = group === "worn" ? t("source-group-worn") : h(GroupMark, { group });
  return h("td", { title: of.source.description }, mark, children);
}

/**
 * Which trials are looked at; nothing where there is only one group.
 * @param {{trials: (WithSource & {kept: boolean})[], chosen: SourceGroup, onChange: (group: SourceGroup) => void}} choice
 */
export function GroupChoice({ trials, chosen, onChange }) {
  const present = GROUPS.filter((group) => group === chosen || trials.some((trial) => groupOf(trial) === group));
  if (present.length < 2) return null;
  const options = present.map((group) => {
    const count = trials.filter((trial) => trial.kept && groupOf(trial) === group).length;
    return { value: group, label: t("source-group-count", { group: t(`source-group-${group}`), count }) };
  });
  const choose = (/** @type {string} */ group) => onChange(/** @type {SourceGroup} */ (group));
  return h(Field, { label: t("source-group") }, h(Selection, { options, chosen, onChange: choose }));
}
