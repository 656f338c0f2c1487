// The channels of a drawn skeleton. Run by test_camera_channels.py with the folder js; prints the channels and a message.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const from = (file) => import(pathToFileURL(`${process.argv[2]}/camera/${file}`));
const { CHANNELS, channelsOf } = await from("channels.js");
const { encodeSample } = await from("sample.js");

const ASPECT = 4 / 3;
const RADIANS = Math.PI / 180;
const NEAR = 1e-9;
const HALF = 0.18; // m, half the width of the shoulders
const [NOSE, EARS, SHOULDERS, ELBOWS, WRISTS, HIPS] = [0, [7, 8], [11, 12], [13, 14], [15, 16], [23, 24]];

const add = (a, b) => a.map((value, i) => value + b[i]);
const times = (a, factor) => a.map((value) => value * factor);
// Turn in the plane of two axes: from the first towards the second.
const turn = (v, [from, to], degrees) => {
  const [c, s] = [Math.cos(degrees * RADIANS), Math.sin(degrees * RADIANS)];
  return v.map((value, i) => (i === from ? c * v[from] - s * v[to] : i === to ? s * v[from] + c * v[to] : value));
};
const [TO_LEFT, UP, AHEAD] = [0, 1, 2]; // of the person, who looks into the camera: to the right of the picture, up, towards it

// A person in m, hips in the middle of the world; each arm is [bend, lift, forward or sideways].
function person({ side = 0, forward = 0, yaw = 0, pitch = 0, roll = 0, arms = [], shrug = [0, 0], reach = [0, 0] }) {
  const lean = (v) => turn(turn(v, [UP, AHEAD], forward), [UP, TO_LEFT], side);
  const points = Array.from({ length: 33 }, () => [0, 0, 0]);
  const neck = [0, 0.5, 0];
  const onHead = (v) => add(neck, turn(turn(turn(v, [AHEAD, UP], pitch), [TO_LEFT, UP], roll), [AHEAD, TO_LEFT], yaw));
  points[NOSE] = onHead([0, 0.2, 0.1]);
  EARS.forEach((ear, i) => (points[ear] = onHead([i ? -0.07 : 0.07, 0.2, 0])));
  HIPS.forEach((hip, i) => (points[hip] = [i ? -0.12 : 0.12, 0, 0]));
  SHOULDERS.forEach((shoulder, i) => {
    const outwards = i ? -1 : 1;
    const { bend = 0, lift = 0, plane = AHEAD } = arms[i] ?? {};
    points[shoulder] = add(neck, [outwards * HALF, shrug[i], reach[i]]);
    const lifted = (v) => turn(v, [UP, plane], plane === AHEAD ? -lift : -lift * outwards);
    points[ELBOWS[i]] = add(points[shoulder], lifted([0, -0.3, 0]));
    points[WRISTS[i]] = add(points[ELBOWS[i]], lifted(turn([0, -0.25, 0], [UP, AHEAD], -bend)));
  });
  return points.map((point, i) => (HIPS.includes(i) ? point : lean(point)));
}

// What the camera sees of it: `place` in heights of the picture, `scale` in heights of the picture a metre.
function poseOf(points, { place = [0.6, 0.3], scale = 0.5, visibility = () => 0.9 } = {}) {
  const picture = points.map(([x, y, z], i) => ({
    x: (place[0] + scale * x) / ASPECT,
    y: 1 - (place[1] + scale * y),
    z: (-scale * z) / ASPECT,
    visibility: visibility(i),
  }));
  return { picture, world: points.map(([x, y, z], i) => ({ x, y: -y, z: -z, visibility: visibility(i) })) };
}

const read = (points, camera) => {
  const values = channelsOf(poseOf(points, camera), ASPECT);
  return Object.fromEntries(CHANNELS.map((name, i) => [name, values[i]]));
};
const isNear = (value, wanted, what, near = NEAR) =>
  assert.ok(Math.abs(value - wanted) < near, `${what}: ${value}, not ${wanted}`);
const areAlike = (one, other, what, near = NEAR) => {
  for (const name of CHANNELS) isNear(one[name], other[name], `${what}, ${name}`, near);
};

// Angles of a drawn skeleton are those that it was drawn with.
for (const degrees of [0, 20, 60, 90, 140]) {
  const arms = [
    { bend: degrees, lift: 30 },
    { bend: 140 - degrees, lift: 80, plane: TO_LEFT },
  ];
  const { left_elbow_bend, right_elbow_bend, left_elbow_lift, right_elbow_lift } = read(person({ arms }));
  isNear(left_elbow_bend, degrees * RADIANS, "left bend");
  isNear(right_elbow_bend, (140 - degrees) * RADIANS, "right bend");
  isNear(left_elbow_lift, 30 * RADIANS, "left lift, to the front");
  isNear(right_elbow_lift, 80 * RADIANS, "right lift, to the side");
}
const LEVEL = read(person({}));
for (const degrees of [-40, -10, 15, 50]) {
  isNear(read(person({ yaw: degrees })).head_yaw, degrees * RADIANS, "yaw");
  isNear(read(person({ roll: -degrees })).head_roll, -degrees * RADIANS, "roll");
  isNear(read(person({ pitch: degrees })).head_pitch - LEVEL.head_pitch, degrees * RADIANS, "pitch");
  isNear(read(person({ side: degrees })).trunk_side, degrees * RADIANS, "lean to the side");
  isNear(read(person({ forward: degrees / 2 })).trunk_forward, (degrees / 2) * RADIANS, "lean forward");
}

// Lengths are in widths of the shoulders.
const WIDTH = 2 * HALF;
const shrugged = read(person({ shrug: [0.1 * WIDTH, 0] }));
isNear(shrugged.left_shoulder_elevation - LEVEL.left_shoulder_elevation, 0.1, "a tenth of a width up", 0.01);
isNear(shrugged.right_shoulder_elevation, LEVEL.right_shoulder_elevation, "the other shoulder", 0.03);
isNear(LEVEL.right_shoulder_out, 0.5, "half a width to the side");
isNear(read(person({ reach: [0.05, 0.05] })).left_shoulder_forward, 0.05 / WIDTH, "forward");
const pointing = read(person({ arms: [{ lift: 90 }, { lift: 90 }] }));
isNear(pointing.left_wrist_height, 0, "level with the shoulder");
isNear(pointing.right_wrist_forward, 0.55 / WIDTH, "an arm's length ahead");

// A picture that is moved, or taken from further away, says the same of a person; so does a person who leans aside.
let state = 1;
const random = (low, high) => {
  state = (state * 48271) % 2147483647;
  return low + ((high - low) * state) / 2147483647;
};
const posture = () => ({
  side: random(-20, 20),
  forward: random(-20, 20),
  yaw: random(-60, 60),
  pitch: random(-30, 30),
  roll: random(-30, 30),
  arms: [0, 1].map(() => ({ bend: random(0, 140), lift: random(0, 120), plane: random(0, 1) < 0.5 ? AHEAD : TO_LEFT })),
  shrug: [random(0, 0.05), random(0, 0.05)],
  reach: [random(-0.05, 0.05), random(-0.05, 0.05)],
});
for (let i = 0; i < 200; i++) {
  const pose = posture();
  const points = person(pose);
  const other = { place: [random(-0.5, 1.5), random(-0.5, 1.5)], scale: random(0.05, 3) };
  areAlike(read(points), read(points, other), "another place and distance");
  const upright = read(person({ ...pose, side: 0 }));
  const leaning = read(person({ ...pose, side: 25 }));
  assert.ok(Math.abs(leaning.trunk_side) > Math.abs(upright.trunk_side));
  areAlike({ ...leaning, trunk_side: 0 }, { ...upright, trunk_side: 0 }, "leaning to the side");
  assert.ok(
    Object.values(upright).every((value) => Math.abs(value) < 10),
    "no value is larger than the server takes",
  );
}

// What is not visible is missing, with all that is measured by it, and nothing else.
const missing = (hidden) =>
  CHANNELS.filter((name) => {
    const visibility = (i) => (hidden.includes(i) ? 0.49 : 0.5);
    return Number.isNaN(read(person({}), { visibility })[name]);
  });
assert.deepEqual(missing([]), []);
assert.deepEqual(missing([WRISTS[0]]), ["left_elbow_bend", "left_wrist_height", "left_wrist_forward"]);
assert.deepEqual(missing([ELBOWS[1]]), ["right_elbow_bend", "right_elbow_lift"]);
assert.deepEqual(missing(HIPS), ["trunk_side", "trunk_forward"]);
assert.deepEqual(
  missing([NOSE]),
  CHANNELS.filter((name) => /shoulder|head/.test(name)),
);
assert.deepEqual(missing([SHOULDERS[1]]), CHANNELS);
assert.ok(channelsOf(null, ASPECT).every(Number.isNaN));
const nowhere = person({}).map(() => [0, 0, 0]);
assert.ok(Object.entries(read(nowhere)).every(([name, value]) => Number.isNaN(value) || /head|trunk/.test(name)));
assert.ok(channelsOf({ picture: [], world: [] }, ASPECT).every(Number.isNaN), "a pose without landmarks");

const sample = { seq: 4294967295, pictureTime: 12.5, sentTime: 12.625, values: [0.25, NaN, -3] };
console.log(JSON.stringify({ channels: CHANNELS, message: Buffer.from(encodeSample(sample)).toString("hex") }));
