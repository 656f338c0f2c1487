/**
 * The result of a calibration: a card per joint, cross-talk, left-out sensors.
 * @import { OnSitting } from "./sitting_card.js"
 * @import { CalibrationResult, JointResult } from "types/documents"
 * @typedef {(step: string) => void} OnRepeat
 * @typedef {(joint: string, map: "pca" | "guided" | "prior") => void} OnMap
 */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { number, percent } from "../../widgets/format.js";
import { jointLabel, jointWithin, sensorWithin } from "../../widgets/joint_words.js";
import { repeatsWord, signalWord } from "../../widgets/grade_words.js";
import { scrollTable } from "../../widgets/scroll_table.js";
import { checkTables, mapChoice } from "./map_choice.js";
import { whereFrom } from "./map_origin.js";
import { sittingCard } from "./sitting_card.js";

const STUDY = { low: 0.8, high: 0.9 }; // the paper's explained variance of PC1
const OWN = 0.75; // from here a cell is painted in full, with the text in the other colour
const WASH = 0.5; // strongest paint below that: dark text stays readable on it

/** @param {CalibrationResult} result @param {OnRepeat} onRepeat @param {OnMap} onMap @param {OnSitting} onSitting */
export function resultView(result, onRepeat, onMap, onSitting) {
  return h(
    "div",
    { class: "stack" },
    h(
      "div",
      { class: "joint-cards" },
      result.joints.map((joint) => jointCard(joint, onRepeat, onMap, onSitting)),
    ),
    result.cross_talk && crossTalk(result.joints, result.cross_talk),
  );
}

/** @param {JointResult} joint @param {OnRepeat} onRepeat @param {OnMap} onMap @param {OnSitting} onSitting */
function jointCard(joint, onRepeat, onMap, onSitting) {
  const { advice, step } = joint;
  const evr = percent(joint.evr);
  const label = jointLabel(joint);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, label, joint.has_to_be_repeated && h("span", { class: "tag bad" }, t("result-repeat"))),
    h(
      "div",
      { class: "evr", role: "img", "aria-label": t("result-bar", { joint: label, percent: evr }) },
      h("span", { style: `width:${(joint.evr ?? 0) * 100}%` }),
      h("em", { style: `left:${STUDY.low * 100}%;width:${(STUDY.high - STUDY.low) * 100}%` }),
    ),
    joint.evr !== null &&
      h(
        "div",
        { class: "row quiet small figures" },
        h("span", {}, t("result-evr", { percent: evr })),
        joint.signal_to_noise !== null &&
          h("span", {}, t("result-signal", { word: signalWord(joint.signal_to_noise) })),
        joint.repeatability !== null && h("span", {}, t("result-repeats", { word: repeatsWord(joint.repeatability) })),
      ),
    joint.map !== null && whereFrom(joint),
    advice !== null && h("p", { class: "small reason" }, advice),
    step &&
      h(
        "button",
        {
          type: "button",
          class: `btn small${advice === null ? " bare" : ""}`,
          "aria-label": t("result-again-label", { joint: label }),
          onclick: () => onRepeat(step),
        },
        t("result-again"),
      ),
    sittingCard(joint, onSitting),
    mapChoice(joint, onMap),
    joint.evr !== null && details(joint),
  );
}

/** The numbers behind the words. @param {JointResult} joint */
function details({ evr, signal_to_noise: signal, repeatability, guided, prior }) {
  return h(
    "details",
    { class: "maps" },
    h("summary", {}, t("result-details")),
    h("p", { class: "small" }, t("result-details-evr", { percent: percent(evr) })),
    signal !== null && h("p", { class: "small" }, t("result-details-signal", { value: number(signal, 0) })),
    repeatability !== null &&
      h("p", { class: "small" }, t("result-details-repeats", { percent: percent(repeatability) })),
    guided &&
      !guided.offered && [
        h("p", { class: "small" }, t("result-maps-kept-guided")),
        checkTables({ guided, prior: null }),
      ],
    prior &&
      !prior.offered && [h("p", { class: "small" }, t("result-maps-kept-prior")), checkTables({ guided: null, prior })],
    guided && h("p", { class: "small" }, t("result-maps-details")),
  );
}

/** A row per gesture that was asked for, a column per joint that answered. @param {JointResult[]} joints @param {number[][]} rows */
function crossTalk(joints, rows) {
  const asked = joints.slice(0, rows.length);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("result-cross")),
    h("p", { class: "quiet small" }, t("result-cross-lead")),
    scrollTable(
      t("result-cross"),
      "heat",
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td", {}),
          asked.map((joint) => h("th", { scope: "col" }, jointLabel(joint))),
        ),
      ),
      h(
        "tbody",
        {},
        rows.map((row, i) =>
          h(
            "tr",
            {},
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
  return h("td", { class: isOwn ? "strong" : null, style: `--share:${Math.round(share * 100)}%` }, number(value, 2));
}

/** In one sentence which sensors were left out, and why. @param {Record<string, string>} leftOut */
export function leftOutWords(leftOut) {
  const which = Object.entries(leftOut).map(([name, why]) => `${sensorWithin(name)} (${why})`);
  if (!which.length) return t("result-left-out-none");
  return t("result-left-out", { count: which.length, which: which.join(", ") });
}
