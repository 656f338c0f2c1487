// What a tablet tells of itself, without a page: the component is called as a function. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

let time = 0;
const timers = new Map();
const define = (name, value) => Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
define("window", Object.assign(new EventTarget(), { isSecureContext: true, DeviceOrientationEvent: {} }));
define("screen", { orientation: { angle: 0 } });
define("performance", { now: () => time });
define("setTimeout", (run) => timers.set(run, run) && run);
define("clearTimeout", (run) => timers.delete(run));

const { endTabletHead, orientation, TabletHead } = await import(
  pathToFileURL(`${process.argv[2]}/pages/shirt/tablet_head.js`)
);

// Upright with its back to the north, 30 degrees each way: left, up and to the right shoulder are positive.
const RADIANS = Math.PI / 180;
const looks = (angles, wanted) => {
  const { yaw, pitch, roll } = orientation(...angles);
  [yaw, pitch, roll].forEach((value, i) =>
    assert.ok(Math.abs(value - wanted[i] * RADIANS) < 1e-9, `${angles}: ${value}`),
  );
};
looks([0, 90, 0, 0], [0, 0, 0]);
looks([30, 90, 0, 0], [30, 0, 0]);
looks([0, 120, 0, 0], [0, 30, 0]);
looks([0, 60, 0, 0], [0, -30, 0]);
// Turned in its own plane, clockwise as its viewer sees it: with the top to the right.
const turned = (degrees) => {
  const [c, s] = [Math.cos(degrees * RADIANS), Math.sin(degrees * RADIANS)];
  // right (c, 0, -s), top (s, 0, c), front (0, -1, 0) as angles: beta from the top's height, gamma from right and front
  const beta = Math.asin(c) / RADIANS;
  const gamma = Math.atan2(s, 0) / RADIANS;
  return [-90, beta, gamma];
};
looks([...turned(30), 0], [0, 0, 30]);
// Landscape, its top to the left: the picture is turned by 90 degrees, and nobody's head lies on the side.
looks([90, 0, -90, 90], [0, 0, 0]);

// Start, tell, end.
const sent = [];
const app = { live: { send: (message) => sent.push(message) } };
const event = (alpha, beta, gamma) => Object.assign(new Event("deviceorientation"), { alpha, beta, gamma });
const shown = () => {
  const [button, words] = TabletHead({ app }).props.children;
  return { press: button.props.onClick, isDisabled: button.props["aria-disabled"], words: words.props.children };
};
const press = async () => {
  await shown().press();
  return shown();
};
window.isSecureContext = false;
assert.match((await press()).words, /https/);
window.isSecureContext = true;
const sensor = window.DeviceOrientationEvent;
delete window.DeviceOrientationEvent;
assert.match((await press()).words, /no such sensor/);
window.DeviceOrientationEvent = { requestPermission: async () => "denied" };
assert.match((await press()).words, /does not permit/);
window.DeviceOrientationEvent = sensor;

assert.ok((await press()).isDisabled);
window.dispatchEvent(event(null, null, null));
for (const run of timers.keys()) run();
assert.match(shown().words, /no such sensor/, "events without angles are those of a machine without a sensor");
assert.ok(!shown().isDisabled);

await press();
for (time = 0; time < 1000; time += 10) window.dispatchEvent(event(30, 90, 0));
assert.ok(sent.length >= 20 && sent.length <= 30, `${sent.length} a second`);
assert.ok(Math.abs(sent[0].look.yaw - 30 * RADIANS) < 1e-9);
assert.equal(timers.size, 0);
assert.match(shown().words, /reports its direction/);
endTabletHead();
window.dispatchEvent(event(30, 90, 0));
assert.ok(sent.length <= 30 && !shown().isDisabled);
console.log("all of it holds");
