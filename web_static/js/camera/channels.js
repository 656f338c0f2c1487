/**
 * From the landmarks of a person in a picture to the channels of the layout `data/shirts/camera-upper-body.json`.
 * Pure mathematics: no picture, no page. "Left" is the person's left, at the right of a picture that is not mirrored.
 *
 * Lengths are in widths of the shoulders and measured along the trunk, so that the place and the distance of the camera
 * matter little; angles are in rad. A channel is NaN while a landmark that it needs is not visible.
 *
 * @import { Landmark, Pose } from "types/pose"
 * @typedef {readonly [number, number, number]} Vector to the right of the picture, up, towards the camera
 * @typedef {"left" | "right"} Side
 */

/** Below it, a landmark counts as not visible. */
export const VISIBLE = 0.5;

const LANDMARKS = 33;
const NOSE = 0;
/** @type {Record<Side, {ear: number, shoulder: number, elbow: number, wrist: number, hip: number}>} */
const OF_SIDE = {
  left: { ear: 7, shoulder: 11, elbow: 13, wrist: 15, hip: 23 },
  right: { ear: 8, shoulder: 12, elbow: 14, wrist: 16, hip: 24 },
};
const { left: LEFT, right: RIGHT } = OF_SIDE;
const SHOULDERS = [LEFT.shoulder, RIGHT.shoulder];

/** The landmarks from which the channels of a joint are made besides the shoulders, by the last word of the channel. */
const OF_SHOULDER = { elevation: [NOSE], forward: [NOSE], out: [NOSE] };
const OF_HEAD = { yaw: [NOSE], pitch: [NOSE], roll: [NOSE] };
const OF_TRUNK = { side: [LEFT.hip, RIGHT.hip], forward: [LEFT.hip, RIGHT.hip] };
/** @param {Side} side */
const ofElbow = (side) => ({ bend: [OF_SIDE[side].elbow, OF_SIDE[side].wrist], lift: [OF_SIDE[side].elbow] });
/** @param {Side} side */
const ofWrist = (side) => ({ height: [OF_SIDE[side].wrist], forward: [OF_SIDE[side].wrist] });

/** The channels by joint, in the order of the layout. @type {Record<string, Record<string, number[]>>} */
const JOINTS = {
  right_shoulder: OF_SHOULDER,
  left_shoulder: OF_SHOULDER,
  right_elbow: ofElbow("right"),
  left_elbow: ofElbow("left"),
  right_wrist: ofWrist("right"),
  left_wrist: ofWrist("left"),
  head: OF_HEAD,
  trunk: OF_TRUNK,
};
const NEEDS = Object.entries(JOINTS).flatMap(([joint, channels]) =>
  Object.entries(channels).map(([name, needed]) => ({ name: `${joint}_${name}`, needed: [...SHOULDERS, ...needed] })),
);

/** The names of the channels, in the order of `channelsOf`. */
export const CHANNELS = NEEDS.map(({ name }) => name);

/**
 * The value of each channel; NaN where it is not known.
 * @param {Pose | null} pose null: nobody is in the picture @param {number} aspect width of the picture by its height
 */
export function channelsOf(pose, aspect) {
  if (!pose || pose.picture.length < LANDMARKS || pose.world.length < LANDMARKS) return CHANNELS.map(() => NaN);
  const values = measured(pose, aspect);
  return NEEDS.map(({ name, needed }) => {
    const value = needed.every((i) => isVisible(pose.picture[i])) ? values[name] : NaN;
    return Number.isFinite(value) ? value : NaN;
  });
}

/** @param {Landmark | undefined} landmark */
export const isVisible = (landmark) => (landmark?.visibility ?? 0) >= VISIBLE;

/** All channels, whatever is visible. @param {Pose} pose @param {number} aspect @returns {Record<string, number>} */
function measured({ picture, world }, aspect) {
  /** In heights of the picture. @param {number} i @returns {Vector} */
  const seen = (i) => [picture[i].x * aspect, -picture[i].y, -picture[i].z * aspect];
  /** In m. @param {number} i @returns {Vector} */
  const placed = (i) => [world[i].x, -world[i].y, -world[i].z];
  const [inPicture, inWorld] = [bodyOf(seen), bodyOf(placed)];
  /** @param {Side} side */
  const arm = (side) => {
    const { shoulder, elbow, wrist } = OF_SIDE[side];
    const outwards = side === "left" ? inPicture.left : minus([0, 0, 0], inPicture.left);
    const fromHead = minus(seen(shoulder), inPicture.head);
    const hand = minus(seen(wrist), seen(shoulder));
    const upperArm = minus(placed(elbow), placed(shoulder));
    const forearm = minus(placed(wrist), placed(elbow));
    return {
      [`${side}_shoulder_elevation`]: dot(fromHead, inPicture.up) / inPicture.width,
      [`${side}_shoulder_forward`]: (placed(shoulder)[2] - inWorld.head[2]) / inWorld.width,
      [`${side}_shoulder_out`]: dot(fromHead, outwards) / inPicture.width,
      [`${side}_elbow_bend`]: angle(upperArm, forearm), // 0: straight
      [`${side}_elbow_lift`]: angle(upperArm, minus([0, 0, 0], inWorld.trunk)), // 0: the arm hangs
      [`${side}_wrist_height`]: dot(hand, inPicture.up) / inPicture.width,
      [`${side}_wrist_forward`]: (placed(wrist)[2] - placed(shoulder)[2]) / inWorld.width,
    };
  };
  return { ...arm("right"), ...arm("left"), ...headOf(inWorld, placed), ...trunkOf(inPicture, inWorld) };
}

/**
 * What the other channels are measured by: the axes of the trunk as the picture shows it, and the width of the shoulders.
 * The hips are used where the model places them, visible or not, so that nothing jumps when they leave the picture.
 * @param {(landmark: number) => Vector} place
 */
function bodyOf(place) {
  const trunk = minus(middle(place(LEFT.shoulder), place(RIGHT.shoulder)), middle(place(LEFT.hip), place(RIGHT.hip)));
  const height = Math.hypot(trunk[0], trunk[1]);
  /** @type {Vector} */
  const up = height > 0 ? [trunk[0] / height, trunk[1] / height, 0] : [0, 1, 0];
  /** @type {Vector} */
  const left = [up[1], -up[0], 0];
  const head = middle(place(LEFT.ear), place(RIGHT.ear));
  return { trunk, up, left, head, width: Math.hypot(...minus(place(LEFT.shoulder), place(RIGHT.shoulder))) };
}

/**
 * The direction of the head against the trunk: to the left, up, and towards the right shoulder are positive.
 * @param {ReturnType<typeof bodyOf>} body in the world @param {(landmark: number) => Vector} placed
 */
function headOf({ up, left, head }, placed) {
  const across = minus(placed(LEFT.ear), placed(RIGHT.ear));
  const ahead = minus(placed(NOSE), head);
  const [acrossLeft, acrossUp] = [dot(across, left), dot(across, up)];
  return {
    head_yaw: Math.atan2(-across[2], acrossLeft),
    head_pitch: Math.atan2(dot(ahead, up), Math.hypot(dot(ahead, left), ahead[2])),
    head_roll: Math.atan2(acrossUp, Math.hypot(acrossLeft, across[2])),
  };
}

/**
 * How far the trunk leans: to the left, and forward.
 * @param {ReturnType<typeof bodyOf>} inPicture @param {ReturnType<typeof bodyOf>} inWorld
 */
function trunkOf({ trunk: [x, y] }, { trunk }) {
  return {
    trunk_side: Math.atan2(x, y),
    trunk_forward: Math.atan2(trunk[2], Math.hypot(trunk[0], trunk[1])),
  };
}

/** @param {Vector} a @param {Vector} b @returns {Vector} */
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Between two vectors, 0 to pi; NaN when one has no length. @param {Vector} a @param {Vector} b */
function angle(a, b) {
  const cosine = dot(a, b) / (Math.hypot(...a) * Math.hypot(...b));
  return Math.acos(Math.min(1, Math.max(-1, cosine)));
}
