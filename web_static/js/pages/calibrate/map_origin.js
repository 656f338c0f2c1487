/**
 * Where the calibration of a joint comes from, and what is expected of it.
 * @import { Discovery, FoundGesture } from "types/api"
 * @import { JointResult } from "types/documents"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { falseWords } from "../../widgets/discovery_card.js";
import { number } from "../../widgets/format.js";
import { expectedWords } from "./expected_words.js";

/** @param {{joint: JointResult, found: Discovery | null}} origin joint: with a map; found: null until it is known */
export function MapOrigin({ joint: { name, map, prior }, found }) {
  const others = map === "prior" ? prior : null;
  const origin = others ? (others.repetitions ? "both" : "others") : "own";
  const gesture = found?.gestures.find((one) => one.joint === name && one.direction === 1);
  const expected = others ? expectedWords(others) : found ? expectedOfOwn(gesture) : [];
  return h(
    "div",
    { class: "origin small" },
    h("p", { class: "quiet" }, t(`result-from-${origin}`)),
    others && !others.repetitions && h("p", {}, t("result-from-others-lead", { count: others.people })),
    expected.map((words) => h("p", { key: words }, words)),
  );
}

/** What is expected of a joint that drives by own movement, in sentences. @param {FoundGesture | undefined} gesture */
function expectedOfOwn(gesture) {
  const {
    hit_rate: hits,
    hit_at_least: least,
    false_per_minute: falsely,
    counted_at_most: most,
  } = gesture?.prediction ?? {};
  const sentences = [];
  if (typeof hits === "number")
    sentences.push(
      t("result-expected-own-hits", { value: number(100 * hits, 0), bound: number(100 * (least ?? 0), 0) }),
    );
  if (typeof falsely === "number" && typeof most === "number") {
    const value = falseWords({ false_per_minute: falsely });
    sentences.push(t("result-expected-own-false", { value, bound: number(most, 0) }));
  }
  return sentences.length ? sentences : [t("result-expected-none")];
}
