/**
 * All gestures that were found, best first, with their numbers, and the suggestion with a tap that takes it.
 * @import { Discovery, FoundGesture, Prediction } from "types/api"
 * @typedef {typeof NUMBERS[number]} NumberName
 * @typedef {(gesture: FoundGesture) => string} Words
 */
import { h, useLayoutEffect, useSignal } from "../preact.js";
import { t } from "../texts.js";
import { number, percent } from "./format.js";
import { gestureWords } from "./gestures.js";
import { repeatsWord, signalWord } from "./grade_words.js";
import { ScrollTable } from "./scroll_table.js";

const NUMBERS = /** @type {const} */ (["signal_to_noise", "repeatability", "cross_talk", "effort"]);
const LEAST_SAID = 0.1; // false activations a minute: a forecast is no finer than that

/** How each number is written. @type {Record<NumberName, (value: number | null) => string>} */
const WRITTEN = {
  signal_to_noise: (value) => (value === null ? number(value, 0) : signalWord(value)),
  repeatability: (value) => (value === null ? percent(value) : repeatsWord(value)),
  cross_talk: percent,
  effort: percent,
};

/**
 * @param {object} card
 * @param {Discovery} card.found @param {Record<string, string>} card.labels joint name -> label
 * @param {(() => void) | null} card.onTake what the tap on the suggestion does; null where it cannot be taken yet
 */
export function DiscoveryCard({ found, labels, onTake }) {
  /** @type {Map<string, string>} what each gesture does in the suggestion */
  const controls = new Map();
  for (const { control, gestures } of found.suggestion.bindings)
    if (control !== "stop") gestures.forEach((name) => controls.set(name, control));
  /** @type {Words} */
  const words = (gesture) => gestureWords({ ...gesture, feature: "rate" }, labels);
  return h(
    "section",
    { class: "card discovery" },
    h("h2", {}, t("found-title")),
    found.message && h("p", { class: "small reason" }, found.message),
    h(
      "div",
      { class: "suggested-block" },
      h("p", {}, found.suggestion.reason),
      onTake
        ? h("button", { type: "button", class: "btn", onClick: onTake }, t("found-take"))
        : h("p", { class: "quiet small" }, t("found-take-later")),
    ),
    h("p", { class: "quiet small" }, t("found-lead")),
    table(found.gestures, controls, words),
    numbers(found.gestures, words),
    Object.entries(found.not_found).map(([joint, reason]) =>
      h("p", { key: joint, class: "small reason" }, `${labels[joint] ?? joint.replaceAll("_", " ")}: ${reason}`),
    ),
    checks(
      found.gestures.flatMap(({ prediction, ...gesture }) =>
        controls.has(gesture.name) && prediction ? [{ ...gesture, prediction }] : [],
      ),
      words,
    ),
  );
}

/**
 * The card of the calibration in use, asked for once; nothing while nothing is calibrated: the page says what is missing.
 * @param {{api: import("../api.js").Api, labels: Record<string, string>, onTake: () => void}} card
 */
export function FoundNow({ api, labels, onTake }) {
  const found = useSignal(/** @type {Discovery | null} */ (null));
  useLayoutEffect(() => {
    api.get("/calibration/gestures").then(
      (answer) => (found.value = answer),
      () => {},
    );
  }, []);
  return found.value && h(DiscoveryCard, { found: found.value, labels, onTake });
}

/** @param {FoundGesture[]} gestures @param {Map<string, string>} controls @param {Words} words */
function table(gestures, controls, words) {
  /** @param {string} name */
  const head = (name) => h("th", { key: name, scope: "col", title: t(`found-means-${name}`) }, t(`found-${name}`));
  /** @param {FoundGesture} gesture */
  const row = (gesture) =>
    h(
      "tr",
      { key: gesture.name, class: controls.has(gesture.name) ? "chosen" : undefined },
      h(
        "th",
        { scope: "row" },
        words(gesture),
        controls.has(gesture.name) && h("span", { class: "tag" }, t(`control-${controls.get(gesture.name)}`)),
      ),
      h("td", { class: "score" }, scoreBar(gesture.score)),
      NUMBERS.map((name) => numberCell(gesture, name)),
      h("td", {}, falseWords(gesture.prediction)),
      h("td", {}, percent(gesture.prediction?.hit_rate)),
    );
  return h(
    ScrollTable,
    { label: t("found-title"), kind: "measures" },
    h(
      "thead",
      {},
      h("tr", {}, h("th", { scope: "col" }, t("found-gesture")), ["score", ...NUMBERS, "false", "hits"].map(head)),
    ),
    h("tbody", {}, gestures.map(row)),
  );
}

/** The numbers behind the words of the table. @param {FoundGesture[]} gestures @param {Words} words */
function numbers(gestures, words) {
  /** @param {FoundGesture} gesture */
  const line = (gesture) =>
    t("found-details-one", {
      gesture: words(gesture),
      signal: number(gesture.signal_to_noise, 0),
      repeats: percent(gesture.repeatability),
    });
  return h(
    "details",
    {},
    h("summary", {}, t("found-details")),
    h(
      "ul",
      { class: "small" },
      gestures.map((gesture) => h("li", { key: gesture.name }, line(gesture))),
    ),
  );
}

/** @param {FoundGesture} gesture @param {NumberName} name */
function numberCell(gesture, name) {
  const written = WRITTEN[name](gesture[name]);
  return h("td", { key: name }, gesture.weakest === name ? h("mark", { title: t("found-weakest") }, written) : written);
}

/** @param {number} score 0..1 */
function scoreBar(score) {
  const value = Math.round(100 * score);
  return [
    h("span", { class: "score-bar", "aria-hidden": "true" }, h("i", { style: `width:${value}%` })),
    h("b", {}, value),
  ];
}

/** @param {{false_per_minute: number | null} | null} prediction */
export function falseWords(prediction) {
  const rate = prediction?.false_per_minute;
  if (typeof rate !== "number" || !Number.isFinite(rate)) return number(null, 1);
  return rate < LEAST_SAID ? t("found-less", { value: LEAST_SAID }) : number(rate, 1);
}

/**
 * For each gesture, the prediction from one part of the recordings beside the count in the other part.
 * @param {(FoundGesture & {prediction: Prediction})[]} gestures @param {Words} words
 */
function checks(gestures, words) {
  /** @param {FoundGesture & {prediction: Prediction}} gesture */
  const line = (gesture) => {
    const { rest_check: rest, hit_check: hits, rest_seconds, counted_at_most, hit_at_least } = gesture.prediction;
    return h(
      "li",
      { key: gesture.name },
      h("b", {}, words(gesture)),
      ": ",
      rest &&
        t("found-check-rest", {
          predicted: falseWords({ false_per_minute: rest.predicted }),
          counted: rest.counted,
          seconds: number(rest.seconds, 0),
          all: number(rest_seconds, 0),
          bound: number(counted_at_most, 0),
        }),
      " ",
      hits &&
        t("found-check-hits", {
          predicted: percent(hits.predicted),
          counted: hits.counted,
          all: hits.repetitions,
          bound: percent(hit_at_least),
        }),
    );
  };
  return (
    gestures.length > 0 &&
    h(
      "details",
      {},
      h("summary", {}, t("found-check")),
      h("p", { class: "quiet small" }, t("found-check-lead")),
      h("ul", { class: "small" }, gestures.map(line)),
    )
  );
}
