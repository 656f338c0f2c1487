/**
 * What joints and sensors are called. A joint that is usual (an elbow, say) has its name in the language of the pages; any
 * other, and one to which the layout of a shirt gives a label of its own, has that label.
 * @typedef {{name: string, label: string}} NamedJoint of a layout
 */
import { hasText, t } from "../texts.js";

const SENSOR = /^(\w+)_(\d+)$/; // of a joint: "right_elbow_3"
const CHANNEL = /^(\w+)_([a-z]+)$/; // what a camera measures of a joint: "right_elbow_bend"

/** Alone, or at the beginning. @param {NamedJoint} joint */
export function jointLabel({ name, label }) {
  return isUsual(name, label) ? t(`joint-${name}`) : label;
}

/** Within a sentence. @param {NamedJoint} joint */
export function jointWithin({ name, label }) {
  return isUsual(name, label) ? t(`joint-within-${name}`) : label;
}

/** A joint alone, of which only the label is known. @param {string} label */
export function labelWords(label) {
  return jointLabel({ name: label.toLowerCase().replaceAll(" ", "_"), label });
}

/** The labels of joints, by name. @param {readonly NamedJoint[]} joints @returns {Record<string, string>} */
export function labelsOf(joints) {
  return Object.fromEntries(joints.map((joint) => [joint.name, jointLabel(joint)]));
}

/** A sensor alone: "Right elbow 3". @param {string} name of the channel */
export function sensorName(name) {
  return sensor(name, (joint) => t(`joint-${joint}`));
}

/** A sensor within a sentence: "right elbow 3". @param {string} name of the channel */
export function sensorWithin(name) {
  return sensor(name, (joint) => t(`joint-within-${joint}`));
}

/** @param {string} name @param {(joint: string) => string} words of a usual joint */
function sensor(name, words) {
  const [, joint, number] = SENSOR.exec(name) ?? [];
  if (joint && hasText(`joint-${joint}`)) return t("joint-sensor", { joint: words(joint), number });
  const [, moved, measure] = CHANNEL.exec(name) ?? [];
  if (moved && hasText(`joint-${moved}`) && hasText(`channel-${measure}`))
    return t("joint-channel", { joint: words(moved), what: t(`channel-${measure}`) });
  return asWords(name);
}

/** Whether a label is that of the language, or that of the layouts that come with the program. @param {string} name @param {string} label */
function isUsual(name, label) {
  if (!hasText(`joint-${name}`)) return false;
  return label === t(`joint-${name}`) || label.toLowerCase() === asWords(name);
}

/** A name of a layout that people gave. @param {string} name */
function asWords(name) {
  return name.replaceAll("_", " ");
}
