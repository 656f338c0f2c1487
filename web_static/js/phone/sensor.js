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
 * A browser tells the angles only when they change. Where it tells the acceleration, it does so all the time: then the
 * sensor has ended when that stops.
 */
export class Sensor {
  /** @type {Angles | null} */
  #angles = null;
  #hasMotion = false;
  #toldAt = performance.now();
  #left = new AbortController();

  constructor() {
    const { signal } = this.#left;
    window.addEventListener("deviceorientation", (event) => this.#take(event), { signal });
    window.addEventListener("devicemotion", ({ acceleration }) => acceleration?.x != null && this.#note(), { signal });
  }

  /** The newest angles; null without a sensor. */
  get angles() {
    const isOver = performance.now() - this.#toldAt > PATIENCE;
    return isOver && (this.#hasMotion || !this.#angles) ? null : this.#angles;
  }

  /** Whether there may be a sensor: it has told something, or had no time yet. */
  get isHere() {
    return this.angles !== null || performance.now() - this.#toldAt <= PATIENCE;
  }

  close() {
    this.#left.abort();
  }

  /** @param {DeviceOrientationEvent} event */
  #take({ alpha, beta, gamma }) {
    if (alpha === null || beta === null || gamma === null) return;
    this.#angles = { alpha, beta, gamma };
    this.#toldAt = performance.now();
  }

  #note() {
    this.#hasMotion = true;
    this.#toldAt = performance.now();
  }
}
