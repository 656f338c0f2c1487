/**
 * How a parameter set differs from the one that was practised last, in words.
 * @import { BoundGestures, FieldDifference, GestureDifference, NamedGesture, Summary } from "types/api"
 */
import { t } from "../../texts.js";
import { anyOf, number, significant } from "../../widgets/format.js";
import { TOGETHER } from "../../widgets/gestures.js";
import { labelWords } from "../../widgets/joint_words.js";
import { SPEEDS } from "../../widgets/speed_rows.js";

const MOST_DIGITS = 9;
const GAIN_DIGITS = 6; // significant
const DIGITS = { cutoff: 1, cruise_time: 0, turn_cruise_time: 1 };

/** A sentence. @param {Summary["differences"][number]} difference */
export function differenceWords(difference) {
  switch (difference.kind) {
    case "field":
      return fieldWords(difference);
    case "gesture":
      return gestureWords(difference);
    case "binding": {
      const { control, before, now } = difference;
      return change(t(`control-${control}`), boundWords(control, before), boundWords(control, now));
    }
  }
}

/** @param {FieldDifference} difference */
function fieldWords({ name, before, now }) {
  if (name === "title") return t("differs-title", { before: String(before), now: String(now) });
  if (name === "profile" || name === "order") return t(`differs-${name}`);
  if (name === "mode_u1" || name === "mode_u2") {
    const how = `how-${name.slice(-2)}`;
    return change(t(how), t(`differs-${how}-${before}`), t(`differs-${how}-${now}`));
  }
  const what = t(`speed-${name}`);
  const { unit, factor, digits } = SPEEDS.find((speed) => speed.name === name) ?? {
    unit: name,
    factor: 1,
    digits: DIGITS[/** @type {keyof DIGITS} */ (name)],
  };
  const [old, fresh] = distinct(Number(before) * factor, Number(now) * factor, digits);
  return change(what, old, `${fresh} ${t(`unit-${unit}`)}`);
}

/** @param {GestureDifference} difference */
function gestureWords({ gesture, feature, name, before, now }) {
  const label = named(gesture);
  if (name === "feature") return change(label, t(featureKey(before)), t(featureKey(now)));
  if (name !== "dead_zone" && name !== "full") return t(`differs-gesture-${name}`, { gesture: label });
  const [old, fresh] = distinct(100 * Number(before), 100 * Number(now), 0);
  const key = name === "full" ? "differs-gesture-full" : "differs-gesture-from";
  return t(key, { gesture: label, before: old, now: t(`handle-${feature}`, { value: fresh }) });
}

/** @param {string | number | null} feature */
function featureKey(feature) {
  return feature === "rate" ? "differs-gesture-moving" : "differs-gesture-holding";
}

/** @param {string} control @param {BoundGestures[]} bindings */
function boundWords(control, bindings) {
  const parts = bindings.map(({ gestures, gain }) => {
    const names = gestures.map(named);
    const words = (control === "stop" ? names.join(TOGETHER) : anyOf(names)) || t("differs-nothing");
    return t("differs-gain", { gestures: words, gain: significant(gain, GAIN_DIGITS) });
  });
  return parts.join("; ") || t("differs-nothing");
}

/** @param {NamedGesture} gesture */
function named({ joint: label, direction }) {
  const joint = labelWords(label);
  return direction === 1 ? joint : t("gesture-back", { joint });
}

/** @param {string} what @param {string} before @param {string} now */
function change(what, before, now) {
  return t("differs-change", { what, before, now });
}

/**
 * Two numbers, with at least `digits` digits and as many as show their difference.
 * @param {number} before @param {number} now @param {number} digits
 */
function distinct(before, now, digits) {
  while (digits < MOST_DIGITS && number(before, digits) === number(now, digits)) digits += 1;
  return [number(before, digits), number(now, digits)];
}
