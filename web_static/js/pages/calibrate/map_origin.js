/**
 * Where the calibration of a joint comes from, what is expected of it, and how the shirt sits there.
 * @import { FoundGesture } from "types/api"
 * @import { Arrangement, JointResult } from "types/documents"
 */
import { t } from "../../texts.js";
import { falseWords } from "../../widgets/discovery_card.js";
import { h, put, s } from "../../widgets/dom.js";
import { number } from "../../widgets/format.js";
import { expectedWords } from "./expected_words.js";

const SIZE = 96; // px of the picture
const ROUND = 34; // px, radius of the ring of sensors
const TURN = 22; // px, radius of the arrow inside

/** @param {JointResult} joint with a map */
export function whereFrom({ name, map, prior }) {
  const others = map === "prior" ? prior : null;
  const origin = others ? (others.repetitions ? "both" : "others") : "own";
  return h(
    "div",
    { class: "origin small" },
    h("p", { class: "quiet" }, t(`result.from.${origin}`)),
    others && !others.repetitions && h("p", {}, t("result.from.others.lead", { count: others.people })),
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
  const { hit_rate: hits, hit_at_least: least, false_per_minute: falsely, counted_at_most: most } = gesture?.prediction ?? {};
  const sentences = [
    typeof hits === "number" &&
      h("p", {}, t("result.expected.own.hits", { value: number(100 * hits, 0), bound: number(100 * (least ?? 0), 0) })),
    typeof falsely === "number" &&
      typeof most === "number" &&
      h("p", {}, t("result.expected.own.false", { value: falseWords({ false_per_minute: falsely }), bound: number(most, 0) })),
  ];
  return sentences.some(Boolean) ? sentences : [h("p", {}, t("result.expected.none"))];
}

/** How each ring of sensors sits otherwise than on other people, with a picture. @param {string} joint its label @param {Record<string, Arrangement>} rings */
export function sittingCard(joint, rings) {
  return Object.values(rings).map(({ shift, mirrored, sensors }) =>
    h(
      "div",
      { class: "sits" },
      shift > 0 && picture(joint, shift, sensors),
      h(
        "div",
        { class: "small" },
        shift > 0 && h("p", {}, t("result.sits.shifted", { joint: joint.toLowerCase(), count: back(shift, sensors), sensors })),
        mirrored && h("p", {}, t("result.sits.mirrored", { joint: joint.toLowerCase() })),
        h("p", { class: "quiet" }, t("result.sits.lead")),
      ),
    ),
  );
}

/** By how many sensors to turn the shirt, the shorter way round. @param {number} shift @param {number} sensors */
function back(shift, sensors) {
  return Math.min(shift, sensors - shift);
}

/** The limb from above with its ring of sensors, and the way to turn it back. @param {string} joint @param {number} shift @param {number} sensors */
function picture(joint, shift, sensors) {
  const middle = SIZE / 2;
  const isForwards = sensors - shift < shift;
  const count = back(shift, sensors);
  /** @param {number} place @param {number} radius */
  const at = (place, radius) => {
    const angle = (2 * Math.PI * place) / sensors - Math.PI / 2;
    return [middle + radius * Math.cos(angle), middle + radius * Math.sin(angle)];
  };
  const [from, to] = isForwards ? [0, count] : [count, 0];
  const [x0, y0] = at(from, TURN);
  const [x1, y1] = at(to, TURN);
  const [tipX, tipY] = at(to + (isForwards ? -0.35 : 0.35), TURN - 7);
  return s(
    "svg",
    { class: "ring", viewBox: `0 0 ${SIZE} ${SIZE}`, width: SIZE, height: SIZE, role: "img", "aria-label": t("result.sits.picture", { joint: joint.toLowerCase(), count, sensors }) },
    s("circle", { cx: middle, cy: middle, r: ROUND, class: "limb" }),
    Array.from({ length: sensors }, (_, place) => {
      const [cx, cy] = at(place, ROUND);
      return s("circle", { cx, cy, r: place === 0 || place === count ? 6 : 4, class: place === from ? "sensor first" : "sensor" });
    }),
    s("path", { d: `M ${x0} ${y0} A ${TURN} ${TURN} 0 0 ${isForwards ? 1 : 0} ${x1} ${y1} L ${tipX} ${tipY}`, class: "turn" }),
  );
}
