/**
 * Reads the pose of a person in pictures, by the engine in a worker, or in a frame where the worker fails.
 * @import { Answer, Beginning, Pose } from "types/pose"
 * @typedef {{read: (picture: ImageBitmap) => Promise<Pose | null>, close: () => void}} PoseReader
 *   read: one picture after the other, which is used up by that
 */
import { h } from "../widgets/dom.js";

const MEDIAPIPE = new URL("../../vendor/@mediapipe/pose/", import.meta.url).href;
const ENGINE = new URL("./pose_engine.js", import.meta.url);
const FRAME = new URL("../../camera.html", import.meta.url);
const PATIENCE = 120_000; // ms until the engine is ready: software draws its first picture in 20 s

/** Start the engine; an Error when it cannot. @param {AbortSignal} ended @returns {Promise<PoseReader>} */
export async function openPoseReader(ended) {
  try {
    return await inWorker(ended);
  } catch (error) {
    ended.throwIfAborted();
    console.warn("The worker cannot read the camera's pictures; a frame does.", error);
    return inFrame(ended);
  }
}

/** @param {AbortSignal} ended @returns {Promise<PoseReader>} */
async function inWorker(ended) {
  const worker = new Worker(ENGINE);
  const close = () => worker.terminate();
  const failed = new Promise((_, reject) => {
    worker.onerror = (event) => reject(new Error(event.message || "the worker was not loaded"));
  });
  return readerOf((beginning, port) => worker.postMessage(beginning, [port]), { close, failed, ended });
}

/** @param {AbortSignal} ended @returns {Promise<PoseReader>} */
async function inFrame(ended) {
  const frame = h("iframe", { src: FRAME.href, class: "unseen", tabindex: "-1", "aria-hidden": "true" });
  const loaded = new Promise((resolve) => frame.addEventListener("load", resolve, { once: true }));
  document.body.append(frame);
  const close = () => frame.remove();
  await loaded;
  /** @param {Beginning} beginning @param {MessagePort} port */
  const begin = (beginning, port) => frame.contentWindow?.postMessage(beginning, location.origin, [port]);
  return readerOf(begin, { close, failed: new Promise(() => {}), ended });
}

/**
 * @param {(beginning: Beginning, port: MessagePort) => void} begin gives the engine its end of a channel
 * @param {{close: () => void, failed: Promise<unknown>, ended: AbortSignal}} engine failed: rejects when it fails at once
 * @returns {Promise<PoseReader>}
 */
async function readerOf(begin, { close, failed, ended }) {
  const { port1: ours, port2: theirs } = new MessageChannel();
  const over = new Promise((_, reject) => {
    ended.addEventListener("abort", () => reject(ended.reason), { once: true });
    setTimeout(() => reject(new Error("the engine is not ready")), PATIENCE);
  });
  over.catch(() => {}); // afterwards, nobody waits for it
  const answer = () =>
    /** @type {Promise<Pose | null>} */ (
      new Promise((resolve, reject) => {
        ours.onmessage = (/** @type {MessageEvent<Answer>} */ { data }) =>
          "failed" in data ? reject(new Error(data.failed)) : resolve(data.pose);
      })
    );
  try {
    const ready = answer();
    begin({ base: MEDIAPIPE, isTouched: "ontouchend" in document }, theirs);
    await Promise.race([ready, failed, over]);
  } catch (error) {
    close();
    throw error;
  }
  return {
    read: (picture) => {
      const read = answer();
      ours.postMessage(picture, [picture]);
      return read;
    },
    close: () => {
      ours.close();
      close();
    },
  };
}
