/**
 * Gestures in words, and found by what they are.
 * @import { Joint } from "types/api"
 */
import { t } from "../texts.js";

/** @param {{layout: {joints: Joint[]}, joints: {name?: unknown}[]}} profile @returns {Record<string, string>} joint name -> label, of the joints that have a map */
export function jointLabels(profile) {
  const labels = Object.fromEntries(profile.layout.joints.map(({ name, label }) => [name, label]));
  const names = profile.joints.map(({ name }) => String(name));
  return Object.fromEntries(names.map((name) => [name, labels[name] ?? name]));
}

/** @param {{joint: string, direction: number, feature: string}} gesture @param {Record<string, string>} labels */
export function gestureWords({ joint, direction, feature }, labels) {
  const words = direction < 0 ? t("gesture-back", { joint: labels[joint] }) : labels[joint];
  return feature === "displacement" ? t("gesture-held", { joint: words }) : words;
}

/**
 * @template {{joint: string, direction: number}} Gesture
 * @param {Gesture[]} gestures @param {string} joint @param {number} direction
 */
export function gestureFor(gestures, joint, direction) {
  return gestures.find((gesture) => gesture.joint === joint && gesture.direction === direction);
}

/** A name for a gesture that does not exist yet. @param {string} joint @param {number} direction */
export function newGestureName(joint, direction) {
  return direction > 0 ? joint : `${joint}_back`;
}

/** A sentence of the server with the joints called by their labels. @param {string} sentence @param {Record<string, string>} labels */
export function withLabels(sentence, labels) {
  return Object.entries(labels).reduce(
    (words, [name, label]) => words.replaceAll(`'${name}'`, name).replaceAll(name, label.toLowerCase()),
    sentence,
  );
}
