/**
 * A layout in the editor. Each change makes another document, and leaves the one of before as it is.
 * @import { LayoutsView, ShirtLayout } from "types/api"
 * @typedef {ShirtLayout["channels"][number]} Channel
 * @typedef {ShirtLayout["joints"][number]} Joint
 * @typedef {"front" | "back"} Side
 */
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";

export const NEW_JOINT = "+"; // chosen in place of a joint's name, which is never that
const FINEST = 1000; // parts of the outline's width and height by which a place is rounded
export const WHOLE = "body"; // the joint of all channels, before somebody says which they have
const OWN = "joint"; // begins the name of a joint that is not usual

/** A layout of so many channels, all of one joint. @param {string} name @param {number} count @param {string} label of the joint @returns {ShirtLayout} */
export function newLayout(name, count, label) {
  return {
    name,
    channels: Array.from({ length: count }, (_, i) => blank(`channel_${i + 1}`, WHOLE)),
    joints: [{ name: WHOLE, label }],
  };
}

/** @param {string} name @param {string} joint @returns {Channel} */
function blank(name, joint) {
  return { name, joint, position: null, side: null, ring: null, place: null, unit: null, liveness: null };
}

/** @param {ShirtLayout} layout @param {number} index of the channel @param {Partial<Channel>} changes @returns {ShirtLayout} */
export function withChannel(layout, index, changes) {
  const channels = layout.channels.map((channel, i) => (i === index ? { ...channel, ...changes } : channel));
  return { ...layout, channels };
}

/** Put a channel on the body. @param {ShirtLayout} layout @param {number} index @param {Side} side @param {[number, number]} position */
export function withPlace(layout, index, side, [x, y]) {
  return withChannel(layout, index, { side, position: [share(x), share(y)] });
}

/** Take a channel off the body. @param {ShirtLayout} layout @param {number} index */
export function withoutPlace(layout, index) {
  return withChannel(layout, index, { side: null, position: null });
}

/** @param {number} part */
const share = (part) => Math.round(Math.min(1, Math.max(0, part)) * FINEST) / FINEST;

/** Give a channel to a joint; a ring goes round one joint, so that the channel leaves its own. @param {ShirtLayout} layout @param {number} index @param {Joint} joint */
export function withJoint(layout, index, joint) {
  if (layout.channels[index].joint === joint.name) return layout;
  const changed = withChannel(layout, index, { joint: joint.name, ring: null, place: null });
  return withoutEmptyJoints({ ...changed, joints: including(layout.joints, joint) });
}

/** Make all channels of a joint those of another one; two joints of one name become one. @param {ShirtLayout} layout @param {string} from @param {Joint} joint */
export function withJointNamed(layout, from, joint) {
  const channels = layout.channels.map((one) => (one.joint === from ? { ...one, joint: joint.name } : one));
  const isThere = layout.joints.some(({ name }) => name === joint.name);
  const joints = isThere ? layout.joints : layout.joints.map((one) => (one.name === from ? joint : one));
  return withoutEmptyJoints({ ...layout, channels, joints });
}

/** @param {ShirtLayout} layout @param {string} name of the joint @param {string} label */
export function withJointLabel(layout, name, label) {
  return { ...layout, joints: layout.joints.map((one) => (one.name === name ? { ...one, label } : one)) };
}

/**
 * Make joints of groups of channels. A group that is a joint already stays that; a channel of no group keeps its joint.
 * @param {ShirtLayout} layout @param {number[][]} groups indices of channels @param {(number: number) => string} labelOf a new joint, from 1
 */
export function withGroups(layout, groups, labelOf) {
  let number = 0;
  return groups.reduce((now, group) => {
    number += 1;
    const own = now.channels[group[0]].joint;
    const members = now.channels.flatMap((channel, i) => (channel.joint === own ? [i] : []));
    if (own !== WHOLE && members.length === group.length && group.every((i) => members.includes(i))) return now;
    const joint = { name: freeJoint(now), label: labelOf(number) };
    return group.reduce((next, i) => withJoint(next, i, joint), now);
  }, layout);
}

/** A name that no joint has. @param {ShirtLayout} layout */
export function freeJoint({ joints }) {
  let number = joints.length;
  while (joints.some(({ name }) => name === `${OWN}_${number}`)) number += 1;
  return `${OWN}_${number}`;
}

/** A usual joint as a layout names it. @param {string} name @returns {Joint} */
export function usualJoint(name) {
  return { name, label: name.replaceAll("_", " ") };
}

/** The joint that somebody chose for a layout: a usual one, or a new one. @param {ShirtLayout} layout @param {string} name @returns {Joint} */
export function chosenJoint(layout, name) {
  return name === NEW_JOINT ? { name: freeJoint(layout), label: t("layouts-joint-new") } : usualJoint(name);
}

/**
 * The first ring whose sensors are not counted 1 to their number, each once, although some are counted.
 * @param {ShirtLayout} layout @returns {{ring: string, count: number} | null}
 */
export function wrongRing({ channels }) {
  for (const { ring } of channels) {
    const members = ring ? channels.filter((channel) => channel.ring === ring) : [];
    const places = new Set(members.map(({ place }) => place ?? null));
    const isCounted = members.every((_, place) => places.has(place));
    if (ring && !isCounted && !(places.size === 1 && places.has(null))) return { ring, count: members.length };
  }
  return null;
}

/** The number of channels of each joint, by its name. @param {ShirtLayout} layout */
export function channelCounts({ channels }) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const { joint } of channels) counts.set(joint, (counts.get(joint) ?? 0) + 1);
  return counts;
}

/** @param {Joint[]} joints @param {Joint} joint */
const including = (joints, joint) => (joints.some(({ name }) => name === joint.name) ? joints : [...joints, joint]);

/** @param {ShirtLayout} layout @returns {ShirtLayout} */
function withoutEmptyJoints(layout) {
  const counts = channelCounts(layout);
  return { ...layout, joints: layout.joints.filter(({ name }) => counts.has(name)) };
}

/** A copy's name, as short as a name may be. @param {string} words @param {string[]} taken names @param {number} longest */
export function freeName(words, taken, longest) {
  const used = new Set(taken);
  for (let number = 1; ; number += 1) {
    const end = number > 1 ? ` ${number}` : "";
    const name = words.slice(0, longest - end.length) + end;
    if (!used.has(name)) return name;
  }
}

/** The name of a new layout, which none has. @param {string} words @param {LayoutsView} layouts */
export function nameOfNew(words, { own, bundled }) {
  const taken = [...own, ...bundled].map(({ layout }) => layout.name);
  return freeName(words, taken, limitsOf("ShirtLayout", "name").longest ?? 0);
}
