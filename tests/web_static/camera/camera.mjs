// The camera of a page from start to end, with stand-ins for the browser. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const settle = () => new Promise((resolve) => setTimeout(resolve, 5));
const define = (name, value) => Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });

let time = 1000; // ms
define("performance", { now: () => time });
define("location", { protocol: "http:", host: "127.0.0.1:8080", origin: "http://127.0.0.1:8080" });
define("window", { isSecureContext: false });
define("console", { ...console, warn: () => {} });

// The page: a video whose pictures a test lets come, and frames.
const video = { videoWidth: 640, videoHeight: 480, setAttribute: () => {}, play: async () => {}, isThere: false };
video.remove = () => (video.isThere = false);
video.requestVideoFrameCallback = (take) => (video.take = take);
// A frame has an engine of its own, which says whom it was begun by.
const frame = Object.assign(new EventTarget(), { attributes: {}, append: () => {} });
frame.setAttribute = (name, value) => (frame.attributes[name] = value);
frame.remove = () => (frame.isGone = true);
frame.contentWindow = {
  postMessage(beginning, origin, [port]) {
    frame.begunBy = origin;
    port.onmessage = () => port.postMessage({ pose: null });
    port.postMessage({ pose: null });
  },
};
define("document", {
  createElement: (tag) => (tag === "iframe" ? frame : video),
  body: {
    append(element) {
      if (element === frame) setTimeout(() => frame.dispatchEvent(new Event("load")));
      else video.isThere = true;
    },
  },
});
define("createImageBitmap", async () => new ArrayBuffer(8));

// The camera.
const track = Object.assign(new EventTarget(), { stop: () => (track.isStopped = true) });
let refusal = null; // name of what getUserMedia throws
let asked = null;
const mediaDevices = {
  async getUserMedia(constraints) {
    asked = constraints;
    if (refusal) throw Object.assign(new Error("no"), { name: refusal });
    track.isStopped = false;
    return { getTracks: () => [track], getVideoTracks: () => [track] };
  },
};
define("navigator", { mediaDevices });

// Messages between the page and its engine come at once, however busy the machine is.
class StandInPort {
  #waiting = [];
  #take = null;
  set onmessage(take) {
    this.#take = take;
    this.#deliver();
  }
  postMessage(data) {
    this.other.#waiting.push(data);
    queueMicrotask(() => this.other.#deliver());
  }
  close() {
    this.#take = null;
  }
  #deliver() {
    while (this.#take && this.#waiting.length) this.#take({ data: this.#waiting.shift() });
  }
}
class StandInChannel {
  port1 = new StandInPort();
  port2 = new StandInPort();
  constructor() {
    [this.port1.other, this.port2.other] = [this.port2, this.port1];
  }
}
define("MessageChannel", StandInChannel);

// The engine in a worker: it sees a person in each picture but when `seen` is null.
let seen = null;
const workers = [];
class StandInWorker {
  constructor(url) {
    this.url = String(url);
    workers.push(this);
  }
  postMessage(beginning, [port]) {
    this.beginning = beginning;
    this.end = () => port.close();
    if (StandInWorker.fails) return port.postMessage({ failed: "no canvas in a worker" });
    port.onmessage = () => port.postMessage({ pose: seen });
    port.postMessage({ pose: null });
  }
  terminate() {
    this.isEnded = true;
    this.end();
  }
}
define("Worker", StandInWorker);

// The server.
const sockets = [];
class StandInSocket {
  static OPEN = 1;
  readyState = 1;
  bufferedAmount = 0;
  sent = [];
  constructor(url) {
    this.url = url;
    sockets.push(this);
  }
  send(message) {
    this.sent.push(message);
  }
  close() {
    this.readyState = 3;
  }
  refuse(code) {
    this.readyState = 3;
    this.onclose({ code });
  }
}
define("WebSocket", StandInSocket);

const from = (file) => import(pathToFileURL(`${process.argv[2]}/${file}`));
const { numbers } = JSON.parse(await (await import("node:fs/promises")).readFile(process.argv[3], "utf-8"));
define("fetch", async () => ({
  ok: true,
  status: 200,
  headers: new Headers({ "content-type": "application/json" }),
  json: async () => ({ numbers }),
  text: async () => JSON.stringify({ numbers }),
}));
await (await from("reference.js")).readReference();
const { advice, pose, startCamera, status, stopCamera } = await from("camera/camera.js");
const { CHANNELS } = await from("camera/channels.js");

// Why there is no camera is said, and it can be started again.
await startCamera();
assert.equal(status.value, "insecure");
window.isSecureContext = true;
for (const [name, why] of [
  ["NotAllowedError", "denied"],
  ["NotFoundError", "none"],
  ["NotReadableError", "busy"],
  ["TypeError", "failed"],
]) {
  refusal = name;
  await startCamera();
  assert.equal(status.value, why);
}
refusal = null;
assert.equal(workers.length, 0);

// Started: no sound is asked for, the engine runs in a worker, and each picture is one message of a known length.
await startCamera();
assert.equal(status.value, "on");
assert.equal(asked.audio, false);
assert.match(workers[0].url, /camera\/pose_engine\.js$/);
assert.match(workers[0].beginning.base, /\/vendor\/@mediapipe\/pose\/$/);
assert.equal(sockets[0].url, "ws://127.0.0.1:8080/api/v1/camera");
const sent = sockets[0].sent;
const come = async (captured = time) => {
  time += 34;
  video.take(time, { captureTime: captured });
  time += 20;
  await settle();
};
await come();
assert.equal(sent.length, 1);
assert.equal(sent[0].byteLength, 24 + 4 * CHANNELS.length);
const read = (message) => {
  const view = new DataView(message);
  const values = CHANNELS.map((_, i) => view.getFloat32(24 + 4 * i, true));
  return { seq: view.getUint32(4, true), picture: view.getFloat64(8, true), sent: view.getFloat64(16, true), values };
};
assert.ok(read(sent[0]).values.every(Number.isNaN), "nobody is seen, and the server is told");
assert.equal(advice.value, "lost");
const landmarks = Array.from({ length: 33 }, (_, i) => ({ x: 0.5, y: 0.5 + i / 100, z: 0, visibility: 0.9 }));
Object.assign(landmarks[11], { x: 0.6 });
Object.assign(landmarks[12], { x: 0.4 });
seen = { picture: landmarks, world: landmarks };
const captured = time;
await come(captured);
const second = read(sent[1]);
assert.equal(second.seq, 1);
assert.equal(second.picture, captured / 1000);
assert.ok(second.sent >= second.picture + 0.02);
assert.ok(second.values.some(Number.isFinite));
assert.deepEqual(pose.value, seen);

// While one picture is read, others are left out; a picture that comes too soon is, too; a slow network gets the newest only.
video.take((time += 40), { captureTime: time });
video.take((time += 40), { captureTime: time });
await settle();
assert.equal(sent.length, 3);
for (const later of [40, 10]) {
  video.take((time += later), { captureTime: time });
  await settle();
}
assert.equal(sent.length, 4);
sockets[0].bufferedAmount = 1000;
await come();
assert.equal(sent.length, 4);
sockets[0].bufferedAmount = 0;
await come();
assert.equal(read(sent[4]).seq, 5, "what was dropped shows in the numbers");

// A second start changes nothing; a stop ends all of it.
await startCamera();
assert.equal(workers.length, 1);
stopCamera();
assert.deepEqual([status.value, pose.value, track.isStopped, video.isThere], ["off", null, true, false]);
assert.ok(workers[0].isEnded);
assert.equal(sockets[0].readyState, 3);
video.take((time += 40), { captureTime: time });
await settle();
assert.equal(sent.length, 5);

// The server may want another sensor.
for (const [code, why] of [
  [numbers.camera_in_use, "taken"],
  [numbers.camera_unwanted, "unwanted"],
  [numbers.signed_out, "off"],
  [1003, "failed"],
]) {
  await startCamera();
  sockets.at(-1).refuse(code);
  assert.deepEqual([status.value, track.isStopped], [why, true]);
}
// A lost connection is opened again, and the camera goes on.
await startCamera();
const count = sockets.length;
sockets.at(-1).refuse(1006);
assert.equal(status.value, "on");
await new Promise((resolve) => setTimeout(resolve, 1050));
assert.equal(sockets.length, count + 1);
await come();
assert.equal(sockets.at(-1).sent.length, 1);
// A camera that is pulled out ends it.
track.dispatchEvent(new Event("ended"));
assert.deepEqual([status.value, workers.at(-1).isEnded], ["none", true]);

// Where a worker cannot read pictures, a frame of this page does.
StandInWorker.fails = true;
await startCamera();
assert.ok(workers.at(-1).isEnded);
assert.deepEqual([status.value, frame.begunBy], ["on", "http://127.0.0.1:8080"]);
assert.match(frame.attributes.src, /\/camera\.html$/);
await come();
assert.equal(sockets.at(-1).sent.length, 1);
stopCamera();
assert.ok(frame.isGone);
console.log("the camera from start to end holds");
process.exit(0); // what waits for an engine that is too slow
