/**
 * Gestures in words, and found by what they are.
 * @import { Joint } from "types/api"
 */
import { t } from "../texts.js";
import { jointLabel, jointWithin } from "./joint_words.js";

/** @param {{layout: {joints: Joint[]}, joints: {name?: unknown}[]}} profile @returns {Record<string, string>} joint name -> label, of the joints that have a map */
export function jointLabels(profile) {
  const labels = Object.fromEntries(profile.layout.joints.map(({ name, label }) => [name, label]));
  const names = profile.joints.map(({ name }) => String(name));
  return Object.fromEntries(names.map((name) => [name, jointLabel({ name, label: labels[name] ?? name })]));
}

/** Between gestures that are made at once. */
export const TOGETHER = " + ";

/** @typedef {{joint: string, direction: number, feature: string}} Gesture */

/** A gesture alone, or at the beginning. @param {Gesture} gesture @param {Record<string, string>} labels of the joints */
export function gestureWords(gesture, labels) {
  return movement(gesture, labels[gesture.joint]);
}

/** A gesture within a sentence. @param {Gesture} gesture @param {Record<string, string>} labels of the joints */
export function gestureWithin(gesture, labels) {
  return movement(gesture, jointWithin({ name: gesture.joint, label: labels[gesture.joint] }));
}

/** @param {Gesture} gesture @param {string} joint in words */
function movement({ direction, feature }, joint) {
  const isHeld = feature === "displacement";
  if (direction < 0) return t(isHeld ? "gesture-back-held" : "gesture-back", { joint });
  return isHeld ? t("gesture-held", { joint }) : joint;
}

/**
 * @template {{joint: string, direction: number}} Found
 * @param {Found[]} gestures @param {string} joint @param {number} direction
 */
export function gestureFor(gestures, joint, direction) {
  return gestures.find((gesture) => gesture.joint === joint && gesture.direction === direction);
}

/** A name for a gesture that does not exist yet. @param {string} joint @param {number} direction */
export function newGestureName(joint, direction) {
  return direction > 0 ? joint : `${joint}_back`;
}
