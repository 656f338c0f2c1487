// The engine in a worker and in a frame, with a stand-in for MediaPipe that asks of a page what MediaPipe's pose.js does.
// Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import vm from "node:vm";

const ENGINE = await readFile(`${process.argv[2]}/camera/pose_engine.js`, "utf-8");
const BASE = "http://clinic/vendor/@mediapipe/pose/";
const LANDMARKS = [{ x: 0.5, y: 0.5, z: 0, visibility: 1 }];

class Picture {
  isClosed = false;
  close() {
    this.isClosed = true;
  }
}
class Canvas {
  getContext(kind) {
    return kind === "webgl2" && !Canvas.isWithout ? {} : null;
  }
}

// What a worker or a frame has; the newest listener of messages begins.
function scopeOf(isWorker) {
  const scope = {
    ...{ EventTarget, Event, Error, Promise, Object, String, console },
    ImageBitmap: Picture,
    ImageData: class {},
    OffscreenCanvas: Canvas,
    location: { origin: "http://clinic", pathname: "/js/camera/pose_engine.js" },
    addEventListener: (_, listener) => (scope.begin = listener),
    removeEventListener: () => (scope.begin = null),
    loaded: [],
  };
  scope.importScripts = (source) => {
    scope.loaded.push(source);
    if (source === `${BASE}pose.js`) scope.Pose = poseIn(scope);
    else if (scope.loaded.some((one) => one.includes("missing"))) throw new Error("404");
  };
  if (!isWorker) {
    scope.document = { createElement: () => new Canvas() };
    scope.Pose = poseIn(scope);
    delete scope.importScripts;
  }
  scope.globalThis = scope;
  vm.runInNewContext(ENGINE, scope);
  return scope;
}

const poseIn = (scope) =>
  class {
    constructor({ locateFile }) {
      this.locateFile = locateFile;
    }
    setOptions(options) {
      scope.options = options;
    }
    onResults(listener) {
      this.listener = listener;
    }
    async send({ image }) {
      if (!this.canvas) await this.initialize();
      if (scope.fails) throw new Error("the engine broke");
      scope.made = new Picture(); // the picture as the graph saw it, which must not be kept
      const seen = image instanceof Picture ? { poseLandmarks: LANDMARKS, poseWorldLandmarks: LANDMARKS } : {};
      this.listener({ image: scope.made, ...seen });
    }
    async initialize() {
      if (scope.window) {
        const { document } = scope.window;
        const script = document.createElement("script");
        script.setAttribute("src", this.locateFile("pose_solution_simd_wasm_bin.js"));
        script.setAttribute("crossorigin", "anonymous");
        const loaded = new Promise((resolve) => script.addEventListener("load", resolve, false));
        document.body.appendChild(script);
        await loaded;
        document.addEventListener("pointerlockchange", () => {}, false);
        assert.equal(document.querySelector("#canvas"), null);
      }
      this.canvas = scope.document.createElement("canvas");
      if (!this.canvas.getContext("webgl2", {})) scope.alert("Failed to create WebGL canvas context");
      scope.isTouched = "ontouchend" in scope.document;
    }
  };

// An end of a channel that keeps what is posted.
function port() {
  const made = { posted: [], postMessage: (message) => made.posted.push(JSON.parse(JSON.stringify(message))) };
  return made;
}
const begin = async (scope, { isTouched = false, origin = "" } = {}) => {
  const end = port();
  await scope.begin({ data: { base: BASE, isTouched }, ports: [end], origin });
  return end;
};

for (const isWorker of [true, false]) {
  const scope = scopeOf(isWorker);
  const end = await begin(scope, { isTouched: true, origin: isWorker ? "" : "http://clinic" });
  assert.deepEqual(end.posted, [{ pose: null }], "ready, once a first picture was read");
  assert.equal(JSON.stringify(scope.options.modelComplexity), "0");
  assert.equal(scope.options.smoothLandmarks, false, "only the decoder smoothes");
  if (isWorker) assert.deepEqual(scope.loaded, [`${BASE}pose.js`, `${BASE}pose_solution_simd_wasm_bin.js`]);
  if (isWorker) assert.ok(scope.isTouched);
  const picture = new Picture();
  await end.onmessage({ data: picture });
  assert.deepEqual(end.posted[1], { pose: { picture: LANDMARKS, world: LANDMARKS } });
  assert.ok(picture.isClosed && scope.made.isClosed, "no picture is kept");
  scope.fails = true;
  await end.onmessage({ data: new Picture() });
  assert.match(end.posted[2].failed, /the engine broke/);
  assert.equal(scope.begin, null, "it begins once");
}

Canvas.isWithout = true;
const withoutWebGl = await begin(scopeOf(true));
assert.match(withoutWebGl.posted[0].failed, /WebGL/);
Canvas.isWithout = false;
const foreign = scopeOf(false);
assert.deepEqual((await begin(foreign, { origin: "http://evil.example" })).posted, []);
assert.notEqual(foreign.begin, null);
console.log("the engine in a worker and in a frame holds");
