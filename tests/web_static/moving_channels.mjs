// Which sensors are seen to move. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { movingChannels, movingNow } = await import(pathToFileURL(`${process.argv[2]}/live/moving_channels.js`));

const RATE = 20; // messages a second
const wave = (t) => Math.sin(2 * Math.PI * t);
const tremble = (t, i) => 0.002 * Math.sin(997 * t + i); // of a body at rest

/** What sees the channels of one shirt: each call lets time pass, and returns which channels moved then, and which at last. */
function watching(noise = []) {
  const see = movingChannels();
  let count = 0;
  return (seconds, values, skipped = 0) => {
    count += skipped * RATE;
    const ever = new Set();
    let moving = [];
    for (const end = count + seconds * RATE; count < end; count += 1) {
      moving = see(count / RATE, values(count / RATE), noise);
      for (const i of moving) ever.add(i);
    }
    return { ever: [...ever].sort(), moving };
  };
}
const atRest = (t) => [0, 1, 2].map((i) => tremble(t, i));
const moved = (sizes) => (t) => atRest(t).map((value, i) => value + sizes[i] * wave(t));

// Who moves one joint sees its sensors, the one that moves most first; a body at rest moves none.
let during = watching();
assert.deepEqual(during(0.5, atRest).ever, []);
assert.deepEqual(during(3, atRest).ever, []);
assert.deepEqual(during(2, moved([0, 0.5, 1])).moving, [2, 1]);
assert.deepEqual(during(3, atRest).moving, []);
assert.deepEqual(during(2, moved([1, 0, 0])).ever, [0]);

// What moves along a little, beside what it does when it is moved itself, is not lit.
during = watching();
during(2, atRest);
assert.deepEqual(during(2, moved([0, 1, 0])).ever, [1]);
during(2, atRest);
assert.deepEqual(during(2, moved([1, 0.1, 0])).ever, [0]);

// What noise alone spans is no movement.
during = watching([0.5, 0.01, null]);
during(2, () => [0, 0, 0]);
assert.deepEqual(during(2, moved([1, 1, 1])).ever, [1, 2]);

// A channel without values does not move, and one of which some are missing does.
during = watching();
during(2, () => [null, 0, 0]);
assert.deepEqual(during(2, (t) => [null, wave(t), Math.round(t * RATE) % 3 ? wave(t) : null]).ever, [1, 2]);

// After a pause, with another shirt and with another control process what is calm is found anew.
const jerk = (t) => [5 * t, 5 * t, 5 * t];
during = watching();
during(2, atRest);
assert.deepEqual(during(0.5, jerk, 10).ever, []);
assert.deepEqual(during(2, (t) => [5 * t, 5 * t]).ever, []);
const see = movingChannels();
for (let t = 1e6; t < 1e6 + 2; t += 1 / RATE) see(t, [tremble(t, 0)], []);
assert.deepEqual(see(0, [1e6], []), []);
for (let t = 0.05; t < 2; t += 1 / RATE) assert.deepEqual(see(t, [tremble(t, 0)], []), []);

// The pages follow the messages of a shirt that sends.
const live = Object.assign(new EventTarget(), { noise: [0, 0] });
const left = new AbortController();
const { moving, most } = movingNow(live, left.signal);
let count = 0;
const send = (seconds, values, alive = true) => {
  for (const end = count + seconds * RATE; count < end; count += 1) {
    const detail = { t: count / RATE, values: values(count / RATE), shirt: { alive } };
    live.dispatchEvent(Object.assign(new Event("tick"), { detail }));
  }
  return [moving.value, most.value];
};
assert.deepEqual(
  send(2, () => [0, 0]),
  [[], -1],
);
assert.deepEqual(
  send(2, (t) => [wave(t), 2 * wave(t)]),
  [[0, 1], 1],
);
assert.deepEqual(
  send(0.1, (t) => [wave(t), 2 * wave(t)], false),
  [[], -1],
);
left.abort();
assert.deepEqual(
  send(2, (t) => [wave(t), 2 * wave(t)]),
  [[], -1],
);
console.log("the movements of sensors hold");
