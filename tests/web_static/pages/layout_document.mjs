// Changes of a layout in its editor, and what places on the body are called. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const at = (file) => import(pathToFileURL(`${process.argv[2]}/pages/layouts/${file}`));
const {
  freeJoint,
  freeName,
  newLayout,
  usualJoint,
  withChannel,
  withGroups,
  withJoint,
  withJointLabel,
  withJointNamed,
  withoutPlace,
  withPlace,
  wrongRing,
} = await at("layout_document.js");
const { partAt, placeWords } = await at("place_names.js");

const joints = (layout) => layout.joints.map(({ name }) => name);
const jointsOf = (layout) => layout.channels.map(({ joint }) => joint);
const frozen = (value) => {
  if (value && typeof value === "object") Object.values(Object.freeze(value)).forEach(frozen);
  return value;
};

const first = frozen(newLayout("Vest", 4, "Whole body"));
assert.deepEqual(first.channels[3], {
  name: "channel_4",
  joint: "body",
  position: null,
  side: null,
  ring: null,
  place: null,
  unit: null,
  liveness: null,
});
assert.deepEqual(first.joints, [{ name: "body", label: "Whole body" }]);

// A place is within the outline, and rounded.
const placed = frozen(withPlace(first, 1, "back", [1.2, 0.123456]));
assert.deepEqual(placed.channels[1].position, [1, 0.123]);
assert.equal(placed.channels[1].side, "back");
assert.deepEqual(withoutPlace(placed, 1), first);
assert.equal(withChannel(first, 0, { name: "EMG" }).channels[0].name, "EMG");

// The sensors of a ring are counted 1, 2, 3 ... for people, from 0 in the document, or not at all.
const ring = (...places) => ({
  ...first,
  channels: first.channels.map((channel, i) =>
    i in places ? { ...channel, ring: "cuff", place: places[i] } : channel,
  ),
});
for (const places of [[], [null], [0], [0, 1, 2], [2, 0, 1], [null, null, null], [undefined, undefined]])
  assert.equal(wrongRing(ring(...places)), null, String(places));
for (const places of [[1], [1, 2, 3], [0, 1, 1], [0, null], [0, undefined, 1]])
  assert.deepEqual(wrongRing(ring(...places)), { ring: "cuff", count: places.length }, String(places));

// A joint is there while a channel has it.
const elbow = usualJoint("right_elbow");
assert.deepEqual(elbow, { name: "right_elbow", label: "right elbow" });
const ringed = frozen(withChannel(first, 0, { ring: "cuff", place: 2 }));
const moved = frozen(withJoint(ringed, 0, elbow));
assert.deepEqual(jointsOf(moved), ["right_elbow", "body", "body", "body"]);
assert.deepEqual(joints(moved), ["body", "right_elbow"]);
assert.deepEqual([moved.channels[0].ring, moved.channels[0].place], [null, null]);
assert.equal(withJoint(ringed, 0, { name: "body", label: "" }), ringed);
const all = [1, 2, 3].reduce((layout, i) => withJoint(layout, i, elbow), moved);
assert.deepEqual(joints(all), ["right_elbow"]);

// Joints get other names, and two of one name become one.
const knee = frozen(withJointNamed(moved, "body", usualJoint("left_knee")));
assert.deepEqual(jointsOf(knee), ["right_elbow", "left_knee", "left_knee", "left_knee"]);
assert.deepEqual(joints(knee), ["left_knee", "right_elbow"]);
assert.deepEqual(joints(withJointNamed(knee, "left_knee", elbow)), ["right_elbow"]);
assert.equal(withJointLabel(knee, "left_knee", "Bad knee").joints[0].label, "Bad knee");

// Groups become joints, those that are joints already stay; who is in no group stays where it was.
const label = (number) => `Group ${number}`;
const grouped = frozen(
  withGroups(
    first,
    [
      [0, 2],
      [1, 3],
    ],
    label,
  ),
);
assert.deepEqual(jointsOf(grouped), ["joint_1", "joint_2", "joint_1", "joint_2"]);
assert.deepEqual(
  grouped.joints.map((joint) => joint.label),
  ["Group 1", "Group 2"],
);
const named = frozen(withJointNamed(grouped, "joint_1", elbow));
assert.equal(withGroups(named, [[2, 0]], label), named);
assert.deepEqual(jointsOf(withGroups(named, [[0, 1]], label)), ["joint_3", "joint_3", "right_elbow", "joint_2"]);
assert.equal(freeJoint({ joints: [{ name: "a" }, { name: "joint_2" }] }), "joint_3");

assert.equal(freeName("Vest", ["Shirt"], 80), "Vest");
assert.equal(freeName("Vest", ["Vest", "Vest 2"], 80), "Vest 3");
assert.equal(freeName("Vestment", ["Vestm"], 5), "Ves 2");

// Seen from the front the wearer's right is at the left of the picture, and from behind at the right.
assert.deepEqual(partAt("front", [0.165, 0.49]), { part: "elbow", hand: "right" });
assert.deepEqual(partAt("back", [0.165, 0.49]), { part: "elbow", hand: "left" });
assert.deepEqual(partAt("front", [0.73, 0.24]), { part: "shoulder", hand: "left" });
assert.deepEqual(partAt("front", [0.5, 0.09]), { part: "head", hand: null });
assert.deepEqual(partAt("front", [0.45, 0.4]), { part: "chest", hand: null });
assert.deepEqual(partAt("back", [0.45, 0.8]), { part: "lower-back", hand: null });
assert.equal(placeWords({ position: [0.09, 0.8], side: "front" }), "Front: right hand");
assert.equal(placeWords({ position: [0.3, 0.25], side: "back" }), "Back: left shoulder");
assert.equal(placeWords({ position: null, side: null }), "Not on the body yet");
for (const side of ["front", "back"])
  for (let x = 0; x <= 1; x += 0.05)
    for (let y = 0; y <= 1; y += 0.05) {
      const words = placeWords({ position: [x, y], side });
      assert.doesNotMatch(words, /layouts-/, `${side} ${x} ${y}`);
    }
console.log("changes of a layout hold");
