/** The one moment of a replay that all its pictures show, and how it goes on by itself. */
import { TypedEvents } from "../../live/typed_events.js";

/**
 * Events: `time` when the moment changes, `state` when it begins or ceases to play, or plays at another speed.
 * @extends {TypedEvents<{time: Event, state: Event}>}
 */
export class PlayHead extends TypedEvents {
  #frame = 0;
  #last = 0;

  /** @param {number} start s @param {number} end s @param {AbortSignal} signal */
  constructor(start, end, signal) {
    super();
    this.start = start;
    this.end = end;
    this.t = Math.max(start, Math.min(0, end));
    this.speed = 1;
    this.playing = false;
    signal.addEventListener("abort", () => this.pause());
  }

  /** Where a moment stands between start and end. @param {number} t s @returns {number} % */
  share(t) {
    return (100 * (Math.min(this.end, Math.max(this.start, t)) - this.start)) / (this.end - this.start || 1);
  }

  /** Go to a moment. @param {number} t s; one beyond the ends is the end */
  seek(t) {
    const within = Math.min(this.end, Math.max(this.start, t));
    if (!Number.isFinite(within) || within === this.t) return;
    this.t = within;
    this.dispatchEvent(new Event("time"));
  }

  play() {
    if (this.playing) return;
    if (this.t >= this.end) this.seek(this.start);
    this.playing = true;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#go(now));
    this.dispatchEvent(new Event("state"));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.#frame);
    this.dispatchEvent(new Event("state"));
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** @param {number} speed times as fast as it was driven */
  setSpeed(speed) {
    this.speed = speed;
    this.dispatchEvent(new Event("state"));
  }

  /** @param {number} now ms */
  #go(now) {
    this.seek(this.t + (this.speed * Math.max(0, now - this.#last)) / 1000);
    this.#last = now;
    if (this.t >= this.end) return this.pause();
    this.#frame = requestAnimationFrame((next) => this.#go(next));
  }
}

/** The last place in rising numbers that is not above a value; 0 before the first. @param {readonly (number | null)[]} values @param {number} value */
export function placeOf(values, value) {
  let [low, high] = [0, values.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (Number(values[middle]) <= value) low = middle;
    else high = middle - 1;
  }
  return low;
}
