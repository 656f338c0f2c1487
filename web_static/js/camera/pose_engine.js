/**
 * Reads the pose of a person in pictures: in a worker, so that a page goes on meanwhile, or in a frame (`camera.html`)
 * where the browser's workers cannot draw. A classic script, because MediaPipe's `pose.js` loads its parts as such. Its
 * policy (app/api/response_headers.py) lets it compile WebAssembly, and reach no other machine.
 *
 * The page begins with a message with a port. It is answered through the port when a first, empty picture was read, and
 * then sends one picture after the other, each of which is closed when it was read.
 */
(() => {
  /**
   * @typedef {import("types/pose").Answer} Answer
   * @typedef {import("types/pose").Beginning} Beginning
   * @typedef {import("types/pose").Landmark} Landmark
   * @typedef {{image?: unknown, poseLandmarks?: Landmark[], poseWorldLandmarks?: Landmark[]}} Results
   * @typedef {object} Solution MediaPipe's, as far as it is used here
   * @property {(options: Record<string, boolean | number>) => void} setOptions
   * @property {(listener: (results: Results) => void) => void} onResults
   * @property {(inputs: {image: ImageBitmap | ImageData}) => Promise<void>} send
   * @typedef {{Pose: new (config: {locateFile: (name: string) => string}) => Solution}} WithPose
   */
  const SIZE = 256; // px of the first picture

  const scope = /** @type {typeof globalThis & WithPose & {alert: (words: string) => void}} */ (globalThis);

  /** A script of a page: it is loaded when it is put into the page. */
  class PageScript extends EventTarget {
    #source = "";

    /** @param {string} name @param {string} value */
    setAttribute(name, value) {
      if (name === "src") this.#source = value;
    }

    load() {
      let event = "load";
      try {
        importScripts(this.#source);
      } catch {
        event = "error";
      }
      this.dispatchEvent(new Event(event));
    }
  }

  /** Give a worker what MediaPipe asks of a page: where it loads scripts, and a canvas. @param {boolean} isTouched */
  function standInForPage(isTouched) {
    const nothing = () => {};
    const page = {
      /** @param {string} kind */
      createElement: (kind) =>
        kind === "canvas" ? Object.assign(new OffscreenCanvas(1, 1), { style: {} }) : new PageScript(),
      body: { appendChild: (/** @type {unknown} */ part) => part instanceof PageScript && part.load() },
      addEventListener: nothing,
      removeEventListener: nothing,
      querySelector: () => null,
      ...(isTouched ? { ontouchend: null } : {}),
    };
    Object.assign(scope, { window: scope, document: page });
  }

  /** @param {Beginning} beginning */
  async function openReader({ base, isTouched }) {
    if (!("document" in scope)) standInForPage(isTouched);
    scope.alert = (words) => {
      throw new Error(words); // MediaPipe reports a missing WebGL by a dialogue
    };
    if (!("Pose" in scope)) importScripts(`${base}pose.js`);
    const solution = new scope.Pose({ locateFile: (name) => base + name });
    solution.setOptions({ modelComplexity: 0, smoothLandmarks: false, enableSegmentation: false, selfieMode: false });
    /** @type {Results} */
    let results = {};
    solution.onResults((newest) => void (results = newest));
    /** @param {ImageBitmap | ImageData} picture @returns {Promise<Answer>} */
    const read = async (picture) => {
      results = {};
      await solution.send({ image: picture });
      const { image, poseLandmarks, poseWorldLandmarks } = results;
      if (image instanceof ImageBitmap) image.close();
      if (!poseLandmarks?.length || !poseWorldLandmarks?.length) return { pose: null };
      return { pose: { picture: poseLandmarks, world: poseWorldLandmarks } };
    };
    await read(new ImageData(SIZE, SIZE)); // the shaders are compiled with the first picture, which takes long
    return read;
  }

  /** @param {MessageEvent<Beginning>} event */
  async function begin({ data, ports: [port], origin }) {
    if (!port || (origin && origin !== location.origin)) return;
    removeEventListener("message", begin);
    /** @param {unknown} error @returns {Answer} */
    const failure = (error) => ({ failed: String(error) });
    /** @type {Awaited<ReturnType<typeof openReader>>} */
    let read;
    try {
      read = await openReader(data);
    } catch (error) {
      return port.postMessage(failure(error));
    }
    port.onmessage = async (/** @type {MessageEvent<ImageBitmap>} */ { data: picture }) => {
      const answer = await read(picture).catch(failure);
      picture.close();
      port.postMessage(answer);
    };
    /** @type {Answer} */
    const ready = { pose: null };
    port.postMessage(ready);
  }

  addEventListener("message", begin);
})();
