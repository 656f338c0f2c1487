/**
 * What the person before the camera shall change, from the landmarks. Pure: no picture, no page.
 * @import { Landmark, Pose } from "types/pose"
 * @typedef {"lost" | "back" | "light" | "good"} Advice
 *   lost: nobody is seen; back: move back, the upper body does not fit in; light: what is in the picture is hardly seen
 */
import { isVisible } from "./channels.js";

const NOSE = 0;
const SHOULDERS = [11, 12];
const ELBOWS = [13, 14];
const RIM = 0.02; // share of the picture
const WIDEST = 0.5; // of the picture's width that the shoulders may take: arms that are spread need the rest
const CLEAR = 0.8; // visibility of head and shoulders in good light
const HOLDS = 500; // ms for which other advice must hold before it is given, so that no word flickers

/** @param {Pose | null} pose @returns {Advice} */
export function adviceOn(pose) {
  const head = pose?.picture[NOSE];
  const shoulders = SHOULDERS.flatMap((i) => pose?.picture[i] ?? []);
  if (!pose || !head || shoulders.length < SHOULDERS.length || !shoulders.every(isVisible)) return "lost";
  const width = Math.abs(shoulders[0].x - shoulders[1].x);
  const areElbowsBelow = ELBOWS.every((i) => !isVisible(pose.picture[i]) && pose.picture[i].y > 1 - RIM);
  if (width > WIDEST || areElbowsBelow || ![head, ...shoulders].every(isInside)) return "back";
  return [head, ...shoulders].every(({ visibility = 0 }) => visibility >= CLEAR) ? "good" : "light";
}

/** @param {Landmark} landmark */
function isInside({ x, y }) {
  return x > RIM && x < 1 - RIM && y > RIM && y < 1 - RIM;
}

/**
 * Advice that changes only when other advice has held for a while; that nobody is seen is said at once.
 * @returns {(advice: Advice, now: number) => Advice} now: ms
 */
export function steadyAdvice() {
  /** @type {Advice} */
  let given = "lost";
  /** @type {Advice} */
  let held = given;
  let heldSince = -Infinity;
  return (advice, now) => {
    if (advice !== held) [held, heldSince] = [advice, now];
    if (held === "lost" || now - heldSince >= HOLDS) given = held;
    return given;
  };
}
