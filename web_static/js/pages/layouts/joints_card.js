/**
 * The joints of a layout: what each is called, and joints proposed by what moves together.
 * @import { JointGroupsView } from "types/api"
 * @import { LayoutStore } from "./store.js"
 * @import { Joint } from "./layout_document.js"
 */
import { failureWords } from "../../api.js";
import { h, useRef, useSignal } from "../../preact.js";
import { REFERENCE, textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Selection } from "../../widgets/fields.js";
import { allOf, number } from "../../widgets/format.js";
import { jointLabel, sensorName } from "../../widgets/joint_words.js";
import { useUntilGone } from "../../widgets/made.js";
import { changed } from "./channel_form.js";
import {
  channelCounts,
  chosenJoint,
  NEW_JOINT,
  usualJoint,
  withGroups,
  withJointLabel,
  withJointNamed,
} from "./layout_document.js";

const SECONDS = 20; // of free movement, from which joints are proposed

/** @param {{store: LayoutStore}} card */
export function JointsCard({ store }) {
  const layout = store.draft.value;
  const counts = channelCounts(layout);
  return h(
    "section",
    { class: "card stack", "data-card": "joints" },
    h("h2", {}, t("layouts-joints")),
    h(
      "div",
      { class: "stack", role: "list" },
      // By their places: a joint that gets another name keeps its row, and the row the focus.
      layout.joints.map((joint, i) => h(JointRow, { key: i, store, joint, count: counts.get(joint.name) ?? 0 })),
    ),
    h(Proposal, { store }),
  );
}

/** @param {{store: LayoutStore, joint: Joint, count: number}} row count: of its channels */
function JointRow({ store: { discards, change }, joint, count }) {
  const words = jointLabel(joint);
  const isUsual = REFERENCE.usual_joints.includes(joint.name);
  /** @param {string} name */
  const rename = (name) => change((now) => withJointNamed(now, joint.name, chosenJoint(now, name)));
  return h(
    "div",
    { class: "layout-joint", role: "listitem" },
    h(Selection, {
      "aria-label": t("layouts-joint-row-label", { joint: words }),
      options: [
        ...REFERENCE.usual_joints.map((name) => ({ value: name, label: jointLabel(usualJoint(name)) })),
        { value: isUsual ? NEW_JOINT : joint.name, label: isUsual ? t("layouts-joint-other") : words },
      ],
      chosen: joint.name,
      onChange: rename,
    }),
    !isUsual &&
      h("input", {
        key: `${joint.name} ${discards.value}`,
        type: "text",
        "aria-label": t("layouts-joint-name-label", { joint: words }),
        defaultValue: joint.label,
        required: true,
        ...textLimits("Joint", "label"),
        autocomplete: "off",
        onChange: changed((label) => change((now) => withJointLabel(now, joint.name, label))),
      }),
    h("span", { class: "quiet small" }, t("layouts-channels", { count })),
  );
}

/** Watches some seconds of free movement, and shows the groups of channels that moved together. @param {{store: LayoutStore}} card */
function Proposal({ store: { app, left, draft, isLive, change } }) {
  const remaining = useSignal(0); // s of movement that are still watched; 0: none
  const found = useSignal(/** @type {JointGroupsView | null} */ (null));
  const problem = useSignal("");
  const gone = useRef(/** @type {AbortSignal | null} */ (null));
  const timer = useRef(0);
  useUntilGone(left, (signal) => {
    gone.current = signal;
    signal.addEventListener("abort", () => clearInterval(timer.current));
  });
  const ask = async () => {
    try {
      const answer = await app.api.get(`/layouts/proposal?seconds=${SECONDS}`);
      if (!gone.current?.aborted) found.value = answer;
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  const count = () => {
    remaining.value -= 1;
    if (remaining.value > 0) return;
    clearInterval(timer.current);
    ask();
  };
  const start = () => {
    found.value = null;
    problem.value = "";
    remaining.value = SECONDS;
    clearInterval(timer.current);
    timer.current = setInterval(count, 1000);
  };
  const stop = () => {
    clearInterval(timer.current);
    remaining.value = 0;
  };
  const use = () => {
    const groups = found.value?.groups ?? [];
    change((now) => withGroups(now, groups, (which) => t("layouts-group", { number: which })));
    found.value = null;
  };
  if (!isLive.value) return h("p", { class: "quiet small" }, t("layouts-propose-not-live"));
  const { channels } = draft.value;
  /** @param {number[]} indices */
  const names = (indices) => allOf(indices.flatMap((i) => (channels[i] ? [sensorName(channels[i].name)] : [])));
  const isWatching = remaining.value > 0;
  return h(
    "div",
    { class: "stack" },
    h("p", { class: "quiet small" }, t("layouts-propose-hint", { seconds: SECONDS })),
    h("p", { class: "small", role: "status" }, isWatching ? t("layouts-propose-move") : (found.value?.message ?? "")),
    isWatching && h("p", { class: "big number", "aria-hidden": "true" }, number(remaining.value, 0)),
    h("p", { class: "problem", role: "alert" }, problem.value),
    found.value &&
      h(
        "ol",
        { class: "small" },
        found.value.groups.map((group) => h("li", { key: group[0] }, names(group))),
      ),
    found.value !== null &&
      found.value.still.length > 0 &&
      h("p", { class: "small" }, t("layouts-propose-still", { names: names(found.value.still) })),
    h(
      "div",
      { class: "spread" },
      h(
        "button",
        { type: "button", class: "btn", onClick: isWatching ? stop : start },
        t(isWatching ? "cancel" : "layouts-propose"),
      ),
      h(
        "button",
        { type: "button", class: "btn", hidden: !found.value?.groups.length, onClick: use },
        t("layouts-propose-use"),
      ),
    ),
  );
}
