/**
 * The camera of this device as the shirt: each picture is read in this browser, and only what the joints do is sent. It
 * goes on whichever page is shown, until it is stopped or the server wants another sensor.
 * @import { Pose } from "types/pose"
 * @import { Refusal } from "./camera_socket.js"
 * @typedef {"insecure" | "none" | "denied" | "busy"} NoCamera why the browser gives no pictures
 * @typedef {"off" | "asking" | "preparing" | "on" | NoCamera | Refusal} Status
 */
import { signal } from "../preact.js";
import { CameraSocket } from "./camera_socket.js";
import { channelsOf } from "./channels.js";
import { adviceOn, steadyAdvice } from "./placement.js";
import { openPoseReader } from "./pose_reader.js";
import { encodeSample } from "./sample.js";

const PICTURES = {
  video: { facingMode: "user", width: { ideal: 640 }, height: { ideal: 480 }, frameRate: { ideal: 30 } },
  audio: false,
};
const LEAST_APART = 28; // ms between two pictures that are read: a camera of 60 pictures a second is read 30 times
const COUNT_EVERY = 2000; // ms
/** By the name of what getUserMedia throws. @type {Record<string, NoCamera | undefined>} */
const NO_CAMERA = {
  NotAllowedError: "denied",
  SecurityError: "denied",
  NotFoundError: "none",
  OverconstrainedError: "none",
  NotReadableError: "busy",
  AbortError: "busy",
};

/** What pages show. */
export const status = signal(/** @type {Status} */ ("off"));
export const advice = signal(/** @type {import("./placement.js").Advice} */ ("lost"));
export const rate = signal(0); // pictures a second that are read
export const stream = signal(/** @type {MediaStream | null} */ (null));
export const pose = signal(/** @type {Pose | null} */ (null)); // in the newest picture

/** What ends the camera; null: it is off. @type {AbortController | null} */
let running = null;

/** Stop the camera. @param {Status} [why] what pages show then */
export function stopCamera(why = "off") {
  running?.abort();
  running = null;
  status.value = why;
  stream.value = pose.value = null;
  rate.value = 0;
  advice.value = "lost";
}

/** Start the camera of this device, which asks its person for permission. */
export async function startCamera() {
  if (running) return;
  const ended = (running = new AbortController()).signal;
  /** @param {Status} why */
  const fail = (why) => {
    if (!ended.aborted) stopCamera(why);
  };
  if (!window.isSecureContext || !navigator.mediaDevices) return fail("insecure");
  try {
    status.value = "asking";
    const pictures = await navigator.mediaDevices.getUserMedia(PICTURES).catch((error) => {
      fail(NO_CAMERA[/** @type {DOMException} */ (error).name] ?? "failed");
    });
    if (!pictures) return;
    onEnd(ended, () => pictures.getTracks().forEach((track) => track.stop()));
    if (ended.aborted) return;
    pictures.getVideoTracks()[0]?.addEventListener("ended", () => fail("none"), { signal: ended });
    status.value = "preparing";
    stream.value = pictures;
    const video = await playing(pictures, ended);
    const reader = await openPoseReader(ended);
    onEnd(ended, reader.close);
    if (ended.aborted) return;
    const socket = new CameraSocket(fail);
    onEnd(ended, () => socket.close());
    status.value = "on";
    readPictures(video, reader, socket, { ended, fail });
  } catch (error) {
    console.warn(error);
    fail("failed");
  }
}

/** Do something at the end, or now when it has come already. @param {AbortSignal} ended @param {() => void} act */
function onEnd(ended, act) {
  if (ended.aborted) act();
  else ended.addEventListener("abort", act, { once: true });
}

/** A video of the camera, out of sight. @param {MediaStream} pictures @param {AbortSignal} ended */
async function playing(pictures, ended) {
  const video = document.createElement("video");
  Object.assign(video, { muted: true, playsInline: true, srcObject: pictures, className: "unseen" });
  video.setAttribute("aria-hidden", "true");
  document.body.append(video);
  onEnd(ended, () => video.remove());
  await video.play();
  return video;
}

/**
 * Read each new picture, but none while the one before is read: of those that come meanwhile, only the newest counts.
 * @param {HTMLVideoElement} video @param {import("./pose_reader.js").PoseReader} reader @param {CameraSocket} socket
 * @param {{ended: AbortSignal, fail: (why: Status) => void}} end
 */
function readPictures(video, reader, socket, { ended, fail }) {
  const steady = steadyAdvice();
  const counted = { pictures: 0, since: performance.now() };
  let [seq, isReading, newest] = [0, false, -Infinity];
  /** @param {number} taken when, in ms of this page */
  const read = async (taken) => {
    isReading = true;
    const aspect = video.videoWidth / video.videoHeight;
    const seen = await reader.read(await createImageBitmap(video));
    if (ended.aborted) return;
    const now = performance.now();
    const [pictureTime, sentTime] = [Math.min(taken, now) / 1000, now / 1000];
    socket.send(encodeSample({ seq: seq++, pictureTime, sentTime, values: channelsOf(seen, aspect) }));
    pose.value = seen;
    advice.value = steady(adviceOn(seen), now);
    count(counted, now);
    isReading = false;
  };
  /** @param {number} now @param {VideoFrameCallbackMetadata} picture */
  const take = (now, { captureTime }) => {
    if (ended.aborted) return;
    video.requestVideoFrameCallback(take);
    if (isReading || now - newest < LEAST_APART) return;
    newest = now;
    read(Math.max(0, captureTime ?? now)).catch((error) => {
      console.warn(error);
      fail("failed");
    });
  };
  video.requestVideoFrameCallback(take);
}

/** Count the pictures that are read. @param {{pictures: number, since: number}} counted @param {number} now ms */
function count(counted, now) {
  counted.pictures++;
  const passed = now - counted.since;
  if (passed < COUNT_EVERY) return;
  rate.value = Math.round((1000 * counted.pictures) / passed);
  Object.assign(counted, { pictures: 0, since: now });
}
