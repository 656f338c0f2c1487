// Where the arrow of the patient's screen points, and which sounds a change makes. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const from = (file) => import(pathToFileURL(`${process.argv[2]}/patient/${file}`));
const { bearingTo, side } = await from("arrow.js");
const { soundsBetween } = await from("sounds.js");

const quarter = Math.PI / 2;
for (const [pose, target, bearing, where] of [
  [[0, 0, 0], [2, 0], 0, "ahead"],
  [[0, 0, 0], [0, 2], quarter, "left"],
  [[0, 0, quarter], [2, 0], -quarter, "right"],
  [[1, 1, quarter], [1, 3], 0, "ahead"],
  [[0, 0, 3], [-2 * Math.cos(3), -2 * Math.sin(3)], Math.PI, "behind"],
  [[0, 0, 4 * Math.PI + 0.1], [2, 0], -0.1, "ahead"],
]) {
  const found = bearingTo(pose, target);
  assert.ok(Math.abs(Math.cos(found.bearing - bearing) - 1) < 1e-6, `${pose} ${target}`);
  assert.ok(Math.abs(found.distance - 2) < 1e-6, `${pose} ${target}`);
  assert.equal(side(found.bearing), where);
}

const still = { state: "armed", contacts: 1, trial: { id: 1 }, over: null };
const over = { ...still, trial: null, over: { id: 1, end: "goal" } };
const fault = { ...still, state: "fault" };
for (const [before, now, sounds] of [
  [null, fault, []],
  [still, still, []],
  [still, { ...still, contacts: 2 }, ["contact"]],
  [still, { ...still, contacts: 5, trial: { id: 2 } }, []],
  [still, fault, ["stop"]],
  [fault, fault, []],
  [still, over, ["goal"]],
  [over, over, []],
  [still, { ...over, over: { id: 1, end: "by hand" } }, []],
])
  assert.deepEqual(soundsBetween(before, now), sounds, JSON.stringify([before, now]));
console.log("arrow and sounds hold");
