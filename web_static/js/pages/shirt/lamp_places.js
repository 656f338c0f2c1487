/** Where a lamp lies: where the layout says, otherwise near its joint, so that every sensor can be tapped. */

// The patient's right, seen from the front; in the units of a layout. The left mirrors it.
/** @type {Record<string, [number, number]>} */
const ANCHORS = { shoulder: [0.33, 0.26], elbow: [0.17, 0.485], wrist: [0.11, 0.715] };
const ELSEWHERE = [0.5, 0.5];
const APART = [0.05, 0.04]; // between two lamps of one joint
const COLUMNS = 3;

const ROUNDS = 80; // more than enough for 52 lamps

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

/**
 * Move points apart, in place, until any two have `least` between them where there is room; each goes as little as it can.
 * @param {[number, number][]} points @param {number} least @param {[number, number]} box width and height that they stay in
 */
export function spread(points, least, [width, height]) {
  const rim = least / 2;
  for (let round = 0; round < ROUNDS; round++) {
    let moved = false;
    points.forEach((a, i) => {
      for (const b of points.slice(i + 1)) {
        const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        const far = Math.hypot(dx, dy);
        if (far >= least - 1e-6) continue;
        const push = (least - far) / 2;
        const [x, y] = far ? [dx / far, dy / far] : [1, 0];
        a[0] = Math.min(width - rim, Math.max(rim, a[0] - x * push));
        a[1] = Math.min(height - rim, Math.max(rim, a[1] - y * push));
        b[0] = Math.min(width - rim, Math.max(rim, b[0] + x * push));
        b[1] = Math.min(height - rim, Math.max(rim, b[1] + y * push));
        moved = true;
      }
    });
    if (!moved) return;
  }
}
