// How a phone's sensors are asked for, and when there are none. Run by test_phone_samples.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

let time = 0;
const define = (name, value) => Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
define("window", Object.assign(new EventTarget(), { isSecureContext: true }));
define("performance", { now: () => time });

const { askForSensors, Sensor } = await import(pathToFileURL(`${process.argv[2]}/phone/sensor.js`));

assert.equal(await askForSensors(), "none");
window.DeviceOrientationEvent = {};
assert.equal(await askForSensors(), "granted", "where a browser asks nobody, as on Android");
let asked = 0;
window.DeviceOrientationEvent = { requestPermission: async () => (asked++, "granted") };
window.DeviceMotionEvent = { requestPermission: async () => (asked++, "granted") };
assert.equal(await askForSensors(), "granted");
assert.equal(asked, 2);
window.DeviceMotionEvent.requestPermission = async () => "denied";
assert.equal(await askForSensors(), "denied");
window.DeviceMotionEvent.requestPermission = () => Promise.reject(new Error("not within a tap"));
assert.equal(await askForSensors(), "denied");
window.isSecureContext = false;
assert.equal(await askForSensors(), "insecure");

const held = (alpha, beta, gamma) => Object.assign(new Event("deviceorientation"), { alpha, beta, gamma });
const moved = (x) => Object.assign(new Event("devicemotion"), { acceleration: { x } });

// A machine without a sensor: events without angles. Acceleration alone is no orientation.
let sensor = new Sensor();
window.dispatchEvent(held(null, null, null));
assert.equal(sensor.angles, null);
assert.ok(sensor.isHere, "it may come yet");
time += 3001;
window.dispatchEvent(moved(0.1));
assert.ok(!sensor.isHere);

// Chromium tells the angles only when they change: of a phone that lies still, the acceleration shows that it works.
sensor = new Sensor();
window.dispatchEvent(held(10, 20, 30));
for (let i = 0; i < 1000; i++) {
  time += 16;
  window.dispatchEvent(moved(0.1));
  assert.equal(sensor.toldAt, time);
}
assert.deepEqual(sensor.angles, { alpha: 10, beta: 20, gamma: 30 });

// A sensor that tells nothing any more has ended, or hangs: nothing is sent in its name.
const toldAt = time;
time += 16;
window.dispatchEvent(moved(null));
assert.equal(sensor.toldAt, toldAt);
time += 3001;
assert.ok(!sensor.isHere);
window.dispatchEvent(held(11, 20, 30));
assert.equal(sensor.angles.alpha, 11);
assert.equal(sensor.toldAt, time);

// A phone that takes no gravity away tells the acceleration with it.
time += 16;
window.dispatchEvent(
  Object.assign(new Event("devicemotion"), { acceleration: null, accelerationIncludingGravity: { x: 9.8 } }),
);
assert.equal(sensor.toldAt, time);
console.log("all of it holds");
