/**
 * What the page says of what arrives at the shirt: that it is too soon to say, or what to do.
 * @import { ArrivalsMoment } from "types/api"
 * @typedef {{state: "waiting" | "silent" | "wrong", words: string}} ArrivalWords
 */
import { t } from "../../texts.js";

/** Verdicts while signals come, which something else is wrong with. */
const WRONG = new Set(["rate", "partial", "moving", "nobody"]);
/** The server's verdicts of which nothing is said here: all is well, or another part of the page says what to do. */
const UNSAID = new Set(["arrives", "senders"]);
/** What a browser says of its own camera, about which the server knows nothing. */
const NO_CAMERA = new Set(["insecure", "none", "denied", "busy", "failed", "taken"]);

/**
 * @param {ArrivalsMoment | null} arrivals null: the shirt does not say it @param {string} camera what this device's does
 * @returns {ArrivalWords | null} null: there is nothing to say
 */
export function arrivalWords(arrivals, camera) {
  if (!arrivals || UNSAID.has(arrivals.verdict)) return null;
  const { verdict, message } = arrivals;
  if (verdict === "waiting") return { state: "waiting", words: message };
  if (WRONG.has(verdict)) return { state: "wrong", words: message };
  return { state: "silent", words: NO_CAMERA.has(camera) ? t(`camera-${camera}`) : message };
}
