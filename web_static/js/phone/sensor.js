/**
 * How this device is held: the newest angles of its sensor, which the browser hands out when they have changed.
 * @import { Angles } from "./sample.js"
 * @typedef {"granted" | "insecure" | "none" | "denied"} Permission
 * @typedef {(typeof DeviceOrientationEvent | typeof DeviceMotionEvent) & {requestPermission?: () => Promise<string>}} AskedSensor by Safari
 */

const PATIENCE = 3000; // ms without an event after which there is no sensor, or it has ended

/** Ask for the sensors, which Safari does once, within a tap. @returns {Promise<Permission>} */
export async function askForSensors() {
  if (!window.isSecureContext) return "insecure";
  if (!("DeviceOrientationEvent" in window)) return "none";
  /** @type {AskedSensor[]} */
  const sensors = [window.DeviceOrientationEvent, window.DeviceMotionEvent].filter(Boolean);
  for (const sensor of sensors) {
    const answer = (await sensor.requestPermission?.().catch(() => "denied")) ?? "granted";
    if (answer !== "granted") return "denied";
  }
  return "granted";
}

/**
 * A browser may tell the angles only when they change, and tells the acceleration all the time: a sensor that tells
 * neither has ended, or hangs.
 */
export class Sensor {
  /** The newest angles; null before the first. @type {Angles | null} */
  angles = null;
  /** When it told something, in ms of performance.now; before the first angles, when it was asked. */
  toldAt = performance.now();

  constructor() {
    window.addEventListener("deviceorientation", (event) => this.#take(event));
    window.addEventListener("devicemotion", (event) => this.#note(event));
  }

  /** Whether there may be a sensor: it has told something, or had no time yet. */
  get isHere() {
    return performance.now() - this.toldAt <= PATIENCE;
  }

  /** @param {DeviceOrientationEvent} event */
  #take({ alpha, beta, gamma }) {
    if (alpha === null || beta === null || gamma === null) return;
    this.angles = { alpha, beta, gamma };
    this.toldAt = performance.now();
  }

  /** @param {DeviceMotionEvent} event */
  #note({ acceleration, accelerationIncludingGravity }) {
    const along = acceleration?.x ?? accelerationIncludingGravity?.x ?? null;
    if (this.angles && along !== null) this.toldAt = performance.now();
  }
}
