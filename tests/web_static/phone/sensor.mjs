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

// A machine without a sensor: events without angles.
let sensor = new Sensor();
window.dispatchEvent(held(null, null, null));
assert.equal(sensor.angles, null);
assert.ok(sensor.isHere, "it may come yet");
time += 3001;
assert.ok(!sensor.isHere);
sensor.close();

// Chromium tells the angles only when they change: a phone that lies still goes on.
sensor = new Sensor();
window.dispatchEvent(held(10, 20, 30));
time += 60_000;
assert.deepEqual(sensor.angles, { alpha: 10, beta: 20, gamma: 30 });

// Where the acceleration is told all the time, its end is the end of the sensor.
for (let i = 0; i < 100; i++, time += 100) window.dispatchEvent(moved(0.1));
assert.deepEqual(sensor.angles, { alpha: 10, beta: 20, gamma: 30 });
time += 3001;
assert.equal(sensor.angles, null);
assert.ok(!sensor.isHere);
window.dispatchEvent(held(11, 20, 30));
assert.equal(sensor.angles.alpha, 11);
sensor.close();
window.dispatchEvent(held(12, 20, 30));
assert.equal(sensor.angles.alpha, 11);
console.log("all of it holds");
