/** The orientation of this tablet or phone as the head tracker: sent at most thirty times a second. */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";

const EVERY = 1000 / 30; // ms
const RADIANS = Math.PI / 180;

const PATIENCE = 3000; // ms without an event after which there is no sensor

/**
 * The orientation that is being sent, whichever page is shown: where it reports its state, and how it ends; null: none is sent.
 * @type {{say: (sentence: string) => void, ended: () => void, end: () => void} | null}
 */
let tracking = null;

/** @param {import("../../main.js").App} app */
export function tabletHead(app) {
  const words = h("p", { class: "quiet small", role: "status" });
  /** @param {string} sentence */
  const say = (sentence) => write(words, sentence);
  const button = h("button", { type: "button", class: "btn" }, t("head-tablet-start"));
  const start = async () => {
    if (!window.isSecureContext) return say(t("head-tablet-insecure"));
    if (!("DeviceOrientationEvent" in window)) return say(t("head-tablet-none"));
    /** @type {typeof DeviceOrientationEvent & {requestPermission?: () => Promise<string>}} asked for by Safari */
    const sensor = window.DeviceOrientationEvent;
    const answer = sensor.requestPermission ? await sensor.requestPermission().catch(() => "denied") : "granted";
    if (answer !== "granted") return say(t("head-tablet-denied"));
    button.disabled = true;
    follow(app, say, () => (button.disabled = false));
  };
  button.disabled = tracking !== null;
  if (tracking) Object.assign(tracking, { say, ended: () => (button.disabled = false) });
  button.addEventListener("click", start);
  return h("div", { class: "spread" }, button, words);
}

/** Stop sending the orientation: another tracker is used. */
export function endTabletHead() {
  tracking?.end();
}

/** @param {import("../../main.js").App} app @param {(sentence: string) => void} say @param {() => void} ended */
function follow(app, say, ended) {
  endTabletHead();
  let last = -Infinity;
  /** @param {DeviceOrientationEvent} event */
  const tell = ({ alpha, beta, gamma }) => {
    if (alpha === null || beta === null || gamma === null) return;
    clearTimeout(patience);
    const now = performance.now();
    if (now - last < EVERY) return;
    last = now;
    app.live.send({ look: orientation(alpha, beta, gamma, screen.orientation?.angle ?? 0) });
    tracking?.say(t("head-tablet-tells"));
  };
  const patience = setTimeout(() => {
    tracking?.say(t("head-tablet-none"));
    endTabletHead();
  }, PATIENCE);
  const end = () => {
    clearTimeout(patience);
    window.removeEventListener("deviceorientation", tell);
    tracking?.ended();
    tracking = null;
  };
  tracking = { say, ended, end };
  say(t("head-tablet-waiting"));
  window.addEventListener("deviceorientation", tell);
}

/**
 * Where the back of the screen looks: yaw left, pitch up, roll to the right positive (rad).
 * The angles are those of the W3C's Device Orientation: turns by alpha about z, beta about x, gamma about y.
 * @param {number} alpha @param {number} beta @param {number} gamma @param {number} turned how the picture is turned, degrees
 */
export function orientation(alpha, beta, gamma, turned) {
  const [ca, sa] = [Math.cos(alpha * RADIANS), Math.sin(alpha * RADIANS)];
  const [cb, sb] = [Math.cos(beta * RADIANS), Math.sin(beta * RADIANS)];
  const [cg, sg] = [Math.cos(gamma * RADIANS), Math.sin(gamma * RADIANS)];
  // Columns of the device's axes in the world (x east, y north, z up): its right, its top, its front.
  const right = [ca * cg - sa * sb * sg, sa * cg + ca * sb * sg, -cb * sg];
  const top = [-sa * cb, ca * cb, sb];
  const back = [-(ca * sg + sa * sb * cg), -(sa * sg - ca * sb * cg), -cb * cg];
  const [c, s] = [Math.cos(turned * RADIANS), Math.sin(turned * RADIANS)];
  const across = right.map((value, i) => c * value - s * top[i]); // the picture's right
  const up = right.map((value, i) => s * value + c * top[i]);
  const pitch = Math.asin(Math.min(1, Math.max(-1, back[2])));
  const yaw = Math.atan2(-back[0], back[1]);
  return { yaw, pitch, roll: Math.atan2(-across[2], up[2]) };
}
