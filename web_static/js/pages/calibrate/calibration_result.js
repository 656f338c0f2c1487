/**
 * The result of a calibration: a card for each joint, cross-talk, and all movements that were found.
 * @import { Discovery } from "types/api"
 * @import { JointResult } from "types/documents"
 * @import { CalibrationStore } from "./store.js"
 */
import { Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { DiscoveryCard } from "../../widgets/discovery_card.js";
import { number, percent } from "../../widgets/format.js";
import { repeatsWord, signalWord } from "../../widgets/grade_words.js";
import { jointLabel, jointWithin, labelsOf, sensorWithin } from "../../widgets/joint_words.js";
import { ScrollTable } from "../../widgets/scroll_table.js";
import { CheckTable, MapChoice } from "./map_choice.js";
import { MapOrigin } from "./map_origin.js";
import { Sitting } from "./sitting_card.js";

const STUDY = { low: 0.8, high: 0.9 }; // the paper's explained variance of PC1
const OWN = 0.75; // from here a cell is painted in full, with the text in the other colour
const WASH = 0.5; // strongest paint below that: dark text stays readable on it

/** @param {{store: CalibrationStore}} page */
export function CalibrationResult({ store }) {
  const { calibration, isRecording, missing, result, found, takeSuggestion, go } = store;
  const count = missing.value.length;
  if (isRecording.value)
    return h(Fragment, {}, title(t("calibrate-fitting")), h("div", { class: "working", role: "status" }));
  if (!result.value)
    return h(
      Fragment,
      {},
      title(t("result-missing")),
      h("p", { class: "lead" }, count ? t("result-missing-lead", { count }) : calibration.value.steps.at(-1)?.message),
      h(
        "div",
        { class: "spread" },
        missing.value.map((step) =>
          h("button", { key: step.id, type: "button", class: "btn", onClick: () => go(step.id) }, step.title),
        ),
      ),
    );
  const { joints, cross_talk: crossTalk, accepted } = result.value;
  return h(
    Fragment,
    {},
    title(t("result-title")),
    h("p", { class: "lead" }, count ? t("result-others-lead", { count }) : t("result-lead")),
    h(
      "div",
      { class: "stack" },
      h(
        "div",
        { class: "joint-cards" },
        joints.map((joint) => h(JointCard, { key: joint.name, store, joint, found: found.value })),
      ),
      crossTalk && h(CrossTalk, { joints, rows: crossTalk }),
    ),
    found.value &&
      h(DiscoveryCard, { found: found.value, labels: labelsOf(joints), onTake: accepted ? takeSuggestion : null }),
  );
}

/** @param {string} words */
function title(words) {
  return h("h1", { tabindex: -1 }, words);
}

/** @param {{store: CalibrationStore, joint: JointResult, found: Discovery | null}} card */
function JointCard({ store, joint, found }) {
  const { advice, step, evr, signal_to_noise: signal, repeatability } = joint;
  const label = jointLabel(joint);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, label, joint.has_to_be_repeated && h("span", { class: "tag bad" }, t("result-repeat"))),
    h(
      "div",
      { class: "evr", role: "img", "aria-label": t("result-bar", { joint: label, percent: percent(evr) }) },
      h("span", { style: `width:${(evr ?? 0) * 100}%` }),
      h("em", { style: `left:${STUDY.low * 100}%;width:${(STUDY.high - STUDY.low) * 100}%` }),
    ),
    evr !== null &&
      h(
        "div",
        { class: "row quiet small figures" },
        h("span", {}, t("result-evr", { percent: percent(evr) })),
        signal !== null && h("span", {}, t("result-signal", { word: signalWord(signal) })),
        repeatability !== null && h("span", {}, t("result-repeats", { word: repeatsWord(repeatability) })),
      ),
    joint.map !== null && h(MapOrigin, { joint, found }),
    advice !== null && h("p", { class: "small reason" }, advice),
    step &&
      h(
        "button",
        {
          type: "button",
          class: `btn small${advice === null ? " bare" : ""}`,
          "aria-label": t("result-again-label", { joint: label }),
          onClick: () => store.start(step),
        },
        t("result-again"),
      ),
    h(Sitting, { joint, onSay: (isRight) => store.saySitting(joint.name, isRight) }),
    h(MapChoice, { joint, onChoose: (map) => store.chooseMap(joint.name, map) }),
    evr !== null && h(Details, { joint }),
  );
}

/** The numbers behind the words. @param {{joint: JointResult}} details */
function Details({ joint: { evr, signal_to_noise: signal, repeatability, guided, prior } }) {
  /** @param {string} words */
  const line = (words) => h("p", { class: "small" }, words);
  return h(
    "details",
    { class: "maps" },
    h("summary", {}, t("result-details")),
    line(t("result-details-evr", { percent: percent(evr) })),
    signal !== null && line(t("result-details-signal", { value: number(signal, 0) })),
    repeatability !== null && line(t("result-details-repeats", { percent: percent(repeatability) })),
    guided && !guided.offered && [line(t("result-maps-kept-guided")), h(CheckTable, { kind: "guided", map: guided })],
    prior && !prior.offered && [line(t("result-maps-kept-prior")), h(CheckTable, { kind: "prior", map: prior })],
    guided && line(t("result-maps-details")),
  );
}

/**
 * A row per gesture that was asked for, a column per joint that answered.
 * @param {{joints: JointResult[], rows: number[][]}} card
 */
function CrossTalk({ joints, rows }) {
  const asked = joints.slice(0, rows.length);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("result-cross")),
    h("p", { class: "quiet small" }, t("result-cross-lead")),
    h(
      ScrollTable,
      { label: t("result-cross"), kind: "heat" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td", {}),
          asked.map((joint) => h("th", { key: joint.name, scope: "col" }, jointLabel(joint))),
        ),
      ),
      h(
        "tbody",
        {},
        rows.map((row, i) =>
          h(
            "tr",
            { key: asked[i].name },
            h("th", { scope: "row" }, t("result-cross-asked", { joint: jointWithin(asked[i]) })),
            row.map(cell),
          ),
        ),
      ),
    ),
  );
}

/** @param {number} value */
function cell(value) {
  const isOwn = value >= OWN;
  const share = isOwn ? 1 : WASH * Math.min(1, Math.max(0, value));
  return h(
    "td",
    { class: isOwn ? "strong" : undefined, style: `--share:${Math.round(share * 100)}%` },
    number(value, 2),
  );
}

/** In one sentence which sensors were left out, and why. @param {Record<string, string>} leftOut */
export function leftOutWords(leftOut) {
  const which = Object.entries(leftOut).map(([name, why]) => `${sensorWithin(name)} (${why})`);
  if (!which.length) return t("result-left-out-none");
  return t("result-left-out", { count: which.length, which: which.join(", ") });
}
