// Which sensor is seen to move. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { ChannelMovement } = await import(
  pathToFileURL(`${process.argv[2]}/pages/layouts/channel_movement.js`)
);

const PERIOD = 0.05; // s
const NOISE = [0.01, 0.01, 0.01];
const wave = (t) => Math.sin(2 * Math.PI * t);
const jitter = (i, t) => 0.01 * Math.sin(997 * t + i); // of a sensor at rest

/** Push frames from `start` to `end` (s), and return which channels moved at any time. */
function watch(movement, start, end, frame) {
  const moved = new Set();
  for (let n = Math.round(start / PERIOD); n < Math.round(end / PERIOD); n += 1) {
    movement.push(n * PERIOD, frame(n * PERIOD));
    for (const i of movement.moving(NOISE)) moved.add(i);
  }
  return [...moved].sort();
}
const rest = (t) => [0, 1, 2].map((i) => jitter(i, t));
const wiggled = (index) => (t) => rest(t).map((value, i) => (i === index ? value + wave(t) : value));

const movement = new ChannelMovement();
assert.deepEqual(watch(movement, 0, 2, rest), [], "noise is no movement");
assert.deepEqual(watch(movement, 2, 4, wiggled(1)), [1]);
assert.deepEqual(watch(movement, 5, 7, rest).filter((i) => i !== 1), []);
assert.deepEqual(movement.moving(NOISE), [], "it is at rest again");
assert.deepEqual(watch(movement, 7, 9, wiggled(2)), [2]);

// What moves along a little, beside what it does when it is moved itself, is not lit.
const together = (t) => [wave(t), 0.1 * wave(t), 0];
const coupled = new ChannelMovement();
assert.deepEqual(watch(coupled, 0, 3, (t) => [0, wave(t), 0]), [1]);
assert.deepEqual(watch(coupled, 4, 6, together).filter((i) => i === 1), []);

// Missing values are no movement, and a frame that comes twice counts once.
const gaps = new ChannelMovement();
assert.deepEqual(watch(gaps, 0, 2, () => [null, null, null]), []);
assert.deepEqual(watch(gaps, 2, 4, (t) => [null, wave(t), null]), [1]);
gaps.push(3.95, [100, 100, 100]);
assert.ok(!gaps.moving(NOISE).includes(0));

// Another control process counts its own time, and another shirt has other channels.
gaps.push(0, [0, 0, 0]);
assert.deepEqual(gaps.moving(NOISE), []);
gaps.push(0.05, [0, 9]);
assert.deepEqual(gaps.moving(NOISE), []);
gaps.push(0.1, [5, 9]);
assert.deepEqual(gaps.moving([null, null]), [0]);
console.log("the movement of sensors holds");
