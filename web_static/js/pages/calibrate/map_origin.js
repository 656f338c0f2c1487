/**
 * Where the calibration of a joint comes from, and what is expected of it.
 * @import { FoundGesture } from "types/api"
 * @import { JointResult } from "types/documents"
 */
import { t } from "../../texts.js";
import { falseWords } from "../../widgets/discovery_card.js";
import { h, put } from "../../widgets/dom.js";
import { number } from "../../widgets/format.js";
import { expectedWords } from "./expected_words.js";

/** @param {JointResult} joint with a map */
export function whereFrom({ name, map, prior }) {
  const others = map === "prior" ? prior : null;
  const origin = others ? (others.repetitions ? "both" : "others") : "own";
  return h(
    "div",
    { class: "origin small" },
    h("p", { class: "quiet" }, t(`result-from-${origin}`)),
    others && !others.repetitions && h("p", {}, t("result-from-others-lead", { count: others.people })),
    others && expectedWords(others).map((words) => h("p", {}, words)),
    !others && h("div", { class: "expected", "data-joint": name }),
  );
}

/** What is expected of each joint that drives by own movement, once it is known. @param {Element} page @param {FoundGesture[]} gestures */
export function showExpected(page, gestures) {
  for (const place of page.querySelectorAll(".expected")) {
    const joint = place.getAttribute("data-joint");
    put(place, expectedOfOwn(gestures.find((one) => one.joint === joint && one.direction === 1)));
  }
}

/** @param {FoundGesture | undefined} gesture */
function expectedOfOwn(gesture) {
  const {
    hit_rate: hits,
    hit_at_least: least,
    false_per_minute: falsely,
    counted_at_most: most,
  } = gesture?.prediction ?? {};
  const sentences = [
    typeof hits === "number" &&
      h("p", {}, t("result-expected-own-hits", { value: number(100 * hits, 0), bound: number(100 * (least ?? 0), 0) })),
    typeof falsely === "number" &&
      typeof most === "number" &&
      h(
        "p",
        {},
        t("result-expected-own-false", { value: falseWords({ false_per_minute: falsely }), bound: number(most, 0) }),
      ),
  ];
  return sentences.some(Boolean) ? sentences : [h("p", {}, t("result-expected-none"))];
}
