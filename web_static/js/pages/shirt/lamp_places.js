/** Where a lamp lies: where the layout says, otherwise near its joint, so that every sensor can be tapped. */

// The patient's right, seen from the front; in the units of a layout. The left mirrors it.
/** @type {Record<string, [number, number]>} */
const ANCHORS = { shoulder: [0.33, 0.26], elbow: [0.17, 0.485], wrist: [0.11, 0.715] };
const ELSEWHERE = [0.5, 0.5];
const APART = [0.05, 0.04]; // between two lamps of one joint
const COLUMNS = 3;

/** @typedef {import("types/api").Channel} Channel */

/**
 * @param {Channel[]} channels
 * @returns {{channel: Channel, index: number, side: "front" | "back", position: [number, number]}[]}
 */
export function lampPlaces(channels) {
  /** @type {Map<string, number>} */
  const placed = new Map(); // number of channels of each joint that were placed near it
  return channels.map((channel, index) => {
    if (channel.position) return { channel, index, side: channel.side ?? "front", position: channel.position };
    const number = placed.get(channel.joint) ?? 0;
    placed.set(channel.joint, number + 1);
    return { channel, index, side: "front", position: nearJoint(channel.joint, number) };
  });
}

/** @param {string} joint @param {number} number @returns {[number, number]} */
function nearJoint(joint, number) {
  const [side, part] = joint.split("_");
  const [x, y] = ANCHORS[part] ?? ELSEWHERE;
  const column = (number % COLUMNS) - 1;
  const row = Math.floor(number / COLUMNS);
  return [(side === "left" ? 1 - x : x) + column * APART[0], y + row * APART[1]];
}
